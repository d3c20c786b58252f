// SPDX-License-Identifier: GPL-3.0-or-later
// A neutral ground for bare bodies.
in vec2 place;
out vec4 colour;

void main() {
    vec3 light = mix(vec3(0.60, 0.63, 0.66), vec3(0.86, 0.87, 0.88), smoothstep(0.0, 1.0, place.y));
    light *= 1.0 - 0.16 * dot(place - 0.5, place - 0.5);
    colour = vec4(light, 1.0);
}
