#pragma once

#include <QStringList>
#include <QWidget>

#include <optional>

#include "signs/beat_drawing.h"

namespace viscera::app {

/// A strip with the events of the textbook's beat, below the timeline and in a lecture (`BeatDrawing`).
class BeatStrip final : public QWidget {
  Q_OBJECT

public:
  explicit BeatStrip(QWidget* parent = nullptr);

  /// Sets the beat; empty: nothing is drawn.
  void setBeat(const std::optional<heart::CardiacBeat>& beat);
  bool hasBeat() const { return drawing_.hasBeat(); }
  /// Sets what is drawn of it, by default everything.
  void setSigns(const presentation::HeartSigns& signs);
  /// Draws all lengths and letters larger by that factor.
  void setScale(double scale);
  /// `fraction` of the cycle in [0, 1].
  void setFraction(double fraction);
  /// The names of the valves that are open at the present instant.
  QStringList openValves() const { return drawing_.openValves(fraction_); }
  const BeatDrawing& drawing() const { return drawing_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  BeatDrawing drawing_;
  double scale_ = 1;
  double fraction_ = 0;
};

} // namespace viscera::app
