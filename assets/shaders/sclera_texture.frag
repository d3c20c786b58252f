// Sclera and conjunctiva seen from above, over [-half_extent, half_extent]^2 mm.
in vec2 place;
uniform sampler2D vessels;
uniform float half_extent;
uniform float limbus_radius;
out vec4 colour;

void main() {
    vec2 at = (2.0 * place - 1.0) * half_extent;
    float radius = length(at);
    float around = atan(at.y, at.x) / 6.2831853 + 0.5;
    float mottle = clouds(place * 9.0, ivec2(9), 5, 201u);
    float grain = clouds(place * 90.0, ivec2(90), 3, 211u);
    vec3 reflectance = mix(vec3(0.76, 0.68, 0.61), vec3(0.86, 0.81, 0.76), smoothstep(0.25, 0.75, mottle));
    reflectance *= 0.97 + 0.06 * grain;

    // Blood in the finest vessels: a blush that thickens away from the cornea, and close around it.
    float far = smoothstep(limbus_radius + 1.0, limbus_radius + 5.5, radius);
    float close = exp(-pow((radius - limbus_radius - 0.55) / 0.45, 2.0));
    float net = crests(place * 46.0, ivec2(46), 3, 241u);
    float blush = clamp(0.55 * far + 0.45 * close, 0.0, 1.0) * smoothstep(0.25, 0.8, mottle);
    reflectance = mix(reflectance, vec3(0.74, 0.44, 0.39), 0.42 * blush + 0.22 * blush * smoothstep(0.85, 0.98, net));

    vec2 blood = texture(vessels, place).rg;
    reflectance = mix(reflectance, vec3(0.56, 0.30, 0.31), 0.55 * blood.g);
    reflectance = mix(reflectance, vec3(0.42, 0.045, 0.040), 0.92 * blood.r);

    // Palisades: pale and dark spokes that cross the limbus.
    float spokes = noise(vec2(around * 190.0, radius * 1.2), ivec2(190, 64), 221u);
    float patches = clouds(vec2(around * 17.0, 0.5), ivec2(17, 8), 2, 222u);
    float band = smoothstep(limbus_radius - 0.4, limbus_radius + 0.05, radius) *
                 (1.0 - smoothstep(limbus_radius + 0.25, limbus_radius + 0.85, radius));
    reflectance *= 1.0 - 0.38 * band * spokes * smoothstep(0.25, 0.7, patches);
    // The limbus itself is thin enough for the dark inside to show, bluish.
    float thin = exp(-pow((radius - limbus_radius + 0.05) / 0.42, 2.0));
    reflectance = mix(reflectance, vec3(0.36, 0.38, 0.39), 0.60 * thin);
    colour = vec4(reflectance, 1.0);
}
