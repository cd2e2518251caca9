"use strict";
/* What stands beside the drawing, for the viewer and the editor. Everything from a file goes in as text, never as HTML. */

/** A new element with properties, attributes (`data-` and `aria-`) and children. */
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "role") element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children);
  return element;
}

/** A long exact number for a narrow place; the whole of it is shown where there is room. */
function shortened(text, length = 46) {
  if (text.length <= length) return text;
  return `${text.slice(0, length - 22)}… (${text.length} characters)`;
}

/** An exact number to read and to copy. */
function exact(text) {
  return make("code", { className: "exact", textContent: text, tabIndex: text.length > 60 ? 0 : -1 });
}

/** Lines of names and values. */
function facts(rows) {
  const list = make("dl");
  for (const [name, ...values] of rows) list.append(make("dt", { textContent: name }), make("dd", {}, ...values));
  return list;
}

/** Follows the system's light or dark until the reader chooses; `changed` is called after each change. */
class Theme {
  constructor(button, changed) {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    this.button = button;
    this.changed = changed;
    this.set(dark.matches ? "dark" : "light");
    dark.addEventListener("change", () => { if (!this.chosen) this.set(dark.matches ? "dark" : "light"); });
    button.addEventListener("click", () => {
      this.chosen = true;
      this.set(this.name === "dark" ? "light" : "dark");
    });
  }

  set(name) {
    this.name = name;
    document.documentElement.dataset.theme = name;
    this.button.setAttribute("aria-pressed", String(name === "dark"));
    this.changed();
  }
}

/** Tells what a vertex or face is, exactly. */
class Describer {
  constructor(scene) {
    this.scene = scene;
    this.data = scene.data;
  }

  /** One line for the pointer. */
  line(item) {
    if (item.vertex !== undefined) {
      const [x, y] = this.#coordinates(item.vertex);
      return `${this.#vertexTitle(item.vertex)}: x = ${shortened(x)}, y = ${shortened(y)}`;
    }
    const feature = this.data.features[item.face];
    const size = feature === null ? "not a triangle"
      : `feature size ≈ ${rootNumber(feature)}, squared exactly ${shortened(feature)}`;
    return `face ${item.face} of vertices ${this.data.faces[item.face].join(", ")}: ${size}`;
  }

  /** Everything about an item, as elements. */
  details(item) {
    if (item.vertex !== undefined) {
      const [x, y] = this.#coordinates(item.vertex);
      return [make("h3", { textContent: this.#vertexTitle(item.vertex) }), facts([["x", exact(x)], ["y", exact(y)]])];
    }
    const face = this.data.faces[item.face], feature = this.data.features[item.face];
    const rows = [["vertices", face.join(", ")]];
    if (feature === null) rows.push(["feature size", "none: this is not a counter-clockwise triangle"]);
    else rows.push(["feature size", `≈ ${rootNumber(feature)}`], ["squared", exact(feature)]);
    for (const v of face) rows.push([`vertex ${v}`, exact(`(${this.#coordinates(v).join(", ")})`)]);
    return [make("h3", { textContent: `Face ${item.face}` }), facts(rows)];
  }

  #coordinates(v) {
    return v < this.data.vertices ? [this.data.x[v], this.data.y[v]] : this.data.extra[v - this.data.vertices];
  }

  #vertexTitle(v) {
    const kinds = [];
    if (v >= this.data.vertices) return "vertex of a step, not of the mesh";
    if (this.data.given !== null) kinds.push(this.scene.isSteiner(v) ? "Steiner vertex" : "vertex of the input");
    if (this.scene.isT[v]) kinds.push("T-vertex");
    return `vertex ${v}` + (kinds.length ? ` (${kinds.join(", ")})` : "");
  }
}

/** What is under a place in pixels: a vertex near it, else a face, else null. */
function itemAt(view, px, py) {
  const { scene, camera } = view;
  if (!scene || px === null || px === undefined) return null;
  const x = camera.toPlaneX(px), y = camera.toPlaneY(py);
  const vertex = scene.nearestVertex(x, y, 9 / camera.scale);
  if (vertex >= 0) return { vertex };
  const face = scene.faceAt(x, y);
  return face >= 0 ? { face } : null;
}

/** Draws witnesses, marks of a claim, the chosen item and what the pointer is on. */
function drawMarks(view, { sizes = [], marks = null, chosen = null, hovered = null }) {
  const { painter, camera, scene } = view;
  if (!scene) return;
  const { colour } = painter, shown = painter.show.witness ? sizes : [];
  const shade = size => colour[size.of === "mesh" ? "witness" : "input-witness"];
  for (const size of shown) {
    const ends = scene.shortest(size), [a, b] = size.feature;
    if (a !== b) painter.segment(camera, scene.x[a], scene.y[a], scene.x[b], scene.y[b], shade(size), 1.5, [5, 4]);
    painter.segment(camera, ...ends, shade(size), 4);
    painter.dot(camera, ends[0], ends[1], shade(size), 5);
  }
  for (const cycle of marks?.cycles ?? []) painter.cycle(scene, camera, cycle, colour.mark, 3);
  for (const [u, v] of marks?.edges ?? []) {
    painter.segment(camera, scene.x[u], scene.y[u], scene.x[v], scene.y[v], colour.mark, 4);
  }
  for (const v of marks?.vertices ?? []) painter.dot(camera, scene.x[v], scene.y[v], colour.mark, 7, true);
  for (const [x, y] of marks?.points ?? []) painter.dot(camera, scene.frame.x(x), scene.frame.y(y), colour.mark, 7, true);
  for (const [item, width] of [[hovered, 1.5], [chosen, 3]]) {
    if (item?.face !== undefined) painter.cycle(scene, camera, scene.face(item.face), colour.hover, width, 0.15);
    if (item?.vertex !== undefined) painter.dot(camera, scene.x[item.vertex], scene.y[item.vertex], colour.hover, 6, true);
  }
  for (const size of shown) {
    const [x, y] = scene.shortest(size), below = size.of === "mesh";
    painter.label(camera, x, y, `mfs of the ${size.of} ≈ ${size.decimal}`, shade(size), below);
  }
}

/** The claims as buttons: one flies to its witness. */
class ClaimList {
  /** `chosen(claim)` is called when a claim is clicked. */
  constructor(list, summary, filter, chosen) {
    this.list = list;
    this.summary = summary;
    this.chosen = chosen;
    this.filter = filter;
    filter?.addEventListener("change", () => this.set(this.claims));
  }

  set(claims) {
    this.claims = claims;
    const failing = claims.filter(claim => !claim.holds);
    this.summary.textContent = claims.length === 0 ? "no claims: give a report, or the input"
      : `${claims.length - failing.length} of ${claims.length} hold` + (failing.length ? `, ${failing.length} FAIL` : "");
    this.summary.dataset.state = failing.length ? "fails" : claims.length ? "holds" : "none";
    const shown = this.filter?.checked ? failing : [...failing, ...claims.filter(claim => claim.holds)];
    this.list.replaceChildren(...shown.map(claim => make("li", {}, this.#button(claim))));
  }

  #button(claim) {
    const worst = claim.worst ? claim.worst.decimal : "", state = claim.holds ? "holds" : "FAILS";
    const button = make("button", { type: "button", className: "claim", "data-claim": claim.id },
      make("span", { className: "name", textContent: claim.id }),
      make("span", { className: claim.holds ? "state holds" : "state fails", textContent: state }),
      make("span", { className: "bound", textContent: [claim.bound, worst && `worst ${worst}`].filter(Boolean).join(" · ") }));
    button.addEventListener("click", () => {
      this.list.querySelector("[aria-current]")?.removeAttribute("aria-current");
      button.setAttribute("aria-current", "true");
      this.chosen(claim);
    });
    return button;
  }
}

function hasPlace(claim) {
  return Object.values(claim.marks).some(list => list.length > 0);
}

function claimDetails(claim) {
  const rows = [["says", claim.statement], ["from", claim.paper], ["bound", claim.bound || "none: it holds or it does not"],
                ["instances", String(claim.instances)], ["verdict", claim.holds ? "holds" : "FAILS"]];
  if (claim.worst) rows.push(["worst", `≈ ${claim.worst.decimal}`], ["exactly", exact(claim.worst.exact)]);
  if (claim.clause) rows.push(["clause", claim.clause]);
  for (const [name, value] of claim.place) rows.push([name.replaceAll("_", " "), exact(value)]);
  const needsSteps = claim.place.some(([name]) => /^(trapezoid|rectangle|ring|at)$|_of_/.test(name));
  const note = hasPlace(claim) ? [] : [make("p", { textContent: needsSteps
    ? "The report alone does not tell where this is: give the input and --steps." : "This verdict has no place." })];
  return [make("h3", { textContent: claim.id }), facts(rows), ...note];
}

/** The box around the marks of a claim, or null when it has no place. */
function marksBox(scene, marks) {
  return scene.boxOf([...marks.vertices, ...marks.edges.flat(), ...marks.cycles.flat()], marks.points);
}
