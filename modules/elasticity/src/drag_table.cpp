#include "viscera/elasticity/drag_table.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::elasticity {
namespace {

constexpr int kGroups = 3;
/// A pose is timed again until that much time has gone by.
constexpr double kPosedSeconds = 0.01;
constexpr int kMostPosed = 100;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The scene's handles; of a system with groups, with those that grouping adds.
coordinates::HandleSet handlesFor(const coordinates::Traits& traits, const DragScene& scene) {
  coordinates::HandleSet handles = scene.handles;
  if (!traits.usesGroups)
    return handles;
  const auto grouping = deformation::groupsAlongAxis(handles.positions, scene.surface, kGroups);
  Points all(handles.positions.rows() + grouping.added.rows(), 3);
  all << handles.positions, grouping.added;
  return {all, {}, grouping.groups};
}

/// The pose of the scene's handles; those behind them stay at rest.
Points poseOf(const coordinates::HandleSet& handles, const Points& pose) {
  Points all = handles.positions;
  all.topRows(pose.rows()) = pose;
  return all;
}

DragDifference differenceTo(const ElasticDrag& drag, const Points& displacements) {
  const Values distances = (displacements - drag.displacements).rowwise().norm();
  const std::vector<double> all(distances.begin(), distances.end());
  const double perCent = 100 / drag.dragMm;
  DragDifference difference;
  difference.median = perCent * quantileOf(all, 0.5);
  difference.p95 = perCent * quantileOf(all, 0.95);
  difference.relative = 100 * distances.norm() / drag.displacements.norm();
  return difference;
}

/// The rank correlation over witnesses that have coordinates.
double stressAgreement(const deformation::WitnessGradients& gradients, const Points& pose,
                       const ElasticDrag& drag) {
  deformation::StressMap map;
  gradients.evaluate(pose, map, Threads{1});
  std::vector<double> ours, elastic;
  for (Eigen::Index w = 0; w < gradients.witnesses(); ++w)
    if (!gradients.failed(w)) {
      ours.push_back(map.rotationalStress[w]);
      elastic.push_back(drag.stress[w]);
    }
  const auto count = static_cast<Eigen::Index>(ours.size());
  return rankCorrelation(Eigen::Map<const Values>(ours.data(), count),
                         Eigen::Map<const Values>(elastic.data(), count));
}

void compare(const coordinates::SystemVariant& variant, const SolvedScene& solved, SystemOnOrgan& found,
             Progress& progress) {
  const DragScene& scene = solved.scene;
  const coordinates::HandleSet handles = handlesFor(variant.system->traits(), scene);
  coordinates::BindOptions options;
  options.parameters = variant.parameters;
  options.threads = Threads{1};
  options = deformation::withTetgen(options);
  const auto begin = Clock::now();
  const auto binding = deformation::bindOrgan(*variant.system, handles, scene.points, options, progress);
  found.bindSeconds = secondsSince(begin);
  const auto gradients =
      deformation::bindWitnesses(*variant.system, handles, scene.witnesses, options, progress);
  found.lostWitnesses = static_cast<Eigen::Index>(gradients->failures().size());
  for (const ElasticDrag& drag : solved.drags) {
    progress.throwIfCancelled();
    if (!drag.refusal.empty())
      continue;
    const Points pose = poseOf(handles, drag.pose);
    Points posed;
    binding->deform(pose, posed, Threads{1});
    DragDifference difference = differenceTo(drag, posed - scene.points);
    difference.spearman = stressAgreement(*gradients, pose, drag);
    found.drags.push_back(difference);
  }
  const auto beginPosing = Clock::now();
  int poses = 0;
  Points posed;
  while (poses < kMostPosed && (poses == 0 || secondsSince(beginPosing) < kPosedSeconds)) {
    binding->deform(handles.positions, posed, Threads{1});
    ++poses;
  }
  found.poseMilliseconds = 1e3 * secondsSince(beginPosing) / poses;
}

SystemOnOrgan comparedOn(const coordinates::SystemVariant& variant, const SolvedScene& scene,
                         Progress& progress) {
  SystemOnOrgan found;
  found.organ = scene.scene.organ;
  try {
    compare(variant, scene, found, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    found.refusal = explanationOf(error).english();
    found.drags.clear();
  }
  return found;
}

/// The ranks of numbers, equal ones with the mean of theirs.
Values ranksOf(const Values& numbers) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(numbers.size()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return numbers[a] < numbers[b]; });
  Values ranks(numbers.size());
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    while (next < order.size() && numbers[order[next]] == numbers[order[first]])
      ++next;
    for (std::size_t i = first; i < next; ++i)
      ranks[order[i]] = 0.5 * static_cast<double>(first + next - 1);
  }
  return ranks;
}

/// The median over all drags of one of their numbers.
double middleOf(const SystemDrags& system, double DragDifference::*member) {
  std::vector<double> numbers;
  for (const SystemOnOrgan& organ : system.organs)
    for (const DragDifference& drag : organ.drags)
      if (std::isfinite(drag.*member))
        numbers.push_back(drag.*member);
  return quantileOf(std::move(numbers), 0.5);
}

double meanOf(const SystemDrags& system, double SystemOnOrgan::*member) {
  double sum = 0;
  int count = 0;
  for (const SystemOnOrgan& organ : system.organs)
    if (organ.refusal.empty()) {
      sum += organ.*member;
      ++count;
    }
  return count > 0 ? sum / count : kNone;
}

} // namespace

double quantileOf(std::vector<double> numbers, double part) {
  if (numbers.empty())
    return kNone;
  std::sort(numbers.begin(), numbers.end());
  return numbers[static_cast<std::size_t>(part * static_cast<double>(numbers.size() - 1))];
}

double rankCorrelation(const Values& a, const Values& b) {
  if (a.size() == 0)
    return kNone;
  Values first = ranksOf(a), second = ranksOf(b);
  first.array() -= first.mean();
  second.array() -= second.mean();
  const double size = first.norm() * second.norm();
  return size > 0 ? first.dot(second) / size : kNone;
}

std::size_t SystemDrags::drags() const {
  return std::accumulate(
      organs.begin(), organs.end(), std::size_t{0},
      [](std::size_t sum, const SystemOnOrgan& organ) { return sum + organ.drags.size(); });
}

DragDifference SystemDrags::middle() const {
  return {middleOf(*this, &DragDifference::median), middleOf(*this, &DragDifference::p95),
          middleOf(*this, &DragDifference::relative), middleOf(*this, &DragDifference::spearman)};
}

double SystemDrags::bindSeconds() const {
  return meanOf(*this, &SystemOnOrgan::bindSeconds);
}

double SystemDrags::poseMilliseconds() const {
  return meanOf(*this, &SystemOnOrgan::poseMilliseconds);
}

std::vector<SystemDrags> compareDrags(const std::vector<coordinates::SystemVariant>& variants,
                                      const std::vector<SolvedScene>& scenes, Threads threads,
                                      Progress& progress) {
  std::vector<SystemDrags> all;
  for (const coordinates::SystemVariant& variant : variants)
    all.push_back({variant.system->id(), variant.system->name(), std::vector<SystemOnOrgan>(scenes.size())});
  const auto count = static_cast<Eigen::Index>(variants.size() * scenes.size());
  std::atomic<Eigen::Index> done{0};
  parallelRanges(count, 1, threads, [&](Eigen::Index index, Eigen::Index) {
    progress.throwIfCancelled();
    const auto system = static_cast<std::size_t>(index) / scenes.size();
    const auto scene = static_cast<std::size_t>(index) % scenes.size();
    Progress inner([&progress, &inner](double, const Text&) {
      if (progress.cancelled())
        inner.cancel();
    });
    all[system].organs[scene] = comparedOn(variants[system], scenes[scene], inner);
    progress.report(static_cast<double>(++done) / static_cast<double>(count), all[system].id);
  });
  return all;
}

} // namespace viscera::elasticity
