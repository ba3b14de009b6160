#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "held_value.h"
#include "thick_cylinder.h"
#include "viscera/core/error.h"
#include "viscera/strain/heart_gauge.h"

namespace viscera::strain {
namespace {

constexpr int kPhases = 9;

/// A ventricle between two spheroids that narrows, shortens and twists, and is back in the end.
struct Beat {
  double narrowing = 0.3, shortening = 0.2, twist = 0.15;

  Points at(const Points& rest, int phase) const {
    const double part = std::sin(std::numbers::pi * phase / (kPhases - 1));
    Points moved(rest.rows(), 3);
    for (Eigen::Index row = 0; row < rest.rows(); ++row) {
      const Vec3 scaled((1 - narrowing * part) * rest(row, 0), (1 - narrowing * part) * rest(row, 1),
                        80 + (1 - shortening * part) * (rest(row, 2) - 80));
      const double angle = twist * part * rest(row, 2) / 80;
      moved.row(row) = (Eigen::AngleAxisd(angle, Vec3::UnitZ()) * scaled).transpose();
    }
    return moved;
  }
};

/// The surfaces of a heart in that motion, turned and shifted as a whole.
struct BeatingHeart {
  HeartSurfaces surfaces;
  HeartPhases phases;

  BeatingHeart(const Beat& beat, const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity(),
               const Vec3& shift = Vec3::Zero(), int around = 48, int along = 40) {
    const auto add = [&](const char* name, const geometry::TriangleMesh& mesh,
                         std::optional<HeartSurface>& surface, std::vector<Points>& moved) {
      const auto placed = [&](const Points& points) {
        return ((points * rotation.transpose()).rowwise() + shift.transpose()).eval();
      };
      surface = HeartSurface{name, mesh.triangles, placed(mesh.points)};
      for (int phase = 0; phase < kPhases; ++phase)
        moved.push_back(placed(beat.at(mesh.points, phase)));
    };
    add("LV", tests::ventricle(20, 80, Vec3::Zero(), around, along), surfaces.left, phases.left);
    add("EPI", tests::ventricle(30, 90, Vec3::Zero(), around, along), surfaces.outer, phases.outer);
    for (int phase = 0; phase < kPhases; ++phase)
      phases.seconds.push_back(0.1 * phase);
  }

  HeartGauge gauge(const Vec3& insertion, const std::vector<ListedContour>& listed = {}) const {
    AxisLandmarks given;
    given.insertion = insertion;
    return {surfaces, findAxes({surfaces.left->rest, surfaces.left->triangles, {}}, nullptr, given), nullptr,
            listed};
  }

  HeartStrain measured(const Vec3& insertion, const std::vector<ListedContour>& listed = {}) const {
    Progress progress;
    return gauge(insertion, listed).read(phases, progress);
  }
};

TEST(HeartStrain, OfAMotionWithoutTwistHasTheShorteningOfItsAxes) {
  const BeatingHeart beating({.narrowing = 0.3, .shortening = 0.2, .twist = 0});
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  ASSERT_EQ(strain.circumferential.size(), 3U);
  for (const ContourStrain& contour : strain.circumferential)
    EXPECT_NEAR(contour.peak.value, -0.3, 1e-9) << contour.name;
  ASSERT_EQ(strain.longitudinal.size(), 3U);
  // An arc of an ellipse of 20 by 80 that becomes one of 14 by 64.
  const auto arc = [](double a, double b) {
    double length = 0;
    for (int i = 0; i < 20000; ++i) {
      const double t = (i + 0.5) * std::numbers::pi / 40000;
      length += std::hypot(a * std::cos(t), b * std::sin(t)) * std::numbers::pi / 40000;
    }
    return length;
  };
  EXPECT_NEAR(strain.gls->peak.value, arc(14, 64) / arc(20, 80) - 1, 1e-3);
  EXPECT_EQ(strain.gls->peak.phase, 4U);
  EXPECT_NEAR(strain.gls->peak.seconds, 0.4, 1e-9);
  for (const SegmentStrain& segment : strain.segments)
    if (segment.number <= 12) {
      EXPECT_NEAR(segment.circumferential[4], -0.3, 1e-3) << segment.number;
    }
  EXPECT_NEAR(strain.dispersionLongitudinal, 0, 1e-9);
  EXPECT_NEAR(strain.twistDegrees[4], 0, 1e-9);
}

TEST(HeartStrain, TwistIsTheTurnOfTheApexSeenFromTheApexAgainstTheBase) {
  const BeatingHeart beating({.narrowing = 0.2, .shortening = 0.1, .twist = 0.2});
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  // From rings at heights of about 0.125 and 0.835 of the axis.
  EXPECT_NEAR(strain.twistDegrees[4], 0.2 * 0.71 * 180 / std::numbers::pi, 0.7);
  EXPECT_GT(strain.torsionDegreesPerCm[4], 0);
}

TEST(HeartStrain, IsTheSameAfterARotationInOtherAxesAndOnAnotherMesh) {
  const Beat beat;
  const BeatingHeart plain(beat);
  const HeartStrain before = plain.measured(Vec3(-10, -20, 40));
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.3, Vec3(2, -1, 1).normalized()).toRotationMatrix();
  const Eigen::Matrix3d ras = Vec3(-1, -1, 1).asDiagonal();
  tests::HeldValue turnedHeart("heart turned, moved, and in RAS", 1e-9);
  for (const Eigen::Matrix3d& turned : {rotation, ras}) {
    const BeatingHeart other(beat, turned, Vec3(7, 8, 9));
    const HeartStrain after = other.measured(turned * Vec3(-10, -20, 40) + Vec3(7, 8, 9));
    turnedHeart.add(after.gls->peak.value - before.gls->peak.value);
    turnedHeart.add(after.gcs->peak.value - before.gcs->peak.value);
    EXPECT_NEAR(after.twistDegrees[4], before.twistDegrees[4], 1e-6);
    for (int number = 1; number <= 16; ++number)
      turnedHeart.add(after.segment(number).longitudinal[4] - before.segment(number).longitudinal[4]);
  }
  const BeatingHeart finer(beat, Eigen::Matrix3d::Identity(), Vec3::Zero(), 71, 57);
  const HeartStrain onFiner = finer.measured(Vec3(-10, -20, 40));
  tests::HeldValue otherMesh("another mesh of the same heart", 1, "points");
  otherMesh.add(100 * (onFiner.gls->peak.value - before.gls->peak.value));
  otherMesh.add(100 * (onFiner.gcs->peak.value - before.gcs->peak.value));
  for (int number = 1; number <= 16; ++number)
    otherMesh.add(100 *
                  (onFiner.segment(number).circumferential[4] - before.segment(number).circumferential[4]));
}

TEST(HeartStrain, MeasuresTheThicknessBetweenBothSurfaces) {
  const BeatingHeart beating({.narrowing = 0, .shortening = 0, .twist = 0});
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  for (int number = 7; number <= 12; ++number)
    EXPECT_NEAR(strain.segment(number).thicknessMm[0], 9.8, 0.5) << number;
}

/// A wall that narrows as a whole becomes thinner as much as it narrows: against any phase as reference.
TEST(HeartStrain, ThickeningIsTheChangeOfTheThicknessAgainstTheReference) {
  BeatingHeart beating({.narrowing = 0.3, .shortening = 0.3, .twist = 0});
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  beating.phases.reference = 4;
  const HeartStrain fromTheMiddle = beating.measured(Vec3(-10, -20, 40));
  for (int number = 7; number <= 12; ++number) {
    EXPECT_NEAR(strain.segment(number).thickening[4], -0.3, 1e-9) << number;
    EXPECT_NEAR(fromTheMiddle.segment(number).thickening[0], 1 / 0.7 - 1, 1e-9) << number;
    EXPECT_NEAR(fromTheMiddle.segment(number).thickening[4], 0, 1e-12) << number;
  }
}

/// What becomes smaller by three tenths in each direction has 0.49 of its area.
TEST(HeartStrain, AreaStrainIsTheChangeOfTheAreaOfEachSegmentAndSurface) {
  const HeartStrain strain =
      BeatingHeart({.narrowing = 0.3, .shortening = 0.3, .twist = 0}).measured(Vec3(-10, -20, 40));
  tests::HeldValue areas("area strain of all segments and surfaces of a heart that becomes smaller", 1e-9);
  for (int number = 1; number <= 16; ++number)
    areas.add(strain.segment(number).area[4] - (0.49 - 1));
  ASSERT_EQ(strain.areas.size(), 2U);
  for (const ContourStrain& surface : strain.areas)
    areas.add(surface.curve[4] - (0.49 - 1));
}

/// A reader that has closed a surface knows its caps.
TEST(HeartStrain, TakesCapsThatAreKnown) {
  BeatingHeart beating({.narrowing = 0.2, .shortening = 0.1, .twist = 0.1});
  const HeartGauge gauge = beating.gauge(Vec3(-10, -20, 40));
  Progress progress;
  const HeartStrain found = gauge.read(beating.phases, progress);
  beating.surfaces.outer->caps = gauge.surfaces().outer->caps;
  const HeartStrain known = beating.measured(Vec3(-10, -20, 40));
  EXPECT_EQ(known.areas.back().curve, found.areas.back().curve);
  EXPECT_EQ(known.segment(8).thicknessMm, found.segment(8).thicknessMm);
  beating.surfaces.outer->caps.assign(gauge.surfaces().outer->caps.size(), false);
  EXPECT_GT(beating.measured(Vec3(-10, -20, 40)).areas.back().referenceMm, found.areas.back().referenceMm)
      << "the fan at its base counts as wall";
}

/// A phase at rest takes what is known of the heart at rest: the same as if it had been measured.
TEST(HeartStrain, OfAPhaseAtRestIsThatOfTheHeartAtRest) {
  BeatingHeart beating({.narrowing = 0.2, .shortening = 0.1, .twist = 0.1});
  beating.surfaces.left->rest = beating.phases.left[0]; // The same up to rounding before.
  beating.surfaces.outer->rest = beating.phases.outer[0];
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  for (Points* surface : {&beating.phases.left[0], &beating.phases.outer[0]})
    surface->array() += 1e-9; // Not at rest any longer.
  const HeartStrain moved = beating.measured(Vec3(-10, -20, 40));
  for (int number = 1; number <= 16; ++number)
    for (const std::size_t phase : {0U, 4U})
      EXPECT_NEAR(strain.segment(number).thicknessMm[phase], moved.segment(number).thicknessMm[phase], 1e-6)
          << number << " in " << phase;
}

TEST(HeartStrain, TakesListsOfVerticesInThePlaceOfContoursThatAreFound) {
  const BeatingHeart beating({.narrowing = 0.25, .shortening = 0, .twist = 0});
  ListedContour ring{"base", "LV", {}, true};
  for (std::int32_t i = 0; i < 48; ++i)
    ring.vertices.push_back(48 * 6 + i);
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40), {ring});
  const ContourStrain& base = strain.circumferential.front();
  EXPECT_EQ(base.name, "base");
  EXPECT_NEAR(base.peak.value, -0.25, 1e-9);
  const Points ringPoints = MaterialContour::through(ring.vertices, true).at(beating.surfaces.left->rest);
  EXPECT_NEAR(base.referenceMm, 48 * (ringPoints.row(1) - ringPoints.row(0)).norm(), 1e-6);
  ring.vertices.push_back(100000);
  EXPECT_THROW(beating.measured(Vec3(-10, -20, 40), {ring}), DataError);
  ring.surface = "liver";
  EXPECT_THROW(beating.measured(Vec3(-10, -20, 40), {ring}), DataError);
}

TEST(HeartStrain, IsMeasuredFromThePhaseThatIsChosen) {
  BeatingHeart beating({.narrowing = 0.3, .shortening = 0.2, .twist = 0});
  beating.phases.reference = 4;
  const HeartStrain strain = beating.measured(Vec3(-10, -20, 40));
  EXPECT_NEAR(strain.gcs->curve[4], 0, 1e-12);
  EXPECT_NEAR(strain.gcs->curve[0], 1 / 0.7 - 1, 1e-9);
  beating.phases.reference = kPhases;
  EXPECT_THROW(beating.measured(Vec3(-10, -20, 40)), DataError);
}

/// A wall whose material is known: the strain of its points is that of the cylinder's closed form, whatever
/// phase is the reference.
TEST(HeartStrain, OfAWallIsTheMeanOverItsPoints) {
  const tests::ThickCylinder tube;
  const deformation::WitnessMesh mesh = tests::tubeWall(tube, 36, 6, 24);
  const geometry::TriangleMesh inner = tests::closedTube(tube.inner, 0, tube.length, 36, 24);
  const geometry::TriangleMesh outer = tests::closedTube(tube.outer, 0, tube.length, 36, 24);
  const tests::CylinderMotion systole{tube, 14, 0.85, 0.003};
  AxisLandmarks given;
  given.base = Vec3::Zero();
  given.apex = Vec3(0, 0, tube.length);
  given.insertion = Vec3(20, 0, 10);
  const FoundAxes axes = findAxes(inner, nullptr, given);
  Progress progress;
  const auto wall = std::make_shared<const WallPoints>(
      wallPoints(mesh, {&inner, &outer, nullptr}, axes.axes, axes.cap, progress));
  const WallPoints& points = *wall;
  HeartPhases phases;
  phases.left = {inner.points, systole(inner.points)};
  phases.seconds = {0, 0.3};
  phases.gradientsAt = [&](std::size_t phase, std::vector<Eigen::Matrix3d>& gradients, Threads) {
    gradients.assign(points.rows.size(), Eigen::Matrix3d::Identity());
    for (std::size_t i = 0; phase == 1 && i < gradients.size(); ++i)
      gradients[i] = systole.gradientAt(mesh.points.row(points.rows[i]).transpose());
  };
  const HeartGauge gauge({.left = HeartSurface{"LV", inner.triangles, inner.points}}, axes, wall, {});
  const HeartStrain strain = gauge.read(phases, progress);
  double radial = 0, around = 0, volume = 0;
  for (Eigen::Index i = 0; i < points.count(); ++i) {
    const Vec3 place = mesh.points.row(points.rows[static_cast<std::size_t>(i)]);
    const double radius = std::hypot(place.x(), place.y());
    radial += points.volumes[i] * engineering(systole.radialStrain(radius));
    around += points.volumes[i] * engineering(systole.aroundStrain(radius));
    volume += points.volumes[i];
  }
  EXPECT_NEAR(strain.grs->peak.value, radial / volume, 1e-3);
  EXPECT_NEAR(strain.materialCircumferential->peak.value, around / volume, 1e-3);
  for (int number = 1; number <= 16; ++number) {
    EXPECT_TRUE(strain.segment(number).enough) << number;
    EXPECT_NEAR(strain.segment(number).radial[1], radial / volume, 0.01) << number;
  }
  EXPECT_FALSE(strain.segment(17).enough) << "a tube has no cap";
  phases.reference = 1;
  const HeartStrain fromSystole = gauge.read(phases, progress);
  EXPECT_NEAR(fromSystole.grs->curve[1], 0, 1e-9);
  EXPECT_LT(fromSystole.grs->curve[0], -0.2) << "the wall becomes thinner again";
}

} // namespace
} // namespace viscera::strain
