#pragma once

#include <QCheckBox>

namespace viscera::app {

/// A check box named by a text of any length, such as an organ's name in a file. Where the text does not fit
/// the box shortens it in the middle, and its tooltip begins with the whole; it never widens its panel.
class ElidedCheck final : public QCheckBox {
  Q_OBJECT

public:
  /// `tip` says what the box does.
  ElidedCheck(const QString& text, const QString& tip, QWidget* parent = nullptr);

  /// The width of the mark and of a few letters.
  QSize minimumSizeHint() const override;
  /// What the box shows of its text at its present width.
  QString shownText() const;

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QString tip_;
};

} // namespace viscera::app
