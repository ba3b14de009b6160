#pragma once

#include <QLabel>

namespace viscera::app {

/// A label that shortens its text with an ellipsis where it does not fit, and shows all of it in the tooltip.
class ElidedLabel final : public QLabel {
  Q_OBJECT

public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setFullText(const QString& text);
  QString fullText() const { return full_; }
  /// How wide the label has to be to show all of a text.
  int widthFor(const QString& text) const;
  /// The size of the whole text, for layouts that use it; by its size policy the label takes the space that
  /// is left.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void elide() { setText(fontMetrics().elidedText(full_, Qt::ElideRight, contentsRect().width())); }

  QString full_;
};

} // namespace viscera::app
