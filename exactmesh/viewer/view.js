"use strict";
/* A drawing on the page: its two canvases, its camera, and what pointer, wheel and keys do to them.

   Hooks, set by the page: `onHover(place)` and `onPick(place)` with a place of the plane in pixels, `drawTop()` for what
   goes on the top canvas, `tool` for pages that edit: each of its `down`, `move`, `up`, `key` may take an event by
   returning true. */

class View {
  static STEP = 60;
  static ZOOM = 1.3;
  /** While something moves, a picture that takes longer than this many milliseconds is moved instead of drawn again. */
  static SLOW = 14;

  constructor(stage) {
    this.stage = stage;
    this.ground = stage.querySelector(".ground");
    this.top = stage.querySelector(".top");
    this.camera = new Camera();
    this.painter = new Painter(this.ground, this.top);
    this.scene = null;
    this.step = null;
    this.home = [-1, -1, 1, 1];
    this.margin = 0.06;
    this.isHome = true;
    this.pointers = new Map();
    this.keyboard = false;
    this.cost = 0;
    this.frames = 0;
    this.moved = 0;
    this.snapshot = null;
    this.flight = null;
    this.onHover = this.onPick = this.drawTop = () => {};
    this.tool = null;
    this.#listen();
    new ResizeObserver(() => this.resize()).observe(stage);
    this.resize();
  }

  /** Shows a scene at one of its stages; the camera stays. */
  setScene(scene, step) {
    this.scene = scene;
    this.step = step;
    this.redraw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.stage;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.camera.width = Math.max(1, width);
    this.camera.height = Math.max(1, height);
    this.painter.resize(this.camera.width, this.camera.height, ratio);
    if (this.isHome) this.fit(false);
    this.redraw();
  }

  /** Draws everything again with the next frame. */
  redraw() {
    this.stale = true;
    this.#request();
  }

  /** Draws only the top canvas again with the next frame. */
  redrawTop() {
    this.#request();
  }

  /** Draws the ground once and returns the milliseconds it took. */
  paintNow() {
    const start = performance.now();
    this.painter.drawGround(this.scene, this.camera, this.step);
    this.cost = performance.now() - start;
    this.stale = false;
    this.snapshot = null;
    this.drawn = { ...this.#pose() };
    this.frames++;
    return this.cost;
  }

  /** Shows all; as long as nobody moves the camera it stays so when the window changes. */
  fit(fly = true) {
    this.flyTo(this.camera.showing(this.home, this.margin), fly);
    this.isHome = true;
  }

  /** Goes to a pose of the camera: at once, or over a third of a second for those who do not mind things moving. */
  flyTo(pose, fly = true) {
    this.flight = null;
    this.isHome = false;
    if (!fly || matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.camera.moveTo(pose);
    } else {
      this.flight = { from: this.#pose(), to: pose, start: performance.now() };
    }
    this.redraw();
  }

  /** Flies to a box, shown large enough to be seen and with its surroundings. */
  flyToBox(box, share = 0.22) {
    const least = 1e-13, [x0, y0, x1, y1] = box, size = Math.max(x1 - x0, y1 - y0);
    const pose = this.camera.showing(size > least ? box : [x0 - 0.01, y0 - 0.01, x1 + 0.01, y1 + 0.01], share);
    this.flyTo(pose);
  }

  pan(dx, dy) {
    this.flight = null;
    this.camera.panBy(dx, dy);
    this.#movedNow();
  }

  zoom(factor, px, py) {
    this.flight = null;
    this.camera.zoomBy(factor, px, py);
    this.#movedNow();
  }

  /** The place the keyboard speaks of: the middle of the window. */
  cross() {
    return [this.camera.width / 2, this.camera.height / 2];
  }

  #pose() {
    return { x: this.camera.x, y: this.camera.y, scale: this.camera.scale };
  }

  #movedNow() {
    this.isHome = false;
    this.moved = performance.now();
    this.redraw();
    if (this.keyboard) this.onHover(...this.cross());
  }

  #request() {
    this.pending ??= requestAnimationFrame(now => {
      this.pending = null;
      this.#frame(now);
    });
  }

  #frame(now) {
    if (this.flight) this.#fly(now);
    const moving = this.flight !== null || now - this.moved < 120;
    if (this.stale && moving && this.cost > View.SLOW && this.drawn) {
      this.#moveSnapshot();
      this.redraw();
    } else if (this.stale) {
      this.paintNow();
    }
    this.painter.clearTop();
    this.drawTop();
    if (this.keyboard) this.#drawCross();
    if (this.flight) this.redraw();
  }

  #moveSnapshot() {
    if (!this.snapshot) {
      const { ground } = this;
      this.snapshot = new OffscreenCanvas(ground.width, ground.height);
      this.snapshot.getContext("2d").drawImage(ground, 0, 0);
      this.from = Object.assign(new Camera(), this.camera, this.drawn);
    }
    this.painter.moveGround(this.snapshot, this.from, this.camera);
  }

  #fly(now) {
    const { from, to, start } = this.flight, t = Math.min(1, (now - start) / 350), eased = t * t * (3 - 2 * t);
    const scale = from.scale * (to.scale / from.scale) ** eased;
    /* The place moves with the zoom, so that the target does not run out of the window on the way. */
    const share = to.scale === from.scale ? eased : (1 / scale - 1 / from.scale) / (1 / to.scale - 1 / from.scale);
    this.camera.moveTo(t === 1 ? to : { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share, scale });
    this.stale = true;
    if (t === 1) this.flight = null;
  }

  #drawCross() {
    const [x, y] = this.cross(), { top, colour } = this.painter;
    top.strokeStyle = colour.hover;
    top.lineWidth = 1.5;
    top.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      top.moveTo(x + 4 * dx, y + 4 * dy);
      top.lineTo(x + 12 * dx, y + 12 * dy);
    }
    top.stroke();
  }

  #listen() {
    const { top } = this, at = event => {
      const box = top.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    top.addEventListener("pointerdown", event => {
      this.#useKeyboard(false);
      top.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { at: at(event), travelled: 0 });
      if (this.pointers.size === 1 && event.button === 0 && this.tool?.down(...at(event), event)) {
        this.pointers.get(event.pointerId).taken = true;
      }
    });
    top.addEventListener("pointermove", event => this.#pointerMoved(event, at(event)));
    const released = event => {
      const pointer = this.pointers.get(event.pointerId), alone = this.pointers.size === 1;
      this.pointers.delete(event.pointerId);
      if (!pointer) return;
      if (pointer.taken) this.tool?.up(...at(event), event);
      else if (alone && event.type === "pointerup" && event.button === 0 && pointer.travelled < 5) this.onPick(...at(event));
    };
    top.addEventListener("pointerup", released);
    top.addEventListener("pointercancel", released);
    top.addEventListener("pointerleave", () => { if (!this.pointers.size) this.onHover(null); });
    top.addEventListener("wheel", event => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      this.zoom(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0018)), ...at(event));
    }, { passive: false });
    top.addEventListener("keydown", event => this.#key(event));
    top.addEventListener("focus", () => { if (top.matches(":focus-visible")) this.#useKeyboard(true); });
    top.addEventListener("blur", () => this.#useKeyboard(false));
  }

  #pointerMoved(event, place) {
    const pointer = this.pointers.get(event.pointerId);
    if (!pointer) {
      this.onHover(...place);
      return;
    }
    const [x, y] = pointer.at;
    pointer.travelled += Math.abs(place[0] - x) + Math.abs(place[1] - y);
    if (pointer.taken) {
      this.tool?.move(...place, event);
    } else if (this.pointers.size === 2) {
      const other = [...this.pointers.values()].find(one => one !== pointer).at;
      const before = Math.hypot(x - other[0], y - other[1]), after = Math.hypot(place[0] - other[0], place[1] - other[1]);
      this.pan((place[0] - x) / 2, (place[1] - y) / 2);
      if (before > 0 && after > 0) this.zoom(after / before, (place[0] + other[0]) / 2, (place[1] + other[1]) / 2);
    } else if (this.pointers.size === 1) {
      this.pan(place[0] - x, place[1] - y);
    }
    pointer.at = place;
  }

  #useKeyboard(is) {
    if (this.keyboard === is) return;
    this.keyboard = is;
    if (is) this.onHover(...this.cross());
    else this.onHover(null);
    this.redrawTop();
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    this.#useKeyboard(true);
    if (!this.tool?.key(event) && !this.#moveByKey(event.key, event.shiftKey ? View.STEP / 6 : View.STEP)) return;
    event.preventDefault();
  }

  #moveByKey(key, step) {
    switch (key) {
      case "ArrowLeft": this.pan(step, 0); return true;
      case "ArrowRight": this.pan(-step, 0); return true;
      case "ArrowUp": this.pan(0, step); return true;
      case "ArrowDown": this.pan(0, -step); return true;
      case "+": case "=": this.zoom(View.ZOOM); return true;
      case "-": case "_": this.zoom(1 / View.ZOOM); return true;
      case "0": case "Home": this.fit(); return true;
      case "Enter": this.onPick(...this.cross()); return true;
      case "Escape": this.onPick(null); return true;
    }
    return false;
  }
}
