#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

#include "viscera/live/live_stress.h"
#include "viscera/scene/color_map.h"
#include "window/settings.h"
#include "window/stress/stress_look.h"
#include "window/timeline/playback.h"
#include "window/workspace.h"

namespace viscera::app {

/// What Stress mode knows: the map of the current organ as it is looked at, live or as the peak over a cycle,
/// and what became of it over time. View, page, chart and probe all look at this.
class StressModel final : public QObject {
  Q_OBJECT

public:
  StressModel(Workspace& workspace, Playback& playback, Settings& settings, QObject* parent = nullptr);
  ~StressModel() override;

  /// While active, the current organ is followed.
  void setActive(bool active);
  bool active() const { return active_; }

  live::LiveStress& live() { return live_; }
  const live::LiveStress& live() const { return live_; }
  const StressLook& look() const { return look_; }
  void setLook(const StressLook& look);

  /// Whether there are numbers to show.
  bool ready() const { return values_->size() > 0; }
  /// The numbers that are shown, one a point of the mesh, in the quantity's unit.
  std::shared_ptr<const Values> values() const { return values_; }
  /// Of the witnesses among them.
  const live::QuantitySummary& summary() const { return summary_; }
  /// Witnesses that are folded in what is shown.
  int folded() const;
  /// The legend: its colours and range. `missing` of the colours is for what is folded.
  const scene::ColorMap& colors() const { return colors_; }
  scene::ValueRange range() const { return range_; }
  QString title() const;
  /// A number with its unit: "12.3 deg".
  QString format(double value) const;

  /// The peak over a cycle instead of the map of this instant; nothing happens while there is none.
  void setPeakShown(bool shown);
  bool peakShown() const { return peakShown_ && live_.peak(); }
  /// Looks for the peak over one cycle of the sequence that is there, and shows it.
  void findPeak();
  /// The map that is shown.
  const deformation::StressMap& shownMap() const;

  /// The stress of the witnesses while a sequence played.
  const live::StressRecord& record() const { return record_; }

  /// The point that is being looked at, -1: none.
  int probe() const { return probe_; }
  void setProbe(int point);

Q_SIGNALS:
  void activeChanged();
  void lookChanged();
  void statusChanged();
  /// Another mesh, or none.
  void sampled();
  /// Points, numbers or legend are new: every frame.
  void shownChanged();
  void probeChanged();
  /// The same, at most ten times a second: for numbers to be read.
  void updated();

private:
  void follow();
  void onStress(const live::StressEvent& event);
  void recompute();
  void sample();

  Workspace& workspace_;
  Playback& playback_;
  Settings& settings_;
  live::LiveStress& live_;
  StressLook look_;
  bool active_ = false;
  bool peakShown_ = false;
  std::shared_ptr<Values> values_ = std::make_shared<Values>();
  live::QuantitySummary summary_;
  scene::ColorMap colors_;
  scene::ValueRange range_{0, 0};
  live::StressRecord record_;
  int probe_ = -1;
  QTimer throttle_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
