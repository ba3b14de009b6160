#pragma once

#include <QLabel>
#include <QStringList>

namespace viscera::app {

/// A label that shortens its text where it does not fit, and shows all of it in the tooltip: it takes a
/// shorter form of the text where it was given one that fits, else it ends with an ellipsis.
class ElidedLabel final : public QLabel {
  Q_OBJECT

public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// `shorter` are other forms of the text, the longest first.
  void setFullText(const QString& text, const QStringList& shorter = {});
  QString fullText() const { return full_; }
  /// Shows nothing where an ellipsis would leave less than so many letters.
  void setFewestLetters(int letters);
  /// How wide the label has to be to show all of a text.
  int widthFor(const QString& text) const;
  /// The size of the whole text, for layouts that use it; by its size policy the label takes the space that
  /// is left.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void elide();

  QString full_;
  QStringList shorter_;
  int fewest_ = 0;
};

} // namespace viscera::app
