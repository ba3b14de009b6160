#include "window/track/contour_grip.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>

#include <utility>

#include "window/style/language.h"

namespace viscera::app {

ContourGrip::ContourGrip(Workspace& workspace, SlicePanes& panes, ContourCorrector& corrector,
                         Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), panes_(panes), corrector_(corrector), playback_(playback) {
  // What was dragged stays visible until the motion meets it.
  connect(&corrector, &ContourCorrector::ended, this, [this] { panes_.setBent(std::nullopt); });
}

ContourGrip::~ContourGrip() = default;

void ContourGrip::addTo(Actions& actions, QMenu& menu) {
  QAction* toggle = actions.addToggle(
      "study.correctContours",
      {tr("Correct &contours"),
       nullptr,
       {},
       tr("Drag the contour of a tracked organ in a slice: the motion is fitted to it. Ctrl does the same "
          "while it is held. Enabled for a motion that was found in images")},
      false, [this](bool on) { on_ = on; });
  actions.enableWhile({"study.correctContours"}, [this] { return corrector_.available(); });
  corrections_.setTitle(tr("&Remove a corrected contour"));
  connect(&corrections_, &QMenu::aboutToShow, this, &ContourGrip::fillMenu);
  menu.addSeparator();
  menu.addAction(toggle);
  QAction* removals = menu.addMenu(&corrections_);
  actions.onSync(
      [this, removals] { removals->setEnabled(!workspace_.state().keySequence->corrections.empty()); });
}

void ContourGrip::fillMenu() {
  corrections_.clear();
  const auto& corrections = workspace_.state().keySequence->corrections;
  for (std::size_t i = 0; i < corrections.size(); ++i)
    corrections_.addAction(tr("%1, slice %2, phase %3")
                               .arg(text(corrections[i].surface))
                               .arg(corrections[i].slice + 1)
                               .arg(corrections[i].phase + 1),
                           this, [this, i] { corrector_.remove(i); });
}

std::optional<presentation::ContourPlace> ContourGrip::placeAt(int direction,
                                                               const Eigen::Vector2d& pixel) const {
  return panes_.cineNow().presenter().contourAt(direction, pixel, panes_.reach(direction));
}

/// The pose that is bent is that of a phase: the motion goes to the nearest one first.
bool ContourGrip::press(int direction, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
  if ((!on_ && (modifiers & Qt::ControlModifier) == 0) || !corrector_.available() ||
      !placeAt(direction, pixel))
    return false;
  const auto [phase, fraction] = corrector_.phaseAt(playback_.player().fraction());
  playback_.pause();
  playback_.seek(fraction);
  const auto place = placeAt(direction, pixel);
  if (!place)
    return false;
  if (const QString refusal = corrector_.refusal(phase, place->organ); !refusal.isEmpty()) {
    workspace_.note(refusal);
    return false;
  }
  const presentation::CinePresenter& presenter = panes_.cineNow().presenter();
  const Vec3 mouse = presenter.frame(direction).at(pixel.x(), pixel.y());
  held_.emplace(Held{presentation::ContourBend(presenter.cut(direction, place->organ), place->place),
                     place->organ, phase, presenter.slice(direction), place->place - mouse});
  qApp->installEventFilter(this);
  return true;
}

void ContourGrip::drag(int direction, const Eigen::Vector2d& pixel) {
  if (!held_)
    return; // Escape has cancelled it.
  held_->bend.dragTo(panes_.cineNow().frame(direction).at(pixel.x(), pixel.y()) + held_->offset);
  show(direction);
}

void ContourGrip::show(int direction) {
  panes_.setBent(
      presentation::BentContour{direction, held_->organ, held_->bend.points(), held_->bend.closed()});
}

void ContourGrip::drop() {
  qApp->removeEventFilter(this);
  held_.reset();
}

void ContourGrip::release(int, const Eigen::Vector2d&, bool moved) {
  if (!held_)
    return;
  const Held held = *held_;
  drop();
  if (!moved)
    return panes_.setBent(std::nullopt);
  live::ContourCorrection correction;
  correction.phase = held.phase;
  correction.slice = held.slice;
  correction.surface = corrector_.surfaceOf(held.organ);
  correction.points = held.bend.corrected();
  corrector_.correct(correction, held.bend.covered());
}

std::optional<Qt::CursorShape> ContourGrip::hover(int direction,
                                                  const std::optional<Eigen::Vector2d>& pixel) {
  const bool wanted = on_ || (QApplication::keyboardModifiers() & Qt::ControlModifier) != 0;
  if (!pixel || !wanted || !corrector_.available() || !placeAt(direction, *pixel))
    return std::nullopt;
  return Qt::PointingHandCursor;
}

bool ContourGrip::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!held_ || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return QObject::eventFilter(watched, event);
  drop();
  panes_.setBent(std::nullopt);
  event->accept();
  return true;
}

} // namespace viscera::app
