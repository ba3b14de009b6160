#include "viscera/deformation/bind_witnesses.h"

#include <algorithm>

namespace viscera::deformation {
namespace {
/// Enough points to keep all threads busy, few enough that the portion's own copy does not matter.
constexpr Eigen::Index kPortion = 8192;
} // namespace

std::shared_ptr<const WitnessGradients>
bindWitnesses(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
              const Points& points, const coordinates::BindOptions& options, Progress& progress) {
  auto result = std::make_shared<WitnessGradients>(points.rows(), handles.positions.rows());
  for (Eigen::Index begin = 0; begin < points.rows(); begin += kPortion) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(begin) / static_cast<double>(points.rows()),
                    "derivatives at the witness points");
    const Eigen::Index count = std::min(kPortion, points.rows() - begin);
    Progress portion; // A portion takes milliseconds to a second; between them the caller may cancel.
    result->put(begin, system.gradients(handles, points.middleRows(begin, count), options, portion), count);
  }
  progress.throwIfCancelled();
  progress.report(1);
  return result;
}

} // namespace viscera::deformation
