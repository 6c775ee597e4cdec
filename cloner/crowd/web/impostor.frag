in vec2 plane;
flat in vec4 tileA, tileB;
flat in vec4 middles;
flat in vec2 sides;
flat in vec4 turns;
flat in vec4 lifts;
flat in vec4 ways;
flat in vec4 sizes;
flat in vec2 fades;
flat in ivec4 marks;
flat in ivec4 whose;
flat in vec4 dyes;
flat in vec4 seat;

uniform vec3 stoneColour;
uniform sampler2DArray colours;  // RGB colour, A coverage
uniform sampler2DArray shapes;   // normal x, y; depth; code: what may be dyed, and eight times the zone of a limb
uniform float depthRange;
uniform float bakedFrom;         // metres from the middle where the bake's eye stood
uniform int classic;             // the source's way: nearest view, no depth
uniform int rim;                 // 0: what covers its pixels whole; 1: the rest, blended over all that was drawn before
out vec4 shownColour;

const float WHOLE = 0.97;        // coverage from which a pixel counts as whole

// Where a point of the plane lies in a tile, 0..1 of the page; below 0 outside the tile.
vec2 inPage(vec2 p, vec4 tile, vec2 middle, vec2 size) {
  vec2 texel = middle + vec2(p.x, -p.y) * sizes.x;
  if (texel.x < 0.0 || texel.y < 0.0 || texel.x > tile.z || texel.y > tile.w) return vec2(-1.0);
  return (tile.xy + texel) / size;
}

// From the eye's axes to those of a baked view, off by an azimuth: rows right, up and back of the baked camera.
mat3 turned(vec2 off) {
  float s = off.x, c = off.y, se = lifts.x, ce = lifts.y, sb = lifts.z, cb = lifts.w;
  return mat3(c, -s * se, s * ce, s * sb, cb * ce + sb * c * se, cb * se - sb * c * ce,
              -s * cb, sb * ce - cb * c * se, sb * se + cb * c * ce);
}

// The baked point that is seen at `plane` when the eye stands off the baked view: depth moves it, found by repeating. At
// edges of depth that swings to and fro: the middle of the last two (.978 instead of .973 for skirts 10 degrees off).
vec2 seenAt(vec4 tile, vec2 middle, vec2 off, float side, vec2 size) {
  vec2 own = vec2(side * plane.x, plane.y), p = own, last = own;
  if (classic == 0) {
    mat3 rows = turned(vec2(side * off.x, off.y));
    for (int k = 0; k <= 2 * marks.z; k++) {  // measured: once far away, three times near, more gain nothing
      vec2 uv = inPage(p, tile, middle, size);
      float z = uv.x < 0.0 ? 0.0 : (textureLod(shapes, vec3(uv, float(marks.y)), 0.0).b - 0.5) * depthRange;
      last = p;
      float back = (z - dot(rows[2].xy, own)) / rows[2].z;
      vec3 seen = vec3(own * (1.0 - back / sizes.y), back);
      p = vec2(dot(rows[0], seen), dot(rows[1], seen)) * (1.0 + dot(rows[2], seen) / bakedFrom);
    }
  }
  if (classic == 0 && marks.z > 0) p = 0.5 * (p + last);
  return inPage(p, tile, middle, size);
}

vec3 worn(vec3 rgb, vec2 uv) {
  float code = texelFetch(shapes, ivec3(uv * vec2(textureSize(shapes, 0).xy), marks.y), 0).a;
  int whole = int(code * 255.0 / CODE_STEP + 0.5), group = whole & 7, zone = whole >> 3;
  int limb = zone > 0 && zone < 5 ? 1 : zone > 4 && zone < 9 ? 2 : 0;  // where tops reach, where bottoms do
  int lender = limb == 1 ? whose.y : limb == 2 ? whose.z : whose.x;
  if (lender != whose.x && (group == 0 || group == limb)) {  // the lent garment may end elsewhere
    bool covers = cloneTexel(lender, REACH + limb - 1)[(zone - 1) & 3] > 0.5;
    vec3 skin = cloneTexel(whose.x, SKIN + limb).rgb;
    if (covers && group == 0) return dyed(rgb, vec4(255.0 * lumaOf(skin), 1.0, 0.0, 2.0), cloneTexel(lender, COLOURS + limb - 1).rgb);
    if (!covers && group > 0) return dyed(rgb, cloneTexel(whose.x, LOOKS + limb - 1), skin);
  }
  if (group == 0) return rgb;
  float dye = dyes[group - 1];
  vec4 look = cloneTexel(whose.x, LOOKS - 1 + group);
  if (dye >= 0.0) return dyed(rgb, look, unpacked(dye));
  if (group == 4) return rgb;  // hair
  int donor = group == 1 ? whose.y : group == 2 ? whose.z : whose.w;
  return donor == whose.x ? rgb : dyed(rgb, look, cloneTexel(donor, COLOURS - 1 + group).rgb);  // its colour in the wearer's folds
}

// Colour times coverage, and coverage; what a view of it adds to the normal goes out, in the world's axes.
vec4 viewAt(vec2 uv, vec4 found, vec2 way, float side, float share, inout vec3 normal) {
  float weight = found.a * share;
  if (weight < 0.004) return vec4(0.0);
  vec2 n = textureLod(shapes, vec3(uv, float(marks.y)), 0.0).rg * 2.0 - 1.0;
  n.x *= side;
  float z = sqrt(max(1.0 - dot(n, n), 0.0));
  float ahead = z * lifts.w - n.y * lifts.z;
  normal += weight * vec3(n.x * way.y + ahead * way.x, n.y * lifts.w + z * lifts.z, ahead * way.y - n.x * way.x);
  return vec4(found.rgb * weight, weight);
}

void main() {
  if (fadedOut(fades.x, fades.y)) discard;
  if (debugView > 0) { shownColour = vec4(0.1, 0.8, 0.2, 1.0); return; }
  vec2 size = vec2(textureSize(colours, 0).xy);
  float page = float(marks.y), share = classic == 0 && sizes.z > 0.02 ? sizes.z : 0.0;
  vec2 uvA = seenAt(tileA, middles.xy, turns.xy, sides.x, size), uvB = vec2(-1.0);
  vec4 a = uvA.x < 0.0 ? vec4(0.0) : textureLod(colours, vec3(uvA, page), sizes.w), b = vec4(0.0);
  if (share > 0.0) {
    uvB = seenAt(tileB, middles.zw, turns.zw, sides.y, size);
    if (uvB.x >= 0.0) b = textureLod(colours, vec3(uvB, page), sizes.w);
  }
  float coverage = mix(a.a, b.a, share);
  if (rim == 0 ? coverage < WHOLE : coverage < 0.02) discard;
  vec3 normal = vec3(0.0);
  vec4 sum = viewAt(uvA, a, ways.xy, sides.x, 1.0 - share, normal) + viewAt(uvB, b, ways.zw, sides.y, share, normal);
  vec3 rgb = sum.rgb / sum.a;
  if (marks.w > 0) rgb = worn(rgb, b.a * share > a.a * (1.0 - share) ? uvB : uvA);
  if (seat.w > 0.0) rgb = mix(rgb, min(stoneColour * (0.55 + 0.9 * lumaOf(rgb)), vec3(1.0)), seat.w);
  shownColour = vec4(lit(rgb, normalize(normal), marks.x, seat.xyz, false), rim == 0 ? 1.0 : coverage);
}
