#include "stress_fixture.h"

#include <QAction>
#include <QEventLoop>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <chrono>
#include <cmath>
#include <thread>

#include "sway.h"
#include "viscera/document/organ_commands.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/stress/stress_chart.h"
#include "window/timeline/chart_cursor.h"

namespace viscera::tests {
namespace {

/// The map over the cycle of a sequence.
class StressOverACycle : public StressModeTest {
protected:
  /// A sequence that swings the first handle that far, mm.
  std::shared_ptr<Sway> swing(double mm) {
    return std::make_shared<Sway>(document().rig().restPositions(), std::vector<Swing>{{0, Vec3(mm, 0, 0)}});
  }
  void give(const std::shared_ptr<Sway>& sequence) {
    window().playback().setSequence(sequence, document().organs().front()->id);
  }
  app::StressChart& chart() { return *window().findChild<app::StressChart*>(); }
  bool drawn(const std::shared_ptr<const live::CycleStress>& than) {
    return waitUntil([&] {
      return model().cycle() && model().cycle() != than && chart().drawnCycle() == model().cycle();
    });
  }
  /// The cycle's curve is what the map says at the instants that are shown.
  void expectTheCurveIsWhatIsShown() {
    const auto cycle = model().cycle();
    ASSERT_TRUE(cycle);
    EXPECT_EQ(cycle->periodSeconds, window().playback().player().periodSeconds());
    for (const std::size_t instant : {std::size_t{5}, cycle->samples.size() / 3, cycle->samples.size() - 1}) {
      window().playback().seek(cycle->samples[instant].seconds / cycle->periodSeconds);
      EXPECT_NEAR(model().live().statistics().max, cycle->samples[instant].statistics.max, 1e-9) << instant;
      EXPECT_NEAR(model().live().statistics().mean, cycle->samples[instant].statistics.mean, 1e-9) << instant;
    }
  }
};

TEST_F(StressOverACycle, IsDrawnWholeBeforeAFrameWasPlayed) {
  give(swing(30));
  enter();
  window().playback().seek(0);
  ASSERT_TRUE(drawn(nullptr));
  EXPECT_GE(model().cycle()->samples.size(), 60u);
  EXPECT_GT(model().peakInstant()->statistics.max, 0.01);
  EXPECT_FALSE(model().peakShown()) << "the map of the instant stays";
  EXPECT_TRUE(window().actions()["stress.exportCurve"]->isEnabled());
  expectTheCurveIsWhatIsShown();
}

/// The view then shows the sequence, and no handles.
TEST_F(StressOverACycle, OfASequenceThatStartsDuringADragUndoesTheDrag) {
  give(swing(30));
  enter();
  const Points before = document().pose();
  const std::size_t steps = window().workspace().undo().names().size();
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const QPoint from = onScreen(handleInView(handle));
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(20, 0));
  QTest::mouseMove(&view(), from + QPoint(40, 0));
  ASSERT_NE(document().pose(), before);
  key(Qt::Key_Space);
  EXPECT_TRUE(window().playback().player().playing());
  EXPECT_EQ(document().pose(), before);
  EXPECT_FALSE(view().view().handleWidget()->IsDragging());
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 0));
  key(Qt::Key_Space);
  settle();
  EXPECT_EQ(document().pose(), before);
  EXPECT_EQ(window().workspace().undo().names().size(), steps);
}

TEST_F(StressOverACycle, HasACursorAtTheInstantInEveryFrame) {
  give(swing(30));
  enter();
  window().playback().seek(0.25);
  ASSERT_TRUE(drawn(nullptr));
  auto* cursor = chart().findChild<app::ChartCursor*>();
  ASSERT_NE(cursor, nullptr);
  ASSERT_TRUE(waitUntil([&] { return !cursor->marks().lines.empty(); }));
  settle(); // The chart has its place.
  const auto at = [&](double fraction) {
    window().playback().seek(fraction);
    return cursor->marks().lines.empty() ? -1 : cursor->marks().lines.front().x;
  };
  const double left = at(0), right = at(0.8);
  ASSERT_GT(right, left + 0.2);
  window().playback().toStart();
  window().playback().play();
  for (int frame = 0; frame < 8; ++frame) {
    now_ += 0.03;
    window().playback().advance(); // No event is handled: on a busy machine those wait.
    const double fraction = window().playback().player().fraction();
    ASSERT_EQ(cursor->marks().lines.size(), 1u);
    EXPECT_NEAR(cursor->marks().lines.front().x, left + (right - left) * fraction / 0.8, 1e-3);
  }
  window().playback().stop();
  EXPECT_TRUE(waitUntil([&] { return cursor->marks().lines.empty(); })) << "the own pose is at no instant";
}

TEST_F(StressOverACycle, HasItsNumbersInEveryFrameOfABusyMachine) {
  give(swing(30));
  enter();
  window().playback().seek(0.25);
  settle();
  // A frame takes longer than the timer of the frames waits for the next one.
  const Subscription slow = window().workspace().live().onEvent([](const live::LiveEvent& event) {
    if (event.moved)
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
  });
  constexpr int kFrames = 12;
  int frames = 0, told = 0;
  QEventLoop loop;
  QObject::connect(&window().playback(), &app::Playback::advanced, &loop, [&] {
    now_ += 0.02;
    if (++frames >= kFrames)
      loop.quit();
  });
  QObject::connect(&model(), &app::StressModel::numbersChanged, &loop, [&] { ++told; });
  QTimer::singleShot(20000, &loop, &QEventLoop::quit);
  window().playback().play();
  now_ += 0.02;
  loop.exec();
  window().playback().pause();
  EXPECT_GE(frames, kFrames);
  EXPECT_GE(told, kFrames / 2);
}

TEST_F(StressOverACycle, IsOfTheRateAndTheSequenceThatAreThere) {
  give(swing(30));
  enter();
  window().playback().seek(0);
  ASSERT_TRUE(drawn(nullptr));
  window().actions()["stress.peak"]->trigger();
  settle();
  ASSERT_TRUE(model().peakShown());
  const auto first = model().cycle();
  const double period = first->periodSeconds;
  window().playback().setRate(2 * window().playback().player().ratePerMinute());
  ASSERT_TRUE(drawn(first));
  EXPECT_NEAR(model().cycle()->periodSeconds, period / 2, 1e-12);
  EXPECT_TRUE(model().peakShown()) << "of the other rate";
  const auto second = model().cycle();
  give(swing(10));
  window().playback().seek(0);
  ASSERT_TRUE(drawn(second));
  EXPECT_LT(model().peakInstant()->statistics.max,
            first->samples[model().cycle()->samples.size() / 4].statistics.max);
  expectTheCurveIsWhatIsShown();
  window().playback().forgetAll();
  ASSERT_TRUE(waitUntil([this] { return !model().cycle(); }));
  EXPECT_FALSE(model().peakShown());
  EXPECT_FALSE(window().actions()["stress.exportCurve"]->isEnabled());
}

TEST_F(StressOverACycle, KeepsALockedVolumeAsThePlayingOrganDoes) {
  give(swing(30));
  enter();
  window().playback().seek(0);
  ASSERT_TRUE(drawn(nullptr));
  const auto free = model().cycle();
  window().workspace().perform(document::setVolumeLocked(document().organs().front()->id, true));
  ASSERT_TRUE(drawn(free));
  const std::size_t quarter = free->samples.size() / 4;
  EXPECT_GT(
      std::abs(model().cycle()->samples[quarter].statistics.mean - free->samples[quarter].statistics.mean),
      1e-6)
      << "the lock moves handles";
  expectTheCurveIsWhatIsShown();
}

TEST_F(StressOverACycle, MovesTheMapWhileItPlaysAndHasAPeak) {
  enter();
  give(swing(30));
  settle();
  key(Qt::Key_Space);
  EXPECT_EQ(window().mode(), "stress");
  for (int frame = 0; frame < 12; ++frame) {
    now_ += 0.02;
    window().playback().advance();
  }
  EXPECT_GT(model().shown().summary().max, 0.5);
  key(Qt::Key_Space);
  // The maximum over the cycle is at least the map of every instant.
  const Values now = *model().shown().values();
  window().actions()["stress.peak"]->trigger();
  ASSERT_TRUE(waitUntil([this] { return model().peakShown(); }));
  const Eigen::Index witnesses = model().live().mesh()->witnesses;
  EXPECT_GE((*model().shown().values() - now).minCoeff(), -0.2);
  EXPECT_GT(model().shown().summary().max, now.head(witnesses).maxCoeff() - 0.2);
  // Each value of the card is the extreme of its own instant, and is called so.
  model().setProbe(0);
  settle();
  QStringList names;
  for (const QLabel* name : window().findChildren<QLabel*>(QStringLiteral("muted")))
    names << name->text();
  for (const live::StressQuantityDescription& quantity : live::stressQuantities())
    EXPECT_TRUE(names.contains(QString::fromStdString(quantity.peakName))) << quantity.peakName;
  model().setProbe(-1);
  // The maximum's instant is that of the largest value of the cycle.
  EXPECT_TRUE(find<QLabel>("stressPeakTime")->isVisible());
  const double largest = model().peakInstant()->statistics.max;
  for (const live::StressSample& sample : model().cycle()->samples)
    EXPECT_LE(sample.statistics.max, largest);
  window().actions()["stress.peakTime"]->trigger();
  settle();
  EXPECT_FALSE(model().peakShown());
  EXPECT_NEAR(model().live().statistics().max, largest, 1e-9);
  window().actions()["stress.peak"]->trigger();
  settle();
  EXPECT_TRUE(model().peakShown());
  // Back to the own pose, which is at rest.
  window().actions()["stress.peak"]->trigger();
  QTest::mouseClick(find<QPushButton>("stressOwnPose"), Qt::LeftButton);
  settle();
  EXPECT_LT(model().shown().summary().max, 1e-6);
}

/// A second view, which follows in the midst of a change, lets the playback tell its state while the picture
/// still has the organ before.
TEST_F(StressOverACycle, NumbersAreThoseOfThePictureWhileTheOrganChanges) {
  open(sphereFile(QStringLiteral("other.stl"), 50));
  const document::OrganId first = document().organs().front()->id, other = document().organs().back()->id;
  window().workspace().selection().clear();
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans({first})));
  enter();
  ASSERT_EQ(model().live().organ(), other);
  ASSERT_TRUE(find<QLabel>("stressMax")->isVisible());
  bool withoutMesh = false, oldNumbers = false;
  const Subscription told = window().workspace().onChange([&](const document::Change&) {
    withoutMesh = !model().live().mesh();
    oldNumbers = model().shown().ready();
    Q_EMIT window().playback().stateChanged();
  });
  window().workspace().undo().undo();
  EXPECT_TRUE(withoutMesh) << "the organ that is back has none yet";
  EXPECT_FALSE(oldNumbers) << "of the organ that was drawn before";
  EXPECT_EQ(model().live().organ(), first);
  EXPECT_EQ(label("stressMax"), QStringLiteral("-"));
  ASSERT_TRUE(waitUntil([this] { return model().shown().ready(); }));
}

} // namespace
} // namespace viscera::tests
