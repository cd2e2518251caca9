"use strict";
/* The polygons that are edited: vertices as exact texts, edges, holes; every change is a new state, so undo is a stack. */

class Drawing {
  /** `state` is { vertices: [[x, y]], edges: [[u, v]], holes, name }. */
  constructor(state) {
    this.state = state;
    this.past = [];
    this.future = [];
  }

  /** Goes to a new state; `past` is kept but for moves that only continue the last one. */
  change(state, continues = false) {
    if (!continues) this.past.push(this.state);
    this.future = [];
    this.state = state;
  }

  undo() {
    if (!this.past.length) return false;
    this.future.push(this.state);
    this.state = this.past.pop();
    return true;
  }

  redo() {
    if (!this.future.length) return false;
    this.past.push(this.state);
    this.state = this.future.pop();
    return true;
  }

  move(v, place, continues) {
    const vertices = this.state.vertices.with(v, place);
    this.change({ ...this.state, vertices }, continues);
  }

  /** Adds a closed polygon. */
  addRing(places) {
    const { vertices, edges } = this.state, first = vertices.length;
    this.change({ ...this.state, vertices: [...vertices, ...places],
                  edges: [...edges, ...places.map((_, i) => [first + i, first + (i + 1) % places.length])] });
  }

  /** Puts a vertex into an edge; returns its number. */
  split(e, place) {
    const { vertices, edges } = this.state, [u, v] = edges[e], w = vertices.length;
    this.change({ ...this.state, vertices: [...vertices, place], edges: edges.toSpliced(e, 1, [u, w], [w, v]) });
    return w;
  }

  /** Deletes a vertex. Two neighbours of it become neighbours, unless they are; of a triangle nothing is left. */
  remove(v) {
    const { vertices, edges } = this.state, mine = edges.filter(edge => edge.includes(v));
    let rest = edges.filter(edge => !edge.includes(v));
    const ends = mine.map(([a, b]) => (a === v ? b : a));
    const gone = new Set([v]);
    if (ends.length === 2) {
      const joined = rest.some(([a, b]) => ends.includes(a) && ends.includes(b));
      if (!joined) rest = rest.toSpliced(edges.indexOf(mine[0]), 0, mine[0][1] === v ? ends : ends.toReversed());
      else if (ends.every(end => rest.filter(edge => edge.includes(end)).length === 1)) {
        rest = rest.filter(edge => !ends.every(end => edge.includes(end)));
        for (const end of ends) gone.add(end);
      }
    }
    const number = new Map(vertices.keys().filter(u => !gone.has(u)).map((u, i) => [u, i]));
    this.change({ ...this.state, vertices: vertices.filter((_, u) => !gone.has(u)),
                  edges: rest.map(edge => edge.map(u => number.get(u))) });
  }

  /** The edge that leaves a vertex, or else one that ends there, or -1. */
  edgeFrom(v) {
    const { edges } = this.state, leaving = edges.findIndex(edge => edge[0] === v);
    return leaving >= 0 ? leaving : edges.findIndex(edge => edge[1] === v);
  }

  json() {
    const { vertices, edges, holes, name } = this.state, pslg = { format: "exactmesh-pslg/1", vertices, edges };
    if (holes.length) pslg.holes = holes;
    if (name) pslg.name = name;
    return pslg;
  }
}

/* The points whose coordinates are multiples of a spacing. */
class Lattice {
  constructor(spacing) {
    this.spacing = spacing;
  }

  /** A lattice of about ten points across a drawing in a frame; its spacing is 1, 2 or 5 times a power of ten. */
  static across(frame) {
    const tenth = Math.log10(new Rational(frame.scale.d, frame.scale.n).toNumber() / 5), power = Math.floor(tenth);
    const factor = [1, 2, 5, 10].reduce((a, b) => (Math.abs(Math.log10(b) + power - tenth)
      < Math.abs(Math.log10(a) + power - tenth) ? b : a));
    const ten = 10n ** BigInt(Math.abs(power));
    return new Lattice((power < 0 ? new Rational(BigInt(factor), ten) : new Rational(BigInt(factor) * ten)).reduced());
  }

  /** The lattice point nearest to a pair of rationals, as texts. */
  nearest(point) {
    return point.map(value => this.#multiple(value.steps(this.spacing)));
  }

  /** A point moved by whole steps from the lattice point nearest to it. */
  moved(place, dx, dy) {
    const [x, y] = place.map(text => Rational.parse(text).steps(this.spacing));
    return [this.#multiple(x + BigInt(dx)), this.#multiple(y + BigInt(dy))];
  }

  #multiple(count) {
    return new Rational(count * this.spacing.n, this.spacing.d).toString();
  }
}
