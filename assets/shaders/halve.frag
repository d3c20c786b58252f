// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of half the size: each of its pixels lies where four of the source meet.
in vec2 place;
uniform sampler2D source;
out vec4 colour;

void main() { colour = textureLod(source, place, 0.0); }
