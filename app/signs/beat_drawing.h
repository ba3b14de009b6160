#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QStringList>

#include <optional>
#include <vector>

#include "viscera/heart/cardiac_cycle.h"
#include "viscera/presentation/heart_signs.h"

class QPainter;

namespace viscera::app {

/// The margin at the left and right of every strip that shows a cycle, in logical pixels. All strips share
/// it, so that the same instants stand below each other.
inline constexpr double kPhaseMargin = 8;

/// Draws the events of the textbook's beat: a schematic electrocardiogram, the first and the second heart
/// sound, and when each of the four valves is open, with a lamp for the present instant. The timeline, a
/// lecture and movies draw them with this. Made on the main thread; it paints on any.
class BeatDrawing {
public:
  /// Colours and size of the drawing.
  struct Look {
    QColor ink;       ///< Lines, names, and what is open.
    QColor muted;     ///< Marks of sounds.
    QColor shut;      ///< A valve's lamp.
    QFont type;       ///< Names of the sounds; those of the valves are smaller.
    double scale = 1; ///< Of all lengths.
  };

  /// Sets the beat; empty: nothing is drawn.
  void setBeat(const std::optional<heart::CardiacBeat>& beat);
  bool hasBeat() const { return !valves_.empty(); }
  /// Sets what is drawn of it: `ecg`, `valves` and `sounds`.
  void setSigns(const presentation::HeartSigns& signs) { signs_ = signs; }
  const presentation::HeartSigns& signs() const { return signs_; }
  /// The names of the valves that are open at `fraction` of the cycle in [0, 1].
  QStringList openValves(double fraction) const;

  /// The height of what is drawn of a beat, logical pixels; 0 where nothing is drawn.
  double height(double scale) const;
  /// Draws in the upper part of `area`, over its whole width.
  void paint(QPainter& painter, const QRectF& area, double fraction, const Look& look) const;

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

  bool hasTracing() const { return signs_.ecg || signs_.sounds; }
  void paintTracing(QPainter& painter, const QRectF& area, const Look& look) const;
  void paintValves(QPainter& painter, const QRectF& area, double fraction, const Look& look) const;

  presentation::HeartSigns signs_;
  std::vector<double> tracing_; ///< mV, at even instants of the cycle.
  std::vector<Sound> sounds_;
  std::vector<Valve> valves_;
};

} // namespace viscera::app
