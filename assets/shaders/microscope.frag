// SPDX-License-Identifier: GPL-3.0-or-later
// The eye under the operating microscope. Lamps lie close to the line of sight. Inside the eye the pixel's line is bent
// once, at the cornea (see View in kernel/render/view.hpp).
in vec2 place;
uniform sampler2D optical_depth;
uniform sampler2D stop;
uniform sampler2D front;
uniform sampler2D relief;
uniform sampler2D inner_tools;
uniform sampler2D outer_tools;
uniform sampler2D pupil_light;
uniform sampler2D iris_map;
uniform sampler2D sclera_map;
uniform sampler2D detail_map;
uniform vec3 reference;
uniform float pixel_mm;  // at the iris
uniform vec4 cornea;  // centre, radius
uniform vec4 globe;
uniform float apex_z;
uniform float limbus_radius;
uniform float iris_z;
uniform float pupil_radius;
uniform float sclera_extent;
uniform vec3 incision;
uniform float incision_width;
uniform int has_bag;
uniform mat4 bag_from_world;
uniform vec3 bag_shape;  // radius, anterior, posterior
uniform float opening_radius;
out vec4 colour;

const vec3 fundus = vec3(1.0, 0.26, 0.10);
const vec3 scattered_share = vec3(0.22, 0.15, 0.065);  // of the light that the cataract takes out
const vec3 lamp = vec3(1.0, 0.97, 0.90);
const float fundus_light = 1.9;

// Distance along a line to a ball's near side; negative: misses it.
float to_ball(vec3 from, vec3 way, vec4 ball) {
    vec3 offset = from - ball.xyz;
    float middle = -dot(offset, way);
    float square = middle * middle - dot(offset, offset) + ball.w * ball.w;
    return square < 0.0 ? -1.0 : middle - sqrt(square);
}

// Mirror image of the lamps in a smooth wet surface.
float lamps_in(vec3 at, vec3 way, float softness) {
    vec3 centre[3] = vec3[3](vec3(13.0, 7.0, 185.0), vec3(-14.0, 6.0, 185.0), vec3(2.0, 30.0, 185.0));
    float size[3] = float[3](0.055, 0.055, 0.032);
    float light = 0.0;
    for (int i = 0; i < 3; ++i) {
        float apart = length(cross(way, normalize(centre[i] - at)));
        float front_side = step(0.0, way.z);
        light += front_side * (1.0 - smoothstep(size[i] - softness, size[i] + softness, apart));
    }
    return light;
}

vec3 iris_colour(vec3 at, float radius) {
    float outward = (radius - pupil_radius) / (limbus_radius + 0.25 - pupil_radius);
    float around = atan(at.y, at.x) / 6.2831853;
    // The level of detail by hand: the angle jumps where it wraps.
    float texel_mm = 6.2831853 * radius / float(textureSize(iris_map, 0).x);
    float level = max(0.0, log2(pixel_mm / texel_mm) - 0.5);
    vec3 reflectance = textureLod(iris_map, vec2(around, clamp(outward, 0.002, 0.998)), level).rgb;
    return reflectance * lamp * 1.15;
}

struct LensLook {
    vec3 haze_tint;
    float shade;
    float shine;
};

// Relief and texture of the first surface of the lens.
LensLook lens_look(ivec2 pixel) {
    vec4 first = texelFetch(front, pixel, 0);
    vec2 step_size = 1.5 / vec2(textureSize(relief, 0));
    float left = texture(relief, place - vec2(step_size.x, 0.0)).r;
    float right = texture(relief, place + vec2(step_size.x, 0.0)).r;
    float below = texture(relief, place - vec2(0.0, step_size.y)).r;
    float above = texture(relief, place + vec2(0.0, step_size.y)).r;
    LensLook look = LensLook(vec3(1.0), 1.0, 0.0);
    if (first.r > 1000.0 || max(max(left, right), max(below, above)) > 1000.0) {
        return look;
    }
    float span = 2.0 * step_size.x * view_size.x * pixel_mm;
    vec3 n = normalize(vec3((right - left) / span, (above - below) / span, 1.0));
    vec3 light = normalize(vec3(-0.30, 0.42, 1.0));
    look.shade = clamp(0.25 + 0.80 * dot(n, light), 0.15, 1.25);
    look.shine = pow(clamp(dot(n, normalize(vec3(-0.10, 0.16, 1.0))), 0.0, 1.0), 90.0);
    vec3 rest = first.gba;
    float fibre = texture(detail_map, rest.xy * 0.11).g;
    float grain = texture(detail_map, rest.xy * 0.35 + 0.2 * rest.z).a;
    float around = atan(rest.y, rest.x) / 6.2831853;
    float spokes = texture(detail_map, vec2(around * 2.0, 0.02 * length(rest.xy))).b;
    look.haze_tint = vec3(0.80 + 0.25 * fibre + 0.22 * (grain - 0.5) + 0.30 * smoothstep(0.72, 0.98, spokes));
    return look;
}

vec3 pupil_colour(vec3 entry, vec3 way, vec4 tool) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 depth = texelFetch(optical_depth, pixel, 0).rgb / dot(way, view_axis);
    vec3 through = exp(-depth);
    vec3 reaches = texelFetch(pupil_light, ivec2(0), 0).rgb;
    LensLook look = lens_look(pixel);
    vec3 reflex = fundus * fundus_light * reaches;
    vec3 haze = 0.5 * scattered_share * (1.0 - exp(-2.0 * depth)) * lamp * look.haze_tint * look.shade;
    vec3 behind = reflex * (1.0 - tool.a) + tool.rgb;
    return haze + behind * through + 0.05 * look.shine * lamp * step(0.002, depth.g);
}

// The rim of the capsulorhexis and the capsule around it.
vec3 capsule(vec3 entry, vec3 way, out float veil) {
    veil = 0.0;
    if (has_bag == 0) {
        return vec3(0.0);
    }
    vec3 from = (bag_from_world * vec4(entry, 1.0)).xyz;
    vec3 along = mat3(bag_from_world) * way;
    vec3 scale = 1.0 / vec3(bag_shape.x, bag_shape.x, bag_shape.y);
    vec3 p = from * scale;
    vec3 d = along * scale;
    float a = dot(d, d);
    float b = dot(p, d);
    float square = b * b - a * (dot(p, p) - 1.0);
    if (square < 0.0) {
        return vec3(0.0);
    }
    vec3 at = from + along * (-b - sqrt(square)) / a;
    float radius = length(at.xy);
    float around = atan(at.y, at.x);
    float uneven = 0.05 * (texture(detail_map, vec2(cos(around), sin(around)) * 0.21).r - 0.5);
    float off = radius - opening_radius - uneven;
    float edge = exp(-pow(off / max(0.045, 0.9 * pixel_mm), 2.0));
    float lower = exp(-pow((off - 0.10) / max(0.06, pixel_mm), 2.0));
    float lit = 0.55 + 0.45 * sin(around + 2.2) + 0.35 * texture(detail_map, at.xy * 0.13).g;
    veil = smoothstep(-0.01, 0.05, off);
    float sheen = texture(detail_map, at.xy * 0.06).b;
    return lamp * (0.42 * edge * lit - 0.05 * lower + veil * (0.012 + 0.03 * smoothstep(0.6, 1.0, sheen)));
}

vec3 sclera_colour(vec3 at, vec3 way) {
    vec4 sampled = texture(sclera_map, 0.5 + 0.5 * at.xy / sclera_extent);
    vec3 n = normalize(at - globe.xyz);
    vec2 bump = vec2(texture(detail_map, at.xy * 0.10 + vec2(0.004, 0.0)).g - texture(detail_map, at.xy * 0.10).g,
                     texture(detail_map, at.xy * 0.10 + vec2(0.0, 0.004)).g - texture(detail_map, at.xy * 0.10).g);
    vec3 wet = normalize(n + vec3(2.2 * bump, 0.0) * sampled.a);
    float facing = clamp(dot(n, normalize(vec3(0.05, 0.1, 1.0))), 0.0, 1.0);
    float shade = clamp(dot(wet, normalize(vec3(-0.15, 0.25, 1.0))), 0.0, 1.0);
    vec3 body = sampled.rgb * lamp * (0.30 + 0.62 * facing * shade);
    vec3 mirror = reflect(way, wet);
    float glint = pow(clamp(dot(mirror, normalize(vec3(0.0, 0.08, 1.0))), 0.0, 1.0), 120.0);
    return body + 0.55 * glint * sampled.a * lamp;
}

// The main wound: a tunnel that ends inside the cornea. Returns a brightness to add and the share it hides.
vec2 wound(vec3 at) {
    float inner = length(incision.xy);
    if (incision_width <= 0.0 || inner < 1.0) {
        return vec2(0.0);
    }
    vec2 outward = incision.xy / inner;
    float radius = length(at.xy);
    float turn = atan(outward.x * at.y - outward.y * at.x, dot(outward, at.xy));
    float along = radius * turn;
    float outer = limbus_radius - 0.18;
    float lip = inner * 1.07;
    float half_width = 0.5 * incision_width;
    float wide = 1.0 - smoothstep(half_width - 0.03, half_width + 0.05, abs(along));
    float thickness = max(0.028, 0.9 * fwidth(radius));
    float wavy = 0.03 * (texture(detail_map, at.xy * 0.15).r - 0.5);
    float outer_line = exp(-pow((radius - outer - wavy) / thickness, 2.0)) * wide;
    float inner_line = exp(-pow((radius - lip - 2.0 * wavy) / (1.3 * thickness), 2.0)) * wide;
    float side_line = exp(-pow((abs(along) - half_width) / thickness, 2.0)) * step(lip, radius) * step(radius, outer);
    float roof = wide * smoothstep(lip - 0.02, lip + 0.10, radius) * (1.0 - smoothstep(outer - 0.05, outer, radius));
    float shadow = exp(-pow((radius - outer + 0.07) / (1.6 * thickness), 2.0)) * wide;
    return vec2(0.34 * outer_line + 0.17 * inner_line + 0.13 * side_line + 0.055 * roof,
                clamp(0.55 * shadow + 0.30 * roof, 0.0, 1.0));
}

vec3 photographed(vec3 light) {
    light *= 0.85;
    vec3 curve = light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14);
    return pow(clamp(curve, 0.0, 1.0), vec3(1.0 / 2.2));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 outside = normalize(outside_direction(gl_FragCoord.xy));
    vec3 entry = at_plane(gl_FragCoord.xy);
    vec3 inside = inside_direction(entry);

    float to_cornea = to_ball(view_eye, outside, cornea);
    float to_globe = to_ball(view_eye, outside, globe);
    vec3 on_cornea = view_eye + to_cornea * outside;
    vec3 on_globe = view_eye + to_globe * outside;
    float cornea_rho = to_cornea > 0.0 ? length(on_cornea.xy) : 100.0;
    float white = smoothstep(limbus_radius - 0.42, limbus_radius + 0.22, cornea_rho);

    // Inside: iris, or the pupil with the lens; an instrument before or behind the iris.
    float to_iris = (iris_z - entry.z) / inside.z;
    vec3 on_iris = entry + to_iris * inside;
    float iris_rho = length(on_iris.xy);
    float soft = max(0.02, 0.8 * fwidth(iris_rho));
    float iris_share = smoothstep(pupil_radius - soft, pupil_radius + soft, iris_rho);
    vec4 tool = texelFetch(inner_tools, pixel, 0);
    float tool_depth = texelFetch(stop, pixel, 0).r + dot(view_axis, reference - view_plane);
    float tool_at = tool_depth / dot(inside, view_axis);

    float veil;
    vec3 rim = capsule(entry, inside, veil);
    vec3 deep = pupil_colour(entry, inside, tool) + rim * (1.0 - 0.9 * tool.a);
    deep *= 1.0 - 0.28 * smoothstep(pupil_radius - 0.55, pupil_radius, iris_rho);
    float shadow = textureLod(inner_tools, place + vec2(0.012, -0.016), 3.0).a;
    vec3 iris = iris_colour(on_iris, iris_rho) * (1.0 - 0.45 * shadow);
    iris = iris * (1.0 - tool.a * step(tool_at, to_iris)) + tool.rgb * step(tool_at, to_iris);
    vec3 inner = mix(deep, iris, iris_share);

    // Cornea: arcus of age, wound, reflections.
    float arcus = exp(-pow((cornea_rho - limbus_radius + 0.72) / 0.20, 2.0));
    inner = mix(inner, vec3(0.60, 0.60, 0.58) * lamp, 0.20 * arcus);
    vec2 cut = wound(on_cornea);
    inner = inner * (1.0 - cut.y) + cut.x * lamp;

    vec3 picture = mix(inner, to_globe > 0.0 ? sclera_colour(on_globe, outside) : vec3(0.02), white);
    vec3 n = normalize(on_cornea - cornea.xyz);
    vec3 mirror = reflect(outside, n);
    float clear = (1.0 - white) * step(0.0, to_cornea);
    picture += clear * (3.2 * lamps_in(on_cornea, mirror, 0.008) + 0.05 * lamps_in(on_cornea, mirror, 0.05)) * lamp;
    picture += clear * 0.006 * lamp;

    vec4 over = texelFetch(outer_tools, pixel, 0);
    float cast_shadow = textureLod(outer_tools, place + vec2(0.02, -0.03), 4.0).a;
    picture *= 1.0 - 0.35 * cast_shadow;
    picture = picture * (1.0 - over.a) + over.rgb;

    vec2 off = (2.0 * place - 1.0) * vec2(view_size.x / view_size.y, 1.0);
    picture *= 1.0 - 0.42 * smoothstep(0.75, 1.65, length(off));
    colour = vec4(photographed(picture), 1.0);
}
