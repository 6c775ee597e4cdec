"use strict";
// The pack that lies in this page, as textures and meshes; nothing is fetched.

const HEADER = ["float", "int", "sampler2D", "sampler2DArray", "usampler2DArray", "isampler2D"]
  .map((type) => `precision highp ${type};`).join("\n") + "\n";
const WIDE = 128, CORNERS_WIDE = 256, ROW = 256;

const held = new Map([...document.querySelectorAll("script[data-file]")].map((one) => [one.dataset.file, one]));

function bytesOf(name) {
  const element = held.get(name), text = atob(element.textContent);
  element.remove();
  held.delete(name);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  return bytes;
}

const TYPES = {
  uint8: Uint8Array, uint16: Uint16Array, int16: Int16Array, uint32: Uint32Array, int32: Int32Array, float32: Float32Array, float64: Float64Array,
};

async function arraysOf(bytes, told) {
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const buffer = await new Response(plain).arrayBuffer(), found = {};
  for (const [name, one] of Object.entries(told)) {
    const count = one.shape.reduce((a, b) => a * b, 1);
    found[name] = new TYPES[one.type](buffer, one.at, count);
  }
  return found;
}

async function pixelsIn(bytes) {
  const blob = new Blob([bytes], { type: "image/webp" });
  const image = await createImageBitmap(blob, { colorSpaceConversion: "none" });
  const canvas = document.createElement("canvas");
  canvas.width = image.width;
  canvas.height = image.height;
  const pen = canvas.getContext("2d", { willReadFrequently: true });
  pen.drawImage(image, 0, 0);
  image.close();
  return pen.getImageData(0, 0, canvas.width, canvas.height);
}

const pixelsOf = (name) => pixelsIn(bytesOf(name));

function arrayTexture(data, width, height, layers, options = {}) {
  const texture = new THREE.DataArrayTexture(data, width, height, layers);
  Object.assign(texture, {
    magFilter: THREE.NearestFilter, minFilter: THREE.NearestFilter, generateMipmaps: false, unpackAlignment: 1,
    needsUpdate: true, ...options,
  });
  return texture;
}

function flatTexture(data, width, height, options) {
  const texture = new THREE.DataTexture(data, width, height);
  Object.assign(texture, {
    magFilter: THREE.NearestFilter, minFilter: THREE.NearestFilter, unpackAlignment: 1, needsUpdate: true, ...options,
  });
  return texture;
}

const SMOOTH = { magFilter: THREE.LinearFilter, minFilter: THREE.LinearFilter };
const MIPPED = { magFilter: THREE.LinearFilter, minFilter: THREE.LinearMipmapLinearFilter, generateMipmaps: true };
const WHOLE = { format: THREE.RGBAIntegerFormat, type: THREE.UnsignedShortType, internalFormat: "RGBA16UI" };
const FLOATS = { format: THREE.RGBAFormat, type: THREE.FloatType };

// One layer a clone of rows of texels; shorter ones end in zeros.
function layered(lists, parts, wide, Type) {
  const rows = Math.max(1, ...lists.map((one) => Math.ceil(one.length / parts / wide)));
  const data = new Type(lists.length * rows * wide * parts);
  lists.forEach((one, k) => data.set(one, k * rows * wide * parts));
  return [data, wide, rows, lists.length];
}

// Pictures one behind another, each as {data, width, height}, shorter ones with zeros below.
function piled(pictures) {
  const height = Math.max(...pictures.map((one) => one.height)), width = pictures[0].width;
  const data = new Uint8Array(pictures.length * height * width * 4);
  pictures.forEach((one, k) => data.set(one.data, k * height * width * 4));
  return [data, width, height, pictures.length];
}

const AT_ONCE = 4; // clones that are read at a time: pictures are decoded beside one another, few lie in memory

async function readAll(rows, read) {
  const found = new Array(rows.length);
  let next = 0;
  const some = async () => { while (next < rows.length) { const k = next++; found[k] = await read(rows[k], k); } };
  await Promise.all(Array.from({ length: AT_ONCE }, some));
  return found;
}

const picturesOf = (row, ...names) => Promise.all(names.map((name) => pixelsOf(`people/${row.id}/${name}.webp`)));

// All that is seen from near; `far` reads the rest, and gives its textures.
async function loadStage(facts, told) {
  const body = await arraysOf(bytesOf("body.bin"), facts.body_arrays);
  let done = 0;
  const people = await readAll(facts.people, async (row) => {
    const numbers = await arraysOf(bytesOf(`people/${row.id}/numbers.bin`), row.arrays);
    const face = facts.faces ? (await arraysOf(bytesOf(`people/${row.id}/face.bin`), row.face)).moves : null;
    const looks = looksOf(...await picturesOf(row, "atlas", "codes", "shell"));
    const [stone, stoneShell] = facts.statues ? await picturesOf(row, "stone", "stone_shell") : [];
    told(++done, facts.people.length);
    return { row, numbers, face, ...looks, stone, stoneShell };
  });
  const none = { width: 1, height: 1, data: new Uint8Array(4) }, textures = { ...bodyTextures(people), ...farTextures([none], [none]) };
  for (const [name, key] of [["stones", "stone"], ["stoneShells", "stoneShell"]])
    textures[name] = arrayTexture(...piled(people.map((one) => one[key] || none)), facts.statues ? MIPPED : {});
  for (const one of people) {
    one.stone = one.stoneShell = null;
    if (!facts.live) one.numbers = one.atlas = one.shell = null; // nobody comes: all of it is in textures
  }
  const far = async () => {
    const found = await readAll(facts.people, async (row) => farOf(...await picturesOf(row, "colours", "shapes", "covers")));
    return farTextures(found.map((one) => one.colours), found.map((one) => one.shapes));
  };
  return { body, people, textures, far };
}

// Everybody's shape, motion and look: made anew when somebody comes or goes.
function bodyTextures(people) {
  const of = (name) => people.map((one) => one.numbers[name]);
  const bones = of("bones"), joints = people.map((one) => one.row.arrays.bones.shape[1]);
  const frames = bones.map((one, k) => one.length / (joints[k] * 12)), most = Math.max(...joints);
  const allBones = new Int16Array(frames.reduce((sum, one) => sum + one, 0) * most * 12);
  const tables = of("table"), columns = tables[0].length / 4, table = new Float32Array(people.length * columns * 4);
  let at = 0, first = 0;
  tables.forEach((one, k) => {
    const own = joints[k] * 12;  // who wears simulated cloth has more bones
    for (let f = 0; f < frames[k]; f++, at += most * 12) allBones.set(bones[k].subarray(f * own, (f + 1) * own), at);
    table.set(one, k * columns * 4);
    const clips = facts.people[0].clips.length, place = k * columns * 4;
    for (let c = 1; c <= clips; c++) table[place + 4 * c] += first - one[4]; // frames lie after those of who is before
    first += frames[k];
  });
  const tiles = of("tiles"), tileWide = Math.max(...tiles.map((one) => one.length / 4));
  const allTiles = new Float32Array(people.length * tileWide * 4);
  tiles.forEach((one, k) => allTiles.set(one, k * tileWide * 4));
  const textures = {
    vertices: arrayTexture(...layered(of("vertices"), 4, WIDE, Uint16Array), WHOLE),
    loose: arrayTexture(...layered(of("loose"), 4, 2 * WIDE, Uint16Array), WHOLE),
    corners: arrayTexture(...layered(of("corners"), 1, CORNERS_WIDE, Uint16Array),
      { format: THREE.RedIntegerFormat, type: THREE.UnsignedShortType, internalFormat: "R16UI" }),
    bones: flatTexture(allBones, most * 3, first,
      { format: THREE.RGBAIntegerFormat, type: THREE.ShortType, internalFormat: "RGBA16I" }),
    clones: flatTexture(table, columns, people.length, FLOATS),
    tiles: flatTexture(allTiles, tileWide, people.length, FLOATS),
    atlases: arrayTexture(...piled(people.map((one) => one.atlas)), MIPPED),
    shells: arrayTexture(...piled(people.map((one) => one.shell)), MIPPED),
  };
  return textures;
}

// What is seen of those who are far.
function farTextures(colours, shapes) {
  return { colours: arrayTexture(...piled(colours), MIPPED), shapes: arrayTexture(...piled(shapes), SMOOTH) };
}

// Atlas with codes in alpha, and shell with the alpha that lies below it.
function looksOf(atlas, codes, shell) {
  for (let p = 3; p < atlas.data.length; p += 4) atlas.data[p] = codes.data[p - 3];
  const half = shell.data.length / 2, data = shell.data.slice(0, half);
  for (let p = 3; p < half; p += 4) data[p] = shell.data[half + p];
  return { atlas, shell: { data, width: shell.width, height: shell.height / 2 } };
}

// Impostors' colours with coverage, and their normals and depths with codes.
function farOf(colours, shapes, covers) {
  const below = colours.data.length / 3, parts = colours.data, seen = new Uint8ClampedArray(below);
  for (let p = 0; p < below; p += 4) { // luma and two differences of colour
    const y = parts[p], co = parts[below + p] - 128, cg = parts[2 * below + p] - 128;
    seen[p] = y - cg + co;
    seen[p + 1] = y + cg;
    seen[p + 2] = y - cg - co;
    seen[p + 3] = covers.data[p];
  }
  const { width } = shapes, rows = shapes.height / 3, plane = width * rows * 4, wide = covers.width * 4;
  const shaped = new Uint8Array(plane), fine = width === colours.width ? 1 : 0;  // codes are half as large
  for (let y = 0; y < rows; y++)
    for (let x = 0; x < width; x++) {
      const p = (y * width + x) * 4;
      for (let part = 0; part < 3; part++) shaped[p + part] = shapes.data[part * plane + p];
      shaped[p + 3] = covers.data[below + (y >> fine) * wide + (x >> fine) * 4];
    }
  return {
    colours: { data: seen, width: colours.width, height: colours.height / 3 }, shapes: { data: shaped, width, height: rows },
  };
}

// Attributes and indices of a level, as cloner/crowd/clones/stock.py makes them.
function levelGeometry(facts, body, level, instances) {
  const loose = facts.numbers.loose, all = body.uv.length / 2, own = facts.tiers[level].vertices;
  const most = facts.live ? facts.numbers.loose[level] : Math.max(...facts.people.map((row) => row.loose_triangles[level]));
  const corners = 3 * most, total = own + corners;
  const which = new Float32Array(total), uv = new Float32Array(total * 2);
  const joints = new Float32Array(total * 4), weights = new Float32Array(total * 4);
  for (let k = 0; k < own; k++) which[k] = k;
  for (let k = 0; k < corners; k++) which[own + k] = all + k;
  uv.set(body.uv.subarray(0, own * 2));
  joints.set(body.joints.subarray(0, own * 4));
  weights.set(body.weights.subarray(0, own * 4));
  // Bodies are closed: only their fronts are drawn. What is loose is there from both sides, once with every winding,
  // one behind the other: a processor that shades vertices then remembers them.
  const triangles = body[`level_${level}`], index = new Uint32Array(triangles.length + 2 * corners);
  index.set(triangles);
  for (let k = 0; k < corners; k++) {
    const at = triangles.length + 2 * k - (k % 3);
    index[at] = own + k;
    index[at + 3] = own + k - (k % 3) + [0, 2, 1][k % 3];
  }
  const geometry = new THREE.InstancedBufferGeometry();
  const add = (name, values, parts) => geometry.setAttribute(name, new THREE.BufferAttribute(values, parts));
  add("which", which, 1);
  geometry.setAttribute("position", geometry.attributes.which); // three draws no wires of what has no positions
  geometry.boundingSphere = { center: new THREE.Vector3(), radius: 1 }; // nobody is left out by it: shaders place people
  add("uv", uv, 2);
  add("joints", joints, 4);
  add("weights", weights, 4);
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  geometry.setAttribute("instance", instances);
  geometry.instanceCount = 0;
  return { geometry, start: 3 * loose.slice(0, level).reduce((a, b) => a + b, 0), triangles: (triangles.length + corners) / 3 };
}

function quadGeometry(instances) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("corner", new THREE.BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 1, 1]), 2));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.setAttribute("instance", instances);
  geometry.instanceCount = 0;
  return geometry;
}

function materialOf(shaders, vertex, fragment, uniforms, options = {}) {
  const text = (names) => HEADER + (facts.room ? "" : "#define NO_ROOM\n") + (state.blocks ? "#define CODES_APART\n" : "") + (facts.acted ? "" : "#define NO_ACTORS\n") + names.map((name) => shaders[name]).join("\n");
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3, vertexShader: text(vertex), fragmentShader: text(fragment), uniforms,
    side: THREE.DoubleSide, ...options,
  });
}
