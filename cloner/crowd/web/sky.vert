// The sky behind a room, over the whole picture.
in vec2 corner;  // 0..1
uniform vec3 skyAhead, skyRight, skyUp;  // to the picture's middle, to its right and upper border
out vec3 way;

void main() {
  vec2 at = corner * 2.0 - 1.0;
  way = skyAhead + at.x * skyRight + at.y * skyUp;
  gl_Position = vec4(at, 0.9999995, 1.0);
}
