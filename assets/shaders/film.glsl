// SPDX-License-Identifier: GPL-3.0-or-later
// The camera on the microscope, its gain fixed: light of this level stays as it is, what is brighter grows by
// `contrast` in the logarithm, colours grow by `saturation`, and what would be brighter than `knee` comes out ever closer to white.
const float mid_grey = 0.20;
const float contrast = 1.65;
const float saturation = 1.04;
const float knee = 0.80;

vec3 photographed(vec3 light) {
    float level = dot(light, vec3(0.2126, 0.7152, 0.0722));
    vec3 value = max(mix(vec3(level), light, saturation), 0.0) * pow(max(level, 1e-4) / mid_grey, contrast - 1.0);
    vec3 over = max(value - knee, 0.0);
    value = min(value, knee) + (1.0 - knee) * over / (1.0 - knee + over);
    return pow(value, vec3(1.0 / 2.2));
}
