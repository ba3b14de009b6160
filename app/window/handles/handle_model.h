#pragma once

#include <QAbstractTableModel>

#include <optional>

#include "window/view/pose_editor.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// The vertex of an organ whose coordinates a table shows.
struct ShownVertex {
  document::OrganId organ;
  int vertex = -1;
};

/// An item model with a row for each handle of the document: label, groups, position at rest and in the pose
/// (mm, LPS), distance moved, and its coordinate at one vertex. Numbers and labels can be edited; each edit
/// is one undo step.
class HandleModel final : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { label, groups, restX, restY, restZ, poseX, poseY, poseZ, moved, weight, columns };

  /// Both have to live longer.
  HandleModel(Workspace& workspace, PoseEditor& poses, QObject* parent = nullptr);

  /// Shows the coordinates of that vertex; none: shows no coordinates.
  void showVertex(std::optional<ShownVertex> vertex);
  const std::optional<ShownVertex>& shownVertex() const { return vertex_; }
  /// The coordinates of the vertex, one for each handle; empty without a vertex, or while its organ is not
  /// bound.
  const Values& weights() const { return weights_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// The displayed text (`DisplayRole`), or the number itself (`EditRole`: for editing, sorting and copying).
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Writes the rows as text: tabulators between cells, a line a row, numbers with all their digits.
  QString textOf(const std::vector<int>& rows) const;

Q_SIGNALS:
  /// The coordinates of the vertex have changed.
  void weightsChanged();

private:
  void refresh();
  void measure();
  bool isNumber(int column) const { return column >= restX; }
  double number(int row, int column) const;
  QString groupsOf(const document::Handle& handle) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  std::optional<ShownVertex> vertex_;
  Values weights_;
  int rows_ = 0;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
