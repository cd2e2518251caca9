"use strict";
/* A static tree of boxes: what is in a window, or near the pointer, without looking at everything. A grid of equal
   cells would do for equal faces; sizes in a mesh differ by factors of a million. */

class BoxTree {
  /** `boxOf(i, box)` puts the least x, least y, greatest x and greatest y of item i into `box`. */
  constructor(count, boxOf) {
    this.count = count;
    const box = new Float64Array(4), leaves = new Float64Array(4 * count);
    const all = [Infinity, Infinity, -Infinity, -Infinity];
    for (let i = 0; i < count; i++) {
      boxOf(i, box);
      leaves.set(box, 4 * i);
      for (let k = 0; k < 2; k++) all[k] = Math.min(all[k], box[k]);
      for (let k = 2; k < 4; k++) all[k] = Math.max(all[k], box[k]);
    }
    this.order = BoxTree.#byMorton(count, leaves, all);
    /* levels[0] has the boxes of the items in order, levels[k + 1] those of SIZE boxes of levels[k] each. */
    const first = new Float64Array(4 * count);
    for (let i = 0; i < count; i++) first.set(leaves.subarray(4 * this.order[i], 4 * this.order[i] + 4), 4 * i);
    this.levels = [first];
    while (this.levels.at(-1).length > 4) this.levels.push(BoxTree.#grouped(this.levels.at(-1)));
  }

  /** Calls `visit(i)` for each item whose box meets the given one. */
  search(x0, y0, x1, y1, visit) {
    if (!this.count) return;
    const stack = [this.levels.length - 1, 0];
    while (stack.length) {
      const node = stack.pop(), depth = stack.pop(), boxes = this.levels[depth], k = 4 * node;
      if (boxes[k] > x1 || boxes[k + 1] > y1 || boxes[k + 2] < x0 || boxes[k + 3] < y0) continue;
      if (depth === 0) {
        visit(this.order[node]);
        continue;
      }
      const end = Math.min((node + 1) * BoxTree.SIZE, this.levels[depth - 1].length / 4);
      for (let child = node * BoxTree.SIZE; child < end; child++) stack.push(depth - 1, child);
    }
  }

  static SIZE = 8;

  /** Items along a curve that keeps neighbours together: by the interleaved bits of their middles. */
  static #byMorton(count, boxes, all) {
    const keys = new Float64Array(count), width = all[2] - all[0] || 1, height = all[3] - all[1] || 1;
    for (let i = 0, k = 0; i < count; i++, k += 4) {
      const x = Math.floor(((boxes[k] + boxes[k + 2]) / 2 - all[0]) / width * 32767);
      const y = Math.floor(((boxes[k + 1] + boxes[k + 3]) / 2 - all[1]) / height * 32767);
      keys[i] = (BoxTree.#spread(x) + 2 * BoxTree.#spread(y)) * 2 ** 22 + i;
    }
    return Uint32Array.from(keys.sort(), key => key % 2 ** 22);
  }

  static #spread(value) {
    value = (value | value << 8) & 0x00ff00ff;
    value = (value | value << 4) & 0x0f0f0f0f;
    value = (value | value << 2) & 0x33333333;
    return (value | value << 1) & 0x55555555;
  }

  static #grouped(boxes) {
    const count = Math.ceil(boxes.length / 4 / BoxTree.SIZE), groups = new Float64Array(4 * count);
    for (let group = 0; group < count; group++) {
      const end = Math.min((group + 1) * BoxTree.SIZE * 4, boxes.length);
      const box = [Infinity, Infinity, -Infinity, -Infinity];
      for (let k = group * BoxTree.SIZE * 4; k < end; k += 4) {
        for (let i = 0; i < 2; i++) box[i] = Math.min(box[i], boxes[k + i]);
        for (let i = 2; i < 4; i++) box[i] = Math.max(box[i], boxes[k + i]);
      }
      groups.set(box, 4 * group);
    }
    return groups;
  }
}
