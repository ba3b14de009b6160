#include "window/handles/handle_model.h"

#include <algorithm>

#include "viscera/document/rig_commands.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

constexpr int kMmDigits = 2;
constexpr int kWeightDigits = 6;
constexpr int kAllDigits = 17;

} // namespace

HandleModel::HandleModel(Workspace& workspace, PoseEditor& poses, QObject* parent)
    : QAbstractTableModel(parent), workspace_(workspace), poses_(poses) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.rig() || change.pose() || change.organs())
      refresh();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (vertex_ && event.organ == vertex_->organ && (event.status || event.replaced))
      measure();
  }));
  refresh();
}

void HandleModel::refresh() {
  const int rows = static_cast<int>(workspace_.document().rig().handles.size());
  if (rows != rows_) {
    beginResetModel();
    rows_ = rows;
    endResetModel();
    measure();
  }
  if (rows_ > 0)
    Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns - 1));
}

void HandleModel::showVertex(std::optional<ShownVertex> vertex) {
  vertex_ = std::move(vertex);
  measure();
}

void HandleModel::measure() {
  weights_.resize(0);
  const auto organ = vertex_ ? workspace_.document().organ(vertex_->organ) : nullptr;
  if (!organ || vertex_->vertex < 0 || vertex_->vertex >= organ->mesh->points.rows()) {
    vertex_.reset();
  } else if (workspace_.live().status(organ->id).state == live::BindingStatus::State::bound) {
    weights_ = workspace_.live().weightsAt(organ->id, vertex_->vertex);
  }
  if (rows_ > 0)
    Q_EMIT dataChanged(index(0, weight), index(rows_ - 1, weight));
  Q_EMIT weightsChanged();
}

int HandleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int HandleModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant HandleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
    return QAbstractTableModel::headerData(section, orientation, role);
  switch (section) {
  case label:
    return tr("Handle");
  case groups:
    return tr("Groups");
  case restX:
    return tr("Rest L");
  case restY:
    return tr("Rest P");
  case restZ:
    return tr("Rest S");
  case poseX:
    return tr("Pose L");
  case poseY:
    return tr("Pose P");
  case poseZ:
    return tr("Pose S");
  case moved:
    return tr("Moved (mm)");
  default:
    return tr("Coordinate");
  }
}

QString HandleModel::groupsOf(const document::Handle& handle) const {
  QStringList names;
  for (const document::Group& group : workspace_.document().rig().groups)
    if (std::find(group.handles.begin(), group.handles.end(), handle.id) != group.handles.end())
      names.push_back(inWords(group.name));
  return names.join(QStringLiteral(", "));
}

double HandleModel::number(int row, int column) const {
  const document::Handle& handle = workspace_.document().rig().handles[static_cast<std::size_t>(row)];
  const Vec3 pose = workspace_.document().pose().row(row).transpose();
  if (column >= restX && column <= restZ)
    return handle.rest[column - restX];
  if (column >= poseX && column <= poseZ)
    return pose[column - poseX];
  return column == moved ? (pose - handle.rest).norm() : weights_[row];
}

QVariant HandleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_)
    return {};
  const int column = index.column();
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole)
    return {};
  const document::Handle& handle = workspace_.document().rig().handles[static_cast<std::size_t>(index.row())];
  if (column == label)
    return inWords(handle.label);
  if (column == groups)
    return groupsOf(handle);
  if (column == weight && index.row() >= weights_.size())
    return {};
  const double value = number(index.row(), column);
  if (role == Qt::EditRole)
    return value;
  return formatNumber(value, column == weight ? kWeightDigits : kMmDigits);
}

Qt::ItemFlags HandleModel::flags(const QModelIndex& index) const {
  const int column = index.column();
  const bool typed = column == label || (column >= restX && column <= poseZ);
  return QAbstractTableModel::flags(index) | (typed ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool HandleModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || data(index, role) == value)
    return false;
  const document::Handle& handle = workspace_.document().rig().handles[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  if (column == label)
    return workspace_.perform(
        document::editHandles({handle.id}, {value.toString().toStdString(), {}, {}, {}, {}}));
  const std::optional<double> typed =
      value.type() == QVariant::String ? numberIn(value.toString()) : std::optional(value.toDouble());
  if (!typed)
    return false;
  Points place(1, 3);
  if (column <= restZ) {
    place.row(0) = handle.rest.transpose();
    place(0, column - restX) = *typed;
    return workspace_.perform(document::moveRestHandles({handle.id}, place));
  }
  Vec3 by = Vec3::Zero();
  by[column - poseX] = *typed - workspace_.document().pose()(index.row(), column - poseX);
  return poses_.moveBy({handle.id}, by).has_value(); // As on the page: locked volumes stay.
}

QString HandleModel::textOf(const std::vector<int>& rows) const {
  QString lines;
  const auto addRow = [&](const std::function<QString(int)>& cell) {
    QStringList cells;
    for (int column = 0; column < columns; ++column)
      cells.push_back(cell(column));
    lines += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
  };
  addRow([this](int column) { return headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); });
  for (const int row : rows)
    addRow([&](int column) {
      const QVariant value = data(index(row, column), Qt::EditRole);
      return isNumber(column) && value.isValid() ? formatDigits(value.toDouble(), kAllDigits)
                                                 : value.toString().simplified();
    });
  return lines;
}

} // namespace viscera::app
