#pragma once

#include <QMenu>

#include "window/work/workspace.h"

namespace viscera::app {

class Actions;

/// Converts axes and unit of all organs after their import, with what is placed on them: for a patient whose
/// files turn out to be in RAS, mirrored, or in another unit. Each entry is one undo step.
class CoordinateMenu final : public QMenu {
  Q_OBJECT

public:
  /// Both have to live longer. The menu can be opened while there are organs; "view.focus", which has to
  /// exist, then shows where the organs are.
  CoordinateMenu(Workspace& workspace, Actions& actions, QWidget* parent);

private:
  void convert(const std::string& id, Actions& actions);

  Workspace& workspace_;
};

} // namespace viscera::app
