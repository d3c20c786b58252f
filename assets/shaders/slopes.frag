// SPDX-License-Identifier: GPL-3.0-or-later
// Of the smoothed depth of the lens's first surface: its unit normal (sideways, upwards), how hollow it is, and whether
// there is a surface here and around.
in vec2 place;
uniform sampler2D relief;   // depth, and that of wider surroundings
uniform float spacing_mm;   // of neighbours in that texture
out vec4 colour;

void main() {
    vec2 off = vec2(1.0) / vec2(textureSize(relief, 0));
    vec2 left = texture(relief, place - vec2(off.x, 0.0)).rg;
    vec2 right = texture(relief, place + vec2(off.x, 0.0)).rg;
    vec2 below = texture(relief, place - vec2(0.0, off.y)).rg;
    vec2 above = texture(relief, place + vec2(0.0, off.y)).rg;
    float there = max(max(left.r, right.r), max(below.r, above.r)) > 1000.0 ? 0.0 : 1.0;
    vec3 n = normalize(vec3((right.r - left.r) / (2.0 * spacing_mm), (above.r - below.r) / (2.0 * spacing_mm), 1.0));
    // Deeper than its wider surroundings: a hollow.
    float hollow = clamp(0.25 * (left.r + right.r + below.r + above.r - left.g - right.g - below.g - above.g), -0.5, 1.0);
    colour = there * vec4(n.xy, hollow, 1.0);
}
