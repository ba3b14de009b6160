// What lies over the picture: names with their lines, handles, measurements, the scale.
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let lastBehind = 0; const kFacing = 0.12, kTouch = 28, kMouse = 16;
const nameItems = surfaces.flatMap(s => {
  const parts = s.labels.map(({text, vertex}) => ({s, text, vertex, part: true}));
  return parts.length && (s.wall || surfaces.length === 1) ? parts : [{s, text: s.title}, ...parts];
});
for (const item of nameItems) $('names').append(item.box = Object.assign(element('span', item.text, item.part ? 'name part' : 'name'), {dir: 'auto'}));
/** Of a whole surface: a place that faces the eye and lies away from the other surfaces, which may stand before it. */
function bestAnchor(s, middles) {
  let best = -Infinity, found = s.anchors[0];
  for (const v of s.anchors) {
    const p = project(placeOf(v)), facing = -dot(normalOf(v), ahead);
    let worth = Math.min(facing, 0.5) * size[1] * (s.wall ? 0.2 : 0.8) + (s.wall ? -p[1] : 0);
    for (const [other, m] of middles) if (other !== s && !other.wall) worth += Math.hypot(p[0] - m[0], p[1] - m[1]) * (s.wall ? 0.3 : 1);
    if (worth > best) { best = worth; found = v; }
  }
  return found;
}
/** Whether a surface hides one of its own vertices from the eye (Moeller and Trumbore 1997). */
function isBehind({firstTriangle, triangleCount}, vertex) {
  const p = placeOf(vertex), d = p.map((x, i) => eye[i] - x);
  for (let t = 3 * firstTriangle, end = t + 3 * triangleCount; t < end; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2], px = points[a], py = points[a + 1], pz = points[a + 2];
    const ux = points[b] - px, uy = points[b + 1] - py, uz = points[b + 2] - pz, vx = points[c] - px, vy = points[c + 1] - py, vz = points[c + 2] - pz;
    const nx = d[1] * vz - d[2] * vy, ny = d[2] * vx - d[0] * vz, nz = d[0] * vy - d[1] * vx, det = ux * nx + uy * ny + uz * nz;
    const x = p[0] - px, y = p[1] - py, z = p[2] - pz, s = (x * nx + y * ny + z * nz) / det;
    if (!(s >= 0 && s <= 1)) continue;
    const qx = y * uz - z * uy, qy = z * ux - x * uz, qz = x * uy - y * ux, w = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
    if (w >= 0 && s + w <= 1 && (vx * qx + vy * qy + vz * qz) / det > 0.01) return true;
  }
  return false;
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
function placeNames() {
  const middles = surfaces.filter(s => s.on).map(s => [s, project([0, 1, 2].map(i => s.anchors.reduce((sum, v) => sum + points[3 * v + i], 0) / s.anchors.length))]);
  const late = performance.now() - lastBehind > 300; if (late) lastBehind = performance.now();
  for (const i of nameItems) {
    const vertex = i.part ? i.vertex : bestAnchor(i.s, middles);
    i.worth = i.part ? -dot(normalOf(vertex), ahead) : 1;
    if (i.part && late) i.behind = i.worth > kFacing && isBehind(i.s, vertex);
    [i.x, i.y] = project(placeOf(vertex));
    i.shown = named() && !quiz.on && i.s.on && !i.behind && i.worth > kFacing && i.x > 0 && i.x < size[0] && i.y > 0 && i.y < size[1];
    i.box.style.display = i.shown ? '' : 'none';
  }
  const top = $('tools').offsetTop + $('tools').offsetHeight + 6, bottom = Math.min(size[1] - 40, $('held').textContent ? $('held').offsetTop - 4 : size[1]);
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
    c.globalAlpha = 1; ringAt(c, i.x, i.y, 2.5, text, css('--bottom'));
  }
  if (!quiz.on) drawMeasurements(c, text);
  if (state.handles) drawHandles(c, text);
  if (quiz.vertex >= 0) { const [x, y] = project(placeOf(quiz.vertex)); c.lineWidth = 3; ringAt(c, x, y, 11, '#e69f0055', '#e69f00'); c.fillStyle = text; c.font = 'bold 16px system-ui'; c.fillText('?', x - 4, y + 6); }
  else drawScale(c, text);
}
