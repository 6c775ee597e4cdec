// What a person's surface shows at a point of the atlas: own texture, exchanged garments, dyes. Groups: 6 top, 7 bottom,
// 8 shoes, 9 hair; 1 to 5 and 10 are eyes, head, arms, nails, legs and mouth.
uniform sampler2DArray atlases;   // RGB colours, A codes (read without filter)
uniform sampler2DArray shells;
#ifdef CODES_APART
uniform sampler2DArray codes;     // where atlases lie in blocks, which keep no codes
#endif
uniform float codeStep;

in vec2 at;
flat in float isLoose;
flat in ivec4 whose;
flat in vec4 dyes;

// Group, and in y the zone of a limb or 0.
ivec2 groupAt(int clone, ivec2 texel) {
#ifdef CODES_APART
  float code = texelFetch(codes, ivec3(texel, clone), 0).r;
#else
  float code = texelFetch(atlases, ivec3(texel, clone), 0).a;
#endif
  float mark = code * 255.0, group = floor((mark + 0.5) / codeStep);
  return ivec2(int(group), int((mark - group * codeStep + 0.5) / ZONE_STEP));
}

// Returns colour and alpha; group and the garment's owner go out. Only who is dyed or wears others' clothes needs them.
// No loops, no gradients of their own, one look into the atlas: software rasterisers need twice as long for any of these.
vec4 wornAt(out int group, out int owner) {
  ivec2 texel = ivec2(at * vec2(textureSize(atlases, 0).xy));
  bool loose = isLoose > 0.5, bare = false, lent = !loose && whose.yzw != whose.xxx;
  owner = whose.x;
  group = 0;
  if (loose) group = at.x > 0.5 ? int(cloneTexel(whose.x, HUNG).x + 0.5) : 9;  // a coat's skirt is dyed with the coat
  if (!loose && (lent || max(max(dyes.x, dyes.y), max(dyes.z, dyes.w)) >= 0.0)) {
    ivec2 mark = groupAt(whose.x, texel);
    group = mark.x;
    if (lent) {
      bvec3 others = notEqual(whose.yzw, whose.xxx);
      bvec3 covers = bvec3(others.x && groupAt(whose.y, texel).x == 6, others.y && groupAt(whose.z, texel).x == 7,
                           others.z && groupAt(whose.w, texel).x == 8);
      bare = mark.y > 0 && !any(covers) && ((group == 6 && others.x) || (group == 7 && others.y) || (group == 8 && others.z));
      owner = covers.x ? whose.y : covers.y ? whose.z : covers.z ? whose.w : owner;
      group = covers.x ? 6 : covers.y ? 7 : covers.z ? 8 : group;
    }
  }
  vec4 own = texture(atlases, vec3(at, float(owner))), shell = texture(shells, vec3(at, float(whose.x)));
  vec4 found = loose ? shell : vec4(own.rgb, 1.0);
  if (bare) {  // the wearer's own skin, of arms above and legs below
    found.rgb = cloneTexel(whose.x, SKIN + (group == 6 ? 1 : 2)).rgb;
    group = group == 6 ? 3 : 5;
  }
  return found;
}

vec3 finished(vec3 rgb, int group, int owner) {
  float dye = group == 6 ? dyes.x : group == 7 ? dyes.y : group == 8 ? dyes.z : group == 9 ? dyes.w : -1.0;
  return dye < 0.0 ? rgb : dyed(rgb, cloneTexel(owner, LOOKS + group - 6), unpacked(dye));
}
