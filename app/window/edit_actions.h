#pragma once

#include <QObject>

#include "window/actions.h"
#include "window/workspace.h"

class QMenu;

namespace viscera::app {

/// Undo and redo, the list of steps, and selecting all handles.
class EditActions final : public QObject {
  Q_OBJECT

public:
  /// Adds "edit.undo", "edit.redo" and "edit.selectAll". `workspace` has to live longer.
  EditActions(Workspace& workspace, Actions& actions, QObject* parent = nullptr);

  /// Fills a menu with the steps around the present one, the youngest first, whenever it is opened; those
  /// that were undone are in italics.
  void listStepsIn(QMenu* menu);

private:
  void selectAll();
  void fillSteps(QMenu* menu);

  Workspace& workspace_;
};

} // namespace viscera::app
