// A lit room: what is drawn of it, with its textures and its light map.
in vec3 position;
in vec2 uv;
in vec2 lightUv;
in float look;
uniform mat4 clipFromWorld;
out vec2 at;
out vec2 lightAt;
out vec3 world;
flat out float layer;

void main() {
  at = uv;
  lightAt = lightUv;
  layer = look;
  world = position;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
