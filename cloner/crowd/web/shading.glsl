// Colour of cloth, light, and the pattern that fades tiers into one another.
uniform sampler2D glow;    // four texels a person
uniform int debugView;     // 1: tiers in plain colours, impostors green

// Feet stand in the dark of their own contact shadow: so much of the light is gone at the floor, fading so fast, metres.
const float DARK_BELOW = 0.35, DARK_M = 0.18;  // taste
const vec3 SKY = vec3(0.62, 0.68, 0.78), EARTH = vec3(0.42, 0.39, 0.35), SUN = vec3(1.05, 1.0, 0.9);  // taste

float lumaOf(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }

// What is dyed shows the dye in its own folds: its grey over the garment's median, evened where cloth is dark, and no
// brighter than the garment is: skin that a filter mixes into a dark hem would be a bead of light.
vec3 dyed(vec3 rgb, vec4 look, vec3 dye) {
  return min(dye * pow(min(max(lumaOf(rgb) * 255.0, 1.0) / look.x, look.w), look.y), vec3(1.0));
}

// Who stands in a lit room (solid: is more than a picture) gets the light of its probes: four numbers a colour, and how much of the sun is seen.
vec3 lit(vec3 rgb, vec3 normal, int who, vec3 world, bool solid) {
  vec3 light = mix(EARTH, SKY, normal.y * 0.5 + 0.5) + SUN * 0.55 * max(dot(normal, sunWay), 0.0);
#ifdef NO_ROOM
  return min(rgb * pow(light, vec3(1.0 / 2.2)), vec3(1.0));  // as below, in half of the powers
#else
  if (roomed > 0 && who >= 0) {
    ivec2 first = ivec2((who & 255) * 4, who >> 8);
    vec4 n = vec4(1.0, normal);
    for (int k = 0; k < 3; k++) light[k] = max(dot(texelFetch(glow, first + ivec2(k, 0), 0), n), 0.0);
    light *= 1.0 - DARK_BELOW * exp(-max(world.y, 0.0) / DARK_M) * (0.6 - 0.4 * normal.y);
    float sun = texelFetch(glow, first + ivec2(3, 0), 0).x * max(dot(normal, sunWay), 0.0);
    if (sun > 0.0) light += sunLight * sun * (solid ? sunLeft(world, normal) : 1.0);
    light = light * daylight + lanternOn(world, normal);
  }
  return toned(pow(rgb, vec3(2.2)) * light);
#endif
}

// fade f > 0 keeps the share f of the pixels, f < 0 the ones that -f leaves.
bool fadedOut(float fade, float shown) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return (fade >= 0.0 ? noise >= fade : noise < -fade) || noise >= shown;
}
