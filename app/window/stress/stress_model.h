#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

#include "viscera/live/live_stress.h"
#include "viscera/presentation/stress_values.h"
#include "viscera/scene/color_map.h"
#include "window/stress/stress_cycle.h"
#include "window/timeline/playback.h"
#include "window/view/picture.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {

using presentation::GlyphChoice;
using presentation::StressLook;

/// The data of the mode Stress: the stress map of the current organ, live or as the maximum over a cycle,
/// and its curves over that cycle. Page, chart and probe read it. The look is a part of the view's state; it
/// is remembered in the settings.
class StressModel final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  StressModel(Workspace& workspace, Playback& playback, Settings& settings, ViewModel& view,
              const Picture& picture, QObject* parent = nullptr);

  /// Whether the stress map is on, and thus computed for the current organ.
  bool active() const { return view_.state().shown.stress; }

  live::LiveStress& live() { return live_; }
  const live::LiveStress& live() const { return live_; }
  const StressLook& look() const { return view_.state().stress; }
  /// Changing the quantity, or the material of one in pascals, resets its limit and range.
  void setLook(StressLook look);
  /// Changes a part of the look.
  void change(const std::function<void(StressLook&)>& edit);

  /// The displayed instant as a fraction of the cycle, [0, 1]; none while the document's pose is shown.
  std::optional<double> shownFraction() const;

  /// The numbers that are shown, with their colours and range.
  const presentation::StressValues& shown() const { return picture_.presenter().stressValues(); }
  QString title() const;
  /// A number with its unit: "12.3 deg", "0.123 kPa, liver".
  QString format(double value) const;

  /// Shows the maximum over a cycle, once it is computed, instead of the map of this instant.
  void setPeakShown(bool shown);
  bool peakShown() const { return look().peak && cycle() && cycle()->peak; }
  /// When the largest rotational stress of the cycle is reached; null without a cycle.
  const live::StressSample* peakInstant() const;
  /// Shows the sequence at that instant instead of the maximum over it.
  void goToPeak();
  /// Whether the map of the current organ in its pose is computed.
  bool hasMap() const;
  /// The map that is shown.
  const deformation::StressMap& shownMap() const { return peakShown() ? *cycle()->peak : live_.map(); }

  /// The stress over one cycle of the present sequence, with the maximum only where that is wanted; null
  /// while it is being computed, and without a sequence.
  std::shared_ptr<const live::CycleStress> cycle() const { return live_.cycle(); }

  /// The point that is being looked at, -1: none.
  int probe() const { return look().probe; }
  void setProbe(int point) {
    view_.change([point](presentation::ViewState& state) { state.stress.probe = point; });
  }

  /// Pins the point that is being looked at to the tissue, as a step to undo; nothing happens without one.
  void pinProbe();
  /// The values of the displayed map at the pinned probes and along the lines of the current organ.
  const live::ReadMarks& marks() const { return picture_.presenter().readMarks(); }
  /// Whether the document has pinned probes, or lines between them, in the current organ: what the actions
  /// ask at every change, when the values are not read yet.
  bool hasProbes() const;
  bool hasProfiles() const;

  /// A caution about the limits of the map for the displayed sequence; empty for none.
  const QString& caution() const { return caution_; }
  void setCaution(const QString& caution) {
    caution_ = caution;
    Q_EMIT statusChanged();
  }

  /// Selects the witness point with the largest value of the displayed quantity (the smallest for quantities
  /// whose minimum matters), and moves the cut to its place in the pose. This is the point of the number on
  /// the page; folded tissue is left out. Nothing happens while there is no map.
  void goToMaximum();

Q_SIGNALS:
  void activeChanged();
  void lookChanged();
  void statusChanged();
  /// The mesh of witness points has changed.
  void sampled();
  /// Points, numbers or legend have changed; emitted with every frame, before it is rendered.
  void shownChanged();
  void probeChanged();
  /// Probes, lines or the organs that they lie in have changed.
  void marksChanged();
  /// The sequence has moved to another instant, and its frame is drawn next; for cursors.
  void instantChanged();
  /// The numbers of the frame that is drawn next have changed; emitted with every frame while the map is on,
  /// for texts.
  void numbersChanged();
  /// The same, at most ten times a second, for slower displays.
  void updated();

private:
  void follow();
  void onView();
  void onStress(const live::StressEvent& event);

  Workspace& workspace_;
  Playback& playback_;
  Settings& settings_;
  ViewModel& view_;
  const Picture& picture_;
  live::LiveStress& live_;
  StressCycle cycle_;
  StressLook known_;                                     ///< The look of the last `lookChanged`.
  document::OrganId organ_;                              ///< The current organ of the last `follow`.
  std::shared_ptr<const deformation::WitnessMesh> mesh_; ///< The mesh of the last `sampled`.
  bool knownActive_ = false;
  QString caution_;
  QTimer throttle_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
