// One person as a quad that faces the eye, with the tiles of the two nearest baked views.
in vec2 corner;    // 0..1
in vec2 instance;  // who, fade

uniform sampler2D tiles;          // two texels a tile, a row a clone: place and size in the page; its middle
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform float focalPx;
uniform int rings;
uniform vec4 ringElevations;      // radians
uniform float dearFromPx;         // taller people get two views and the full search of depth

out vec2 plane;                   // metres on the plane through the person's middle
flat out vec4 tileA, tileB;
flat out vec4 middles;            // of both tiles
flat out vec2 sides;              // 1, or -1 for a tile that is shown mirrored
flat out vec4 turns;              // sine and cosine of the azimuth off each baked view
flat out vec4 lifts;              // of the eye's elevation and of the baked one
flat out vec4 ways;               // of the headings of the baked cameras, for light
flat out vec4 sizes;              // texels a metre; distance in metres of the person's own size; share of B; level of the page
flat out vec2 fades;
flat out ivec4 marks;             // who it is; page; near enough for two views; whether anything is dyed or exchanged
flat out ivec4 whose;
flat out vec4 dyes;
flat out vec4 seat;               // where its middle is; how much of it is stone

const int FRONT = 0, ALL = 1, LEFT = 2;  // which views are baked: see Baked in cloner/crowd/clones/stock.py

// Where a view's tiles lie among those of its ring, and -1 where they are shown mirrored.
ivec2 slotOf(int view, int views, int baked) {
  int v = view < 0 ? view + views : view >= views ? view - views : view;  // % is for whole positives
  if (baked == ALL) return ivec2(v, 1);
  if (baked == LEFT) return 2 * v > views ? ivec2(views - v, -1) : ivec2(v, 1);
  int front = views / 4;
  v = clamp(view, -front, front);
  return ivec2(v >= 0 ? v : v + 2 * front + 1, 1);
}

void main() {
  Person p = personOf(int(instance.x + 0.5), true);
  vec4 facts = cloneTexel(p.clone, 0);                 // middle's height, texels a metre, views, -
  vec4 set = cloneTexel(p.clone, SETS + p.clip);       // first tile, poses, which views are baked, coarse poses
  vec3 middle = p.place + vec3(0.0, facts.x * p.scale, 0.0);
  vec3 to = eye - middle;
  float c = cos(p.heading), s = sin(p.heading);
  vec2 turned = vec2(to.x * c - to.z * s, to.x * s + to.z * c);
  float azimuth = atan(turned.x, turned.y), elevation = atan(to.y, length(to.xz));
  int ring = 0;
  for (int k = 1; k < rings; k++)
    if (abs(elevation - ringElevations[k]) < abs(elevation - ringElevations[ring])) ring = k;
  int views = int(facts.z + 0.5);
  float stepAngle = 2.0 * PI / float(views);
  float at = azimuth / stepAngle;
  int first = int(floor(at)), other = first + 1;
  float share = at - float(first);
  if (share > 0.5) { int swap = first; first = other; other = swap; share = 1.0 - share; }
  int poses = int(set.y + 0.5);
  int pose = p.frame * poses / p.frames;
  int baked = int(set.z + 0.5), perRing = baked == ALL ? views : baked == LEFT ? views / 2 + 1 : 2 * (views / 4) + 1;
  int base = int(set.x + 0.5) + ring * perRing * poses;
  int later = pose + poses / 2 < poses ? pose + poses / 2 : pose + poses / 2 - poses;
  ivec2 slotA = slotOf(first, views, baked), slotB = slotOf(other, views, baked);
  int a = base + slotA.x * poses + (slotA.y > 0 ? pose : later), b = base + slotB.x * poses + (slotB.y > 0 ? pose : later);
  sides = vec2(slotA.y, slotB.y);
  tileA = texelFetch(tiles, ivec2(2 * a, p.clone), 0);
  tileB = texelFetch(tiles, ivec2(2 * b, p.clone), 0);
  middles = vec4(texelFetch(tiles, ivec2(2 * a + 1, p.clone), 0).xy, texelFetch(tiles, ivec2(2 * b + 1, p.clone), 0).xy);
  float dA = azimuth - float(first) * stepAngle, dB = azimuth - float(other) * stepAngle, low = ringElevations[ring];
  turns = vec4(sin(dA), cos(dA), sin(dB), cos(dB));
  lifts = vec4(sin(elevation), cos(elevation), sin(low), cos(low));
  float wayA = p.heading + float(first) * stepAngle, wayB = p.heading + float(other) * stepAngle;
  ways = vec4(sin(wayA), cos(wayA), sin(wayB), cos(wayB));
  vec2 rights = vec2(tileA.z, tileB.z) - middles.xz;
  vec2 lefts = mix(rights, middles.xz, greaterThan(sides, vec2(0.0)));
  rights = vec2(tileA.z, tileB.z) - lefts;
  vec4 reach = vec4(max(lefts.x, lefts.y), max(rights.x, rights.y),
                    max(middles.y, middles.w), max(tileA.w - middles.y, tileB.w - middles.w)) / facts.y;
  plane = vec2(mix(-reach.x, reach.y, corner.x), mix(-reach.w, reach.z, corner.y));
  float away = length(to);
  vec3 back = to / away;
  vec3 right = normalize(vec3(back.z, 0.0, -back.x));
  vec3 world = middle + p.scale * (plane.x * right + plane.y * cross(back, right));
  gl_Position = clipFromWorld * vec4(world, 1.0);
  float pxPerM = focalPx * p.scale / away;
  bool near = pxPerM * 1.7 > dearFromPx;
  sizes = vec4(facts.y, away / p.scale, near ? share : 0.0, clamp(log2(facts.y / pxPerM) - 0.7, 0.0, 2.0));  // bias measured: .7
  bool own = p.donors == ivec3(p.clone) && max(max(p.dyes.x, p.dyes.y), max(p.dyes.z, p.dyes.w)) < 0.0;
  marks = ivec4(int(instance.x + 0.5), p.clone, near ? 1 : 0, own ? 0 : 1);
  fades = vec2(instance.y, p.shown);
  whose = ivec4(p.clone, p.donors);
  dyes = p.dyes;
  seat = vec4(middle, p.stone);
}
