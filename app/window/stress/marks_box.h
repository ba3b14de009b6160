#pragma once

#include <QTimer>
#include <QWidget>

#include "window/stress/stress_model.h"
#include "window/style/theme.h"
#include "window/work/actions.h"

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

class ProfileChart;

/// The controls for pinned probes and the profiles between them, of all organs: a table with place and value
/// in the pose that is shown, buttons that pin, join and remove, and a chart of the profiles.
class MarksBox final : public QWidget {
  Q_OBJECT

public:
  MarksBox(Workspace& workspace, StressModel& model, const Actions& actions, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);

private:
  void makeList();
  void rebuild();
  void syncValues();
  void syncButtons();
  void fill(QTreeWidgetItem& item, const document::StressProbe& probe) const;
  void fill(QTreeWidgetItem& item, const document::StressLine& line) const;
  std::vector<document::StressProbeId> chosenProbes() const;
  std::vector<document::StressLineId> chosenLines() const;
  void removeChosen();
  void drawProfile();

  Workspace& workspace_;
  StressModel& model_;
  QTreeWidget* list_;
  QPushButton* profile_;
  QPushButton* remove_;
  std::vector<QWidget*> forAll_; ///< Enabled while there is any probe or profile.
  ProfileChart* chart_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
