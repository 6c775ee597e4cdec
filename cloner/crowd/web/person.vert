// One person as geometry: a level's body vertices by their own attributes, loose shells by their corners.
in float which;
in vec2 uv;
in vec4 joints;
in vec4 weights;
in vec2 instance;  // who, fade

uniform highp usampler2DArray vertices;  // a layer a clone: place in the box, normal as an octahedron's point
uniform highp usampler2DArray loose;     // two texels a loose vertex: uv, joints; weights
uniform highp usampler2DArray corners;   // loose vertices of the levels' triangles, in line
uniform highp isampler2D bones;          // three texels a joint, a row a frame
uniform int bodyVertices;
uniform int looseStart;
uniform mat4 clipFromWorld;
uniform vec3 boxMin;
uniform float boxStep;
uniform float boneReach;
uniform int coarse;  // 1: only the poses that impostors have, so that nothing jumps at the switch

out vec3 normal;
out vec3 world;
out vec2 at;
flat out float isLoose;
flat out ivec4 whose;  // wearer, and whose top, bottom, shoes
flat out vec4 dyes;
flat out vec2 fades;
flat out int wearer;  // who it is
#ifndef NO_ACTORS
uniform highp isampler2DArray faces;  // a layer a clone: how each target moves a face's vertices, micrometres
uniform highp usampler2D faceRows;    // where a vertex lies there, from 1; 0: no face moves it
uniform int faceHigh;                 // rows of a target
uniform sampler2D feels;              // of each person: which feeling its face shows, 0 none, and how strongly
uniform int faced;                    // 1: faces show feelings
uniform int speakers;                 // how many speak now
uniform int speaks[8];                // who
uniform vec4 mouths[40];              // the weights of the targets of each
out float headness;    // 1 on the head
out vec3 rested;       // place in the rest pose, shares of the stature
flat out float stone;
flat out float partial;
#endif

const int SPOKEN = 20;       // targets of speech; those of feelings follow
const float SPEAKING = 0.5;  // taste
const int HEAD_FIRST = 35, HEAD_LAST = 45;  // joints of the head and the upper neck
const float HEAD_MIDDLE = 1.86;             // in halves of the stature

vec3 fromOctahedron(uint code) {
  vec2 f = vec2(float(code & 255u), float(code >> 8)) / 127.5 - 1.0;
  vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
  float under = max(-n.z, 0.0);
  n.xy -= vec2(n.x >= 0.0 ? under : -under, n.y >= 0.0 ? under : -under);
  return normalize(n);
}

// A line of a vertex' four joints, blended. In line: software rasterisers need 1.6 times as long for a loop.
vec4 boneLine(ivec4 at, vec4 share, int row) {
  vec4 sum = share.x * vec4(texelFetch(bones, ivec2(at.x, row), 0)) + share.y * vec4(texelFetch(bones, ivec2(at.y, row), 0))
    + share.z * vec4(texelFetch(bones, ivec2(at.z, row), 0)) + share.w * vec4(texelFetch(bones, ivec2(at.w, row), 0));
  return sum * vec4(1.0, 1.0, 1.0, boneReach) / 32767.0;
}

#ifndef NO_ACTORS
vec3 target(int t, int at, int clone) { return vec3(texelFetch(faces, ivec3(at & 127, t * faceHigh + (at >> 7), clone), 0).xyz); }

// How far a face that speaks or feels moves a vertex, metres; who speaks has less of the feeling.
vec3 moved(int who, int clone, int v) {
  int at = int(texelFetch(faceRows, ivec2(v & 127, v >> 7), 0).r) - 1;
  if (at < 0) return vec3(0.0);
  vec3 sum = vec3(0.0);
  vec2 felt = faced > 0 ? texelFetch(feels, ivec2(who & 255, who >> 8), 0).xy : vec2(0.0);
  for (int k = 0; k < speakers; k++) {
    if (speaks[k] != who) continue;
    felt.y *= SPEAKING;
    for (int t = 0; t < SPOKEN; t++) {
      float share = mouths[5 * k + (t >> 2)][t & 3];
      if (share > 0.0) sum += share * target(t, at, clone);
    }
  }
  if (felt.x > 0.5) sum += felt.y * target(SPOKEN + int(felt.x + 0.5) - 1, at, clone);
  return 1e-6 * sum;
}
#endif

void main() {
  Person p = personOf(int(instance.x + 0.5), coarse > 0);
  int v = int(which + 0.5);
  vec4 j = joints, w = weights;
  at = uv;
  isLoose = 0.0;
  if (v >= bodyVertices) {
    int corner = v - bodyVertices + looseStart;
    int row = int(texelFetch(corners, ivec3(corner & 255, corner >> 8, p.clone), 0).r);
    uvec4 a = texelFetch(loose, ivec3((row & 127) * 2, row >> 7, p.clone), 0);
    uvec4 b = texelFetch(loose, ivec3((row & 127) * 2 + 1, row >> 7, p.clone), 0);
    at = vec2(a.xy) / 65535.0;
    j = vec4(float(a.z & 255u), float(a.z >> 8), float(a.w & 255u), float(a.w >> 8));
    w = vec4(float(b.x & 255u), float(b.x >> 8), float(b.y & 255u), float(b.y >> 8)) / 255.0;
    v = bodyVertices + row;
    isLoose = 1.0;
  }
  uvec4 q = texelFetch(vertices, ivec3(v & 127, v >> 7, p.clone), 0);
  vec4 rest = vec4(boxMin + vec3(q.xyz) * boxStep, 1.0);
  vec3 n = fromOctahedron(q.w);
#ifndef NO_ACTORS
  if (faced + speakers > 0 && v < bodyVertices) rest.xyz += moved(int(instance.x + 0.5), p.clone, v);
#endif
  int row = int(cloneTexel(p.clone, CLIPS + p.clip).x + 0.5) + p.frame;
  ivec4 first = 3 * ivec4(j + 0.5);
  vec4 r0 = boneLine(first, w, row), r1 = boneLine(first + 1, w, row), r2 = boneLine(first + 2, w, row);
#ifndef NO_ACTORS
  if (p.share > 0.0) {
    int second = int(cloneTexel(p.clone, CLIPS + p.other).x + 0.5) + p.second;
    r0 = mix(r0, boneLine(first, w, second), p.share);
    r1 = mix(r1, boneLine(first + 1, w, second), p.share);
    r2 = mix(r2, boneLine(first + 2, w, second), p.share);
  }
  headness = dot(w, vec4(greaterThanEqual(j, vec4(HEAD_FIRST))) * vec4(lessThanEqual(j, vec4(HEAD_LAST))));
#endif
  vec3 own = vec3(dot(r0, rest), dot(r1, rest), dot(r2, rest)) * p.scale;
  n = vec3(dot(r0.xyz, n), dot(r1.xyz, n), dot(r2.xyz, n));
#ifndef NO_ACTORS
  if (p.part > 1.5) {  // a head on its own leans to its side
    vec3 middle = vec3(0.0, HEAD_MIDDLE * cloneTexel(p.clone, 0).x * p.scale, 0.0);
    float lean = 2.0 * PI * (p.part - 2.0), cl = cos(lean), sl = sin(lean);
    own = own - middle;
    own = middle + vec3(cl * own.x - sl * own.y, sl * own.x + cl * own.y, own.z);
    n = vec3(cl * n.x - sl * n.y, sl * n.x + cl * n.y, n.z);
  }
  rested = rest.xyz / (2.0 * cloneTexel(p.clone, 0).x);
  stone = p.stone;
  partial = p.part;
#endif
  float c = cos(p.heading), s = sin(p.heading);
  world = p.place + vec3(c * own.x + s * own.z, own.y, c * own.z - s * own.x);
  normal = vec3(c * n.x + s * n.z, n.y, c * n.z - s * n.x);
  whose = ivec4(p.clone, p.donors);
  dyes = p.dyes;
  fades = vec2(instance.y, p.shown);
  wearer = int(instance.x + 0.5);
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
