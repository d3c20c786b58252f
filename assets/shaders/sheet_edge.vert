// SPDX-License-Identifier: GPL-3.0-or-later
// A ribbon along an edge of a sheet.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 look;  // away from the sheet: across the view; distance from the edge [mm]
uniform mat4 clip_from_world;
uniform vec3 view_axis;
uniform vec3 reference;
out vec2 outward;
out float beyond;
out vec2 at;
out float depth;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    outward = look.xy;
    beyond = look.z;
    at = position.xy;
    depth = dot(view_axis, position - reference);
}
