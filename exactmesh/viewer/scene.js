"use strict";
/* A mesh with all that is known of it: exact texts to read, arrays of doubles to draw and to find things by. */

class Scene {
  /** `data` is a document (`document.py`). `frame` places coordinates: those of another scene, or none for its own. */
  constructor(data, frame = Frame.around(data.x, data.y)) {
    this.data = data;
    this.frame = frame;
    this.count = data.vertices;
    this.x = Float64Array.from(data.x, text => frame.x(text));
    this.y = Float64Array.from(data.y, text => frame.y(text));
    this.isT = new Uint8Array(this.x.length);
    for (const v of data.t_vertices) this.isT[v] = 1;
    this.shades = Int8Array.from(data.shades);
    this.#link(data.faces);
    this.faceTree = new BoxTree(data.faces.length, (f, box) => this.#box(this.vertex, this.start[f], this.start[f + 1], box));
    this.edgeTree = new BoxTree(this.edges.length / 2, (e, box) => this.#box(this.edges, 2 * e, 2 * e + 2, box));
    this.vertexTree = new BoxTree(this.count, (v, box) => box.set([this.x[v], this.y[v], this.x[v], this.y[v]]));
    this.bounds = this.boxOf(Array.from({ length: this.count }, (_, v) => v)) ?? [-1, -1, 1, 1];
  }

  face(f) {
    return this.vertex.subarray(this.start[f], this.start[f + 1]);
  }

  isSteiner(v) {
    return this.data.given !== null && v >= this.data.given && v < this.count;
  }

  /** The vertex nearest to (x, y) among those within `reach`, or -1. */
  nearestVertex(x, y, reach) {
    let best = -1, least = reach * reach;
    this.vertexTree.search(x - reach, y - reach, x + reach, y + reach, v => {
      const distance = (this.x[v] - x) ** 2 + (this.y[v] - y) ** 2;
      if (distance < least || (distance === least && v < best)) [best, least] = [v, distance];
    });
    return best;
  }

  /** The face that (x, y) is in as far as doubles can tell, or -1. */
  faceAt(x, y) {
    let found = -1;
    this.faceTree.search(x, y, x, y, f => {
      const face = this.face(f);
      let inside = false;
      for (let i = 0, j = face.length - 1; i < face.length; j = i++) {
        const a = face[i], b = face[j];
        if (this.y[a] > y !== this.y[b] > y
            && x < (this.x[b] - this.x[a]) * (y - this.y[a]) / (this.y[b] - this.y[a]) + this.x[a]) inside = !inside;
      }
      if (inside) found = f;
    });
    return found;
  }

  /** The box of some vertices and points, or null when there are none. */
  boxOf(vertices, points = []) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const grow = (x, y) => {
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    };
    for (const v of vertices) grow(this.x[v], this.y[v]);
    for (const [x, y] of points) grow(this.frame.x(x), this.frame.y(y));
    return box[0] <= box[2] ? box : null;
  }

  /** Where the witness of a feature size is: the vertex and the nearest point of the edge or vertex. */
  shortest({ vertex, feature: [a, b] }) {
    const px = this.x[vertex], py = this.y[vertex], ax = this.x[a], ay = this.y[a];
    const dx = this.x[b] - ax, dy = this.y[b] - ay, length = dx * dx + dy * dy;
    const t = length ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
    return [px, py, ax + t * dx, ay + t * dy];
  }

  #box(numbers, from, to, box) {
    box[0] = box[1] = Infinity;
    box[2] = box[3] = -Infinity;
    for (let i = from; i < to; i++) {
      const x = this.x[numbers[i]], y = this.y[numbers[i]];
      if (x < box[0]) box[0] = x;
      if (x > box[2]) box[2] = x;
      if (y < box[1]) box[1] = y;
      if (y > box[3]) box[3] = y;
    }
  }

  /** Puts the faces into one array, and their edges, each once, into another. */
  #link(faces) {
    this.start = new Uint32Array(faces.length + 1);
    faces.forEach((face, f) => { this.start[f + 1] = this.start[f] + face.length; });
    this.vertex = new Uint32Array(this.start[faces.length]);
    this.longest = faces.reduce((most, face) => Math.max(most, face.length), 0);
    faces.forEach((face, f) => this.vertex.set(face, this.start[f]));
    const keys = new Float64Array(this.vertex.length);
    for (let f = 0; f < faces.length; f++) {
      for (let i = this.start[f], j = this.start[f + 1] - 1; i < this.start[f + 1]; j = i++) {
        const u = this.vertex[j], v = this.vertex[i];
        keys[i] = Math.min(u, v) * 2 ** 24 + Math.max(u, v);
      }
    }
    keys.sort();
    const once = keys.filter((key, i) => key !== keys[i - 1]);
    this.edges = new Uint32Array(2 * once.length);
    once.forEach((key, e) => this.edges.set([Math.floor(key / 2 ** 24), key % 2 ** 24], 2 * e));
  }
}

/* Exact coordinates to doubles near [-1, 1]: moved and scaled exactly, then rounded once. */
class Frame {
  constructor(x, y, scale) {
    this.origin = [x, y];
    this.scale = scale;
  }

  static around(xs, ys) {
    const range = texts => {
      let low = null, high = null;
      for (const text of texts) {
        const value = Rational.parse(text);
        if (low === null || value.minus(low).n < 0n) low = value;
        if (high === null || value.minus(high).n > 0n) high = value;
      }
      return low === null ? [new Rational(-1n), new Rational(1n)] : [low, high];
    };
    const [x0, x1] = range(xs), [y0, y1] = range(ys);
    const half = new Rational(1n, 2n), across = x1.minus(x0), up = y1.minus(y0);
    const reach = across.minus(up).n > 0n ? across : up;
    const scale = reach.n ? new Rational(2n * reach.d, reach.n) : new Rational(1n);
    return new Frame(x0.plus(x1).times(half).reduced(), y0.plus(y1).times(half).reduced(), scale.reduced());
  }

  x(text) {
    return Rational.parse(text).minus(this.origin[0]).times(this.scale).toNumber();
  }

  y(text) {
    return Rational.parse(text).minus(this.origin[1]).times(this.scale).toNumber();
  }

  /** The exact point at a place of the drawing. */
  point(x, y) {
    const back = new Rational(this.scale.d, this.scale.n);
    return [x, y].map((value, i) => Rational.fromNumber(value).times(back).plus(this.origin[i]));
  }
}
