// A heart that is cut open: its walls in place of its outer surface, empty chambers or blood; and its conduction system, lit as the beat goes.
/** The triangles of all surfaces, then those of the walls as one closed surface, and the face of a cut. */
function withTissue(own) {
  const outer = lesson.surfaces[tissue.surface], left = new Set(integers(arrays.left)), walls = [];
  for (let t = 0; t < outer.triangleCount; ++t) if (!left.has(t)) for (let i = 0; i < 3; ++i) walls.push(own[3 * (outer.firstTriangle + t) + i]);
  for (const v of integers(arrays.innerTriangles)) walls.push(v < lesson.vertices ? v : v + handles.length); // The handles lie between.
  Object.assign(tissue, {firstTriangle: own.length / 3, triangleCount: walls.length / 3, face: {rgb: tissue.face, firstTriangle: (own.length + walls.length) / 3, triangleCount: 2}});
  return Uint32Array.from([0, 1, 2, 0, 2, 3].reduce((all, i) => { all.push(faceVertices + i); return all; }, [...own, ...walls]));
}
/** What is carried is off its place by a mean of what its four vertices are off theirs. */
function carry() {
  for (let p = 0, from = 0, to = 3 * firstInner; from < inner.length; ++p, from += 3, to += 3) {
    points[to] = inner[from]; points[to + 1] = inner[from + 1]; points[to + 2] = inner[from + 2];
    for (let k = 0, left = 1; k < 4; ++k) {
      const share = k < 3 ? carried[3 * p + k] : left, v = 3 * carriers[4 * p + k]; left -= share;
      for (let i = 0; i < 3; ++i) points[to + i] += share * (points[v + i] - rest[v + i]);
    }
  }
}
const outerWall = tissue && surfaces[tissue.surface], chambersOf = tissue ? tissue.chambers.map(i => surfaces[i]) : [];
const cut = tissue ? {...tissue.cut} : {on: false}, kLit = [1, 1, 0.55], kUnlit = [0.8, 0.66, 0.22], kFadingMs = 70, kCordSides = 8, kCordMm = 2.5, kAroundCords = 0.3;
let lit = !!conduction && conduction.on;
const cutting = () => !!tissue && cut.on, opened = () => cutting() && outerWall.on, litNow = () => lit && !quiz.on;
/** What is drawn: while the heart is open its walls, and its chambers only where blood fills them. */
const drawnOf = () => !opened() ? surfaces.filter(s => s.on) : [tissue, ...surfaces.filter(s => s.on && s !== outerWall && (cut.blood || !chambersOf.includes(s)))];
/** The opacity of a surface: walls are whole where they are cut, and glass around cords that lie in them. */
const seenOf = s => s === tissue || opened() && chambersOf.includes(s) ? 1 : litNow() && !cutting() && conduction.around.includes(s) ? Math.min(s.now, kAroundCords) : s.now;
const heightOf = p => dot(p, cut.normal) - dot(cut.origin, cut.normal), isCutAway = p => cutting() && heightOf(p) < 0;
/** How much a vertex faces the eye; chambers that are open are seen from within. */
const facing = (s, v) => (opened() && chambersOf.includes(s) ? 1 : -1) * dot(normalOf(v), ahead);
if (conduction) { // Their surfaces, and those around them.
  const from = (tissue ? tissue.vertices : 0), holds = s => conduction.ways.some(w => { const v = carriers[4 * (from + w.first)]; return v >= s.firstVertex && v < s.firstVertex + s.vertexCount; });
  conduction.around = surfaces.filter(s => holds(s) || s.wall);
}
function setPlane(on) { if (!on) gl.uniform4f(uniform.plane, 0, 0, 0, 1); else gl.uniform4f(uniform.plane, ...cut.normal, -dot(cut.origin, cut.normal)); }
/** Lays the square on which faces are drawn into the plane; it is seen from the side that is away. */
function placeFace() {
  const n = cut.normal, a = Math.abs(n[2]) < 0.9 ? [n[1], -n[0], 0] : [0, n[2], -n[1]], size = Math.hypot(...a), u = a.map(x => x / size), v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]], far = 4 * lesson.radius;
  const middle = lesson.center.map((x, i) => x - heightOf(lesson.center) * n[i]);
  [[-1, -1], [-1, 1], [1, 1], [1, -1]].forEach(([x, y], k) => { for (let i = 0; i < 3; ++i) { points[3 * (faceVertices + k) + i] = middle[i] + far * (x * u[i] + y * v[i]); normals[3 * (faceVertices + k) + i] = -n[i]; } });
}
/** The face that the cut makes of a closed surface: where more of its back sides than of its front sides lie behind the plane. */
function drawFace(s) {
  if (s !== tissue && !s.closed) return;
  const rgb = s === tissue ? s.face.rgb : s.color, paint = new Uint8Array([0, 1, 2, 3].flatMap(() => [...rgb.map(x => 255 * x), 255]));
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers[2]); gl.bufferSubData(gl.ARRAY_BUFFER, 4 * faceVertices, paint);
  gl.enable(gl.STENCIL_TEST); gl.clear(gl.STENCIL_BUFFER_BIT); gl.colorMask(false, false, false, false); gl.depthMask(false); gl.disable(gl.DEPTH_TEST);
  gl.stencilFunc(gl.ALWAYS, 0, 255); gl.stencilOpSeparate(gl.FRONT, gl.KEEP, gl.KEEP, gl.DECR_WRAP); gl.stencilOpSeparate(gl.BACK, gl.KEEP, gl.KEEP, gl.INCR_WRAP);
  drawRange(s);
  gl.colorMask(true, true, true, true); gl.depthMask(true); gl.enable(gl.DEPTH_TEST); gl.stencilFunc(gl.NOTEQUAL, 0, 255); gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
  if (s !== tissue) { gl.enable(gl.POLYGON_OFFSET_FILL); gl.polygonOffset(1, 4); } // Blood lies behind the walls' face.
  setPlane(false); drawRange(tissue.face); setPlane(true); gl.disable(gl.STENCIL_TEST); gl.disable(gl.POLYGON_OFFSET_FILL);
}
// Cords: lines of points, each a way and a place on it; rings of vertices around them.
const cords = [];
if (conduction) for (const way of conduction.ways) {
  const from = firstInner + (tissue ? tissue.vertices : 0) + way.first, line = [];
  const at = v => [...inner.subarray(3 * (v - firstInner), 3 * (v - firstInner) + 3)];
  for (let i = 0; i + 1 < way.count; ++i) {
    const parts = Math.max(1, Math.ceil(Math.hypot(...at(from + i).map((x, k) => x - at(from + i + 1)[k])) / kCordMm));
    for (let k = 0; k < parts; ++k) line.push({v: from + i, part: k / parts, ms: way.reached[i] + k / parts * (way.reached[i + 1] - way.reached[i])});
  }
  line.push({v: from + way.count - 2, part: 1, ms: way.reached[way.count - 1]});
  cords.push({line, width: way.width});
}
const ringCount = cords.reduce((sum, c) => sum + c.line.length, 0) * kCordSides, cordPoints = new Float32Array(3 * ringCount), cordNormals = new Float32Array(3 * ringCount), cordColors = new Uint8Array(4 * ringCount).fill(255), cordTriangles = [];
for (let ring = 0, c = 0; c < cords.length; ring += cords[c++].line.length) for (let r = ring; r + 1 < ring + cords[c].line.length; ++r) for (let k = 0; k < kCordSides; ++k) {
  const a = r * kCordSides + k, b = r * kCordSides + (k + 1) % kCordSides; cordTriangles.push(a, b, a + kCordSides, b, b + kCordSides, a + kCordSides);
}
const cordArray = conduction && gl.createVertexArray(), cordBuffers = [];
if (conduction) {
  gl.bindVertexArray(cordArray);
  [cordPoints, cordNormals, cordColors].forEach((data, i) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, cordBuffers[i] = gl.createBuffer()); gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(i); gl.vertexAttribPointer(i, i < 2 ? 3 : 4, i < 2 ? gl.FLOAT : gl.UNSIGNED_BYTE, i === 2, 0, 0);
  });
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer()); gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(cordTriangles), gl.STATIC_DRAW);
  gl.bindVertexArray(null);
}
const beatNow = () => conduction.beats[state.rate], ecg = conduction ? numbers(arrays.ecg) : [], ecgOf = rate => { const n = ecg.length / conduction.beats.length; return ecg.subarray(rate * n, rate * n + n); };
/** How far the excitation is, ms in the time of the ways. */
function excitationMs() {
  const {begins, marks} = beatNow(), since = mod(state.fraction - begins, 1), i = marks.findIndex(m => m[0] > since);
  if (i < 1) return i ? 1e9 : 0;
  const [[from, low], [to, high]] = [marks[i - 1], marks[i]]; return low + (high - low) * (since - from) / (to - from);
}
const lightOf = (reached, now) => now < reached ? 0 : Math.exp(-(now - reached) / kFadingMs);
function placeCords() {
  const now = excitationMs(); let to = 0;
  for (const {line, width} of cords) {
    const at = line.map(({v, part}) => [0, 1, 2].map(i => points[3 * v + i] + part * (points[3 * v + 3 + i] - points[3 * v + i]))); let across = null;
    at.forEach((p, i) => {
      const along = at[Math.min(i + 1, at.length - 1)].map((x, k) => x - at[Math.max(i - 1, 0)][k]), length = Math.hypot(...along) || 1, t = along.map(x => x / length);
      across = across || (Math.abs(t[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]); // Carried along, so that the rings do not twist.
      const off = dot(across, t), raw = across.map((x, k) => x - off * t[k]), size = Math.hypot(...raw) || 1, u = across = raw.map(x => x / size), w = [t[1] * u[2] - t[2] * u[1], t[2] * u[0] - t[0] * u[2], t[0] * u[1] - t[1] * u[0]];
      const light = lightOf(line[i].ms, now), radius = width * (1 + 0.5 * light);
      for (let k = 0; k < kCordSides; ++k, ++to) {
        const a = 2 * Math.PI * k / kCordSides, n = u.map((x, j) => Math.cos(a) * x + Math.sin(a) * w[j]);
        for (let j = 0; j < 3; ++j) { cordNormals[3 * to + j] = n[j]; cordPoints[3 * to + j] = p[j] + radius * n[j]; cordColors[4 * to + j] = 255 * (kUnlit[j] + light * (kLit[j] - kUnlit[j])); }
      }
    });
  }
  [cordPoints, cordNormals, cordColors].forEach((data, i) => { gl.bindBuffer(gl.ARRAY_BUFFER, cordBuffers[i]); gl.bufferSubData(gl.ARRAY_BUFFER, 0, data); });
}
function drawCords() {
  if (!conduction || !litNow()) return;
  placeCords(); gl.bindVertexArray(cordArray); gl.drawElements(gl.TRIANGLES, cordTriangles.length, gl.UNSIGNED_INT, 0); gl.bindVertexArray(null);
}
/** The electrocardiogram of the beat, with its present instant; below what is named. */
const kEcgHigh = 50, kEcgAbove = 52;
function drawEcg(c, text) {
  const narrow = size[0] < kNarrow; if (narrow && $('held').textContent) return; // It stands there.
  const curve = ecgOf(state.rate), w = Math.min(280, size[0] * 0.7 - 40), x = 12, y = size[1] - (narrow ? 12 : kEcgAbove), X = f => x + 34 + f * (w - 34), Y = mv => y - 26 * mv;
  c.fillStyle = text; c.fillText(say('ecg'), x, y + 4); c.strokeStyle = '#e0b93b'; c.lineWidth = 1.8; c.beginPath();
  for (let i = 0; i <= curve.length; ++i) c.lineTo(X(i / curve.length), Y(curve[i % curve.length]));
  c.stroke(); c.lineWidth = 1.3; ringAt(c, X(state.fraction), Y(valueAround(curve, state.fraction)), 4, '#e0b93b', text);
}
const valueAround = (curve, fraction) => { const x = fraction * curve.length, i = Math.floor(x); return curve[i % curve.length] + (x - i) * (curve[(i + 1) % curve.length] - curve[i % curve.length]); };
const faceCut = () => lookAlong(cut.normal, lesson.center, lesson.radius / Math.sin(kHalfAngle));
function showHeart() {
  for (const s of surfaces) setOpacity(s, s.now);
  if (tissue) { placeFace(); press('cut', cut.on); press('blood', cut.blood); $('blood').hidden = !cut.on; $('opacity').disabled = opened(); }
  if (conduction) press('conduct', lit);
  turned = changed = true; lastBehind = 0;
}
/** Opens or closes the heart; the picture turns to the open side where it is not seen. */
function setCut(on, like) {
  if (!tissue) return;
  Object.assign(cut, like, {on});
  showHeart(); look(); if (on && !like && dot(ahead, cut.normal) < 0.7) faceCut();
}
function setBlood(on) { if (tissue) { cut.blood = on; showHeart(); } }
function setConduction(on) { if (conduction) { lit = on; showHeart(); } }
