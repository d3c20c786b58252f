// SPDX-License-Identifier: GPL-3.0-or-later
// A crack: depths of faces that lie under each other add up.
in float deep;
in float beside;
in float depth;
uniform sampler2D stop;
out vec4 colour;

void main() {
    if (depth > texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
    colour = vec4(deep * exp(-pow(beside / 0.060, 2.0)), deep * exp(-pow(beside / 0.15, 2.0)), 0.0, 0.0);
}
