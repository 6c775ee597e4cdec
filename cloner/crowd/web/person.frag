in vec3 normal;
in vec3 world;
flat in vec2 fades;
flat in int wearer;
uniform vec3 eye;
out vec4 shownColour;

void main() {
  if (fadedOut(fades.x, fades.y)) discard;
  int group, owner;
  vec4 found = wornAt(group, owner);
  if (isLoose > 0.5 && found.a < 0.4) discard;  // as the material in the glTF
  vec3 n = normalize(normal);
  if (dot(n, eye - world) < 0.0) n = -n;  // cloth and hair that turn inside out
  vec3 rgb = lit(finished(found.rgb, group, owner), n, wearer);
  if (debugView > 0) rgb = mix(rgb, vec3(0.85, 0.3, 0.2), 0.35);
  shownColour = vec4(rgb, 1.0);
}
