#include <gtest/gtest.h>

#include "measured_beat.h"
#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/textbook_motion.h"

namespace viscera::live {
namespace {

/// One image of the sample heart: its outer surface and both ventricles.
MotionSeries image(const Vec3& spacing) {
  static const tests::MeasuredBeat truth(1, sample_organs::Resolution::low);
  MotionSeries heart = spacing[0] > 0 ? truth.voxels(spacing) : truth.surfaces();
  heart.names = {"heart", "LV", "RV"};
  return heart;
}

TEST(TextbookSeries, MovesTheCavitiesOfOneImageByWhatIsWanted) {
  for (const double wanted : {0.58, 0.35}) {
    TextbookBeat beat;
    beat.ejectionFraction = wanted;
    beat.phases = 10;
    Progress progress;
    const MotionSeries series = textbookSeries(image(Vec3(2, 2, 2)), beat, progress);
    ASSERT_EQ(series.phases(), 10U);
    const PatientMotion found = trackMotion(series, {}, progress);
    EXPECT_NEAR(found.indices.at("LV").ejectionFraction, wanted, 0.02);
    EXPECT_NEAR(found.indices.at("LV").strokeVolumeMl / found.indices.at("RV").strokeVolumeMl, 1, 0.03)
        << "both eject as much";
    for (std::size_t phase = 0; phase < 10; ++phase) {
      EXPECT_EQ(found.phases[phase].quality.folded, 0) << "phase " << phase;
      EXPECT_LT(found.phases[phase].quality.meanMm, 1.5) << "phase " << phase;
      EXPECT_NEAR(found.tissueMl[phase] / found.tissueMl[0], 1, 1e-3) << "muscle keeps its volume";
      for (const tracking::SurfaceQuality& surface : found.phases[phase].quality.surfaces)
        EXPECT_EQ(surface.flipped, 0) << "phase " << phase;
    }
  }
}

TEST(TextbookMotion, IsARecordedSequenceForTheHeartOfADocument) {
  Progress progress;
  const MeasuredPhase rest = measuredPhase(image(Vec3(3, 3, 3)), 0, progress);
  std::vector<document::NewOrgan> batch;
  for (const char* name : {"Heart", "LV", "RV"})
    batch.push_back({document::makeOrgan(name, rest.surfaces[batch.size()]), batch.empty() ? -1 : 0});
  batch.push_back({document::makeOrgan("spleen", tests::sphere(2, 20, Vec3(300, 0, 0))), -1});
  document::Document document;
  document::UndoStack undo(document);
  undo.perform(document::addOrgans(batch));
  const document::OrganList organs = document.organs();
  EXPECT_EQ(heartWithCavities(organs, *organs[0]), organs[0]);
  EXPECT_EQ(heartWithCavities(organs, *organs[1]), organs[0]) << "a chamber is of its heart";
  EXPECT_EQ(heartWithCavities(organs, *organs[3]), nullptr);
  TextbookBeat beat;
  beat.ejectionFraction = 0.45;
  beat.phases = 8;
  const PatientMotion found = textbookMotion(organs, *organs[0], beat, progress);
  EXPECT_NEAR(found.indices.at("LV").ejectionFraction, 0.45, 0.02);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(found.sequence.organs[i].mesh->points, organs[i]->mesh->points) << "the image, to the bit";
  undo.perform(openSequence(found.sequence));
  EXPECT_EQ(document.keySequence().keys.size(), 8U);
  EXPECT_EQ(document.keySequence().name, "Textbook heartbeat");
  EXPECT_EQ(document.rig().handles.size(), 120U);
  EXPECT_EQ(document.organs(), organs);
}

TEST(TextbookSeries, SaysWhatItNeeds) {
  Progress progress;
  MotionSeries heart = image(Vec3::Zero());
  TextbookBeat beat;
  beat.ejectionFraction = 0.95;
  EXPECT_THROW(textbookSeries(heart, beat, progress), UsageError);
  heart.names = {"heart", "one", "two"};
  beat.ejectionFraction = 0.5;
  EXPECT_THROW(textbookSeries(heart, beat, progress), DataError);
}

} // namespace
} // namespace viscera::live
