#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sequence_scene.h"
#include "session_fixture.h"
#include "sway.h"
#include "viscera/document/open_files.h"
#include "viscera/lesson/lesson.h"
#include "viscera/lesson/packed_arrays.h"
#include "viscera/live/sequence_file.h"

/// Scenes and helpers that the tests of lessons share.
namespace viscera::lesson {

/// A ball on ten handles, two of which sway.
struct BallScene : viscera::tests::BoundSession {
  Progress progress;

  std::shared_ptr<const sequences::Sequence> sway(double mm = 15) const {
    return std::make_shared<viscera::tests::Sway>(
        document.rig().restPositions(),
        std::vector<viscera::tests::Swing>{{8, Vec3(0, 4, mm), 0.3}, {9, Vec3(mm, 0, -5), 1.9}});
  }
  LessonSource source(std::shared_ptr<const sequences::Sequence> sequence) const {
    return {.state = document.state(), .sequence = std::move(sequence)};
  }
  Lesson made(const LessonSource& from, const LessonSpec& spec = {}) {
    return makeLesson(planLesson(from, spec), from, live, progress);
  }
};

/// A sequence of the program on its own organ, bound; what has cavities is seen through.
struct SampleScene {
  document::Document document;
  document::UndoStack undo{document};
  coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {}}};
  Progress progress;
  LessonSource source;

  explicit SampleScene(const std::string& sequence,
                       sample_organs::Resolution resolution = sample_organs::Resolution::low) {
    const live::SequenceSetup setup =
        live::setUpSequence(viscera::tests::cachedLibrary(), sequence, resolution, progress);
    std::vector<document::NewOrgan> organs = document::organsFrom(setup.organ);
    if (organs.size() > 1)
      organs.front().organ.look.opacity = 0.3;
    undo.perform(
        document::combined("Sample", {document::addOrgans(std::move(organs)), document::replaceRig(setup.rig),
                                      document::setSystem(setup.system)}));
    source = {.state = document.state(), .sequence = setup.sequence};
  }
};

/// What a sequence file holds as a document with its recording, bound. The organ "EPI" is the wall around the
/// others.
struct MotionFileScene {
  document::Document document;
  document::UndoStack undo{document};
  coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](const std::function<void()>& work) { work(); }};
  live::LiveBinding live{document, registry, jobs, {std::numeric_limits<double>::infinity(), {}}};
  Progress progress;

  explicit MotionFileScene(const std::filesystem::path& file) {
    live::SequenceFile motion = live::readSequence(file);
    std::vector<document::NewOrgan> organs;
    for (const live::SequenceOrgan& organ : motion.organs) {
      organs.push_back({document::makeOrgan(organ.name, organ.mesh), -1});
      organs.back().organ.look.opacity = organ.name == "EPI" ? 0.35 : 1;
    }
    undo.perform(document::addOrgans(std::move(organs)));
    undo.perform(live::openSequence(std::move(motion)));
  }

  LessonSource source() const {
    return {.state = document.state(),
            .sequence = document::sequenceOf(*document.state().keySequence, *document.state().rig)};
  }
};

/// The vertices as a page computes them from what is in the file.
inline Points pagePoints(const Lesson& lesson, std::size_t rate, double fraction) {
  const Eigen::VectorXd values =
      valueAt(lesson.courses[static_cast<std::size_t>(lesson.courseOfRate[rate])], fraction);
  Points points = lesson.rest;
  for (std::size_t k = 0; k < lesson.modes.size(); ++k)
    points += values[static_cast<Eigen::Index>(k)] * lesson.modes[k];
  return points.topRows(lesson.vertexCount());
}

/// And as the organs themselves are.
inline Points organPoints(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs,
                          std::size_t rate, double fraction) {
  Points pose;
  const double perMinute = plan.rates[rate];
  source.sequence->poseAt(fraction * 60 / perMinute, perMinute, pose);
  organs.showPose(pose);
  Points points(0, 3);
  for (const PlannedSurface& surface : plan.surfaces) {
    const Points& own = *organs.sharedPoints(surface.organ);
    points.conservativeResize(points.rows() + own.rows(), 3);
    points.bottomRows(own.rows()) = own;
  }
  return points;
}

/// How far they are apart at instants that are no samples, over all rates.
inline double worstOver(const Lesson& lesson, const LessonSource& source, live::PosedOrgans& organs,
                        const std::vector<double>& fractions) {
  double worst = 0;
  for (std::size_t rate = 0; rate < lesson.plan.rates.size(); ++rate)
    for (const double fraction : fractions)
      worst = std::max(worst, (pagePoints(lesson, rate, fraction) -
                               organPoints(lesson.plan, source, organs, rate, fraction))
                                  .rowwise()
                                  .norm()
                                  .maxCoeff());
  return worst;
}

} // namespace viscera::lesson
