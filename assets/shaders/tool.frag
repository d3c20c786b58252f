// SPDX-License-Identifier: GPL-3.0-or-later
// Metal and silicone under the lamps of the microscope.
in vec3 world;
in vec3 normal;
in vec3 body;
flat in vec3 along;  // of the shaft
uniform vec3 camera;
uniform vec3 lamp_way;  // towards the lamps
uniform int encoded;    // 1: light as screens expect it, 0: linear
// What a part is made of is a feature (SLEEVE, CLEAR, PLASTIC, SKIN; none: metal; tool_layer.cpp), and within it:
uniform int finish;    // titanium, bore, sleeve, steel, skin, lash, drape, clear, hub, sponge, nylon
uniform int medium;    // 0: all of it, 1: only inside the eye, 2: only outside
uniform vec4 cornea;   // centre and radius of the ball of the cornea
uniform vec4 globe;    // and of the sclera
uniform sampler2D detail_map;
out vec4 colour;

// What a mirror at the instrument sees: lamps above, a pale ceiling, blue drapes, a dark horizon. turn: of the mirror's
// normal within a pixel, over which that is blurred.
vec3 surroundings(vec3 way, float turn) {
    float up = dot(way, lamp_way);
    float room = encoded == 1 ? 1.0 : 0.15;  // under a microscope the theatre is dark
    vec3 light = room * mix(vec3(0.02, 0.03, 0.04), vec3(0.16, 0.22, 0.27), smoothstep(-0.6, 0.1, up));
    light = mix(light, room * vec3(0.50, 0.52, 0.54), smoothstep(0.15, 0.75, up));
    float lamps = smoothstep(0.945 - 0.20 * turn, 0.995 + 0.07 * turn, up) / (1.0 + turn);
    light += vec3(2.6, 2.5, 2.35) * lamps;
    light *= 0.85 + 0.3 * smoothstep(-0.3, 0.3, sin(5.0 * way.x + 1.3));
    return light;
}

vec3 shown(vec3 light) { return encoded == 1 ? pow(clamp(light, 0.0, 1.0), vec3(1.0 / 2.2)) : light; }

void main() {
    vec3 n = normalize(normal);
    float turn = min(length(fwidth(n)), 1.5);  // from pixel to pixel
    bool inside = distance(world, cornea.xyz) < cornea.w || distance(world, globe.xyz) < globe.w;
    if ((medium == 1 && !inside) || (medium == 2 && inside)) {
        discard;
    }
    vec3 toward = normalize(camera - world);
    float around = atan(body.y, body.x) / 6.2831853;
    // Turned on a lathe: fine rings.
    float rings = texture(detail_map, vec2(0.35 * around, 0.9 * body.z)).a - 0.5;
    vec3 bumped = normalize(n + 0.06 * rings * vec3(0.3, 1.0, 0.2));
    vec3 mirror = surroundings(reflect(-toward, bumped), turn);
    float facing = clamp(dot(n, toward), 0.0, 1.0);
    float graze = pow(1.0 - facing, 4.0);
    if (SLEEVE == 1) {
        float wall = mix(0.40, 0.92, pow(1.0 - facing, 1.3));
        vec3 silicone = (encoded == 1 ? 1.0 : 0.3) * vec3(0.24, 0.47, 0.78) * (0.25 + 0.75 * facing) + 0.03 * rings;
        float ribs = 0.93 + 0.07 * sin(9.0 * body.z);
        vec3 shine = 0.055 * mirror + 0.25 * graze * mirror;
        colour = vec4(shown(silicone * ribs + shine / wall) * wall, wall);
        return;
    }
    if (CLEAR == 1) {
        // Moulded, clear: seen by its edges and by the lamps in it.
        float wall = mix(0.13, 0.62, pow(1.0 - facing, 1.6));
        vec3 body = (encoded == 1 ? 1.0 : 0.35) * vec3(0.62, 0.70, 0.76) * (0.3 + 0.7 * (1.0 - facing));
        colour = vec4(shown(body + (0.09 + 0.5 * graze) * mirror / wall) * wall, wall);
        return;
    }
    if (PLASTIC == 1) {
        // Plastic, cellulose, nylon.
        float lit = 0.30 + 0.70 * clamp(dot(n, lamp_way), 0.0, 1.0);
        float grain = texture(detail_map, 0.23 * body.xz + 0.31 * body.yy).a - 0.5;
        vec3 matte = finish == 8 ? vec3(0.30, 0.33, 0.36) : finish == 9 ? vec3(0.88, 0.87, 0.84) * (1.0 + 0.25 * grain)
                                                                        : vec3(0.05, 0.16, 0.42);
        float gloss = finish == 9 ? 0.0 : 0.05;
        colour = vec4(shown((encoded == 1 ? 1.0 : 0.9) * matte * lit + (gloss + 0.3 * gloss * graze) * mirror), 1.0);
        return;
    }
    if (SKIN == 1) {
        // Skin that the eye's lamps light, hair, and wet blue foil.
        float grain = texture(detail_map, 0.11 * world.xy).a - 0.5;
        float pores = texture(detail_map, 0.47 * world.xy).a - 0.5;
        float lit = 0.35 + 0.65 * clamp(dot(n, lamp_way), 0.0, 1.0);
        vec3 skin = vec3(0.52, 0.33, 0.25) * (1.0 + 0.20 * grain + 0.14 * pores);
        // Foil lies in shallow folds.
        vec2 folds = textureLod(detail_map, 0.008 * world.xy + 0.17, 3.0).rg - 0.5;
        vec3 creased = normalize(n + vec3(0.25, 0.10, 0.0) + vec3(0.5 * folds, 0.0) + 0.1 * vec3(grain, pores, 0.0));
        vec3 foil = vec3(0.09, 0.25, 0.36) * (1.0 + 0.10 * grain) * (0.85 + 0.9 * dot(folds, vec2(-0.6, 0.8)));
        vec3 matte = finish == 4 ? skin : finish == 5 ? vec3(0.030, 0.022, 0.018) : foil;
        vec3 shine = finish == 6 ? 0.04 * surroundings(reflect(-toward, creased), turn) : vec3(0.0);
        colour = vec4(shown((encoded == 1 ? 1.0 : 0.4) * (matte * lit + shine)), 1.0);
        return;
    }
    // Brushed around: a bright line along the side that faces the lamp.
    vec3 halfway = toward + lamp_way;
    halfway = normalize(halfway - dot(halfway, along) * along);
    float slant = dot(halfway, normalize(n - 0.98 * dot(n, along) * along));
    float line = encoded == 1 ? 26.0 : 70.0;
    // On a thin shaft it is narrower than a pixel, which shows its mean.
    float broad = line / (1.0 + 0.25 * line * turn * turn);
    float bright = 0.85 * sqrt(broad / line) * pow(clamp(slant, 0.0, 1.0), broad);
    mirror += vec3(1.0, 0.97, 0.90) * (bright + (encoded == 1 ? 0.10 : 0.015));
    vec3 metal = finish == 3 ? vec3(0.72, 0.73, 0.75) : vec3(0.66, 0.63, 0.60);
    vec3 light = mix(metal, vec3(1.0), graze) * mirror * (0.92 + 0.16 * rings);
    if (finish == 1) {
        light *= 0.10;
    }
    colour = vec4(shown(light), 1.0);
}
