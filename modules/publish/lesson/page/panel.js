// Numbers, slides and controls beside the picture.
let changed = true, turned = true, pullsChanged = false, lastBeat = 0; const press = (id, on) => $(id).setAttribute('aria-pressed', on);
const tell = (list, name, value, more) => { const dd = element('dd', value); if (more) dd.append(element('small', more)); $(list).append(element('dt', name), dd); };
for (const s of surfaces) {
  s.tile = element('li', '', 'tile'); s.tile.style.setProperty('--own', s.rgb);
  s.eye = element('button', '', 'sign'); s.value = element('b'); s.part = element('small');
  const title = element('span', s.title); title.dir = 'auto'; title.title = s.title;
  s.eye.setAttribute('aria-label', say('eye', s.title)); s.eye.title = say('eye', s.title);
  s.eye.onclick = () => showSurface(s, !s.on);
  s.tile.append(title, s.value, s.eye, s.part); $('tiles').append(s.tile); s.eye.setAttribute('aria-pressed', true);
}
function showSurface(s, on) {
  s.on = on; s.eye.setAttribute('aria-pressed', on); $('opacity').disabled = opened();
  s.tile.classList.toggle('off', !on); changed = true;
}
function writeNumbers() {
  const pulledNow = pullsOf().length > 0;
  for (const s of surfaces) {
    if (!s.closed) continue;
    s.ml = volumeOf(s);
    const as = pulledNow && motion ? valueOn(curveOf(s), state.fraction) : s.restMl, part = 100 * (s.ml / as - 1);
    s.value.textContent = say('ml', number(s.ml));
    s.part.textContent = say(pulledNow ? 'byHandles' : 'ofRest', (part < -0.05 ? '\u2212' : '+') + number(Math.abs(part)));
  }
  $('undo').hidden = !pulledNow; $('measured').replaceChildren();
  for (const m of measurements) tell('measured', m.title, say(m.kind === 'angle' ? 'degrees' : 'mm', number(measure(m).value)));
}
const beatOf = curve => { const high = Math.max(...curve), low = Math.min(...curve); return {part: 100 * (high - low) / high, stroke: high - low}; };
function writeIndices() {
  const ejecting = motion ? surfaces.filter(s => s.ejects && s.curves.length) : [];
  for (const s of charted) s.pulled = pullsOf().length ? pulledCurve(s) : null;
  $('indices').replaceChildren();
  for (const s of ejecting) {
    const own = beatOf(curveOf(s)), now = s.pulled ? beatOf(s.pulled) : own, was = value => s.pulled ? say('was', value) : '';
    const normal = lesson.ranges.find(r => r.kind === 'percent' && surfaces[r.surface] === s);
    tell('indices', say('ejection', s.title), say('percent', number(now.part)), was(say('percent', number(own.part))) || normal && say('normal', `${number(normal.low, 0)}\u2013${number(normal.high, 0)} %`));
    tell('indices', say('stroke'), say('ml', number(now.stroke)), was(say('ml', number(own.stroke))));
    const output = beat => say('litres', number(beat.stroke * motion.rates[state.rate] / 1000));
    if (s.output) tell('indices', say('output'), output(now), was(output(own)));
  }
}
function writePhase() {
  const phases = motion.phases[state.rate], now = Math.max(0, phases.findIndex(p => state.fraction < p[2]));
  [...$('phases').children].forEach((span, i) => span.classList.toggle('now', i === now));
  const name = phases.length ? phases[now][0] : '';
  if ($('phase').textContent !== name) $('phase').textContent = name;
  $('time').value = state.fraction; $('time').setAttribute('aria-valuetext', say('timeText', number(state.fraction * 60 / motion.rates[state.rate], 2), name));
}
/** The initials of a name's longer words, with as many letters of the first as tell it from all others; AS is aortic stenosis to its readers. */
function shortOf(text, names) {
  const words = t => { const all = t.split(/\s+/), long = all.filter(w => [...w].length > 3); return long.length ? long : all; };
  const short = (t, n) => words(t).map((w, i) => { const l = [...w]; return (l[0] || '').toUpperCase() + (i ? '' : l.slice(1, n).join('').toLowerCase()); }).join('');
  let n = 1; while (n < 9 && (short(text, n) === 'AS' || names.some(other => other !== text && short(other, n) === short(text, n)))) ++n;
  return short(text, n) || '\u2026';
}
/** Where a phase's name finds no room, its short form stands for it. */
function shortenPhases() {
  const spans = [...$('phases').children], names = spans.map(span => span.title);
  for (const span of spans) span.textContent = span.title;
  for (const span of spans) if (span.scrollWidth > span.clientWidth) span.textContent = shortOf(span.title, names);
}
function setRate(index) {
  state.rate = index; $('rate').value = index; pullsChanged = changed = true;
  $('rateText').textContent = say('aMinute', number(motion.rates[index], motion.rates[index] % 1 ? 1 : 0));
  $('rate').setAttribute('aria-valuetext', $('rateText').textContent);
  $('phases').replaceChildren(...motion.phases[index].map(([name, from, to]) => {
    const span = element('span', name); span.title = name; span.style.flex = `${to - from} 1 0`; return span;
  }));
  shortenPhases();
}
function setPlaying(on) {
  state.playing = on && !!motion; $('play').classList.toggle('on', state.playing);
  $('play').setAttribute('aria-label', say(state.playing ? 'stop' : 'play')); $('phase').setAttribute('aria-live', state.playing ? 'off' : 'polite');
}
function seek(fraction) { state.fraction = mod(fraction, 1); changed = true; }
function setGlass(opacity) { for (const s of surfaces) if (s.wall) setOpacity(s, opacity); $('opacity').value = opacity; turned = true; }
function setLight(on) { document.documentElement.classList.toggle('light', on); turned = changed = true; }
function showHandles(on) { state.handles = on && handles.length > 0; state.held = -1; press('grips', state.handles); $('held').textContent = state.handles ? say('hint') : ''; turned = true; }
function showNames(on) { state.names = on; turned = true; }
function reset() { for (const h of handles) h.pull.fill(0); takePulls(); pullsChanged = changed = true; }
function pullBy(handle, dx, dy, dz) {
  const by = handles[handle].pull;
  for (let i = 0; i < 3; ++i) by[i] += right[i] * dx + up[i] * dy - ahead[i] * dz;
  takePulls(); pullsChanged = changed = true;
}
function setSide(name) { [camera.yaw, camera.pitch] = sides[name]; camera.target = [...lesson.center]; camera.zoom = 1; turned = true; $('side').value = name; }
let slide = -1;
function showSlide(index) {
  const s = slides[slide = mod(index, slides.length)];
  $('slideTitle').textContent = say('slide', slide + 1, slides.length, s.title); $('slideText').textContent = s.text;
  if (s.side) setSide(s.side); if (s.position) lookFrom(s);
  surfaces.forEach((surface, i) => showSurface(surface, !s.hidden.includes(i)));
  if ('seeThrough' in s) setGlass(s.seeThrough);
  if (motion && 'rate' in s) setRate(s.rate);
  if (motion && 'fraction' in s) { setPlaying(false); seek(s.fraction); } else setPlaying(!calm.matches);
  if ('names' in s) showNames(s.names ? state.names || null : false);
  if ('cut' in s) setCut(s.cut.on, s.cut);
  showHandles(s.handles);
}
const turnPage = by => { if (slides[slide + by] && !quiz.on) showSlide(slide + by); }, darken = on => document.body.classList.toggle('night', on);
