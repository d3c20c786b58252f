// SPDX-License-Identifier: GPL-3.0-or-later
// What holds a bag without zonules. A hook: a blue thread of polypropylene that comes through the limbus, goes round the
// edge of the capsule's opening and ends under the capsule; outside, a silicone stopper that has been pushed against the
// limbus. A tension ring while it is fed in: from the end of its tube under the capsule into the fornix.
// What eye_front.glsl has comes before it.
uniform vec4 capsule_hooks[5];  // across the eye: where each holds the edge of the opening, and the limbus
uniform int capsule_hook_count;
uniform vec4 ring_feed;  // end of the tube, angle along which the ring lies in the fornix by now; 1 while it is fed in
uniform vec4 fornix;     // middle of the bag, radius at which the ring lies

const float thread_radius = 0.085;  // [mm]
const float thread_reach = 3.6;     // beyond the limbus
const float bend_radius = 0.13;     // of the end that goes round the edge
const float end_length = 0.75;      // under the capsule
const float stopper_from = 0.12;    // beyond the limbus
const float stopper_length = 0.85;
const float stopper_width = 0.30;   // half of it
const vec3 polypropylene = vec3(0.030, 0.105, 0.430);
const vec3 acrylic = vec3(0.20, 0.26, 0.42);  // of a ring

// A round thread by how far a place lies from its middle (signed, towards `side`): its light, and what it hides.
vec4 thread(float beside, vec2 side, vec3 body) {
    float soft = max(0.016, 0.7 * pixel_mm);
    float hides = 1.0 - smoothstep(thread_radius - soft, thread_radius + soft, abs(beside));
    float across = clamp(beside / thread_radius, -1.0, 1.0);
    vec3 n = vec3(side * across, sqrt(1.0 - across * across));
    float lit = clamp(dot(n, normalize(vec3(-0.34, 0.42, 1.0))), 0.0, 1.0);
    float glint = pow(clamp(dot(n, normalize(vec3(-0.20, 0.26, 1.0))), 0.0, 1.0), 36.0);
    return vec4(body * lamp * (0.16 + 1.05 * lit * lit) + 0.30 * glint * lamp, hides);
}

vec3 laid_over(vec3 picture, vec4 thing, float share) { return mix(picture, thing.rgb, share * thing.a); }

// One hook in its own frame: x from the edge of the opening to the limbus, y beside it.
struct HookFrame {
    vec2 along;
    vec2 side;
    float length;
};

HookFrame hook_frame(vec4 hook) {
    vec2 line = hook.zw - hook.xy;
    vec2 along = normalize(line);
    return HookFrame(along, vec2(-along.y, along.x), length(line));
}

vec2 in_frame(HookFrame frame, vec2 off) { return vec2(dot(off, frame.along), dot(off, frame.side)); }

// What a hook inside the eye covers of a picture. at: place at the plane of the iris; shadowed: how far what lies behind
// shows a shadow.
vec3 with_hook_inside(vec3 picture, vec2 at, vec4 hook, float shadowed) {
    HookFrame frame = hook_frame(hook);
    vec2 here = in_frame(frame, at - hook.xy);
    vec2 shade = in_frame(frame, at - hook.xy - vec2(0.16, -0.15));
    float in_shade = (1.0 - smoothstep(0.4 * thread_radius, 2.6 * thread_radius, abs(shade.y))) * step(-0.2, shade.x) *
                     step(shade.x, frame.length);
    picture *= 1.0 - 0.5 * shadowed * in_shade;
    // Its end lies under the capsule: duller.
    float end_beside = here.y - 2.0 * bend_radius;
    float tip = max(here.x - end_length, 0.0);
    vec4 end = thread(sign(end_beside) * length(vec2(end_beside, tip)), frame.side, polypropylene);
    picture = laid_over(picture, end, 0.62 * step(0.0, here.x));
    // Round the edge.
    vec2 from_bend = here - vec2(0.0, bend_radius);
    float off = length(from_bend);
    vec2 outward = from_bend / max(off, 1e-3);
    vec4 bend = thread(off - bend_radius, outward.x * frame.along + outward.y * frame.side, polypropylene);
    picture = laid_over(picture, bend, 0.96 * step(here.x, 0.0));
    vec4 shaft = thread(here.y, frame.side, polypropylene);
    return laid_over(picture, shaft, 0.96 * step(0.0, here.x) * step(here.x, frame.length + 0.4));
}

// The rest of it, over the white of the eye. at: place at the height of the limbus.
vec3 with_hook_outside(vec3 picture, vec2 at, vec4 hook) {
    HookFrame frame = hook_frame(hook);
    vec2 here = in_frame(frame, at - hook.zw);
    vec2 shade = here - in_frame(frame, vec2(0.10, -0.10));
    float cut = exp(-pow(here.x / 0.05, 2.0)) * (1.0 - smoothstep(0.30, 0.42, abs(here.y)));
    picture = mix(picture, vec3(0.80, 0.74, 0.70) * lamp, 0.45 * cut);
    float from = stopper_from + 0.5 * stopper_length;
    vec2 box = abs(vec2(shade.x - from, shade.y)) - vec2(0.5 * stopper_length, stopper_width);
    float thread_shade = (1.0 - smoothstep(0.5 * thread_radius, 2.0 * thread_radius, abs(shade.y))) * step(0.0, shade.x) *
                         step(shade.x, thread_reach);
    picture *= 1.0 - 0.45 * max(thread_shade, 1.0 - smoothstep(-0.10, 0.10, max(box.x, box.y)));
    vec4 shaft = thread(here.y, frame.side, polypropylene);
    picture = laid_over(picture, shaft, 0.96 * step(-0.05, here.x) * step(here.x, thread_reach));
    // Silicone: a soft block that the thread shows through.
    vec2 inside = vec2(0.5 * stopper_length, stopper_width) - abs(vec2(here.x - from, here.y));
    float rim = min(inside.x, inside.y);
    float soft = max(0.02, 0.8 * pixel_mm);
    vec3 silicone = vec3(0.34, 0.37, 0.39) * lamp * (0.60 + 0.5 * smoothstep(0.0, 0.16, rim));
    silicone += 0.30 * lamp * exp(-pow((dot(at - hook.zw - from * frame.along, vec2(-0.62, 0.78)) - 0.16) / 0.05, 2.0));
    return mix(picture, silicone, 0.62 * smoothstep(-soft, soft, rim));
}

// Distance from a ring's way between its tube and the fornix, and to which side.
vec3 off_ring(vec2 at) {
    vec2 from = ring_feed.xy - fornix.xy;
    float turn = ring_feed.z;
    vec2 outward = from / max(length(from), 1e-3);
    vec2 bend = ring_feed.xy + (fornix.z - length(from)) * 0.9 * outward;
    vec2 end = fornix.xy + fornix.z * (cos(turn) * outward + sin(turn) * vec2(-outward.y, outward.x));
    vec3 nearest = vec3(0.0, 1.0, 100.0);
    vec2 last = ring_feed.xy;
    for (int i = 1; i <= 10; ++i) {
        float share = 0.1 * float(i);
        vec2 next = mix(mix(ring_feed.xy, bend, share), mix(bend, end, share), share);
        vec2 line = next - last;
        vec2 off = at - last;
        off -= clamp(dot(off, line) / max(dot(line, line), 1e-6), 0.0, 1.0) * line;
        nearest = length(off) < nearest.z ? vec3(off / max(length(off), 1e-4), length(off)) : nearest;
        last = next;
    }
    return nearest;
}

vec3 with_ring_fed(vec3 picture, vec2 at, float covered) {
    if (ZONULES == 0 || ring_feed.w == 0.0) {
        return picture;
    }
    vec3 off = off_ring(at);
    return laid_over(picture, thread(off.z, off.xy, acrylic), 0.60 * (1.0 - covered));
}

vec3 with_hooks_inside(vec3 picture, vec2 at, float shadowed) {
    for (int i = 0; ZONULES == 1 && i < capsule_hook_count; ++i) {
        picture = with_hook_inside(picture, at, capsule_hooks[i], shadowed);
    }
    return picture;
}

vec3 with_hooks_outside(vec3 picture, vec2 at) {
    for (int i = 0; ZONULES == 1 && i < capsule_hook_count; ++i) {
        picture = with_hook_outside(picture, at, capsule_hooks[i]);
    }
    return picture;
}
