// SPDX-License-Identifier: GPL-3.0-or-later
// A matte card in the place of the eye.
uniform float reflectance;
out vec4 colour;

void main() {
    vec3 outside = normalize(outside_direction(gl_FragCoord.xy));
    colour = vec4(reflectance * lamp * lamp_at(outside), 1.0);
}
