#pragma once

#include <QFrame>
#include <QHBoxLayout>
#include <QStringList>
#include <QVBoxLayout>

#include "window/widgets/elided_label.h"

namespace viscera::app {

/// The heading of one of two compared views: its number, what moves there and how fast, the phase and the
/// volumes. In a narrow view its controls have a second row.
class SideHeader final : public QFrame {
  Q_OBJECT

public:
  explicit SideHeader(int number, QWidget* parent = nullptr);

  void setTitle(const QString& title) { title_->setFullText(title); }
  /// The names of all phases that follow one another: the longest one's width is every phase's, as far as the
  /// title leaves it, so that the title stands still. None: each phase has its own width.
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
  /// All but phase and volumes, which give way.
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
