#include "viscera/workbench/workbench.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "session_fixture.h"
#include "temporary_folder.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/live/player.h"

namespace viscera::workbench {
namespace {

/// A ball with a locked volume, thirty handles and a motion of two keys.
const char* const kSession = VISCERA_SOURCE_DIR "/tests/gui/sessions/play_recorded_locked.viscera";
const Vec3 kBy(6, -4, 3);

document::DocumentState savedState() {
  Progress progress;
  return document::readSession(kSession, sample_organs::standardLibrary(), progress).contents.state;
}

/// The same document as the parts of a window have it, whose locks are prepared by a worker.
struct WindowParts {
  document::Document document;
  document::UndoStack undo{document};
  coordinates::Registry registry = coordinates::builtInRegistry();
  ManualEventLoop loop;
  JobQueue jobs{loop.post()};
  live::LiveBinding live{document, registry, jobs};
  live::VolumeKeeper keeper{document.state(), live, {}, &jobs};

  explicit WindowParts(const document::DocumentState& state) {
    undo.reset(state);
    wait();
    keeper.prepare();
    wait();
  }
  void wait() {
    loop.runUntil([this] { return jobs.idle(); });
  }
};

std::string firstLabel(const Workbench& bench) {
  return bench.state().rig->handles.at(8).label;
}

} // namespace

TEST(Workbench, ReplaysADragABeatAndASessionToTheSameBits) {
  std::vector<std::vector<double>> replays;
  for (int time = 0; time < 2; ++time) {
    Workbench bench;
    bench.restore(kSession);
    std::vector<double>& numbers = replays.emplace_back();
    const Vec3 given = bench.drag(firstLabel(bench), kBy);
    numbers.insert(numbers.end(), given.data(), given.data() + 3);
    numbers.push_back(bench.volume("ball").nowMl);
    for (const PlayedVolumes& instant : bench.play(10))
      numbers.insert(numbers.end(), instant.milliliters.begin(), instant.milliliters.end());
  }
  EXPECT_GT(replays[0].size(), 10u);
  EXPECT_EQ(replays[0], replays[1]);
}

TEST(Workbench, DragsUnderALockAsTheWindowDoes) {
  const document::DocumentState state = savedState();
  Workbench bench;
  bench.restore(kSession);
  const double rest = bench.volume("ball").restMl;
  for (const live::Others others : {live::Others::asMarked, live::Others::compensate}) {
    WindowParts window(state);
    live::LockedMotion motion =
        window.keeper.begin({state.rig->handles.at(8).id}, std::nullopt, std::nullopt, others);
    motion.translate(kBy);
    const Vec3 given = bench.drag(firstLabel(bench), kBy, others);
    EXPECT_EQ(given, motion.given());
    EXPECT_EQ(*bench.state().pose, motion.pose());
    EXPECT_NEAR(bench.volume("ball").nowMl, rest, 1e-6);
    EXPECT_TRUE(bench.undo());
  }
  EXPECT_EQ(*bench.state().pose, *state.pose);
}

TEST(Workbench, FreeHandlesFollowADragAndAPoseAsInTheWindowAndUndoTakesBoth) {
  const document::DocumentState state = savedState();
  Workbench bench;
  bench.restore(kSession);
  const Points before = *bench.state().pose;
  const double rest = bench.volume("ball").restMl;
  WindowParts window(state);
  window.keeper.setSystems(window.registry);
  live::LockedMotion motion =
      window.keeper.begin({state.rig->handles.at(8).id}, std::nullopt, std::nullopt, live::Others::follow);
  motion.translate(kBy);
  const Vec3 given = bench.drag(firstLabel(bench), kBy, live::Others::follow);
  EXPECT_LE((given - kBy).norm(), 1e-12);
  EXPECT_EQ(*bench.state().pose, motion.pose());
  EXPECT_NEAR(bench.volume("ball").nowMl, rest, 1e-6);
  EXPECT_GT(((*bench.state().pose - before).rowwise().norm().array() > 1e-3).count(), 5);
  EXPECT_TRUE(bench.undo());
  EXPECT_EQ(*bench.state().pose, before);
  Points places = before;
  places.row(8) += kBy.transpose();
  bench.pose(places, live::Others::follow);
  EXPECT_LE((*bench.state().pose - motion.pose()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE(bench.undo());
  EXPECT_EQ(*bench.state().pose, before);
}

TEST(Workbench, RefusesAnExactDragThatTheLockForbids) {
  Workbench bench;
  bench.restore(kSession);
  std::vector<document::HandleId> others;
  for (const document::Handle& handle : bench.state().rig->handles)
    if (handle.label != firstLabel(bench))
      others.push_back(handle.id);
  document::HandleEdit held;
  held.locked = true;
  bench.perform(document::editHandles(others, held)); // None can make up for the volume.
  const Points before = *bench.state().pose;
  EXPECT_THROW(bench.drag(firstLabel(bench), Vec3(30, 10, 20), live::Others::compensate), DataError);
  EXPECT_EQ(*bench.state().pose, before);
}

TEST(Workbench, PlaysWhatThePlayerOfAWindowShows) {
  Workbench bench;
  bench.restore(kSession);
  ASSERT_TRUE(bench.sequence());
  EXPECT_EQ(bench.motion().ratePerMinute(), 30) << "as it was saved";
  WindowParts window(savedState());
  live::Player player(
      window.document.state(), window.live, [] { return 0.0; }, &window.jobs);
  player.setSequence(bench.sharedSequence(), window.document.organs().front()->id);
  player.setRatePerMinute(30);
  player.match();
  player.seek(0.05); // Prepares the locks.
  window.wait();
  for (const double fraction : {0.125, 0.5, 0.75}) {
    player.seek(fraction);
    const PlayedVolumes played = bench.show(fraction * player.periodSeconds());
    EXPECT_EQ(played.milliliters, player.runner().volumesMl()) << fraction;
    EXPECT_EQ(bench.organs().shownPose(), window.live.shownPose()) << fraction;
    EXPECT_TRUE(played.obstacle.empty());
  }
  EXPECT_EQ(*bench.state().pose, *savedState().pose) << "playing changes no document";
}

TEST(Workbench, MeasuresACycleWithoutPlayingIt) {
  Workbench bench;
  bench.restore(kSession);
  bench.lock("ball", false);
  const Points shown = bench.organs().shownPose();
  const live::CycleCurves curves = bench.cycle();
  EXPECT_EQ(bench.organs().shownPose(), shown);
  ASSERT_EQ(curves.milliliters.size(), 1u);
  const PlayedVolumes played = bench.show(curves.fractions[30] * bench.motion().periodSeconds());
  EXPECT_EQ(played.milliliters.front(), curves.milliliters.front()[30]);
}

TEST(Workbench, TellsOnceOfEveryCallThatChangedSomething) {
  Workbench bench;
  bench.restore(kSession);
  int told = 0;
  const Subscription subscription = bench.onHappened([&] { ++told; });
  const double before = bench.volume("ball").nowMl;
  EXPECT_EQ(told, 0);
  bench.lock("ball", false);
  EXPECT_EQ(told, 1);
  bench.drag(firstLabel(bench), kBy);
  EXPECT_EQ(told, 2);
  EXPECT_NE(bench.volume("ball").nowMl, before);
  bench.play(5);
  EXPECT_EQ(told, 3);
  bench.undo();
  bench.redo();
  EXPECT_EQ(told, 5);
  EXPECT_FALSE(bench.redo());
  EXPECT_EQ(told, 5);
}

TEST(Workbench, PosesAllHandlesAndKeepsALockedVolume) {
  Workbench bench;
  bench.restore(kSession);
  const double volume = bench.volume("ball").nowMl;
  Points places = *bench.state().pose;
  places.row(9) += Vec3(4, 4, 0).transpose();
  bench.pose(places);
  EXPECT_NEAR(bench.volume("ball").nowMl, volume, 1e-6);
  bench.lock("ball", false);
  bench.pose(places);
  EXPECT_EQ(*bench.state().pose, places);
  EXPECT_THROW(bench.pose(Points::Zero(3, 3)), DataError);
  bench.rest();
  EXPECT_EQ(*bench.state().pose, bench.state().rig->restPositions());
}

TEST(Workbench, ListsTheNamesWhereOneIsUnknown) {
  Workbench bench;
  bench.restore(kSession);
  try {
    bench.lock("bal");
    FAIL() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("\"bal\""), std::string::npos);
    EXPECT_NE(error.tryThis().english().find("ball"), std::string::npos);
  }
  EXPECT_THROW(bench.drag("no handle", kBy), UsageError);
  EXPECT_THROW(bench.measure("no measurement"), UsageError);
  EXPECT_THROW(Workbench().show(0), UsageError) << "nothing moves";
}

TEST(Workbench, SavesTheViewOfTheSessionWithTheDocument) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "saved.viscera";
  Workbench bench;
  bench.restore(kSession);
  const nlohmann::ordered_json view = bench.session().view;
  ASSERT_TRUE(view.contains("camera"));
  bench.drag(firstLabel(bench), kBy);
  EXPECT_FALSE(bench.steps().isClean());
  bench.save(file);
  EXPECT_TRUE(bench.steps().isClean());
  Workbench again;
  again.restore(file);
  EXPECT_EQ(*again.state().pose, *bench.state().pose);
  EXPECT_EQ(again.state().organs->front()->mesh->points, bench.state().organs->front()->mesh->points);
  EXPECT_EQ(again.session().view.dump(), view.dump());
  EXPECT_EQ(again.volume("ball").nowMl, bench.volume("ball").nowMl);
}

TEST(Workbench, MeasuresStressAndDistancesInThePose) {
  Workbench bench;
  document::SessionContents contents;
  contents.state = tests::Session().document.state();
  bench.restore(contents);
  const document::Organ& ball = *bench.state().organs->front();
  bench.perform(document::addMeasurement(
      {document::nearestPoint(ball, Vec3(40, 0, 0)), document::nearestPoint(ball, Vec3(-40, 0, 0))},
      "Width"));
  EXPECT_NEAR(bench.stress("Ball", 300).statistics().max, 0, 1e-9);
  EXPECT_EQ(bench.measure("Width").rest, bench.measure("Width").now);
  bench.drag(bench.state().rig->handles.at(9).label, Vec3(20, 0, 0));
  EXPECT_GT(bench.stress("Ball", 300).statistics().max, 0.01);
  EXPECT_NE(bench.measure("Width").rest, bench.measure("Width").now);
}

TEST(Workbench, OpensASurfaceWithHandlesAndUndoesIt) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "tetrahedron.obj";
  std::ofstream(file) << "v 0 0 0\nv 60 0 0\nv 0 60 0\nv 0 0 60\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  Workbench bench;
  bench.open({file});
  ASSERT_EQ(bench.state().organs->size(), 1u);
  EXPECT_GE(bench.state().rig->handles.size(), 8u);
  const std::string name = bench.state().organs->front()->name;
  EXPECT_NEAR(bench.volume(name).nowMl, 36, 1e-9);
  EXPECT_TRUE(bench.undo());
  EXPECT_TRUE(bench.state().organs->empty());
  EXPECT_THROW(bench.open({folder.path() / "none.obj"}), NoInputError);
}

TEST(Workbench, AnOpenedSampleKeepsItsMotionInItsSession) {
  const tests::TemporaryFolder folder;
  Workbench bench;
  bench.openSample("liver", sample_organs::Resolution::low);
  ASSERT_TRUE(bench.sequence());
  EXPECT_EQ(bench.sequence()->id(), "breathing");
  EXPECT_FALSE(bench.undo()) << "nothing was done yet";
  bench.save(folder.path() / "liver.viscera");
  Workbench again;
  again.restore(folder.path() / "liver.viscera");
  EXPECT_EQ(again.show(1).milliliters, bench.show(1).milliliters);
}

TEST(Workbench, IsCancelledByItsProgress) {
  Progress progress;
  Workbench bench(workbench::Setup(), &progress);
  bench.restore(kSession);
  progress.cancel();
  EXPECT_THROW(bench.play(10), Cancelled);
  EXPECT_THROW(bench.stress("ball", 300), Cancelled);
}

} // namespace viscera::workbench
