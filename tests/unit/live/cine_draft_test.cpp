#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/live/cine_draft.h"

namespace viscera::live {
namespace {

constexpr std::size_t kDraftPhases = 12, kDraftSystole = 5;

/// Two slices of a disc that is smallest in the sixth of twelve phases; each lacks a pixel.
medical_io::CineStudy beatingDisc() {
  medical_io::CineStudy study;
  for (int number = 1; number <= 2; ++number) {
    medical_io::CineSlice& slice = study.slices.emplace_back();
    slice.number = number;
    slice.geometry.columns = slice.geometry.rows = 32;
    slice.interval = number == 1 ? 0.8 : 0.9;
    for (std::size_t phase = 0; phase < kDraftPhases; ++phase)
      slice.fractions.push_back(static_cast<double>(phase) / kDraftPhases);
    slice.image = [](std::size_t phase) {
      auto image = std::make_shared<medical_io::CineImage>(32, 32);
      const double away = std::abs(static_cast<double>(phase) - kDraftSystole);
      const double radius = 6 + std::min(away, 5.0) * 0.8;
      for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column)
          (*image)(row, column) = std::hypot(row - 15.5, column - 15.5) < radius ? 300.0F : 100.0F;
      (*image)(16, 16) = std::numeric_limits<float>::quiet_NaN();
      return std::shared_ptr<const medical_io::CineImage>(image);
    };
  }
  return study;
}

CineCycle discCycle() {
  Progress progress;
  return cycleOf(beatingDisc(), "patient1", progress);
}

/// The guessed phases of files, -1 for none.
std::vector<int> guessedPhases(std::vector<std::filesystem::path> files) {
  CineDraft draft;
  draft.setCycle(discCycle());
  draft.add(std::move(files));
  std::vector<int> phases;
  for (const CineDraft::Labels& each : draft.labels())
    phases.push_back(each.phase ? static_cast<int>(*each.phase) : -1);
  return phases;
}

TEST(CineDraft, KnowsTheCycleOfItsImagesAndTheirEmptiestPhase) {
  const CineCycle cycle = discCycle();
  EXPECT_EQ(cycle.phases, kDraftPhases);
  EXPECT_EQ(cycle.emptiest, kDraftSystole);
  ASSERT_TRUE(cycle.periodSeconds);
  EXPECT_DOUBLE_EQ(*cycle.periodSeconds, 0.9) << "the upper one of two";
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(cycleOf(beatingDisc(), "patient1", cancelled), Cancelled);
}

TEST(CineDraft, GuessesPhasesFromNames) {
  using Phases = std::vector<int>;
  EXPECT_EQ(guessedPhases({"es.nrrd", "ed.nrrd"}), (Phases{0, 5})) << "in the order of their names";
  EXPECT_EQ(guessedPhases({"p_frame01_gt.nii.gz", "p_frame06_gt.nii.gz"}), (Phases{0, 5})) << "from 1";
  EXPECT_EQ(guessedPhases({"p1_LV_000.obj", "p1_LV_006.obj"}), (Phases{0, 6})) << "from 0";
  EXPECT_EQ(guessedPhases({"p1_LV_006.obj", "p1_LV_012.obj"}), (Phases{5, 11}))
      << "there is no phase 12 from 0";
  EXPECT_EQ(guessedPhases({"ED/LV.obj", "ED/RV.obj", "ES/LV.obj"}), (Phases{0, 0, 5}));
  EXPECT_EQ(guessedPhases({"patient1_ed.seg.nrrd"}), (Phases{0})) << "its number is the patient's";
  EXPECT_EQ(guessedPhases({"heart.nrrd"}), (Phases{-1}));
  EXPECT_EQ(guessedPhases({"LV_040.obj"}), (Phases{-1})) << "the cycle has no such phase";
}

TEST(CineDraft, KeepsWhatTheUserSaid) {
  CineDraft draft;
  draft.add({"ed.nrrd", "es.nrrd"});
  EXPECT_FALSE(draft.labels()[1].phase) << "images would tell";
  draft.setPhase(1, 7);
  draft.setCycle(discCycle());
  EXPECT_EQ(draft.labels()[0].phase, std::size_t{0});
  EXPECT_EQ(draft.labels()[1].phase, std::size_t{7});
  EXPECT_FALSE(draft.labels()[1].guessed);
  draft.add({"es.nrrd"});
  EXPECT_EQ(draft.labels().size(), 2U) << "it was there";
  EXPECT_EQ(draft.labelled(), (std::vector<std::size_t>{0, 7}));
  draft.remove(0);
  EXPECT_EQ(draft.labelled(), std::vector<std::size_t>{7});
  EXPECT_THROW(draft.remove(1), UsageError);
  EXPECT_THROW(draft.setPhase(1, 0), UsageError);
}

TEST(CineDraft, SaysWhatIsMissingAndWhatToDoubt) {
  CineDraft draft;
  EXPECT_EQ(draft.missing().english(), "Choose the images first");
  EXPECT_THROW(draft.request(), UsageError);
  draft.setCycle(discCycle());
  EXPECT_NE(draft.missing().english().find("Choose the labels"), std::string::npos);
  draft.add({"heart.nrrd"});
  EXPECT_EQ(draft.missing().english(), "Enter the phase of heart.nrrd");
  draft.setPhase(0, 99);
  EXPECT_EQ(draft.missing().english(), "The images have 12 phases: enter another one for heart.nrrd");
  draft.setPhase(0, 0);
  EXPECT_TRUE(draft.missing().empty());
  EXPECT_TRUE(draft.isEstimate());
  EXPECT_NE(draft.remark().english().find("Only phase 1 has labels"), std::string::npos);
  draft.add({"other.nrrd"});
  draft.setPhase(1, 1);
  EXPECT_FALSE(draft.isEstimate());
  EXPECT_NE(draft.remark().english().find("in phase 6, which has no labels"), std::string::npos);
  draft.setPhase(1, 6);
  EXPECT_TRUE(draft.remark().empty()) << "a phase beside the emptiest shows it";
  draft.add({"a/heart.nrrd"});
  draft.setPhase(2, 0);
  EXPECT_EQ(draft.missing().english(), "heart.nrrd and heart.nrrd are both labels of phase 1");
}

TEST(CineDraft, BecomesARequestWhoseTextsCountFromOne) {
  CineDraft draft;
  draft.setCycle(discCycle());
  draft.add({"ED/LV.obj", "ED/RV.obj", "ES/LV.obj", "ES/RV.obj"});
  CineRequest request = draft.request();
  EXPECT_EQ(request.images, "patient1");
  ASSERT_EQ(request.labels.size(), 2U);
  EXPECT_EQ(request.labels[0].files, (std::vector<std::filesystem::path>{"ED/LV.obj", "ED/RV.obj"}));
  EXPECT_EQ(request.labels[1].phase, kDraftSystole);
  request.labels = {PhaseLabels{kDraftPhases, {"ed.nrrd"}}};
  Progress progress;
  try {
    joinStudy(beatingDisc(), request, progress);
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.problem().english(), "The images have no phase 13");
  }
}

} // namespace
} // namespace viscera::live
