// SPDX-License-Identifier: GPL-3.0-or-later
// One layer of a transparent sheet: it is seen where it mirrors the lamps, where it is looked at along its surface, and
// where wrinkles bend the light of the fundus.
in vec3 world;
in vec3 normal;
in vec2 rest;
in vec2 wrinkled;
in float depth;
uniform sampler2D stop;
uniform sampler2D detail_map;
uniform vec3 contour;  // of the lens under it: radius, anterior, posterior; or zero
uniform vec3 view_axis;
uniform int body;  // 1: a clear body's surface, front and back
out vec4 colour;

const vec3 lamps[2] = vec3[2](vec3(-0.10, 0.16, 0.98), vec3(0.13, 0.21, 0.97));

// Normal of the lens's front under a place.
vec3 under(vec2 at) {
    if (contour.x <= 0.0) {
        return vec3(0.0, 0.0, 1.0);
    }
    float level = min(dot(at, at) / (contour.x * contour.x), 0.96);
    return normalize(vec3(at / (contour.x * contour.x), sqrt(1.0 - level) / contour.y));
}

// Noise drawn out along a direction: wrinkles run along the pull.
float streaks(vec2 at, vec2 along) {
    float sum = 0.0;
    for (int i = -3; i <= 3; ++i) {
        sum += texture(detail_map, 0.30 * (at + 0.16 * float(i) * along)).r;
    }
    return sum / 7.0;
}

// What a clear smooth body does to light: each of its surfaces mirrors the lamps, all of it where it is looked at along
// the surface; its slopes bend the light of the fundus.
vec4 clear_body() {
    bool behind = dot(normal, view_axis) > 0.0;
    vec3 n = normalize(behind ? -normal : normal);
    float facing = max(-dot(n, view_axis), 0.05);
    float light = 0.0;
    for (int i = 0; i < 2; ++i) {
        float near = clamp(dot(n, normalize(lamps[i] - view_axis)), 0.0, 1.0);
        light += 0.02 * pow(near, 400.0) + 0.30 * pow(near, 6000.0);
    }
    light += 0.20 * pow(1.0 - facing, 4.0);
    float side = dot(n.xy, vec2(-0.64, 0.77));
    light += 0.05 * smoothstep(0.05, 0.6, side);
    float shade = 0.10 * smoothstep(0.05, 0.7, length(n.xy)) + 0.10 * smoothstep(0.05, 0.6, -side);
    return vec4(0.0, 2.0 * light, 0.008, shade);  // no layer that dye would stain
}

void main() {
    if (depth > texelFetch(stop, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
    if (body == 1) {
        colour = clear_body();
        return;
    }
    bool turned = normal.z < 0.0;
    vec3 n = normalize(turned ? -normal : normal);
    float facing = max(abs(dot(n, view_axis)), 0.12);
    float slant = 1.0 / facing - 1.0;
    vec4 grain = texture(detail_map, 0.21 * rest);
    vec4 coarse = texture(detail_map, 0.05 * rest);

    // Shagreen: the epithelium under it makes the mirror uneven.
    vec3 rough = normalize(n + vec3(0.10 * (grain.rg - 0.5) + 0.05 * (grain.a - 0.5), 0.0));
    float sheen = 0.0;
    for (int i = 0; i < 2; ++i) {
        vec3 halfway = normalize(lamps[i] - view_axis);
        float near = clamp(dot(rough, halfway), 0.0, 1.0);
        sheen += 0.016 * pow(near, 160.0) + 0.07 * pow(near, 2200.0);
    }

    // What stands out from the lens is lit on one side and shades the other.
    vec2 tilt = n.xy - under(world.xy).xy;
    float side = dot(tilt, vec2(-0.64, 0.77));
    float light = sheen + 0.10 * smoothstep(0.03, 0.5, side);
    float shade = 0.20 * smoothstep(0.03, 0.6, length(tilt)) + 0.14 * smoothstep(0.03, 0.5, -side);

    float deep = length(wrinkled);
    if (deep > 0.02) {
        float angle = 0.5 * atan(wrinkled.y, wrinkled.x);
        vec2 along = vec2(cos(angle), sin(angle));
        vec2 across = vec2(-along.y, along.x);
        float here = streaks(world.xy, along);
        float beside = streaks(world.xy + 0.05 * across, along);
        float slope = clamp(9.0 * (here - beside), -1.0, 1.0) * min(1.0, 1.4 * deep);
        light += 0.16 * max(slope, 0.0) * max(slope, 0.0);
        shade += 0.22 * max(-slope, 0.0);
    }

    // A fold turns every way, so that some of it always mirrors a lamp.
    float fold = smoothstep(0.35, 2.0, slant);
    light += 0.26 * fold * (0.5 + 0.8 * grain.r);
    shade *= 1.0 - fold;
    // The back of a flap is dull: cells cling to it. That of a bag, where no lens is left, is clean.
    bool dull = turned && contour.x > 0.0;
    float veil = dull ? 0.035 + 0.040 * coarse.r + 0.06 * grain.g : 0.006 + 0.006 * coarse.b;
    shade += dull ? 0.07 + 0.10 * coarse.g : 0.0;
    veil += 0.020 * min(slant, 4.0);
    colour = vec4(0.25 * min(1.0 + slant, 3.0), 2.0 * light, 2.0 * veil, shade);
}
