// How uneven and wet the conjunctiva is: slopes (0.5 is flat) and, in blue, the share of a mirror.
in vec2 place;
uniform float half_extent;
uniform float limbus_radius;
out vec4 colour;

float height(vec2 at) { return clouds(at * 22.0, ivec2(22), 4, 231u) + 0.15 * crests(at * 14.0, ivec2(14), 2, 251u); }

void main() {
    float radius = length((2.0 * place - 1.0) * half_extent);
    float here = height(place);
    vec2 slope = vec2(height(place + vec2(0.0015, 0.0)) - here, height(place + vec2(0.0, 0.0015)) - here) / 0.0015;
    float film = smoothstep(limbus_radius - 0.2, limbus_radius + 0.6, radius);
    colour = vec4(clamp(0.5 + 0.028 * slope * film, 0.0, 1.0), 0.25 + 0.75 * smoothstep(0.35, 0.7, here), 1.0);
}
