// SPDX-License-Identifier: GPL-3.0-or-later
// One face's share of the optical depth; see kernel/render/signed_faces.hpp. In units of depth: distance along the line
// is that times stretch(), the same for all faces of a pixel.
in float depth;
flat in vec3 face_value;
uniform sampler2D stop;  // depth of the first opaque thing on this line
out vec4 colour;

void main() {
    float until = min(depth, texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r);
    colour = vec4((gl_FrontFacing ? -until : until) * face_value, 0.0);
}
