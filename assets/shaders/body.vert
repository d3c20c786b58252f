// SPDX-License-Identifier: GPL-3.0-or-later
// A body behind or in front of the cornea, with one triple of numbers per face.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 value;
uniform mat4 clip_from_world;
uniform mat4 world_from_body;
uniform vec3 view_axis;
uniform vec3 reference;
out float depth;
flat out vec3 face_value;
out vec3 point_value;

void main() {
    vec4 world = world_from_body * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
    depth = dot(view_axis, world.xyz - reference);
    face_value = value;
    point_value = value;
}
