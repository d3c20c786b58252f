// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of sight: see View in kernel/render/view.hpp.
uniform vec2 view_size;
uniform vec3 view_eye;
uniform vec3 view_forward;
uniform vec3 view_right;
uniform vec3 view_up;
uniform vec3 view_axis;
uniform vec3 view_plane;
uniform vec4 view_centre;

// Direction in air of a place in pixels from the bottom left.
vec3 outside_direction(vec2 pixel) {
    vec2 ndc = 2.0 * pixel / view_size - 1.0;
    return view_forward + ndc.x * view_right + ndc.y * view_up;
}

// Where its line meets the plane of depth 0.
vec3 at_plane(vec2 pixel) {
    vec3 outside = outside_direction(pixel);
    return view_eye + dot(view_plane - view_eye, view_axis) / dot(outside, view_axis) * outside;
}

// Direction of a line in its own medium, from where it meets that plane, away from the camera.
vec3 inside_direction(vec3 place) {
    vec3 direction = view_centre.w * place - view_centre.xyz;
    return normalize(dot(direction, view_axis) < 0.0 ? -direction : direction);
}

// Distance along a line per depth.
float stretch(vec2 pixel) { return 1.0 / dot(inside_direction(at_plane(pixel)), view_axis); }
