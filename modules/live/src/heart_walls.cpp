#include "viscera/live/heart_walls.h"

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/heart/beating_heart.h"

namespace viscera::live {
namespace {

/// The frame of a heart whose cavities are known; empty for any other sequence.
std::optional<heart::HeartFrame> frameOf(const sequences::Sequence* sequence) {
  const heart::BeatingHeart* heart = sequence ? sequence->heart() : nullptr;
  return heart ? heart->frame() : std::nullopt;
}

const document::Organ* chamberIn(const document::DocumentState& state, const anatomy::Part& chamber) {
  for (const auto& organ : *state.organs)
    if (anatomy::chamberNamed(organ->name) == chamber)
      return organ.get();
  return nullptr;
}

/// The whole heart of the command line is called like the sample's surface.
const document::Organ* outerIn(const document::DocumentState& state) {
  for (const auto& organ : *state.organs)
    if (organ->name == "outer")
      return organ.get();
  return nullptr;
}

} // namespace

HeartWalls::HeartWalls(const MotionRunner& runner) : runner_(runner) {
  const std::optional<heart::HeartFrame> frame = frameOf(runner.sequence().get());
  const document::Organ* left = chamberIn(runner.state(), anatomy::kLeftVentricle);
  const document::Organ* right = chamberIn(runner.state(), anatomy::kRightVentricle);
  if (!frame || !left || !right)
    return;
  const document::Organ* outer =
      left->parent ? runner.state().organ(left->parent).get() : outerIn(runner.state());
  if (!outer)
    return;
  left_ = left->id;
  right_ = right->id;
  outer_ = outer->id;
  try {
    gauge_.emplace(*frame,
                   heart::HeartSurfaces{left->mesh->points, right->mesh->points, outer->mesh->points});
  } catch (const DataError&) {
    // Surfaces that were made coarser, or are no heart's: there is nothing to measure.
  }
}

std::optional<heart::WallPlaces> HeartWalls::now() const {
  if (!gauge_)
    return std::nullopt;
  const auto left = runner_.organs().sharedPoints(left_);
  const auto right = runner_.organs().sharedPoints(right_);
  const auto outer = runner_.organs().sharedPoints(outer_);
  return gauge_->at({*left, *right, *outer});
}

} // namespace viscera::live
