// Distance along the line of sight, from the plane through the reference point.
in float depth;
out vec4 colour;

void main() { colour = vec4(depth * stretch(), 0.0, 0.0, 1.0); }
