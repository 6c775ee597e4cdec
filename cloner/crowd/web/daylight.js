"use strict";
// What a room's light asks of who draws it: the same as cloner/crowd/staged/daylight.py, number for number; and the passes that
// draw the sky and what people leave of the sun.

const LUMA = [0.2126, 0.7152, 0.0722], KEY = 0.85, ADAPTS = 0.8, ADAPTS_TO_NIGHT = 0.35, ADAPTS_TO_COLOUR = 0.5;
const AHEAD_M = [0, 1.5, 3], DARKEST = 0.02, CAST_M = 9, CAST_AHEAD_M = 6, CAST_PX = 1536, CAST_DEEP_M = 40, CAST_LEVEL = 2;
const DAY = { daylight: [1, 1, 1], stars: 0, stops: 0, lantern: [0, 0, 0, 0], lantern_light: [0, 0, 0] };

const luma = (c) => LUMA[0] * c[0] + LUMA[1] * c[1] + LUMA[2] * c[2];

// Uniforms of everything that is drawn in a room, as where there is none.
function lightUniforms() {
  return {
    roomed: { value: 0 }, sunLight: { value: new THREE.Vector3() }, skyLight: { value: new THREE.Vector3() },
    groundColour: { value: new THREE.Vector3() }, daylight: { value: new THREE.Vector3(1, 1, 1) },
    exposure: { value: new THREE.Vector3(1, 1, 1) }, shadowed: { value: 0 },
    shadowFromWorld: { value: new THREE.Matrix4() }, shadows: { value: flatTexture(new Float32Array(4), 1, 1, FLOATS) },
    lantern: { value: [0, 0, 0, 0] }, lanternLight: { value: new THREE.Vector3() }, starry: { value: 0 },
    stoneColour: { value: new THREE.Vector3(1, 1, 1) }, skyAhead: { value: new THREE.Vector3() },
    skyRight: { value: new THREE.Vector3() }, skyUp: { value: new THREE.Vector3() },
  };
}

function levelWay(ahead) {
  const long = Math.max(Math.hypot(ahead.x, ahead.z), 1e-6);
  return [ahead.x / long, ahead.z / long];
}

// Red, green and blue that light is multiplied by for an eye that looks ahead; `lightAt` gives 16 numbers at a place.
function exposureOf(lightAt, told, eye, ahead, hour) {
  const [wx, wz] = levelWay(ahead), logs = [0, 0, 0];
  for (const far of AHEAD_M) {
    const light = lightAt(eye.x + wx * far, eye.z + wz * far);
    for (let c = 0; c < 3; c++)
      logs[c] += Math.log(Math.max(light[4 * c] + 0.25 * light[12] * told.sun_light[c], DARKEST)) / AHEAD_M.length;
  }
  const colour = logs.map(Math.exp), level = luma(colour), day = Math.max(luma(hour.daylight), 1e-4);
  const gain = ((KEY / level) ** ADAPTS / day ** ADAPTS_TO_NIGHT) * 2 ** hour.stops;
  return colour.map((one) => gain * (level / one) ** ADAPTS_TO_COLOUR);
}

// Rows of the matrix to the clip space of the sun's picture.
function sunClip(told, eye, ahead) {
  const way = new THREE.Vector3(...told.sun_way);
  const right = new THREE.Vector3(...(Math.abs(way.z) < 0.9 ? [0, 0, 1] : [1, 0, 0])).cross(way).normalize();
  const up = way.clone().cross(right), [wx, wz] = levelWay(ahead), step = (2 * CAST_M) / CAST_PX;
  const middle = new THREE.Vector3(eye.x + wx * CAST_AHEAD_M, 0, eye.z + wz * CAST_AHEAD_M);
  const line = (axis) => [axis.x / CAST_M, axis.y / CAST_M, axis.z / CAST_M,
                          (-Math.floor(axis.dot(middle) / step) * step) / CAST_M];
  const deep = [-way.x / CAST_DEEP_M, -way.y / CAST_DEEP_M, -way.z / CAST_DEEP_M, way.dot(middle) / CAST_DEEP_M];
  return [...line(right), ...line(up), ...deep, 0, 0, 0, 1];
}

// The sky, and the sun's picture of people: what a lit room is drawn with besides its own triangles.
function lightPasses(facts, body, shaders, uniforms) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("corner", new THREE.BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]), 2));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.instanceCount = 1;
  const sky = new THREE.Mesh(geometry, materialOf(shaders, ["sky.vert"], ["light.glsl", "sky.frag"], uniforms, { depthWrite: false }));
  sky.frustumCulled = false;
  sky.renderOrder = -1;
  const target = new THREE.WebGLRenderTarget(CAST_PX, CAST_PX, { depthTexture: new THREE.DepthTexture(CAST_PX, CAST_PX) });
  const instances = new THREE.InstancedBufferAttribute(new Float32Array(2 * CAST_MOST), 2);
  instances.setUsage(35048); // dynamic
  const people = levelGeometry(facts, body, CAST_LEVEL, instances);
  const own = { ...uniforms, clipFromWorld: uniforms.shadowFromWorld, looseStart: { value: people.start }, coarse: { value: 0 } };
  const mesh = new THREE.Mesh(people.geometry, materialOf(shaders, ["common.glsl", "person.vert"], ["common.glsl", "cast.frag"], own));
  mesh.frustumCulled = false;
  const world = new THREE.Scene();
  world.add(mesh);
  return {
    sky,
    // Draw who stands near enough to throw a shadow into the picture.
    cast(renderer, camera, eye, ahead, { x, z, count, rows }) {
      const [wx, wz] = levelWay(ahead), mx = eye.x + wx * CAST_AHEAD_M, mz = eye.z + wz * CAST_AHEAD_M, reach = 2.2 * CAST_M;
      let found = 0;
      for (let i = 0; i < count && found < CAST_MOST; i++) {
        if (rows[i * 4 * PERSON_TEXELS] >= GONE || Math.abs(x[i] - mx) > reach || Math.abs(z[i] - mz) > reach) continue;
        instances.array[2 * found] = i;
        instances.array[2 * found++ + 1] = 1;
      }
      people.geometry.instanceCount = found;
      mesh.visible = found > 0;
      instances.clearUpdateRanges();
      instances.addUpdateRange(0, 2 * found);
      instances.needsUpdate = true;
      renderer.setRenderTarget(target);
      renderer.clear();
      renderer.render(world, camera);
      renderer.setRenderTarget(null);
      uniforms.shadows.value = target.depthTexture;
    },
  };
}
const CAST_MOST = 2000;
