#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viscera/live/stress_frame.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/presentation/stress_look.h"
#include "viscera/scene/color_map.h"

namespace viscera::presentation {

/// Computes the numbers that a stress map shows, and their colours: of this instant, or of the maximum over
/// a cycle. For one thread.
class StressValues {
public:
  /// Computes the numbers of a frame for a look. `shared` is a range to use instead of their own, unless the
  /// look has a pinned range. O(points).
  void update(const live::StressFrame& frame, const StressLook& look,
              std::optional<scene::ValueRange> shared = std::nullopt);

  /// Whether there are numbers to show.
  bool ready() const { return values_->size() > 0; }
  /// One number for each point of the mesh, in the quantity's unit. They keep their place in memory.
  std::shared_ptr<const Values> values() const { return values_; }
  /// The number of witness points, which come first among the points; 0 while there are no numbers.
  Eigen::Index witnesses() const { return ready() ? mesh_->witnesses : 0; }
  /// Statistics of the numbers at witness points.
  const live::QuantitySummary& summary() const { return summary_; }
  /// The number of folded witness points in the displayed map.
  int folded() const { return folded_; }
  /// Whether the numbers are those of the maximum over a cycle.
  bool peak() const { return peak_; }
  live::StressQuantity quantity() const { return measure_.quantity; }
  /// The quantity with the material that it is of.
  const live::StressMeasure& measure() const { return measure_; }
  /// The colours; `missing` marks folded tissue.
  const scene::ColorMap& colors() const { return colors_; }
  scene::ValueRange range() const { return shared_.value_or(range_); }
  /// Whether the shown pose, or the sequence, strains the organ at all.
  bool deformed() const { return deformed_; }
  /// What a legend says: `range`, but at rest only the value that undeformed tissue has. A scale that no
  /// number reaches would invent an amount.
  scene::ValueRange legendRange() const;
  /// The range that these numbers alone would have.
  scene::ValueRange ownRange() const { return range_; }

private:
  std::shared_ptr<Values> values_ = std::make_shared<Values>();
  live::QuantitySummary summary_;
  int folded_ = 0;
  bool peak_ = false;
  live::StressMeasure measure_ = live::StressQuantity::rotationalStress;
  std::shared_ptr<const deformation::WitnessMesh> mesh_; ///< The mesh to which the range belongs.
  scene::ColorMap colors_;
  scene::ValueRange range_{0, 0};
  bool deformed_ = false;
  bool pinned_ = false; ///< The user keeps the range.
  std::optional<scene::ValueRange> shared_;
};

/// The member of a look that names the colour map for a quantity.
std::string StressLook::*colorsOf(live::StressQuantity quantity);

/// The colour map of that name (`scene::colorMapByName`), with folded tissue in magenta, a colour that none
/// of the maps contains.
scene::ColorMap stressColors(const std::string& name);

/// The range of a legend for a quantity of which nine tenths lie in `bulk`: from a list of round steps, so
/// that it does not change continuously while something moves, and half as wide again as the bulk: a few
/// extreme places do not take the colours from all others. Ratios lie around 1. It grows at once; it shrinks
/// only when what would do fills less than `kLeastFilled` of `before`. `before.logarithmic` asks for a
/// logarithmic range: of an angle it ends below where the bulk begins, within three decades; of a ratio it
/// goes by one factor up and down from 1.
scene::ValueRange steppedRange(live::StressQuantity quantity, scene::ValueRange bulk,
                               scene::ValueRange before);

/// The range that holds both.
scene::ValueRange joined(scene::ValueRange a, scene::ValueRange b);

/// The same ends on a linear or a logarithmic scale; the lower end is moved above 0 for a logarithmic scale.
/// Folded tissue, which is or is not, stays linear.
scene::ValueRange onScale(live::StressQuantity quantity, scene::ValueRange range, bool logarithmic);

inline constexpr double kLeastFilled = 0.35;
/// The lower end of a logarithmic range, of its upper end, lies between these.
inline constexpr double kLowestPart = 1e-3, kHighestPart = 0.1;

} // namespace viscera::presentation
