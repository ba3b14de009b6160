#pragma once

#include <QWidget>

#include <map>
#include <string>
#include <vector>

#include "window/pose_editor.h"
#include "window/timeline/volume_monitor.h"
#include "window/workspace.h"

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ValueSlider;

/// A panel with the organs of the document: eye, colour, name, volume and its change, padlock, and the
/// opacity of the selected ones. Cavities stand under their organ; many organs stand under the systems of the
/// body, and can be searched for. Several can be chosen: what is done to organs' looks is done to all of
/// them.
class OrganPanel final : public QWidget {
  Q_OBJECT

public:
  OrganPanel(Workspace& workspace, PoseEditor& poses, VolumeMonitor& volumes, QWidget* parent = nullptr);

  /// Adds the actions on the chosen organs: "organ.showOnly", "organ.hide", "organ.showAll", "organ.find",
  /// "organ.rename" and "organ.remove".
  void addTo(Actions& actions);
  /// The organs whose rows are chosen, those of chosen systems included; else the current one; may be none.
  std::vector<document::OrganId> chosen() const;
  /// What can be done to the chosen organs; there after `addTo`.
  QMenu* menu() const { return menu_; }
  /// Opens the name of the selected organ for editing.
  void editName();

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void rebuild();
  bool sameRows() const;
  void makeRows();
  QTreeWidgetItem* rowUnder(QTreeWidgetItem* parent);
  /// The row of a system of the body, made when it is not there yet.
  QTreeWidgetItem* systemRow(const std::string& system);
  void updateSystems();
  void filter();
  void updateRow(const document::Organ& organ, QTreeWidgetItem* item);
  void updateLock(const document::Organ& organ, QTreeWidgetItem* item);
  void updateVolumes();
  void syncSelection();
  void giveNamesRoom();
  void remove(const std::vector<document::OrganId>& organs);
  void onClicked(QTreeWidgetItem* item, int column);
  void onChanged(QTreeWidgetItem* item, int column);
  using LookChange = std::function<void(document::OrganLook&)>;
  void changeLook(document::OrganId organ, const LookChange& change);
  /// In one step, which the next change of the same name and organs joins.
  void changeLooks(const QString& name, const std::vector<document::OrganId>& organs,
                   const LookChange& change);
  void show(const QString& name, const std::function<bool(const document::Organ&)>& visible);
  void showOnlyChosen();
  void toggleSystem(const QTreeWidgetItem* row);
  void chooseColorOf(document::OrganId organ, const QPoint& globalPlace);
  document::OrganId organOf(const QTreeWidgetItem* item) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  QTreeWidget* list_ = nullptr;
  QLabel* empty_;
  ValueSlider* opacity_;
  QLineEdit* search_;
  std::map<document::OrganId, QTreeWidgetItem*> items_;
  std::map<std::string, QTreeWidgetItem*> systems_; ///< Empty while the organs are few.
  QMenu* menu_ = nullptr;                           ///< What can be done to the chosen organs,
  QAction* remove_ = nullptr;                       ///< and at its end.
  bool updating_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
