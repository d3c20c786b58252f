// SPDX-License-Identifier: GPL-3.0-or-later
// The iris unrolled: x once around, y from the edge of the pupil (0) to the root (1). Reflectance, not shaded.
in vec2 place;
out vec4 colour;

float ridge(float value, float sharpness) { return pow(1.0 - abs(2.0 * value - 1.0), sharpness); }

// Spindle-shaped gaps, `count` around the eye, at `middle` outward; in [0, 1]: 1 in the depth of one.
float gaps(vec2 at, int count, float middle, float spread, vec2 size, uint stream) {
    float cell = floor(at.x * float(count));
    float deepest = 0.0;
    for (int i = -1; i <= 1; ++i) {
        int id = int(mod(cell + float(i), float(count)));
        float a = chance(ivec2(id, 1), stream);
        float b = chance(ivec2(id, 2), stream);
        float c = chance(ivec2(id, 3), stream);
        vec2 centre = vec2((cell + float(i) + 0.2 + 0.6 * a) / float(count), middle + spread * (b - 0.5));
        vec2 off = (at - centre) / (size * (0.45 + 0.9 * c));
        off.y += 0.25 * off.x * (a - 0.5);
        float shape = 1.0 - (abs(off.x) * 0.8 + length(off) * 0.5 + 0.25 * off.y * off.y);
        deepest = max(deepest, smoothstep(0.0, 0.45, shape) * step(0.35, fract(17.0 * (a + b))));
    }
    return deepest;
}

void main() {
    float around = place.x;
    float outward = place.y;
    // Where the zones meet: a zigzag around the eye.
    float collarette = 0.25 + 0.09 * (clouds(vec2(around * 19.0, 0.5), ivec2(19, 8), 2, 11u) - 0.5) +
                       0.05 * (noise(vec2(around * 58.0, 0.5), ivec2(58, 8), 12u) - 0.5);
    float zone = smoothstep(-0.06, 0.07, outward - collarette);

    // Fibres run outward, waver, and cross in two layers.
    float sway = 0.012 * (clouds(vec2(around * 26.0, outward * 3.0), ivec2(26, 16), 2, 21u) - 0.5);
    float u = around + sway;
    float back = ridge(clouds(vec2((around - sway) * 70.0, outward * 1.2), ivec2(70, 16), 2, 26u), 1.5);
    float coarse = ridge(clouds(vec2(u * 84.0, outward * 1.1), ivec2(84, 16), 2, 31u), 3.0);
    float fine = ridge(clouds(vec2(u * 200.0, outward * 2.0), ivec2(200, 16), 2, 41u), 2.0);
    float hair = noise(vec2(u * 520.0, outward * 3.0), ivec2(520, 16), 51u);
    float fibres = clamp(0.20 * back + 0.48 * coarse + 0.30 * fine + 0.14 * hair, 0.0, 1.0);
    float patches = clouds(vec2(around * 11.0, outward * 2.0), ivec2(11, 16), 3, 55u);

    vec3 outer = mix(vec3(0.052, 0.050, 0.042), vec3(0.37, 0.37, 0.28), pow(fibres, 1.35));
    outer = mix(outer, outer * vec3(1.25, 1.05, 0.72), 0.8 * smoothstep(0.45, 0.75, patches));
    vec3 inner = mix(vec3(0.075, 0.038, 0.016), vec3(0.44, 0.28, 0.13), pow(fibres, 1.2));
    vec3 reflectance = mix(inner, outer, zone);

    // The collarette stands out as a pale, frayed ridge.
    float fray = exp(-pow((outward - collarette) / 0.04, 2.0));
    reflectance += fray * vec3(0.16, 0.13, 0.085) * (0.25 + 1.2 * coarse);

    // Crypts, most of them along the collarette, and the dark layer that shows in them.
    vec2 frayed = vec2(around, outward) + vec2(0.0035, 0.05) * (clouds(vec2(around * 150.0, outward * 6.0), ivec2(150, 32), 2, 66u) - 0.5);
    float crypt = gaps(frayed, 26, 0.36, 0.10, vec2(0.016, 0.10), 61u);
    crypt = max(crypt, 0.8 * gaps(frayed, 38, 0.74, 0.20, vec2(0.008, 0.06), 64u));
    reflectance = mix(reflectance, vec3(0.030, 0.034, 0.040) + 0.22 * reflectance, 0.70 * crypt);

    // Furrows of contraction: arcs that break off.
    for (int i = 0; i < 3; ++i) {
        float middle = 0.50 + 0.16 * float(i) + 0.04 * (noise(vec2(around * 9.0, float(i)), ivec2(9, 8), 71u) - 0.5);
        float strength = smoothstep(0.35, 0.65, noise(vec2(around * 7.0, float(i) + 3.0), ivec2(7, 16), 72u));
        reflectance *= 1.0 - 0.40 * strength * exp(-pow((outward - middle) / 0.018, 2.0));
        reflectance *= 1.0 + 0.22 * strength * exp(-pow((outward - middle - 0.035) / 0.022, 2.0));
    }

    // The ruff: beads of dark pigment that roll over the edge of the pupil.
    float bead = 0.022 + 0.018 * noise(vec2(around * 130.0, 0.5), ivec2(130, 8), 91u);
    float ruff = 1.0 - smoothstep(bead, bead + 0.03, outward);
    reflectance = mix(reflectance, vec3(0.030, 0.014, 0.009), ruff);

    reflectance *= 1.0 - 0.55 * smoothstep(0.60, 1.0, outward);
    // Under a wet cornea, and lit as little as it is beside the spot's middle, it shows soft and dark.
    reflectance = 0.06 * mix(reflectance, vec3(0.20, 0.175, 0.135), 0.35);
    colour = vec4(reflectance, 1.0);
}
