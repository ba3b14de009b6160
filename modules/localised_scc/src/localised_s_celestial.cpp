#include "viscera/localised_scc/localised_s_celestial.h"

#include <atomic>
#include <cassert>
#include <chrono>
#include <utility>

#include "viscera/coordinates/systems.h"
#include "viscera/coordinates/weights_binding.h"
#include "viscera/localised_scc/region_layout.h"

namespace viscera::localised_scc {
namespace {

using coordinates::BindOptions;
using coordinates::CoordinateGradients;
using coordinates::CoordinateSystem;
using coordinates::HandleSet;
using coordinates::Parameter;

/// Points that are bound together: enough to fill the solver's packs, few enough for every thread to get
/// some.
constexpr Eigen::Index kBlock = 1024;
/// A share this small may be dropped when its set has no answer: a point a hair inside a region's boundary
/// that belongs to a zone anyway. The jump that this makes is no larger.
constexpr double kNegligibleShare = 1e-9;

const Parameter kOffset{
    .name = "offset",
    .minimum = 0.01,
    .maximum = 1000,
    .standard = 10,
    .unit = "mm",
    .help = "Distance from a zone within which its super-region still counts: smoothness against locality"};

using Systems = std::vector<std::shared_ptr<const CoordinateSystem>>;

coordinates::SystemDescription describedWith(const Systems& inner) {
  assert(!inner.empty());
  Parameter choice{.name = "inner",
                   .maximum = static_cast<double>(inner.size() - 1),
                   .help = "System used inside each region",
                   .integer = true};
  for (const auto& system : inner)
    choice.choices.push_back(system->id());
  std::vector<Parameter> parameters = inner.front()->parameters();
  parameters.insert(parameters.begin(), {kOffset, choice});
  return {
      .id = "localised-s-celestial",
      .name = "Localised S-Celestial",
      .summary =
          "Groups of handles move only their own region of the organ; neighbouring regions blend smoothly.",
      .traits = {.positive = true, .interpolates = true, .closedFormGradient = true, .usesGroups = true},
      .parameters = std::move(parameters)};
}

/// A point of a set, and the set's part in it.
struct Member {
  Eigen::Index point = 0;
  double weight = 0;
  Vec3 gradient = Vec3::Zero();
};

/// One set of handles with those points of a block that it serves, as the inner system takes them.
struct SetTask {
  const std::vector<int>& rows; ///< The set's handles.
  const std::vector<Member>& members;
  const HandleSet& handles;
  Points points;
};

Points pointsOf(const Points& points, const std::vector<Member>& members) {
  Points chosen(static_cast<Eigen::Index>(members.size()), 3);
  for (std::size_t i = 0; i < members.size(); ++i)
    chosen.row(static_cast<Eigen::Index>(i)) = points.row(members[i].point);
  return chosen;
}

/// The options for the inner system: those of its parameters that were given to us. One thread: the blocks
/// take all of them.
BindOptions optionsFor(const CoordinateSystem& inner, const BindOptions& options) {
  BindOptions chosen;
  chosen.threads.count = 1;
  for (const auto& parameter : inner.parameters())
    if (options.parameters.all().count(parameter.name) > 0)
      chosen.parameters.set(parameter.name, options.parameters.get(parameter));
  return chosen;
}

/// How much of each point's coordinates has no answer, and which points fail for it. Several threads may
/// write to it, each for points of its own.
class Coverage {
public:
  explicit Coverage(Eigen::Index points) : missing_(Values::Zero(points)) {}
  void lose(Eigen::Index point, double part) { missing_[point] += part; }
  bool usable(Eigen::Index point) const { return missing_[point] <= kNegligibleShare; }
  /// Divides the rows of points that lost a negligible share by what is left.
  void restoreUnity(coordinates::TiledWeights& weights) const {
    for (Eigen::Index i = 0; i < missing_.size(); ++i)
      if (missing_[i] > 0 && usable(i))
        for (Eigen::Index h = 0; h < weights.handles(); ++h)
          weights.set(i, h, weights(i, h) / (1 - missing_[i]));
  }
  std::vector<int> failures() const {
    std::vector<int> list;
    for (Eigen::Index i = 0; i < missing_.size(); ++i)
      if (!usable(i))
        list.push_back(static_cast<int>(i));
    return list;
  }

private:
  Values missing_;
};

/// Calls `work(SetTask)` for every block of points and every set of handles that serves some of them. A point
/// is in one block, so no two threads work on one point. Points in no region are lost to `coverage`.
template <class Work>
void forEachSet(const RegionLayout& layout, const HandleSet& handles, const Points& points, Threads threads,
                Progress& progress, Coverage& coverage, const Work& work) {
  std::vector<HandleSet> sets;
  for (int set = 0; set < layout.setCount(); ++set)
    sets.push_back({handles.positions(layout.handlesOf(set), Eigen::all), {}, {}});
  std::atomic<Eigen::Index> done{0};
  progress.throwIfCancelled();
  parallelRanges(points.rows(), kBlock, threads, [&](Eigen::Index begin, Eigen::Index end) {
    progress.throwIfCancelled();
    std::vector<std::vector<Member>> ofSet(sets.size());
    std::vector<RegionLayout::Share> shares;
    for (Eigen::Index i = begin; i < end; ++i) {
      layout.shares(points.row(i).transpose(), shares);
      if (shares.empty())
        coverage.lose(i, 1);
      for (const auto& share : shares)
        ofSet[std::size_t(share.set)].push_back({i, share.weight, share.gradient});
    }
    for (std::size_t set = 0; set < sets.size(); ++set)
      if (const auto& members = ofSet[set]; !members.empty())
        work(SetTask{layout.handlesOf(static_cast<int>(set)), members, sets[set], pointsOf(points, members)});
    progress.report(static_cast<double>(done += end - begin) / static_cast<double>(points.rows()),
                    "localised coordinates");
  });
}

/// Adds a set's coordinates, by their parts, to the rows of its points; those without an answer are lost.
void addBinding(const coordinates::Binding& binding, const SetTask& task, Coverage& coverage,
                coordinates::TiledWeights& weights) {
  std::vector<bool> failed(task.members.size(), false);
  for (const int point : binding.report().failures) {
    failed[std::size_t(point)] = true;
    coverage.lose(task.members[std::size_t(point)].point, task.members[std::size_t(point)].weight);
  }
  for (std::size_t column = 0; column < task.rows.size(); ++column) {
    const Values influence = binding.influence(static_cast<int>(column));
    const int handle = task.rows[column];
    for (std::size_t i = 0; i < task.members.size(); ++i) {
      const Member& member = task.members[i];
      if (!failed[i])
        weights.set(member.point, handle,
                    weights(member.point, handle) + member.weight * influence[Eigen::Index(i)]);
    }
  }
}

/// The inner systems bound region by region.
class LocalisedSCelestial final : public coordinates::DescribedSystem {
public:
  explicit LocalisedSCelestial(Systems inner)
      : DescribedSystem(describedWith(inner)), inner_(std::move(inner)) {}

  std::unique_ptr<coordinates::Binding> bind(const HandleSet& handles, const Points& points,
                                             const BindOptions& options, Progress& progress) const override;
  CoordinateGradients gradients(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress& progress) const override;
  coordinates::SpaceLayout layout(const HandleSet& handles,
                                  const coordinates::ParameterValues& values) const override;

private:
  const CoordinateSystem& innerFor(const coordinates::ParameterValues& values) const;

  Systems inner_;
};

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

  coordinates::TiledWeights weights(points.rows(), handles.positions.rows());
  Coverage coverage(points.rows());
  forEachSet(layout, handles, points, options.threads, progress, coverage, [&](const SetTask& task) {
    Progress ofBlock; // The block is short; the whole is reported and cancelled between blocks.
    addBinding(*inner.bind(task.handles, task.points, innerOptions, ofBlock), task, coverage, weights);
  });
  coverage.restoreUnity(weights);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::make_unique<coordinates::WeightsBinding>(std::move(weights), handles.positions, points,
                                                       coverage.failures(), seconds, options.threads,
                                                       layout.notes());
}

CoordinateGradients LocalisedSCelestial::gradients(const HandleSet& handles, const Points& points,
                                                   const BindOptions& options, Progress& progress) const {
  options.parameters.requireWithin(parameters());
  const RegionLayout layout(handles, options.parameters.get(kOffset));
  const auto& inner = innerFor(options.parameters);
  const BindOptions innerOptions = optionsFor(inner, options);

  const Eigen::Index handleCount = handles.positions.rows();
  CoordinateGradients result;
  result.values = Points::Zero(points.rows() * handleCount, 3);
  result.closedForm = inner.traits().closedFormGradient;
  Coverage coverage(points.rows());
  forEachSet(layout, handles, points, options.threads, progress, coverage, [&](const SetTask& task) {
    Progress ofBlock;
    const auto binding = inner.bind(task.handles, task.points, innerOptions, ofBlock);
    const auto own = inner.gradients(task.handles, task.points, innerOptions, ofBlock);
    for (const int point : own.failures)
      coverage.lose(task.members[std::size_t(point)].point, task.members[std::size_t(point)].weight);
    for (std::size_t column = 0; column < task.rows.size(); ++column) {
      const Values influence = binding->influence(static_cast<int>(column));
      for (std::size_t i = 0; i < task.members.size(); ++i) {
        const Member& member = task.members[i];
        const auto from = static_cast<Eigen::Index>(i * task.rows.size() + column);
        // a = sum_s w_s a_s over the sets s, and grad a = sum_s (w_s grad a_s + a_s grad w_s).
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

coordinates::SpaceLayout LocalisedSCelestial::layout(const HandleSet& handles,
                                                     const coordinates::ParameterValues& values) const {
  values.requireWithin(parameters());
  return spaceLayoutOf(RegionLayout(handles, values.get(kOffset)), handles.groups.size(), kOffset.name);
}

} // namespace

std::shared_ptr<const CoordinateSystem> localisedSCelestial(Systems inner) {
  return std::make_shared<LocalisedSCelestial>(std::move(inner));
}

std::shared_ptr<const CoordinateSystem> localisedWithBuiltIns() {
  Systems inner;
  for (const auto& system : coordinates::builtInSystems()) {
    const auto traits = system->traits();
    const bool sound = traits.positive && traits.everywhere && traits.continuous;
    if (sound && !traits.needsCage && !traits.needsTetrahedra && !traits.usesGroups)
      inner.push_back(system);
  }
  return localisedSCelestial(std::move(inner));
}

} // namespace viscera::localised_scc
