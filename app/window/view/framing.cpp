#include "window/view/framing.h"

#include <algorithm>
#include <utility>

namespace viscera::app {

Framing::Framing(Workspace& workspace, ViewModel& view, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), alone_(showsOneAlone()), seen_(seen()) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      onOrgans();
  }));
  // A user who chooses another organ, or another mode, moves the camera himself.
  subscriptions_.push_back(workspace.selection().onChange([this] { seen_ = seen(); }));
  // Other parts of the view may be another one already while a change is being told.
  connect(&view, &ViewModel::changed, this, [this] {
    const bool now = showsOneAlone();
    if (std::exchange(alone_, now) != now)
      seen_ = seen();
  });
}

bool Framing::showsOneAlone() const {
  const presentation::ViewState& state = view_.state();
  return state.shown.stress && !state.stress.others;
}

/// Hidden organs count: showing one of them is no reason to move the camera.
std::vector<document::OrganId> Framing::seen() const {
  std::vector<document::OrganId> organs;
  if (alone_) {
    if (const auto organ = workspace_.currentOrgan())
      organs.push_back(organ->id);
    return organs;
  }
  for (const auto& organ : workspace_.document().organs())
    organs.push_back(organ->id);
  return organs;
}

/// Does not frame the organs of a session that was just opened: it has a camera of its own, and no steps yet.
/// When this is called, no signal has been sent yet of a selection that the change removed, so `seen_` is
/// still of the time before.
void Framing::onOrgans() {
  const std::vector<document::OrganId> now = seen();
  const std::vector<document::OrganId> before = std::exchange(seen_, now);
  const bool others = !before.empty() && !now.empty() &&
                      std::none_of(now.begin(), now.end(), [&before](document::OrganId organ) {
                        return std::find(before.begin(), before.end(), organ) != before.end();
                      });
  if (others && !workspace_.undo().names().empty())
    Q_EMIT wanted();
}

} // namespace viscera::app
