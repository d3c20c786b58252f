// Smooths the depth of the lens's first surface along one direction, so that tetrahedra do not show as facets: red over
// a short way, green over a long one.
in vec2 place;
uniform sampler2D source;
uniform vec2 direction;  // one standard deviation of the short way, in texture coordinates
uniform int first;       // 1: the source holds the bare depth in red
out vec4 colour;

void main() {
    vec2 sum = vec2(0.0);
    vec2 total = vec2(0.0);
    for (int i = -4; i <= 4; ++i) {
        vec2 way = vec2(0.5, 2.2) * float(i);
        float near = texture(source, place + way.x * direction).r;
        vec2 wide = texture(source, place + way.y * direction).rg;
        float far = first == 1 ? wide.r : wide.g;
        vec2 there = vec2(near < 1000.0 ? 1.0 : 0.0, far < 1000.0 ? 1.0 : 0.0);
        vec2 weight = exp(-0.5 * vec2(0.25, 0.25) * float(i * i)) * there;
        sum += weight * mix(vec2(0.0), vec2(near, far), there);
        total += weight;
    }
    vec2 smoothed = sum / max(total, vec2(1e-6));
    colour = vec4(mix(vec2(10000.0), smoothed, step(vec2(1e-6), total)), 0.0, 1.0);
}
