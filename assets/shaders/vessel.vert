// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of a blood vessel as a ribbon: across runs from -1 to 1.
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 look;  // across, along, strength, layer (0 near the surface, 1 deep)
uniform float half_extent;
out vec4 ribbon;

void main() {
    gl_Position = vec4(position / half_extent, 0.0, 1.0);
    ribbon = look;
}
