#pragma once

#include <QObject>

#include <functional>

#include "viscera/presentation/view_state.h"
#include "window/actions.h"

namespace viscera::app {

/// Holds how the document is shown (colours, labels, cuts, slices), shared by all parts of the window: they
/// read and change it, the presenter draws it, a session saves it. Actions only switch it. Selection, camera,
/// motions and the shown pose are kept where they live and gathered when a session is saved.
///
///     view.change([](presentation::ViewState& state) { state.ghost = true; });
class ViewModel final : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  const presentation::ViewState& state() const { return state_; }
  /// Edits the state; tells only when it has become another one.
  void change(const std::function<void(presentation::ViewState&)>& edit);
  /// An action that shows and switches one part of the state, however that is changed.
  QAction* addToggle(Actions& actions, const char* id, const Actions::Description& description,
                     std::function<bool&(presentation::ViewState&)> part);

Q_SIGNALS:
  /// The state is another one. Whoever hears it reads the whole state.
  void changed();

private:
  presentation::ViewState state_;
};

} // namespace viscera::app
