in vec3 normal;
in vec3 world;
flat in vec2 fades;
flat in int wearer;
uniform vec3 eye;
out vec4 shownColour;

#ifndef NO_ACTORS
in float headness;
in vec3 rested;
flat in float stone;
flat in float partial;
uniform sampler2DArray stones;       // the atlases and shells of the same people in stone
uniform sampler2DArray stoneShells;

// How much of a place is still stone: life begins at the head and runs down in patches.
float stoneAt(vec3 place) {
  vec3 p = place * 9.0;
  float patchy = sin(p.x * 3.1 + 2.0 * sin(p.y * 1.7)) * sin(p.y * 2.3 + 1.3 * sin(p.z * 2.9)) * sin(p.z * 3.7 + p.x);
  return smoothstep(0.0, 0.1, 1.2 * stone - 0.1 - clamp(0.85 * place.y + 0.12 * patchy + 0.07, 0.0, 1.0));
}
#endif

void main() {
  if (fadedOut(fades.x, fades.y)) discard;
#ifndef NO_ACTORS
  if (leftOut(headness, partial)) discard;
#endif
  int group, owner;
  vec4 found = wornAt(group, owner);
  if (isLoose > 0.5 && found.a < 0.4) discard;  // as the material in the glTF
  vec3 n = normalize(normal);
  if (dot(n, eye - world) < 0.0) n = -n;  // cloth and hair that turn inside out
  vec3 rgb = finished(found.rgb, group, owner);
#ifndef NO_ACTORS
  float hard = stone > 0.0 ? stoneAt(rested) : 0.0;
  if (hard > 0.0) rgb = mix(rgb, (isLoose > 0.5 ? texture(stoneShells, vec3(at, float(whose.x)))
                                                : texture(stones, vec3(at, float(whose.x)))).rgb, hard);
#endif
  rgb = lit(rgb, n, wearer, world, true);
  if (debugView > 0) rgb = mix(rgb, vec3(0.85, 0.3, 0.2), 0.35);
  shownColour = vec4(rgb, 1.0);
}
