#include "viscera/localised_scc/localised_s_celestial.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "viscera/coordinates/weights_binding.h"
#include "viscera/localised_scc/region_layout.h"

namespace viscera::localised_scc {
namespace {

using coordinates::BindOptions;
using coordinates::CoordinateGradients;
using coordinates::CoordinateSystem;
using coordinates::HandleSet;
using coordinates::Parameter;

constexpr Eigen::Index kGrain = 256;
/// A share this small may be dropped when its set has no answer: a point a hair inside a region's boundary
/// that belongs to a zone anyway. The jump that this makes is no larger.
constexpr double kNegligibleShare = 1e-9;

const Parameter kOffset{
    "offset", 0.01,
    1000,     10,
    "mm",     "Distance from a zone within which its super-region still counts: smoothness against locality",
    false,    {}};

/// A point of a set, and the set's part in it.
struct Member {
  Eigen::Index point = 0;
  double weight = 0;
  Vec3 gradient = Vec3::Zero();
};

/// Which points each set of handles serves; points in no region are in `outside`.
struct Memberships {
  std::vector<std::vector<Member>> ofSet;
  std::vector<int> outside;
};

Memberships memberships(const RegionLayout& layout, const Points& points, Threads threads) {
  std::vector<std::vector<RegionLayout::Share>> shares(static_cast<std::size_t>(points.rows()));
  parallelRanges(points.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      shares[std::size_t(i)] = layout.shares(points.row(i).transpose());
  });
  Memberships result;
  result.ofSet.resize(static_cast<std::size_t>(layout.setCount()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (shares[std::size_t(i)].empty())
      result.outside.push_back(static_cast<int>(i));
    for (const auto& share : shares[std::size_t(i)])
      result.ofSet[std::size_t(share.set)].push_back({i, share.weight, share.gradient});
  }
  return result;
}

HandleSet subset(const HandleSet& handles, const std::vector<int>& rows) {
  HandleSet chosen;
  chosen.positions.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    chosen.positions.row(static_cast<Eigen::Index>(i)) = handles.positions.row(rows[i]);
  return chosen;
}

Points pointsOf(const Points& points, const std::vector<Member>& members) {
  Points chosen(static_cast<Eigen::Index>(members.size()), 3);
  for (std::size_t i = 0; i < members.size(); ++i)
    chosen.row(static_cast<Eigen::Index>(i)) = points.row(members[i].point);
  return chosen;
}

/// The options for the inner system: those of its parameters that were given to us.
BindOptions optionsFor(const CoordinateSystem& inner, const BindOptions& options) {
  BindOptions chosen;
  chosen.threads = options.threads;
  for (const auto& parameter : inner.parameters())
    if (options.parameters.all().count(parameter.name) > 0)
      chosen.parameters.set(parameter.name, options.parameters.get(parameter));
  return chosen;
}

/// One set of handles with the points it serves, as the inner system takes them.
struct SetTask {
  const std::vector<int>& rows; ///< The set's handles.
  const std::vector<Member>& members;
  HandleSet handles;
  Points points;
};

/// Calls `work(SetTask)` for every set that serves any point.
template <class Work>
void forEachSet(const RegionLayout& layout, const Memberships& members, const HandleSet& handles,
                const Points& points, Progress& progress, const Work& work) {
  for (int set = 0; set < layout.setCount(); ++set) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(set) / layout.setCount(), "localised coordinates");
    const auto& own = members.ofSet[std::size_t(set)];
    const auto& rows = layout.handlesOf(set);
    if (!own.empty())
      work(SetTask{rows, own, subset(handles, rows), pointsOf(points, own)});
  }
}

/// Remembers which points keep how much of their coordinates, and makes the failures of it.
class Coverage {
public:
  Coverage(Eigen::Index points, std::vector<int> outside)
      : missing_(Values::Zero(points)), failed_(std::move(outside)) {}
  void lose(const Member& member) { missing_[member.point] += member.weight; }
  bool usable(Eigen::Index point) const { return missing_[point] <= kNegligibleShare; }
  /// Divides the rows of points that lost a negligible share by what is left.
  void restoreUnity(coordinates::TiledWeights& weights) const {
    for (Eigen::Index i = 0; i < missing_.size(); ++i)
      if (missing_[i] > 0 && usable(i))
        for (Eigen::Index h = 0; h < weights.handles(); ++h)
          weights.set(i, h, weights(i, h) / (1 - missing_[i]));
  }
  std::vector<int> failures() const {
    std::vector<int> list = failed_;
    for (Eigen::Index i = 0; i < missing_.size(); ++i)
      if (!usable(i))
        list.push_back(static_cast<int>(i));
    std::sort(list.begin(), list.end());
    return list;
  }

private:
  Values missing_;
  std::vector<int> failed_;
};

} // namespace

LocalisedSCelestial::LocalisedSCelestial(std::vector<std::shared_ptr<const CoordinateSystem>> inner)
    : inner_(std::move(inner)) {
  assert(!inner_.empty());
}

std::string LocalisedSCelestial::summary() const {
  return "Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.";
}

coordinates::Traits LocalisedSCelestial::traits() const {
  coordinates::Traits traits;
  traits.positive = true;
  traits.interpolates = true;
  traits.closedFormGradient = true;
  traits.usesGroups = true;
  return traits;
}

std::vector<Parameter> LocalisedSCelestial::parameters() const {
  std::vector<Parameter> list = {kOffset};
  Parameter inner{"inner", 0, static_cast<double>(inner_.size() - 1), 0, "", "System used inside each region",
                  true,    {}};
  for (const auto& system : inner_)
    inner.choices.push_back(system->id());
  list.push_back(std::move(inner));
  for (const auto& parameter : inner_.front()->parameters())
    list.push_back(parameter);
  return list;
}

const CoordinateSystem& LocalisedSCelestial::innerFor(const coordinates::ParameterValues& values) const {
  return *inner_[static_cast<std::size_t>(values.get(parameters()[1]))];
}

std::unique_ptr<coordinates::Binding> LocalisedSCelestial::bind(const HandleSet& handles,
                                                                const Points& points,
                                                                const BindOptions& options,
                                                                Progress& progress) const {
  const auto start = std::chrono::steady_clock::now();
  options.parameters.requireWithin(parameters());
  const RegionLayout layout(handles, options.parameters.get(kOffset));
  const auto& inner = innerFor(options.parameters);
  const BindOptions innerOptions = optionsFor(inner, options);
  const Memberships members = memberships(layout, points, options.threads);

  coordinates::TiledWeights weights(points.rows(), handles.positions.rows());
  Coverage coverage(points.rows(), members.outside);
  forEachSet(layout, members, handles, points, progress, [&](const SetTask& task) {
    const auto binding = inner.bind(task.handles, task.points, innerOptions, progress);
    std::vector<bool> failed(task.members.size(), false);
    for (const int point : binding->report().failures) {
      failed[std::size_t(point)] = true;
      coverage.lose(task.members[std::size_t(point)]);
    }
    for (std::size_t column = 0; column < task.rows.size(); ++column) {
      const Values influence = binding->influence(static_cast<int>(column));
      for (std::size_t i = 0; i < task.members.size(); ++i) {
        const Member& member = task.members[i];
        if (!failed[i])
          weights.set(member.point, task.rows[column],
                      weights(member.point, task.rows[column]) + member.weight * influence[Eigen::Index(i)]);
      }
    }
  });
  coverage.restoreUnity(weights);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::make_unique<coordinates::WeightsBinding>(std::move(weights), handles.positions, points,
                                                       coverage.failures(), seconds, options.threads);
}

CoordinateGradients LocalisedSCelestial::gradients(const HandleSet& handles, const Points& points,
                                                   const BindOptions& options, Progress& progress) const {
  options.parameters.requireWithin(parameters());
  const RegionLayout layout(handles, options.parameters.get(kOffset));
  const auto& inner = innerFor(options.parameters);
  const BindOptions innerOptions = optionsFor(inner, options);
  const Memberships members = memberships(layout, points, options.threads);

  const Eigen::Index handleCount = handles.positions.rows();
  CoordinateGradients result;
  result.values = Points::Zero(points.rows() * handleCount, 3);
  result.closedForm = inner.traits().closedFormGradient;
  Coverage coverage(points.rows(), members.outside);
  forEachSet(layout, members, handles, points, progress, [&](const SetTask& task) {
    const auto binding = inner.bind(task.handles, task.points, innerOptions, progress);
    const auto own = inner.gradients(task.handles, task.points, innerOptions, progress);
    for (const int point : own.failures)
      coverage.lose(task.members[std::size_t(point)]);
    for (std::size_t column = 0; column < task.rows.size(); ++column) {
      const Values influence = binding->influence(static_cast<int>(column));
      for (std::size_t i = 0; i < task.members.size(); ++i) {
        const Member& member = task.members[i];
        const auto from = static_cast<Eigen::Index>(i * task.rows.size() + column);
        result.values.row(member.point * handleCount + task.rows[column]) +=
            member.weight * own.values.row(from) + influence[Eigen::Index(i)] * member.gradient.transpose();
      }
    }
  });
  result.failures = coverage.failures();
  for (const int point : result.failures)
    result.values.middleRows(point * handleCount, handleCount).setZero();
  return result;
}

} // namespace viscera::localised_scc
