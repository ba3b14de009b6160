#pragma once

#include <QWidget>

#include <optional>
#include <vector>

#include "viscera/heart/heart_numbers.h"
#include "viscera/sequences/sequence.h"

namespace viscera::app {

/// A strip that shows one cycle with its phases and the present instant, which mouse and arrow keys move.
/// Under the strip are the names of the phases, or, for waves that travel through an organ, their way with
/// the names of places and a mark for each wave.
class PhaseScrubber final : public QWidget {
  Q_OBJECT

public:
  explicit PhaseScrubber(QWidget* parent = nullptr);

  /// `periodSeconds` is the cycle's length, for the milliseconds of its parts; 0: they are not shown.
  void setPhases(std::vector<sequences::Phase> phases, double periodSeconds);
  /// Sets the way of the waves; empty: the names of the phases are shown.
  void setCourse(std::vector<sequences::NamedPlace> course);
  void setMarks(std::vector<sequences::TravellingMark> marks);
  /// Marks the ends of diastole and systole over the strip; none: there are no marks.
  void setEnds(const std::optional<heart::CycleEnds>& ends);
  const std::optional<heart::CycleEnds>& ends() const { return ends_; }
  /// `fraction` of the cycle in [0, 1].
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  const std::vector<sequences::TravellingMark>& marks() const { return marks_; }
  /// The phase at the present instant; empty without phases.
  QString phaseName() const;
  /// The same with when it begins and ends.
  QString phaseText() const;
  /// The texts over the brackets under the strip, from the left: "systole 322 ms".
  QStringList groupsShown() const;
  /// The names shown under the strip now, from the left; names without room are left out.
  QStringList namesShown() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

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
    double center = 0; ///< Centre of the text.
    double at = 0;     ///< Place of what it names.
    bool present = false;
  };

  QRectF strip() const;
  double fractionAt(double x) const;
  const sequences::Phase* phaseAt(double fraction) const;
  void scrubTo(double fraction);
  std::vector<Name> names() const;
  /// Moves names apart; false when there is no room for all of them.
  bool place(std::vector<Name>& names) const;
  void paintPhases(QPainter& painter, const QRectF& area) const;
  void paintNames(QPainter& painter, const QRectF& area) const;
  void paintGroups(QPainter& painter, const QRectF& area) const;
  void paintEnds(QPainter& painter, const QRectF& area) const;
  void paintMarks(QPainter& painter, const QRectF& area) const;

  /// Phases of one group beside each other.
  struct Group {
    QString text;
    double begin = 0;
    double end = 0;
  };
  std::vector<Group> groups() const;

  std::vector<sequences::Phase> phases_;
  double periodSeconds_ = 0;
  std::vector<sequences::NamedPlace> course_;
  std::vector<sequences::TravellingMark> marks_;
  double fraction_ = 0;
  std::optional<heart::CycleEnds> ends_;
};

/// The name of the phase, and when it begins and ends in a cycle of that length.
QString phaseText(const sequences::Phase& phase, double periodSeconds);

} // namespace viscera::app
