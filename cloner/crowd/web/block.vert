// What stands in the way of those who act: plain blocks.
in vec3 position;
in vec3 normal;
uniform mat4 clipFromWorld;
out vec3 facing;

void main() {
  facing = normal;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
