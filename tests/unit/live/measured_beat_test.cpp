#include <map>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "measured_beat.h"
#include "temporary_folder.h"

namespace viscera::live {
namespace {

/// Section by section what docs/patient_motion.md promises, in fewer phases than a scanner gives.
class MeasuredBeatTest : public testing::Test {
protected:
  static const tests::MeasuredBeat& truth() {
    static const tests::MeasuredBeat beat(6, sample_organs::Resolution::low);
    return beat;
  }
  static PatientMotion track(const MotionSeries& series) {
    Progress progress;
    return trackMotion(series, {}, progress);
  }
};

TEST_F(MeasuredBeatTest, ComesBackFromSurfaces) {
  const PatientMotion found = track(truth().surfaces());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.6) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 1e-3);
  for (const TrackedPhase& phase : found.phases)
    EXPECT_EQ(phase.quality.folded, 0);
}

/// Every triangle as four, the middles of its edges being new points.
tracking::SurfaceSeries denser(const tracking::SurfaceSeries& series) {
  std::map<std::pair<int, int>, int> middles;
  std::vector<std::pair<int, int>> edges;
  const auto first = static_cast<int>(series.phases.front().rows());
  const auto middle = [&](int a, int b) {
    const auto [edge, isNew] = middles.try_emplace(std::minmax(a, b), first + static_cast<int>(edges.size()));
    if (isNew)
      edges.emplace_back(a, b);
    return edge->second;
  };
  tracking::SurfaceSeries dense{series.name, Triangles(4 * series.triangles.rows(), 3), {}};
  for (Eigen::Index t = 0; t < series.triangles.rows(); ++t) {
    const auto corner = series.triangles.row(t);
    const int ab = middle(corner[0], corner[1]), bc = middle(corner[1], corner[2]),
              ca = middle(corner[2], corner[0]);
    dense.triangles.row(4 * t) << corner[0], ab, ca;
    dense.triangles.row(4 * t + 1) << ab, corner[1], bc;
    dense.triangles.row(4 * t + 2) << ca, bc, corner[2];
    dense.triangles.row(4 * t + 3) << ab, bc, ca;
  }
  for (const Points& points : series.phases) {
    Points& all = dense.phases.emplace_back(first + static_cast<Eigen::Index>(edges.size()), 3);
    all.topRows(first) = points;
    for (std::size_t i = 0; i < edges.size(); ++i)
      all.row(first + static_cast<Eigen::Index>(i)) =
          (points.row(edges[i].first) + points.row(edges[i].second)) / 2;
  }
  return dense;
}

/// A phase as a segmenter writes it: open at the top (valves), every point of its left half a second time for
/// the triangles that lie there, those of the front half with the other winding.
std::string spoiltObj(const tracking::SurfaceSeries& series, std::size_t phase, bool open) {
  const Points& first = series.phases.front();
  const Bounds box = boundsOf(first);
  const double top = box.high[2] - 0.08 * (box.high[2] - box.low[2]);
  std::ostringstream out;
  out.precision(17);
  for (int copy = 0; copy < 2; ++copy)
    for (const auto& p : series.phases[phase].rowwise())
      out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : series.triangles.rowwise()) {
    const Vec3 middle = (first.row(t[0]) + first.row(t[1]) + first.row(t[2])).transpose() / 3;
    if (open && middle[2] > top)
      continue;
    const Eigen::Index shift = 1 + (middle[0] < box.center()[0] ? first.rows() : 0);
    const bool turned = middle[1] < box.center()[1];
    out << "f " << t[0] + shift << ' ' << t[turned ? 2 : 1] + shift << ' ' << t[turned ? 1 : 2] + shift
        << '\n';
  }
  return out.str();
}

/// One rig of 120 handles for three surfaces of unlike density, open, with points twice and triangles turned.
TEST_F(MeasuredBeatTest, ComesBackFromSurfacesAsSegmentersWriteThem) {
  const tests::TemporaryFolder folder;
  for (std::size_t i = 0; i < 3; ++i) {
    const tracking::SurfaceSeries series = i == 2 ? denser(truth().truth[i]) : truth().truth[i];
    for (std::size_t phase = 0; phase < truth().times.count(); ++phase)
      folder.put(series.name + "_" + std::to_string(phase) + ".obj", spoiltObj(series, phase, i > 0));
  }
  SeriesRequest request;
  request.inputs = {folder.path()};
  request.periodSeconds = truth().times.periodSeconds;
  Progress progress;
  const MotionSeries series = readMotionSeries(request, progress);
  ASSERT_EQ(series.corresponding.size(), 3U);
  const PatientMotion found = track(series);
  EXPECT_EQ(found.sequence.track.restHandles.rows(), 120);
  for (std::size_t i = 0; i < 3; ++i) {
    double mean = 0;
    for (const TrackedPhase& phase : found.phases) {
      const tracking::SurfaceQuality& surface = phase.quality.surfaces[i];
      mean += surface.meanMm / static_cast<double>(found.phases.size());
      EXPECT_NEAR(surface.fittedMl / surface.measuredMl, 1, 1e-4);
      EXPECT_EQ(surface.flipped, 0) << series.names[i];
      EXPECT_EQ(phase.quality.folded, 0);
    }
    EXPECT_LT(mean, 1.0) << series.names[i];
    RecordProperty(series.names[i], std::to_string(mean));
  }
}

TEST_F(MeasuredBeatTest, ComesBackFromThickSlices) {
  const PatientMotion found = track(truth().voxels(Vec3(1.5, 1.5, 8)));
  double dice = 0;
  for (const TrackedPhase& phase : found.phases)
    for (std::size_t i = 0; i < phase.quality.surfaces.size(); ++i) {
      const tracking::SurfaceQuality& surface = phase.quality.surfaces[i];
      EXPECT_GT(surface.dice.value_or(0), 0.94) << truth().truth[i].name;
      EXPECT_NEAR(surface.fittedMl / surface.measuredMl, 1, 1e-4);
      dice += *surface.dice / (3.0 * static_cast<double>(found.phases.size()));
    }
  EXPECT_GT(dice, 0.96);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.8) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 0.015);
}

TEST_F(MeasuredBeatTest, ComesBackFromFineVoxels) {
  const PatientMotion found = track(truth().voxels(Vec3(1, 1, 1)));
  double dice = 0;
  for (const TrackedPhase& phase : found.phases)
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces)
      dice += *surface.dice / (3.0 * static_cast<double>(found.phases.size()));
  EXPECT_GT(dice, 0.975);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(truth().distanceTo(found, i), 0.4) << i;
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_NEAR(found.indices.at(truth().truth[i].name).ejectionFraction, truth().trueEjection(i), 0.002);
}

} // namespace
} // namespace viscera::live
