#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace viscera::app {

class ElidedLabel;

/// The line above one of two views: its letter, what moves there and how fast, the phase and the volumes.
class SideHeader final : public QFrame {
  Q_OBJECT

public:
  SideHeader(const QString& letter, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  /// What changes with every frame.
  void setState(const QString& phase, const QString& volumes);
  QString volumes() const;
  QString phase() const;
  /// Puts a control behind the title.
  void addControl(QWidget* control);
  /// Puts a control at the right end.
  void addAtEnd(QWidget* control);

private:
  QHBoxLayout* row_;
  QLabel* title_;
  ElidedLabel* phase_;
  ElidedLabel* volumes_;
};

} // namespace viscera::app
