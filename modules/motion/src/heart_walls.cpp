#include "viscera/motion/heart_walls.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "viscera/core/error.h"
#include "viscera/sequences/beating_heart.h"

namespace viscera::motion {
namespace {

/// The frame of a heart whose cavities are known; empty for any other sequence.
std::optional<sequences::HeartFrame> frameOf(const sequences::Sequence* sequence) {
  const sequences::BeatingHeart* heart = sequence ? sequence->heart() : nullptr;
  return heart ? heart->frame() : std::nullopt;
}

const document::Organ* organCalled(const document::DocumentState& state, const std::string& wanted) {
  for (const auto& organ : *state.organs) {
    std::string name = organ->name;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (name == wanted)
      return organ.get();
  }
  return nullptr;
}

} // namespace

HeartWalls::HeartWalls(const MotionRunner& runner) : runner_(runner) {
  const std::optional<sequences::HeartFrame> frame = frameOf(runner.sequence().get());
  const document::Organ* left = organCalled(runner.state(), "lv");
  const document::Organ* right = organCalled(runner.state(), "rv");
  if (!frame || !left || !right)
    return;
  const document::Organ* outer =
      left->parent ? runner.state().organ(left->parent).get() : organCalled(runner.state(), "outer");
  if (!outer)
    return;
  left_ = left->id;
  right_ = right->id;
  outer_ = outer->id;
  try {
    gauge_.emplace(*frame,
                   sequences::HeartSurfaces{left->mesh->points, right->mesh->points, outer->mesh->points});
  } catch (const DataError&) {
    // Surfaces that were made coarser, or are no heart's: there is nothing to measure.
  }
}

std::optional<sequences::WallPlaces> HeartWalls::now() const {
  if (!gauge_)
    return std::nullopt;
  const auto left = runner_.organs().sharedPoints(left_);
  const auto right = runner_.organs().sharedPoints(right_);
  const auto outer = runner_.organs().sharedPoints(outer_);
  return gauge_->at({*left, *right, *outer});
}

} // namespace viscera::motion
