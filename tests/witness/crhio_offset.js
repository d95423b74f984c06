// SPDX-License-Identifier: GPL-3.0-or-later
//
// Equidistants of random contours of lines and arcs, round joins, held against those of the npm
// package @crhio/offset, which has arcs of its own and shares nothing with this project:
//
//   npm install --prefix DIR @crhio/offset@0.0.13
//   NODE_PATH=DIR/node_modules node crhio_offset.js path/to/dgt [contours] [seed]
//
// Per contour: as many loops, and of each the area and the length to 1e-9 of the contour's. Where
// the two disagree the curves are judged in plain floating point, place by place, by their distance
// from the contour, which on both must be the offset: one curve that comes nearer, or ends, or
// leaves out a loop that keeps the distance, is wrong. It fails when a disagreement is ours, or
// nobody's. Without the package the test is skipped (77).
'use strict';

const { spawnSync } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

let outsider;
try {
  outsider = require('@crhio/offset');
  outsider = outsider.default || outsider;
} catch {
  console.log('skipped: the package @crhio/offset is not installed');
  process.exit(77);
}

const [dgt, contours = '1000', seed = '1'] = process.argv.slice(2);

/** mulberry32: the same numbers for the same seed on every machine. */
function numbers(state) {
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const rounded = (v, digits) => Number(v.toFixed(digits));

/** A star about the origin; half of its sides are arcs of at most a third of a turn. */
function star(random) {
  const n = 5 + Math.floor(random() * 40);
  const vertices = [];
  for (let i = 0; i < n; ++i) {
    const angle = (2 * Math.PI * (i + 0.6 * random())) / n;
    const r = 20 + 30 * random();
    const bulge = random() < 0.5 ? 0 : rounded((random() - 0.5) * 0.5, 4);
    vertices.push({ x: rounded(r * Math.cos(angle), 4), y: rounded(r * Math.sin(angle), 4), bulge });
  }
  return vertices;
}

/** A comb of slots with half-round grounds. */
function slots(random) {
  const n = 1 + Math.floor(random() * 6);
  const width = rounded(2 + 4 * random(), 2);
  const vertices = [{ x: 0, y: -20, bulge: 0 }];
  const pitch = rounded(2 * width + 1 + random(), 2);
  vertices.push({ x: rounded(n * pitch + width, 2), y: -20, bulge: 0 });
  vertices.push({ x: rounded(n * pitch + width, 2), y: 0, bulge: 0 });
  for (let i = n - 1; i >= 0; --i) {
    const x = rounded(i * pitch + width, 2);
    const depth = rounded(-5 - 8 * random(), 2);
    vertices.push({ x: rounded(x + width, 2), y: 0, bulge: 0 });
    vertices.push({ x: rounded(x + width, 2), y: depth, bulge: -1 });
    vertices.push({ x, y: depth, bulge: 0 });
    vertices.push({ x, y: 0, bulge: 0 });
  }
  vertices.push({ x: 0, y: 0, bulge: 0 });
  return vertices;
}

/** A rectangle with fillets, tangent to a few decimals. */
function rounds(random) {
  const w = rounded(20 + 40 * random(), 1);
  const h = rounded(20 + 40 * random(), 1);
  const r = rounded(1 + 8 * random(), 1);
  const b = Math.tan(Math.PI / 8);
  const at = (x, y, bulge) => ({ x: rounded(x, 6), y: rounded(y, 6), bulge });
  return [at(r, 0, 0), at(w - r, 0, b), at(w, r, 0), at(w, h - r, b), at(w - r, h, 0),
    at(r, h, b), at(0, h - r, 0), at(0, r, b)];
}

// --- measures -----------------------------------------------------------------------------------

/** The pieces of a closed polyline with bulges: {ax, ay, bx, by} and for arcs {cx, cy, r, from, sweep}. */
function pieces(vertices, closed = true) {
  const list = [];
  const last = closed ? vertices.length : vertices.length - 1;
  for (let i = 0; i < last; ++i) {
    const a = vertices[i];
    const b = vertices[(i + 1) % vertices.length];
    const piece = { ax: a.x, ay: a.y, bx: b.x, by: b.y };
    const bulge = a.bulge || 0;
    if (Math.abs(bulge) > 1e-12) {
      const dx = b.x - a.x;
      const dy = b.y - a.y;
      const k = (1 - bulge * bulge) / (4 * bulge);
      piece.cx = (a.x + b.x) / 2 - k * dy;
      piece.cy = (a.y + b.y) / 2 + k * dx;
      piece.r = Math.hypot(a.x - piece.cx, a.y - piece.cy);
      piece.from = Math.atan2(a.y - piece.cy, a.x - piece.cx);
      piece.sweep = 4 * Math.atan(bulge);
    }
    list.push(piece);
  }
  return list;
}

function measure(list) {
  let area = 0;
  let length = 0;
  for (const p of list) {
    area += (p.ax * p.by - p.bx * p.ay) / 2;
    if (p.r === undefined) {
      length += Math.hypot(p.bx - p.ax, p.by - p.ay);
    } else {
      area += (p.r * p.r * (p.sweep - Math.sin(p.sweep))) / 2;
      length += p.r * Math.abs(p.sweep);
    }
  }
  return { area, length };
}

function distance_to(p, x, y) {
  const ends = Math.min(Math.hypot(x - p.ax, y - p.ay), Math.hypot(x - p.bx, y - p.by));
  if (p.r === undefined) {
    const dx = p.bx - p.ax;
    const dy = p.by - p.ay;
    const t = ((x - p.ax) * dx + (y - p.ay) * dy) / (dx * dx + dy * dy);
    return t <= 0 || t >= 1 ? ends : Math.abs((x - p.ax) * dy - (y - p.ay) * dx) / Math.hypot(dx, dy);
  }
  const turn = 2 * Math.PI;
  let along = Math.atan2(y - p.cy, x - p.cx) - p.from;
  along = p.sweep > 0 ? ((along % turn) + turn) % turn : ((-along % turn) + turn) % turn;
  if (along > Math.abs(p.sweep)) return ends;
  return Math.abs(Math.hypot(x - p.cx, y - p.cy) - p.r);
}

/** How far the curve strays from the offset: most too near, most too far; places along each piece. */
function strays(loops, source, offset) {
  let near = 0;
  let far = 0;
  for (const p of loops.flat()) {
    for (let k = 0; k < 16; ++k) {
      const t = (k + 0.5) / 16;
      const angle = p.r === undefined ? 0 : p.from + t * p.sweep;
      const x = p.r === undefined ? p.ax + t * (p.bx - p.ax) : p.cx + p.r * Math.cos(angle);
      const y = p.r === undefined ? p.ay + t * (p.by - p.ay) : p.cy + p.r * Math.sin(angle);
      let least = Infinity;
      for (const s of source) least = Math.min(least, distance_to(s, x, y));
      near = Math.max(near, offset - least);
      far = Math.max(far, least - offset);
    }
  }
  return { near, far };
}

// --- both engines -------------------------------------------------------------------------------

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'dgt-crhio-'));
const file = path.join(folder, 'part.poly');

/** Nothing where the contour is refused, since it crosses itself. */
function of_dgt(vertices, offset) {
  fs.writeFileSync(file, vertices.map((v) => `${v.x} ${v.y} ${v.bulge}\n`).join(''));
  const run = spawnSync(dgt, ['offset', file, '--distance', String(offset), '--corner', 'round']);
  if (run.status === 1 && run.stderr.toString().includes(' crosses itself')) return null;
  if (run.status !== 0) throw new Error(run.stderr.toString());
  return JSON.parse(run.stdout).loops.map((loop) =>
    loop.moves.map((m) => {
      const piece = { ax: m.from[0], ay: m.from[1], bx: m.to[0], by: m.to[1] };
      if (m.kind !== 'arc') return piece;
      [piece.cx, piece.cy] = m.center;
      piece.r = m.radius;
      piece.from = Math.atan2(piece.ay - piece.cy, piece.ax - piece.cx);
      piece.sweep = (m.sweep * Math.PI) / 180;
      return piece;
    }));
}

function of_outsider(vertices, offset) {
  const loops = outsider({ vertexes: vertices, isClosed: true }, offset, false);
  return (Array.isArray(loops) ? loops : []).map((l) => ({
    closed: l.isClosed !== false,
    list: pieces(l.vertexes.map((v) => ({ x: v.x, y: v.y, bulge: v.bulge })), l.isClosed !== false),
  }));
}

const sorted = (loops) => loops.map(measure).sort((a, b) => a.area - b.area || a.length - b.length);

function agree(ours, theirs, scale) {
  if (ours.length !== theirs.length) return false;
  return ours.every((o, i) =>
    Math.abs(o.area - theirs[i].area) <= 1e-9 * scale.area &&
    Math.abs(o.length - theirs[i].length) <= 1e-9 * scale.length);
}

/** Below what the judgement in floating point can see, mm. */
const kSeen = 1e-6;

function explain(ours, theirs, source, offset) {
  const us = strays(ours, source, Math.abs(offset));
  const them = strays(theirs.map((t) => t.list), source, Math.abs(offset));
  const ok = us.near < kSeen && us.far < kSeen;
  if (!ok) return { ours: true, why: `ours comes ${us.near.toPrecision(3)} too near, strays ${us.far.toPrecision(3)} away` };
  if (theirs.some((t) => !t.closed)) return { why: 'theirs leaves a loop open' };
  if (them.near > kSeen) return { why: `theirs comes ${them.near.toPrecision(3)} too near` };
  if (them.far > kSeen) return { why: `theirs strays ${them.far.toPrecision(3)} away` };
  const total = (loops, key) => loops.map(measure).reduce((sum, m) => sum + m[key], 0);
  const lists = theirs.map((t) => t.list);
  const lacking = total(ours, 'length') - total(lists, 'length');
  if (lacking < -kSeen && Math.abs(total(ours, 'area') - total(lists, 'area')) < kSeen)
    return { why: 'theirs runs in and out of a slot exactly as wide as the tool' };
  if (lacking > kSeen) return { why: `theirs lacks ${lacking.toPrecision(3)} of curve that keeps the distance` };
  if (Math.abs(lacking) <= kSeen) return { why: 'the curves agree within 1e-6 and not within 1e-9' };
  return { nobody: true, why: `theirs has ${(-lacking).toPrecision(3)} more that keeps the distance` };
}

// --- the run ------------------------------------------------------------------------------------

const random = numbers(Number(seed));
const families = { star, slots, rounds };
const names = Object.keys(families);
let agreed = 0;
let wrong = 0;
let crossing = 0;  // sides that cross: which side is inside is a matter of definition there
const reasons = new Map();
for (let i = 0; i < Number(contours); ++i) {
  const name = names[i % names.length];
  const vertices = families[name](random);
  const offset = rounded((random() < 0.5 ? -1 : 1) * (0.05 + 4 * random() * random()), 3);
  const source = pieces(vertices);
  const size = measure(source);
  const ours = of_dgt(vertices, offset);
  if (ours === null) {
    ++crossing;
    continue;
  }
  let theirs;
  try {
    theirs = of_outsider(vertices, offset);
  } catch (error) {
    const why = `theirs fails: ${error.message}`;
    reasons.set(why, (reasons.get(why) || 0) + 1);
    continue;
  }
  const scale = { area: Math.abs(size.area), length: size.length };
  if (agree(sorted(ours), sorted(theirs.map((t) => t.list)), scale)) {
    ++agreed;
    continue;
  }
  const verdict = explain(ours, theirs, source, offset);
  if (verdict.ours || verdict.nobody) ++wrong;
  const kind = verdict.why.replace(/[-0-9.e]+(?= )/g, '…');
  reasons.set(`${name}: ${kind}`, (reasons.get(`${name}: ${kind}`) || 0) + 1);
  if (verdict.ours || verdict.nobody || process.env.DGT_VERBOSE) {
    console.log(`contour ${i} (${name}) at ${offset}: ${verdict.why}`);
    console.log(vertices.map((v) => `${v.x} ${v.y} ${v.bulge}`).join('\n'));
  }
}
fs.rmSync(folder, { recursive: true });
console.log(
  `${contours} contours: ${agreed} agree, ${crossing} cross themselves and are left out, ` +
    `${wrong} disagreements that are not theirs`);
for (const [why, count] of [...reasons].sort()) console.log(`  ${count} x ${why}`);
process.exit(wrong === 0 ? 0 : 1);
