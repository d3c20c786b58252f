// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the picture: corners of rectangles, 0 to 1 from the bottom left.
layout(location = 0) in vec2 corner;
out vec2 place;

void main() {
    place = corner;
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
