// What a lit room adds to plain drawing: the sun behind people, the time of day, the eye's exposure and a film's curve.
uniform int roomed;            // 1: in a lit room
uniform vec3 sunWay;           // unit, towards the sun
uniform vec3 sunLight;         // of the room, by day
uniform vec3 daylight;         // what all of the room's light is multiplied by
uniform vec3 exposure;         // of red, green and blue: the eye gets used to brightness and to colour
uniform int shadowed;          // 1: people stand in the sun's way
uniform mat4 shadowFromWorld;
uniform sampler2D shadows;     // depth of people as the sun sees them
uniform vec4 lantern;          // a light that is carried about: its place, and its radius (0: none)
uniform vec3 lanternLight;     // what it gives at one metre

const float EDGE = 1.3;        // texels over which a shadow's edge goes: the sun's disc at a metre or two

// How much of the sun people leave at a place, 0..1.
float sunLeft(vec3 world, vec3 normal) {
  if (shadowed == 0) return 1.0;
  vec4 seen = shadowFromWorld * vec4(world + normal * 0.025, 1.0);
  vec3 at = seen.xyz * 0.5 + 0.5;
  if (min(min(at.x, at.y), 1.0 - max(at.x, at.y)) < 0.005 || at.z > 1.0) return 1.0;
  float size = float(textureSize(shadows, 0).x), left = 0.0;
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++)
      left += step(at.z - 0.0004, textureLod(shadows, at.xy + vec2(x, y) * EDGE / size, 0.0).r);
  return left / 9.0;
}

// Light of the lantern on a surface.
vec3 lanternOn(vec3 world, vec3 normal) {
  if (lantern.w <= 0.0) return vec3(0.0);
  vec3 to = lantern.xyz - world;
  float far = max(dot(to, to), lantern.w * lantern.w);
  return lanternLight * max(dot(normal, to), 0.0) * inversesqrt(far) / far;
}

// From light to what a screen shows. In a room: exposed, then the upper part of Khronos' PBR neutral curve (2024), which
// keeps colours as they are and bends what is brighter than .76 towards white; its lower part takes away what reflects on
// polish, of which there is none here. Elsewhere: what is brighter than white is white.
vec3 toned(vec3 rgb) {
  if (roomed > 0) {
    rgb *= exposure;
    float peak = max(rgb.r, max(rgb.g, rgb.b));
    if (peak > 0.76) {
      float bent = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
      rgb = mix(rgb * bent / peak, vec3(bent), 1.0 - 1.0 / (0.15 * (peak - bent) + 1.0));
    }
    float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;  // no bands
    return pow(clamp(rgb, 0.0, 1.0), vec3(1.0 / 2.2)) + grain / 255.0;
  }
  return pow(min(rgb, vec3(1.0)), vec3(1.0 / 2.2));
}
