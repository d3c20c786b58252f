// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet behind the cornea.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
layout(location = 2) in vec4 look;  // place at rest, wrinkles
uniform mat4 clip_from_world;
uniform vec3 view_axis;
uniform vec3 reference;
out vec3 world;
out vec3 normal;
out vec2 rest;
out vec2 wrinkled;  // how much, times cosine and sine of twice the angle of the pull
out float depth;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    world = position;
    normal = direction;
    rest = look.xy;
    wrinkled = look.zw;
    depth = dot(view_axis, position - reference);
}
