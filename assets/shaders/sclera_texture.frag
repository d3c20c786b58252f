// SPDX-License-Identifier: GPL-3.0-or-later
// Sclera and conjunctiva seen from above, over [-half_extent, half_extent]^2 mm. Reflectance; alpha: how wet and uneven.
in vec2 place;
uniform sampler2D vessels;
uniform float half_extent;
uniform float limbus_radius;
out vec4 colour;

void main() {
    vec2 at = (2.0 * place - 1.0) * half_extent;
    float radius = length(at);
    float around = atan(at.y, at.x) / 6.2831853 + 0.5;
    float mottle = clouds(place * 12.0, ivec2(12), 5, 201u);
    float grain = clouds(place * 90.0, ivec2(90), 3, 211u);
    vec3 reflectance = mix(vec3(0.80, 0.71, 0.63), vec3(0.88, 0.83, 0.77), mottle);
    reflectance *= 0.95 + 0.10 * grain;

    // Blood in the finest vessels: a blush that thickens away from the cornea.
    float blush = smoothstep(limbus_radius + 0.3, limbus_radius + 5.5, radius) * smoothstep(0.3, 0.75, mottle);
    reflectance = mix(reflectance, vec3(0.80, 0.52, 0.47), 0.38 * blush);

    vec2 blood = texture(vessels, place).rg;
    reflectance = mix(reflectance, vec3(0.66, 0.38, 0.37), 0.50 * blood.g);
    reflectance = mix(reflectance, vec3(0.50, 0.075, 0.06), 0.85 * blood.r);

    // Palisades: pale and dark spokes that cross the limbus.
    float spokes = noise(vec2(around * 210.0, radius * 1.5), ivec2(210, 64), 221u);
    float band = smoothstep(limbus_radius - 0.5, limbus_radius, radius) *
                 (1.0 - smoothstep(limbus_radius + 0.35, limbus_radius + 0.8, radius));
    reflectance *= 1.0 - 0.20 * band * spokes;
    // The limbus itself is thin enough for the dark inside to show, bluish.
    float thin = exp(-pow((radius - limbus_radius) / 0.55, 2.0));
    reflectance = mix(reflectance, vec3(0.52, 0.55, 0.58), 0.55 * thin);

    colour = vec4(reflectance, 0.35 + 0.65 * clouds(place * 40.0, ivec2(40), 4, 231u));
}
