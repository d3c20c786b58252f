// SPDX-License-Identifier: GPL-3.0-or-later
// The lamp of the microscope. There is no other light in the theatre.
uniform float limbus_z;
uniform vec3 lamp_spot;  // its middle on the eye, and how far from there it is half as bright [mm]

// In the middle of its spot: what a white card there sends back.
const vec3 lamp = vec3(1.53, 1.47, 1.29);

// Share of that at a place of the picture, by the height of the limbus: flat in the middle.
float lamp_at(vec3 outside) {
    vec2 off = (view_eye + (limbus_z - view_eye.z) / outside.z * outside).xy - lamp_spot.xy;
    float share = dot(off, off) / (lamp_spot.z * lamp_spot.z);
    return exp2(-share * share);
}
