#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "sequence_scene.h"
#include "viscera/live/patient_motion.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/tracking/surface_distance.h"

/// The sample heart's own beat as simulated measurements, so that a tracked motion can be compared with the
/// truth.
namespace viscera::tests {

/// Defects of voxels as in real label maps.
struct Spoilt {
  double border = 0;      ///< Chance that a voxel at a border is another one's.
  double sliceMm = 0;     ///< One slice of every phase lies so far aside (breathing).
  bool papillary = false; ///< Muscle in the left cavity, in every second phase.
};

/// The truth: "outer", "lv" and "rv" in `phases` phases over a beat of 0.8 s.
class MeasuredBeat {
public:
  /// `unlike`: how much faster than the textbook's the beat runs at its ends, and slower in its middle, as a
  /// part of its speed.
  MeasuredBeat(std::size_t phases, sample_organs::Resolution resolution, double unlike = 0)
      : scene_([&](Progress& progress) {
          return live::setUpSequence(cachedLibrary(), "heartbeat", resolution, progress);
        }) {
    times = tracking::PhaseTimes::even(phases, kPeriod);
    for (const std::string name : {"outer", "lv", "rv"}) {
      tracking::SurfaceSeries series{name, {}, {}};
      for (const double seconds : times.seconds) {
        const double turn = 2 * std::numbers::pi;
        scene_.show(seconds + unlike * kPeriod / turn * std::sin(turn * seconds / kPeriod), 60 / kPeriod);
        geometry::TriangleMesh mesh = scene_.posed(name);
        series.triangles = mesh.triangles;
        series.phases.push_back(std::move(mesh.points));
      }
      truth.push_back(std::move(series));
    }
  }

  /// As surfaces with the same triangles in all phases.
  live::MotionSeries surfaces() const {
    live::MotionSeries series = begin();
    series.corresponding = truth;
    for (std::size_t phase = 0; phase < times.count(); ++phase)
      for (std::size_t i = 0; i < truth.size(); ++i)
        series.volumesMl[phase].push_back(trueMl(phase, i));
    return series;
  }

  /// As voxels: their centres inside.
  live::MotionSeries voxels(const Vec3& spacing, const Spoilt& spoilt = {}) const {
    live::MotionSeries series = begin();
    const tracking::Mask grid = gridAround(spacing);
    std::mt19937 random(5);
    for (std::size_t phase = 0; phase < times.count(); ++phase) {
      std::vector<tracking::Mask>& masks = series.masks.emplace_back();
      for (std::size_t i = 0; i < truth.size(); ++i) {
        tracking::Mask mask = tracking::voxelised(truth[i].at(phase), grid);
        if (spoilt.papillary && i == 1 && phase % 2 == 1)
          addPillar(mask, truth[i].phases[phase]);
        if (spoilt.sliceMm > 0)
          shiftSlice(mask, spoilt.sliceMm);
        if (spoilt.border > 0)
          roughen(mask, spoilt.border, random);
        series.volumesMl[phase].push_back(mask.volumeMl());
        masks.push_back(std::move(mask));
      }
    }
    return series;
  }

  double trueMl(std::size_t phase, std::size_t surface) const {
    return geometry::volume(truth[surface].phases[phase], truth[surface].triangles) / kMm3PerMl;
  }
  /// Of the left (1) or right (2) cavity.
  double trueEjection(std::size_t surface) const {
    double most = 0, least = 1e9;
    for (std::size_t phase = 0; phase < times.count(); ++phase) {
      most = std::max(most, trueMl(phase, surface));
      least = std::min(least, trueMl(phase, surface));
    }
    return 1 - least / most;
  }

  /// A found motion's surface where it is in a phase.
  static Points foundAt(const live::PatientMotion& found, std::size_t surface, std::size_t phase) {
    Progress progress;
    const auto& parameters = found.sequence.system->parameters.all();
    const tracking::MotionRig rig({*found.sequence.organs[surface].mesh}, found.sequence.track.restHandles,
                                  parameters.at("locality"), parameters.at("softness"), progress);
    return rig.vertices(found.sequence.track.keys[phase].pose);
  }

  /// How far each vertex of it is from the true surface, mm.
  Values apartMm(const Points& vertices, std::size_t surface, std::size_t phase) const {
    const tracking::MeshDistance distance(
        std::make_shared<const geometry::TriangleMesh>(truth[surface].at(phase)));
    Values apart(vertices.rows());
    Vec3 ignored;
    for (Eigen::Index v = 0; v < vertices.rows(); ++v)
      apart[v] = std::abs(distance.at(vertices.row(v).transpose(), ignored));
    return apart;
  }

  /// How far a found motion's surface is from the true one on average, over all phases, mm.
  double distanceTo(const live::PatientMotion& found, std::size_t surface) const {
    const auto& organ = *found.sequence.organs[surface].mesh;
    double sum = 0;
    for (std::size_t key = 0; key < found.sequence.track.keys.size(); ++key) {
      const double part = found.sequence.track.keys[key].seconds / kPeriod;
      const auto phase = static_cast<std::size_t>(std::lround(part * static_cast<double>(times.count())));
      const Points vertices = foundAt(found, surface, key);
      const Values apart = apartMm(vertices, surface, phase);
      sum += tracking::spreadOf(apart, tracking::vertexAreas(vertices, organ.triangles)).mean;
    }
    return sum / static_cast<double>(found.sequence.track.keys.size());
  }

  tracking::PhaseTimes times;
  std::vector<tracking::SurfaceSeries> truth;

private:
  static constexpr double kPeriod = 0.8;

  live::MotionSeries begin() const {
    live::MotionSeries series;
    series.names = {"outer", "lv", "rv"};
    series.times = times;
    series.volumesMl.resize(times.count());
    return series;
  }

  /// Around the outer surface in all phases, its long axis through the slices as in short-axis images.
  tracking::Mask gridAround(const Vec3& spacing) const {
    Bounds box = boundsOf(truth[0].phases[0]);
    for (const Points& points : truth[0].phases) {
      const Bounds own = boundsOf(points);
      box.low = box.low.cwiseMin(own.low);
      box.high = box.high.cwiseMax(own.high);
    }
    tracking::Mask grid;
    for (int axis = 0; axis < 3; ++axis)
      grid.size[static_cast<std::size_t>(axis)] =
          static_cast<int>(std::ceil((box.high[axis] - box.low[axis]) / spacing[axis])) + 4;
    grid.indexToLps = Eigen::Translation3d(box.low - 2 * spacing) * Eigen::Scaling(spacing);
    grid.inside.assign(std::size_t(grid.size[0]) * std::size_t(grid.size[1]) * std::size_t(grid.size[2]), 0);
    return grid;
  }

  /// Takes a rod of 4 mm radius out of a cavity, beside its middle.
  static void addPillar(tracking::Mask& mask, const Points& cavity) {
    const Bounds box = boundsOf(cavity);
    for (int k = 0; k < mask.size[2]; ++k)
      for (int j = 0; j < mask.size[1]; ++j)
        for (int i = 0; i < mask.size[0]; ++i) {
          const Vec3 at = mask.indexToLps * Vec3(i, j, k) - box.center();
          if (std::hypot(at[0] - 6, at[1] - 6) < 4 && std::abs(at[2]) < 12)
            mask.inside[mask.indexOf(i, j, k)] = 0;
        }
  }

  /// One slice in the middle.
  static void shiftSlice(tracking::Mask& mask, double mm) {
    const tracking::Mask before = mask;
    const int k = mask.size[2] / 2, by = static_cast<int>(std::lround(mm / mask.spacing()[0]));
    for (int j = 0; j < mask.size[1]; ++j)
      for (int i = 0; i < mask.size[0]; ++i)
        mask.inside[mask.indexOf(i, j, k)] = i >= by ? before.inside[before.indexOf(i - by, j, k)] : 0;
  }

  /// Voxels with another one beside them change sides by chance.
  static void roughen(tracking::Mask& mask, double chance, std::mt19937& random) {
    const tracking::Mask before = mask;
    std::uniform_real_distribution<double> any(0, 1);
    for (int k = 0; k < mask.size[2]; ++k)
      for (int j = 1; j + 1 < mask.size[1]; ++j)
        for (int i = 1; i + 1 < mask.size[0]; ++i) {
          const auto at = [&](int a, int b) { return before.inside[before.indexOf(a, b, k)]; };
          const std::uint8_t own = at(i, j);
          const bool border =
              at(i - 1, j) != own || at(i + 1, j) != own || at(i, j - 1) != own || at(i, j + 1) != own;
          if (border && any(random) < chance)
            mask.inside[mask.indexOf(i, j, k)] = 1 - own;
        }
  }

  SequenceScene scene_;
};

} // namespace viscera::tests
