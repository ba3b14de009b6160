// Controls, mouse, fingers, keys, and the loop of frames.
const calm = matchMedia('(prefers-reduced-motion: reduce)'), bright = matchMedia('(prefers-color-scheme: light)');
for (const e of document.querySelectorAll('[data-say]')) e.textContent = say(e.dataset.say);
for (const e of document.querySelectorAll('[data-tip]')) { e.title = say(e.dataset.tip); if (!e.dataset.say) e.setAttribute('aria-label', e.title); }
for (const e of document.querySelectorAll('[data-label]')) e.setAttribute('aria-label', say(e.dataset.label, lesson.title));
$('title').textContent = $('title').title = lesson.title; $('notes').textContent = lesson.notes; $('keyText').textContent = say('keyText') + (tissue || conduction ? '\n' + say('heartKeys') : '');
for (const name of Object.keys(sides)) $('side').append(Object.assign(element('option', say(name)), {value: name}));
for (const speed of [1, 0.5, 0.25, 0.1]) $('speed').append(Object.assign(element('option', number(speed, speed % 1 ? 2 : 0) + '\u00D7'), {value: speed}));
for (const [id, act] of Object.entries({play: () => setPlaying(!state.playing), theme: () => setLight(!document.documentElement.classList.contains('light')),
  labels: () => showNames(!named()), grips: () => showHandles(!state.handles), cut: () => setCut(!cut.on), blood: () => setBlood(!cut.blood), conduct: () => setConduction(!lit), undo: reset, ask: () => setQuiz(!quiz.on), next: askNext, leave: () => setQuiz(false),
  before: () => showSlide(slide - 1), after: () => showSlide(slide + 1)})) $(id).onclick = act;
$('side').onchange = e => setSide(e.target.value); $('speed').onchange = e => { state.speed = +e.target.value; };
$('time').oninput = e => { setPlaying(false); seek(Math.min(+e.target.value, 0.9999)); };
$('rate').oninput = e => setRate(+e.target.value); $('opacity').oninput = e => setGlass(+e.target.value);
bright.onchange = () => setLight(bright.matches);
const pick = by => { if (!state.handles) showHandles(true); state.held = mod(state.held + (state.held < 0 && by < 0 ? 0 : by), handles.length || 1); $('held').textContent = say('held', handles[state.held].label); turned = true; };
const keys = {' ': () => setPlaying(!state.playing), Home: () => seek(0), n: () => showNames(!named()), h: () => showHandles(!state.handles), r: reset, t: () => $('theme').click(),
  c: () => setCut(!cut.on), f: () => cut.on && setBlood(!cut.blood), e: () => setConduction(!lit),
  x: () => setGlass(surfaces.some(s => s.wall && s.now < 1) ? 1 : 0.3), 1: () => setSide('anterior'), 3: () => setSide('left'), 7: () => setSide('superior'),
  j: () => handles.length && pick(1), k: () => handles.length && pick(-1), PageDown: () => turnPage(1), PageUp: () => turnPage(-1), b: () => darken(), Escape: () => { darken(false); state.held = -1; $('held').textContent = ''; turned = true; if (quiz.on) setQuiz(false); },
  '+': () => state.held >= 0 ? pullBy(state.held, 0, 0, 2) : zoomBy(1.15), '-': () => state.held >= 0 ? pullBy(state.held, 0, 0, -2) : zoomBy(1 / 1.15)};
const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
addEventListener('keydown', e => {
  const to = e.target.tagName; // What a control does with a key itself is left to it.
  if (e.ctrlKey || e.metaKey || e.altKey || /INPUT|SELECT/.test(to) && e.key !== 'Escape' || /BUTTON|SUMMARY/.test(to) && /^( |Enter)$/.test(e.key)) return;
  const by = arrows[e.key], far = e.shiftKey ? 5 : 1;
  if (by && state.held >= 0) pullBy(state.held, by[0] * 2 * far, by[1] * 2 * far, 0);
  else if (by && e.target === $('view')) turnBy(by[0] * 0.09 * far, by[1] * 0.09 * far);
  else if (by && by[0] && motion) { setPlaying(false); seek(state.fraction + by[0] * 0.02); }
  else { const act = keys[e.key] || keys[e.key.toLowerCase()]; if (!act) return; act(); }
  turned = true; e.preventDefault();
});
addEventListener('pointerdown', () => darken(false), true);
// One finger turns or drags a handle, two come nearer and push aside; wheel; Shift or the right button pushes aside.
const view = $('view'), fingers = new Map(); let dragging = false;
view.onpointerdown = e => {
  view.setPointerCapture(e.pointerId); fingers.set(e.pointerId, [e.offsetX, e.offsetY]); dragging = false;
  if (!state.handles || fingers.size > 1) return;
  let best = e.pointerType === 'touch' ? kTouch : kMouse;
  handles.forEach((h, i) => { const [x, y] = project(placeOf(h.vertex)), d = Math.hypot(x - e.offsetX, y - e.offsetY); if (d < best) { best = d; state.held = i; dragging = true; } });
};
view.onpointermove = e => {
  const before = fingers.get(e.pointerId), now = [e.offsetX, e.offsetY]; if (!before) return;
  const dx = now[0] - before[0], dy = now[1] - before[1], other = [...fingers].find(([id]) => id !== e.pointerId);
  if (dragging) { const mm = project(placeOf(handles[state.held].vertex))[2] / pixels(); pullBy(state.held, dx * mm, -dy * mm, 0); }
  else if (other) { zoomBy(Math.hypot(now[0] - other[1][0], now[1] - other[1][1]) / (Math.hypot(before[0] - other[1][0], before[1] - other[1][1]) || 1)); pushBy(dx / 2, dy / 2); }
  else if (e.buttons & 6 || e.shiftKey) pushBy(dx, dy); else turnBy(dx * 0.008, dy * 0.008);
  fingers.set(e.pointerId, now); turned = true;
};
view.onpointerup = view.onpointercancel = e => { fingers.delete(e.pointerId); if (dragging) state.held = -1; dragging = false; turned = true; };
view.addEventListener('wheel', e => { e.preventDefault(); zoomBy(Math.exp(-e.deltaY * 0.001)); turned = true; }, {passive: false});
view.oncontextmenu = e => e.preventDefault();
$('chart').onpointerdown = $('chart').onpointermove = e => { if (e.buttons) { setPlaying(false); seek(Math.max(0, Math.min(0.9999, (e.offsetX - kLeft) / ($('chart').clientWidth - kLeft - kRight)))); } };
const times = {pose: 0, shade: 0, volume: 0, draw: 0, frames: 0}, timed = (name, act) => { const begin = performance.now(); act(); times[name] += performance.now() - begin; };
function render() {
  const ratio = Math.min(devicePixelRatio || 1, 2), box = $('stage').getBoundingClientRect();
  size = [Math.max(box.width, 1), Math.max(box.height, 1)]; toolsHigh = Math.max(40, $('tools').offsetHeight); look();
  for (const id of ['view', 'over']) { const [w, h] = size.map(x => Math.round(x * ratio)); if ($(id).width !== w || $(id).height !== h) Object.assign($(id), {width: w, height: h}); }
  if (changed) {
    timed('pose', pose); timed('shade', shade); timed('volume', writeNumbers); send(0, points); send(1, normals);
    if (pullsChanged && (!dragging || performance.now() - lastBeat > 200)) { writeIndices(); pullsChanged = false; lastBeat = performance.now(); }
    if (motion) { writePhase(); drawChart(); drawStrain(); }
  }
  timed('draw', () => { draw(); drawOver(); }); ++times.frames; press('labels', named());
  changed = pullsChanged; turned = false;
}
let last = 0; function frame(now) {
  const seconds = Math.min((now - last) / 1000, 0.1), cycles = motion ? seconds * state.speed * motion.rates[state.rate] / 60 : 0;
  last = now;
  if (state.playing && !dragging) seek(state.fraction + cycles);
  if (quiz.around >= 0 && !calm.matches) seek(quiz.around + 0.03 * Math.sin(now / 700));
  if (changed || turned || stale && performance.now() - lastBehind > 300) render();
  requestAnimationFrame(frame);
}
new ResizeObserver(() => { turned = changed = true; shortenPhases(); }).observe($('stage'));
$('motion').hidden = $('pace').hidden = !motion; $('chart').hidden = !charted.length; $('chart').setAttribute('aria-label', say('chart', charted.map(s => s.title).join(', ')));
$('glass').hidden = !surfaces.some(s => s.wall); $('grips').hidden = !handles.length; $('slides').hidden = !slides.length; $('ask').hidden = !kinds.length;
$('cut').hidden = $('blood').hidden = !tissue; $('conduct').hidden = !conduction; showHeart();
setLight(bright.matches); for (const s of surfaces) setOpacity(s, s.opacity);
$('opacity').value = Math.min(...surfaces.filter(s => s.wall).map(s => s.opacity), 1);
if (motion) { $('rate').max = motion.rates.length - 1; $('rates').hidden = motion.rates.length < 2; setRate(state.rate); }
setPlaying(!calm.matches); if (slides.length) showSlide(0);
if (lesson.eye && !(slides[0] || {}).position) lookFrom(lesson.eye);
/** For tests: all that the controls do, and the numbers behind the picture. */
window.viscera = {lesson, state, camera, times, points, surfaces, handles, quiz, gl, seek, setRate, setPlaying, setGlass, setLight, showHandles, showNames, showSlide, showSurface, setSide, setQuiz, judge, askable, shortOf, nameItems, isHidden, reset, render, project, placeOf, cut, tissue, conduction, opened, isCutAway, setCut, setBlood, setConduction, excitationMs, lightOf, cordColors, ecgOf: conduction && ecgOf,
  pull: (h, by) => { handles[h].pull = [...by]; takePulls(); pullsChanged = changed = true; }, volumes: () => surfaces.map(s => volumeOf(s)), measures: () => measurements.map(m => measure(m).value)};
$('failure').hidden = true; render(); requestAnimationFrame(frame); document.documentElement.dataset.ready = Math.round(performance.now());
