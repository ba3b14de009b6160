#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "cine_phantom.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/contour_corrections.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::live {
namespace {

using tests::CinePhantom;

/// The phantom with labels in some of its phases.
LabelledStudy phantomStudy(const std::vector<std::size_t>& phases, const std::string& cavity = "LV",
                           const tests::CineFaults& faults = {}) {
  LabelledStudy study;
  study.labels.names = {"EPI", cavity};
  study.labels.outer = 0;
  study.phases = phases;
  study.times = tracking::PhaseTimes::even(CinePhantom::kPhases, 0.8);
  study.labels.times = tracking::PhaseTimes::even(phases.size(), 0.8);
  study.caps.resize(2);
  for (const std::size_t phase : phases) {
    auto& meshes = study.labels.meshes.emplace_back();
    auto& volumes = study.labels.volumesMl.emplace_back();
    for (std::size_t which = 0; which < 2; ++which) {
      meshes.push_back(std::make_shared<const geometry::TriangleMesh>(CinePhantom::surface(which, phase)));
      volumes.push_back(CinePhantom::volumeMl(which, phase));
    }
  }
  study.planes = CinePhantom::planes(faults);
  for (std::size_t plane = 0; plane < study.planes.size(); ++plane)
    study.sources.push_back(
        {plane, static_cast<int>(plane) + 1, study.planes[plane].name, medical_io::CinePlane::other});
  return study;
}

TrackOptions fewHandles() {
  TrackOptions options;
  options.rig.handles = 60;
  options.witnesses = 500;
  return options;
}

/// What is said of a phase or of the whole.
bool says(const CineMotion& found, const std::string& words) {
  for (const CineFinding& finding : found.findings)
    if (finding.text.english().find(words) != std::string::npos)
      return true;
  return false;
}

TEST(CineMotion, HasTheVolumesOfItsLabelsAndThoseOfTheImagesBetween) {
  Progress progress;
  const CineMotion found = trackCine(phantomStudy({0, CinePhantom::kSystole}), fewHandles(), progress);
  EXPECT_FALSE(found.estimate);
  EXPECT_EQ(found.motion.sequence.track.keys.size(), CinePhantom::kPhases);
  ASSERT_EQ(found.motion.phases.size(), CinePhantom::kPhases);
  const double full = CinePhantom::volumeMl(1, 0), empty = CinePhantom::volumeMl(1, CinePhantom::kSystole);
  EXPECT_NEAR(found.motion.indices.at("LV").ejectionFraction, (full - empty) / full, 1e-7);
  EXPECT_EQ(found.motion.indices.count("EPI"), 0U);
  for (std::size_t phase = 0; phase < CinePhantom::kPhases; ++phase) {
    const tracking::SurfaceQuality& cavity = found.motion.phases[phase].quality.surfaces[1];
    EXPECT_NEAR(cavity.fittedMl, CinePhantom::volumeMl(1, phase), 0.05 * full) << phase;
    EXPECT_EQ(found.motion.phases[phase].verdict.light, tracking::FitLight::good) << phase;
    EXPECT_EQ(found.isLabelled(phase), phase == 0 || phase == CinePhantom::kSystole);
  }
  ASSERT_EQ(found.planes.size(), 7U);
  for (const CinePlaneUse& use : found.planes) {
    EXPECT_EQ(use.states[0], PlaneState::labelled);
    EXPECT_EQ(use.shares.size(), CinePhantom::kPhases);
    EXPECT_GT(use.weight, 0);
    EXPECT_GT(use.likeness, 0);
  }
  EXPECT_TRUE(found.planes[5].longAxis);
  EXPECT_FALSE(found.planes[1].longAxis);
}

TEST(CineMotion, FromOneLabelIsAnEstimateThatSaysSo) {
  Progress progress;
  const CineMotion found = trackCine(phantomStudy({0}), fewHandles(), progress);
  EXPECT_TRUE(found.estimate);
  EXPECT_TRUE(says(found, "only phase 0 has labels"));
  const double full = CinePhantom::volumeMl(1, 0), empty = CinePhantom::volumeMl(1, CinePhantom::kSystole);
  EXPECT_NEAR(found.motion.phases[0].quality.surfaces[1].fittedMl, full, 1e-5);
  EXPECT_NEAR(found.motion.indices.at("LV").ejectionFraction, (full - empty) / full, 0.1);
  EXPECT_EQ(found.emptiest, CinePhantom::kSystole);
}

TEST(CineMotion, FromOneLabelHasNoNumberOfARightVentricle) {
  Progress progress;
  LabelledStudy study = phantomStudy({0}, "RV");
  study.planes.resize(2);
  study.sources.resize(2);
  const CineMotion found = trackCine(study, fewHandles(), progress);
  EXPECT_EQ(found.motion.indices.count("RV"), 0U);
  EXPECT_TRUE(says(found, "planes of one direction only"));
}

TEST(CineMotion, NamesAPhaseThatIsEmptierThanItsLabelsAndAPlaneWithoutImages) {
  Progress progress;
  LabelledStudy study = phantomStudy({0, CinePhantom::kSystole - 2});
  study.planes[1].fractions.erase(study.planes[1].fractions.begin() + 5);
  study.planes[1].images.erase(study.planes[1].images.begin() + 5);
  const CineMotion found = trackCine(study, fewHandles(), progress);
  EXPECT_TRUE(says(found, "emptier than the labelled end of systole, phase 2"));
  EXPECT_EQ(found.planes[1].states[5], PlaneState::noImage);
  EXPECT_NE(found.planes[1].light, tracking::FitLight::good);
}

/// The phantom's planes as slices of a study.
class CineJoin : public ::testing::Test {
protected:
  CineJoin() {
    for (const tracking::CinePlane& plane : CinePhantom::planes()) {
      medical_io::CineSlice& slice = study_.slices.emplace_back();
      slice.number = static_cast<int>(study_.slices.size());
      slice.geometry.origin = plane.origin;
      slice.geometry.row = plane.alongRow;
      slice.geometry.column = plane.alongColumn;
      slice.geometry.betweenColumns = plane.spacing[0];
      slice.geometry.betweenRows = plane.spacing[1];
      slice.geometry.columns = static_cast<int>(plane.images[0].cols());
      slice.geometry.rows = static_cast<int>(plane.images[0].rows());
      slice.fractions = plane.fractions;
      slice.interval = 0.7 + 0.01 * slice.number;
      slice.image = [images = plane.images](std::size_t phase) {
        auto image = std::make_shared<medical_io::CineImage>(images[phase].matrix());
        (*image)(0, 0) = std::numeric_limits<float>::quiet_NaN();
        return std::shared_ptr<const medical_io::CineImage>(image);
      };
    }
  }
  /// Both surfaces of a phase in a folder, `aside` mm from where they are.
  PhaseLabels labels(std::size_t phase, const Vec3& aside = Vec3::Zero()) const {
    const auto folder = folder_.path() / std::to_string(phase);
    std::filesystem::create_directories(folder);
    for (std::size_t which = 0; which < 2; ++which) {
      geometry::TriangleMesh mesh = CinePhantom::surface(which, phase);
      mesh.points.rowwise() += aside.transpose();
      medical_io::writeSurface(folder / (which == 0 ? "EPI.obj" : "LV.obj"), mesh, {});
    }
    return {phase, {folder}};
  }
  LabelledStudy joined(const CineRequest& request) const {
    Progress progress;
    return joinStudy(study_, request, progress);
  }

  medical_io::CineStudy study_;
  tests::TemporaryFolder folder_;
};

TEST_F(CineJoin, HasPlanesTimesAndLabelsInTheOrderOfTheCycle) {
  CineRequest request;
  request.labels = {labels(4), labels(0)};
  const LabelledStudy study = joined(request);
  EXPECT_EQ(study.phases, (std::vector<std::size_t>{0, 4}));
  EXPECT_EQ(study.labels.names, (std::vector<std::string>{"EPI", "LV"}));
  EXPECT_NEAR(study.labels.volumesMl[1][1], CinePhantom::volumeMl(1, 4), 0.01);
  EXPECT_EQ(study.times.count(), CinePhantom::kPhases);
  EXPECT_NEAR(study.times.periodSeconds, 0.74, 1e-9) << "the median of the slices";
  EXPECT_NEAR(study.times.seconds[5], 0.37, 1e-9);
  ASSERT_EQ(study.planes.size(), 7U);
  EXPECT_NO_THROW(tracking::requireValid(study.planes));
  EXPECT_EQ(study.sources[6].series, 7);
  request.leftOutSeries = {2, 7};
  request.periodSeconds = 1;
  const LabelledStudy less = joined(request);
  EXPECT_EQ(less.planes.size(), 5U);
  EXPECT_EQ(less.times.periodSeconds, 1);
}

/// A point of the cavity's contour in the plane of the second slice at phase 2, and 2 mm farther out.
ContourCorrection farther() {
  ContourCorrection correction;
  correction.phase = 2;
  correction.surface = "LV";
  const geometry::TriangleMesh cavity = CinePhantom::surface(1, 2);
  const geometry::PlaneCut cut =
      geometry::cutSurface({&cavity.points, &cavity.triangles}, {Vec3(0, 0, -8), Vec3::UnitZ()});
  const Eigen::RowVector3d middle = cut.points.colwise().mean(), at = cut.points.row(0);
  correction.points = at + 2 * (at - middle).normalized();
  return correction;
}

TEST_F(CineJoin, FindsTheSliceOfACorrectionOrSaysWhatIsWrong) {
  CineRequest request;
  request.labels = {labels(4), labels(0)};
  request.corrections = {farther()};
  const LabelledStudy study = joined(request);
  ASSERT_EQ(study.slices.size(), 7U);
  ASSERT_EQ(study.corrections.size(), 1U);
  EXPECT_EQ(study.corrections[0].slice, 1U);
  EXPECT_EQ(study.corrections[0].series, 2);
  EXPECT_EQ(restored(stored(study.corrections[0])).points, study.corrections[0].points);
  ASSERT_EQ(correctedContours(study, request.corrections).size(), 1U);
  EXPECT_EQ(correctedContours(study, request.corrections)[0].surface, 1U);
  const auto refused = [&](const std::function<void(ContourCorrection&)>& spoil, const std::string& words) {
    ContourCorrection correction = farther();
    spoil(correction);
    try {
      resolved(study, correction);
      ADD_FAILURE() << words;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused([](auto& each) { each.phase = 4; }, "Phase 4 has labels");
  refused([](auto& each) { each.phase = 10; }, "no phase 10");
  refused([](auto& each) { each.slice = 7; }, "no slice 7");
  refused([](auto& each) { each.series = 9; }, "no series 9");
  refused([](auto& each) { each.surface = "RV"; }, "There is no surface");
  refused([](auto& each) { each.points.resize(0, 3); }, "no points");
  refused([](auto& each) { each.slice = 0; }, "16.0 mm beside the plane");
  refused([](auto& each) { each.points.row(0) << 30, 15, -3; }, "beside the plane");
}

TEST_F(CineJoin, ASecondCorrectionOfAContourTakesThePlaceOfWhatItCovers) {
  ContourCorrection first = farther();
  first.slice = 1;
  first.points.resize(3, 3);
  first.points << 0, 0, -8, 10, 0, -8, 20, 0, -8;
  ContourCorrection second = first;
  second.points = Points(1, 3);
  second.points << 10, 4, -8;
  Points covered(1, 3);
  covered << 11, 0, -8;
  const auto list = withCorrection({first}, second, covered);
  ASSERT_EQ(list.size(), 1U);
  ASSERT_EQ(list[0].points.rows(), 3);
  EXPECT_EQ(list[0].points.row(1), first.points.row(2));
  EXPECT_EQ(list[0].points.row(2), second.points.row(0));
  second.phase = 3;
  EXPECT_EQ(withCorrection({first}, second, covered).size(), 2U);
}

TEST(CineTracker, MeetsCorrectionsOneAfterTheOtherAndGivesTheEarlierMotionBack) {
  auto study = std::make_shared<LabelledStudy>(phantomStudy({0, CinePhantom::kSystole}));
  study->slices.push_back({{study->planes[1].origin, study->planes[1].normal()}, 2, "slice 0, short axis"});
  Progress progress;
  const CineTracker tracker(study, fewHandles(), progress);
  const CineMotion before = tracker.motion({}, progress);
  ContourCorrection correction = farther();
  const CineMotion corrected = tracker.motion({correction}, progress);
  ASSERT_EQ(corrected.corrections.size(), 1U);
  EXPECT_TRUE(corrected.corrections[0].met.met()) << corrected.corrections[0].met.mostMm;
  const std::vector<std::size_t> changed = phasesThatDiffer(before, corrected);
  EXPECT_EQ(changed, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_TRUE(phasesThatDiffer(before, tracker.motion({}, progress)).empty()) << "to the bit";
  for (const std::size_t phase : {std::size_t{0}, CinePhantom::kSystole})
    EXPECT_EQ(corrected.motion.phases[phase].quality.surfaces[1].fittedMl,
              before.motion.phases[phase].quality.surfaces[1].fittedMl);
  EXPECT_EQ(corrected.motion.indices.at("LV").ejectionFraction,
            before.motion.indices.at("LV").ejectionFraction);
}

TEST_F(CineJoin, LeavesOutEmptyPicturesAndNamesThem) {
  const auto whole = study_.slices[1].image;
  study_.slices[1].image = [whole](std::size_t phase) {
    const auto picture = whole(phase);
    return phase != 2 ? picture
                      : std::make_shared<const medical_io::CineImage>(
                            medical_io::CineImage::Zero(picture->rows(), picture->cols()));
  };
  CineRequest request;
  request.labels = {labels(0), labels(4)};
  const LabelledStudy study = joined(request);
  ASSERT_EQ(study.planes.size(), 7U);
  EXPECT_EQ(study.planes[0].images.size(), CinePhantom::kPhases);
  EXPECT_EQ(study.planes[1].images.size(), CinePhantom::kPhases - 1);
  EXPECT_NEAR(study.planes[1].fractions[2], 0.3, 1e-9);
  std::string said;
  for (const Text& warning : study.warnings)
    said += warning.english() + '\n';
  EXPECT_NE(said.find("1 picture of series 2"), std::string::npos) << said;
  EXPECT_NE(said.find("is empty and left out: 2"), std::string::npos) << said;
}

TEST_F(CineJoin, RejectsWhatCannotBeJoined) {
  const auto refused = [this](const CineRequest& request, const std::string& words) {
    try {
      joined(request);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  CineRequest request;
  refused(request, "No phase has labels");
  request.labels = {labels(0), {10, labels(4).files}};
  refused(request, "The images have no phase 10");
  request.labels = {labels(0), labels(0)};
  refused(request, "Phase 0 has labels twice");
  request.labels = {labels(0), labels(4)};
  request.leftOutSeries = {99};
  refused(request, "no series 99");
  request.leftOutSeries.clear();
  std::filesystem::remove(folder_.path() / "4" / "LV.obj");
  refused(request, "\"LV\" is missing in phase 4");
  request.labels = {labels(0, Vec3(0, 0, 300)), labels(4, Vec3(0, 0, 300))};
  refused(request, "No image shows what is labelled");
}

TEST_F(CineJoin, SaysThatLabelsAreInOtherAxes) {
  for (medical_io::CineSlice& slice : study_.slices)
    slice.geometry.origin += Vec3(-200, -150, 0);
  CineRequest request;
  request.labels = {labels(0, Vec3(200, 150, 0)), labels(4, Vec3(200, 150, 0))};
  try {
    joined(request);
    ADD_FAILURE();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("in RAS"), std::string::npos) << error.what();
  }
}

TEST_F(CineJoin, OneSurfaceAPhaseHasWhatItsFilesNamesShare) {
  const auto file = [this](const std::string& name, std::size_t phase) {
    medical_io::writeSurface(folder_.path() / name, CinePhantom::surface(1, phase), {});
    return folder_.path() / name;
  };
  CineRequest request;
  request.labels = {{0, {file("cavity_ed.obj", 0)}}, {4, {file("cavity_es.obj", 4)}}};
  EXPECT_EQ(joined(request).labels.names, std::vector<std::string>{"cavity"});
  request.surfaces = {{"RV", {}}};
  EXPECT_EQ(joined(request).labels.names, std::vector<std::string>{"RV"});
}

} // namespace
} // namespace viscera::live
