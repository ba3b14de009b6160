#pragma once

#include <QObject>

#include <functional>

#include "viscera/presentation/view_state.h"
#include "window/work/actions.h"

namespace viscera::app {

/// Holds how the document is shown (colours, labels, cuts, slices), shared by all parts of the window: they
/// read and change it, the presenter draws it, a session saves it. Actions only change it. Selection, camera,
/// motions and the shown pose are kept in other objects and gathered when a session is saved.
///
///     view.change([](presentation::ViewState& state) { state.ghost = true; });
class ViewModel final : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  const presentation::ViewState& state() const { return state_; }
  /// Edits the state; emits `changed` only if it is different afterwards.
  void change(const std::function<void(presentation::ViewState&)>& edit);
  /// Adds a checkable action for one part of the state; it follows changes from elsewhere.
  QAction* addToggle(Actions& actions, const char* id, const Actions::Description& description,
                     std::function<bool&(presentation::ViewState&)> part);

Q_SIGNALS:
  /// The state has changed. Receivers should read the whole state.
  void changed();

private:
  presentation::ViewState state_;
};

} // namespace viscera::app
