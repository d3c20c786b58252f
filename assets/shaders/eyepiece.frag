// SPDX-License-Identifier: GPL-3.0-or-later
// What the optics of a microscope and the film of its camera do to the light of a sharp picture: what is out of focus
// spreads, the field ends in a round stop, the lamp is turned up or down. Two pictures make one for red and cyan glasses.
in vec2 place;
uniform sampler2D sharp;        // with its smaller copies
uniform sampler2D inner_tools;  // covered where alpha is
uniform sampler2D outer_tools;
uniform sampler2D front;        // depth of the lens's first surface, see LensFront
uniform vec3 reference;         // from which that is measured
uniform vec2 size;              // of the picture [pixels]
uniform vec2 middle;            // of the picture, in the eye's frame [mm]
uniform float field_mm;         // height of the picture
uniform float stop_mm;          // diameter of the field; 0: there is no stop
uniform float aperture;         // half the angle of the light from a point, as a sine
uniform float focus_z;          // height that is in focus [mm]
uniform float iris_z;
uniform float back_z;           // what shows in the pupil where there is no lens
uniform float pupil_radius;     // as it shows [mm]
uniform float limbus_radius;
uniform vec4 globe;             // ball of the sclera
uniform vec4 tool_ends[16];     // pairs: place in the picture from its lower left, height [mm]
uniform int tool_end_count;
uniform float light;
uniform int only;               // 1: red, 2: green and blue
out vec4 colour;

const float edge_pixels = 2.0;

// Features, as in microscope.frag: SPREADS what is out of focus, where TOOLS are; for one EYE of two.

// Height of the instrument that is nearest to a pixel.
float tool_height(vec2 pixel) {
    float nearest = 1e9;
    float height = focus_z;
    for (int i = 0; i < tool_end_count; i += 2) {
        vec2 way = tool_ends[i + 1].xy - tool_ends[i].xy;
        float share = clamp(dot(pixel - tool_ends[i].xy, way) / max(dot(way, way), 1e-6), 0.0, 1.0);
        float away = distance(pixel, tool_ends[i].xy + share * way);
        if (away < nearest) {
            nearest = away;
            height = mix(tool_ends[i].z, tool_ends[i + 1].z, share);
        }
    }
    return height;
}

// A point spreads over a pixel and a half by lenses and sensor.
vec3 spread_by_lenses(ivec2 pixel) {
    ivec2 last = ivec2(size) - 1;
    vec3 beside = texelFetch(sharp, max(pixel - ivec2(1, 0), 0), 0).rgb +
                  texelFetch(sharp, max(pixel - ivec2(0, 1), 0), 0).rgb +
                  texelFetch(sharp, min(pixel + ivec2(1, 0), last), 0).rgb +
                  texelFetch(sharp, min(pixel + ivec2(0, 1), last), 0).rgb;
    return 0.40 * texelFetch(sharp, pixel, 0).rgb + 0.15 * beside;
}

float height_at(vec2 mm, ivec2 pixel) {
    if (TOOLS == 1 && max(texelFetch(inner_tools, pixel, 0).a, texelFetch(outer_tools, pixel, 0).a) > 0.3) {
        return tool_height(vec2(pixel) + 0.5);
    }
    float radius = length(mm);
    if (radius < pupil_radius) {
        float depth = texelFetch(front, pixel, 0).r;
        return depth > 1000.0 ? back_z : reference.z - depth;
    }
    if (radius < limbus_radius) {
        return iris_z;
    }
    float beside = length(mm - globe.xy);
    return globe.z + sqrt(max(0.0, globe.w * globe.w - beside * beside));
}

void main() {
    vec2 from_middle = (place - 0.5) * size;
    float pixels_per_mm = size.y / field_mm;
    vec3 seen = spread_by_lenses(ivec2(gl_FragCoord.xy));
    if (SPREADS == 1) {
        float height = height_at(middle + from_middle / pixels_per_mm, ivec2(place * size));
        float spread = 2.0 * aperture * abs(height - focus_z) * pixels_per_mm;
        if (spread > 1.3) {
            float level = log2(0.75 * spread);
            vec2 off = 0.2 * spread / size;
            seen = 0.5 * (textureLod(sharp, place + off, level).rgb + textureLod(sharp, place - off, level).rgb);
        }
    }
    if (stop_mm > 0.0) {
        float within = clamp((0.5 * stop_mm * pixels_per_mm - length(from_middle)) / edge_pixels + 0.5, 0.0, 1.0);
        seen = within > 0.0 ? seen * within : vec3(0.0);  // beyond it nothing is painted
    }
    seen = photographed(seen * light);
    if (EYE == 1) {
        // for red and cyan glasses each eye gets its own colours, of a picture that is half grey: Dubois is left out
        float grey = dot(seen, vec3(0.30, 0.59, 0.11));
        seen = only == 1 ? vec3(mix(grey, seen.r, 0.3), 0.0, 0.0) : vec3(0.0, seen.gb);
    }
    colour = vec4(seen, 1.0);
}
