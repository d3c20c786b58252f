// SPDX-License-Identifier: GPL-3.0-or-later
// Value noise of lattice points that repeat, so that textures have no seams.
uint scramble(uint x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    return x ^ (x >> 16u);
}

float chance(ivec2 cell, uint stream) {
    uint mixed = scramble(uint(cell.x) + scramble(uint(cell.y) + scramble(stream)));
    return float(mixed >> 8u) / 16777216.0;
}

// In [0, 1]; repeats after `period` cells each way.
float noise(vec2 place, ivec2 period, uint stream) {
    vec2 base = floor(place);
    vec2 part = place - base;
    part = part * part * part * (part * (6.0 * part - 15.0) + 10.0);
    ivec2 low = ivec2(mod(base, vec2(period)));
    ivec2 high = ivec2(mod(base + 1.0, vec2(period)));
    float bottom = mix(chance(low, stream), chance(ivec2(high.x, low.y), stream), part.x);
    float top = mix(chance(ivec2(low.x, high.y), stream), chance(high, stream), part.x);
    return mix(bottom, top, part.y);
}

// Octaves of noise, each half as strong; in [0, 1].
float clouds(vec2 place, ivec2 period, int octaves, uint stream) {
    float sum = 0.0;
    float weight = 0.5;
    float total = 0.0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(place, period, stream + uint(i));
        total += weight;
        place *= 2.0;
        period *= 2;
        weight *= 0.5;
    }
    return sum / total;
}

// Bright along the crests of the noise; in [0, 1].
float crests(vec2 place, ivec2 period, int octaves, uint stream) {
    return 1.0 - abs(2.0 * clouds(place, period, octaves, stream) - 1.0);
}
