// SPDX-License-Identifier: GPL-3.0-or-later
// Soft light from above and behind the viewer; the mesh shows as fine lines.
in vec3 world;
in vec3 normal;
in vec3 body_colour;
in vec3 edges;
uniform vec3 camera;
uniform vec3 light_way;  // towards the light
uniform float lines;     // strength of the mesh lines
out vec4 colour;

void main() {
    vec3 n = normalize(normal);
    vec3 toward = normalize(camera - world);
    n = dot(n, toward) < 0.0 ? -n : n;  // a sheet has two sides
    float facing = dot(n, toward);
    float key = clamp(0.5 + 0.5 * dot(n, light_way), 0.0, 1.0);
    float sky = 0.5 + 0.5 * n.z;
    vec3 light = vec3(1.02, 0.98, 0.93) * pow(key, 1.6) + vec3(0.20, 0.23, 0.28) * sky + vec3(0.05);
    vec3 shine = vec3(0.22) * pow(clamp(dot(n, normalize(light_way + toward)), 0.0, 1.0), 40.0);
    shine += vec3(0.10) * pow(1.0 - clamp(facing, 0.0, 1.0), 3.0);
    vec3 lit = body_colour * light + shine;
    vec3 width = fwidth(edges);
    vec3 near = smoothstep(vec3(0.0), 1.1 * width, edges);
    float line = 1.0 - min(min(near.x, near.y), near.z);
    lit *= 1.0 - lines * line * clamp(1.0 - 1.5 * max(max(width.x, width.y), width.z), 0.0, 1.0);
    colour = vec4(pow(clamp(lit, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
}
