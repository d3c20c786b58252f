// SPDX-License-Identifier: GPL-3.0-or-later
// The iris unrolled: x once around, y from the edge of the pupil (0) to the root (1). Reflectance, not shaded.
in vec2 place;
out vec4 colour;

float ridge(float value, float sharpness) { return pow(1.0 - abs(2.0 * value - 1.0), sharpness); }

void main() {
    float around = place.x;
    float outward = place.y;
    // Where the zones meet: a zigzag around the eye.
    float collarette = 0.27 + 0.07 * (clouds(vec2(around * 23.0, 0.5), ivec2(23, 8), 2, 11u) - 0.5) +
                       0.035 * (noise(vec2(around * 64.0, 0.5), ivec2(64, 8), 12u) - 0.5);
    float zone = smoothstep(-0.045, 0.05, outward - collarette);

    // Fibres run outward and waver.
    float sway = 0.010 * (clouds(vec2(around * 30.0, outward * 4.0), ivec2(30, 16), 2, 21u) - 0.5);
    float u = around + sway;
    float coarse = ridge(clouds(vec2(u * 90.0, outward * 1.6), ivec2(90, 16), 2, 31u), 2.0);
    float fine = ridge(clouds(vec2(u * 230.0, outward * 2.6), ivec2(230, 16), 2, 41u), 1.6);
    float hair = noise(vec2(u * 560.0, outward * 5.0), ivec2(560, 16), 51u);
    float fibres = 0.45 * coarse + 0.35 * fine + 0.20 * hair;

    vec3 outer = mix(vec3(0.10, 0.14, 0.17), vec3(0.46, 0.52, 0.52), pow(fibres, 1.25));
    vec3 inner = mix(vec3(0.17, 0.095, 0.045), vec3(0.55, 0.38, 0.20), pow(fibres, 1.1));
    vec3 reflectance = mix(inner, outer, zone);

    // The collarette stands out as a pale, frayed ridge.
    float fray = exp(-pow((outward - collarette) / 0.035, 2.0));
    reflectance += fray * vec3(0.17, 0.145, 0.10) * (0.4 + 0.8 * coarse);

    // Crypts: gaps in the front layer, most of them along the collarette.
    vec2 cell = vec2(around * 34.0, outward * 5.0);
    float gap = clouds(cell, ivec2(34, 16), 2, 61u);
    float where = exp(-pow((outward - collarette - 0.10) / 0.14, 2.0)) + 0.35 * smoothstep(0.55, 0.8, outward);
    float crypt = smoothstep(0.60, 0.72, gap) * where;
    reflectance *= 1.0 - 0.72 * clamp(crypt, 0.0, 1.0);

    // Furrows of contraction: arcs that break off.
    for (int i = 0; i < 3; ++i) {
        float middle = 0.52 + 0.15 * float(i) + 0.03 * (noise(vec2(around * 9.0, float(i)), ivec2(9, 8), 71u) - 0.5);
        float strength = smoothstep(0.35, 0.65, noise(vec2(around * 7.0, float(i) + 3.0), ivec2(7, 16), 72u));
        reflectance *= 1.0 - 0.34 * strength * exp(-pow((outward - middle) / 0.016, 2.0));
        reflectance *= 1.0 + 0.16 * strength * exp(-pow((outward - middle - 0.03) / 0.02, 2.0));
    }

    // Freckles of pigment.
    float freckle = smoothstep(0.74, 0.80, noise(vec2(around * 40.0, outward * 7.0), ivec2(40, 16), 81u));
    reflectance = mix(reflectance, vec3(0.20, 0.12, 0.06), 0.55 * freckle * zone);

    // The ruff: beads of dark pigment that roll over the edge of the pupil.
    float bead = 0.020 + 0.014 * noise(vec2(around * 150.0, 0.5), ivec2(150, 8), 91u);
    float ruff = 1.0 - smoothstep(bead, bead + 0.02, outward);
    reflectance = mix(reflectance, vec3(0.045, 0.022, 0.014), ruff);

    reflectance *= 1.0 - 0.45 * smoothstep(0.72, 1.0, outward);
    colour = vec4(reflectance, 1.0);
}
