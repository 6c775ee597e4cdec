in vec2 at;
in vec2 lightAt;
in vec3 world;
flat in float layer;
uniform sampler2DArray roomLooks;
uniform sampler2D roomLight;  // without the sun's own light
uniform sampler2D roomSun;    // how much of it falls there
uniform float brightest;      // what a white texel of the light map stands for
out vec4 shownColour;

vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }

void main() {
  vec3 base = pow(texture(roomLooks, vec3(at, layer)).rgb, vec3(2.2));
  vec3 light = linear(texture(roomLight, lightAt).rgb) * brightest;
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  float sun = texture(roomSun, lightAt).r;
  if (sun > 0.004) light += sunLight * sun * sunLeft(world, normal);
  shownColour = vec4(toned(base * (light * daylight + lanternOn(world, normal))), 1.0);
}
