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

/// A named place on the way of what travels through the organ, 0 to 1.
struct CoursePlace {
  QString name;
  double place = 0;
};

/// Something on that way now.
struct CourseMark {
  double place = 0;
  double strength = 0; ///< 0 to 1.
};

/// One cycle as a strip of its phases with the present instant on it; drag or use the arrow keys to look
/// elsewhere. Under the strip stand the names of the phases, or what travels through the organ: its way with
/// the names of places and a mark for each wave.
class PhaseScrubber final : public QWidget {
  Q_OBJECT

public:
  explicit PhaseScrubber(QWidget* parent = nullptr);

  void setPhases(std::vector<PhaseBand> phases);
  /// The way of what travels; empty: the names of the phases are shown.
  void setCourse(std::vector<CoursePlace> course);
  void setMarks(std::vector<CourseMark> marks);
  /// `fraction` of the cycle in [0, 1].
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  const std::vector<CourseMark>& marks() const { return marks_; }
  /// The phase at the present instant; empty without phases.
  QString phaseName() const;
  /// The names that stand under the strip now, from the left; one that finds no room is left out.
  QStringList namesShown() const;

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
  /// A name under the strip.
  struct Name {
    QString text;
    double center = 0; ///< Of the text.
    double at = 0;     ///< Of what it names.
    bool present = false;
  };

  QRectF strip() const;
  double fractionAt(double x) const;
  const PhaseBand* phaseAt(double fraction) const;
  void scrubTo(double fraction);
  std::vector<Name> names() const;
  void paintPhases(QPainter& painter, const QRectF& area) const;
  void paintNames(QPainter& painter, const QRectF& area) const;
  void paintMarks(QPainter& painter, const QRectF& area) const;

  std::vector<PhaseBand> phases_;
  std::vector<CoursePlace> course_;
  std::vector<CourseMark> marks_;
  double fraction_ = 0;
};

} // namespace viscera::app
