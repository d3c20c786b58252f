// SPDX-License-Identifier: GPL-3.0-or-later
// The eye under the operating microscope. Lamps lie close to the line of sight. Inside the eye the pixel's line is bent
// once, at the cornea (see View in kernel/render/view.hpp).
// What a scene shows beyond a healthy eye are features (names in capitals, 0 or 1; eye_parameters.cpp): without them a
// program is cheaper. The picture is put together in parts, each with what it needs only: PART 0 beyond the limbus, 1
// where the cornea shows, 2 where the edge of the pupil does: each draws what the ones before it do, and more. 3 is the
// middle of the pupil, where neither iris nor wound nor limbus can show. What eye_front.glsl, bag_support.glsl and
// pupil_contents.glsl have comes before it.
// Under a microscope that stands still, parts 0 and 1, and what lies over the pupil, are kept as light, before instruments
// and lamp: 4 and 5 write what is kept of them, 6 and 7 draw with it, and 8 the pupil. What lies over the iris is linear in
// what lies under it: light = share * iris + added.
#if PART == 2 || PART == 3 || PART == 8
uniform sampler2D optical_depth;
uniform sampler2D soft_depth;
uniform sampler2D front;
uniform sampler2D relief;
uniform sampler2D pupil_light;
uniform vec3 extinction_tint;
uniform float lamp_share;  // of the light in the middle of its spot, what falls into the pupil
uniform int has_bag;
uniform float opening_radius;
uniform float ring_in;          // 1: a tension ring lies in it
uniform vec4 loose;             // where zonules hold it no more: direction, half the width of the gap [rad], 1; or 0
uniform float cortical_opacity;
uniform sampler2D sheets;  // see SheetLayer
uniform sampler2D cracks;  // see CrackLayer
uniform float trypan_blue;
uniform float vitreous_white;  // share that triamcinolone shows
uniform float optic_rocked;    // 0 to 1

const vec3 fundus = vec3(1.0, 0.57, 0.39);
const vec3 scattered_share = vec3(0.030, 0.0195, 0.0118);  // of the light that the cataract takes out
const vec3 scattered_white = vec3(0.40, 0.395, 0.375);     // and a white one
const float fundus_light = 0.31;

struct LensLook {
    float haze;    // unevenness of what scatters
    float clear;   // and of what absorbs: spokes of the cortex
    float shade;   // of the relief
    float hollow;  // floor and walls that lie in each other's shade
    float steep;   // walls bend the light of the fundus away
    float shine;
};

// Relief and texture of the first surface of the lens.
LensLook lens_look(ivec2 pixel) {
    LensLook look = LensLook(1.0, 1.0, 1.0, 0.0, 0.0, 0.0);
    vec4 first = texelFetch(front, pixel, 0);
    vec4 slopes = texture(relief, place);
    if (first.r > 1000.0 || slopes.a < 0.99) {
        return look;
    }
    vec3 n = vec3(slopes.xy, sqrt(max(0.0, 1.0 - dot(slopes.xy, slopes.xy))));
    look.shade = clamp(0.10 + 0.98 * dot(n, normalize(vec3(-0.34, 0.42, 1.0))), 0.08, 1.4);
    look.hollow = slopes.z;
    look.steep = smoothstep(0.35, 0.90, 1.0 - n.z);
    look.shine = pow(clamp(dot(n, normalize(vec3(-0.08, 0.13, 1.0))), 0.0, 1.0), 60.0);
    vec3 rest = first.gba;
    float radius = length(rest.xy);
    float around = atan(rest.y, rest.x) / 6.2831853;
    vec4 fine = texture(detail_map, rest.xy * 0.13 + 0.05 * rest.z);
    vec4 coarse = texture(detail_map, rest.xy * 0.045);
    float spokes = textureLod(detail_map, vec2(around * 3.0, 0.018 * radius + 0.31), 0.0).b;
    float in_cortex = smoothstep(2.5, 3.6, radius) * smoothstep(0.0, 0.5, rest.z + 1.0);
    float spoke = smoothstep(0.66, 0.93, spokes + 0.10 * (fine.g - 0.5)) * (0.16 + 0.84 * in_cortex);
    look.haze = 0.72 + 0.30 * coarse.r + 0.35 * (fine.a - 0.5) + 0.16 * fine.g + 0.75 * spoke;
    look.clear = (1.0 - 0.38 * spoke) * (0.90 + 0.20 * coarse.g) * (0.96 + 0.10 * (fine.g - 0.5));
    return look;
}

vec3 pupil_colour(vec3 entry, vec3 way, vec4 tool, float radius) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float blocked = texelFetch(stop, pixel, 0).r < 1000.0 ? 1.0 : 0.0;
    vec3 sharp = texelFetch(optical_depth, pixel, 0).rgb;
    vec3 soft = texture(soft_depth, place).rgb;
    vec3 depth = max(mix(soft, sharp, blocked), 0.0) * extinction_tint / dot(way, view_axis);
    vec2 crack = vec2(0.0);
    if (CRACKS == 1) {
        // It lets light through, and its walls lie in each other's shade.
        crack = smoothstep(vec2(0.02), vec2(0.60), texture(cracks, place).rg);
        depth *= 1.0 - 0.85 * crack.r;
    }
    vec3 through = exp(-depth);
    vec3 reaches = texelFetch(pupil_light, ivec2(0), 0).rgb;
    LensLook look = lens_look(pixel);
    // The fundus is lit through the pupil: the lamp's cone covers its middle best,
    float cone = 1.0 - 0.06 * pow(radius / pupil_radius, 3.0);
    // and one side a little better than the other.
    cone *= 1.0 + 0.16 * dot(place - 0.5, vec2(-0.9, 1.6));
    // The fundus is not even, nor is what lies in the light's way: patches of the reflex.
    vec4 patches = texture(detail_map, entry.xy * 0.021 + vec2(0.37, 0.11));
    cone *= 0.25 + 1.05 * patches.r + 0.40 * patches.g;
    // Where no lens is left the fundus shows through: brighter in the middle, and not even. An eye without any is out of
    // focus, so that the lamp lights a wider patch of its fundus, and less comes back.
    float bare = exp(-12.0 * max(depth.g, 0.0));
    float blurred = OPTIC == 1 ? 0.0 : smoothstep(0.80, 0.98, reaches.g);
    float uneven = 0.90 + 0.16 * texture(detail_map, entry.xy * 0.016 + 0.21).r +
                   0.08 * texture(detail_map, entry.xy * 0.05).g;
    cone *= mix(1.0, mix(0.84, 0.54, blurred) * uneven * (1.02 - mix(0.40, 0.55, blurred) * pow(radius / pupil_radius, 2.0)), bare);
    vec3 reflex = fundus * mix(vec3(1.0), vec3(1.0, 0.92, 0.80), bare) * fundus_light * lamp_share * reaches * look.clear * cone * posterior_capsule(entry, way);
    // The edge of the wave bends the light away, and what it has parted is a little duller.
    float cells = bag_cells_at(entry, way);
    float cortex = cells_are_cortex == 1 ? cells * mix(0.35, 1.0, smoothstep(0.3, 2.6, length(entry.xy))) : 0.0;
    float wave = cells_are_cortex == 1 ? 0.0 : cells;
    reflex *= (1.0 - 2.6 * wave * (1.0 - wave)) * (1.0 - 0.10 * wave) * (1.0 - 0.45 * cortex);
    float lit = look.shade * (1.0 - 0.68 * max(look.hollow, 0.0)) * look.haze * (1.0 - 0.65 * max(crack.g - crack.r, 0.0));
    reflex *= 1.0 - 0.45 * max(crack.g - crack.r, 0.0) + 0.5 * crack.r;
    vec3 scattered = mix(scattered_share, scattered_white, cortical_opacity);
    vec3 haze = 0.5 * scattered * (1.0 - exp(-2.0 * depth)) * lamp * lit;
    vec3 behind = reflex * (1.0 - tool.a) * (1.0 - 0.36 * look.steep) + tool.rgb;
    vec3 lens = haze + behind * through + 0.006 * look.shine * lamp * smoothstep(0.02, 0.2, depth.g);
    float strands = vitreous_at(entry, way) * (1.0 - tool.a);
    lens = mix(lens * (1.0 - 0.05 * strands), vec3(0.74, 0.74, 0.72) * lamp, 0.85 * vitreous_white * strands);
    lens = mix(lens, vec3(0.112, 0.098, 0.074) * lamp, 0.75 * cortex * fluff(entry) * (1.0 - tool.a));
    if (OPTIC == 1) {
        vec2 off = (entry + (optic.z - entry.z) / way.z * way).xy - optic.xy;
        vec2 visco = viscoelastic_at(off);
        lens = lens * (1.0 - visco.y * (1.0 - tool.a)) + visco.x * lamp * (1.0 - tool.a);
        off.y *= 1.0 + 0.12 * optic_rocked;
        vec2 edge = optic_edge(off) * (1.0 - tool.a);
        lens = lens * (1.0 - 0.30 * edge.y) + (0.22 * edge.x + 0.085 * lamps_in_optic(off) * (1.0 - tool.a)) * lamp;
    }
    if (CRUMBS == 0) {
        return lens;
    }
    vec4 crumb = crumbs_at(entry, way);
    if (crumbs_are_beads == 1) {
        return mix(lens, bead_colour(crumb), crumb.x * (1.0 - tool.a));
    }
    // It lets light through where it is thin, and is as brown as what it broke from.
    vec3 flake = lens + (0.009 + 0.0315 * crumb.y) * vec3(0.95, 0.74, 0.50) * lamp;
    return mix(lens, flake * (0.70 + 0.45 * crumb.y), crumb.x * (1.0 - tool.a));
}

// The rim of the capsulorhexis and the sheen of the capsule around it.
vec3 capsule(vec3 entry, vec3 way) {
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
    vec2 around = at.xy / max(radius, 0.01);
    vec4 rough = texture(detail_map, around * 0.23);
    float uneven = 0.10 * (rough.r - 0.5) + 0.03 * (rough.a - 0.5);
    float off = radius - opening_radius - uneven;
    float thin = max(0.030, 0.85 * pixel_mm);
    float edge = exp(-pow(off / thin, 2.0));
    float fold = exp(-pow((off - 0.09 - 0.05 * rough.g) / (1.3 * thin), 2.0));
    float lit = 0.30 + 0.70 * pow(max(0.0, 0.5 + 0.5 * dot(around, vec2(-0.64, 0.77))), 1.5) + 0.35 * (rough.b - 0.5);
    float veil = smoothstep(-0.01, 0.05, off);
    float sheen = texture(detail_map, at.xy * vec2(0.05, 0.08)).b;
    float slack = 0.0;
    if (ZONULES == 1 && loose.w > 0.0) {
        // Nothing draws the capsule outward there: it lies in folds along its edge.
        float aside = acos(clamp(dot(around, loose.xy), -1.0, 1.0)) / loose.z;
        float where = (1.0 - smoothstep(0.75, 1.25, aside)) * smoothstep(0.05, 0.5, off);
        float wave = sin(15.0 * radius + 9.0 * texture(detail_map, around * 0.5 + 0.05 * radius).r + 2.0 * aside);
        slack = where * wave * smoothstep(0.30, 0.70, texture(detail_map, at.xy * 0.06 + 0.3).g);
    }
    float ridges = 0.032 * max(slack, 0.0) * max(slack, 0.0) - 0.006 * max(-slack, 0.0);
    return lamp * (ridges + 0.15 * edge * lit + 0.04 * fold * lit + veil * (0.003 + 0.012 * smoothstep(0.72, 1.0, sheen)));
}

// Beyond the edge of a bag that has come out behind the iris: the reflex without a lens, and the edge itself.
vec3 past_bag(vec3 deep, vec3 entry, vec3 way, float covered) {
    if (has_bag == 0 || ZONULES == 0) {
        return deep;
    }
    vec3 from = (bag_from_world * vec4(entry, 1.0)).xyz;
    vec3 along = mat3(bag_from_world) * way;
    vec2 at = (from - from.z / along.z * along).xy;
    float beyond = length(at) - bag_shape.x + 0.05 * (texture(detail_map, at * 0.21).r - 0.5);
    vec3 reflex = fundus * fundus_light * lamp_share * texelFetch(pupil_light, ivec2(0), 0).rgb;
    deep = mix(deep, reflex, smoothstep(-0.01, 0.06, beyond) * (1.0 - covered));
    deep *= 1.0 - 0.62 * exp(-pow((beyond + 0.03) / 0.06, 2.0)) * (1.0 - covered);
    float ring = ring_in * exp(-pow((beyond + 0.26) / 0.07, 2.0)) * (1.0 - covered);
    return mix(deep, vec3(0.20, 0.26, 0.42) * lamp, 0.75 * ring);
}

// What thin sheets do to the light of what lies under them. A stained layer keeps red back and returns blue.
const vec3 stain_passes = vec3(0.31, 0.66, 1.0);
const vec3 stain_returns = vec3(0.026, 0.125, 0.40);
const float stain_cover = 0.35;  // of what lies under one layer

// Layers, light, whitish veil, shade: see SheetLayer.
vec4 sheets_at(vec2 at) {
    // Four taps between pixels: sheets end within a pixel, not at its border.
    vec2 off = 0.5 / view_size;
    return vec4(1.0, 0.125, 0.125, 0.25) *
           (texture(sheets, at + off) + texture(sheets, at - off) + texture(sheets, at + vec2(off.x, -off.y)) +
            texture(sheets, at + vec2(-off.x, off.y)));
}

vec3 under_sheets(vec3 deep) {
    if (SHEETS == 0) {
        return deep;
    }
    vec4 here = sheets_at(place);
    // A flap that is folded over throws a shadow, to the right and below.
    vec2 step_away = vec2(0.05, -0.06) / (pixel_mm * view_size);
    float above = 0.0;
    for (int i = 1; i <= 3; ++i) {
        above += min(4.0 * texture(sheets, place - float(i) * step_away).r, 2.2) / 3.0;
    }
    float shadow = 0.22 * clamp(above - max(min(here.r, 2.2), 1.0), 0.0, 1.0);
    float veiled = 1.0 - exp(-here.b);
    float dye = trypan_blue * here.r;
    float covered = 1.0 - pow(1.0 - stain_cover, dye);
    vec3 light = deep * (1.0 - min(here.a, 0.7)) * (1.0 - shadow) * pow(stain_passes, vec3(dye));
    light += covered * stain_returns;
    vec3 white = mix(vec3(0.36, 0.36, 0.36) * lamp, vec3(0.06, 0.13, 0.34), min(1.0, 1.5 * covered));
    // Many layers in a heap mirror no more than a few do.
    float mirrored = 0.20 * (1.0 - exp(-here.g / 0.20));
    return mix(light, white, veiled) + mirrored * mix(lamp, vec3(0.50, 0.72, 1.0), min(1.0, covered));
}
#endif

#if PART == 5
layout(location = 1) out vec4 added;  // light over the iris; in the last component how clear the cornea is
#endif
#if PART == 6 || PART == 7 || PART == 8
uniform sampler2D kept;
#endif
#if PART == 7 || PART == 8
uniform sampler2D kept_added;
#endif

#if PART == 0 || PART == 1 || PART == 2 || PART == 4 || PART == 5
vec3 beyond_limbus(vec3 outside) {
    if (has_cornea == 0) {
        return nothing;
    }
    float to_globe = to_ball(view_eye, outside, globe);
    vec3 on_globe = view_eye + max(to_globe, 0.0) * outside;
    vec3 picture = to_globe > 0.0 ? sclera_colour(on_globe, outside) : vec3(0.16, 0.07, 0.06);
    vec3 on_lids = view_eye + (limbus_z + 1.5 - view_eye.z) / outside.z * outside;
    return around_eye(on_lids.xy, picture);
}

vec3 before_eye(vec3 picture, vec3 outside) {
    vec3 at = view_eye + (limbus_z - view_eye.z) / outside.z * outside;
    picture = with_hooks_outside(picture, at.xy);
    if (CAUGHT == 1 && prolapse.w > 0.0) {
        vec4 fold = prolapsed(at);
        picture = mix(picture, fold.rgb, fold.a);
    }
    return picture;
}
#endif

#if PART != 0 && PART != 4 && PART != 6
// The line of a pixel inside the eye, and where it meets the plane of the iris.
struct Inside {
    vec3 entry;
    vec3 way;
    float to_iris;
    vec3 on_iris;
};

Inside inside_of_eye() {
    Inside line;
    line.entry = at_plane(gl_FragCoord.xy);
    line.way = inside_direction(line.entry);
    line.to_iris = (iris_z - line.entry.z) / line.way.z;
    line.on_iris = line.entry + line.to_iris * line.way;
    return line;
}
#endif

#if PART == 1 || PART == 2 || PART == 7 || PART == 8
// How much of the iris an instrument before it hides.
float hidden_iris(Inside line, vec4 tool) {
    if (tool.a == 0.0) {
        return 0.0;
    }
    float tool_depth = texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r + dot(view_axis, reference - view_plane);
    return tool.a * step(tool_depth / dot(line.way, view_axis), line.to_iris);
}

vec3 with_tool(vec3 iris, vec4 tool, float hidden) { return iris * (1.0 - hidden) + tool.rgb * step(0.001, hidden); }
#endif

#if PART == 1 || PART == 2 || PART == 5
vec3 iris_at(Inside line) {
    float rho = length(line.on_iris.xy);
    if (has_iris == 0 || rho >= limbus_radius + 0.25) {
        return nothing;
    }
    // An edge that has come in takes the tissue behind it along.
    float span = limbus_radius + 0.25;
    float edge = edge_at(line.on_iris, rho);
    float from = caught_edge.z < 0.0 ? pupil_radius + (rho - edge) * (span - pupil_radius) / (span - edge) : rho;
    return iris_colour(line.on_iris, from);
}
#endif

#if PART == 1 || PART == 2 || PART == 3 || PART == 5
// Of what the front of the cornea mirrors, its back, by Fresnel: 1.376 to 1.336 against 1 to 1.376.
const float from_back = 0.0087;

// What lies over what shows inside the eye: hooks, cornea with its wounds, limbus, lamps. white: sclera and lids.
vec3 over_inside(vec3 inner, Inside line, vec3 outside, vec3 white_light, out float clear) {
#if PART == 3
    inner = with_hooks_inside(inner, line.on_iris.xy, 0.25);
#else
    inner = with_hooks_inside(inner, line.on_iris.xy, length(line.on_iris.xy) < pupil_radius ? 0.25 : 1.0);
#endif
    clear = 0.0;
    if (has_cornea == 0) {
        return inner;
    }
    float to_cornea = to_ball(view_eye, outside, cornea);
    vec3 on_cornea = view_eye + to_cornea * outside;
    float cornea_rho = to_cornea > 0.0 ? length(on_cornea.xy) : 100.0;
    vec4 grain = texture(detail_map, on_cornea.xy * 0.07);
#if PART == 3
    float white = 0.0;
#else
    float ragged = cornea_rho + 0.22 * (grain.r - 0.5);
    float white = smoothstep(limbus_radius - 0.55, limbus_radius + 0.20, ragged);
    // Cornea: the pale ring of age, the wound.
    float arcus = exp(-pow((ragged - limbus_radius + 0.85) / 0.24, 2.0));
    inner = mix(inner, vec3(0.10, 0.10, 0.098) * lamp, 0.24 * arcus * (0.6 + 0.8 * grain.g));
    vec2 cut = wound(on_cornea, incision, incision_width) + wound(on_cornea, side_port, side_port_width);
    inner = inner * (1.0 - cut.y) + cut.x * lamp;
    if (WOUNDS == 1 && wound_peel.x > 0.05) {
        vec2 flap = descemet_flap(on_cornea, incision, incision_width, wound_peel.x);
        inner = inner * (1.0 - flap.y) + flap.x * lamp;
    }
    if (WOUNDS == 1 && wound_peel.y > 0.05) {
        vec2 flap = descemet_flap(on_cornea, side_port, side_port_width, wound_peel.y);
        inner = inner * (1.0 - flap.y) + flap.x * lamp;
    }
    if (WOUNDS == 1) {
        inner = mix(inner, vec3(0.68, 0.67, 0.63) * lamp, sqrt(wound_burn) * burnt(on_cornea, grain.g));
    }
    if (WOUNDS == 1 && wound_swelling.x > 0.0) {
        inner = mix(inner, vec3(0.60, 0.63, 0.64) * lamp,
                    wound_swelling.x * swollen_stroma(on_cornea, incision, incision_width, grain.g));
    }
    if (WOUNDS == 1 && wound_swelling.y > 0.0) {
        inner = mix(inner, vec3(0.60, 0.63, 0.64) * lamp,
                    wound_swelling.y * swollen_stroma(on_cornea, side_port, side_port_width, grain.g));
    }
#endif
    for (int i = 0; STRIAE == 1 && i < 2; ++i) {
        if (striae[i].w > 0.0) {
            vec2 folds = striae_from(on_cornea, striae[i]);
            inner = inner * (1.0 - folds.y) + folds.x * lamp;
        }
    }
    vec3 picture = mix(inner, white_light, white);
    vec3 mirror = reflect(outside, normalize(on_cornea - cornea.xyz));
    vec2 lamps = lamps_in(on_cornea, mirror, grain.rg - 0.5);
    // The second image of each, in the back of the cornea, is smaller and duller by the change of index there.
    vec3 on_back = view_eye + to_ball(view_eye, outside, cornea_back) * outside;
    vec3 back_mirror = reflect(outside, normalize(on_back - cornea_back.xyz));
    lamps.x += from_back * lamps_in(on_back, back_mirror, grain.rg - 0.5).x;
    clear = (1.0 - white) * step(0.0, to_cornea);
#if PART != 3
    if (WOUNDS == 1 && wound_stitches.x > 0.0) {
        vec2 stitch = stitches_over(on_cornea, incision, incision_width, wound_stitches.x);
        picture = mix(picture * (1.0 - 0.22 * stitch.y), vec3(0.010, 0.011, 0.016) * lamp, stitch.x);
    }
    if (WOUNDS == 1 && wound_stitches.y > 0.0) {
        vec2 stitch = stitches_over(on_cornea, side_port, side_port_width, wound_stitches.y);
        picture = mix(picture * (1.0 - 0.22 * stitch.y), vec3(0.010, 0.011, 0.016) * lamp, stitch.x);
    }
    if (WOUNDS == 1 && wound_fluid.x > 0.0) {
        vec2 film = film_on_lip(on_cornea, incision, wound_fluid.x, grain.g);
        picture = picture * (1.0 - film.y) + film.x * lamp;
    }
    if (WOUNDS == 1 && wound_fluid.y > 0.0) {
        vec2 film = film_on_lip(on_cornea, side_port, wound_fluid.y, grain.g);
        picture = picture * (1.0 - film.y) + film.x * lamp;
    }
#endif
    return picture + clear * (2.0 * lamps.x + 0.010 * lamps.y + 0.0006) * lamp;
}
#endif

#if PART == 1 || PART == 2 || PART == 3 || PART == 7 || PART == 8
// The tear film is a veil that thickens and thins as it runs.
vec3 tear_film(vec3 outside, float clear) {
    vec2 at = (view_eye + (limbus_z - view_eye.z) / outside.z * outside).xy;
    float film = max(0.0, sin(0.9 * at.x - 0.6 * at.y + 0.21 * time_s) + sin(0.5 * at.x + 1.1 * at.y - 0.13 * time_s));
    return clear * 0.0016 * film * lamp;
}
#endif

#if PART == 2 || PART == 3 || PART == 8
vec3 pupil_at(Inside line, vec4 tool, float shade) {
    float rho = length(line.on_iris.xy);
    vec3 lens = past_bag(pupil_colour(line.entry, line.way, tool, rho), line.entry, line.way, tool.a);
    vec3 deep = under_sheets(lens) * (1.0 - 0.12 * shade) + capsule(line.entry, line.way) * (1.0 - 0.92 * tool.a);
    deep = with_ring_fed(deep, line.on_iris.xy, tool.a);
    float edge = edge_at(line.on_iris, rho);
    return deep * (1.0 - 0.55 * float(has_iris) * smoothstep(edge - 0.45, edge, rho));
}
#endif

#if PART == 2 || PART == 8
// The pupil, and the iris beyond its edge.
vec3 within_pupil(vec3 iris, Inside line, vec4 tool, float shade) {
    float rho = length(line.on_iris.xy);
    float edge = edge_at(line.on_iris, rho);
    float soft = max(0.015, 0.8 * pixel_mm);
    return mix(pupil_at(line, tool, shade), iris, smoothstep(edge - soft, edge + soft, rho));
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 outside = normalize(outside_direction(gl_FragCoord.xy));
#if PART == 4
    colour = vec4(before_eye(beyond_limbus(outside), outside), 1.0);
#elif PART == 5
    Inside line = inside_of_eye();
    vec3 white = beyond_limbus(outside);
    float clear = 0.0;
    vec3 from_none = before_eye(over_inside(vec3(0.0), line, outside, white, clear), outside);
    vec3 from_one = before_eye(over_inside(vec3(1.0), line, outside, white, clear), outside);
    colour = vec4(iris_at(line), from_one.g - from_none.g);
    added = vec4(from_none, clear);
#else
    vec2 shade = texture(shadows, place).rg;
#if PART == 0
    vec3 picture = before_eye(beyond_limbus(outside), outside);
#elif PART == 6
    vec3 picture = texelFetch(kept, pixel, 0).rgb;
#else
    Inside line = inside_of_eye();
    vec4 tool = texelFetch(inner_tools, pixel, 0);
    float clear = 0.0;
#if PART == 7 || PART == 8
    vec4 under = texelFetch(kept, pixel, 0);
    vec4 over_it = texelFetch(kept_added, pixel, 0);
    vec3 inner = with_tool(under.rgb * (1.0 - 0.55 * shade.r), tool, hidden_iris(line, tool));
#if PART == 8
    inner = within_pupil(inner, line, tool, shade.r);
#endif
    vec3 picture = under.a * inner + over_it.rgb + tear_film(outside, over_it.a);
#else
#if PART == 3
    vec3 inner = pupil_at(line, tool, shade.r);
    vec3 white = nothing;
#else
    vec3 inner = with_tool(iris_at(line) * (1.0 - 0.55 * shade.r), tool, hidden_iris(line, tool));
    vec3 white = beyond_limbus(outside);
#endif
#if PART == 2
    inner = within_pupil(inner, line, tool, shade.r);
#endif
    vec3 picture = over_inside(inner, line, outside, white, clear);
#if PART != 3
    picture = before_eye(picture, outside);
#endif
    picture += tear_film(outside, clear);
#endif
#endif
    vec4 over = texelFetch(outer_tools, pixel, 0);
    picture *= 1.0 - 0.50 * shade.g;
    picture = picture * (1.0 - over.a) + over.rgb;
    colour = vec4(picture * lamp_at(outside), 1.0);
#endif
}
