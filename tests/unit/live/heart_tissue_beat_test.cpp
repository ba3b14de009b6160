#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "held_value.h"
#include "sequence_scene.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/live/live_binding.h"

/// The heart's walls, as a cut shows them, over a beat: rows of the table in docs/sample_organs.md.
namespace viscera::live {
namespace {

using sample_organs::Resolution;
using tests::HeldValue;

/// The coarse sample heart with its walls, in the poses of a sequence.
class BeatingTissue {
public:
  explicit BeatingTissue(SequenceSetup setup) : setup_(std::move(setup)) {
    undo_.perform(
        document::combined("Show", {document::addOrgans(document::organsFrom(setup_.organ)),
                                    document::replaceRig(setup_.rig), document::setSystem(setup_.system)}));
    heart_ = sampleHeartIn(document_.state());
    tissue_ = makeHeartTissue(*heart_, tests::cachedLibrary(), progress_);
  }

  void show(double fraction) {
    const double rate = setup_.sequence->standardRatePerMinute();
    Points pose;
    setup_.sequence->poseAt(fraction * 60 / rate, rate, pose);
    live_.showPose(pose);
    tissue_->at(*heart_, live_, walls_);
  }
  double volumeMl() const { return geometry::volume(walls_, tissue_->mesh()->triangles) / kMm3PerMl; }
  int crossings() {
    return geometry::countSelfIntersections({walls_, tissue_->mesh()->triangles, {}}, progress_);
  }

private:
  Progress progress_;
  SequenceSetup setup_;
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](const std::function<void()>& work) { work(); }};
  LiveBinding live_{document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}};
  std::optional<SampleHeartOrgans> heart_;
  std::shared_ptr<const HeartTissue> tissue_;
  Points walls_;
};

/// What is seen of the tissue in frames evenly over a beat.
struct TissueOverABeat {
  double change = 0; ///< Of its volume, half of the way from the least to the most, % of the middle.
  int crossings = 0; ///< Pairs of triangles, in all frames.
};

TissueOverABeat tissueOver(int frames, BeatingTissue& tissue) {
  TissueOverABeat found;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int frame = 0; frame < frames; ++frame) {
    tissue.show((frame + 0.37) / frames);
    least = std::min(least, tissue.volumeMl());
    most = std::max(most, tissue.volumeMl());
    found.crossings += tissue.crossings();
  }
  found.change = 100 * (most - least) / (most + least);
  return found;
}

/// Ten frames, which are enough to meet each phase. The coarse walls are held here; those of the window's
/// resolution are looked at by `TissueOfAHeart.GoesAlongWithItsSurfacesInTheBeat`.
TEST(HeartTissueOverABeat, KeepsItsVolumeAndNeverMeetsItselfInTheTextbooksBeat) {
  constexpr int kBeatFrames = 10;
  Progress progress;
  BeatingTissue tissue(setUpSequence(tests::cachedLibrary(), "heartbeat", Resolution::low, progress));
  const TissueOverABeat found = tissueOver(kBeatFrames, tissue);
  HeldValue volume("change of the walls' volume over the textbook's beat, either way", 5, "%");
  volume.add(found.change);
  HeldValue crossings("crossings of the coarse walls with themselves in ten frames of the textbook's beat",
                      0);
  crossings.add(found.crossings);
}

/// Two stand for all scenarios, since each takes a second to make: those with a strong and with a weak beat,
/// in two frames each.
TEST(HeartTissueOverABeat, KeepsItsVolumeAndNeverMeetsItselfInTwoScenarios) {
  constexpr int kFramesEach = 2;
  HeldValue volume("change of the walls' volume in exercise and in heart failure, either way", 5, "%");
  HeldValue crossings(
      "crossings of the coarse walls with themselves in exercise and in heart failure, four frames", 0);
  for (const char* id : {"exercise", "heart-failure-reduced-ef"}) {
    Progress progress;
    BeatingTissue tissue(circulatingHeart(tests::cachedLibrary(), circulation::scenario(id).name,
                                          circulation::scenarioParameters(id), Resolution::low, progress));
    const TissueOverABeat found = tissueOver(kFramesEach, tissue);
    volume.add(found.change);
    crossings.add(found.crossings);
  }
}

TEST(SampleHeartIn, HasItsCavitiesWithAndWithoutAParent) {
  for (const bool nested : {true, false}) {
    document::OrganList organs;
    for (const char* surface : {"outer", "lv", "ra"}) {
      document::Organ organ;
      organ.id = document::OrganId{static_cast<std::int64_t>(organs.size()) + 1};
      organ.origin.sample = "heart@low";
      organ.origin.surface = surface;
      if (nested && !organs.empty())
        organ.parent = organs.front()->id;
      organs.push_back(std::make_shared<const document::Organ>(std::move(organ)));
    }
    document::DocumentState state;
    state.organs = std::make_shared<const document::OrganList>(organs);
    const auto heart = sampleHeartIn(state);
    ASSERT_TRUE(heart) << nested;
    EXPECT_EQ(heart->cavities.size(), 2u) << nested;
  }
}

} // namespace
} // namespace viscera::live
