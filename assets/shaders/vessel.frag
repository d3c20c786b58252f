// SPDX-License-Identifier: GPL-3.0-or-later
// Strength of the vessels near the surface (red) and of the deep ones (green); the strongest wins.
in vec4 ribbon;
out vec4 colour;

void main() {
    float across = abs(ribbon.x);
    float edge = ribbon.w < 0.5 ? 1.0 - smoothstep(0.55, 1.0, across) : pow(max(0.0, 1.0 - across * across), 1.5);
    float strength = ribbon.z * edge;
    colour = ribbon.w < 0.5 ? vec4(strength, 0.0, 0.0, 1.0) : vec4(0.0, strength, 0.0, 1.0);
}
