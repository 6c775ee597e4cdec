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

// Group, and in y whether a limb is there.
ivec2 groupAt(int clone, ivec2 texel) {
#ifdef CODES_APART
  float code = texelFetch(codes, ivec3(texel, clone), 0).r;
#else
  float code = texelFetch(atlases, ivec3(texel, clone), 0).a;
#endif
  int mark = int(code * 255.0 + 0.5), step = int(codeStep + 0.5);
  return ivec2(mark / step, mark % step > 0 ? 1 : 0);
}

// Returns colour and alpha; group and the garment's owner go out. Only who is dyed or wears others' clothes needs them.
// Loops that nobody enters are skipped by software rasterisers too, branches are not.
vec4 wornAt(out int group, out int owner) {
  owner = whose.x;
  group = 0;
  vec2 dx = dFdx(at), dy = dFdy(at);
  vec4 found = vec4(0.0);
  int loose = isLoose > 0.5 ? 1 : 0;
  bool dyedToo = max(max(dyes.x, dyes.y), max(dyes.z, dyes.w)) >= 0.0, lent = whose.yzw != whose.xxx;
  for (int once = 0; once < loose; once++) {
    group = at.x > 0.5 ? 7 : 9;
    found = textureGrad(shells, vec3(at, float(whose.x)), dx, dy);
  }
  for (int once = loose; once < 1; once++)
    found = vec4(textureGrad(atlases, vec3(at, float(whose.x)), dx, dy).rgb, 1.0);
  for (int once = loose; once < (dyedToo || lent ? 1 : 0); once++) {
    ivec2 texel = ivec2(at * vec2(textureSize(atlases, 0).xy)), own = groupAt(whose.x, texel);
    group = own.x;
    for (int k = 0; k < (lent ? 3 : 0); k++) {
      int donor = k == 0 ? whose.y : k == 1 ? whose.z : whose.w;
      if (donor == whose.x) continue;
      if (groupAt(donor, texel).x == 6 + k) {
        found.rgb = textureGrad(atlases, vec3(at, float(donor)), dx, dy).rgb;
        group = 6 + k;
        owner = donor;
        break;
      }
      if (own.x == 6 + k && own.y > 0) {  // bare now: the wearer's own skin, of arms above and legs below
        found.rgb = cloneTexel(whose.x, SKIN + (k == 0 ? 1 : 2)).rgb;
        group = k == 0 ? 3 : 5;
      }
    }
  }
  return found;
}

vec3 finished(vec3 rgb, int group, int owner) {
  float dye = group == 6 ? dyes.x : group == 7 ? dyes.y : group == 8 ? dyes.z : group == 9 ? dyes.w : -1.0;
  for (int once = 0; once < (dye < 0.0 ? 0 : 1); once++)
    rgb = dyed(rgb, cloneTexel(owner, LOOKS + group - 6), unpacked(dye));
  return rgb;
}
