// Volumes over one cycle, with bands of what healthy people have.
const charted = motion ? surfaces.filter(s => s.charted && s.curves.length) : [], kLeft = 44, kBelow = 18, kRight = 10;
const bands = lesson.ranges.filter(r => r.kind === 'ml' && charted.includes(surfaces[r.surface]));
/** Writes the bands' texts at their edges where no curve and no other text is in the way; what finds no place is left out. */
function writeBands(c, drawn, X, Y) {
  const taken = [], high = 14, shown = charted.filter(s => s.on);
  for (const r of drawn) {
    const text = say('healthy', r.text), wide = Math.min(c.measureText(text).width, (X(1) - X(0)) * 0.45) + 8, part = wide / (X(1) - X(0));
    const places = [0, 0.25, 0.5, 0.75, 1].flatMap(at => [Y(r.low) - 4, Y(r.high) + 12].map(y => [at * (1 - part), y])).map(([from, y]) => {
      const clear = Math.min(...shown.flatMap(s => [0, 0.25, 0.5, 0.75, 1].map(d => Math.abs(Y(valueOn(curveOf(s), from + d * part)) - y + 4))));
      return {x: X(from) + 4, y, clear, free: taken.every(t => X(from) > t.x + t.wide || X(from) + wide < t.x || Math.abs(t.y - y) > high)};
    }).filter(p => p.free && p.clear > 9).sort((p, q) => q.clear - p.clear);
    if (!places.length) continue;
    taken.push({...places[0], wide}); c.fillStyle = css('--muted'); c.fillText(text, places[0].x, places[0].y, wide - 8);
  }
}
function drawCurve(c, s, curve, X, Y, width) {
  c.strokeStyle = c.fillStyle = s.rgb; c.lineWidth = width; c.beginPath();
  const last = motion.cycles ? curve.length : curve.length - 1;
  for (let i = 0; i <= last; ++i) c.lineTo(X(i / last), Y(curve[i % curve.length]));
  c.stroke();
}
function drawChart() {
  const canvas = $('chart'), ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (!charted.length || !w) return;
  canvas.width = w * ratio; canvas.height = h * ratio;
  const c = canvas.getContext('2d'), shown = charted.filter(s => s.on); c.scale(ratio, ratio); c.font = '12px system-ui,sans-serif';
  const largest = Math.max(...shown.flatMap(curveOf)), drawn = bands.filter(r => surfaces[r.surface].on && r.low < 3 * largest); // Others would press the curves flat.
  const all = shown.flatMap(s => [...curveOf(s), ...(s.pulled || []), s.ml]).concat(drawn.flatMap(r => [r.low, r.high]));
  if (!all.length) return;
  const top = Math.max(...all), flat = Math.max(0, 0.02 * top - (top - Math.min(...all))) / 2; // What hardly changes is to look so.
  const least = Math.min(...all) - flat, most = top + flat, step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].find(m => (most - least) / m < h / 26) || 1000;
  const low = Math.floor(least / step - 0.1) * step, high = Math.ceil(most / step + 0.1) * step;
  const X = f => kLeft + f * (w - kLeft - kRight), Y = v => 6 + (h - kBelow - 6) * (1 - (v - low) / (high - low));
  c.fillStyle = css('--muted'); c.strokeStyle = css('--line');
  for (let v = low; v <= high + step / 2; v += step) { if (v > low) c.fillText(number(v, step < 1 ? 1 : 0), 4, Y(v) + 4); c.beginPath(); c.moveTo(kLeft, Y(v)); c.lineTo(w - kRight, Y(v)); c.stroke(); }
  const seconds = 60 / motion.rates[state.rate];
  const ticks = w < 480 ? 2 : 4;
  for (let i = 0; i <= ticks; ++i) { c.textAlign = i === ticks ? 'right' : 'left'; c.fillText(say('seconds', number(seconds * i / ticks, seconds < 5 ? 2 : 0)), X(i / ticks), h - 3); }
  c.textAlign = 'left'; c.fillText('ml', 4, h - 3);
  for (const r of drawn) {
    c.globalAlpha = 0.17; c.fillStyle = surfaces[r.surface].rgb; c.fillRect(kLeft, Y(r.high), w - kLeft - kRight, Y(r.low) - Y(r.high)); c.globalAlpha = 1;
  }
  if (w >= 560) writeBands(c, drawn, X, Y);
  for (const s of shown) {
    if (s.pulled) { c.setLineDash([4, 4]); drawCurve(c, s, curveOf(s), X, Y, 1.2); c.setLineDash([]); }
    drawCurve(c, s, s.pulled || curveOf(s), X, Y, 2.2);
    c.beginPath(); c.arc(X(state.fraction), Y(s.ml), 4, 0, 7); c.fill();
  }
  c.strokeStyle = css('--text'); c.lineWidth = 1; c.beginPath(); c.moveTo(X(state.fraction), 4); c.lineTo(X(state.fraction), h - kBelow); c.stroke();
}
