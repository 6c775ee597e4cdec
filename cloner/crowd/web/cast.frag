// People as the sun sees them: their depth alone.
in vec2 at;
in float headness;
flat in float isLoose;
flat in float partial;
flat in ivec4 whose;
uniform sampler2DArray shells;
out vec4 shownColour;

void main() {
  if (leftOut(headness, partial)) discard;
  if (isLoose > 0.5 && texture(shells, vec3(at, float(whose.x))).a < 0.4) discard;
  shownColour = vec4(1.0);
}
