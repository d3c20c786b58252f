// SPDX-License-Identifier: GPL-3.0-or-later
// What microscope.frag draws within the pupil besides the lens: the posterior capsule, crumbs and beads, vitreous, what the
// cells of the bag hold, an optic and viscoelastic about it. entry, way: a line of sight inside the eye.
#if PART == 2 || PART == 3 || PART == 8
uniform mat4 bag_from_world;
uniform vec3 bag_shape;  // radius, anterior, posterior
uniform vec4 folds;  // place where a tip holds the posterior capsule; 1 if it does
uniform vec4 hole;   // of the posterior capsule: place, radius
uniform vec4 vitreous;         // ball that it fills before the hole: place, radius
uniform vec4 vitreous_strand;  // that leads to the wound: place, radius; 0: there is none
uniform vec4 crumbs[24];
uniform int crumb_count;
uniform int crumbs_are_beads;  // 1: glass beads to practise with; 0: crumbs of lens
uniform vec4 bag_cells[24];    // per sector of the bag, a value 0 to 1 for each ring from the axis out
uniform int bag_sectors;
uniform int bag_rings;
uniform vec4 optic;            // of an implant that is a disc only: middle, radius
uniform vec2 optic_mirrors;    // radii of its front and back [mm]
uniform vec2 viscoelastic;     // before and behind it: share of the most that is looked for
uniform int cells_are_cortex;  // 1: cortex on the wall; 0: what the wave of hydrodissection has parted

// The posterior capsule in the reflex: folds that run like a star to where it is held, and the clear edge of a hole.
float posterior_capsule(vec3 entry, vec3 way) {
    float light = 1.0;
    if (HARM == 1 && folds.w > 0.0) {
        vec2 off = (entry + (folds.z - entry.z) / way.z * way).xy - folds.xy;
        float radius = length(off);
        float ray = 0.5 + 0.5 * cos(11.0 * atan(off.y, off.x) + 2.0 * texture(detail_map, off * 0.2).r);
        light *= 1.0 + folds.w * (1.1 * pow(ray, 6.0) - 0.55) * exp(-radius / 1.3) * smoothstep(0.1, 0.35, radius);
    }
    if (HARM == 1 && hole.w > 0.0) {
        vec2 off = (entry + (hole.z - entry.z) / way.z * way).xy - hole.xy;
        float beyond = length(off) - hole.w - 0.06 * (texture(detail_map, off * 0.3).r - 0.5);
        light *= 1.0 + 0.30 * (1.0 - smoothstep(-0.03, 0.03, beyond)) - 0.85 * exp(-pow(beyond / 0.06, 2.0));
    }
    return light;
}

// Crumbs that drift before the lens: how much of the light they take, how lit they are, and where on one this is.
vec4 crumbs_at(vec3 entry, vec3 way) {
    vec4 look = vec4(0.0);
    for (int i = 0; i < crumb_count; ++i) {
        vec3 off = cross(crumbs[i].xyz - entry, way);
        float share = length(off) / crumbs[i].w;
        if (crumbs_are_beads == 0) {  // a crumb is broken off: no two have the same outline
            vec2 own = vec2(0.37, 0.21) * float(i);
            share *= 0.55 + 0.70 * texture(detail_map, 0.11 * entry.xy + own).r +
                     0.60 * texture(detail_map, 0.23 * entry.xy + own).g;
        }
        if (share < 1.0) {
            // the line passes the middle here, across it
            vec2 on = (entry + dot(crumbs[i].xyz - entry, way) * way - crumbs[i].xyz).xy / crumbs[i].w;
            float covers = 1.0 - smoothstep(crumbs_are_beads == 1 ? 0.92 : 0.7, 1.0, share);
            if (covers >= look.x) {
                look = vec4(covers, sqrt(1.0 - share * share), on);
            }
        }
    }
    return look;
}

// A bead of blue glass in the light of the lamps: bright where the lamp stands in it, and on the far side, where what
// goes through comes out.
vec3 bead_colour(vec4 look) {
    vec3 n = vec3(look.zw, look.y);
    float lit = clamp(dot(n, normalize(vec3(-0.34, 0.42, 1.0))), 0.0, 1.0);
    float through = pow(clamp(dot(n.xy, vec2(0.55, -0.65)), 0.0, 1.0), 2.0);
    float glint = pow(clamp(dot(n, normalize(vec3(-0.30, 0.36, 1.0))), 0.0, 1.0), 70.0);
    return (vec3(0.02, 0.06, 0.17) + vec3(0.05, 0.16, 0.40) * lit * lit + vec3(0.10, 0.28, 0.45) * through +
            0.9 * glint) * lamp;
}

// Strands of vitreous across a part of the picture: fibres along `along`, 0 none to 1.
float fibres(vec2 at, vec2 along) {
    vec2 across = vec2(-along.y, along.x);
    vec2 turned = vec2(dot(at, along), dot(at, across));
    float wave = texture(detail_map, turned * 0.06).r - 0.5;
    float fine = texture(detail_map, vec2(0.05 * turned.x, 0.7 * turned.y + 0.5 * wave)).r;
    float coarse = texture(detail_map, vec2(0.03 * turned.x, 0.25 * turned.y + 0.3 * wave) + 0.37).g;
    return smoothstep(0.35, 0.85, fine) * (0.35 + 0.65 * smoothstep(0.3, 0.7, coarse));
}

// Vitreous before the hole and on its way to the wound: how much of it the light meets. Clear it hardly shows.
float vitreous_at(vec3 entry, vec3 way) {
    float amount = 0.0;
    if (HARM == 1 && vitreous.w > 0.0) {
        vec2 off = (entry + (vitreous.z - entry.z) / way.z * way).xy - vitreous.xy;
        float share = length(off) / (1.25 * vitreous.w);
        vec2 along = length(vitreous_strand.xy - vitreous.xy) > 0.1 ? normalize(vitreous_strand.xy - vitreous.xy)
                                                                    : vec2(0.0, -1.0);
        amount = (1.0 - smoothstep(0.35, 1.0, share + 0.5 * (texture(detail_map, off * 0.11).r - 0.5))) * fibres(off, along);
    }
    if (HARM == 1 && vitreous_strand.w > 0.0) {
        vec3 root = vec3(vitreous.xyz);
        vec3 line = vitreous_strand.xyz - root;
        vec3 normal = normalize(cross(line, way));
        vec3 from = entry - root;
        float beside = dot(from, normal);
        vec2 at = (entry + (root.z - entry.z) / way.z * way).xy - root.xy;
        float along = dot(at, normalize(line.xy)) / max(length(line.xy), 0.1);
        float wide = 0.18 + 0.6 * vitreous_strand.w * (1.0 - 0.6 * clamp(along, 0.0, 1.0));
        float inside = (1.0 - smoothstep(0.4, 1.0, abs(beside) / wide)) * step(0.0, along) * step(along, 1.0);
        amount = max(amount, inside * (0.25 + 0.75 * fibres(at, normalize(line.xy))));
    }
    return amount;
}

float bag_cell(int sector, int ring) {
    vec4 rings = bag_cells[(sector + bag_sectors) % bag_sectors];
    return rings[clamp(ring, 0, bag_rings - 1)];
}

// What the cells of the bag say where the ray goes through it, smooth between them.
float bag_cells_at(vec3 entry, vec3 way) {
    if (CELLS == 0) {
        return 0.0;
    }
    vec3 from = (bag_from_world * vec4(entry, 1.0)).xyz;
    vec3 along = mat3(bag_from_world) * way;
    vec2 at = (from + (-1.2 - from.z) / along.z * along).xy;
    // Cortex comes off in shreds; a wave has a smooth front.
    if (cells_are_cortex == 1) {
        at += 0.9 * (texture(detail_map, at * 0.07).rg - 0.5) + 0.4 * (texture(detail_map, at * 0.19).rg - 0.5);
    } else {
        at += 0.5 * (texture(detail_map, at * 0.03).rg - 0.5);
    }
    float ring = min(dot(at, at) / (bag_shape.x * bag_shape.x), 1.0) * float(bag_rings) - 0.5;
    float sector = atan(at.y, at.x) / 6.2831853 * float(bag_sectors) - 0.5;
    ivec2 cell = ivec2(floor(vec2(sector, ring)));
    vec2 part = smoothstep(0.0, 1.0, vec2(sector, ring) - vec2(cell));
    return mix(mix(bag_cell(cell.x, cell.y), bag_cell(cell.x + 1, cell.y), part.x),
               mix(bag_cell(cell.x, cell.y + 1), bag_cell(cell.x + 1, cell.y + 1), part.x), part.y);
}

// Cortex: grey-white fluff whose fibres run from the fornix to the middle.
float fluff(vec3 entry) {
    float turn = atan(entry.y, entry.x);
    float radius = length(entry.xy);
    float fibre = texture(detail_map, vec2(turn * 1.7, radius * 0.05)).r;
    return clamp(0.15 + 0.6 * fibre + 0.7 * (texture(detail_map, entry.xy * 0.13).g - 0.35), 0.0, 1.0);
}

// The edge of an optic in the reflex: a bright line where the lamps stand in it, and a dark one beside it.
vec2 optic_edge(vec2 off) {
    float beyond = length(off) - optic.w;
    float thin = max(0.035, 0.9 * pixel_mm);
    float facing = 0.5 + 0.5 * dot(off / max(length(off), 0.1), vec2(-0.6, 0.8));
    return vec2(exp(-pow(beyond / thin, 2.0)) * (0.25 + 0.75 * facing * facing),
                exp(-pow((beyond + 0.10) / (2.0 * thin), 2.0)));
}

// Mirror images of the lamps in its front and, upside down, in its back (Purkinje III and IV of an implant).
float lamps_in_optic(vec2 off) {
    float light = 0.0;
    for (int face = 0; face < 2; ++face) {
        vec2 at = off / (face == 0 ? optic_mirrors.x : -optic_mirrors.y);
        vec2 first = (at - vec2(0.22, 0.12)) / vec2(0.050, 0.030);
        vec2 second = (at - vec2(-0.17, 0.18)) / vec2(0.022, 0.016);
        light += (face == 0 ? 1.0 : 0.7) * (2.0 - smoothstep(0.3, 2.0, length(first)) - smoothstep(0.3, 2.0, length(second)));
    }
    return light * step(length(off), optic.w);
}

// Viscoelastic is clear. Before an optic light gleams on its uneven surface, in streaks; behind it is a bubble whose
// rim bends the light away, as wide as there is much of it. Brightness to add, and the share of the reflex it takes.
vec2 viscoelastic_at(vec2 off) {
    vec4 broad = texture(detail_map, off * 0.035 + 0.4);
    vec4 fine = texture(detail_map, off * vec2(0.10, 0.16) + 0.08 * broad.rg);
    float streak = smoothstep(0.45, 1.0, fine.r) + 0.5 * smoothstep(0.65, 1.0, fine.b);
    float before = viscoelastic.x * smoothstep(0.25, 0.65, broad.g + 0.35 * viscoelastic.x);
    float rim = optic.w * sqrt(viscoelastic.y) * 0.94 * (1.0 + 0.10 * (broad.r - 0.5)) - length(off);
    float shows = smoothstep(0.02, 0.12, viscoelastic.y);
    float edge = shows * exp(-pow(rim / 0.10, 2.0));
    float inner = shows * exp(-pow((rim - 0.16) / 0.07, 2.0));
    return vec2(before * (0.008 + 0.085 * streak * streak) + 0.05 * inner, 0.10 * before + 0.50 * edge);
}
#endif
