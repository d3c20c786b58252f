// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths the distance to the lens along one direction, so that tetrahedra do not show as facets.
in vec2 place;
uniform sampler2D source;
uniform vec2 direction;  // one standard deviation, in texture coordinates
out vec4 colour;

void main() {
    float sum = 0.0;
    float total = 0.0;
    for (int i = -4; i <= 4; ++i) {
        float far = 0.5 * float(i);
        float distance = texture(source, place + far * direction).r;
        float weight = distance < 1000.0 ? exp(-0.5 * far * far) : 0.0;
        sum += weight * (weight > 0.0 ? distance : 0.0);
        total += weight;
    }
    colour = vec4(total > 0.0 ? sum / total : 10000.0, 0.0, 0.0, 1.0);
}
