#include "window/view/view_model.h"

#include <QAction>

#include <utility>

namespace viscera::app {

void ViewModel::change(const std::function<void(presentation::ViewState&)>& edit) {
  presentation::ViewState edited = state_;
  edit(edited);
  if (edited == state_)
    return;
  state_ = std::move(edited);
  Q_EMIT changed();
}

QAction* ViewModel::addToggle(Actions& actions, const char* id, const Actions::Description& description,
                              std::function<bool&(presentation::ViewState&)> part) {
  QAction* action = actions.addToggle(id, description, part(state_), [this, part](bool on) {
    change([&](presentation::ViewState& state) { part(state) = on; });
  });
  connect(this, &ViewModel::changed, action, [this, action, part] {
    presentation::ViewState now = state_;
    action->setChecked(part(now));
  });
  return action;
}

} // namespace viscera::app
