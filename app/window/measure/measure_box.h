#pragma once

#include <QTimer>
#include <QWidget>

#include "viscera/document/measured_values.h"
#include "window/measure/measure_tool.h"
#include "window/work/actions.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace viscera::app {

/// The controls for measurements: buttons that begin one, and the list of all with each value now and at
/// rest. Names are edited in the list; a measurement that is selected in the list is highlighted in the view,
/// and vice versa.
class MeasureBox final : public QWidget {
  Q_OBJECT

public:
  MeasureBox(Workspace& workspace, MeasureTool& tool, const Actions& actions, QWidget* parent = nullptr);

private:
  void makeList();
  void rebuild();
  void syncValues();
  void syncChosen();
  QString hint() const;
  void removeChosen();
  void rename(QTreeWidgetItem* item, int column);

  Workspace& workspace_;
  MeasureTool& tool_;
  QLabel* hint_;
  QTreeWidget* list_;
  QPushButton* remove_;
  std::vector<QPushButton*> forAll_; ///< Enabled while there is any measurement.
  QTimer values_;                    ///< Updates the values when the frame with the new positions is drawn.
  document::MeasuringMemory memory_;
  bool updating_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
