// One face's share of the optical depth; see kernel/render/signed_faces.hpp.
in float depth;
flat in vec3 face_value;
uniform sampler2D stop;  // distance to the first opaque thing on this line
out vec4 colour;

void main() {
    float distance = min(depth * stretch(), texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r);
    colour = vec4((gl_FrontFacing ? -distance : distance) * face_value, 0.0);
}
