#include "series_checks.h"

#include <algorithm>
#include <cmath>

#include "phase_name.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/signed_distance.h"

namespace viscera::live {
namespace {

constexpr std::size_t kFewestPhases = 4;
constexpr double kMostJump = 0.5;
constexpr double kMostOutside = 0.25, kOutsideMm = 5;
constexpr double kMostReturn = 2; ///< In the largest step between neighbours.
/// The area of a ball with volume 1: no surface around a volume has less.
constexpr double kBallArea = 4.836;

double apart(const tracking::Mask& a, const tracking::Mask& b) {
  std::int64_t differ = 0;
  for (std::size_t v = 0; v < a.inside.size(); ++v)
    differ += a.inside[v] != b.inside[v];
  // The volume between two outlines over the area around one, (36 pi)^1/3 V^2/3 of a ball: about how far they
  // lie apart, and rather more where they are no balls.
  const double voxel = std::abs(a.indexToLps.linear().determinant());
  const double volume = voxel * static_cast<double>(std::max(a.count(), b.count()));
  return static_cast<double>(differ) * voxel / (kBallArea * std::pow(volume, 2.0 / 3));
}

/// The middle of a surface in a phase.
Vec3 middleOf(const MotionSeries& series, std::size_t phase, std::size_t surface, double& size) {
  Bounds box;
  if (!series.corresponding.empty()) {
    box = boundsOf(series.corresponding[surface].phases[phase]);
  } else {
    box = boundsOf(series.meshes[phase][surface]->points);
  }
  size = box.diagonal();
  return box.center();
}

/// Whether `there` is where `here` would be in the other axes, and far from it.
bool turned(const Vec3& here, const Vec3& there, double size) {
  const Vec3 back(-there.x(), -there.y(), there.z());
  return (there - here).norm() > 0.75 * size && (back - here).norm() < 0.5 * size;
}

[[noreturn]] void refuseSpace(const Text& which, const Text& other) {
  throw DataError(
      phrase("It seems to be in RAS where %1 is in LPS, or the other way round: it lies on the opposite "
             "side of the patient's middle",
             other),
      which, "export all surfaces of a patient in the same axes");
}

} // namespace

double apartMm(const MotionSeries& series, std::size_t a, std::size_t b) {
  double sum = 0;
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    if (!series.corresponding.empty()) {
      const auto& phases = series.corresponding[i].phases;
      sum += (phases[a] - phases[b]).rowwise().norm().mean();
    } else if (!series.masks.empty()) {
      sum += apart(series.masks[a][i], series.masks[b][i]);
    } else {
      const geometry::SignedDistance distance(series.meshes[b][i]);
      const Points& points = series.meshes[a][i]->points;
      double all = 0;
      for (Eigen::Index v = 0; v < points.rows(); ++v)
        all += std::abs(distance(points.row(v).transpose()));
      sum += all / static_cast<double>(points.rows());
    }
  }
  return sum / static_cast<double>(series.names.size());
}

void requirePhases(std::size_t count) {
  if (count < kFewestPhases)
    throw DataError(phrase("It has %n {phase|phases}; a motion needs four at least", count), "series",
                    count == 1
                        ? "name all phases of the cycle; a single image of a heart with cavities can "
                          "beat as the textbook's (--textbook, in the window Fit a sequence to an organ)"
                        : "name all phases of the cycle");
}

void requireSteadyVolumes(const MotionSeries& series) {
  const std::size_t count = series.volumesMl.size();
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    double largest = 0;
    for (std::size_t phase = 0; phase < count; ++phase) {
      if (!(series.volumesMl[phase][i] > 0))
        throw DataError(phrase("%1 has no volume in %2", series.names[i], phaseName(phase)), "series",
                        "check this phase, or leave it out");
      largest = std::max(largest, series.volumesMl[phase][i]);
    }
    for (std::size_t phase = 0; phase < count; ++phase) {
      const std::size_t next = (phase + 1) % count;
      if (next == 0 && !series.times.loop)
        break;
      const double here = series.volumesMl[phase][i], there = series.volumesMl[next][i];
      if (std::abs(here - there) > kMostJump * largest)
        throw DataError(phrase("The volume of %1 jumps from %2 to %3 ml between %4 and %5", series.names[i],
                               inFixed(here, 1), inFixed(there, 1), phaseName(phase), phaseName(next)),
                        "series", "check whether one of them is mislabelled, or leave it out");
    }
  }
}

void requireCavitiesInside(const MotionSeries& series) {
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    if (i == series.outer)
      continue;
    double outside = 0;
    if (!series.masks.empty()) {
      const tracking::Mask& cavity = series.masks[0][i];
      const tracking::Mask& outer = series.masks[0][series.outer];
      const Eigen::Affine3d between = outer.indexToLps.inverse() * cavity.indexToLps;
      std::int64_t out = 0;
      std::size_t voxel = 0;
      for (int c = 0; c < cavity.size[2]; ++c)
        for (int b = 0; b < cavity.size[1]; ++b)
          for (int a = 0; a < cavity.size[0]; ++a, ++voxel) {
            if (cavity.inside[voxel] == 0)
              continue;
            const Vec3 at = between * Vec3(a, b, c);
            const int x = static_cast<int>(std::lround(at[0])), y = static_cast<int>(std::lround(at[1])),
                      z = static_cast<int>(std::lround(at[2]));
            const bool within =
                x >= 0 && y >= 0 && z >= 0 && x < outer.size[0] && y < outer.size[1] && z < outer.size[2];
            out += !within || outer.inside[outer.indexOf(x, y, z)] == 0;
          }
      outside = static_cast<double>(out) / static_cast<double>(std::max<std::int64_t>(cavity.count(), 1));
    } else if (!series.corresponding.empty()) {
      outside = tracking::partOutside(
          series.corresponding[i].at(0),
          std::make_shared<const geometry::TriangleMesh>(series.corresponding[series.outer].at(0)),
          kOutsideMm);
    } else {
      outside = tracking::partOutside(*series.meshes[0][i], series.meshes[0][series.outer], kOutsideMm);
    }
    if (outside > kMostOutside)
      throw DataError(phrase("The cavity %1 is not inside the outer surface %2: %3 % of it lie outside",
                             series.names[i], series.names[series.outer], inFixed(100 * outside, 0)),
                      "series",
                      series.masks.empty() ? "track surfaces that are not within each other one by one"
                                           : "give the outer surface the labels of its cavities too, as in "
                                             "EPI=1,2,3");
  }
}

void requireOneSpace(const MotionSeries& series) {
  if (!series.masks.empty())
    return; // Grids are compared.
  for (std::size_t phase = 0; phase < series.phases(); ++phase)
    for (std::size_t i = 0; i < series.names.size(); ++i) {
      double size = 0, ignored = 0;
      const Vec3 first = middleOf(series, 0, i, size);
      if (turned(first, middleOf(series, phase, i, ignored), size))
        refuseSpace(phrase("%1, %2", named(series.names[i]), phaseName(phase)), "the first phase");
      const Vec3 outer = middleOf(series, phase, series.outer, size);
      if (turned(outer, middleOf(series, phase, i, ignored), size))
        refuseSpace(phrase("%1, %2", named(series.names[i]), phaseName(phase)),
                    named(series.names[series.outer]));
    }
}

void requireClosedLoop(const MotionSeries& series) {
  if (!series.times.loop)
    return;
  const std::size_t last = series.phases() - 1;
  double largest = 0;
  for (std::size_t phase = 0; phase < last; ++phase)
    largest = std::max(largest, apartMm(series, phase, phase + 1));
  const double back = apartMm(series, last, 0);
  // A longer way back in time may be longer in space.
  const double gap = series.times.periodSeconds - series.times.seconds[last] + series.times.seconds[0];
  const double step = (series.times.seconds[last] - series.times.seconds[0]) / static_cast<double>(last);
  if (back > kMostReturn * std::max(1.0, gap / step) * largest)
    throw DataError(
        phrase("The last phase does not lead back to the first: they lie %1 mm apart on average, neighbours "
               "%2 mm "
               "at most",
               inFixed(back, 1), inFixed(largest, 1)),
        "series",
        "if it is not a whole cycle, say that it is to be played once (--once); else add the phases "
        "that are missing");
}

} // namespace viscera::live
