"use strict";
/* The viewer's page: a mesh, its claims and its steps. */

class Viewer {
  constructor(data) {
    const $ = id => document.getElementById(id);
    this.data = data;
    this.scene = new Scene(data);
    this.view = new View(document.querySelector(".stage"));
    this.describer = new Describer(this.scene);
    this.chosen = this.hovered = this.marks = null;
    this.view.drawTop = () => drawMarks(this.view, { sizes: this.#sizesNow(), marks: this.marks, chosen: this.chosen,
                                                     hovered: this.hovered });
    this.view.onHover = (x, y) => this.#hover(x, y);
    this.view.onPick = (x, y) => this.choose(itemAt(this.view, x, y));
    this.theme = new Theme($("theme"), () => {
      this.view.painter.readColours();
      this.view.redraw();
    });
    this.claims = new ClaimList($("claims"), $("claims-summary"), $("failing"), claim => this.showClaim(claim));
    this.claims.set(data.claims);
    $("failing-only").hidden = data.claims.every(claim => claim.holds);
    this.#listen($);
    this.#fillIn($);
    this.view.home = this.scene.bounds;
    this.setStep(data.stages.length - 1);
    this.view.fit(false);
  }

  setStep(step) {
    this.step = Math.min(this.data.stages.length - 1, Math.max(0, step));
    const stage = this.data.stages[this.step], slider = document.getElementById("step");
    slider.value = String(this.step);
    slider.setAttribute("aria-valuetext", stage.name);
    document.getElementById("step-name").textContent = `${stage.name}: ${stage.says}`;
    document.getElementById("step-back").disabled = this.step === 0;
    document.getElementById("step-on").disabled = this.step === this.data.stages.length - 1;
    this.view.setScene(this.scene, stage);
  }

  /** Shows what an item is; null lets go of it. */
  choose(item) {
    this.chosen = item;
    this.marks = null;
    this.#details(item ? this.describer.details(item) : null);
    this.view.redrawTop();
  }

  showClaim(claim) {
    this.chosen = null;
    this.marks = claim.marks;
    this.#details(claimDetails(claim));
    const box = marksBox(this.scene, claim.marks);
    if (box) this.view.flyToBox(box);
    this.view.redrawTop();
  }

  showSize(size) {
    const [x0, y0, x1, y1] = this.scene.shortest(size);
    this.view.flyToBox([Math.min(x0, x1), Math.min(y0, y1), Math.max(x0, x1), Math.max(y0, y1)], 0.42);
  }

  find(text) {
    const note = document.getElementById("search-note"), field = document.getElementById("vertex");
    const number = /^\s*\d{1,9}\s*$/.test(text) ? Number(text) : -1, found = number >= 0 && number < this.data.vertices;
    note.textContent = found ? `vertex ${number}` : `There is no vertex ${text.trim() || "without a number"}: they are `
      + `numbered 0 to ${this.data.vertices - 1}.`;
    field.setAttribute("aria-invalid", String(!found));
    if (!found) return;
    this.choose({ vertex: number });
    const reach = this.#surroundings(number), x = this.scene.x[number], y = this.scene.y[number];
    this.view.flyToBox([x - reach, y - reach, x + reach, y + reach], 0.2);
  }

  /** Half the side of a window about a vertex that has the faces around it. */
  #surroundings(v) {
    let reach = 0;
    const { x, y } = this.scene;
    this.scene.edgeTree.search(x[v], y[v], x[v], y[v], e => {
      const [a, b] = this.scene.edges.subarray(2 * e, 2 * e + 2);
      if (a !== v && b !== v) return;
      const length = Math.hypot(x[a] - x[b], y[a] - y[b]);
      reach = reach ? Math.min(reach, 3 * length) : 3 * length;
    });
    return reach || 0.1;
  }

  #sizesNow() {
    const last = this.step === this.data.stages.length - 1;
    return this.data.sizes.filter(size => size.of === "input" || last);
  }

  #hover(x, y) {
    this.hovered = itemAt(this.view, x, y);
    document.getElementById("under").textContent = this.hovered ? this.describer.line(this.hovered) : "";
    this.view.redrawTop();
  }

  #details(elements) {
    document.getElementById("chosen").hidden = !elements;
    document.getElementById("details").replaceChildren(...elements ?? []);
    if (!elements) document.querySelector(".claim[aria-current]")?.removeAttribute("aria-current");
  }

  #listen($) {
    $("zoom-in").addEventListener("click", () => this.view.zoom(View.ZOOM));
    $("zoom-out").addEventListener("click", () => this.view.zoom(1 / View.ZOOM));
    $("fit").addEventListener("click", () => this.view.fit());
    $("step").max = String(this.data.stages.length - 1);
    $("step").addEventListener("input", event => this.setStep(Number(event.target.value)));
    $("step-back").addEventListener("click", () => this.setStep(this.step - 1));
    $("step-on").addEventListener("click", () => this.setStep(this.step + 1));
    $("steps").hidden = this.data.stages.length < 2;
    $("unchoose").addEventListener("click", () => {
      this.choose(null);
      this.view.top.focus();
    });
    $("search").addEventListener("submit", event => {
      event.preventDefault();
      this.find($("vertex").value);
    });
    $("show").addEventListener("change", event => {
      this.view.painter.show[event.target.value] = event.target.checked;
      this.view.redraw();
    });
  }

  #fillIn($) {
    const { data } = this, steiner = data.given === null ? "" : `, ${data.vertices - data.given} of them Steiner vertices`;
    $("counts").textContent = `${data.kind} mesh: ${data.faces.length} faces, ${data.vertices} vertices${steiner}, `
      + `${data.t_vertices.length} T-vertices`;
    const rows = data.sizes.map(size => {
      const to = size.feature[0] === size.feature[1] ? `vertex ${size.feature[0]}` : `edge (${size.feature.join(", ")})`;
      const button = make("button", { type: "button", textContent: `vertex ${size.vertex} and ${to}`,
                                      "aria-label": `Show the mfs of the ${size.of}`, "data-size": size.of });
      button.addEventListener("click", () => this.showSize(size));
      return [`mfs of the ${size.of}`, `≈ ${size.decimal} `, button, exact(`squared ${size.squared}`)];
    });
    if (data.degradation) {
      rows.push(["degradation", `≈ ${data.degradation.decimal}`, exact(`squared ${data.degradation.squared}`)]);
    }
    $("sizes").append(facts(rows));
    const names = ["all of it or more", "1/2", "1/4", "1/8", "1/16", "1/32", "less"];
    $("legend").append(make("p", { textContent: `Feature size of a face over the ${data.reference}:` }), make("ol", {},
      ...names.map((name, i) => make("li", {}, make("i", { "data-shade": String(i) }), name))));
  }
}

const viewer = new Viewer(JSON.parse(document.getElementById("data").textContent));
