#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/cine_study.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/phantom/render.h"
#include "viscera/phantom/tissue.h"
#include "viscera/phantom/write_phantom.h"

namespace viscera::phantom {
namespace {

constexpr auto kResolution = sample_organs::Resolution::medium;

/// A body whose heart beats while it breathes; making it takes seconds.
struct MovingBody {
  Progress progress;
  sample_organs::SampleLibrary library = sample_organs::standardLibrary();
  PhantomBody body = phantomBody(library, kResolution, progress);
  PhantomMotion motion = PhantomMotion(library, body, {.heartbeat = true, .breathing = true}, progress);

  /// An instant at which the heart is small and the breath deep.
  PhantomInstant deep() {
    motion.setSeconds(2);
    return instantOf(body, motion);
  }
};

/// Voxels around the ventricles.
ImageGrid heartGrid(double spacing) {
  ImageGrid grid;
  const auto count = static_cast<int>(130 / spacing);
  grid.size = {count, count, count};
  grid.indexToLps = Eigen::Translation3d(-65, -60, -70) * Eigen::Scaling(spacing);
  return grid;
}

void expectForwardAfterInverseToComeBack(MovingBody& moving) {
  const PhantomInstant instant = moving.deep();
  for (std::size_t s = 0; s < moving.body.surfaces.size(); ++s) {
    if (moving.body.surfaces[s].still)
      continue;
    const PhantomRest rest = moving.motion.restOf(instant.surfaces[s]);
    const Points back = moving.motion.moved(rest.points);
    EXPECT_LT((back - instant.surfaces[s]).rowwise().norm().maxCoeff(), 0.05)
        << moving.body.surfaces[s].tissue;
    EXPECT_LT((rest.points - moving.body.surfaces[s].mesh.points).rowwise().norm().maxCoeff(), 0.05)
        << moving.body.surfaces[s].tissue;
  }
  EXPECT_EQ(moving.motion.foldedMl(), 0);
}

void expectBreathToKeepVolumesOfTheHeart(MovingBody& moving) {
  const BodySurface& left = moving.body.surfaceOf("left ventricle");
  // The same place of two beats, without breath and at its deepest.
  const double beat = 60 / moving.motion.beatsPerMinute();
  moving.motion.setSeconds(0);
  const double before = geometry::volume(moving.motion.moved(left.mesh.points), left.mesh.triangles);
  moving.motion.setSeconds(2 * beat);
  EXPECT_GT(moving.motion.inspiration(), 0.5);
  EXPECT_NEAR(geometry::volume(moving.motion.moved(left.mesh.points), left.mesh.triangles) / before, 1, 1e-4);
}

void expectMovedLabelsAtTheRestOfVoxels(MovingBody& moving) {
  const PhantomInstant instant = moving.deep();
  const ImageGrid grid = heartGrid(4);
  const std::vector<std::uint8_t> moved = renderLabels(moving.body, instant, grid);
  const std::vector<std::uint8_t> warped = warpLabels(RestTissue(moving.body), moving.motion, grid);
  std::map<int, std::array<double, 3>> counts; // Moved, warped, both.
  for (std::size_t v = 0; v < moved.size(); ++v) {
    counts[moved[v]][0] += 1;
    counts[warped[v]][1] += 1;
    counts[moved[v]][2] += moved[v] == warped[v] ? 1 : 0;
  }
  for (const char* tissue :
       {"myocardium", "left ventricle", "right ventricle", "left atrium", "right atrium"}) {
    const auto& [a, b, both] = counts.at(tissueNamed(tissue).label);
    EXPECT_GT(2 * both / (a + b), 0.99) << tissue;
  }
}

void expectLabelledVolumesOfTheSurfaces(MovingBody& moving) {
  const PhantomInstant instant = moving.deep();
  const ImageGrid grid = heartGrid(2);
  const std::vector<std::uint8_t> labels = renderLabels(moving.body, instant, grid);
  for (std::size_t s = 0; s < moving.body.surfaces.size(); ++s) {
    const BodySurface& surface = moving.body.surfaces[s];
    if (surface.tissue != "left ventricle" && surface.tissue != "right ventricle")
      continue;
    const double exact = geometry::volume(instant.surfaces[s], surface.mesh.triangles);
    const auto count = std::count(labels.begin(), labels.end(), tissueNamed(surface.tissue).label);
    EXPECT_NEAR(static_cast<double>(count) * grid.voxelMm3() / exact, 1, 0.01) << surface.tissue;
  }
}

void expectImagesForAnyNumberOfThreads(MovingBody& moving) {
  const PhantomInstant instant = moving.deep();
  const Contrast contrast{Contrast::Kind::cineMr, Contrast::Noise::rician, 10, 7};
  const ImageGrid grid = heartGrid(6);
  const std::vector<float> one = renderImage(moving.body, instant, grid, contrast, 3, Threads{1});
  EXPECT_EQ(one, renderImage(moving.body, instant, grid, contrast, 3, Threads{3}));
  EXPECT_NE(one, renderImage(moving.body, instant, grid, contrast, 4, Threads{1}))
      << "the noise of another image";
}

// One test, because each test is a process of its own, which would make the body again.
TEST(Phantom, ItsImagesAndLabelsFollowItsMotion) {
  MovingBody moving;
  expectForwardAfterInverseToComeBack(moving);
  expectBreathToKeepVolumesOfTheHeart(moving);
  expectMovedLabelsAtTheRestOfVoxels(moving);
  expectLabelledVolumesOfTheSurfaces(moving);
  expectImagesForAnyNumberOfThreads(moving);
}

TEST(Phantom, WritesACineStudyThatIsReadAsOne) {
  const tests::TemporaryFolder folder;
  PhantomOptions options;
  options.modality = Modality::cine;
  options.motion.heartbeat = true;
  options.motion.ejectionFraction = 0.45;
  options.spacing = Vec3(5, 5, 8);
  options.slices = {.shortAxis = 3, .gapMm = 10, .longAxis = true};
  options.shiftSlicesMm = 3;
  options.phases = 3;
  options.fieldSpacingMm = 0;
  options.resolution = kResolution;
  Progress progress;
  const PhantomReport report =
      writePhantom(folder.path(), options, sample_organs::standardLibrary(), progress);
  EXPECT_NEAR(report.ejectionFraction, 0.45, 1e-3);
  const medical_io::CineStudy study = medical_io::readCineStudy(folder.path() / "cine", progress);
  ASSERT_EQ(study.slices.size(), 6U);
  ASSERT_EQ(study.stacks.size(), 1U);
  EXPECT_NEAR(study.stacks[0].gaps.at(0), 10, 1e-3);
  EXPECT_EQ(study.slices[0].plane, medical_io::CinePlane::shortAxis);
  EXPECT_EQ(study.slices[5].plane, medical_io::CinePlane::fourChamber);
  ASSERT_EQ(study.slices[0].fractions.size(), 3U);
  EXPECT_NEAR(study.slices[0].fractions[2], 2.0 / 3, 1e-3);
}

TEST(Phantom, WritesOneFileOverTimeAndFieldsAsNifti) {
  const tests::TemporaryFolder folder;
  PhantomOptions options;
  options.motion.heartbeat = true;
  options.spacing = Vec3::Constant(12);
  options.phases = 2;
  options.fieldSpacingMm = 40;
  options.format = ".nii.gz";
  options.overTime = true;
  options.resolution = kResolution;
  Progress progress;
  const PhantomReport report =
      writePhantom(folder.path(), options, sample_organs::standardLibrary(), progress);
  for (const char* name : {"ct.nii.gz", "labels.nii.gz", "forward_001.nii.gz", "backward_001.nii.gz"})
    EXPECT_EQ(std::count(report.files.begin(), report.files.end(), name), 1) << name;
  EXPECT_EQ(medical_io::readScan(folder.path() / "ct.nii.gz", {"", 1}, progress).phaseTimesMs.size(), 2U);
  EXPECT_EQ(medical_io::readLabelMap(folder.path() / "labels.nii.gz", progress, 1).phaseTimesMs.size(), 2U);
}

TEST(Phantom, RefusesOptionsThatMakeNoSense) {
  EXPECT_THROW(spacingFrom("2,2"), UsageError);
  EXPECT_THROW(spacingFrom("2,2,x"), UsageError);
  EXPECT_THROW(slicesFrom({"sax:9"}), UsageError);
  EXPECT_THROW(slicesFrom({"sax:1.5,2"}), UsageError);
  EXPECT_THROW(slicesFrom({"axial"}), UsageError);
  PhantomOptions noisy;
  EXPECT_THROW(setNoise("poisson:3", noisy), UsageError);
  EXPECT_THROW(setNoise("rician:", noisy), UsageError);
  PhantomOptions options;
  EXPECT_NO_THROW(requireSound(options));
  options.modality = Modality::cine;
  EXPECT_THROW(requireSound(options), UsageError) << "a cine without a heartbeat";
  options.motion = {.heartbeat = true, .breathing = true};
  EXPECT_THROW(requireSound(options), UsageError) << "a cine that breathes";
  options = {};
  options.shiftSlicesMm = 3;
  EXPECT_THROW(requireSound(options), UsageError) << "shifted slices of a CT";
  options = {};
  options.spacing = Vec3(0, 1, 1);
  EXPECT_THROW(requireSound(options), UsageError);
}

} // namespace
} // namespace viscera::phantom
