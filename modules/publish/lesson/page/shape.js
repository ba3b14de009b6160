// Where the vertices are: rest + sum c_k mode_k + sum w_h pull_h, and what follows from that.
const points = new Float32Array(3 * allVertices), pulled = new Float32Array(rest.length), normals = new Float32Array(points.length), coefficients = new Float64Array(motion ? motion.modes : 0);
points.set(rest); carry();
const firstInstants = motion ? motion.instants.map((_, i) => motion.instants.slice(0, i).flat().length) : [];
const pullsOf = () => handles.filter(h => h.pull.some(x => x)), mod = (a, n) => (a % n + n) % n;
/** The courses at an instant: cubic pieces between the motion's own instants (Hermite). */
function setInstant(fraction, rate) {
  const course = motion.courses[rate], at = motion.instants[course], n = motion.modes;
  let i = 1; while (i < at.length - 1 && at[i] <= fraction) ++i;
  const length = at[i] - at[i - 1], u = (fraction - at[i - 1]) / length, v = 1 - u;
  const w = [v * v * (1 + 2 * u), length * u * v * v, u * u * (3 - 2 * u), -length * u * u * v], row = 2 * n * (firstInstants[course] + i - 1);
  for (let k = 0; k < n; ++k) coefficients[k] = w.reduce((sum, x, j) => sum + x * courses[row + j * n + k], 0);
}
/** Writes vertices at the instant that is set into `out`, from place `from` to `to` of all. */
function poseInto(out, from, to) {
  for (let i = from; i < to; ++i) out[i] = rest[i] + pulled[i];
  for (let k = 0; k < coefficients.length; ++k) {
    const c = coefficients[k], first = k * rest.length;
    for (let i = from; i < to; ++i) out[i] += c * modes[first + i];
  }
}
const pose = () => { if (motion) setInstant(state.fraction, state.rate); poseInto(points, 0, rest.length); carry(); };
function takePulls() {
  pulled.fill(0);
  for (const h of pullsOf()) {
    const [x, y, z] = h.pull, first = (h.vertex - lesson.vertices) * lesson.vertices;
    for (let v = 0, i = 0; v < lesson.vertices; ++v) { const a = weights[first + v]; pulled[i++] += a * x; pulled[i++] += a * y; pulled[i++] += a * z; }
    for (let i = 0; i < 3; ++i) pulled[3 * h.vertex + i] = h.pull[i];
  }
}
/** Sums of the triangles' normals; the shader brings them to length 1. */
function shade() {
  normals.fill(0);
  if (!opened()) addNormals(0, organTriangles.length);
  else for (const s of [tissue, ...surfaces]) if (s !== outerWall) addNormals(3 * s.firstTriangle, 3 * (s.firstTriangle + s.triangleCount));
  if (cutting()) placeFace();
}
function addNormals(from, to) {
  for (let t = from; t < to; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2], px = points[a], py = points[a + 1], pz = points[a + 2];
    const ux = points[b] - px, uy = points[b + 1] - py, uz = points[b + 2] - pz, vx = points[c] - px, vy = points[c + 1] - py, vz = points[c + 2] - pz;
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    normals[a] += x; normals[a + 1] += y; normals[a + 2] += z;
    normals[b] += x; normals[b + 1] += y; normals[b + 2] += z;
    normals[c] += x; normals[c + 1] += y; normals[c + 2] += z;
  }
}
/** Signed tetrahedra over the surface's first vertex, ml. */
function volumeOf({firstTriangle, triangleCount}, at = points) {
  const o = 3 * triangles[3 * firstTriangle], ox = at[o], oy = at[o + 1], oz = at[o + 2];
  let sum = 0;
  for (let t = 3 * firstTriangle, end = t + 3 * triangleCount; t < end; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
    const ax = at[a] - ox, ay = at[a + 1] - oy, az = at[a + 2] - oz;
    const bx = at[b] - ox, by = at[b + 1] - oy, bz = at[b + 2] - oz;
    const cx = at[c] - ox, cy = at[c + 1] - oy, cz = at[c + 2] - oz;
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum / 6000;
}
const placeOf = vertex => [points[3 * vertex], points[3 * vertex + 1], points[3 * vertex + 2]];
const normalOf = vertex => { const n = [0, 1, 2].map(i => normals[3 * vertex + i]), size = Math.hypot(...n) || 1; return n.map(x => x / size); };
/** A surface's curve, ml, as the handles that are pulled make it; the lesson's own when none is. */
function pulledCurve(s, samples = 48) {
  const out = new Float32Array(points.length), from = 3 * s.firstVertex, curve = [];
  for (let i = 0; i < samples; ++i) {
    setInstant(i / (motion.cycles ? samples : samples - 1), state.rate);
    poseInto(out, from, from + 3 * s.vertexCount);
    curve.push(volumeOf(s, out));
  }
  return curve;
}
const curveOf = s => s.curves[motion.courses[state.rate]];
/** A curve's value at a fraction of the cycle, linear. */
function valueOn(curve, fraction) {
  const last = motion.cycles ? curve.length : curve.length - 1, x = Math.min(fraction, 0.99999) * last, i = Math.floor(x);
  return curve[i] + (x - i) * (curve[(i + 1) % curve.length] - curve[i]);
}
/** What a measurement says now (mm or degrees), and where its points are. */
function measure({kind, points: from}) {
  const at = from.map(p => p.at || [0, 1, 2].map(i => p.vertices.reduce((sum, v, j) => sum + p.weights[j] * points[3 * v + i], 0)));
  const away = (a, b) => a.map((x, i) => x - b[i]), [a, b] = [away(at[0], at[1]), at[2] && away(at[2], at[1])];
  if (kind === 'distance') return {at, value: Math.hypot(...a)};
  const size = Math.hypot(...a) * Math.hypot(...b), cosine = size ? a.reduce((sum, x, i) => sum + x * b[i], 0) / size : 1;
  return {at, value: Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI};
}
