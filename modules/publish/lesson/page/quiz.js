// A quiz: names of parts and valves, phases, what shrinks. Nothing of it leaves the page.
const kQuestions = 8, kShown = 4, quiz = {on: false, vertex: -1, around: -1, asked: 0, right: 0, answer: -1, item: null, done: new Set(), questions: kQuestions};
const anyOf = list => list[Math.floor(Math.random() * list.length)], shuffled = list => list.map(x => [Math.random(), x]).sort((a, b) => a[0] - b[0]).map(x => x[1]);
/** The answer among others: those that come first in their list are kept, in any order. */
const choicesOf = (answer, others) => shuffled([answer, ...[...new Set(others)].filter(x => x !== answer).slice(0, kShown - 1)]);
/** Looks at a vertex as its surface faces, a little from the front. */
const faceVertex = vertex => { if (opened()) faceCut(); else lookAlong(normalOf(vertex).map((x, i) => i === 2 ? -x / 2 : -x), lesson.center, lesson.radius / Math.sin(kHalfAngle)); look(); };
/** How much of a surface is seen when a name is asked: outer parts on an opaque wall, what is in it through the wall as glass. */
const opacityFor = (s, item) => !s.wall || item && item.s === s ? 1 : 0.3;
const showFor = item => surfaces.forEach(s => setOpacity(s, opacityFor(s, item)));
/** The vertex at which a name can be asked, where nothing hides it and no other name is nearer; -1: nowhere. */
function askedAt(item) {
  const others = nameItems.filter(i => i.part && i !== item), own = item.part ? 0 : 0.12 * lesson.radius;
  for (const s of surfaces) s.now = opacityFor(s, item);
  for (const v of item.part ? [item.vertex] : item.s.free.slice(0, 2 * kTried)) {
    faceVertex(v); findMiddles();
    const p = project(placeOf(v)), near = i => { const q = project(placeOf(i.vertex)); return Math.hypot(q[0] - p[0], q[1] - p[1]) < 24; };
    if (!item.ring && facing(item.s, v) <= kFacing || isHidden(item.s, v, item.ring)) continue;
    if (others.every(i => apart(i.vertex, v) > own && !(near(i) && !isHidden(i.s, i.vertex, i.ring)))) return v;
  }
  return -1;
}
/** All that can be asked at this instant, with the vertices that are marked: parts, and organs that have nothing in them. */
const askable = () => nameItems.filter(i => i.part || !i.s.wall).map(item => ({item, vertex: askedAt(item)})).filter(a => a.vertex >= 0);
function nameQuestion(valves) {
  const all = shuffled(askable().filter(a => !a.item.ring === !valves)), found = all.find(a => !quiz.done.has(a.item)) || all[0];
  if (!found) return null;
  const {item, vertex} = found, like = i => i.part === item.part && !i.ring === !item.ring, texts = list => shuffled(list.filter(i => i.part || !i.s.wall).map(i => i.text));
  quiz.done.add(item); showFor(item); faceVertex(vertex); Object.assign(quiz, {vertex, item});
  return {text: say('askName'), answer: item.text, choices: choicesOf(item.text, texts(nameItems.filter(like)).concat(texts(nameItems)))};
}
function phaseQuestion() {
  const phases = motion.phases[state.rate].filter(p => p[2] - p[1] > 0.02), [name, from, to] = anyOf(phases);
  seek((from + to) / 2); quiz.around = state.fraction;
  return {text: say('askPhase'), answer: name, choices: choicesOf(name, shuffled(motion.phases[state.rate].map(p => p[0])))};
}
/** Whether a surface shrinks at an instant: 1, 0, or null where nobody could tell. */
function shrinks(s, at) {
  const curve = curveOf(s), change = (valueOn(curve, mod(at + 0.03, 1)) - valueOn(curve, mod(at - 0.03, 1))) / (Math.max(...curve) - Math.min(...curve));
  return change < -0.09 ? 1 : change > -0.015 ? 0 : null;
}
function shrinkQuestion() {
  const instants = [...Array(50).keys()].map(i => i / 50).filter(at => chambers.every(s => shrinks(s, at) !== null));
  if (!instants.length) return phaseQuestion();
  seek(anyOf(instants)); quiz.around = state.fraction;
  const small = chambers.filter(s => shrinks(s, state.fraction)), both = [...chambers.map(s => s.title), say('all'), say('none')];
  return {text: say('askShrinks'), answer: small.length === chambers.length ? say('all') : small.length ? small[0].title : say('none'), choices: both};
}
const chambers = charted.filter(s => s.ejects).slice(0, 2);
const kinds = [nameItems.length > 1 && (() => nameQuestion(false)), nameItems.some(i => i.ring) && (() => nameQuestion(true)), motion && motion.phases[0].length > 1 && phaseQuestion, chambers.length > 1 && shrinkQuestion].filter(Boolean);
function askNext() {
  Object.assign(quiz, {vertex: -1, around: -1, item: null}); $('verdict').textContent = ''; $('choices').replaceChildren(); $('next').disabled = true;
  if (quiz.asked === kQuestions) {
    $('question').textContent = say('done', quiz.right, quiz.asked); $('score').textContent = ''; quiz.asked = quiz.right = 0; quiz.done.clear(); $('next').disabled = false;
    $('next').textContent = say('again'); $('next').focus(); return;
  }
  showFor(null);
  const asked = kinds.reduce((found, _, k) => found || kinds[(quiz.asked + k) % kinds.length](), null); if (!asked) return setQuiz(false);
  const {text, answer, choices} = asked;
  quiz.answer = choices.indexOf(answer); $('score').textContent = quiz.asked ? say('score', quiz.right, quiz.asked) : ''; $('question').textContent = text; $('next').textContent = say('next'); turned = true;
  choices.forEach((choice, i) => { const b = element('button', choice); b.dir = 'auto'; b.onclick = () => judge(i); $('choices').append(b); });
  $('question').focus();
}
function judge(choice) {
  const boxes = [...$('choices').children], right = choice === quiz.answer;
  ++quiz.asked; quiz.right += right;
  boxes.forEach((b, i) => { b.disabled = true; if (i === quiz.answer) b.classList.add('right'); else if (i === choice) b.classList.add('wrong'); });
  $('verdict').textContent = right ? say('rightAnswer') : say('wrongAnswer', boxes[quiz.answer].textContent);
  $('score').textContent = say('score', quiz.right, quiz.asked); $('next').disabled = false; $('next').focus();
}
function setQuiz(on) {
  if (on && !quiz.on) { quiz.before = surfaces.map(s => s.now); quiz.done.clear(); } else if (!on && quiz.on) surfaces.forEach((s, i) => setOpacity(s, quiz.before[i]));
  Object.assign(quiz, {on, vertex: -1, around: -1, item: null, asked: 0, right: 0});
  document.body.classList.toggle('asking', on); $('quiz').hidden = !on; $('panel').hidden = on; $('score').textContent = '';
  if (on) { setPlaying(false); showHandles(false); reset(); for (const s of surfaces) showSurface(s, true); showHeart(); askNext(); } else { showHeart(); $('ask').focus(); }
  turned = changed = true;
}
