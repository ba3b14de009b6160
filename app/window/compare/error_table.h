#pragma once

#include <QWidget>

#include <array>
#include <vector>

#include "window/work/workspace.h"

class QLabel;

namespace viscera::app {

/// A table of how exactly two systems of coordinates bind the current organ: the errors of identity and unity
/// at rest, the smallest weight, the vertices without coordinates, and the time that binding took.
class ErrorTable final : public QWidget {
  Q_OBJECT

public:
  /// The second document mirrors the first; both must live longer.
  ErrorTable(Workspace& first, Workspace& second, QWidget* parent = nullptr);

private:
  static constexpr std::size_t kRows = 5;
  struct Column {
    Workspace* workspace;
    QLabel* title;
    std::array<QLabel*, kRows> cells;
  };

  void addColumn(Workspace& workspace, int place);
  void refresh();

  Workspace& first_;
  std::vector<Column> columns_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
