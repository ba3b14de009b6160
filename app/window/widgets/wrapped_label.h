#pragma once

#include <QLabel>

class QTextLayout;

namespace viscera::app {

/// A label of plain text in several lines that needs no more width than its panel has: where a word, such as
/// the name of a file, is wider than the label, it breaks within the word. A plain `QLabel` asks for the
/// width of its longest word, and with it the whole panel. What is copied from it is the text as it was
/// given.
class WrappedLabel final : public QLabel {
  Q_OBJECT

public:
  explicit WrappedLabel(QWidget* parent = nullptr) : WrappedLabel(QString(), parent) {}
  explicit WrappedLabel(const QString& text, QWidget* parent = nullptr);

  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  /// The width of a few letters.
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// Whether some word is wider than the label would be.
  bool breaksWords(int width) const;
  /// The lines of the text in a label of that width, of which the return value is the height.
  double layOut(QTextLayout& lines, int width) const;
  /// The logical pixels that are no room for text, across and down.
  QSize around() const;
};

} // namespace viscera::app
