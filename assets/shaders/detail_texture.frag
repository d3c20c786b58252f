// SPDX-License-Identifier: GPL-3.0-or-later
// Repeating noise for surfaces: red coarse, green fine, blue crests, alpha very fine.
in vec2 place;
out vec4 colour;

void main() {
    colour = vec4(clouds(8.0 * place, ivec2(8), 4, 101u), clouds(24.0 * place, ivec2(24), 4, 111u),
                  crests(10.0 * place, ivec2(10), 4, 121u), clouds(64.0 * place, ivec2(64), 3, 131u));
}
