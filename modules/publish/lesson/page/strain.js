// The bull's eye of the left ventricle's segments, which follows the beat. Red shortens, blue lengthens, white is zero.
const strained = motion && lesson.strain, kRings = 4, kEyeTitle = 20, kEyeRim = 4, kDark = 0.55;
if (strained) { $('strain').hidden = false; $('strain').setAttribute('aria-label', strained.title); }
/** Of a segment at the present moment, in per cent; null where it is not known. */
function strainOf(segment) {
  const course = strained.courses[motion.courses[state.rate]], at = course.at, n = at.length, next = at.findIndex(f => f > state.fraction), b = next < 0 ? n : next;
  if (!motion.cycles && (b === 0 || b === n)) return course.percent[b === 0 ? 0 : n - 1][segment];
  const from = course.percent[mod(b - 1, n)][segment], to = course.percent[b % n][segment], begin = b ? at[b - 1] : at[n - 1] - 1, end = b < n ? at[b] : at[0] + 1;
  return from === null || to === null ? null : from + (to - from) * (state.fraction - begin) / (end - begin || 1);
}
function strainColor(part) {
  const share = Math.min(1, Math.abs(part)) ** 0.85, end = part < 0 ? [178, 24, 43] : [33, 102, 172];
  return `rgb(${end.map(x => Math.round(255 + (x - 255) * share)).join()})`;
}
function drawStrain() {
  const canvas = $('strain'), ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (!strained || !w) return;
  canvas.width = w * ratio; canvas.height = h * ratio;
  const c = canvas.getContext('2d'), radius = Math.max(1, Math.min(w / 2, (h - kEyeTitle) / 2) - kEyeRim), x = w / 2, y = (h + kEyeTitle) / 2;
  c.scale(ratio, ratio); c.font = '12px system-ui,sans-serif'; c.textAlign = 'center';
  c.fillStyle = css('--muted'); c.fillText(`${strained.title} (%)`, x, 13);
  strained.sectors.forEach(([ring, low, high], segment) => {
    const value = strainOf(segment), outer = radius * (kRings - ring) / kRings, inner = radius * (kRings - 1 - ring) / kRings;
    const from = -high * Math.PI / 180, to = -low * Math.PI / 180, middle = (from + to) / 2, r = inner > 0 ? (outer + inner) / 2 : 0;
    c.beginPath(); c.arc(x, y, outer, from, to); if (inner > 0) c.arc(x, y, inner, to, from, true); c.closePath();
    c.fillStyle = value === null ? css('--line') : strainColor(value / strained.range); c.fill(); c.strokeStyle = css('--panel'); c.stroke();
    if (value === null) return;
    c.fillStyle = Math.abs(value) > kDark * strained.range ? '#fff' : '#222'; c.fillText(number(value, 0), x + r * Math.cos(middle), y + r * Math.sin(middle) + 4);
  });
}
