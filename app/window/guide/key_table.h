#pragma once

#include <QWidget>

#include <utility>
#include <vector>

class QLabel;

namespace viscera::app {

/// A table of keys and what they do: in two columns, in one where it is narrow, and with the meaning below
/// its keys where it is narrower still, so that it scrolls only vertically.
class KeyTable final : public QWidget {
  Q_OBJECT

public:
  /// Keys and their meaning, in the order in which they are read.
  explicit KeyTable(const std::vector<std::pair<QString, QString>>& rows, QWidget* parent = nullptr);

  /// The size in two columns, with each meaning on a line.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Row {
    QLabel* keys;
    QLabel* meaning;
  };
  /// How rows share a width.
  struct Shares {
    int columns = 1;
    int keys = 0;
    int meaning = 0;
    bool stacked = false; ///< The meaning is below its keys.
  };

  Shares sharesOf(int width) const;
  /// The height that rows take; `place` puts the labels there, too.
  int arrange(int width, bool place) const;

  std::vector<Row> rows_;
};

} // namespace viscera::app
