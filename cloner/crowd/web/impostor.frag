in vec2 plane;
flat in vec4 tileA, tileB;
flat in vec4 middles;
flat in vec4 turnA, turnB;
flat in vec3 axesA, axesB;
flat in vec2 blend;
flat in vec2 fades;
flat in int wearer;
flat in int page;
flat in int dear;
flat in float texelsPerM;
flat in ivec4 whose;
flat in vec4 dyes;

flat in float stone;
flat in vec3 seat;   // where its middle is

uniform vec3 stoneColour;
uniform sampler2DArray colours;  // RGB colour, A coverage
uniform sampler2DArray shapes;   // normal x, y; depth; code of what may be dyed
uniform float depthRange;
uniform int classic;             // the source's way: nearest view, no depth
out vec4 shownColour;

// Where a point of the plane lies in a tile, 0..1 of the page; below 0 outside the tile.
vec2 inPage(vec2 p, vec4 tile, vec2 middle, vec2 size) {
  vec2 texel = middle + vec2(p.x, -p.y) * texelsPerM;
  if (texel.x < 0.0 || texel.y < 0.0 || texel.x > tile.z || texel.y > tile.w) return vec2(-1.0);
  return (tile.xy + texel) / size;
}

// The baked point that is seen at `plane` when the eye stands off the baked view: depth moves it, found by repeating.
vec2 seenAt(vec4 tile, vec2 middle, vec4 turn, vec2 size, int times) {
  vec2 p = plane;
  for (int k = 0; k < times; k++) {
    vec2 uv = inPage(p, tile, middle, size);
    float z = uv.x < 0.0 ? 0.0 : (textureLod(shapes, vec3(uv, float(page)), 0.0).b - 0.5) * depthRange;
    p = vec2((plane.x + z * turn.x) / turn.y, (plane.y + z * turn.z) / turn.w);
  }
  return inPage(p, tile, middle, size);
}

vec3 towards(vec2 n, vec3 axes) {
  float s = sin(axes.x), c = cos(axes.x), se = sin(axes.y), ce = cos(axes.y);
  float z = sqrt(max(1.0 - dot(n, n), 0.0));
  return n.x * vec3(c, 0.0, -s) + n.y * vec3(-s * se, ce, -c * se) + z * vec3(s * ce, se, c * ce);
}

// Lit colour times coverage, and coverage.
vec4 viewAt(vec4 tile, vec2 middle, vec4 turn, vec3 axes, vec2 size, int times) {
  vec2 uv = seenAt(tile, middle, turn, size, times);
  if (uv.x < 0.0) return vec4(0.0);
  vec4 found = textureLod(colours, vec3(uv, float(page)), blend.y);
  if (found.a < 0.004) return vec4(0.0);
  vec4 shape = textureLod(shapes, vec3(uv, float(page)), 0.0);
  float code = texelFetch(shapes, ivec3(uv * vec2(textureSize(shapes, 0).xy), page), 0).a;
  int group = int(code * 4.0 + 0.5);
  vec3 rgb = found.rgb;
  if (group > 0) {
    float dye = dyes[group - 1];
    vec4 look = cloneTexel(whose.x, LOOKS - 1 + group);
    if (dye >= 0.0) rgb = dyed(rgb, look, unpacked(dye));
    else if (group < 4) {  // an exchanged garment shows its owner's colour in the wearer's folds
      int donor = group == 1 ? whose.y : group == 2 ? whose.z : whose.w;
      if (donor != whose.x) rgb = dyed(rgb, look, cloneTexel(donor, COLOURS - 1 + group).rgb);
    }
  }
  if (stone > 0.0) rgb = mix(rgb, min(stoneColour * (0.55 + 0.9 * lumaOf(rgb)), vec3(1.0)), stone);
  return vec4(lit(rgb, normalize(towards(shape.rg * 2.0 - 1.0, axes)), wearer, seat, false) * found.a, found.a);
}

void main() {
  if (fadedOut(fades.x, fades.y)) discard;
  if (debugView > 0) { shownColour = vec4(0.1, 0.8, 0.2, 1.0); return; }
  vec2 size = vec2(textureSize(colours, 0).xy);
  int times = classic > 0 ? 0 : dear > 0 ? 3 : 1;
  vec4 sum = viewAt(tileA, middles.xy, turnA, axesA, size, times);
  if (blend.x > 0.02 && classic == 0)
    sum = mix(sum, viewAt(tileB, middles.zw, turnB, axesB, size, times), blend.x);
  if (sum.a < 0.004) discard;
  shownColour = covered(sum.rgb / sum.a, clamp((sum.a - 0.5) * 1.3 + 0.5, 0.0, 1.0));
}
