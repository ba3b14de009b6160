// A quiz: names, phases, what shrinks. Nothing of it leaves the page.
const kQuestions = 6, kShown = 4, quiz = {on: false, vertex: -1, around: -1, asked: 0, right: 0, answer: -1};
const anyOf = list => list[Math.floor(Math.random() * list.length)], shuffled = list => list.map(x => [Math.random(), x]).sort((a, b) => a[0] - b[0]).map(x => x[1]);
const choicesOf = (answer, others) => shuffled([answer, ...shuffled([...new Set(others)].filter(x => x !== answer)).slice(0, kShown - 1)]);
function nameQuestion() {
  const items = nameItems.filter(i => i.s.on), item = anyOf(items), vertex = item.part ? item.vertex : item.s.anchors[0];
  quiz.vertex = vertex; lookAlong(normalOf(vertex).map((x, i) => i === 2 ? -x / 2 : -x), lesson.center, lesson.radius / Math.sin(kHalfAngle));
  return {text: say('askName'), answer: item.text, choices: choicesOf(item.text, items.map(i => i.text))};
}
function phaseQuestion() {
  const phases = motion.phases[state.rate].filter(p => p[2] - p[1] > 0.02), [name, from, to] = anyOf(phases);
  seek((from + to) / 2); quiz.around = state.fraction;
  return {text: say('askPhase'), answer: name, choices: choicesOf(name, motion.phases[state.rate].map(p => p[0]))};
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
const kinds = [nameItems.length > 1 && nameQuestion, motion && motion.phases[0].length > 1 && phaseQuestion, chambers.length > 1 && shrinkQuestion].filter(Boolean);
function askNext() {
  quiz.vertex = quiz.around = -1; $('verdict').textContent = ''; $('choices').replaceChildren(); $('next').disabled = true;
  if (quiz.asked === kQuestions) {
    $('question').textContent = say('done', quiz.right, quiz.asked); quiz.asked = quiz.right = 0; $('next').disabled = false;
    $('score').textContent = ''; $('next').textContent = say('again'); $('next').focus(); return;
  }
  const {text, answer, choices} = kinds[quiz.asked % kinds.length]();
  quiz.answer = choices.indexOf(answer); $('question').textContent = text; $('next').textContent = say('next'); turned = true;
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
  Object.assign(quiz, {on, vertex: -1, around: -1, asked: 0, right: 0});
  document.body.classList.toggle('asking', on); $('quiz').hidden = !on; $('panel').hidden = on; $('score').textContent = '';
  if (on) { setPlaying(false); showHandles(false); reset(); for (const s of surfaces) showSurface(s, true); askNext(); } else $('ask').focus();
  turned = changed = true;
}
