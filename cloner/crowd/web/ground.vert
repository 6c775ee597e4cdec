// The floor, or a soft shadow under somebody.
in vec2 corner;    // 0..1
in vec2 instance;  // who, fade; who below 0 is the floor
uniform mat4 clipFromWorld;
uniform vec3 eye;
out vec2 at;
flat out float strength;

void main() {
  vec3 place;
  if (instance.x < 0.0) {
    at = (corner - 0.5) * 1600.0 + floor(eye.xz / 4.0) * 4.0;
    place = vec3(at.x, -0.004, at.y);
    strength = -1.0;
  } else {
    Person p = personOf(int(instance.x + 0.5), true);
    at = corner * 2.0 - 1.0;
    float c = cos(p.heading), s = sin(p.heading);
    vec2 flat_ = at * vec2(0.42, 0.5) * p.scale;
    place = vec3(p.place.x, max(p.place.y, 0.0), p.place.z) + vec3(c * flat_.x + s * flat_.y, 0.004, c * flat_.y - s * flat_.x);
    strength = 0.5 * p.shown * (p.part > 1.5 ? 0.3 : 1.0);
  }
  gl_Position = clipFromWorld * vec4(place, 1.0);
}
