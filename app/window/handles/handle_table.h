#pragma once

#include <QDialog>

#include "window/handles/handle_model.h"
#include "window/view/picture.h"
#include "window/view/view_widget.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace viscera::app {

class Actions;

/// A dialog with a table of all handles: positions to read and to type, and the coordinates of the vertex
/// that was clicked last while the table is open. Rows can be copied into a spreadsheet.
class HandleTable final : public QDialog {
  Q_OBJECT

public:
  /// All have to live longer.
  HandleTable(Workspace& workspace, PoseEditor& poses, const Picture& picture, ViewWidget& view,
              QWidget* parent);

  /// Adds "handles.table".
  void addTo(Actions& actions);

  HandleModel& model() { return model_; }
  /// Copies the selected rows, or all, to the clipboard.
  void copy() const;

private:
  void onClick(const QPointF& place);
  void sayVertex();
  void selectInDocument();

  Workspace& workspace_;
  const Picture& picture_;
  ViewWidget& view_;
  HandleModel model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLabel* vertex_;
};

} // namespace viscera::app
