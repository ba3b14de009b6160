#pragma once

#include <QWidget>

#include <vector>

namespace viscera::app {

/// A named part of the cycle on the timeline.
struct PhaseBand {
  QString name;
  double begin = 0; ///< Fraction of the cycle.
  double end = 1;
};

/// One cycle as a strip of its phases with the present instant on it; drag or use the arrow keys to look
/// elsewhere.
class PhaseScrubber final : public QWidget {
  Q_OBJECT

public:
  explicit PhaseScrubber(QWidget* parent = nullptr);

  void setPhases(std::vector<PhaseBand> phases);
  /// `fraction` of the cycle in [0, 1].
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  /// The phase at the present instant; empty without phases.
  QString phaseName() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

Q_SIGNALS:
  void scrubbed(double fraction);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QRectF strip() const;
  double fractionAt(double x) const;
  const PhaseBand* phaseAt(double fraction) const;
  void scrubTo(double fraction);
  void paintPhases(QPainter& painter, const QRectF& area) const;

  std::vector<PhaseBand> phases_;
  double fraction_ = 0;
};

} // namespace viscera::app
