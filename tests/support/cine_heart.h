#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>

#include "measured_beat.h"
#include "smooth_error.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/cine_motion.h"

/// The sample heart's beat as a cine study: slices with gaps, each in a breath-hold of its own, noise, and
/// texture that moves with the tissue; two of its phases are labelled.
namespace viscera::tests {

/// What is wrong with images and labels.
struct CineHeartFaults {
  double noise = 10;     ///< Deviation of Rician noise; blood has 300, muscle 100.
  double breathMm = 3;   ///< How far each plane's content lies aside, in its plane.
  double labelMm = 0;    ///< Root mean square of a smooth error of the labels.
  int missingSlice = -1; ///< A short-axis slice that is not there.
  int shiftedSlice = -1; ///< One whose content lies 5 mm further aside.
  bool longAxis = true;  ///< Whether there are long-axis planes.
  int systoleOff = 0;    ///< How many phases beside the end of systole is labelled as such.
  bool systole = true;   ///< Whether it is labelled at all.
  double pixelMm = 1.6;
};

/// The study of a measured beat.
class CineHeart {
public:
  explicit CineHeart(const MeasuredBeat& beat) : beat_(beat) {
    const Points& cavity = beat.truth[1].phases[0];
    const Points centred = cavity.rowwise() - cavity.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(Eigen::Matrix3d(centred.transpose() * centred));
    axis_ = axes.eigenvectors().col(2);
    across_ = axes.eigenvectors().col(1);
    middle_ = cavity.colwise().mean().transpose();
    for (std::size_t phase = 1; phase < beat.times.count(); ++phase) {
      if (beat.trueMl(phase, 1) < beat.trueMl(systole_, 1))
        systole_ = phase;
      if (beat.trueMl(phase, 1) > beat.trueMl(diastole_, 1))
        diastole_ = phase;
    }
  }

  /// The phases with the emptiest and the fullest left ventricle.
  std::size_t systole() const { return systole_; }
  std::size_t diastole() const { return diastole_; }

  live::LabelledStudy study(const CineHeartFaults& faults = {}) const {
    live::LabelledStudy study;
    study.times = beat_.times;
    study.labels.names = {"outer", "lv", "rv"};
    study.caps.resize(3);
    study.phases = {diastole_};
    if (faults.systole)
      study.phases.push_back(systole_ + static_cast<std::size_t>(faults.systoleOff));
    std::sort(study.phases.begin(), study.phases.end());
    study.labels.times = tracking::PhaseTimes::even(study.phases.size(), beat_.times.periodSeconds);
    for (const std::size_t phase : study.phases)
      addLabels(phase, faults, study.labels);
    std::mt19937 random(11);
    const Vec3 third = axis_.cross(across_);
    for (int slice = 0; slice < kSlices; ++slice)
      if (slice != faults.missingSlice)
        addPlane("short " + std::to_string(slice + 1),
                 middle_ + kApartMm * (slice - 0.5 * (kSlices - 1)) * axis_, across_, third, faults,
                 slice == faults.shiftedSlice ? 5 : 0, random, study);
    for (int view = 0; view < 3 && faults.longAxis; ++view) {
      const double turn = std::numbers::pi / 3 * view;
      addPlane("long " + std::to_string(view + 1), middle_, std::cos(turn) * across_ + std::sin(turn) * third,
               axis_, faults, 0, random, study);
    }
    return study;
  }

private:
  static constexpr int kSlices = 6, kMarkers = 500;
  static constexpr double kApartMm = 16, kSideMm = 153.6, kReachMm = 8;

  void addLabels(std::size_t phase, const CineHeartFaults& faults, live::MotionSeries& labels) const {
    auto& meshes = labels.meshes.emplace_back();
    auto& volumes = labels.volumesMl.emplace_back();
    for (const tracking::SurfaceSeries& surface : beat_.truth) {
      geometry::TriangleMesh mesh = surface.at(phase);
      if (faults.labelMm > 0)
        mesh.points += smoothError(mesh.points, faults.labelMm, 3 + static_cast<unsigned>(phase));
      volumes.push_back(geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl);
      meshes.push_back(std::make_shared<const geometry::TriangleMesh>(std::move(mesh)));
    }
  }

  /// Where tissue at a point was in the first phase: as the vertices around it, of which some suffice.
  Vec3 restOf(const Vec3& point, std::size_t phase) const {
    Vec3 moved = Vec3::Zero();
    double weights = 1e-6;
    for (const tracking::SurfaceSeries& surface : beat_.truth) {
      const Points& now = surface.phases[phase];
      for (Eigen::Index v = 0; v < now.rows(); v += 1 + now.rows() / kMarkers) {
        const double apart = (now.row(v).transpose() - point).squaredNorm();
        if (apart > 9 * kReachMm * kReachMm)
          continue;
        const double weight = std::exp(-0.5 * apart / (kReachMm * kReachMm));
        weights += weight;
        moved += weight * (surface.phases[0].row(v) - now.row(v)).transpose();
      }
    }
    return point + moved / weights;
  }
  static double texture(const Vec3& rest) {
    return std::sin(0.45 * rest[0] + 0.2 * rest[1]) + std::sin(0.4 * rest[1] - 0.3 * rest[2] + 1) +
           std::sin(0.5 * rest[2] + 0.25 * rest[0] + 2);
  }

  static int pixelsOf(double pixelMm) { return static_cast<int>(std::lround(kSideMm / pixelMm)); }

  /// A grid of one layer in the plane.
  static tracking::Mask gridOf(const tracking::CinePlane& plane, const Vec3& aside) {
    tracking::Mask grid;
    const int pixels = pixelsOf(plane.spacing[0]);
    grid.size = {pixels, pixels, 1};
    Eigen::Matrix3d axes;
    axes << plane.alongRow, plane.alongColumn, plane.normal();
    grid.indexToLps = Eigen::Translation3d(plane.origin - aside) * Eigen::Affine3d(axes * plane.spacing[0]);
    grid.inside.assign(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), 0);
    return grid;
  }

  void addPlane(const std::string& name, const Vec3& middle, const Vec3& alongRow, const Vec3& alongColumn,
                const CineHeartFaults& faults, double furtherMm, std::mt19937& random,
                live::LabelledStudy& study) const {
    const int pixels = pixelsOf(faults.pixelMm);
    tracking::CinePlane plane{name, middle, alongRow, alongColumn, {faults.pixelMm, faults.pixelMm}, {}, {}};
    plane.origin -= 0.5 * (pixels - 1) * faults.pixelMm * (alongRow + alongColumn);
    std::uniform_real_distribution<double> any(0, 2 * std::numbers::pi);
    std::normal_distribution<double> noise(0, faults.noise);
    const double way = any(random);
    const Vec3 aside =
        (faults.breathMm + furtherMm) * (std::cos(way) * alongRow + std::sin(way) * alongColumn);
    const tracking::Mask grid = gridOf(plane, aside);
    for (std::size_t phase = 0; phase < beat_.times.count(); ++phase) {
      std::array<tracking::Mask, 3> inside = {grid, grid, grid};
      for (std::size_t i = 0; i < 3; ++i)
        inside[i] = tracking::voxelised(beat_.truth[i].at(phase), grid);
      tracking::CineImage& image = plane.images.emplace_back(pixels, pixels);
      plane.fractions.push_back(beat_.times.seconds[phase] / beat_.times.periodSeconds);
      for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column) {
          const std::size_t at = grid.indexOf(column, row, 0);
          const double grey = inside[1].inside[at] || inside[2].inside[at] ? 300
                              : inside[0].inside[at]                       ? 100
                                                                           : 180;
          const Vec3 rest = restOf(grid.indexToLps * Vec3(column, row, 0), phase);
          // Rice's distribution: the length of a complex number with noise in both parts.
          const double real = grey + 15 * texture(rest) + noise(random);
          image(row, column) = static_cast<float>(std::hypot(real, noise(random)));
        }
    }
    study.sources.push_back(
        {study.planes.size(), static_cast<int>(study.planes.size()) + 1, name, medical_io::CinePlane::other});
    study.planes.push_back(std::move(plane));
  }

  const MeasuredBeat& beat_;
  Vec3 axis_, across_, middle_;
  std::size_t systole_ = 0, diastole_ = 0;
};

} // namespace viscera::tests
