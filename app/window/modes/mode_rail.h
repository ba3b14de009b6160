#pragma once

#include <QWidget>

#include <vector>

class QToolButton;

namespace viscera::app {

class ModeController;

/// The narrow column of buttons at the left edge that switch between modes, each an icon with a word. In a
/// low window the words go, which the tooltips have, too.
class ModeRail final : public QWidget {
  Q_OBJECT

public:
  /// `modes` has all of them, and has to live longer.
  explicit ModeRail(ModeController& modes, QWidget* parent = nullptr);

  /// The size with the words, whether they are there now or not.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  int heightFor(bool words) const;
  void setWords(bool words);

  std::vector<QToolButton*> buttons_;
  bool words_ = true;
};

} // namespace viscera::app
