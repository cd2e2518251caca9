"use strict";
/* Draws a scene. The ground canvas has faces and edges; the top one has what follows the pointer, marks and labels, and
   is drawn again far more often. Colours are those of the style sheet. */

class Painter {
  /** Above this many edges in view lines are as thin as pixels, above this many vertices dots are left out. */
  static MANY_EDGES = 4000;
  static MANY_DOTS = 3000;

  constructor(ground, top) {
    this.ground = ground.getContext("2d", { alpha: false, willReadFrequently: true });
    this.top = top.getContext("2d");
    this.raster = new Raster();
    this.show = { shades: true, edges: true, steiner: true, t: true, witness: true, input: true };
    this.ratio = 1;
    this.readColours();
  }

  readColours() {
    const style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(`--${name}`).trim();
    const names = ["paper", "line", "ink", "input", "step", "steiner", "t-vertex", "mark", "witness", "input-witness",
                   "hover", "old-face", "plain-face", "bad-face", "lattice", "error"];
    this.colour = Object.fromEntries(names.map(name => [name, colour(name)]));
    this.shades = Array.from({ length: 7 }, (_, i) => packed(colour(`shade-${i}`)));
    this.fills = { paper: packed(this.colour.paper), old: packed(this.colour["old-face"]),
                   plain: packed(this.colour["plain-face"]), bad: packed(this.colour["bad-face"]) };
  }

  resize(width, height, ratio) {
    this.ratio = ratio;
    for (const context of [this.ground, this.top]) {
      context.canvas.width = Math.max(1, Math.round(width * ratio));
      context.canvas.height = Math.max(1, Math.round(height * ratio));
    }
    this.raster.resize(this.ground.canvas.width, this.ground.canvas.height);
  }

  /** Draws faces, edges and dots of the stage; null for a page without a mesh. */
  drawGround(scene, camera, stage) {
    this.raster.clear(this.fills.paper);
    if (scene && stage) this.#fillFaces(scene, camera, stage);
    this.ground.setTransform(1, 0, 0, 1, 0, 0);
    this.ground.putImageData(this.raster.image, 0, 0);
    if (!scene || !stage) return;
    this.ground.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.ground.lineJoin = this.ground.lineCap = "round";
    const crowded = this.show.edges && this.#strokeMesh(scene, camera, stage);
    this.#strokeStage(scene, camera, stage, crowded);
    this.#dots(scene, camera, stage);
  }

  /** Moves the last ground to where a new camera sees it; quick, and blurred until it is drawn again. */
  moveGround(picture, from, camera) {
    const factor = camera.scale / from.scale, ratio = this.ratio;
    this.ground.setTransform(1, 0, 0, 1, 0, 0);
    this.ground.fillStyle = this.colour.paper;
    this.ground.fillRect(0, 0, this.ground.canvas.width, this.ground.canvas.height);
    this.ground.drawImage(picture, camera.toScreenX(from.toPlaneX(0)) * ratio, camera.toScreenY(from.toPlaneY(0)) * ratio,
                          picture.width * factor, picture.height * factor);
  }

  clearTop() {
    this.top.setTransform(1, 0, 0, 1, 0, 0);
    this.top.clearRect(0, 0, this.top.canvas.width, this.top.canvas.height);
    this.top.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.top.lineJoin = this.top.lineCap = "round";
  }

  /** Strokes a segment of the plane on the top canvas, cut to what is seen. */
  segment(camera, x0, y0, x1, y1, colour, width, dash = []) {
    const seen = clipped(camera, x0, y0, x1, y1);
    if (!seen) return;
    this.top.strokeStyle = colour;
    this.top.lineWidth = width;
    this.top.setLineDash(dash);
    this.top.beginPath();
    this.top.moveTo(seen[0], seen[1]);
    this.top.lineTo(seen[2], seen[3]);
    this.top.stroke();
    this.top.setLineDash([]);
  }

  dot(camera, x, y, colour, radius, hollow = false) {
    this.top.beginPath();
    this.top.arc(camera.toScreenX(x), camera.toScreenY(y), radius, 0, 2 * Math.PI);
    this.top.strokeStyle = this.top.fillStyle = colour;
    this.top.lineWidth = 2.5;
    if (hollow) this.top.stroke();
    else this.top.fill();
  }

  /** Outlines a cycle of vertices, and fills it with a trace of the colour. */
  cycle(scene, camera, cycle, colour, width, share = 0.25) {
    this.top.save();
    this.top.beginPath();
    const far = 1e6, near = value => Math.min(far, Math.max(-far, value));
    for (const v of cycle) this.top.lineTo(near(camera.toScreenX(scene.x[v])), near(camera.toScreenY(scene.y[v])));
    this.top.closePath();
    this.top.globalAlpha = share;
    this.top.fillStyle = colour;
    this.top.fill();
    this.top.restore();
    cycle.forEach((v, i) => {
      const u = cycle.at(i - 1);
      this.segment(camera, scene.x[u], scene.y[u], scene.x[v], scene.y[v], colour, width);
    });
  }

  /** Writes beside a point of the plane, above it or `below`. */
  label(camera, x, y, text, colour, below) {
    const { top } = this, px = camera.toScreenX(x), py = camera.toScreenY(y);
    if (px < 0 || py < 0 || px > camera.width || py > camera.height) return;
    top.font = "13px system-ui, sans-serif";
    const left = px + top.measureText(text).width + 14 > camera.width;
    top.textAlign = left ? "right" : "left";
    top.lineWidth = 4;
    top.strokeStyle = this.colour.paper;
    top.fillStyle = colour;
    const at = [px + (left ? -9 : 9), below || py < 24 ? py + 20 : py - 9];
    top.strokeText(text, ...at);
    top.fillText(text, ...at);
  }

  #fillFaces(scene, camera, stage) {
    const { ratio } = this, { scale, width, height } = camera;
    const kind = stageFaces(scene, stage), xs = new Float64Array(scene.longest), ys = new Float64Array(scene.longest);
    scene.faceTree.search(...camera.window(1), f => {
      if (!kind[f]) return;
      const from = scene.start[f], count = scene.start[f + 1] - from;
      for (let i = 0; i < count; i++) {
        const v = scene.vertex[from + i];
        xs[i] = ((scene.x[v] - camera.x) * scale + width / 2) * ratio;
        ys[i] = (height / 2 - (scene.y[v] - camera.y) * scale) * ratio;
      }
      const shade = scene.shades[f];
      this.raster.fill(xs, ys, count, shade < 0 ? this.fills.bad : kind[f] === 1 ? this.fills.old
        : this.show.shades ? this.shades[shade] : this.fills.plain);
    });
  }

  /** Strokes the edges of the faces of a stage; returns whether they are many. */
  #strokeMesh(scene, camera, stage) {
    const seen = [], drawn = stageVertices(scene, stage);
    scene.edgeTree.search(...camera.window(2), e => {
      if (drawn === null || (drawn[scene.edges[2 * e]] && drawn[scene.edges[2 * e + 1]])) seen.push(e);
    });
    const crowded = seen.length > Painter.MANY_EDGES;
    /* The more of the window lines would cover, the fainter they are: the shades of the faces stay visible. */
    let length = 0;
    const long = seen.filter(e => {
      const a = scene.edges[2 * e], b = scene.edges[2 * e + 1];
      const pixels = Math.hypot(scene.x[a] - scene.x[b], scene.y[a] - scene.y[b]) * camera.scale;
      length += Math.min(pixels, camera.width);
      return pixels > 0.3;
    });
    this.ground.globalAlpha = Math.min(1, Math.max(0.12, 0.15 * camera.width * camera.height / length));
    /* Lines up to a pixel wide are drawn in a much faster way. */
    this.#stroke(camera, this.colour.line, (crowded ? 0.9 : 1.1) / this.ratio, add => {
      for (const e of long) {
        const a = scene.edges[2 * e], b = scene.edges[2 * e + 1];
        add(scene.x[a], scene.y[a], scene.x[b], scene.y[b]);
      }
    });
    this.ground.globalAlpha = 1;
    return crowded;
  }

  #strokeStage(scene, camera, stage, crowded) {
    const pairs = (edges, add) => {
      for (let i = 0; i < edges.length; i += 2) {
        add(scene.x[edges[i]], scene.y[edges[i]], scene.x[edges[i + 1]], scene.y[edges[i + 1]]);
      }
    };
    if (stage.cycles.length) {
      this.#stroke(camera, this.colour.line, 1, add => {
        for (const cycle of stage.cycles) {
          cycle.forEach((v, i) => add(scene.x[cycle.at(i - 1)], scene.y[cycle.at(i - 1)], scene.x[v], scene.y[v]));
        }
      });
    }
    const input = scene.data.stages[0].edges, many = input.length / 2 > Painter.MANY_EDGES;
    if (this.show.input) {
      this.#stroke(camera, this.colour.input, crowded || many ? 1 / this.ratio : 2.2, add => pairs(input, add));
    }
    if (stage !== scene.data.stages[0] && stage.edges.length) {
      const thin = stage.edges.length / 2 > Painter.MANY_EDGES;
      this.#stroke(camera, this.colour.step, thin ? 1 / this.ratio : 2, add => pairs(stage.edges, add));
    }
    this.#arcs(scene, camera, stage.arcs);
  }

  #arcs(scene, camera, arcs) {
    this.#stroke(camera, this.colour.step, 2, add => {
      for (const [centre, from, to] of arcs) {
        const x = scene.x[centre], y = scene.y[centre], dx = scene.x[from] - x, dy = scene.y[from] - y;
        const ex = scene.x[to] - x, ey = scene.y[to] - y;
        const turn = Math.atan2(dx * ey - dy * ex, dx * ex + dy * ey), parts = 24;
        let lastX = x + dx, lastY = y + dy;
        for (let i = 1; i <= parts; i++) {
          const c = Math.cos(turn * i / parts), s = Math.sin(turn * i / parts);
          const nextX = x + dx * c - dy * s, nextY = y + dx * s + dy * c;
          add(lastX, lastY, nextX, nextY);
          [lastX, lastY] = [nextX, nextY];
        }
      }
    });
  }

  /** Steiner vertices as dots and T-vertices as squares, where there is room for them. */
  #dots(scene, camera, stage) {
    const seen = [], drawn = stageVertices(scene, stage);
    scene.vertexTree.search(...camera.window(4), v => {
      if ((drawn === null || drawn[v]) && (scene.isT[v] || scene.isSteiner(v))) seen.push(v);
    });
    if (seen.length > Painter.MANY_DOTS) return;
    const size = seen.length > 1000 ? 1.2 : seen.length > 250 ? 1.8 : 2.6, { ground, colour } = this;
    for (const v of seen) {
      const px = camera.toScreenX(scene.x[v]), py = camera.toScreenY(scene.y[v]);
      if (this.show.steiner && scene.isSteiner(v)) {
        ground.fillStyle = colour.steiner;
        ground.beginPath();
        ground.arc(px, py, size, 0, 2 * Math.PI);
        ground.fill();
      }
      if (this.show.t && scene.isT[v]) {
        ground.strokeStyle = colour["t-vertex"];
        ground.lineWidth = 1.5;
        ground.strokeRect(px - size - 1.5, py - size - 1.5, 2 * size + 3, 2 * size + 3);
      }
    }
  }

  /** Strokes the segments that `each` adds, cut to what is seen, a thousand to a path: long paths are slow. */
  #stroke(camera, colour, width, each) {
    const { ground } = this;
    ground.strokeStyle = colour;
    ground.lineWidth = width;
    ground.beginPath();
    let count = 0;
    each((x0, y0, x1, y1) => {
      const seen = clipped(camera, x0, y0, x1, y1);
      if (!seen) return;
      ground.moveTo(seen[0], seen[1]);
      ground.lineTo(seen[2], seen[3]);
      if (++count % 1000 === 0) {
        ground.stroke();
        ground.beginPath();
      }
    });
    ground.stroke();
  }
}

/** For each face 2 when the stage makes it, 1 when an earlier one did, 0 when it is not there yet. */
function stageFaces(scene, stage) {
  if (stage.kind?.length !== scene.data.faces.length) {
    stage.kind = new Uint8Array(scene.data.faces.length);
    for (const [from, to] of stage.old) stage.kind.fill(1, from, to);
    for (const [from, to] of stage.new) stage.kind.fill(2, from, to);
  }
  return stage.kind;
}

/** Which vertices the faces of a stage have; null when it has all faces. */
function stageVertices(scene, stage) {
  if (stage.vertices === undefined) {
    const kind = stageFaces(scene, stage);
    stage.vertices = null;
    if (!kind.every(Boolean)) {
      stage.vertices = new Uint8Array(scene.x.length);
      kind.forEach((made, f) => { if (made) for (const v of scene.face(f)) stage.vertices[v] = 1; });
    }
  }
  return stage.vertices;
}

/** The part of a segment of the plane that is seen, in pixels, or null; the array is used again by the next call. What
    reaches far out is cut off: the canvas computes with few digits. */
function clipped(camera, x0, y0, x1, y1) {
  const ax = camera.toScreenX(x0), ay = camera.toScreenY(y0), bx = camera.toScreenX(x1), by = camera.toScreenY(y1);
  const low = -8, right = camera.width + 8, bottom = camera.height + 8, cut = clipped.result;
  const inside = ax > low && ax < right && bx > low && bx < right && ay > low && ay < bottom && by > low && by < bottom;
  let first = 0, last = 1;
  if (!inside) {
    for (const [at, to, high] of [[ax, bx, right], [ay, by, bottom]]) {
      if (at === to) {
        if (at < low || at > high) return null;
      } else {
        const one = (low - at) / (to - at), other = (high - at) / (to - at);
        first = Math.max(first, Math.min(one, other));
        last = Math.min(last, Math.max(one, other));
      }
    }
    if (first > last) return null;
  }
  cut[0] = ax + first * (bx - ax);
  cut[1] = ay + first * (by - ay);
  cut[2] = last === 1 ? bx : ax + last * (bx - ax);
  cut[3] = last === 1 ? by : ay + last * (by - ay);
  return cut;
}
clipped.result = new Float64Array(4);

/** A colour #rrggbb as a pixel of an image, whatever the order of bytes. */
function packed(colour) {
  const parts = [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16));
  return new Uint32Array(Uint8ClampedArray.of(...parts, 255).buffer)[0];
}
