// SPDX-License-Identifier: GPL-3.0-or-later
// The first surface of what is left of the lens: depth, and where that tissue lay at rest.
in float depth;
in vec3 point_value;
out vec4 colour;

void main() { colour = vec4(depth, point_value); }
