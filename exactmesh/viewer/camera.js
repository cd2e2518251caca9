"use strict";
/* Which part of the plane is seen: the point (x, y) is in the middle, `scale` pixels are a unit of length. */

class Camera {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.scale = 1;
    this.width = 1;
    this.height = 1;
    this.least = 1e-3;
    this.greatest = 1e13;
  }

  toScreenX(x) {
    return (x - this.x) * this.scale + this.width / 2;
  }

  toScreenY(y) {
    return this.height / 2 - (y - this.y) * this.scale;
  }

  toPlaneX(px) {
    return this.x + (px - this.width / 2) / this.scale;
  }

  toPlaneY(py) {
    return this.y + (this.height / 2 - py) / this.scale;
  }

  /** The part of the plane that is seen, with a margin in pixels: least x, least y, greatest x, greatest y. */
  window(margin = 0) {
    return [this.toPlaneX(-margin), this.toPlaneY(this.height + margin), this.toPlaneX(this.width + margin),
            this.toPlaneY(-margin)];
  }

  panBy(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Zooms about the pixel (px, py), which keeps its place. */
  zoomBy(factor, px = this.width / 2, py = this.height / 2) {
    const x = this.toPlaneX(px), y = this.toPlaneY(py);
    this.scale = Math.min(this.greatest, Math.max(this.least, this.scale * factor));
    this.x = x - (px - this.width / 2) / this.scale;
    this.y = y + (py - this.height / 2) / this.scale;
  }

  /** Where the camera shows a box with a margin of `share` of the window on each side. */
  showing(box, share = 0.06) {
    const [x0, y0, x1, y1] = box, room = 1 - 2 * share;
    const scale = Math.min(this.width * room / Math.max(x1 - x0, Number.MIN_VALUE),
                           this.height * room / Math.max(y1 - y0, Number.MIN_VALUE));
    return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: Math.min(this.greatest, Math.max(this.least, scale)) };
  }

  moveTo({ x, y, scale }) {
    Object.assign(this, { x, y, scale });
  }
}
