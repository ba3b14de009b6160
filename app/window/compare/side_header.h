#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QStringList>
#include <QVBoxLayout>

#include "window/widgets/elided_label.h"

namespace viscera::app {

/// The heading of one of two compared views: its number, the sequence it plays and its rate, the phase and
/// the volumes. In a narrow view its controls have a second row.
class SideHeader final : public QFrame {
  Q_OBJECT

public:
  explicit SideHeader(int number, QWidget* parent = nullptr);

  void setTitle(const QString& title) { title_->setFullText(title); }
  /// Sets the names of all phases of a cycle. As far as the title leaves room, every phase gets the width of
  /// the longest name, so that the title does not move. None: each phase has its own width.
  void setPhases(const QStringList& phases);
  /// What changes with every frame.
  void setState(const QString& phase, const QString& volumes);
  QString volumes() const { return volumes_->fullText(); }
  QString phase() const { return phase_->fullText(); }
  /// Puts a control behind the title, or into the second row.
  void addControl(QWidget* control) { controls_->layout()->addWidget(control); }
  /// Puts a control at the right end.
  void addAtEnd(QWidget* control) { row_->addWidget(control); }

Q_SIGNALS:
  /// The header has got a second row, or lost it.
  void heightChanged(int height);

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  /// Moves the controls to the row that has room for them.
  void arrange();
  void arrangeIn(bool two);
  void sharePhase();
  /// The width of everything but phase and volumes, which are shortened first.
  int widthInOneRow() const;

  QVBoxLayout* rows_;
  QHBoxLayout* row_;
  QWidget* controls_;
  ElidedLabel* title_;
  ElidedLabel* phase_;
  ElidedLabel* volumes_;
  QStringList phases_;
  bool twoRows_ = false;
};

} // namespace viscera::app
