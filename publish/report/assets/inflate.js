// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: unpacks what is packed in it. Raw DEFLATE (RFC 1951) in base64; the
// browser's own stream would do, but gives its result later, and a page opened at a case needs it now.
'use strict';

// Lengths and distances of RFC 1951, 3.2.5: base value and extra bits of each symbol.
const kDeflate = (() => {
  const series = (count, first, perStep) => {
    const base = [];
    const extra = [];
    for (let i = 0, at = first; i < count; ++i) {
      const bits = Math.max(0, Math.floor(i / perStep) - 1);
      base.push(at);
      extra.push(bits);
      at += 1 << bits;
    }
    return { base, extra };
  };
  const lengths = series(29, 3, 4);
  lengths.base[28] = 258;
  lengths.extra[28] = 0;
  return { lengths, distances: series(30, 1, 2),
    order: [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15] };
})();

// A canonical Huffman code: how many symbols each length has, and the symbols in their order.
function huffman(lengths) {
  const counts = new Uint16Array(16);
  for (const length of lengths) counts[length] += 1;
  counts[0] = 0;
  const offsets = new Uint16Array(17);
  for (let i = 1; i < 16; ++i) offsets[i + 1] = offsets[i] + counts[i];
  const symbols = new Uint16Array(lengths.length);
  lengths.forEach((length, symbol) => { if (length > 0) symbols[offsets[length]++] = symbol; });
  return { counts, symbols };
}

class Inflater {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
    this.held = 0;
    this.count = 0;
    this.out = new Uint8Array(Math.max(1024, bytes.length * 8));
    this.size = 0;
  }

  bits(count) {
    while (this.count < count) {
      this.held |= this.bytes[this.at++] << this.count;
      this.count += 8;
    }
    const value = this.held & ((1 << count) - 1);
    this.held >>>= count;
    this.count -= count;
    return value;
  }

  symbol({ counts, symbols }) {
    let code = 0;
    let first = 0;
    let index = 0;
    for (let length = 1; length < 16; ++length) {
      code |= this.bits(1);
      if (code - counts[length] < first) return symbols[index + code - first];
      index += counts[length];
      first = (first + counts[length]) << 1;
      code <<= 1;
    }
    throw new Error('The data of this page is damaged.');
  }

  put(byte) {
    if (this.size === this.out.length) {
      const larger = new Uint8Array(2 * this.size);
      larger.set(this.out);
      this.out = larger;
    }
    this.out[this.size++] = byte;
  }

  stored() {
    this.held = this.count = 0;
    const length = this.bytes[this.at] | (this.bytes[this.at + 1] << 8);
    this.at += 4;
    for (let i = 0; i < length; ++i) this.put(this.bytes[this.at++]);
  }

  codes(literals, distances) {
    for (;;) {
      const symbol = this.symbol(literals);
      if (symbol === 256) return;
      if (symbol < 256) {
        this.put(symbol);
        continue;
      }
      const length = kDeflate.lengths.base[symbol - 257] + this.bits(kDeflate.lengths.extra[symbol - 257]);
      const far = this.symbol(distances);
      let from = this.size - kDeflate.distances.base[far] - this.bits(kDeflate.distances.extra[far]);
      for (let i = 0; i < length; ++i) this.put(this.out[from++]);
    }
  }

  dynamic() {
    const literals = this.bits(5) + 257;
    const distances = this.bits(5) + 1;
    const codes = this.bits(4) + 4;
    const lengths = new Array(19).fill(0);
    for (let i = 0; i < codes; ++i) lengths[kDeflate.order[i]] = this.bits(3);
    const code = huffman(lengths);
    const all = [];
    while (all.length < literals + distances) {
      const symbol = this.symbol(code);
      if (symbol < 16) all.push(symbol);
      else if (symbol === 16) for (let i = this.bits(2) + 3, last = all.at(-1); i > 0; --i) all.push(last);
      else for (let i = symbol === 17 ? this.bits(3) + 3 : this.bits(7) + 11; i > 0; --i) all.push(0);
    }
    this.codes(huffman(all.slice(0, literals)), huffman(all.slice(literals)));
  }

  run() {
    for (let last = 0; last === 0;) {
      last = this.bits(1);
      const kind = this.bits(2);
      if (kind === 0) this.stored();
      else if (kind === 2) this.dynamic();
      else {
        const lengths = Array.from({ length: 288 }, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8));
        this.codes(huffman(lengths), huffman(new Array(30).fill(5)));
      }
    }
    return this.out.subarray(0, this.size);
  }
}

// The value of a packed JSON text.
function unpack(node) {
  const packed = Uint8Array.from(atob(node.textContent), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(new Inflater(packed).run()));
}
