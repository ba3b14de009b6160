#pragma once

#include <QFrame>
#include <QHBoxLayout>

#include "window/widgets/elided_label.h"

namespace viscera::app {

/// The heading of one of two compared views: its number, what moves there and how fast, the phase and the
/// volumes.
class SideHeader final : public QFrame {
  Q_OBJECT

public:
  explicit SideHeader(int number, QWidget* parent = nullptr);

  void setTitle(const QString& title) { title_->setText(title); }
  /// What changes with every frame.
  void setState(const QString& phase, const QString& volumes);
  QString volumes() const { return volumes_->fullText(); }
  QString phase() const { return phase_->fullText(); }
  /// Puts a control behind the title.
  void addControl(QWidget* control) { row_->insertWidget(row_->indexOf(phase_), control); }
  /// Puts a control at the right end.
  void addAtEnd(QWidget* control) { row_->addWidget(control); }

private:
  QHBoxLayout* row_;
  QLabel* title_;
  ElidedLabel* phase_;
  ElidedLabel* volumes_;
};

} // namespace viscera::app
