"use strict";
/* The editor's page: a polygon on a lattice, and what the server says of it, exactly and part by part. */

class Editor {
  static NAMES = { repaired: "repaired construction", paper: "the paper's construction" };
  /** An answer that takes longer than so many milliseconds is given up when the polygon changes: while a vertex is
      dragged an answer to where it was is better than none. */
  static PATIENCE = { dragging: 5000, still: 700 };
  static REACH = 13;

  constructor(settings) {
    this.$ = id => document.getElementById(id);
    this.settings = settings;
    this.drawing = new Drawing(settings.pslg);
    const { vertices } = settings.pslg;
    this.frame = Frame.around(vertices.map(p => p[0]), vertices.map(p => p[1]));
    this.lattice = Lattice.across(this.frame);
    this.$("spacing").value = this.lattice.spacing.toString();
    this.view = new View(document.querySelector(".stage"));
    this.view.margin = 0.15;
    this.mode = "move";
    this.ring = [];
    this.chosen = -1;
    this.pointer = this.picked = this.hovered = this.marks = this.fault = null;
    this.scenes = {};
    this.which = "repaired";
    this.version = 0;
    this.asked = null;
    this.theme = new Theme(this.$("theme"), () => {
      this.view.painter.readColours();
      this.view.redraw();
    });
    this.lists = Object.fromEntries(Object.keys(Editor.NAMES).map(name => [name, new ClaimList(
      this.$(`${name}-claims`), this.$(`${name}-summary`), null, claim => this.#showClaim(name, claim))]));
    this.#listen();
    this.view.tool = { down: (...args) => this.#down(...args), move: (...args) => this.#drag(...args),
                       up: () => this.#drop(), key: event => this.#key(event) };
    this.view.drawTop = () => this.#drawTop();
    this.view.onHover = (x, y) => this.#hover(x, y);
    this.view.onPick = (x, y) => this.#pick(x, y);
    this.#goHome(false);
    this.changed(true);
  }

  /** Takes note of a change of the polygon and asks the server about it; `whole` asks for the claims as well. */
  changed(whole) {
    this.version++;
    this.whole = whole;
    const { vertices, edges } = this.drawing.state;
    if (this.chosen >= vertices.length) this.chosen = -1;
    this.fault = null;
    this.marks = null;
    this.$("counts").textContent = `${vertices.length} vertices, ${edges.length} edges`;
    this.#buttons();
    this.#stale(true);
    this.#ask();
    this.view.redrawTop();
  }

  setMode(mode) {
    this.mode = mode;
    this.ring = [];
    this.chosen = -1;
    this.$("move").setAttribute("aria-pressed", String(mode === "move"));
    this.$("draw").setAttribute("aria-pressed", String(mode === "draw"));
    this.#buttons();
    this.view.redrawTop();
  }

  /* --- the server --- */

  #ask() {
    if (this.drawing.state.vertices.length === 0) {
      this.asked?.controller.abort();
      this.asked = null;
      this.#forget();
      this.#say("Draw a polygon.");
      this.#stale(false);
      return;
    }
    const patience = this.whole ? Editor.PATIENCE.still : Editor.PATIENCE.dragging;
    const left = this.asked ? this.asked.start + patience - performance.now() : 0;
    if (left > 0) {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => { if (this.asked && this.asked.version !== this.version) this.#ask(); }, left);
      return;
    }
    this.asked?.controller.abort();
    const asked = { version: this.version, start: performance.now(), controller: new AbortController() };
    this.asked = asked;
    this.fault = null;
    this.#say("computing …");
    this.#read(asked, JSON.stringify({ pslg: this.drawing.json(), claims: this.whole })).catch(error => {
      if (this.asked === asked) this.#say(`The server does not answer: ${error.message}`, true);
    }).finally(() => {
      if (this.asked !== asked) return;
      this.asked = null;
      if (asked.version !== this.version) this.#ask();
      else this.#stale(false);
    });
  }

  async #read(asked, body) {
    const answer = await this.#post("/evaluate", body, asked.controller.signal);
    const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
    let rest = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      const lines = (rest + value).split("\n");
      rest = lines.pop();
      for (const line of lines) if (this.asked === asked) this.#part(JSON.parse(line));
    }
  }

  async #post(path, body, signal) {
    const answer = await fetch(path, { method: "POST", body, signal, headers: { "X-Exactmesh-Token": this.settings.token } });
    if (!answer.ok) throw new Error((await answer.json()).error);
    return answer;
  }

  #part(part) {
    switch (part.part) {
      case "input":
        this.$("input-sizes").replaceChildren(facts(part.sizes.map(size => this.#sizeRow(size))));
        break;
      case "error":
        this.fault = part;
        this.#forget();
        this.#say(part.message, true);
        break;
      case "timeout":
        this.#forget();
        this.#say(`Stopped after ${part.seconds} s: this polygon takes too long.`, true);
        break;
      case "stopped":
        this.#say("The computation has ended without an answer.", true);
        break;
      case "end":
        if (!this.fault) this.#say("exact");
        break;
      case "superseded":
        break;
      default:
        this.#made(part);
    }
    this.view.redraw();
  }

  #made(part) {
    const name = part.part, reason = part.refused ?? part.failed;
    this.scenes[name] = reason ? { reason } : { scene: new Scene(part.document, this.frame) };
    if (reason) this.lists[name].set([]);
    else this.lists[name].set(part.document.claims);
    if (reason) this.$(`${name}-summary`).textContent = reason;
    else if (!part.document.claims.length) this.$(`${name}-summary`).textContent = "judged when the vertex is let go";
    this.#meshSizes();
    this.#steps();
  }

  #forget() {
    this.scenes = {};
    this.$("input-sizes").replaceChildren();
    for (const [name, list] of Object.entries(this.lists)) {
      list.set([]);
      this.$(`${name}-summary`).textContent = "";
    }
    this.#meshSizes();
    this.#steps();
  }

  /* --- what is shown --- */

  #say(text, isError = false) {
    this.$("state").textContent = text;
    this.$("state").className = isError ? "error" : "";
  }

  /** Numbers that are those of an earlier polygon are dimmed. */
  #stale(is) {
    document.querySelector("aside").dataset.stale = String(is);
  }

  #buttons() {
    this.$("undo").disabled = !this.drawing.past.length && !this.ring.length;
    this.$("redo").disabled = !this.drawing.future.length;
    this.$("close").disabled = this.ring.length < 3;
    this.$("split").disabled = this.$("delete").disabled = this.chosen < 0;
  }

  #sizeRow(size) {
    const to = size.feature[0] === size.feature[1] ? `vertex ${size.feature[0]}` : `edge (${size.feature.join(", ")})`;
    return [`mfs of the ${size.of}`, `≈ ${size.decimal}: vertex ${size.vertex} and ${to}`, exact(`squared ${size.squared}`)];
  }

  #meshSizes() {
    const parts = Object.entries(this.scenes).flatMap(([name, { scene, reason }]) => {
      const head = make("h3", { textContent: Editor.NAMES[name] });
      if (reason) return [head, make("p", { textContent: reason })];
      const { data } = scene, rows = data.sizes.filter(size => size.of === "mesh").map(size => this.#sizeRow(size));
      rows.unshift(["faces", `${data.faces.length}, ${data.vertices - data.given} Steiner vertices`]);
      if (data.degradation) {
        rows.push(["degradation", `≈ ${data.degradation.decimal}`, exact(`squared ${data.degradation.squared}`)]);
      }
      const list = facts(rows);
      list.dataset.mesh = name;
      return [head, list];
    });
    this.$("mesh-sizes").replaceChildren(...parts);
  }

  /** Fills the list of steps of the mesh that is drawn, and draws the one that was chosen if it is there. */
  #steps() {
    const scene = this.scenes[this.which]?.scene ?? null, select = this.$("step"), before = select.value;
    const names = scene ? scene.data.stages.map(stage => stage.name) : [];
    select.replaceChildren(...names.map(name => make("option", { value: name, textContent: name })));
    select.disabled = !scene;
    select.value = names.includes(before) ? before : names.at(-1) ?? "";
    this.#drawStep();
  }

  #drawStep() {
    const scene = this.scenes[this.which]?.scene ?? null;
    this.view.setScene(scene, scene?.data.stages[this.$("step").selectedIndex] ?? null);
  }

  #showClaim(name, claim) {
    if (this.which !== name) {
      document.querySelector(`input[value="${name}"]`).checked = true;
      this.which = name;
      this.#steps();
    }
    for (const [other, list] of Object.entries(this.lists)) {
      if (other !== name) list.list.querySelector("[aria-current]")?.removeAttribute("aria-current");
    }
    const { scene } = this.scenes[name];
    this.marks = claim.marks;
    this.#details(claimDetails(claim));
    const box = marksBox(scene, claim.marks);
    if (box) this.view.flyToBox(box);
    this.view.redrawTop();
  }

  #details(elements) {
    this.$("chosen").hidden = !elements;
    this.$("details").replaceChildren(...elements ?? []);
    if (!elements) document.querySelector(".claim[aria-current]")?.removeAttribute("aria-current");
  }

  #place(v) {
    const [x, y] = this.drawing.state.vertices[v];
    return [this.frame.x(x), this.frame.y(y)];
  }

  #goHome(fly) {
    const places = this.drawing.state.vertices.map((_, v) => this.#place(v));
    if (places.length) {
      this.view.home = [Math.min(...places.map(p => p[0])), Math.min(...places.map(p => p[1])),
                        Math.max(...places.map(p => p[0])), Math.max(...places.map(p => p[1]))];
    }
    this.view.fit(fly);
  }

  #drawTop() {
    const { view } = this, { painter, camera } = view, { colour } = painter;
    this.#drawLattice();
    if (view.scene) {
      const last = this.$("step").selectedIndex === view.scene.data.stages.length - 1;
      const sizes = view.scene.data.sizes.filter(size => size.of === "input" || last);
      const fresh = document.querySelector("aside").dataset.stale !== "true";
      drawMarks(view, { sizes: fresh ? sizes : [], marks: this.marks, chosen: this.picked, hovered: this.hovered });
    }
    const { vertices, edges } = this.drawing.state, places = vertices.map((_, v) => this.#place(v));
    for (const [u, v] of edges) painter.segment(camera, ...places[u], ...places[v], colour.input, 2.2);
    const radius = places.length > 60 ? 3 : 4.5;
    for (const [x, y] of places) painter.dot(camera, x, y, colour.input, radius);
    if (this.chosen >= 0) painter.dot(camera, ...places[this.chosen], colour.hover, 10, true);
    this.#drawFault(places);
    this.#drawRing();
  }

  #drawLattice() {
    const { camera, painter } = this.view, [x0, y0, x1, y1] = camera.window();
    const step = this.lattice.spacing.times(this.frame.scale).toNumber();
    if (step * camera.scale < 9) return;
    const first = this.lattice.nearest(this.frame.point(x0, y0));
    const startX = this.frame.x(first[0]), startY = this.frame.y(first[1]);
    painter.top.fillStyle = painter.colour.lattice;
    for (let x = startX; x <= x1; x += step) {
      for (let y = startY; y <= y1; y += step) {
        painter.top.fillRect(camera.toScreenX(x) - 1, camera.toScreenY(y) - 1, 2, 2);
      }
    }
  }

  #drawFault(places) {
    if (!this.fault) return;
    const { camera, painter } = this.view, red = painter.colour.error;
    for (const [u, v] of this.fault.edges ?? []) painter.segment(camera, ...places[u], ...places[v], red, 4);
    for (const v of this.fault.vertices ?? []) painter.dot(camera, ...places[v], red, 7);
    if (this.fault.at) painter.dot(camera, this.frame.x(this.fault.at[0]), this.frame.y(this.fault.at[1]), red, 9, true);
  }

  #drawRing() {
    const { camera, painter } = this.view, { colour } = painter;
    if (this.mode !== "draw") return;
    const places = this.ring.map(([x, y]) => [this.frame.x(x), this.frame.y(y)]);
    places.forEach((place, i) => {
      if (i) painter.segment(camera, ...places[i - 1], ...place, colour.step, 2.5);
      painter.dot(camera, ...place, colour.step, i ? 4.5 : 7);
    });
    if (!this.pointer) return;
    const next = [this.frame.x(this.pointer[0]), this.frame.y(this.pointer[1])];
    if (places.length) painter.segment(camera, ...places.at(-1), ...next, colour.step, 1.5, [5, 4]);
    painter.dot(camera, ...next, colour.step, 5, true);
  }

  /* --- pointer and keys --- */

  /** The lattice point nearest to a pixel, as exact texts. */
  #snapped(px, py) {
    return this.lattice.nearest(this.frame.point(this.view.camera.toPlaneX(px), this.view.camera.toPlaneY(py)));
  }

  #vertexNear(px, py) {
    const { camera } = this.view;
    let best = -1, least = Editor.REACH;
    this.drawing.state.vertices.forEach((_, v) => {
      const [x, y] = this.#place(v), distance = Math.hypot(camera.toScreenX(x) - px, camera.toScreenY(y) - py);
      if (distance < least) [best, least] = [v, distance];
    });
    return best;
  }

  #down(px, py) {
    if (this.mode !== "move") return false;
    const v = this.#vertexNear(px, py);
    if (v < 0) return false;
    this.#choose(v);
    this.dragged = false;
    return true;
  }

  #drag(px, py) {
    this.#moveChosen(this.#snapped(px, py), this.dragged);
  }

  #drop() {
    if (this.dragged) this.changed(true);
    this.dragged = false;
  }

  #moveChosen(place, continues) {
    if (String(place) === String(this.drawing.state.vertices[this.chosen])) return;
    this.drawing.move(this.chosen, place, continues);
    this.dragged = true;
    this.#choose(this.chosen);
    this.changed(false);
  }

  #hover(px, py) {
    const outside = px === null || px === undefined;
    this.pointer = outside ? null : this.#snapped(px, py);
    this.hovered = this.mode === "draw" ? null : itemAt(this.view, px, py);
    const lines = [];
    if (this.pointer) lines.push(`lattice point (${this.pointer.join(", ")})`);
    if (this.hovered) lines.push(new Describer(this.view.scene).line(this.hovered));
    this.$("under").textContent = lines.join(" · ");
    this.view.redrawTop();
  }

  #pick(px, py) {
    if (px === null || px === undefined) {
      this.ring = [];
      this.#choose(-1);
      this.picked = this.marks = null;
      this.#details(null);
    } else if (this.mode === "draw") {
      this.#addCorner(this.#snapped(px, py));
    } else {
      this.#choose(-1);
      this.picked = itemAt(this.view, px, py);
      this.marks = null;
      this.#details(this.picked ? new Describer(this.view.scene).details(this.picked) : null);
    }
    this.view.redrawTop();
  }

  #choose(v) {
    this.chosen = v;
    this.#buttons();
    if (v >= 0) this.$("under").textContent = `vertex ${v}: (${this.drawing.state.vertices[v].join(", ")})`;
    this.view.redrawTop();
  }

  #addCorner(place) {
    const same = corner => String(corner) === String(place);
    if (this.ring.length >= 3 && same(this.ring[0])) this.closeRing();
    else if (!this.ring.some(same)) this.ring = [...this.ring, place];
    this.#buttons();
  }

  closeRing() {
    if (this.ring.length < 3) return;
    this.drawing.addRing(this.ring);
    this.setMode("move");
    this.changed(true);
  }

  split() {
    if (this.chosen < 0) return;
    const e = this.drawing.edgeFrom(this.chosen);
    if (e < 0) return;
    const { vertices, edges } = this.drawing.state, [u, v] = edges[e], half = new Rational(1n, 2n);
    const middle = [0, 1].map(i => Rational.parse(vertices[u][i]).plus(Rational.parse(vertices[v][i])).times(half));
    this.#choose(this.drawing.split(e, middle.map(String)));
    this.changed(true);
  }

  remove() {
    if (this.chosen < 0) return;
    this.drawing.remove(this.chosen);
    this.#choose(-1);
    this.changed(true);
  }

  clear() {
    this.drawing.change({ vertices: [], edges: [], holes: [], name: "" });
    this.setMode("draw");
    this.changed(true);
  }

  undo() {
    if (this.ring.length) this.ring = this.ring.slice(0, -1);
    else if (this.drawing.undo()) this.changed(true);
    this.#buttons();
    this.view.redrawTop();
  }

  redo() {
    if (this.drawing.redo()) this.changed(true);
  }

  #step(offset) {
    const count = this.drawing.state.vertices.length;
    if (count) this.#choose(((this.chosen < 0 && offset < 0 ? 0 : this.chosen) + offset + count) % count);
  }

  /** Takes a key when it is one of the editor's. */
  #key(event) {
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (arrows && this.chosen >= 0) {
      this.#moveChosen(this.lattice.moved(this.drawing.state.vertices[this.chosen], ...arrows), false);
      this.changed(true);
      return true;
    }
    const action = { m: () => this.setMode("move"), d: () => this.setMode("draw"), c: () => this.closeRing(),
                     i: () => this.split(), u: () => this.undo(), r: () => this.redo(), n: () => this.#step(1),
                     p: () => this.#step(-1), Delete: () => this.remove(), Backspace: () => this.remove() }[event.key];
    action?.();
    return Boolean(action);
  }

  #listen() {
    const click = (id, action) => this.$(id).addEventListener("click", action);
    click("move", () => this.setMode("move"));
    click("draw", () => this.setMode("draw"));
    click("close", () => this.closeRing());
    click("split", () => this.split());
    click("delete", () => this.remove());
    click("clear", () => this.clear());
    click("undo", () => this.undo());
    click("redo", () => this.redo());
    click("download", () => this.#download());
    click("save", () => this.#save());
    click("zoom-in", () => this.view.zoom(View.ZOOM));
    click("zoom-out", () => this.view.zoom(1 / View.ZOOM));
    click("fit", () => this.#goHome(true));
    click("unchoose", () => this.#pick(null));
    this.$("save").hidden = !this.settings.saves;
    this.$("spacing").addEventListener("input", event => {
      const spacing = Rational.parse(event.target.value), ok = spacing !== null && spacing.n > 0n;
      event.target.setAttribute("aria-invalid", String(!ok));
      if (ok) this.lattice = new Lattice(spacing.reduced());
      this.view.redrawTop();
    });
    this.$("which").addEventListener("change", event => {
      this.which = event.target.value;
      this.marks = null;
      this.#steps();
    });
    this.$("step").addEventListener("change", () => this.#drawStep());
  }

  #download() {
    const blob = new Blob([JSON.stringify(this.drawing.json(), null, 1), "\n"], { type: "application/json" });
    const link = make("a", { href: URL.createObjectURL(blob), download: "polygon.json" });
    link.click();
    URL.revokeObjectURL(link.href);
  }

  async #save() {
    try {
      const answer = await this.#post("/save", JSON.stringify(this.drawing.json()));
      this.#say(`saved to ${(await answer.json()).saved}`);
    } catch (error) {
      this.#say(`not saved: ${error.message}`, true);
    }
  }
}

const editor = new Editor(JSON.parse(document.getElementById("data").textContent));
