// An instrument, in front of the cornea or behind it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_world;
uniform mat4 world_from_body;
out vec3 world;
out vec3 normal;
out vec3 body;
flat out vec3 along;

void main() {
    vec4 moved = world_from_body * vec4(position, 1.0);
    gl_Position = clip_from_world * moved;
    world = moved.xyz;
    normal = mat3(world_from_body) * direction;
    body = position;
    along = mat3(world_from_body) * vec3(0.0, 0.0, 1.0);
}
