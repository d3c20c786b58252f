// SPDX-License-Identifier: GPL-3.0-or-later
// A bare body: surface triangles with normals, colours and distances to their edges.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
layout(location = 2) in vec3 tint;
layout(location = 3) in vec3 from_edges;
uniform mat4 clip_from_world;
out vec3 world;
out vec3 normal;
out vec3 body_colour;
out vec3 edges;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    world = position;
    normal = direction;
    body_colour = tint;
    edges = from_edges;
}
