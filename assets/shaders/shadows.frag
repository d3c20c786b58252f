// Soft shadows of the instruments, at an eighth of the size: red of what is inside the eye, green outside.
in vec2 place;
uniform sampler2D inner_tools;
uniform sampler2D outer_tools;
uniform vec2 inner_shift;  // in texture coordinates
uniform vec2 outer_shift;
out vec4 colour;

void main() {
    vec2 sum = vec2(0.0);
    for (int row = -2; row <= 2; ++row) {
        for (int column = -2; column <= 2; ++column) {
            vec2 spread = 0.5 * vec2(column, row);
            sum.r += texture(inner_tools, place - inner_shift * (1.0 + 0.3 * length(spread)) + spread * abs(inner_shift.y)).a;
            sum.g += texture(outer_tools, place - outer_shift + 0.8 * spread * abs(outer_shift.y)).a;
        }
    }
    colour = vec4(sum / 25.0, 0.0, 1.0);
}
