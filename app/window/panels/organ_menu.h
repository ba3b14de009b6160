#pragma once

#include <QMenu>

#include <functional>
#include <vector>

#include "window/pose_editor.h"
#include "window/workspace.h"

class QAction;

namespace viscera::app {

/// The menu of what can be done to the chosen organs, in the list and in the view. What it does is done to
/// all of them in one undo step.
class OrganMenu final : public QMenu {
  Q_OBJECT

public:
  using Chosen = std::function<std::vector<document::OrganId>()>;

  /// All have to live longer; `chosen` says which organs are meant.
  OrganMenu(Workspace& workspace, PoseEditor& poses, Chosen chosen, QWidget* parent);

  /// Adds "volume.lock", and fills the menu with that and with the actions of the list and the view, which
  /// have to be there.
  void addTo(Actions& actions);
  /// Lets the user choose a colour for organs, beside what was clicked.
  void chooseColorOf(const std::vector<document::OrganId>& organs, const QPoint& globalPlace);

private:
  std::vector<document::OrganId> withHiddenColors() const;
  bool allLocked() const;
  void fill(Actions& actions);

  Workspace& workspace_;
  PoseEditor& poses_;
  Chosen chosen_;
};

} // namespace viscera::app
