// SPDX-License-Identifier: GPL-3.0-or-later
// What microscope.frag draws of the front of the eye: sclera, lids, iris, wounds.
in vec2 place;
uniform sampler2D sclera_map;
uniform sampler2D sclera_relief;
uniform sampler2D detail_map;
uniform sampler2D outer_tools;
uniform sampler2D shadows;  // of the instruments: red inside the eye, green outside
uniform vec4 cornea;        // centre, radius
uniform vec4 cornea_back;   // likewise
uniform vec4 globe;
uniform float limbus_radius;
uniform float sclera_extent;
uniform float pixel_mm;  // at the iris
uniform int has_iris;
uniform int has_cornea;  // and sclera
layout(location = 0) out vec4 colour;

const vec3 nothing = vec3(0.003, 0.002, 0.002);  // where a tissue is left out

// Distance along a line to a ball's near side; negative: misses it.
float to_ball(vec3 from, vec3 way, vec4 ball) {
    vec3 offset = from - ball.xyz;
    float middle = -dot(offset, way);
    float square = middle * middle - dot(offset, offset) + ball.w * ball.w;
    return square < 0.0 ? -1.0 : middle - sqrt(square);
}

vec3 sclera_colour(vec3 at, vec3 way) {
    vec2 where = 0.5 + 0.5 * at.xy / sclera_extent;
    vec3 reflectance = texture(sclera_map, where).rgb;
    vec3 uneven = texture(sclera_relief, where).rgb;
    vec3 n = normalize(at - globe.xyz);
    vec3 wet = normalize(n + vec3(0.38 * (uneven.xy - 0.5), 0.0));
    float facing = clamp(dot(n, vec3(0.05, 0.10, 0.994)), 0.0, 1.0);
    float shade = clamp(dot(wet, vec3(-0.145, 0.242, 0.959)), 0.0, 1.0);
    vec3 body = reflectance * lamp * (0.12 + 0.98 * facing * facing * shade);
    vec3 mirror = reflect(way, wet);
    float glint = pow(clamp(dot(mirror, vec3(0.06, 0.12, 0.991)), 0.0, 1.0), 420.0);
    return body + 0.9 * glint * uneven.z * lamp;
}

// Lids that a wire speculum holds open, and the drape over the skin. `edge`: distance from the lid's margin, outward.
vec3 around_eye(vec2 at, vec3 sclera) {
    float across = abs(at.x) / 12.0;
    float reach = (at.y > 0.0 ? 7.0 : 7.2) * (1.0 - pow(across, 3.0));
    float slope = 3.0 * 7.0 / 12.0 * min(across * across, 1.5);
    float edge = (abs(at.y) - reach) * inversesqrt(1.0 + slope * slope);
    vec4 grain = texture(detail_map, at * 0.035);
    edge += 0.10 * (grain.r - 0.5);
    vec3 margin = 0.4 * mix(vec3(0.62, 0.33, 0.27), vec3(0.72, 0.50, 0.41), smoothstep(0.1, 1.0, edge));
    margin *= 0.62 + 0.5 * grain.g;
    margin += lamp * 0.35 * smoothstep(0.62, 0.72, grain.a) * exp(-edge * edge / 0.08);
    vec4 folds = texture(detail_map, at * 0.021 + vec2(0.3, 0.1));
    vec3 drape = vec3(0.03, 0.08, 0.11) * (0.55 + 0.7 * folds.r) + lamp * 0.10 * smoothstep(0.86, 1.0, folds.b);
    vec3 cover = mix(margin, drape, smoothstep(1.5, 1.75, edge + 0.25 * (folds.g - 0.5)));
    vec3 open = sclera * (1.0 - 0.50 * exp(-max(0.0, -edge) / 0.55));
    open += lamp * 0.30 * exp(-pow((edge + 0.10) / 0.05, 2.0)) * grain.g;  // tears along the margin
    vec3 picture = mix(open, cover, smoothstep(-0.03, 0.03, edge));
    float bend = max(0.0, abs(at.x) - 5.2);
    float wire = (edge - 0.15 - 0.22 * bend * bend) / 0.42;
    float inside = sqrt(max(0.0, 1.0 - wire * wire));
    vec3 steel = vec3(0.06, 0.07, 0.08) + vec3(0.42) * smoothstep(0.2, 1.0, inside) * (0.6 + 0.4 * wire);
    steel += lamp * 1.2 * exp(-pow((wire - 0.18) / 0.16, 2.0)) + lamp * 0.35 * exp(-pow((wire + 0.55) / 0.12, 2.0));
    float pixel = 1.5 * pixel_mm / 0.42;
    picture *= 1.0 - 0.55 * exp(-pow((wire + 1.15) / 0.55, 2.0));
    return mix(picture, steel, 1.0 - smoothstep(1.0 - pixel, 1.0 + pixel, abs(wire)));
}

uniform sampler2D iris_map;
uniform float pupil_radius;
uniform float incision_width;
uniform vec4 prolapse;     // of the iris into the main wound: direction, from the axis, length; 0: there is none

// A wide pupil has pushed the stroma into folds that lie in each other's shade; a narrow one has drawn it flat.
float drawn_out() { return 1.0 + 2.4 * (1.0 - smoothstep(2.5, 3.85, pupil_radius)); }

vec3 iris_colour(vec3 at, float radius) {
    float outward = (radius - pupil_radius) / (limbus_radius + 0.25 - pupil_radius);
    float around = atan(at.y, at.x) / 6.2831853;
    // The level of detail by hand: the angle jumps where it wraps.
    float texel_mm = 6.2831853 * radius / float(textureSize(iris_map, 0).x);
    float level = max(0.0, log2(pixel_mm / texel_mm) - 0.5);
    return textureLod(iris_map, vec2(around, clamp(outward, 0.002, 0.998)), level).rgb * drawn_out() * lamp;
}

// Iris that lies in the wound and before it: a moist fold, dark where its pigment shows at the rim, and its shadow on what
// lies beside it. What it hides is in the last component.
vec4 prolapsed(vec3 at) {
    float along = at.y * prolapse.x - at.x * prolapse.y;
    float out_to = dot(prolapse.xy, at.xy) - prolapse.z;
    float half_length = 0.25 + 0.22 * prolapse.w;
    float half_width = 0.48 * incision_width;
    vec4 grain = texture(detail_map, at.xy * 0.30);
    vec2 off = vec2(along / half_width, (out_to - half_length + 0.15) / half_length);
    float round = dot(off, off) + 0.30 * (grain.r - 0.5);
    float hides = 1.0 - smoothstep(0.86, 1.02, round);
    vec2 slope = prolapse.xy * off.y + vec2(-prolapse.y, prolapse.x) * off.x;
    vec3 n = normalize(vec3(0.8 * slope + 0.45 * (grain.gb - 0.5), sqrt(max(0.1, 1.0 - 0.8 * dot(off, off)))));
    float lit = clamp(dot(n, normalize(vec3(-0.34, 0.42, 1.0))), 0.0, 1.0);
    // The stroma is of one colour with the rest of the iris; its folds run towards the wound.
    vec4 folds = texture(detail_map, vec2(0.35 * along, 0.07 * out_to) + 0.05 * grain.rg);
    vec3 stroma = textureLod(iris_map, vec2(0.25, 0.7), 7.0).rgb * drawn_out() * lamp * (0.55 + 0.5 * smoothstep(0.3, 0.8, folds.r));
    float pigment = smoothstep(0.55, 1.0, round + 0.35 * (grain.g - 0.5));
    vec3 body = mix(stroma * (0.6 + 2.2 * lit), vec3(0.050, 0.032, 0.022) * (0.4 + 0.9 * lit), 0.75 * pigment);
    float wet = pow(clamp(dot(n, normalize(vec3(-0.16, 0.24, 1.0))), 0.0, 1.0), 60.0) * smoothstep(0.35, 0.75, grain.a + 0.3 * folds.g);
    float shadow = 0.34 * (1.0 - smoothstep(1.0, 1.9, round));
    vec3 picture = mix(vec3(0.05, 0.03, 0.03), body + 0.22 * wet * lamp, step(0.001, hides));
    return vec4(mix(vec3(0.05, 0.03, 0.03), picture, hides), max(hides, shadow));
}

#if PART >= 1
uniform sampler2D inner_tools;
uniform sampler2D stop;
uniform vec3 reference;
uniform float iris_z;
uniform vec3 incision;
uniform float wound_burn;
uniform vec3 side_port;
uniform float side_port_width;
uniform vec2 wound_swelling;  // of the stroma beside the main wound and the side port: 0 none, 1 white
uniform vec2 wound_fluid;     // radius of what lies on the lip of each [mm]
uniform vec2 wound_peel;      // Descemet's membrane that hangs off at the inner lip of each [mm]
uniform vec2 wound_stitches;  // that hold each
uniform vec4 striae[2];       // of a cornea that a shaft bends beside its wound: inner lip, 0 none to 1
uniform float time_s;
uniform vec3 caught_edge;  // of the pupil: direction, how far it is drawn in

// Mirror image of the microscope's lamps in the tear film, large and soft as it is on a wet cornea, and the glow around it.
vec2 lamps_in(vec3 at, vec3 way, vec2 ripple) {
    const vec2 ways[3] = vec2[3](vec2(0.44, 0.24), vec2(0.27, 0.42), vec2(-0.34, 0.36));
    const vec2 sizes[3] = vec2[3](vec2(0.145, 0.082), vec2(0.095, 0.075), vec2(0.055, 0.038));
    vec2 slant = way.xy / max(way.z, 0.05) + at.xy * 0.005 + 0.035 * ripple;
    vec2 light = vec2(0.0);
    for (int i = 0; i < 3; ++i) {
        vec2 off = mat2(0.88, 0.47, -0.47, 0.88) * (slant - ways[i]) / sizes[i];
        vec2 squared = off * off;
        light.x += 1.0 - smoothstep(0.3, 2.4, dot(squared, squared));
        light.y += 1.0 / (1.0 + 0.3 * dot(off, off) * dot(off, off));
    }
    return light * step(0.0, way.z);
}

// Radius of the pupil's edge in the direction of a place.
float edge_at(vec3 at, float rho) {
    if (CAUGHT == 0) {
        return pupil_radius;
    }
    float aside = caught_edge.z != 0.0 ? dot(at.xy, caught_edge.xy) / max(rho, 0.01) : -1.0;
    return caught_edge.z < 0.0 ? pupil_radius + caught_edge.z * (1.0 - exp(-(1.0 - aside) / 0.06))
                               : pupil_radius - caught_edge.z * exp(-(1.0 - aside) / 0.05);
}

// Where a burnt main wound is white: its roof and lips, more the nearer to its middle.
float burnt(vec3 at, float grain) {
    vec2 outward = incision.xy / max(length(incision.xy), 1e-3);
    float along = at.y * outward.x - at.x * outward.y;
    float off = dot(outward, at.xy) - 1.04 * length(incision.xy);
    float fibres = texture(detail_map, vec2(0.23 * along, 0.06 * off)).g;
    return min(0.85, 1.4 * exp(-pow(along / (0.62 * incision_width), 4.0) - pow(off / (0.34 + 0.2 * grain), 2.0))) *
           (0.70 + 0.45 * fibres);
}

// Where the stroma beside a wound is white and tight with water: its tunnel and both of its sides.
float swollen_stroma(vec3 at, vec3 inner_lip, float width, float grain) {
    vec2 outward = inner_lip.xy / max(length(inner_lip.xy), 1e-3);
    float along = at.y * outward.x - at.x * outward.y;
    float off = dot(outward, at.xy) - 0.5 * (length(inner_lip.xy) + limbus_radius);
    float shape = exp(-pow(along / (0.55 * width + 0.30), 2.0) - pow(off / (0.72 + 0.5 * (grain - 0.5)), 2.0));
    float fibres = texture(detail_map, vec2(0.11 * along, 0.03 * off)).g;
    return 0.58 * shape * (0.65 + 0.35 * grain + 0.45 * (fibres - 0.4));
}

// A place beside a wound: along its lips, and outward from the axis.
vec2 beside_wound(vec3 at, vec3 inner_lip) {
    vec2 outward = inner_lip.xy / max(length(inner_lip.xy), 1e-3);
    return vec2(at.y * outward.x - at.x * outward.y, dot(outward, at.xy));
}

// Where the inner lip shows on the front of the cornea, from the axis. A tunnel has some length, however short it is.
float shown_lip(vec3 inner_lip) { return min(1.075 * length(inner_lip.xy), limbus_radius - 0.42); }

// Fluid on an outer lip: a drop that lies flat, with the lamps in it and a dark edge. Returns a brightness to add and the
// share it hides.
vec2 film_on_lip(vec3 at, vec3 inner_lip, float reach, float grain) {
    vec2 outward = inner_lip.xy / max(length(inner_lip.xy), 1e-3);
    vec2 off = at.xy - (limbus_radius - 0.05) * outward;
    float along = off.y * outward.x - off.x * outward.y;
    float far = length(vec2(0.45 * along, dot(off, outward))) + 0.30 * reach * (grain - 0.5);
    float soft = max(0.05, pixel_mm);
    float inside = 1.0 - smoothstep(reach - soft, reach + soft, far);
    float edge = exp(-pow((far - reach) / 0.09, 2.0));
    vec2 slope = off / max(reach, 0.1) * smoothstep(0.0, 1.0, far / max(reach, 0.1));
    float glint = exp(-dot(slope - vec2(-0.42, 0.55), slope - vec2(-0.42, 0.55)) / 0.035);
    float rim = exp(-pow((far - 0.86 * reach) / 0.06, 2.0)) * clamp(0.5 + dot(slope, vec2(0.35, -0.45)), 0.0, 1.0);
    return vec2(inside * (0.02 + 0.60 * glint + 0.12 * rim), 0.10 * inside + 0.17 * edge);
}

// Descemet's membrane that hangs off at an inner lip: a clear flap that rolls up at its free end. Returns a brightness to
// add and the share it hides.
vec2 descemet_flap(vec3 at, vec3 inner_lip, float width, float peel) {
    vec2 where = beside_wound(at, inner_lip);
    float into = (shown_lip(inner_lip) - where.y) / (0.75 * peel);
    float grain = texture(detail_map, at.xy * 0.06).g - 0.5;
    float half_width = 0.46 * width * (1.0 - 0.22 * into) + 0.10 * grain;
    float aside = abs(where.x) - half_width;
    float free_end = 1.0 + 0.35 * grain - 0.18 * pow(where.x / max(half_width, 0.1), 2.0);
    float soft = max(0.03, pixel_mm);
    float on = (1.0 - smoothstep(-soft, soft, aside)) * step(0.0, into) *
               (1.0 - smoothstep(free_end, free_end + 0.06, into));
    float thin = max(0.035, 1.1 * pixel_mm);
    float roll = (into - free_end + 0.12) * 0.75 * peel;
    float scroll = exp(-pow(roll / (1.6 * thin), 2.0)) - 0.7 * exp(-pow((roll + 2.6 * thin) / (1.4 * thin), 2.0));
    float border = exp(-pow(aside / thin, 2.0)) * step(0.0, into) * step(into, free_end);
    return vec2(0.006 * on + 0.08 * max(scroll, 0.0) * on + 0.015 * border,
                clamp(0.10 * on + 0.35 * max(-scroll, 0.0) * on, 0.0, 1.0));
}

// Folds of the cornea's back that run like a fan from a wound whose shaft is levered: each with light on one side and dark
// on the other, the longer the more it is bent. Returns a brightness to add and the share it hides.
vec2 striae_from(vec3 at, vec4 lip) {
    const float fan = 0.125;     // from fold to fold [rad]
    const float outside = 0.42;  // where they would meet, beyond the lip: share of its distance from the axis
    float from_axis = length(lip.xy);
    vec2 outward = lip.xy / from_axis;
    vec2 from = at.xy - (1.0 + outside) * lip.xy;
    vec2 line = vec2(dot(from, vec2(-outward.y, outward.x)), -dot(from, outward));
    float far = length(line);
    float into = far - outside * from_axis;
    vec4 grain = texture(detail_map, at.xy * 0.05);
    vec4 waves = texture(detail_map, at.xy * 0.025 + 0.4);
    float turn = atan(line.x, line.y) + 0.10 * (waves.r - 0.5);
    float fold = floor(turn / fan + 0.5);
    float own = fract(0.618034 * fold + 0.37);
    float across = (turn - fan * (fold + 0.35 * (own - 0.5))) * far;
    float reach = (1.2 + 3.6 * lip.w) * (0.55 + 0.45 * own);
    float on = smoothstep(-0.1, 0.5, into) * (1.0 - smoothstep(0.4 * reach, reach, into)) *
               (1.0 - smoothstep(0.40, 0.62, abs(turn))) * smoothstep(0.15, 0.55, own + lip.w) * (0.5 + 0.8 * grain.g);
    float wide = max(0.06, 0.9 * pixel_mm);
    float bright = exp(-pow((across - wide) / wide, 2.0));
    float dark = exp(-pow((across + wide) / (1.3 * wide), 2.0));
    return lip.w * on * vec2(0.060 * bright, 0.42 * dark);
}

// Stitches across an outer lip: how much of each place the thread hides, and how far the cornea is drawn in beside it.
vec2 stitches_over(vec3 at, vec3 inner_lip, float width, float count) {
    vec2 where = beside_wound(at, inner_lip);
    float spacing = min(0.95, width / max(count, 1.0));
    float place_in_row = where.x / spacing + 0.5 * (count - 1.0);
    float nearest = clamp(floor(place_in_row + 0.5), 0.0, count - 1.0);
    float beside = (place_in_row - nearest) * spacing;
    float over = where.y - (limbus_radius - 0.20);
    float thin = max(0.022, 0.75 * pixel_mm);
    float long_as = 1.0 - smoothstep(0.72, 0.80, abs(over));
    float thread = (1.0 - smoothstep(0.5 * thin, 1.5 * thin, abs(beside))) * long_as;
    float knot = 1.0 - smoothstep(0.05, 0.05 + 1.5 * thin, length(vec2(beside, over - 0.42)));
    float ends = (1.0 - smoothstep(0.5 * thin, 1.5 * thin, abs(abs(beside) - 0.9 * (over - 0.42)))) *
                 step(0.42, over) * step(over, 0.62);
    float drawn = exp(-pow(beside / 0.16, 2.0)) * (1.0 - smoothstep(0.75, 1.05, abs(over)));
    return vec2(max(max(thread, knot), ends), drawn);
}

// A wound: a tunnel that ends inside the cornea. Its outer lip is a fine grey line with light on it; of the rest one sees
// a little haze, and the inner lip where the light falls well. Returns a brightness to add and the share it hides.
vec2 wound(vec3 at, vec3 incision, float incision_width) {
    float inner = length(incision.xy);
    if (incision_width <= 0.0 || inner < 1.0) {
        return vec2(0.0);
    }
    vec2 outward = incision.xy / inner;
    float radius = length(at.xy);
    float turn = atan(outward.x * at.y - outward.y * at.x, dot(outward, at.xy));
    float along = radius * turn;
    float outer = limbus_radius - 0.20;
    float lip = shown_lip(incision);
    float into = clamp((outer - radius) / (outer - lip), 0.0, 1.0);
    float half_width = 0.5 * incision_width * (1.0 - 0.10 * into);
    vec4 grain = texture(detail_map, at.xy * 0.12);
    vec4 fine = texture(detail_map, at.xy * 0.45);
    float wavy = 0.07 * (grain.r - 0.5);
    float wide = 1.0 - smoothstep(half_width - 0.18, half_width + 0.06, abs(along));
    float thin = max(0.030, 0.9 * pixel_mm);
    float broken = 0.35 + 0.9 * smoothstep(0.30, 0.70, fine.g);
    float outer_line = exp(-pow((radius - outer - wavy) / thin, 2.0)) * wide * broken;
    float inner_line = exp(-pow((radius - lip - 1.5 * wavy - 0.05 * along * along) / (2.2 * thin), 2.0)) * wide *
                       smoothstep(0.35, 0.75, fine.r);
    float sides = exp(-pow((abs(along) - half_width + 0.06 - wavy) / (2.5 * thin), 2.0)) *
                  smoothstep(lip, lip + 0.3, radius) * (1.0 - smoothstep(outer - 0.3, outer, radius));
    float roof = wide * smoothstep(lip - 0.05, lip + 0.25, radius) * (1.0 - smoothstep(outer - 0.10, outer, radius));
    float shadow = exp(-pow((radius - outer - wavy + 0.08) / (2.0 * thin), 2.0)) * wide;
    float swollen = wide * exp(-pow((radius - outer + 0.30) / 0.26, 2.0));
    return vec2(0.16 * outer_line + 0.025 * inner_line + 0.008 * sides * grain.g + roof * (0.002 + 0.006 * grain.a) +
                    0.012 * swollen,
                clamp(0.60 * shadow + 0.10 * roof + 0.16 * swollen + 0.10 * sides, 0.0, 1.0));
}
#endif
