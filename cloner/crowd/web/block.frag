in vec3 facing;
out vec4 shownColour;

void main() { shownColour = vec4(lit(vec3(0.74, 0.71, 0.66), normalize(facing), -1, vec3(0.0), false), 1.0); }
