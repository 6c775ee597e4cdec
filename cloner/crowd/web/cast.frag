// People as the sun sees them: their depth alone.
in vec2 at;
#ifndef NO_ACTORS
in float headness;
flat in float partial;
#endif
flat in float isLoose;
flat in ivec4 whose;
uniform sampler2DArray shells;
out vec4 shownColour;

void main() {
#ifndef NO_ACTORS
  if (leftOut(headness, partial)) discard;
#endif
  if (isLoose > 0.5 && texture(shells, vec3(at, float(whose.x))).a < 0.4) discard;
  shownColour = vec4(1.0);
}
