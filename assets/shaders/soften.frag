// Tissue scatters: what is seen through it is smoothed along one direction, but not across the rim of an instrument.
in vec2 place;
uniform sampler2D source;
uniform sampler2D stop;
uniform vec2 direction;  // one standard deviation, in texture coordinates
out vec4 colour;

void main() {
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int i = -3; i <= 3; ++i) {
        float far = 0.65 * float(i);
        vec2 at = place + far * direction;
        float weight = exp(-0.5 * far * far) * (texture(stop, at).r > 1000.0 ? 1.0 : 0.0001);
        sum += weight * texture(source, at).rgb;
        total += weight;
    }
    colour = vec4(sum / total, 1.0);
}
