"use strict";
// A lit room: its mesh, and how its probes light people.

const CHEST_M = 1.1;

async function loadRoom(told, shaders, uniforms) {
  const held = await arraysOf(bytesOf("room.bin"), told.arrays), corners = held.corners;
  const [looks, map, sun] = await Promise.all(["room_looks.webp", "room_light.webp", "room_sun.webp"].map(pixelsOf));
  const geometry = new THREE.InstancedBufferGeometry(), count = corners.length / 8;
  const add = (name, first, parts) => {
    const values = new Float32Array(count * parts);
    for (let k = 0; k < count; k++) values.set(corners.subarray(8 * k + first, 8 * k + first + parts), k * parts);
    geometry.setAttribute(name, new THREE.BufferAttribute(values, parts));
  };
  add("position", 0, 3);
  add("uv", 3, 2);
  add("lightUv", 5, 2);
  add("look", 7, 1);
  geometry.instanceCount = 1;
  const again = { wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, anisotropy: 8 };
  const own = {
    ...uniforms, brightest: { value: told.brightest },
    roomLooks: { value: arrayTexture(new Uint8Array(looks.data), looks.width, looks.width, looks.height / looks.width, { ...MIPPED, ...again }) },
    roomLight: { value: flatTexture(new Uint8Array(map.data), map.width, map.height, SMOOTH) },
    roomSun: { value: flatTexture(new Uint8Array(sun.data), sun.width, sun.height, SMOOTH) },
  };
  const mesh = new THREE.Mesh(geometry, materialOf(shaders, ["room.vert"], ["light.glsl", "room.frag"], own, { side: THREE.FrontSide }));
  mesh.frustumCulled = false;
  const outside = uniforms.sunWay.value.clone(), [levels, deep, wide] = told.shape, [x0, , z0] = told.low;
  const heights = told.heights, grid = deep * wide;
  const [rows, columns] = told.arrays.walkable.shape, [gx, gz] = told.ground_low;
  let data = null;

  function free(px, pz) {
    const c = Math.floor((px - gx) / told.ground_step), r = Math.floor((pz - gz) / told.ground_step);
    return c >= 0 && r >= 0 && c < columns && r < rows && held.walkable[r * columns + c] > 0;
  }

  // Sixteen numbers into a list: the light straight between the eight probes around the chest of somebody who stands so high.
  function lightInto(list, to, px, pz, high = 0) {
    const chest = CHEST_M + high;
    let h = 0;
    while (h + 2 < levels && heights[h + 1] < chest) h++;
    const up = levels > 1 ? Math.min(Math.max((chest - heights[h]) / (heights[h + 1] - heights[h]), 0), 1) : 0;
    const x = Math.min(Math.max((px - x0) / told.step, 0), wide - 1), z = Math.min(Math.max((pz - z0) / told.step, 0), deep - 1);
    const ix = Math.min(Math.floor(x), Math.max(wide - 2, 0)), iz = Math.min(Math.floor(z), Math.max(deep - 2, 0));
    list.fill(0, to, to + 16);
    for (let k = 0; k < 8; k++) {
      const right = k & 1, back = (k >> 1) & 1, over = k >> 2;
      const weight = (right ? x - ix : 1 - x + ix) * (back ? z - iz : 1 - z + iz) * (over ? up : 1 - up);
      if (weight <= 0) continue;
      const probe = Math.min(h + over, levels - 1) * grid + Math.min(iz + back, deep - 1) * wide + Math.min(ix + right, wide - 1);
      for (let c = 0; c < 12; c++) list[to + c] += weight * held.probes[12 * probe + c];
      list[to + 12] += weight * held.sun[probe];
    }
    return list;
  }
  const asked = new Float64Array(16), lightAt = (x, z) => lightInto(asked, 0, x, z);
  return {
    mesh, told, sunny: told.sun_light.some((one) => one > 0),
    // Whether one could walk straight from one place to another.
    open(x, z, to_x, to_z) {
      const steps = Math.max(1, Math.ceil(Math.hypot(to_x - x, to_z - z) / told.ground_step));
      for (let k = 0; k <= steps; k++) if (!free(x + ((to_x - x) * k) / steps, z + ((to_z - z) * k) / steps)) return false;
      return true;
    },
    // Where somebody gets who wants to go from one place to another: along walls, not through them.
    walk(x, z, wanted_x, wanted_z) {
      if (!free(x, z)) {  // who comes from the air goes to the nearest floor
        let best = Infinity, found = [x, z];
        for (let k = 0; k < held.walkable.length; k++) {
          if (!held.walkable[k]) continue;
          const px = gx + ((k % columns) + 0.5) * told.ground_step, pz = gz + (Math.floor(k / columns) + 0.5) * told.ground_step;
          const far = (px - x) ** 2 + (pz - z) ** 2;
          if (far < best) { best = far; found = [px, pz]; }
        }
        return found;
      }
      const steps = Math.max(1, Math.ceil(Math.hypot(wanted_x - x, wanted_z - z) / (0.5 * told.ground_step)));
      const dx = (wanted_x - x) / steps, dz = (wanted_z - z) / steps;
      for (let k = 0; k < steps; k++) {
        if (free(x + dx, z + dz)) { x += dx; z += dz; }
        else if (free(x + dx, z)) x += dx;
        else if (free(x, z + dz)) z += dz;
        else break;
      }
      return [x, z];
    },
    // The uniforms of this eye and hour.
    see(eye, ahead, right, up_, hour) {
      uniforms.daylight.value.set(...hour.daylight);
      uniforms.starry.value = hour.stars;
      uniforms.lantern.value = hour.lantern;
      uniforms.lanternLight.value.set(...hour.lantern_light);
      uniforms.exposure.value.set(...exposureOf(lightAt, told, eye, ahead, hour));
      uniforms.skyAhead.value.copy(ahead);
      uniforms.skyRight.value.copy(right);
      uniforms.skyUp.value.copy(up_);
      uniforms.shadowed.value = this.sunny ? 1 : 0;
      if (this.sunny) uniforms.shadowFromWorld.value.set(...sunClip(told, eye, ahead));
    },
    // Show the room or not, and make place for the light of so many people.
    enter(inside, people) {
      mesh.visible = inside;
      if (!inside) uniforms.shadowed.value = 0;
      uniforms.roomed.value = inside ? 1 : 0;
      if (inside) uniforms.sunWay.value.set(...told.sun_way);
      else uniforms.sunWay.value.copy(outside);
      uniforms.sunLight.value.set(...told.sun_light);
      uniforms.skyLight.value.set(...told.sky_light);
      uniforms.groundColour.value.set(...told.ground);
      const rows = Math.ceil(people / ROW);
      data = new Float32Array(rows * ROW * 16);
      uniforms.glow.value.dispose();
      uniforms.glow.value = flatTexture(data, ROW * 4, rows, FLOATS);
    },
    // Everybody's light: straight between the eight probes around the chest.
    light(people, count) {
      for (let i = 0; i < count; i++) {
        const from = i * 4 * PERSON_TEXELS;
        lightInto(data, 16 * i, people[from + 1], people[from + 2], people[from + UP]);
      }
      uniforms.glow.value.needsUpdate = true;
    },
  };
}
