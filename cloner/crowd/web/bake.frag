// One impostor's tile: colour; then eye-space normal, depth, the group that may be dyed and the zone of a limb.
in vec3 normal;
in vec3 world;
uniform vec3 eye;
uniform vec3 tileRight, tileUp, tileBack;  // the tile's axes; back points to the eye
uniform vec3 tileCentre;
uniform float depthRange;
layout(location = 0) out vec4 tileColour;
layout(location = 1) out vec4 tileShape;

void main() {
  int group, owner;
  vec4 found = wornAt(group, owner);
  if (isLoose > 0.5 && found.a < 0.4) discard;
  ivec2 mark = isLoose < 0.5 ? groupAt(whose.x, ivec2(at * vec2(textureSize(atlases, 0).xy))) : ivec2(group, 0);
  vec3 n = normalize(normal);
  if (dot(n, eye - world) < 0.0) n = -n;  // back faces would be lit from behind
  float depth = dot(world - tileCentre, tileBack) / depthRange + 0.5;
  tileColour = vec4(found.rgb, 1.0);
  int code = 8 * mark.y + (mark.x >= 6 && mark.x <= 9 ? mark.x - 5 : 0);
  tileShape = vec4(dot(n, tileRight) * 0.5 + 0.5, dot(n, tileUp) * 0.5 + 0.5, clamp(depth, 0.0, 1.0), float(code) * CODE_STEP / 255.0);
}
