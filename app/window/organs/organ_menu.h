#pragma once

#include <QMenu>

#include <functional>
#include <vector>

#include "window/view/pose_editor.h"
#include "window/work/workspace.h"

class QAction;

namespace viscera::app {

/// The context menu of the selected organs, in the list and in the view. An action applies to all of them in
/// one undo step.
class OrganMenu final : public QMenu {
  Q_OBJECT

public:
  using Chosen = std::function<std::vector<document::OrganId>()>;

  /// All have to live longer; `chosen` returns the selected organs.
  OrganMenu(Workspace& workspace, PoseEditor& poses, Chosen chosen, QWidget* parent);

  /// Adds "volume.lock", "organ.bends", "organ.rigid", "organ.fixed" and "measure.gap", and fills the menu
  /// with that and with the actions of the list and the view, which have to exist.
  void addTo(Actions& actions);
  /// Opens the colour menu for organs beside the clicked place.
  void chooseColorOf(const std::vector<document::OrganId>& organs, const QPoint& globalPlace);

private:
  std::vector<document::OrganId> withHiddenColors() const;
  bool allLocked() const;
  void addMobility(Actions& actions);
  void fill(Actions& actions);

  Workspace& workspace_;
  PoseEditor& poses_;
  Chosen chosen_;
};

} // namespace viscera::app
