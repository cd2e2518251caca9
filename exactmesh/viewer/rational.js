"use strict";
/* Exact rationals, as texts and as pairs of BigInts. Floats are made of them to draw, and decide nothing. */

class Rational {
  /** numerator / denominator with denominator > 0; not reduced until it is spelled. */
  constructor(numerator, denominator = 1n) {
    this.n = numerator;
    this.d = denominator;
  }

  /** The integer, finite decimal or fraction that a text spells; null for anything else. */
  static parse(text) {
    const match = /^\s*([+-]?)(\d+)(?:\.(\d+)|\/(\d+))?\s*$/.exec(text);
    if (!match || (match[4] && !/[1-9]/.test(match[4]))) return null;
    const sign = match[1] === "-" ? -1n : 1n;
    if (match[4]) return new Rational(sign * BigInt(match[2]), BigInt(match[4]));
    const part = match[3] ?? "";
    return new Rational(sign * BigInt(match[2] + part), 10n ** BigInt(part.length));
  }

  minus(other) {
    return new Rational(this.n * other.d - other.n * this.d, this.d * other.d);
  }

  plus(other) {
    return new Rational(this.n * other.d + other.n * this.d, this.d * other.d);
  }

  times(other) {
    return new Rational(this.n * other.n, this.d * other.d);
  }

  /** The whole number nearest to this over `step` > 0; the greater one on a tie. */
  steps(step) {
    const n = 2n * this.n * step.d + this.d * step.n, d = 2n * this.d * step.n;
    return n >= 0n || n % d === 0n ? n / d : n / d - 1n;
  }

  reduced() {
    let a = this.n < 0n ? -this.n : this.n, b = this.d;
    while (b) [a, b] = [b, a % b];
    return new Rational(this.n / a, this.d / a);
  }

  toString() {
    const { n, d } = this.reduced();
    return d === 1n ? `${n}` : `${n}/${d}`;
  }

  /** A double near the value, also where numerator and denominator are beyond all doubles. */
  toNumber() {
    let n = Number(this.n), d = Number(this.d);
    if (Number.isFinite(n) && Number.isFinite(d)) return n / d;
    const excess = BigInt(Math.max(this.n.toString(16).length, this.d.toString(16).length) * 4 - 1000);
    n = Number(this.n >> excess);
    d = Number(this.d >> excess);
    return d ? n / d : Math.sign(n) * Number.MAX_VALUE;
  }

  /** The rational that is exactly a finite double. */
  static fromNumber(value) {
    let exponent = 0n;
    while (!Number.isInteger(value)) {
      value *= 2;
      exponent++;
    }
    return new Rational(BigInt(value), 1n << exponent);
  }
}

/** Six digits of a double, for reading. */
function shortNumber(value) {
  return String(Number(value.toPrecision(6)));
}

/** Six digits of the square root of the rational that `text` spells, for reading. */
function rootNumber(text) {
  return shortNumber(Math.sqrt(Rational.parse(text).toNumber()));
}
