// The camera, a turntable around the axis to the head (LPS mm), and the drawing in WebGL 2.
const kHalfAngle = 15 * Math.PI / 180, kSteepest = 1.5, dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sides = {anterior: [0, 0], posterior: [Math.PI, 0], left: [Math.PI / 2, 0], right: [-Math.PI / 2, 0], superior: [0, kSteepest], inferior: [0, -kSteepest]};
const camera = {yaw: 0.25, pitch: 0.12, zoom: 1, target: [...lesson.center]};
let eye, right, up, ahead, far, size = [1, 1], toolsHigh = 40;
function look() {
  const {yaw, pitch} = camera, cp = Math.cos(pitch), sp = Math.sin(pitch), cy = Math.cos(yaw), sy = Math.sin(yaw);
  ahead = [-cp * sy, cp * cy, -sp]; right = [cy, sy, 0]; up = [-sp * sy, sp * cy, cp];
  far = lesson.radius / Math.sin(kHalfAngle) / camera.zoom * Math.max(1, size[1] / size[0]) * (size[0] < 600 ? size[1] / (size[1] - toolsHigh - 10) : 1) // The tools lie over it,
    * (named() && size[0] < kNarrow ? 1.2 : 1); // and the names beside it.
  eye = camera.target.map((x, i) => x - ahead[i] * far + (size[0] < kNarrow ? up[i] * (toolsHigh / 2 + 2) * far / pixels() : 0)); // Below the tools.
}
/** Looks along a direction at a point; from as far away as `distance` in a square picture. */
function lookAlong(direction, target, distance) {
  const length = Math.hypot(...direction);
  camera.yaw = Math.atan2(-direction[0], direction[1]);
  camera.pitch = Math.max(-kSteepest, Math.min(kSteepest, Math.asin(-direction[2] / length)));
  camera.target = [...target]; camera.zoom = lesson.radius / Math.sin(kHalfAngle) / distance;
}
const lookFrom = ({position, focus}) => { const way = focus.map((x, i) => x - position[i]); lookAlong(way, focus, Math.hypot(...way)); };
const zoomBy = factor => { camera.zoom = Math.max(0.3, Math.min(12, camera.zoom * factor)); };
const pixels = () => size[1] / 2 / Math.tan(kHalfAngle);
const pushBy = (dx, dy) => { const mm = far / pixels(); camera.target = camera.target.map((x, i) => x - (right[i] * dx - up[i] * dy) * mm); };
const turnBy = (dx, dy) => { camera.yaw -= dx; camera.pitch = Math.max(-kSteepest, Math.min(kSteepest, camera.pitch + dy)); };
const project = p => { const d = p.map((x, i) => x - eye[i]), z = dot(d, ahead), s = pixels() / z; return [size[0] / 2 + dot(d, right) * s, size[1] / 2 - dot(d, up) * s, z]; };
const gl = $('view').getContext('webgl2', {antialias: true, alpha: true, premultipliedAlpha: true, stencil: !!tissue});
if (!gl) await giveUp('noWebGl');
const vertexText = `#version 300 es
layout(location=0) in vec3 p; layout(location=1) in vec3 n; layout(location=2) in vec4 c;
uniform vec3 eye, right, up, ahead, lens; uniform vec4 plane; out vec3 N, V; out vec4 C; out float K;
void main(){ vec3 d=p-eye; K=dot(vec4(p,1.0),plane); V=-d; N=n; C=c; float z=dot(d,ahead);
 gl_Position=vec4(dot(d,right)*lens.x, dot(d,up)*lens.y, z-2.0*lens.z, z); }`;
const pixelText = `#version 300 es
precision highp float; in vec3 N, V; in vec4 C; in float K; out vec4 o;
void main(){ ${tissue ? 'if(K<0.0) discard;' : ''} vec3 n=normalize(N), v=normalize(V); if(!gl_FrontFacing) n=-n; float f=max(dot(n,v),0.0);
 vec3 l=normalize(v+vec3(-0.35,0.1,0.45)); float d=max(dot(n,l),0.0), s=pow(max(dot(reflect(-l,n),v),0.0),28.0);
 float a=C.a>0.99?1.0:clamp(C.a*mix(0.75,2.2,pow(1.0-f,2.0)),0.0,1.0);
 vec3 rgb=C.rgb*(0.28+0.62*d+0.16*f)+0.25*s; o=vec4(rgb*a,a); }`;
const program = gl.createProgram();
for (const [kind, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, pixelText]]) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(program, shader);
}
gl.linkProgram(program); if (!gl.getProgramParameter(program, gl.LINK_STATUS)) await giveUp('noWebGl');
gl.useProgram(program);
const uniform = Object.fromEntries(['eye', 'right', 'up', 'ahead', 'lens', 'plane'].map(u => [u, gl.getUniformLocation(program, u)]));
const buffers = [points, normals, colors].map((data, i) => {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer); gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW); gl.enableVertexAttribArray(i);
  gl.vertexAttribPointer(i, i < 2 ? 3 : 4, i < 2 ? gl.FLOAT : gl.UNSIGNED_BYTE, i === 2, 0, 0);
  return buffer;
});
const send = (i, data) => { gl.bindBuffer(gl.ARRAY_BUFFER, buffers[i]); gl.bufferSubData(gl.ARRAY_BUFFER, 0, data); };
gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles.byteLength * 2, gl.DYNAMIC_DRAW);
gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 0, triangles);
gl.canvas.addEventListener('webglcontextlost', () => giveUp('lost'));
/** How much of a surface is seen; its vertices carry it to the shader. */
function setOpacity(s, opacity) {
  s.now = opacity;
  const seen = seenOf(s), alpha = seen >= 1 ? 255 : Math.min(251, 255 * seen);
  for (let v = s.firstVertex; v < s.firstVertex + s.vertexCount; ++v) colors[4 * v + 3] = alpha;
  send(2, colors);
}
// Translucent triangles of all surfaces together, the farthest first: a counting sort of 2^12 depths, once a frame.
const kDepths = 4096, firstOf = new Uint32Array(kDepths + 1), sorted = new Uint32Array(triangles.length), depths = new Uint16Array(triangles.length / 3);
const depth = new Float32Array(allVertices);
function sortTranslucent() {
  const clear = drawnOf().filter(s => seenOf(s) < 1), reach = 2 * lesson.radius;
  firstOf.fill(0);
  for (const s of clear) {
    for (let v = s.firstVertex; v < s.firstVertex + s.vertexCount; ++v)
      depth[v] = (points[3 * v] - eye[0]) * ahead[0] + (points[3 * v + 1] - eye[1]) * ahead[1] + (points[3 * v + 2] - eye[2]) * ahead[2];
    for (let t = s.firstTriangle, end = t + s.triangleCount; t < end; ++t) {
      const z = (depth[triangles[3 * t]] + depth[triangles[3 * t + 1]] + depth[triangles[3 * t + 2]]) / 3;
      ++firstOf[(depths[t] = Math.max(0, Math.min(kDepths - 1, (far + reach - z) / (2 * reach) * kDepths | 0))) + 1];
    }
  }
  for (let bin = 0; bin < kDepths; ++bin) firstOf[bin + 1] += firstOf[bin];
  const count = firstOf[kDepths];
  for (const s of clear)
    for (let t = s.firstTriangle, end = t + s.triangleCount; t < end; ++t) {
      const to = 3 * firstOf[depths[t]]++;
      sorted[to] = triangles[3 * t]; sorted[to + 1] = triangles[3 * t + 1]; sorted[to + 2] = triangles[3 * t + 2];
    }
  return 3 * count;
}
function draw() {
  look();
  gl.viewport(0, 0, gl.canvas.width, gl.canvas.height); gl.enable(gl.DEPTH_TEST); gl.depthMask(true); gl.disable(gl.BLEND); // The mask holds for clearing, too.
  gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  for (const [name, value] of Object.entries({eye, right, up, ahead})) gl.uniform3fv(uniform[name], value);
  const y = 1 / Math.tan(kHalfAngle); gl.uniform3f(uniform.lens, y * size[1] / size[0], y, Math.max(far - 2 * lesson.radius, far / 50));
  setPlane(cutting());
  for (const s of drawnOf()) if (seenOf(s) >= 1) { drawRange(s); if (cutting()) drawFace(s); }
  drawCords();
  const count = sortTranslucent(); if (!count) return;
  gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, triangles.byteLength, sorted.subarray(0, count));
  gl.enable(gl.BLEND); gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA); gl.depthMask(false);
  gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, triangles.byteLength);
}
const drawRange = s => gl.drawElements(gl.TRIANGLES, 3 * s.triangleCount, gl.UNSIGNED_INT, 12 * s.firstTriangle);
