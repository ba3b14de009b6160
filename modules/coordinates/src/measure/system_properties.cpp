#include "viscera/coordinates/measure/system_properties.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>

#include "viscera/coordinates/cage/cage.h"
#include "viscera/core/error.h"
#include "viscera/core/inner_job.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Part of the handles' size: so far from a handle its coordinates are taken that do not exist at it.
constexpr double kBeside = 1e-7;
/// A binding is timed again until that much time has gone by.
constexpr double kTimedSeconds = 0.02;
constexpr int kMostTimed = 25;
/// The change that counts for a coordinate that exists only before or only after a rotation.
constexpr double kGone = 1;

Points pointsOf(const Scene& scene) {
  if (!scene.line)
    return scene.points;
  Points points(scene.parts + 1, 3);
  for (int i = 0; i <= scene.parts; ++i)
    points.row(i) = scene.line->at(static_cast<double>(i) / scene.parts).transpose();
  return points;
}

/// A turn about a skew axis through `center`.
Points turned(const Points& points, const Vec3& center) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.9, Vec3(1, 2, -3).normalized()).toRotationMatrix();
  return ((points.rowwise() - center.transpose()) * turn.transpose()).rowwise() + center.transpose();
}

class Meter {
public:
  Meter(const CoordinateSystem& system, const Scene& scene, const BindOptions& options, Progress& progress)
      : system_(system), scene_(scene), options_(options), progress_(progress), points_(pointsOf(scene)),
        size_(boundsOf(scene.handles.positions).diagonal()) {}

  void measure(SceneProperties& found) {
    measureBinding(found);
    if (scene_.line)
      measureLine(found);
    measureTurn(found);
    measureHandles(found);
  }

private:
  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points) const {
    progress_.throwIfCancelled();
    return system_.bind(handles, points, options_, progress_);
  }

  /// The first binding's coordinates are what a turn is compared with.
  void measureBinding(SceneProperties& found) {
    double least = INFINITY, spent = 0;
    std::unique_ptr<Binding> binding;
    for (int round = 0; round < kMostTimed && spent < kTimedSeconds; ++round) {
      const auto start = std::chrono::steady_clock::now();
      binding = bind(scene_.handles, points_);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      least = std::min(least, seconds);
      spent += seconds;
    }
    const BindingReport& report = binding->report();
    found.identityError = report.identityError / size_;
    found.unityError = report.unityError;
    found.minWeight = report.minWeight;
    found.failures = static_cast<Eigen::Index>(report.failures.size());
    found.notes = inEnglish(report.notes);
    found.nanoseconds =
        1e9 * least / (static_cast<double>(points_.rows()) * static_cast<double>(found.handles));
    coordinates_ = coordinatesOf(*binding);
  }

  void measureLine(SceneProperties& found) {
    const LineProperties line =
        measureAlong(system_, scene_.handles, *scene_.line, scene_.parts, options_, progress_);
    found.jump = line.largestJump;
    found.maxima = line.localMaxima;
    if (line.largestJump == 0) {
      found.kinks = line.kinks;
      found.largestKink = line.largestKink;
    }
  }

  void measureTurn(SceneProperties& found) {
    HandleSet handles = scene_.handles;
    // Four handles in one face of the hull: rounding decides on its diagonal, in each position anew.
    if (system_.traits().needsCage)
      handles.cage = cageOf(handles);
    const Vec3 center = boundsOf(handles.positions).center();
    handles.positions = turned(handles.positions, center);
    const Eigen::MatrixXd after = coordinatesOf(*bind(handles, turned(points_, center)));
    for (Eigen::Index point = 0; point < points_.rows(); ++point) {
      const bool here = coordinates_.row(point).allFinite(), there = after.row(point).allFinite();
      if (here && there)
        found.rotationChange = std::max(found.rotationChange,
                                        (after.row(point) - coordinates_.row(point)).cwiseAbs().maxCoeff());
      else if (here != there)
        found.rotationChange = std::max(found.rotationChange, kGone);
    }
  }

  void measureHandles(SceneProperties& found) {
    const Points& positions = scene_.handles.positions;
    Eigen::MatrixXd at = coordinatesOf(*bind(scene_.handles, positions));
    if (!at.allFinite()) {
      const Eigen::RowVector3d middle = positions.colwise().mean();
      const Points inward = (-positions).rowwise() + middle;
      const Eigen::MatrixXd beside =
          coordinatesOf(*bind(scene_.handles, positions + kBeside * size_ * inward.rowwise().normalized()));
      for (Eigen::Index handle = 0; handle < positions.rows(); ++handle)
        if (!at.row(handle).allFinite())
          at.row(handle) = beside.row(handle);
    }
    for (Eigen::Index handle = 0; handle < positions.rows(); ++handle) {
      if (!at.row(handle).allFinite()) {
        ++found.handleGaps;
        continue;
      }
      at(handle, handle) -= 1;
      found.handleError = std::max(found.handleError, at.row(handle).cwiseAbs().maxCoeff());
    }
  }

  const CoordinateSystem& system_;
  const Scene& scene_;
  const BindOptions& options_;
  Progress& progress_;
  Points points_;
  double size_;
  Eigen::MatrixXd coordinates_;
};

/// One system on one scene, and where the answer goes.
struct Task {
  std::size_t variant;
  std::size_t slot;
  const Scene* scene;
};

std::vector<const Scene*> scenesFor(const Traits& traits, const std::vector<Scene>& scenes) {
  std::vector<const Scene*> chosen;
  bool lineTaken = false;
  for (const Scene& scene : scenes) {
    if (!traits.needsTetrahedra || !scene.line || !lineTaken)
      chosen.push_back(&scene);
    lineTaken = lineTaken || scene.line;
  }
  return chosen;
}

template <class Number>
void keepGreater(std::optional<Number>& worst, const std::optional<Number>& other) {
  if (other && (!worst || *other > *worst))
    worst = other;
}

} // namespace

SceneProperties measureOn(const CoordinateSystem& system, const Scene& scene, const BindOptions& options,
                          Progress& progress) {
  SceneProperties found;
  found.scene = scene.name;
  found.handles = scene.handles.positions.rows();
  found.points = scene.line ? scene.parts + 1 : scene.points.rows();
  try {
    Meter(system, scene, options, progress).measure(found);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    found.refusal = explanationOf(error).english();
  } catch (...) {
    found.refusal = "an error of unknown kind";
  }
  return found;
}

std::vector<SystemProperties> measureSystems(const std::vector<SystemVariant>& variants,
                                             const std::vector<Scene>& scenes, Threads threads,
                                             const Tetrahedraliser& tetrahedralise, Progress& progress) {
  std::vector<SystemProperties> all;
  std::vector<Task> tasks;
  for (const SystemVariant& variant : variants) {
    all.push_back({variant.system->id(), variant.system->name(), {}});
    for (const Scene* scene : scenesFor(variant.system->traits(), scenes)) {
      tasks.push_back({all.size() - 1, all.back().scenes.size(), scene});
      all.back().scenes.emplace_back();
    }
  }
  std::atomic<std::size_t> done{0};
  parallelRanges(static_cast<Eigen::Index>(tasks.size()), 1, threads, [&](Eigen::Index index, Eigen::Index) {
    progress.throwIfCancelled();
    const Task& task = tasks[static_cast<std::size_t>(index)];
    const SystemVariant& variant = variants[task.variant];
    InnerJob part(progress);
    const BindOptions options{variant.parameters, Threads{1}, tetrahedralise};
    progress.report(static_cast<double>(done) / static_cast<double>(tasks.size()), all[task.variant].id);
    all[task.variant].scenes[task.slot] = measureOn(*variant.system, *task.scene, options, part.progress());
    progress.report(static_cast<double>(++done) / static_cast<double>(tasks.size()));
  });
  return all;
}

SceneProperties SystemProperties::worst() const {
  SceneProperties worst;
  worst.scene = "worst";
  worst.minWeight = INFINITY;
  for (const SceneProperties& scene : scenes) {
    if (!scene.refusal.empty())
      continue;
    worst.handles = std::max(worst.handles, scene.handles);
    worst.points += scene.points;
    worst.identityError = std::max(worst.identityError, scene.identityError);
    worst.unityError = std::max(worst.unityError, scene.unityError);
    worst.minWeight = std::min(worst.minWeight, scene.minWeight);
    worst.failures += scene.failures;
    keepGreater(worst.jump, scene.jump);
    keepGreater(worst.kinks, scene.kinks);
    keepGreater(worst.maxima, scene.maxima);
    worst.largestKink = std::max(worst.largestKink, scene.largestKink);
    worst.rotationChange = std::max(worst.rotationChange, scene.rotationChange);
    worst.handleError = std::max(worst.handleError, scene.handleError);
    worst.handleGaps += scene.handleGaps;
    worst.nanoseconds = std::max(worst.nanoseconds, scene.nanoseconds);
  }
  if (!std::isfinite(worst.minWeight))
    worst.minWeight = 0;
  return worst;
}

Eigen::Index SystemProperties::refusals() const {
  return std::count_if(scenes.begin(), scenes.end(),
                       [](const SceneProperties& scene) { return !scene.refusal.empty(); });
}

} // namespace viscera::coordinates
