#include "viscera/deformation/bind_witnesses.h"

#include <algorithm>

#include "viscera/deformation/tetrahedralise.h"

namespace viscera::deformation {
namespace {
/// Enough points to keep all threads busy, few enough that the portion's own copy does not matter. Systems
/// that fill the handles with tetrahedra first get all points at once: they take longer to prepare than to
/// answer.
constexpr Eigen::Index kPortion = 8192;
} // namespace

std::shared_ptr<const WitnessGradients>
bindWitnesses(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
              const Points& points, const coordinates::BindOptions& options, Progress& progress) {
  const coordinates::BindOptions own = withTetgen(options);
  const Eigen::Index portion = system.traits().needsTetrahedra ? points.rows() : kPortion;
  std::shared_ptr<WitnessGradients> result;
  for (Eigen::Index begin = 0; begin < points.rows(); begin += portion) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(begin) / static_cast<double>(points.rows()),
                    "derivatives at the witness points");
    const Eigen::Index count = std::min(portion, points.rows() - begin);
    Progress brief; // A portion takes milliseconds to a second; between them the caller may cancel.
    Progress& watched = system.traits().needsTetrahedra ? progress : brief;
    const auto gradients = system.gradients(handles, points.middleRows(begin, count), own, watched);
    if (!result)
      result = std::make_shared<WitnessGradients>(points.rows(), handles.positions.rows(), gradients.lift);
    result->put(begin, gradients, count);
  }
  if (!result)
    result = std::make_shared<WitnessGradients>(0, handles.positions.rows());
  progress.throwIfCancelled();
  progress.report(1);
  return result;
}

} // namespace viscera::deformation
