#pragma once

#include <QWidget>

#include <map>
#include <string>
#include <vector>

#include "window/organs/organ_menu.h"
#include "window/timeline/volume_monitor.h"
#include "window/view/pose_editor.h"
#include "window/work/workspace.h"

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ValueSlider;

/// A panel with the organs of the document: eye, colour, name, volume with its change below, padlock, and the
/// opacity of the selected ones. Cavities stand under their organ; many organs stand under the systems of the
/// body, and can be searched for. Several can be chosen: what is done to organs' looks is done to all of
/// them.
class OrganPanel final : public QWidget {
  Q_OBJECT

public:
  OrganPanel(Workspace& workspace, PoseEditor& poses, VolumeMonitor& volumes, QWidget* parent = nullptr);

  /// Adds the actions on the chosen organs: "organ.showOnly", "organ.hide", "organ.showAll", "organ.find",
  /// "organ.rename", "organ.remove" and "volume.lock".
  void addTo(Actions& actions);
  /// The organs whose rows are chosen, those of chosen systems included, as far as the search shows them;
  /// else the current one; may be none.
  std::vector<document::OrganId> chosen() const;
  /// The context menu of the selected organs; null before `addTo`.
  OrganMenu* menu() const { return menu_; }
  /// Opens the name of the selected organ for editing.
  void editName();
  /// What an empty list says: that an organ is on its way, or how to get one.
  void setWaiting(bool waiting);

protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void rebuild();
  bool sameRows() const;
  void makeRows();
  QTreeWidgetItem* rowUnder(QTreeWidgetItem* parent);
  /// The row of a system of the body; creates it if needed.
  QTreeWidgetItem* systemRow(const std::string& system);
  void updateSystems();
  void filter();
  bool handleSearchKey(QKeyEvent& event);
  bool isFound(const QTreeWidgetItem* row) const;
  void chooseFirstFound();
  void updateRow(const document::Organ& organ, QTreeWidgetItem* item);
  void updateLock(const document::Organ& organ, QTreeWidgetItem* item);
  void updateVolumes();
  void writeVolumes();
  void syncSelection();
  void syncOpacity();
  void fitNameColumn();
  void leaveNumbersOut();
  void remove(const std::vector<document::OrganId>& organs);
  void onClicked(QTreeWidgetItem* item, int column);
  void onChanged(QTreeWidgetItem* item, int column);
  using LookChange = std::function<void(document::OrganLook&)>;
  void changeLook(document::OrganId organ, const LookChange& change);
  void toggleSystem(const QTreeWidgetItem* row);
  document::OrganId organOf(const QTreeWidgetItem* item) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  QTreeWidget* list_ = nullptr;
  QLabel* empty_;
  ValueSlider* opacity_;
  QLineEdit* search_;
  std::map<document::OrganId, QTreeWidgetItem*> items_;
  std::map<std::string, QTreeWidgetItem*> systems_; ///< Empty while the organs are few.
  OrganMenu* menu_;                                 ///< The context menu of the selected organs.
  bool updating_ = false;
  int widestVolume_ = 0; ///< Of the numbers since the panel or its rows were others last, in pixels.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
