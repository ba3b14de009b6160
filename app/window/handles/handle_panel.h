#pragma once

#include <QWidget>

#include "window/work/handle_placer.h"
#include "window/work/workspace.h"

class QCheckBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ValueSlider;

/// A panel with the handles by group, their automatic placement, and buttons that edit the selected ones.
class HandlePanel final : public QWidget {
  Q_OBJECT

public:
  HandlePanel(Workspace& workspace, HandlePlacer& placer, QWidget* parent = nullptr);

  /// Adds a button of the panel's tool row for an action of the window.
  void addTool(QAction* action);

private:
  QWidget* makePlacement();
  void rebuild();
  void addGroup(const QString& name, const QColor& color,
                const std::vector<const document::Handle*>& handles);
  void syncSelection();
  void syncPlacement();
  void selectFromList();
  void rename(QTreeWidgetItem* item);

  Workspace& workspace_;
  HandlePlacer& placer_;
  ValueSlider* count_ = nullptr;
  QCheckBox* enclosing_ = nullptr;
  QWidget* tools_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QLabel* empty_ = nullptr;
  bool updating_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
