#include "play_fixture.h"

#include <QTest>

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "session_fixture.h"
#include "viscera/document/organ_commands.h"
#include "window/compare/comparison.h"
#include "window/session/session_files.h"

namespace viscera::tests {
namespace {

using Json = nlohmann::ordered_json;
using What = presentation::Compared::What;

bool hasJob(const JobQueue& queue, const char* slot) {
  const std::vector<JobInfo> jobs = queue.jobs();
  return std::any_of(jobs.begin(), jobs.end(), [slot](const JobInfo& job) { return job.slot == slot; });
}

/// A session that is saved while parts of it are still being created: nothing is lost.
class UnfinishedSession : public PlayMode {
protected:
  app::Comparison& comparison() { return parts().comparison(); }
  Json view() { return window().sessions().contents().view; }

  QString save() {
    bool done = false;
    const QString file = path(QStringLiteral("beat.viscera"));
    window().sessions().saveTo(file, false, [&] { done = true; });
    EXPECT_TRUE(waitUntil([&] { return done; })) << message().toStdString();
    return file;
  }
  /// Opens a session in another window and returns what would be saved when a job of that slot is queued.
  Json viewDuring(const QString& file, const char* slot) {
    reopenWindow();
    std::optional<Json> seen;
    const auto look = [&](const JobQueue& queue) {
      if (!seen && hasJob(queue, slot))
        seen = view();
    };
    const Subscription first =
        window().workspace().jobs().onChange([&] { look(window().workspace().jobs()); });
    window().sessions().open(file);
    EXPECT_TRUE(waitUntil([&] { return seen.has_value(); })) << message().toStdString();
    return seen.value_or(Json());
  }
  void waitForSecond() {
    ASSERT_TRUE(comparison().on());
    app::Workspace& second = comparison().workspace();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !second.document().organs().empty() && second.jobs().idle() && !second.live().busy(); },
        120000));
    settle();
  }
};

TEST_F(UnfinishedSession, HasTheMotionsThatAreStillCreated) {
  window().playback().setRate(90);
  window().playback().seek(0.25);
  comparison().showSameOrgan();
  waitForSecond();
  const QString file = save();
  const Json before = view();
  ASSERT_EQ(before["motions"].size(), 1u);
  const Json during = viewDuring(file, "motions");
  EXPECT_EQ(window().playback().sequence(), nullptr) << "the test looks too late";
  for (const char* key : {"motions", "playing", "compared", "shownPose"})
    EXPECT_EQ(during.value(key, Json()), before[key]) << key;
  ASSERT_TRUE(waitUntil([this] { return window().playback().showing(); }));
  settle();
  for (const char* key : {"motions", "playing", "compared", "shownPose"})
    EXPECT_EQ(view().value(key, Json()), before[key]) << key;
}

TEST_F(UnfinishedSession, LeavesOutTheMotionOfAnOrganThatIsGone) {
  const QString file = save();
  reopenWindow();
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([this] { return hasJob(window().workspace().jobs(), "motions"); }));
  ASSERT_TRUE(window().workspace().perform(document::removeAllOrgans()));
  const Json during = view();
  EXPECT_TRUE(during["motions"].empty());
  EXPECT_FALSE(during.contains("playing"));
  settle();
  EXPECT_EQ(window().playback().sequence(), nullptr);
}

TEST_F(UnfinishedSession, HasTheSampleThatIsStillLoadedBesideIt) {
  comparison().showSample(QStringLiteral("kidney_left"));
  const auto asked = comparison().compared();
  ASSERT_TRUE(asked) << "it is being loaded";
  EXPECT_EQ(asked->name, "kidney_left");
  waitForSecond();
  const QString file = save();
  const Json before = view();
  reopenWindow();
  std::optional<presentation::Compared> during;
  Subscription jobs;
  const QObject scope;
  QObject::connect(&comparison(), &app::Comparison::toggled, &scope, [&] {
    jobs = comparison().workspace().jobs().onChange([&] {
      if (!during && hasJob(comparison().workspace().jobs(), "open"))
        during = comparison().compared();
    });
  });
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([&] { return during.has_value(); })) << message().toStdString();
  EXPECT_EQ(during->what, What::sample);
  EXPECT_EQ(during->name, "kidney_left");
  waitForSecond();
  EXPECT_EQ(view()["compared"], before["compared"]);
}

TEST_F(UnfinishedSession, HasTheSampleBesideItWhoseSuccessorWasCancelled) {
  comparison().showSample(QStringLiteral("kidney_left"));
  waitForSecond();
  comparison().showSample(QStringLiteral("liver"));
  EXPECT_EQ(comparison().compared()->name, "liver");
  comparison().workspace().jobs().cancelAll();
  waitForSecond();
  ASSERT_TRUE(comparison().compared());
  EXPECT_EQ(comparison().compared()->name, "kidney_left");
}

TEST_F(UnfinishedSession, ASampleThatStillLoadsDoesNotReplaceWhatIsChosenAfterIt) {
  comparison().showSample(QStringLiteral("kidney_left"));
  comparison().showSameOrgan();
  waitForSecond();
  QTest::qWait(300);
  waitForSecond();
  EXPECT_EQ(comparison().workspace().document().organs(), document().organs());
  EXPECT_EQ(comparison().compared()->what, What::rate);
}

TEST_F(UnfinishedSession, HasThePrescribedVolumeThatWaitsForItsOrgan) {
  prescribeLeftVentricle();
  const QString file = save();
  const Json before = view();
  reopenWindow();
  Json during;
  const QObject scope;
  QObject::connect(&window().playback(), &app::Playback::stateChanged, &scope, [&] {
    if (window().workspace().live().busy() && window().playback().showing())
      during = view();
  });
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([this] { return hasJob(window().workspace().jobs(), "motions"); }));
  // So large that it is bound by a job, after the motion has been created.
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("other", 10, 6, Vec3(0, 0, 200))})));
  ASSERT_TRUE(waitUntil([&] { return window().playback().player().runner().prescribed().has_value(); }))
      << message().toStdString();
  ASSERT_FALSE(during.is_null()) << "the organs were bound at once";
  EXPECT_EQ(during["playing"]["prescribed"], before["playing"]["prescribed"]);
  settle();
  EXPECT_EQ(view()["shownPose"], before["shownPose"]);
}

} // namespace
} // namespace viscera::tests
