#include "refine_rest.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "broyden_search.h"

namespace viscera::deformation {
namespace {

constexpr Eigen::Index kSamplesBoundAtOnce = 65'536; ///< Samples bound at a time: weights take memory.
constexpr Eigen::Index kSamplesAtOnce = 4096;        ///< Samples that a thread takes at a time.
constexpr int kMostRefinements = 6;
constexpr double kRough = 0.5; ///< Of the tolerance: what the grid may be off without being asked again.

using Searches = std::vector<BroydenSearch>;

/// The samples that the grid answers too roughly, in their order; the roughest where there are too many.
std::vector<Eigen::Index> roughSamples(const RestField& field, const Refinement& refinement,
                                       const RestPoints& rest, Threads threads) {
  const Eigen::Index count = rest.points.rows();
  std::vector<float> roughness(static_cast<std::size_t>(count), 0);
  parallelRanges(count, kSamplesAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      if (rest.states[static_cast<std::size_t>(i)] == RestState::moved)
        roughness[static_cast<std::size_t>(i)] =
            static_cast<float>(field.roughnessAt(rest.points.row(i).transpose()));
  });
  const auto limit = static_cast<float>(kRough * refinement.toleranceMm);
  std::vector<Eigen::Index> rough;
  for (Eigen::Index i = 0; i < count; ++i)
    if (roughness[static_cast<std::size_t>(i)] > limit)
      rough.push_back(i);
  const auto most = static_cast<std::size_t>(std::max<Eigen::Index>(refinement.mostPoints, 0));
  if (rough.size() <= most)
    return rough;
  const auto rougher = [&](Eigen::Index a, Eigen::Index b) {
    const float one = roughness[static_cast<std::size_t>(a)], other = roughness[static_cast<std::size_t>(b)];
    return one > other || (one == other && a < b);
  };
  std::nth_element(rough.begin(), rough.begin() + static_cast<std::ptrdiff_t>(most), rough.end(), rougher);
  rough.resize(most);
  std::sort(rough.begin(), rough.end());
  return rough;
}

/// The motion of the space, exactly: the system's in the hull; around it the field's with what that is off
/// where the hull is entered, so that there is no jump.
Points exactDisplacements(const RestField& field, const coordinates::CoordinateSystem& system,
                          const Searches& searches) {
  const auto count = static_cast<Eigen::Index>(searches.size());
  const Threads threads = field.options().threads;
  Points entries(count, 3);
  parallelRanges(count, kSamplesAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      entries.row(i) = field.pulledIn(searches[static_cast<std::size_t>(i)].at).transpose();
  });
  Progress quiet; // The caller looks for cancelling between pieces.
  const auto binding = system.bind(field.handles(), entries, field.options(), quiet);
  Points moved;
  binding->deform(field.pose(), moved, threads);
  parallelRanges(count, kSamplesAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const Vec3 at = searches[static_cast<std::size_t>(i)].at, entry = entries.row(i).transpose();
      // u(x) = u_field(x) + part(x) (u_exact(e) - u_field(e)), with e the place x pulled into the hull.
      const Vec3 off = moved.row(i).transpose() - entry - field.displacementAt(entry);
      moved.row(i) = (field.displacementAt(at) + field.exactPart(at) * off).transpose();
    }
  });
  for (const int failure : binding->report().failures)
    moved.row(failure).setConstant(std::numeric_limits<double>::quiet_NaN());
  return moved;
}

Searches begin(const RestField& field, const SamplePlane& plane, const RestPoints& rest,
               const Eigen::Index* rows, Eigen::Index count) {
  Searches searches(static_cast<std::size_t>(count));
  parallelRanges(count, kSamplesAtOnce, field.options().threads, [&](Eigen::Index first, Eigen::Index last) {
    for (Eigen::Index i = first; i < last; ++i) {
      BroydenSearch& search = searches[static_cast<std::size_t>(i)];
      search.row = rows[i];
      search.target = plane.at(rows[i] % plane.columns, rows[i] / plane.columns);
      search.at = rest.points.row(rows[i]).transpose();
      search.derivative += field.motionAt(search.at).gradient;
    }
  });
  return searches;
}

/// One step of all searches; gives those that are not at their end, in their order.
Searches advanced(Searches searches, const Points& moved, double toleranceMm, Threads threads,
                  const std::function<void(const BroydenSearch&)>& finish) {
  std::vector<std::uint8_t> going(searches.size(), 0);
  parallelRanges(static_cast<Eigen::Index>(searches.size()), kSamplesAtOnce, threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index i = begin; i < end; ++i) {
                     BroydenSearch& search = searches[static_cast<std::size_t>(i)];
                     const bool goesOn = search.advance(moved.row(i).transpose(), toleranceMm);
                     going[static_cast<std::size_t>(i)] = goesOn ? 1 : 0;
                     if (!goesOn)
                       finish(search); // Each has a row of its own.
                   }
                 });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < searches.size(); ++i)
    if (going[i] != 0)
      searches[kept++] = searches[i];
  searches.resize(kept);
  return searches;
}

} // namespace

void refineRest(const RestField& field, const coordinates::CoordinateSystem& system, const SamplePlane& plane,
                const Refinement& refinement, RestPoints& rest, Progress& progress) {
  const auto rough = roughSamples(field, refinement, rest, field.options().threads);
  const auto finish = [&](const BroydenSearch& search) {
    if (std::isfinite(search.bestError))
      rest.points.row(search.row) = search.best.transpose();
  };
  const auto count = static_cast<Eigen::Index>(rough.size());
  for (Eigen::Index first = 0; first < count; first += kSamplesBoundAtOnce) {
    Searches searches = begin(field, plane, rest, rough.data() + first,
                              std::min<Eigen::Index>(kSamplesBoundAtOnce, count - first));
    for (int round = 0; round < kMostRefinements && !searches.empty(); ++round) {
      progress.throwIfCancelled();
      const Points moved = exactDisplacements(field, system, searches);
      searches =
          advanced(std::move(searches), moved, refinement.toleranceMm, field.options().threads, finish);
    }
    std::for_each(searches.begin(), searches.end(), finish);
  }
}

} // namespace viscera::deformation
