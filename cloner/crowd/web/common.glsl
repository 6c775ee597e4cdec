// What every shader of the crowd knows: one person's place, pose and looks at a time. Frames: metres, Y up; heading 0
// faces +Z. The same text runs in the player (GLSL ES 3.00) and in the offscreen painter (GLSL 3.30).
uniform sampler2D people;    // PERSON texels a person, ROW persons a row
uniform sampler2D clones;    // one row a clone: see cloner/crowd/clones/stock.py
uniform float now;           // seconds
uniform float laneLength;    // metres

const int PERSON = 5;        // whole numbers are divided by shifts: software rasterisers divide one by one
const int CLIPS = 1, SETS = 25, LOOKS = 49, COLOURS = 53, SKIN = 58, REACH = 61, HUNG = 63;  // columns of the clones' table
const float PI = 3.14159265;
const float ZONE_STEP = 2.0, CODE_STEP = 3.0;  // levels between zones in codes, and between impostors' codes

struct Person {
  vec3 place; float heading;
  int clone; float scale; float shown;
  int clip; int frame; int frames;
  int other; int second; float share;  // the clip and frame that are blended in, and by how much
  ivec3 donors;   // whose top, bottom and shoes are worn
  vec4 dyes;      // top, bottom, shoes, hair: 0xRRGGBB or -1
  float stone;    // 1: made of stone, 0: come alive
  float part;     // 0: whole, 1: without the head, from 2: the head alone, leaned by the rest, in turns
};

vec4 personTexel(int who, int k) { return texelFetch(people, ivec2((who & 255) * PERSON + k, who >> 8), 0); }
vec4 cloneTexel(int clone, int k) { return texelFetch(clones, ivec2(k, clone), 0); }

// Between two poses a walker stays where the last pose stood, so that no foot slides: the ground moves by whole poses.
Person personOf(int who, bool coarse) {
  vec4 path = personTexel(who, 0), pace = personTexel(who, 1), worn = personTexel(who, 2), where = personTexel(who, 4);
  Person p;
  p.dyes = personTexel(who, 3);
  p.clone = int(pace.z + 0.5);
  p.scale = pace.w;
  p.donors = ivec3(worn.xyz + 0.5);
  p.clip = int(worn.w + 0.5);
  p.stone = 0.0;
  p.part = 0.0;
  p.shown = path.x > 3.5 ? 0.0 : 1.0;
  p.other = p.clip;
  p.share = 0.0;
  vec4 clip = cloneTexel(p.clone, CLIPS + p.clip);  // first row of bones, frames, seconds, metres a cycle
  float cycles = clip.w > 0.0 ? pace.x / (clip.w * p.scale) : 1.0 / clip.z;
  p.frames = int(clip.y + 0.5);
#ifndef NO_ACTORS
  if (path.x > 2.5) {         // by footings: see footing.js
    p.frame = int(pace.x + 0.5);
    p.place = vec3(path.y, where.z, path.z);
    p.stone = where.y;
    p.part = where.w;
    p.heading = path.w;
    p.other = int(where.x + 0.5) >> 10;
    p.second = int(where.x + 0.5) & 1023;
    p.share = pace.y;
    return p;
  }
#endif
  float turns = pace.y + cycles * now;
  float poses = coarse ? cloneTexel(p.clone, SETS + p.clip).w : clip.y;
  float posed = floor(turns * poses) / poses;
  p.frame = min(int(fract(posed + 0.25 / clip.y) * clip.y), p.frames - 1);
  float when = cycles > 0.0 && pace.x > 0.0 ? now - (turns - posed) / cycles : now;
  p.place = vec3(path.y, where.x, path.z);
  p.heading = path.w;
  if (path.x > 1.5) {         // a ring: radius, first angle, turning way
    float angle = path.z + path.w * pace.x * when / path.y;
    p.place = vec3(path.y * sin(angle), where.x, path.y * cos(angle));
    p.heading = angle + path.w * PI * 0.5;
  } else if (path.x > 0.5) {  // a lane along Z: x, start, way
    float along = mod(path.z + pace.x * when, laneLength);
    p.place = vec3(path.y, where.x, path.w * (along - 0.5 * laneLength));
    p.heading = path.w > 0.0 ? 0.0 : PI;
    p.shown = clamp(min(along, laneLength - along) / 2.0, 0.0, 1.0);
  }
  return p;
}

// Which half of somebody is not there.
bool leftOut(float headness, float part) { return part > 0.5 && (part < 1.5 ? headness > 0.5 : headness < 0.5); }

vec3 unpacked(float dye) {
  int whole = int(dye);  // whole already; half more would not fit a float
  return vec3(float(whole >> 16), float((whole >> 8) & 255), float(whole & 255)) / 255.0;
}
