// What the lesson holds: what it says, and its numbers out of one zlib stream.
const kNarrow = 480; // Pixels: names find no room beside an organ in less.
const $ = id => document.getElementById(id);
const lesson = JSON.parse($('lesson').textContent);
const say = (key, ...values) => lesson.strings[key].replace(/%(\d)/g, (_, i) => values[i - 1]);
const number = (value, digits = 1) => value.toLocaleString(lesson.language, {minimumFractionDigits: digits, maximumFractionDigits: digits}).replace('-', '\u2212');
const element = (kind, text = '', className = '') => Object.assign(document.createElement(kind), {textContent: text, className});
/** Says why there is no lesson, and never comes back. */
function giveUp(key) {
  $('failure').textContent = say(key);
  Object.assign($('failure'), {hidden: false}).style.visibility = 'visible';
  return new Promise(() => {});
}
if (!window.DecompressionStream) await giveUp('tooOld');
const packed = Uint8Array.from(atob($('arrays').textContent), c => c.charCodeAt(0)); $('arrays').textContent = '';
const bytes = new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'))).arrayBuffer());
/** Planes of bytes of zigzag differences to the element `stride` before, modulo 2^(8 width). */
function integers({at, count, width, stride}) {
  const out = new Int32Array(count), free = 32 - 8 * width;
  for (let i = 0; i < count; ++i) {
    let v = 0;
    for (let p = 0; p < width; ++p) v |= bytes[at + p * count + i] << 8 * p;
    v = v >>> 1 ^ -(v & 1);
    out[i] = (v + (i >= stride ? out[i - stride] : 0)) << free >> free;
  }
  return out;
}
/** Fields over some vertices from their differences to the mean of the neighbours before, or to the vertex before. */
function overMesh(array, count, components) {
  const out = integers(array), before = Array.from({length: count}, () => []);
  organTriangles.forEach((v, i) => { for (let corner = i - i % 3, end = corner + 3; corner < end; ++corner) if (organTriangles[corner] < v) before[v].push(organTriangles[corner]); });
  for (let at = 0; at < out.length; ++at) {
    const v = Math.floor(at / components) % count, near = before[v];
    out[at] += near.length ? Math.floor(near.reduce((sum, other) => sum + out[at + components * (other - v)], 0) / near.length + 0.5) : v ? out[at - components] : 0;
  }
  return Float32Array.from(out, x => x * array.step);
}
const numbers = array => array.step === 0 ? new Float32Array(bytes.slice(array.at, array.at + 4 * array.count).buffer) : Float32Array.from(integers(array), v => v * array.step);
const {surfaces, arrays, motion, measurements, slides} = lesson;
const handles = lesson.handles.map((label, i) => ({label, vertex: lesson.vertices + i, pull: [0, 0, 0]}));
const organTriangles = integers(arrays.triangles), rest = numbers(arrays.rest), modes = motion ? overMesh(arrays.motion, rest.length / 3, 3) : [], courses = motion ? numbers(arrays.course) : [];
// Beside the surfaces and handles, and carried by their vertices: the inner walls of a heart that can be cut open, then its conduction system.
const {tissue, conduction} = lesson, inner = arrays.inner ? numbers(arrays.inner) : [], carriers = arrays.inner ? integers(arrays.carriers) : [], carried = arrays.inner ? numbers(arrays.carried) : [];
const firstInner = lesson.vertices + handles.length, faceVertices = firstInner + inner.length / 3, allVertices = faceVertices + (tissue ? 4 : 0); // The face of a cut is a square.
const triangles = tissue ? withTissue(organTriangles) : Uint32Array.from(organTriangles), weights = handles.length ? overMesh(arrays.weights, lesson.vertices, 1) : [];
const painted = integers(arrays.colors), colors = new Uint8Array(4 * allVertices);
for (let i = 0; i < lesson.vertices; ++i) for (let c = 0; c < 3; ++c) colors[4 * i + c] = painted[3 * i + c];
if (tissue) integers(arrays.innerColors).forEach((x, i) => { const at = 4 * (firstInner + Math.floor(i / 3)); colors[at + i % 3] = x; colors[at + 3] = 255; });
for (const s of surfaces) Object.assign(s, {on: true, now: s.opacity, rgb: `rgb(${s.color.map(x => Math.round(255 * x)).join()})`});
const state = {fraction: 0, rate: motion ? motion.rate : 0, speed: 1, playing: false, names: null, handles: false, held: -1}, named = () => state.names ?? size[0] >= kNarrow; // Null: as there is room.
