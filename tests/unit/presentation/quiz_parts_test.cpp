#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sequence_scene.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/open_files.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/presentation/part_names.h"
#include "viscera/presentation/stage.h"
#include "viscera/scene/surface_pick.h"

/// What the quiz asks for (`clickableParts`) against what a click meets.
namespace viscera::presentation {
namespace {

/// A sequence's sample in a small picture.
class AskedSample {
public:
  explicit AskedSample(const std::string& sequence)
      : setup_(live::setUpSequence(tests::cachedLibrary(), sequence, sample_organs::Resolution::low,
                                   progress_)) {
    undo_.perform(document::setSystem(setup_.system));
    undo_.perform(document::addOrgans(document::organsFrom(setup_.organ)));
    undo_.perform(document::replaceRig(setup_.rig));
  }

  std::vector<Part> asked() const { return clickableParts(document_.organs()); }
  const std::string& nameOf(const Part& part) const { return presentation::nameOf(part, document_.organs()); }
  void show(double fraction) {
    const double rate = setup_.sequence->standardRatePerMinute();
    Points pose;
    setup_.sequence->poseAt(fraction * 60 / rate, rate, pose);
    live_.showPose(pose);
    stage_.presenter().update({document_.state(), live_, view_, registry_});
  }
  void lookFrom(scene::StandardView side) { stage_.compose(side); }

  /// Whether a click on the part, as it is seen from here, answers with it.
  bool isMet(const Part& part) {
    std::vector<scene::OrganActor*> all;
    for (const auto& organ : stage_.view().organs())
      all.push_back(organ.get());
    const Points& points = *live_.sharedPoints(part.organ);
    const Vec3 eye = cameraOf(stage_.view()).position;
    const Vec3 sight = (points.row(part.vertex).transpose() - eye).normalized();
    const auto met = scene::pickSurface({eye, sight}, all);
    if (!met || stage_.presenter().organOf(met->organ) != part.organ)
      return false;
    const auto answer = nearestPart(asked(), part.organ, points, met->position);
    return answer && *answer == part;
  }

private:
  Progress progress_;
  live::SequenceSetup setup_;
  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  JobQueue jobs_{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live_{document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {}}};
  ViewState view_;
  Stage stage_{320, 240, scene::lightTheme()};
};

class QuizOfASample : public testing::TestWithParam<const char*> {};

/// Three phases, from six sides: each part can be answered from one of them in each phase.
TEST_P(QuizOfASample, AsksForPartsThatAClickMeetsFromOneSideInEachPhase) {
  AskedSample sample(GetParam());
  ASSERT_FALSE(sample.asked().empty());
  for (const double fraction : {0.0, 0.35, 0.7}) {
    sample.show(fraction);
    std::vector<Part> left = sample.asked();
    for (const auto side :
         {scene::StandardView::anterior, scene::StandardView::posterior, scene::StandardView::left,
          scene::StandardView::right, scene::StandardView::superior, scene::StandardView::inferior}) {
      sample.lookFrom(side);
      std::erase_if(left, [&](const Part& part) { return sample.isMet(part); });
    }
    for (const Part& part : left)
      ADD_FAILURE() << sample.nameOf(part) << " cannot be clicked at " << fraction;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, QuizOfASample, testing::Values("heartbeat", "breathing", "peristalsis"),
                         [](const auto& sequence) { return std::string(sequence.param); });

} // namespace
} // namespace viscera::presentation
