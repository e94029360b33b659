// Pixels of the PNG files that a browser's screenshots are: 8 bits, red, green, blue and perhaps alpha, not interlaced.

import { inflateSync } from "node:zlib";

/** @returns {{ width: number, height: number, rgb: Uint8Array }} */
export function pixels(file) {
  let at = 8;
  let width, height, channels;
  const parts = [];
  while (at < file.length) {
    const length = file.readUInt32BE(at);
    const kind = file.toString("latin1", at + 4, at + 8);
    const data = file.subarray(at + 8, at + 8 + length);
    if (kind === "IHDR") {
      [width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
      channels = { 2: 3, 6: 4 }[data[9]];
      if (data[8] !== 8 || !channels || data[12] !== 0) {
        throw new Error("a screenshot of another kind");
      }
    } else if (kind === "IDAT") {
      parts.push(data);
    }
    at += length + 12;
  }
  const rows = inflateSync(Buffer.concat(parts));
  const stride = width * channels;
  const rgb = new Uint8Array(width * height * 3);
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; y += 1) {
    const filter = rows[y * (stride + 1)];
    const row = rows.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1));
    for (let i = 0; i < stride; i += 1) {
      const left = i < channels ? 0 : row[i - channels];
      const corner = i < channels ? 0 : above[i - channels];
      row[i] += [0, left, above[i], (left + above[i]) >> 1, paeth(left, above[i], corner)][filter];
    }
    for (let x = 0; x < width; x += 1) {
      rgb.set(row.subarray(x * channels, x * channels + 3), 3 * (y * width + x));
    }
    above = row;
  }
  return { width, height, rgb };
}

function paeth(left, above, corner) {
  const guess = left + above - corner;
  const [a, b, c] = [left, above, corner].map((value) => Math.abs(guess - value));
  return a <= b && a <= c ? left : b <= c ? above : corner;
}

/** Mean level and its standard deviation, of the rows from one part of the height to another. */
export function levels(picture, from = 0, to = 1) {
  const { width, height, rgb } = picture;
  const part = rgb.subarray(3 * width * Math.floor(from * height), 3 * width * Math.floor(to * height));
  const mean = part.reduce((sum, level) => sum + level, 0) / part.length;
  const square = part.reduce((sum, level) => sum + (level - mean) ** 2, 0) / part.length;
  return { mean, deviation: Math.sqrt(square) };
}

/** Mean difference in levels, of the columns up to a part of the width. */
export function difference(one, other, width = 1) {
  if (one.width !== other.width || one.height !== other.height) {
    return Infinity;
  }
  let sum = 0;
  const columns = Math.floor(width * one.width);
  for (let y = 0; y < one.height; y += 1) {
    const start = 3 * y * one.width;
    for (let i = start; i < start + 3 * columns; i += 1) {
      sum += Math.abs(one.rgb[i] - other.rgb[i]);
    }
  }
  return sum / (3 * columns * one.height);
}
