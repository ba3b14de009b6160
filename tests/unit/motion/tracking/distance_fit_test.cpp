#include <cmath>

#include <gtest/gtest.h>

#include "beating_shell.h"
#include "open_balls.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/distance_fit.h"
#include "viscera/tracking/fit_quality.h"
#include "viscera/tracking/mask_distance.h"
#include "viscera/tracking/rims.h"

namespace viscera::tracking {
namespace {

/// The shell as label maps, and what is to be brought to them.
class LabelledShell {
public:
  LabelledShell(std::size_t phases, const Vec3& spacing) : series_(tests::beatingShell(phases, 3)) {
    const Mask grid = tests::gridAround(spacing);
    for (std::size_t phase = 0; phase < phases; ++phase) {
      std::vector<Mask>& masks = masks_.emplace_back();
      for (const SurfaceSeries& one : series_)
        masks.push_back(voxelised(one.at(phase), grid));
    }
  }

  PhaseTargets targets(std::size_t phase) const {
    PhaseTargets targets{{}, Values(2)};
    for (std::size_t i = 0; i < 2; ++i) {
      targets.distances.push_back(std::make_shared<const MaskDistance>(masks_[phase][i], 12, Threads{1}));
      targets.volumesMl[static_cast<Eigen::Index>(i)] = masks_[phase][i].volumeMl();
    }
    return targets;
  }
  MotionFit fit(const MotionRig& rig, const DistanceFitOptions& options = {}, Threads threads = {}) const {
    Progress progress;
    return fitDistances(
        rig, [this](std::size_t phase) { return targets(phase); }, PhaseTimes::even(masks_.size(), 1),
        options, progress, threads);
  }
  const std::vector<SurfaceSeries>& series() const { return series_; }
  const Mask& mask(std::size_t phase, std::size_t surface) const { return masks_[phase][surface]; }

private:
  std::vector<SurfaceSeries> series_;
  std::vector<std::vector<Mask>> masks_;
};

MotionRig rigOf(const LabelledShell& shell, int handles = 60) {
  const std::vector<geometry::TriangleMesh> rest = {shell.series()[0].at(0), shell.series()[1].at(0)};
  const Points at = placeMotionHandles(rest, 0, {.handles = handles}).rest;
  Progress progress;
  return MotionRig(rest, at, 3, softnessFor(at, 8, 1.5), progress);
}

TEST(FitDistances, BringsTheShellToItsVoxels) {
  const LabelledShell shell(6, Vec3(2, 2, 2));
  const MotionRig rig = rigOf(shell);
  const MotionFit fit = shell.fit(rig);
  for (std::size_t phase = 0; phase < 6; ++phase) {
    const Values volumes = rig.volumesMl(rig.vertices(fit.poses[phase]));
    for (std::size_t i = 0; i < 2; ++i) {
      const geometry::TriangleMesh fitted{rig.vertices(fit.poses[phase], i), shell.series()[i].triangles, {}};
      EXPECT_GT(diceOf(voxelised(fitted, shell.mask(phase, i)), shell.mask(phase, i)), 0.96)
          << "phase " << phase << ", surface " << i;
      EXPECT_NEAR(volumes[static_cast<Eigen::Index>(i)] / shell.mask(phase, i).volumeMl(), 1, 1e-7);
    }
  }
}

TEST(FitDistances, TakesSurfacesOfAnyTriangles) {
  const LabelledShell shell(4, Vec3(4, 4, 4));
  const MotionRig rig = rigOf(shell);
  const geometry::TriangleMesh coarse = tests::sphere(2, 1);
  const auto targets = [&](std::size_t phase) {
    const double part = static_cast<double>(phase) / 4;
    PhaseTargets found{{}, Values(2)};
    for (const Points& points :
         {tests::outsideAt(40 * coarse.points, part), tests::cavityAt(25 * coarse.points, part)}) {
      auto mesh = std::make_shared<geometry::TriangleMesh>(coarse);
      mesh->points = points;
      found.volumesMl[static_cast<Eigen::Index>(found.distances.size())] =
          geometry::volume(mesh->points, mesh->triangles) / 1000;
      found.distances.push_back(std::make_shared<const MeshDistance>(mesh));
    }
    return found;
  };
  Progress progress;
  const MotionFit fit = fitDistances(rig, targets, PhaseTimes::even(4, 1), {}, progress);
  // Facets do not hold what slides along them, but what leaves them.
  for (std::size_t phase = 0; phase < 4; ++phase) {
    const PhaseTargets wanted = targets(phase);
    for (std::size_t i = 0; i < 2; ++i) {
      const Points fitted = rig.vertices(fit.poses[phase], i);
      double apart = 0;
      Vec3 ignored;
      for (Eigen::Index v = 0; v < fitted.rows(); ++v)
        apart += std::abs(wanted.distances[i]->at(fitted.row(v).transpose(), ignored));
      EXPECT_LT(apart / static_cast<double>(fitted.rows()), 0.6) << phase << ' ' << i;
      EXPECT_TRUE(fit.volumes[phase].met);
    }
  }
}

/// How far down the ball the opening reaches in a phase of four.
double openingAt(std::size_t phase) {
  return (0.75 + 0.1 * (1 - std::cos(0.5 * std::numbers::pi * static_cast<double>(phase))));
}

/// The change of the length of the wall from its rim to the ball's bottom in the third phase, where the
/// opening is widest: as fitted to balls of other triangles, and how far the rim is from where it should be,
/// mm.
struct GlidingWall {
  static constexpr int kRings = 14, kAround = 24;
  double lengthening = 0, rimMm = 0;

  explicit GlidingWall(bool withRims) {
    const geometry::ClosedSurface rest = tests::openBall(openingAt(0), kRings, kAround);
    const Points at = placeMotionHandles({rest.mesh}, 0, {}).rest;
    Progress progress;
    const MotionRig rig({rest.mesh}, at, 3, softnessFor(at, 8, 1.5), progress);
    DistanceFitOptions options;
    if (withRims)
      options.rims.push_back({0, {rest.rims.front().begin(), rest.rims.front().end()}});
    const auto targets = [withRims](std::size_t phase) {
      const auto ball = tests::openBall(openingAt(phase), phase == 0 ? kRings : 17, phase == 0 ? kAround : 31,
                                        phase == 0 ? 0 : 0.07);
      auto mesh = std::make_shared<const geometry::TriangleMesh>(ball.mesh);
      PhaseTargets found{{std::make_shared<const MeshDistance>(mesh)}, Values(1)};
      found.volumesMl[0] = geometry::volume(mesh->points, mesh->triangles) / 1000;
      if (withRims)
        found.rims.push_back(pointsOf(ball.rims.front(), ball.mesh.points));
      return found;
    };
    const MotionFit fit = fitDistances(rig, targets, PhaseTimes::even(4, 1), options, progress);
    const Points points = rig.vertices(fit.poses[2]);
    const auto lengthOf = [](const Points& of, int place) {
      double length = (of.row(kRings * kAround) - of.row((kRings - 1) * kAround + place)).norm();
      for (int ring = 1; ring < kRings; ++ring)
        length += (of.row(ring * kAround + place) - of.row((ring - 1) * kAround + place)).norm();
      return length;
    };
    for (int place = 0; place < kAround; ++place) {
      lengthening += (lengthOf(points, place) / lengthOf(rest.mesh.points, place) - 1) / kAround;
      const double down = std::acos(points(place, 2) / points.row(place).norm());
      rimMm += tests::kOpenBallMm * std::abs(down - openingAt(2)) / kAround;
    }
  }
};

TEST(FitDistances, KeepsTheRimOfAnOpeningOnItsRimWhereTheWallGlides) {
  const double wall = std::numbers::pi - openingAt(0), truth = (openingAt(0) - openingAt(2)) / wall;
  ASSERT_LT(truth, -0.08) << "the wall shortens by 8 %";
  const GlidingWall with(true), without(false);
  EXPECT_NEAR(with.lengthening, truth, 0.01);
  EXPECT_LT(with.rimMm, 0.45);
  EXPECT_GT(without.rimMm, 0.7) << "distances alone let it slip: else this test holds nothing";
}

TEST(FitDistances, DoesNotDependOnTheNumberOfThreads) {
  const LabelledShell shell(4, Vec3(3, 3, 8));
  const MotionRig rig = rigOf(shell, 40);
  const MotionFit one = shell.fit(rig, {}, Threads{1}), three = shell.fit(rig, {}, Threads{3});
  for (std::size_t phase = 0; phase < 4; ++phase)
    EXPECT_EQ(one.poses[phase], three.poses[phase]);
}

TEST(FitDistances, BringsAForeignRigThereFromFarAway) {
  const LabelledShell shell(4, Vec3(2, 2, 2));
  std::vector<geometry::TriangleMesh> rest = {tests::sphere(3, 33, Vec3(18, 9, -6)),
                                              tests::sphere(3, 22, Vec3(18, 9, -6))};
  const Points at = placeMotionHandles(rest, 0, {.handles = 60}).rest;
  Progress progress;
  const MotionRig rig(rest, at, 3, softnessFor(at, 8, 1.5), progress);
  DistanceFitOptions options;
  options.foreignRig = true;
  const MotionFit fit = shell.fit(rig, options);
  for (std::size_t i = 0; i < 2; ++i) {
    const geometry::TriangleMesh fitted{rig.vertices(fit.poses[0], i), rest[i].triangles, {}};
    EXPECT_GT(diceOf(voxelised(fitted, shell.mask(0, i)), shell.mask(0, i)), 0.95) << i;
  }
}

TEST(FitDistances, CanBeCancelled) {
  const LabelledShell shell(4, Vec3(4, 4, 4));
  const MotionRig rig = rigOf(shell, 40);
  Progress progress([&](double fraction, const Text&) {
    if (fraction > 0.3)
      throw std::logic_error("went on");
  });
  progress.cancel();
  EXPECT_THROW(
      fitDistances(
          rig, [&](std::size_t phase) { return shell.targets(phase); }, PhaseTimes::even(4, 1), {}, progress),
      Cancelled);
}

} // namespace
} // namespace viscera::tracking
