"use strict";
/* Fills convex polygons into a buffer of pixels. Paths of a canvas take ten times as long for 50,000 faces, and differ
   from machine to machine; here a pixel has the colour of the face its middle lies in. */

class Raster {
  constructor() {
    this.resize(1, 1);
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.low = new Float64Array(height);
    this.high = new Float64Array(height);
  }

  clear(colour) {
    this.pixels.fill(colour);
  }

  /** Fills the convex polygon with the first `count` corners of `xs`, `ys`, in pixels. */
  fill(xs, ys, count, colour) {
    const { low, high, pixels, width } = this;
    let least = ys[0], greatest = ys[0];
    for (let i = 1; i < count; i++) {
      if (ys[i] < least) least = ys[i];
      else if (ys[i] > greatest) greatest = ys[i];
    }
    const top = Math.max(0, Math.ceil(least - 0.5)), bottom = Math.min(this.height, Math.ceil(greatest - 0.5));
    if (top >= bottom) return;
    low.fill(Infinity, top, bottom);
    high.fill(-Infinity, top, bottom);
    for (let i = 0, j = count - 1; i < count; j = i++) {
      let x = xs[j], y = ys[j], farX = xs[i], farY = ys[i];
      if (y > farY) [x, y, farX, farY] = [farX, farY, x, y];
      const start = Math.max(top, Math.ceil(y - 0.5)), end = Math.min(bottom, Math.ceil(farY - 0.5));
      const slope = (farX - x) / (farY - y);
      for (let row = start; row < end; row++) {
        const at = x + (row + 0.5 - y) * slope;
        if (at < low[row]) low[row] = at;
        if (at > high[row]) high[row] = at;
      }
    }
    for (let row = top; row < bottom; row++) {
      const from = Math.max(0, Math.ceil(low[row] - 0.5)), to = Math.min(width, Math.ceil(high[row] - 0.5));
      if (to - from > 16) pixels.fill(colour, row * width + from, row * width + to);
      else for (let k = row * width + from, end = row * width + to; k < end; k++) pixels[k] = colour;
    }
  }
}
