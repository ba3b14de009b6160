#include "window/modes/mode_controller.h"

#include <algorithm>

namespace viscera::app {

ModeController::ModeController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  connect(&parts.playback, &Playback::playModeWanted, this, [this] { choose("play"); });
  connect(&parts.view, &ViewWidget::clicked, this, &ModeController::onClick);
  parts.view.addClickTaker([this] { return parts_.handles.underMouse() || modes_[present_]->takesClicks(); });
}

void ModeController::take(std::unique_ptr<Mode> mode) {
  connect(mode.get(), &Mode::shownChanged, this, &ModeController::syncShown);
  connect(mode.get(), &Mode::wanted, this, [this, id = mode->description().id] { choose(id); });
  connect(mode.get(), &Mode::hintChanged, this, [this, added = mode.get()] {
    if (added == modes_[present_].get())
      Q_EMIT hintChanged();
  });
  modes_.push_back(std::move(mode));
  if (modes_.size() == 1)
    begin(0);
}

void ModeController::addTo(Actions& actions) {
  for (const auto& mode : modes_) {
    const Mode::Description& it = mode->description();
    const QByteArray id = QByteArray("mode.") + it.id;
    actions.add(id.constData(), {it.name, it.icon, {QKeySequence(Qt::Key_0 + it.key)}, it.hint},
                [this, chosen = it.id] { choose(chosen); });
  }
}

std::size_t ModeController::rowOf(const std::string& id) const {
  const auto found = std::find_if(modes_.begin(), modes_.end(),
                                  [&id](const auto& mode) { return mode->description().id == id; });
  return found == modes_.end() ? 0 : static_cast<std::size_t>(found - modes_.begin());
}

void ModeController::choose(const std::string& id) {
  const std::size_t row = rowOf(id);
  if (row == present_)
    return;
  if (parts_.handles.cancelDrag())
    Q_EMIT dragUndone();
  modes_[present_]->leave();
  begin(row);
}

void ModeController::begin(std::size_t row) {
  present_ = row;
  Mode& mode = *modes_[row];
  parts_.model.change([&mode](presentation::ViewState& state) {
    state.mode = mode.description().id;
    state.shown = mode.shown();
  });
  parts_.playback.setPose(mode.pose());
  mode.enter();
  syncShown(); // A sequence may be shown now, or no longer.
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

void ModeController::syncShown() {
  if (const presentation::Shown shown = present().shown(); !(parts_.model.state().shown == shown))
    parts_.model.change([&shown](presentation::ViewState& state) { state.shown = shown; });
}

void ModeController::onClick(const QPointF& place, Qt::KeyboardModifiers modifiers) {
  if (parts_.handles.underMouse() || (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)))
    return;
  if (modes_[present_]->press(place))
    return;
  const auto pick = parts_.view.pickNear(place);
  // Surfaces that are being opened or were measured are no organs of the document.
  const document::OrganId organ = pick ? parts_.picture.organOf(pick->organ) : document::OrganId{};
  if (!organ)
    return modes_[present_]->click(nullptr);
  const ClickedPlace clicked{organ, pick->position, pick->normal};
  modes_[present_]->click(&clicked);
}

} // namespace viscera::app
