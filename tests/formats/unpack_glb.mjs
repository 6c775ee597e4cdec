// Writes a GLB whose views are unpacked by three.js's own meshopt decoder: node unpack_glb.mjs MODULE_FOLDER FILE OUT
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, file, out] = process.argv.slice(2);
const decoder = join(folder, "node_modules/three/examples/jsm/libs/meshopt_decoder.module.js");
const { MeshoptDecoder } = await import(pathToFileURL(decoder).href);
await MeshoptDecoder.ready;
const bytes = readFileSync(file);
const length = bytes.readUInt32LE(12);
const gltf = JSON.parse(bytes.subarray(20, 20 + length).toString());
const blob = bytes.subarray(28 + length);
const chunks = [];
let at = 0;
for (const view of gltf.bufferViews) {
  const packed = view.extensions?.EXT_meshopt_compression;
  let data = blob.subarray(view.byteOffset ?? 0, (view.byteOffset ?? 0) + view.byteLength);
  if (packed) {
    const source = blob.subarray(packed.byteOffset, packed.byteOffset + packed.byteLength);
    data = new Uint8Array(packed.count * packed.byteStride);
    if (data.length !== view.byteLength) throw new Error("a view's length is not its elements'");
    MeshoptDecoder.decodeGltfBuffer(data, packed.count, packed.byteStride, source, packed.mode, packed.filter ?? "NONE");
    delete view.extensions;
  }
  view.buffer = 0;
  view.byteOffset = at;
  chunks.push(data, Buffer.alloc((4 - (data.length % 4)) % 4));
  at += data.length + chunks.at(-1).length;
}
gltf.buffers = [{ byteLength: at }];
const name = "EXT_meshopt_compression";
for (const key of ["extensionsUsed", "extensionsRequired"]) gltf[key] = gltf[key].filter((one) => one !== name);
let text = JSON.stringify(gltf);
text += " ".repeat((4 - (Buffer.byteLength(text) % 4)) % 4);
const json = Buffer.from(text);
const head = Buffer.alloc(20);
head.write("glTF", 0);
head.writeUInt32LE(2, 4);
head.writeUInt32LE(28 + json.length + at, 8);
head.writeUInt32LE(json.length, 12);
head.write("JSON", 16);
const second = Buffer.alloc(8);
second.writeUInt32LE(at, 0);
second.writeUInt32LE(0x004e4942, 4);
writeFileSync(out, Buffer.concat([head, json, second, ...chunks]));
