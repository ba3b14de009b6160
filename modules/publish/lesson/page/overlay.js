// What lies over the picture: names with their lines, handles, measurements, the scale.
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let lastBehind = 0, stale = false; const kFacing = 0.12, kTouch = 28, kMouse = 16, kSolid = 0.9, kTried = 6, apart = (v, w) => Math.hypot(...[0, 1, 2].map(i => points[3 * v + i] - points[3 * w + i]));
const nameItems = surfaces.flatMap(s => {
  const parts = s.labels.map(({text, vertex, ring}) => ({s, text, vertex, ring, part: true}));
  return parts.length && (s.wall || surfaces.length === 1) ? parts : [{s, text: s.title}, ...parts];
});
for (const item of nameItems) $('names').append(item.box = Object.assign(element('span', item.text, item.part ? 'name part' : 'name'), {dir: 'auto'}));
/** Of a whole surface: places that face the eye and lie away from the other surfaces, which may stand before it, and from its named parts; the best first. */
function bestAnchors(s, middles) {
  const worthOf = v => {
    const p = project(placeOf(v));
    let worth = Math.min(facing(s, v), 0.5) * size[1] * (s.wall ? 0.2 : 0.8) + (s.wall ? -p[1] : 0);
    for (const [other, m] of middles) if (other !== s && !other.wall) worth += Math.hypot(p[0] - m[0], p[1] - m[1]) * (s.wall ? 0.3 : 1);
    return worth;
  };
  return s.free.filter(v => facing(s, v) > kFacing && !isCutAway(placeOf(v))).map(v => [worthOf(v), v]).sort((a, b) => b[0] - a[0]).slice(0, kTried).map(x => x[1]);
}
for (const s of surfaces) { const extent = Math.max(...s.anchors.map(v => apart(v, s.anchors[0]))); s.free = s.anchors.filter(v => s.labels.every(l => apart(l.vertex, v) > 0.15 * extent)); }
/** Whether a surface hides a vertex from the eye by more than a part of the way to it (Moeller and Trumbore 1997). */
function isBehind({firstTriangle, triangleCount}, vertex, least) {
  const p = placeOf(vertex), d = p.map((x, i) => eye[i] - x), away = cutting(), low = away ? heightOf(p) : 0, rise = away ? heightOf(eye) - low : 0;
  for (let t = 3 * firstTriangle, end = t + 3 * triangleCount; t < end; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2], px = points[a], py = points[a + 1], pz = points[a + 2];
    const ux = points[b] - px, uy = points[b + 1] - py, uz = points[b + 2] - pz, vx = points[c] - px, vy = points[c + 1] - py, vz = points[c + 2] - pz;
    const nx = d[1] * vz - d[2] * vy, ny = d[2] * vx - d[0] * vz, nz = d[0] * vy - d[1] * vx, det = ux * nx + uy * ny + uz * nz;
    const x = p[0] - px, y = p[1] - py, z = p[2] - pz, s = (x * nx + y * ny + z * nz) / det;
    if (!(s >= 0 && s <= 1)) continue;
    const qx = y * uz - z * uy, qy = z * ux - x * uz, qz = x * uy - y * ux, w = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
    if (!(w >= 0 && s + w <= 1)) continue;
    const far = (vx * qx + vy * qy + vz * qz) / det;
    if (far > least && !(away && low + far * rise < 0)) return true; // What is cut away hides nothing.
  }
  return false;
}
/** Whether the way from a place to the eye comes near a surface's ball. */
function mayHide({ball}, p) {
  const d = p.map((x, i) => eye[i] - x), c = p.map((x, i) => ball.at[i] - x), t = Math.max(0, dot(c, d) / dot(d, d));
  return Math.hypot(...c.map((x, i) => x - t * d[i])) < ball.radius;
}
/** Whether something opaque stands before a vertex; before the ring of a valve only what is around its chamber does, since it is drawn over what is in it. */
const isHidden = (s, vertex, ring) => opened() ? isCutAway(placeOf(vertex)) || isBehind(tissue, vertex, 0.01) || surfaces.some(o => o.on && o !== outerWall && !chambersOf.includes(o) && o.now >= kSolid && mayHide(o, placeOf(vertex)) && isBehind(o, vertex, 0.01))
  : isCutAway(placeOf(vertex)) || surfaces.some(o => o.on && (o === s ? !ring : seenOf(o) >= kSolid && (!ring || o.wall) && mayHide(o, placeOf(vertex))) && isBehind(o, vertex, o === s ? 0.01 : 0.002));
/** Finds out whether a name's place is seen, and of a whole surface, where: null for nowhere. */
function findPlace(i, middles) {
  if (i.part) i.seen = (i.ring || facing(i.s, i.vertex) > kFacing) && !isHidden(i.s, i.vertex, i.ring) ? i.vertex : null;
  else i.seen = bestAnchors(i.s, middles).find(v => !isHidden(i.s, v)) ?? null;
}
/** Puts boxes of one side below one another, each as near to its place as it can be; what finds no room is left out. */
function column(items, top, bottom) {
  items.sort((a, b) => b.worth - a.worth);
  let room = bottom - top;
  const kept = items.filter(i => (room -= i.box.offsetHeight + 2) >= 0 || void (i.shown = false)).sort((a, b) => a.y - b.y);
  let y = top;
  for (const i of kept) { i.top = Math.max(y, i.y - i.box.offsetHeight / 2); y = i.top + i.box.offsetHeight + 2; }
  y = bottom;
  for (const i of kept.reverse()) { i.top = Math.min(i.top, y - i.box.offsetHeight); y = i.top - 2; }
}
/** The middles of all surfaces that are shown, in the picture; and their balls. */
function findMiddles() {
  for (const s of surfaces) { const at = [0, 1, 2].map(i => s.anchors.reduce((sum, v) => sum + points[3 * v + i], 0) / s.anchors.length); s.ball = {at, radius: 5 + Math.max(...s.anchors.map(v => Math.hypot(...placeOf(v).map((x, i) => x - at[i]))))}; }
  return surfaces.filter(s => s.on).map(s => [s, project(s.ball.at)]);
}
function placeNames() {
  const late = performance.now() - lastBehind > 300; if (late) lastBehind = performance.now();
  stale = !late;
  const middles = late ? findMiddles() : [];
  for (const i of nameItems) {
    if (late && i.s.on) findPlace(i, middles);
    const vertex = i.seen ?? i.vertex ?? i.s.anchors[0];
    i.worth = !i.part ? 1 : i.ring ? 0.9 : facing(i.s, vertex);
    [i.x, i.y] = project(placeOf(vertex));
    i.shown = named() && !quiz.on && i.s.on && i.seen !== null && i.worth > kFacing && i.x > 0 && i.x < size[0] && i.y > 0 && i.y < size[1];
    i.box.style.display = i.shown ? '' : 'none';
  }
  const top = $('tools').offsetTop + $('tools').offsetHeight + 6, bottom = Math.min(size[1] - 40 - (litNow() && size[0] >= kNarrow ? kEcgHigh : 0), $('held').textContent ? $('held').offsetTop - 4 : size[1]);
  const middle = size[0] / 2, shown = nameItems.filter(i => i.shown);
  for (const onLeft of [true, false]) column(shown.filter(i => (i.x < middle) === onLeft), top, bottom);
  for (const i of shown) {
    if (!i.shown) { i.box.style.display = 'none'; continue; }
    i.left = i.x < middle ? 10 : size[0] - 10 - i.box.offsetWidth;
    i.box.style.transform = `translate(${i.left}px,${i.top}px)`;
  }
  return shown.filter(i => i.shown);
}
const ringAt = (c, x, y, radius, fill, line) => { c.beginPath(); c.arc(x, y, radius, 0, 7); c.fillStyle = fill; c.fill(); c.strokeStyle = line; c.stroke(); };
/** A valve: its ring, across the way of the blood. */
function drawRing(c, {vertex, ring}) {
  const n = normalOf(vertex), a = [n[1], -n[0], 0], s = Math.hypot(...a) || 1, u = a.map(x => x / s), v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]], p = placeOf(vertex);
  c.beginPath();
  for (let k = 0; k <= 36; ++k) { const [x, y] = project(p.map((x, i) => x + ring * (Math.cos(k * Math.PI / 18) * u[i] + Math.sin(k * Math.PI / 18) * v[i]))); c.lineTo(x, y); }
  c.setLineDash([5, 4]); c.stroke(); c.setLineDash([]);
}
const drawHandles = (c, text) => handles.forEach((h, i) => {
  const [x, y] = project(placeOf(h.vertex)), held = i === state.held;
  ringAt(c, x, y, held ? 10 : 7, held ? css('--accent') : '#e69f00', held ? text : '#fff');
});
function drawMeasurements(c, text) {
  for (const m of measurements) {
    const {at, value} = measure(m), flat = at.map(project), says = say(m.kind === 'angle' ? 'degrees' : 'mm', number(value));
    c.setLineDash([5, 4]); c.strokeStyle = text; c.beginPath(); flat.forEach(([x, y]) => c.lineTo(x, y)); c.stroke(); c.setLineDash([]);
    const [x, y] = flat.length === 3 ? flat[1] : [0, 1].map(i => (flat[0][i] + flat[1][i]) / 2);
    c.lineWidth = 4; c.strokeStyle = css('--bottom'); c.strokeText(says, x + 6, y - 6); c.lineWidth = 1.3; // To be read on any colour.
    c.fillStyle = text; c.fillText(says, x + 6, y - 6);
  }
}
function drawScale(c, text) {
  const perMm = pixels() / far, mm = [1, 2, 5, 10, 20, 50, 100, 200].filter(m => m * perMm < size[0] / 4).pop() || 1;
  const x = size[0] - 18, y = size[1] - 12;
  c.strokeStyle = c.fillStyle = text; c.beginPath();
  for (const [dx, dy] of [[-mm * perMm, -5], [-mm * perMm, 0], [0, 0], [0, -5]]) c.lineTo(x + dx, y + dy);
  c.stroke(); c.textAlign = 'center'; c.fillText(say('mm', mm), x - mm * perMm / 2, y - 7); c.textAlign = 'left';
}
function drawOver() {
  const c = $('over').getContext('2d'), text = css('--text'), ratio = gl.canvas.width / size[0];
  c.setTransform(ratio, 0, 0, ratio, 0, 0); c.clearRect(0, 0, size[0], size[1]);
  c.font = '14px system-ui,sans-serif'; c.lineWidth = 1.3;
  for (const i of placeNames()) {
    const fromLeft = i.x < size[0] / 2;
    c.globalAlpha = 0.65; c.strokeStyle = text; c.beginPath();
    c.moveTo(fromLeft ? i.left + i.box.offsetWidth + 2 : i.left - 2, i.top + i.box.offsetHeight / 2); c.lineTo(i.x, i.y); c.stroke();
    c.globalAlpha = 1; if (i.ring) drawRing(c, i); ringAt(c, i.x, i.y, 2.5, text, css('--bottom'));
  }
  if (!quiz.on) drawMeasurements(c, text);
  if (state.handles) drawHandles(c, text);
  if (quiz.vertex >= 0) { const [x, y] = project(placeOf(quiz.vertex)); c.lineWidth = 3; c.strokeStyle = '#e69f00'; if (quiz.item && quiz.item.ring) drawRing(c, quiz.item); ringAt(c, x, y, 11, '#e69f0055', '#e69f00'); c.fillStyle = text; c.font = 'bold 16px system-ui'; c.fillText('?', x - 4, y + 6); }
  else { drawScale(c, text); if (litNow()) drawEcg(c, text); }
}
