#pragma once

#include <QWidget>

#include "viscera/document/group_commands.h"
#include "window/work/workspace.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

/// A panel with the groups of handles: a list with names and colours, buttons that edit the chosen group, and
/// automatic grouping. Every change is one undo step.
class GroupPanel final : public QWidget {
  Q_OBJECT

public:
  explicit GroupPanel(Workspace& workspace, QWidget* parent = nullptr);

private:
  QWidget* makeButtons();
  QWidget* makeAutomatic();
  void rebuild();
  void sync();
  void rename(QTreeWidgetItem* item);
  void chooseColorOf(const document::Group& group);
  void create();
  void makeAutomatically();
  void useGroups();
  const document::Group* current() const;
  std::string freeName() const;
  /// How many handles automatic grouping has added to how many groups, in a sentence; empty: none.
  QString added() const;

  Workspace& workspace_;
  QTreeWidget* list_;
  QLabel* empty_;
  QLabel* unused_;   ///< Shown when the chosen coordinates do not use groups.
  QLabel* added_;    ///< What automatic grouping has added.
  QPushButton* use_; ///< Switches to coordinates that use groups.
  QPushButton* create_ = nullptr;
  QPushButton* add_ = nullptr;
  QPushButton* takeOut_ = nullptr;
  QPushButton* select_ = nullptr;
  QPushButton* color_ = nullptr;
  QPushButton* remove_ = nullptr;
  QComboBox* by_ = nullptr;
  QSpinBox* count_ = nullptr;
  QPushButton* automatic_ = nullptr;
  bool updating_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
