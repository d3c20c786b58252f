// SPDX-License-Identifier: GPL-3.0-or-later
// A ribbon along a face that has given way.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 look;  // how deep the face is, distance from its middle [mm]
uniform mat4 clip_from_world;
uniform vec3 view_axis;
uniform vec3 reference;
out float deep;
out float beside;
out float depth;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    deep = look.x;
    beside = look.y;
    depth = dot(view_axis, position - reference);
}
