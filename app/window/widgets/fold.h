#pragma once

#include <QWidget>

class QToolButton;

namespace viscera::app {

/// A title that shows and hides what is under it, for what is not needed every time.
class Fold final : public QWidget {
  Q_OBJECT

public:
  /// Takes `contents`.
  Fold(const QString& title, QWidget* contents, bool open, QWidget* parent = nullptr);

  void setOpen(bool open);
  bool isOpen() const;

private:
  QToolButton* title_;
  QWidget* contents_;
};

} // namespace viscera::app
