#pragma once

#include <QTableWidget>

#include "viscera/circulation/readings.h"
#include "window/style/theme.h"

namespace viscera::app {

/// The numbers of a circulation beside what is normal, and beside those of one before.
class NumbersTable final : public QTableWidget {
  Q_OBJECT

public:
  explicit NumbersTable(QWidget* parent = nullptr);

  /// Null: there is none.
  void setIndices(const circulation::Indices* now, const circulation::Indices* before);
  /// Whose normal ranges are beside the numbers.
  void setPerson(const norms::Person& person);
  void setTheme(const Theme& theme);

private:
  void fill(int row, int column, const circulation::Indices* indices);

  Theme theme_;
  norms::Person person_;
};

} // namespace viscera::app
