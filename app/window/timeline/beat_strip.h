#pragma once

#include <QStringList>
#include <QWidget>

#include <optional>
#include <vector>

#include "viscera/heart/cardiac_cycle.h"

namespace viscera::app {

/// A strip below the timeline with the events of the textbook's beat: a schematic electrocardiogram, the
/// first and the second heart sound, and when each of the four valves is open, with a lamp for the present
/// instant.
class BeatStrip final : public QWidget {
  Q_OBJECT

public:
  explicit BeatStrip(QWidget* parent = nullptr);

  /// Sets the beat; empty: nothing is drawn.
  void setBeat(const std::optional<heart::CardiacBeat>& beat);
  bool hasBeat() const { return !valves_.empty(); }
  /// `fraction` of the cycle in [0, 1].
  void setFraction(double fraction);
  /// The names of the valves that are open at the present instant.
  QStringList openValves() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// One valve: when it is open, as parts of the cycle; the interval may wrap around the beginning.
  struct Valve {
    QString name;
    double opens = 0;
    double shuts = 0;

    bool isOpen(double fraction) const;
  };
  /// A heart sound.
  struct Sound {
    QString name;
    double at = 0; ///< Part of the cycle.
  };

  QRectF tracing() const;
  double xAt(double fraction) const;
  void paintTracing(QPainter& painter) const;
  void paintValves(QPainter& painter) const;

  std::vector<double> tracing_; ///< mV, at even instants of the cycle.
  std::vector<Sound> sounds_;
  std::vector<Valve> valves_;
  double fraction_ = 0;
};

} // namespace viscera::app
