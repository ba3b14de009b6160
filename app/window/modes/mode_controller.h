#pragma once

#include <QObject>

#include <memory>
#include <string>
#include <vector>

#include "window/modes/mode.h"
#include "window/view/handle_controller.h"
#include "window/view/picture.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/work/actions.h"

namespace viscera::app {

/// Switches between the modes of the window. It holds the current mode, and writes what that mode shows into
/// the view's state, from which the views are drawn.
class ModeController final : public QObject {
  Q_OBJECT

public:
  /// The parts of the window that modes change or whose mouse events they handle; all have to live longer.
  struct Parts {
    Playback& playback;
    ViewModel& model;
    ViewWidget& view;
    const Picture& picture;
    HandleController& handles;
  };

  explicit ModeController(const Parts& parts, QObject* parent = nullptr);

  /// Adds a mode after the others in the rail. The first one is the current mode at the start.
  template <typename AnyMode>
  AnyMode& add(std::unique_ptr<AnyMode> mode) {
    AnyMode& added = *mode;
    take(std::move(mode));
    return added;
  }
  /// Adds "mode.explore" and so on, which choose a mode.
  void addTo(Actions& actions);

  const std::vector<std::unique_ptr<Mode>>& all() const { return modes_; }
  /// The current mode. Requires at least one mode.
  const Mode& present() const { return *modes_[present_]; }
  /// Index of the present mode in `all`.
  int index() const { return static_cast<int>(present_); }
  /// The mode of that id; the first one when there is none.
  const Mode& find(const std::string& id) const { return *modes_[rowOf(id)]; }
  /// Changes to the mode of that id, or to the first one.
  void choose(const std::string& id);
  /// Cancels the present drag, or else what the user is doing in the mode; false when there is nothing to
  /// cancel.
  bool escape() { return parts_.handles.cancelDrag() || modes_[present_]->escape(); }

Q_SIGNALS:
  /// A mode was chosen during a drag, which was therefore cancelled.
  void dragUndone();
  /// Another mode is on.
  void changed();
  /// The present mode has another hint.
  void hintChanged();

private:
  void take(std::unique_ptr<Mode> mode);
  std::size_t rowOf(const std::string& id) const;
  void begin(std::size_t row);
  void onClick(const QPointF& place, Qt::KeyboardModifiers modifiers);
  void syncShown();

  Parts parts_;
  std::vector<std::unique_ptr<Mode>> modes_;
  std::size_t present_ = 0;
};

} // namespace viscera::app
