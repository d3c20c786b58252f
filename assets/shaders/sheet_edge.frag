// SPDX-License-Identifier: GPL-3.0-or-later
// The edge of a sheet where it is torn or folded over: it catches the light, a darker line lies beside it.
in vec2 outward;
in float beyond;
in vec2 at;
in float depth;
uniform sampler2D stop;
uniform sampler2D detail_map;
uniform float pixel_mm;
out vec4 colour;

void main() {
    if (depth > texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
    float thin = max(0.016, 0.65 * pixel_mm);
    float bright = exp(-pow(beyond / thin, 2.0));
    float dark = exp(-pow((beyond - 2.1 * thin) / (1.3 * thin), 2.0));
    vec4 grain = texture(detail_map, 0.15 * at);
    vec2 way = normalize(outward + vec2(1e-6, 0.0));
    float lit = 0.42 + 0.60 * pow(max(0.0, 0.5 + 0.5 * dot(way, vec2(-0.64, 0.77))), 1.5) + 0.5 * (grain.r - 0.5);
    colour = vec4(0.0, 0.40 * bright * max(lit, 0.1), 0.0, 0.30 * dark * (0.6 + 0.8 * grain.b));
}
