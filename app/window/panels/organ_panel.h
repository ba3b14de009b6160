#pragma once

#include <QWidget>

#include <map>

#include "window/pose_editor.h"
#include "window/timeline/volume_monitor.h"
#include "window/workspace.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ValueSlider;

/// The organs of the document: eye, colour, name, volume and its change, padlock, and the opacity of the
/// selected one. Cavities stand under their organ.
class OrganPanel final : public QWidget {
  Q_OBJECT

public:
  OrganPanel(Workspace& workspace, PoseEditor& poses, VolumeMonitor& volumes, QWidget* parent = nullptr);

  /// Adds "organ.rename" and "organ.remove".
  void addTo(Actions& actions);
  /// Opens the name of the selected organ for editing.
  void editName();

Q_SIGNALS:
  void focusRequested(viscera::document::OrganId organ);

protected:
  void changeEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void rebuild();
  void updateRow(const document::Organ& organ, QTreeWidgetItem* item);
  void updateLock(const document::Organ& organ, QTreeWidgetItem* item);
  void updateVolumes();
  void syncSelection();
  void onClicked(QTreeWidgetItem* item, int column);
  void onChanged(QTreeWidgetItem* item, int column);
  void changeLook(document::OrganId organ, const std::function<void(document::OrganLook&)>& change);
  void chooseColorOf(document::OrganId organ, const QPoint& globalPlace);
  document::OrganId organOf(const QTreeWidgetItem* item) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  QTreeWidget* list_ = nullptr;
  QLabel* empty_;
  ValueSlider* opacity_;
  std::map<document::OrganId, QTreeWidgetItem*> items_;
  bool updating_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
