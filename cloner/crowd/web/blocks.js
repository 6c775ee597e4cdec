"use strict";
// Textures in blocks of 4 x 4 texels (S3TC, whose patents have ended): a quarter of a card's memory, made as the page opens.

// Ends of the line along which a block's colours lie, and each texel's quarter of the way: 8 bytes at `to`.
function colourBlock(texels, out, to) {
  const low = [255, 255, 255], high = [0, 0, 0];
  for (let k = 0; k < 64; k += 4)
    for (let c = 0; c < 3; c++) {
      if (texels[k + c] < low[c]) low[c] = texels[k + c];
      if (texels[k + c] > high[c]) high[c] = texels[k + c];
    }
  const wide = [0, 1, 2].map((c) => high[c] - low[c]), main = wide.indexOf(Math.max(...wide));
  for (let c = 0; c < 3; c++) {
    let along = 0;
    for (let k = 0; k < 64; k += 4) along += (texels[k + c] - (low[c] + high[c]) / 2) * (texels[k + main] - (low[main] + high[main]) / 2);
    const inset = wide[c] / 16;
    low[c] += inset;
    high[c] -= inset;
    if (along < 0) [low[c], high[c]] = [high[c], low[c]];
  }
  const packed = (one) => (Math.round((one[0] * 31) / 255) << 11) | (Math.round((one[1] * 63) / 255) << 5) | Math.round((one[2] * 31) / 255);
  let first = packed(high), second = packed(low), from = high, way = low;
  if (first < second) [first, second, from, way] = [second, first, way, from];
  const line = [0, 1, 2].map((c) => way[c] - from[c]), long = line[0] ** 2 + line[1] ** 2 + line[2] ** 2;
  let marks = 0;
  for (let k = 15; k >= 0 && first !== second && long > 0; k--) {
    const at = 4 * k, share = ((texels[at] - from[0]) * line[0] + (texels[at + 1] - from[1]) * line[1] + (texels[at + 2] - from[2]) * line[2]) / long;
    marks = marks * 4 + [0, 2, 3, 1][Math.max(0, Math.min(3, Math.round(share * 3)))];
  }
  out[to] = first & 255; out[to + 1] = first >> 8; out[to + 2] = second & 255; out[to + 3] = second >> 8;
  for (let k = 0; k < 4; k++) out[to + 4 + k] = Math.floor(marks / 2 ** (8 * k)) & 255;
}

function alphaBlock(texels, out, to) {
  let low = 255, high = 0;
  for (let k = 3; k < 64; k += 4) { low = Math.min(low, texels[k]); high = Math.max(high, texels[k]); }
  out[to] = high; out[to + 1] = low;
  for (let half = 0; half < 2; half++) {
    let marks = 0;
    for (let k = 7; k >= 0; k--) {
      const step = high > low ? Math.round(((high - texels[4 * (8 * half + k) + 3]) * 7) / (high - low)) : 0;
      marks = marks * 8 + (step === 0 ? 0 : step === 7 ? 1 : step + 1);
    }
    for (let k = 0; k < 3; k++) out[to + 2 + 3 * half + k] = (marks >> (8 * k)) & 255;
  }
}

function inBlocks(data, width, height, layers, alpha) {
  const across = Math.ceil(width / 4), down = Math.ceil(height / 4), size = alpha ? 16 : 8, texels = new Uint8Array(64);
  const out = new Uint8Array(layers * across * down * size);
  for (let layer = 0, to = 0; layer < layers; layer++)
    for (let y = 0; y < down; y++)
      for (let x = 0; x < across; x++, to += size) {
        for (let k = 0; k < 16; k++) {
          const row = Math.min(4 * y + (k >> 2), height - 1), column = Math.min(4 * x + (k & 3), width - 1);
          const at = ((layer * height + row) * width + column) * 4;
          for (let c = 0; c < 4; c++) texels[4 * k + c] = data[at + c];
        }
        if (alpha) alphaBlock(texels, out, to);
        colourBlock(texels, out, to + size - 8);
      }
  return out;
}

function halved(data, width, height, layers) {
  const wide = Math.max(width >> 1, 1), tall = Math.max(height >> 1, 1), out = new Uint8Array(layers * wide * tall * 4);
  for (let layer = 0, to = 0; layer < layers; layer++)
    for (let y = 0; y < tall; y++)
      for (let x = 0; x < wide; x++)
        for (let c = 0; c < 4; c++, to++) {
          const at = (row, column) => data[((layer * height + Math.min(row, height - 1)) * width + Math.min(column, width - 1)) * 4 + c];
          out[to] = (at(2 * y, 2 * x) + at(2 * y, 2 * x + 1) + at(2 * y + 1, 2 * x) + at(2 * y + 1, 2 * x + 1) + 2) >> 2;
        }
  return out;
}

// The same texture with all its mips in blocks; three knows such textures by these marks.
function blockTexture(texture, alpha) {
  let { data, width, height, depth } = texture.image;
  const mipmaps = [], layers = depth;
  for (;;) {
    mipmaps.push({ data: inBlocks(data, width, height, layers, alpha), width, height });
    if (width === 1 && height === 1) break;
    data = halved(data, width, height, layers);
    width = Math.max(width >> 1, 1);
    height = Math.max(height >> 1, 1);
  }
  const made = new THREE.DataArrayTexture(null, texture.image.width, texture.image.height, layers);
  return Object.assign(made, {
    isDataArrayTexture: false, isCompressedTexture: true, isCompressedArrayTexture: true, layerUpdates: new Set(), mipmaps,
    format: alpha ? 33779 : 33776, magFilter: texture.magFilter, minFilter: texture.minFilter, generateMipmaps: false, needsUpdate: true,
  });
}

// Atlases and hair in blocks where the card knows them; codes then lie in a texture of their own.
function smaller(textures, context) {
  if (!context.getExtension("WEBGL_compressed_texture_s3tc")) return false;
  const { data, width, height, depth } = textures.atlases.image, codes = new Uint8Array(width * height * depth);
  for (let k = 0; k < codes.length; k++) codes[k] = data[4 * k + 3];
  // 1028: one value a texel
  textures.codes = arrayTexture(codes, width, height, depth, { format: 1028 });
  for (const [name, alpha] of [["shells", true], ["atlases", false]]) textures[name] = blockTexture(textures[name], alpha);
  return true;
}
