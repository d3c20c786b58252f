// Light that reaches the fundus: mean of exp(-optical depth) over the pupil, in one pixel. Instruments block it.
uniform sampler2D optical_depth;
uniform sampler2D stop;
uniform vec3 extinction_tint;
uniform vec2 pupil_centre;  // in pixels
uniform vec2 pupil_reach;
out vec4 colour;

void main() {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    ivec2 size = textureSize(stop, 0);
    for (int row = -12; row <= 12; ++row) {
        for (int column = -12; column <= 12; ++column) {
            vec2 offset = vec2(column, row) / 12.0;
            ivec2 at = ivec2(floor(pupil_centre + offset * pupil_reach));
            if (dot(offset, offset) <= 1.0 && all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size))) {
                bool open = texelFetch(stop, at, 0).r > 1000.0;
                sum += open ? exp(-stretch(vec2(at) + 0.5) * extinction_tint * texelFetch(optical_depth, at, 0).rgb) : vec3(0.0);
                count += 1.0;
            }
        }
    }
    colour = vec4(count > 0.0 ? sum / count : vec3(1.0), 1.0);
}
