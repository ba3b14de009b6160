#include "carried_vertices.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/rig_commands.h"

namespace viscera::lesson {
namespace {

/// A sum of handles differs by rounding only, as a part of the size.
constexpr double kRounding = 1e-9;

} // namespace

CarriedVertices::CarriedVertices(const LessonPlan& plan, const LessonSource& source,
                                 live::PosedOrgans& organs, Threads threads)
    : plan_(plan), source_(source), organs_(organs), runner_(source.state, organs, threads),
      restHandles_(source.state.rig->restPositions()), threads_(threads) {
  if (source.sequence) {
    document::requireFits(*source.state.rig, *source.sequence);
    runner_.setSequence(source.sequence);
    runner_.prescribe(source.prescribed);
  }
  keepsVolumes_ =
      source.prescribed.has_value() || std::any_of(source.state.organs->begin(), source.state.organs->end(),
                                                   [](const auto& organ) { return organ->volumeLocked; });
  gather();
  if (isSumOfHandles())
    return;
  weights_.resize(vertices_, 0);
  rest_.conservativeResize(vertices_, 3);
}

void CarriedVertices::gather() {
  for (const PlannedSurface& surface : plan_.surfaces)
    vertices_ += source_.state.organ(surface.organ)->mesh->points.rows();
  const Eigen::Index handles = restHandles_.rows(), own = plan_.ownHandles ? handles : 0;
  rest_.resize(vertices_ + own, 3);
  weights_ = CarrierWeights::Zero(vertices_ + own, handles);
  Eigen::Index first = 0;
  for (const PlannedSurface& surface : plan_.surfaces) {
    const Points& points = source_.state.organ(surface.organ)->mesh->points;
    rest_.middleRows(first, points.rows()) = points;
    if (const deformation::Deformer* bound = organs_.bound(surface.organ))
      for (Eigen::Index handle = 0; handle < handles; ++handle)
        weights_.block(first, handle, points.rows(), 1) =
            bound->binding().influence(static_cast<int>(handle));
    first += points.rows();
  }
  if (own > 0) { // Rows of an empty array have no address.
    rest_.bottomRows(own) = restHandles_.topRows(own);
    weights_.bottomRows(own).setIdentity();
  }
}

bool CarriedVertices::isSumOfHandles() {
  if (restHandles_.rows() == 0)
    return true;
  const double size = boundsOf(restHandles_).diagonal();
  Points pose = restHandles_;
  for (Eigen::Index i = 0; i < pose.size(); ++i)
    pose.data()[i] += 0.05 * size * std::sin(static_cast<double>(i));
  return ((rest_ + weights_ * (pose - restHandles_)) - in(pose)).cwiseAbs().maxCoeff() < kRounding * size;
}

void CarriedVertices::poseAt(double fraction, double ratePerMinute, Points& pose) {
  if (!keepsVolumes_)
    return source_.sequence->poseAt(fraction * 60 / ratePerMinute, ratePerMinute, pose);
  runner_.setRatePerMinute(ratePerMinute);
  std::optional<Points> kept = runner_.poseAt(fraction * 60 / ratePerMinute);
  if (!kept || !runner_.obstacle().empty())
    throw DataError(phrase("the volume cannot be kept throughout the cycle: %1", runner_.obstacle()), {},
                    "unlock it, or prescribe a volume nearer to that at rest");
  pose = std::move(*kept);
}

Points CarriedVertices::in(const Points& pose) {
  organs_.showPose(pose);
  Points points(rest_.rows(), 3);
  Eigen::Index first = 0;
  for (const PlannedSurface& surface : plan_.surfaces) {
    const Points& posed = *organs_.sharedPoints(surface.organ);
    points.middleRows(first, posed.rows()) = posed;
    first += posed.rows();
  }
  points.bottomRows(points.rows() - first) = pose.topRows(points.rows() - first);
  return points;
}

CarriersAt CarriedVertices::carriersAt() {
  return [this](const std::vector<Moment>& moments) {
    std::vector<Points> carriers(moments.size());
    const bool sums = weights_.cols() > 0;
    const auto fill = [&](Eigen::Index begin, Eigen::Index end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        poseAt(moments[i].fraction, moments[i].ratePerMinute, carriers[i]);
        carriers[i] = sums ? Points(carriers[i] - restHandles_) : Points(in(carriers[i]) - rest_);
      }
    };
    const auto count = static_cast<Eigen::Index>(moments.size());
    if (sums && !keepsVolumes_) // Then only the sequence is asked, which may be by several threads.
      parallelRanges(count, 1, threads_, fill);
    else
      fill(0, count);
    return carriers;
  };
}

} // namespace viscera::lesson
