// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of half the size: each of its pixels is the mean of four of the source.
uniform sampler2D source;  // which shows one of its levels only
out vec4 colour;

void main() {
    ivec2 first = 2 * ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(source, 0) - 1;
    colour = 0.25 * (texelFetch(source, min(first, last), 0) + texelFetch(source, min(first + ivec2(1, 0), last), 0) +
                     texelFetch(source, min(first + ivec2(0, 1), last), 0) +
                     texelFetch(source, min(first + ivec2(1, 1), last), 0));
}
