in vec2 at;
flat in float strength;
uniform vec3 eye;
uniform vec3 skyLight;      // in a room: of the whole sky
uniform vec3 groundColour;  // and what the land around is made of
out vec4 shownColour;

void main() {
  if (strength < 0.0) {  // paving of two metres, fading with distance
    vec2 tile = abs(fract(at / 2.0) - 0.5), wide = fwidth(at / 2.0);
    float line = 1.0 - smoothstep(0.0, 1.5, min((0.5 - tile.x) / max(wide.x, 1e-4), (0.5 - tile.y) / max(wide.y, 1e-4)));
    float away = length(at - eye.xz);
    vec3 stone = mix(vec3(0.56, 0.55, 0.53), vec3(0.45, 0.44, 0.42), line * exp(-away / 40.0));
    if (roomed > 0) {
      vec3 light = skyLight + sunLight * max(sunWay.y, 0.0) * sunLeft(vec3(at.x, 0.0, at.y), vec3(0.0, 1.0, 0.0));
      vec3 far = mix(groundColour * light, skyLight * vec3(1.25, 1.2, 1.1), 1.0 - exp(-away / 260.0));
      shownColour = vec4(toned(far * daylight), 1.0);
      return;
    }
    shownColour = vec4(mix(stone, vec3(0.80, 0.84, 0.88), 1.0 - exp(-away / 260.0)), 1.0);
    return;
  }
  shownColour = vec4(vec3(0.0), strength * pow(max(1.0 - length(at), 0.0), 1.2));
  if (shownColour.a < 0.01) discard;
}
