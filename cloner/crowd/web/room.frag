in vec2 at;
in vec2 lightAt;
flat in float layer;
uniform sampler2DArray roomLooks;
uniform sampler2D roomLight;
uniform float brightest;  // what a white texel of the light map stands for
out vec4 shownColour;

vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

void main() {
  vec3 base = pow(texture(roomLooks, vec3(at, layer)).rgb, vec3(2.2)), light = linear(texture(roomLight, lightAt).rgb);
  shownColour = vec4(pow(min(base * light * brightest, vec3(1.0)), vec3(1.0 / 2.2)), 1.0);
}
