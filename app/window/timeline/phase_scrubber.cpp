#include "window/timeline/phase_scrubber.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

#include "signs/beat_drawing.h"
#include "viscera/scene/label_layout.h"
#include "window/style/language.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {
constexpr double kStripHeight = 18;
constexpr double kBelow = 4; ///< Between the strip and the names.
constexpr double kBetweenNames = 10;
constexpr double kBesideGroup = 4;        ///< Between a group's name and its bracket,
constexpr double kBracketEnd = 6;         ///< which has so much at each side at least.
constexpr std::size_t kMostDistinct = 12; ///< More phases than that are numbered keys.
constexpr double kMarkRadius = 3;         ///< Of the faintest mark; the strongest is as much larger again.
constexpr double kPartAKeyPress = 0.01;
} // namespace

PhaseScrubber::PhaseScrubber(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Instant of the cycle"));
  setCursor(Qt::PointingHandCursor);
}

QString phaseText(const sequences::Phase& phase, double periodSeconds) {
  const double period = 1000 * periodSeconds;
  // A stomach's wave lasts for many seconds: no milliseconds are shown.
  if (phase.group.empty() || period * (phase.end - phase.begin) <= 0)
    return inWords(phase.name);
  return PhaseScrubber::tr("%1 (%2\u2013%3 ms)")
      .arg(inWords(phase.name), formatNumber(period * phase.begin, 0), formatNumber(period * phase.end, 0));
}

void PhaseScrubber::setPhases(std::vector<sequences::Phase> phases, double periodSeconds) {
  phases_ = std::move(phases);
  periodSeconds_ = periodSeconds;
  updateGeometry();
  update();
}

void PhaseScrubber::setCourse(std::vector<sequences::NamedPlace> course) {
  course_ = std::move(course);
  marks_.clear();
  update();
}

void PhaseScrubber::setMarks(std::vector<sequences::TravellingMark> marks) {
  marks_ = std::move(marks);
  update();
}

void PhaseScrubber::setFraction(double fraction) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (fraction == fraction_)
    return;
  fraction_ = fraction;
  update();
}

QString PhaseScrubber::phaseName() const {
  const sequences::Phase* phase = phaseAt(fraction_);
  return phase ? inWords(phase->name) : QString();
}

QString PhaseScrubber::phaseText() const {
  const sequences::Phase* phase = phaseAt(fraction_);
  return phase ? app::phaseText(*phase, periodSeconds_) : QString();
}

QSize PhaseScrubber::sizeHint() const {
  const int lines = groups().empty() ? 1 : 2;
  return {400, static_cast<int>(5 + kStripHeight + kBelow) + lines * fontMetrics().height() + 4};
}

bool PhaseScrubber::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    const sequences::Phase* phase = phaseAt(fractionAt(help->pos().x()));
    const QString keys = tr("Drag, or use the arrow keys");
    QToolTip::showText(help->globalPos(),
                       phase ? tr("%1\n%2").arg(app::phaseText(*phase, periodSeconds_), keys) : keys, this);
    return true;
  }
  return QWidget::event(event);
}

void PhaseScrubber::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = strip();
  const QColor ink = palette().color(QPalette::WindowText);
  const QColor accent = palette().color(QPalette::Highlight);
  QPainterPath outline;
  outline.addRoundedRect(area, 4, 4);
  painter.save();
  painter.setClipPath(outline);
  painter.fillRect(area, palette().color(QPalette::Base));
  paintPhases(painter, area);
  QColor passed = accent;
  passed.setAlphaF(0.25);
  painter.fillRect(QRectF(area.left(), area.top(), fraction_ * area.width(), area.height()), passed);
  painter.restore();
  painter.setPen(QPen(hasFocus() ? accent : palette().color(QPalette::Mid), 1));
  painter.drawPath(outline);
  const double x = area.left() + fraction_ * area.width();
  painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + 2));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawEllipse(QPointF(x, area.top() - 1), 4, 4);
  paintEnds(painter, area);
  paintNames(painter, area);
  paintGroups(painter, area);
  if (!course_.empty())
    paintMarks(painter, area);
}

void PhaseScrubber::setEnds(const std::optional<heart::CycleEnds>& ends) {
  if (ends_ == ends)
    return;
  ends_ = ends;
  update();
}

/// Paints in the strip, so that names and handle keep their places.
void PhaseScrubber::paintEnds(QPainter& painter, const QRectF& area) const {
  if (!ends_)
    return;
  const auto paint = [&](double fraction, const QString& words) {
    const double x = area.left() + fraction * area.width();
    const double wide = painter.fontMetrics().horizontalAdvance(words);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DashLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(palette().color(QPalette::WindowText));
    const double left = x + 3 + wide <= area.right() ? x + 3 : x - 3 - wide;
    painter.drawText(QRectF(left, area.top(), wide + 1, area.height()), Qt::AlignCenter | Qt::TextDontClip,
                     words);
  };
  paint(ends_->diastole, tr("ED"));
  paint(ends_->systole, tr("ES"));
}

void PhaseScrubber::paintPhases(QPainter& painter, const QRectF& area) const {
  QColor band = palette().color(QPalette::WindowText);
  bool shaded = false;
  for (const sequences::Phase& phase : phases_) {
    const QRectF part(area.left() + phase.begin * area.width(), area.top(),
                      (phase.end - phase.begin) * area.width(), area.height());
    band.setAlphaF(&phase == phaseAt(fraction_) ? 0.22 : shaded ? 0.05 : 0.11);
    painter.fillRect(part, band);
    shaded = !shaded;
  }
}

std::vector<PhaseScrubber::Name> PhaseScrubber::names() const {
  const QRectF area = strip();
  std::vector<Name> names;
  for (const sequences::NamedPlace& place : course_)
    names.push_back({inWords(place.name), 0, area.left() + place.place * area.width(), false});
  if (course_.empty())
    for (const sequences::Phase& phase : phases_)
      names.push_back({inWords(phase.name), 0, area.left() + (phase.begin + phase.end) / 2 * area.width(),
                       &phase == phaseAt(fraction_)});
  if (place(names))
    return names;
  if (names.size() > kMostDistinct) // Numbered keys: every second, third, ... name.
    for (std::size_t step = 2;; ++step) {
      std::vector<Name> some;
      for (std::size_t i = 0; i < names.size(); i += step)
        some.push_back(names[i]);
      if (place(some) || some.size() == 1)
        return some;
    }
  do // The longest name goes first; that of the present phase stays.
    names.erase(std::max_element(names.begin(), names.end(), [](const Name& a, const Name& b) {
      return a.present != b.present ? a.present : a.text.size() < b.text.size();
    }));
  while (!place(names));
  return names;
}

bool PhaseScrubber::place(std::vector<Name>& names) const {
  std::vector<double> centers;
  std::vector<double> sizes;
  for (const Name& name : names) {
    centers.push_back(name.at);
    sizes.push_back(fontMetrics().horizontalAdvance(name.text));
  }
  const QRectF area = strip();
  const auto placed = scene::spreadApart(centers, sizes, area.left(), area.right(), kBetweenNames);
  for (std::size_t i = 0; placed && i < names.size(); ++i)
    names[i].center = (*placed)[i];
  return placed.has_value();
}

QStringList PhaseScrubber::namesShown() const {
  QStringList shown;
  for (const Name& name : names())
    shown.push_back(name.text);
  return shown;
}

void PhaseScrubber::paintNames(QPainter& painter, const QRectF& area) const {
  const QColor muted = palette().color(QPalette::PlaceholderText);
  const double top = area.bottom() + kBelow;
  for (const Name& name : names()) {
    const double half = painter.fontMetrics().horizontalAdvance(name.text) / 2.0;
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawLine(QPointF(name.at, area.bottom() + 1),
                     QPointF(std::clamp(name.at, name.center - half, name.center + half), top));
    painter.setPen(name.present ? palette().color(QPalette::WindowText) : muted);
    painter.drawText(QRectF(name.center - half - 1, top, 2 * half + 2, painter.fontMetrics().height()),
                     Qt::AlignCenter | Qt::TextDontClip, name.text);
  }
}

/// A cycle begins within a group: its two ends are one in time, and the longer one carries the name.
std::vector<PhaseScrubber::Group> PhaseScrubber::groups() const {
  std::vector<Group> groups;
  for (const sequences::Phase& phase : phases_) {
    if (phase.group.empty())
      return {};
    const QString name = inWords(phase.group);
    if (groups.empty() || groups.back().text != name)
      groups.push_back({name, phase.begin, phase.end});
    groups.back().end = phase.end;
  }
  const auto lengthOf = [&groups](const QString& name) {
    double length = 0;
    for (const Group& group : groups)
      length += group.text == name ? group.end - group.begin : 0;
    return length;
  };
  const double room = strip().width();
  std::vector<Group> named = groups;
  for (Group& group : named) {
    const QString name = group.text;
    group.text =
        tr("%1 %2 ms").arg(group.text).arg(formatNumber(1000 * periodSeconds_ * lengthOf(group.text), 0));
    // A narrow window has room for the name alone, or for none.
    for (const QString& shorter : {name, QString()})
      if (fontMetrics().horizontalAdvance(group.text) + 2 * (kBesideGroup + kBracketEnd) >
          (group.end - group.begin) * room)
        group.text = shorter;
  }
  if (named.size() > 1 && groups.front().text == groups.back().text)
    (named.front().end - named.front().begin < named.back().end - named.back().begin ? named.front()
                                                                                     : named.back())
        .text.clear();
  return named;
}

QStringList PhaseScrubber::groupsShown() const {
  QStringList shown;
  for (const Group& group : groups())
    if (!group.text.isEmpty())
      shown.push_back(group.text);
  return shown;
}

void PhaseScrubber::paintGroups(QPainter& painter, const QRectF& area) const {
  const double top = area.bottom() + kBelow + painter.fontMetrics().height();
  const double line = top + 0.5 * painter.fontMetrics().height();
  const QColor muted = palette().color(QPalette::PlaceholderText);
  for (const Group& group : groups()) {
    const double left = area.left() + group.begin * area.width() + 1;
    const double right = area.left() + group.end * area.width() - 1;
    const double room =
        group.text.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(group.text) + 2 * kBesideGroup;
    painter.setPen(QPen(muted, 1));
    painter.drawLine(QPointF(left, top + 2), QPointF(left, line));
    painter.drawLine(QPointF(right, top + 2), QPointF(right, line));
    const double middle = 0.5 * (left + right);
    painter.drawLine(QPointF(left, line), QPointF(std::max(left, middle - room / 2), line));
    painter.drawLine(QPointF(std::min(right, middle + room / 2), line), QPointF(right, line));
    painter.drawText(QRectF(middle - room / 2, top, room, painter.fontMetrics().height()),
                     Qt::AlignCenter | Qt::TextDontClip, group.text);
  }
}

/// The waves on their way through the organ, over the names of its places.
void PhaseScrubber::paintMarks(QPainter& painter, const QRectF& area) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Highlight));
  for (const sequences::TravellingMark& mark : marks_) {
    const double radius = kMarkRadius * (1 + mark.strength);
    const QPointF tip(area.left() + mark.place * area.width(), area.bottom() + 1);
    painter.drawPolygon(
        QPolygonF({tip, tip + QPointF(-1.2 * radius, 2 * radius), tip + QPointF(1.2 * radius, 2 * radius)}));
  }
}

void PhaseScrubber::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    scrubTo(fractionAt(event->x()));
}

void PhaseScrubber::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    scrubTo(fractionAt(event->x()));
}

void PhaseScrubber::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Left:
    return scrubTo(fraction_ - kPartAKeyPress);
  case Qt::Key_Right:
    return scrubTo(fraction_ + kPartAKeyPress);
  case Qt::Key_Home:
    return scrubTo(0);
  case Qt::Key_End:
    return scrubTo(1);
  default:
    QWidget::keyPressEvent(event);
  }
}

QRectF PhaseScrubber::strip() const {
  return {kPhaseMargin, 5, width() - 2 * kPhaseMargin, kStripHeight};
}

double PhaseScrubber::fractionAt(double x) const {
  const QRectF area = strip();
  return std::clamp((x - area.left()) / std::max(1.0, area.width()), 0.0, 1.0);
}

const sequences::Phase* PhaseScrubber::phaseAt(double fraction) const {
  for (const sequences::Phase& phase : phases_)
    if (fraction >= phase.begin && fraction < phase.end)
      return &phase;
  return phases_.empty() ? nullptr : &phases_.back();
}

void PhaseScrubber::scrubTo(double fraction) {
  setFraction(fraction);
  Q_EMIT scrubbed(fraction_);
}

} // namespace viscera::app
