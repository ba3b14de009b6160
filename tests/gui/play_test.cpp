#include "window_test.h"

#include <QAbstractButton>
#include <QTest>

#include "viscera/organs/sample_organ.h"
#include "window/timeline/phase_scrubber.h"

namespace viscera::tests {
namespace {

/// The window as it starts: the sample heart with its motion.
class PlayMode : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().samples().load(QStringLiteral("heart"), false);
    ASSERT_TRUE(QTest::qWaitFor([this] { return window().playback().sequence() != nullptr; }, 120000))
        << message().toStdString();
    settle();
    key(Qt::Key_5);
    ASSERT_EQ(window().mode(), app::Mode::play);
  }
  double volumeOf(const char* name) {
    for (const auto& organ : document().organs())
      if (organ->name == name)
        return window().workspace().live().volume(organ->id).nowMl;
    ADD_FAILURE() << "no organ " << name;
    return 0;
  }
  /// Lets the test's clock run and the window play as long.
  void playFor(double seconds) {
    for (double end = now_ + seconds; now_ < end;) {
      now_ += 1.0 / 30;
      window().playback().advance();
      QTest::qWait(1);
    }
  }
};

TEST_F(PlayMode, SpacePlaysAndTheVolumesFollowTheBeat) {
  key(Qt::Key_Space);
  ASSERT_TRUE(window().playback().player().playing());
  double smallest = 1e9;
  double largest = 0;
  for (int i = 0; i < 30; ++i) {
    playFor(1.0 / 30);
    smallest = std::min(smallest, volumeOf("LV"));
    largest = std::max(largest, volumeOf("LV"));
  }
  EXPECT_NEAR(largest, 130.5, 1);
  EXPECT_NEAR(smallest, 55, 2);
  key(Qt::Key_Space);
  EXPECT_FALSE(window().playback().player().playing());
  EXPECT_EQ(window().workspace().undo().names().size(), 1u) << "playing leaves no undo steps";
}

TEST_F(PlayMode, TheTimelineLooksAtOneInstant) {
  auto* scrubber = window().findChild<app::PhaseScrubber*>();
  ASSERT_NE(scrubber, nullptr);
  QTest::mouseClick(scrubber, Qt::LeftButton, Qt::NoModifier,
                    QPoint(8 + (scrubber->width() - 16) / 2, scrubber->height() / 2));
  settle();
  EXPECT_NEAR(window().playback().player().fraction(), 0.5, 0.02);
  EXPECT_LT(volumeOf("LV"), 62) << "the middle of the cycle is the end of systole";
  EXPECT_FALSE(scrubber->phaseName().isEmpty());
}

TEST_F(PlayMode, OneFrameForwardAndBackIsTheSameInstant) {
  window().playback().seek(0.2);
  const double before = volumeOf("LV");
  key(Qt::Key_Period);
  EXPECT_NE(volumeOf("LV"), before);
  key(Qt::Key_Comma);
  EXPECT_NEAR(volumeOf("LV"), before, 1e-6);
}

TEST_F(PlayMode, EditingTheHandlesEndsTheMotionAndOffersItsOwnHandlesAgain) {
  key(Qt::Key_Space);
  playFor(0.1);
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_Delete);
  EXPECT_FALSE(window().playback().player().playing());
  key(Qt::Key_Space);
  EXPECT_FALSE(window().playback().player().playing());
  auto* offer = window().findChild<QAbstractButton*>(QStringLiteral("offer"));
  ASSERT_NE(offer, nullptr) << message().toStdString();
  offer->click();
  settle();
  EXPECT_TRUE(window().playback().player().playing());
}

TEST_F(PlayMode, OpeningAFileTakesThePlaceOfTheSampleAndUndoBringsItBackWithItsMotion) {
  key(Qt::Key_Space);
  open(sphereFile());
  EXPECT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(window().playback().sequence(), nullptr);
  EXPECT_FALSE(window().playback().player().playing());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().organs().size(), 3u);
  EXPECT_NE(window().playback().sequence(), nullptr);
}

TEST_F(PlayMode, UndoOfOpeningAFileIsHeardByEveryPanelThoughTheSelectionGoesWithIt) {
  key(Qt::Key_2);
  ASSERT_EQ(window().mode(), app::Mode::handles);
  open(sphereFile());
  session::Selection& selection = window().workspace().selection();
  ASSERT_TRUE(selection.organ());
  selection.setHandles({document().rig().handles.front().id});
  settle();
  window().workspace().undo().undo();
  EXPECT_EQ(document().organs().size(), 3u);
  EXPECT_FALSE(selection.organ());
  EXPECT_TRUE(selection.handles().empty());
  selection.setHandles({document().rig().handles.front().id});
  settle();
  window().workspace().undo().redo();
  EXPECT_EQ(document().organs().size(), 1u);
}

} // namespace
} // namespace viscera::tests
