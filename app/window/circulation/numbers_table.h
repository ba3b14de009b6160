#pragma once

#include <QTableWidget>

#include "viscera/circulation/readings.h"
#include "window/style/theme.h"

namespace viscera::app {

/// A normal range with the numbers of the window's language: "60–100", "from 60", "up to 5".
QString normalText(const circulation::NormalValues& normal, int decimals);
/// The meaning of the range, the people that were measured, and the source, in the language of the window.
QString sourceText(const circulation::NormalValues& normal);

/// A table of the computed numbers of a circulation, with normal ranges and the numbers of a kept
/// circulation.
class NumbersTable final : public QTableWidget {
  Q_OBJECT

public:
  explicit NumbersTable(QWidget* parent = nullptr);

  /// Null: that circulation does not exist.
  void setIndices(const circulation::Indices* now, const circulation::Indices* before);
  /// Sets the person whose normal ranges are shown beside the numbers.
  void setPerson(const anatomy::Person& person);
  void setTheme(const Theme& theme);

private:
  void fill(int row, int column, const circulation::Indices* indices);

  Theme theme_;
  anatomy::Person person_;
};

} // namespace viscera::app
