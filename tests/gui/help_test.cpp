#include "window_test.h"

#include <QAction>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTest>

#include "window/widgets/help_cards.h"
#include "window/widgets/pointing_frame.h"

namespace viscera::tests {
namespace {

class Tour : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().setMode("play");
    chooseSequence("heartbeat");
    settle();
    window().findChild<QAction*>(QStringLiteral("help.tour"))->trigger();
    settle();
  }

  app::TourCard& card() { return *window().findChild<app::TourCard*>(); }
  QList<app::PointingFrame*> frames() { return window().findChildren<app::PointingFrame*>(); }
  QRect placeOf(QWidget& widget) { return {widget.mapTo(&window(), QPoint(0, 0)), widget.size()}; }
  /// Whether every frame lies just around what it is for.
  bool framesFit() {
    for (app::PointingFrame* frame : frames())
      if (!frame->isVisible() || frame->geometry() != placeOf(*frame->target()))
        return false;
    return !frames().isEmpty();
  }
  void next() {
    for (QPushButton* button : card().findChildren<QPushButton*>())
      if (button->objectName() == QLatin1String("primary"))
        QTest::mouseClick(button, Qt::LeftButton);
    settle();
  }
};

TEST_F(WindowTest, TheWelcomeLeavesMostOfASmallViewFree) {
  window().resize(window().minimumSizeHint().width(), 600);
  window().showWelcome(true);
  settle();
  const auto& card = *window().findChild<app::WelcomeCard*>();
  const auto buttons = card.findChildren<QPushButton*>();
  ASSERT_EQ(buttons.size(), 3);
  EXPECT_LE(card.height(), window().viewArea().height() / 3);
  EXPECT_TRUE(buttons[1]->isVisible()) << "the samples";
  window().resize(1280, 800);
  settle();
  for (const QPushButton* button : buttons)
    EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
}

TEST_F(Tour, FramesWhatEachStepSpeaksOfAndCoversNothingOfIt) {
  for (const app::TourStep& step : card().steps()) {
    const std::string title = step.title.toStdString();
    ASSERT_FALSE(step.targets.isEmpty()) << title;
    EXPECT_EQ(frames().size(), step.targets.size()) << title << ": a target is missing";
    EXPECT_TRUE(waitUntil([this] { return framesFit(); })) << title;
    for (app::PointingFrame* frame : frames())
      EXPECT_TRUE(frame->target() == &view() || // Which is large, and has the card in it.
                  !placeOf(*frame->target()).intersects(placeOf(card())))
          << title;
    next();
  }
  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(frames().isEmpty());
}

TEST_F(Tour, FramesFollowTheWindowTakeNoClicksAndEndWithEscape) {
  next();
  ASSERT_TRUE(waitUntil([this] { return framesFit(); }));
  const QRect before = frames().front()->geometry();
  window().resize(window().width() - 120, window().height() - 40);
  EXPECT_TRUE(waitUntil([&] { return framesFit() && frames().front()->geometry() != before; }));
  QWidget* target = frames().front()->target();
  EXPECT_TRUE(target == window().childAt(placeOf(*target).center()) ||
              target->isAncestorOf(window().childAt(placeOf(*target).center())));
  key(Qt::Key_Escape);
  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(frames().isEmpty());
}

TEST_F(Tour, LetsTheWindowHideEveryFrameBeforeItTakesThemAway) {
  next();
  ASSERT_TRUE(waitUntil([this] { return framesFit(); }));
  const QPointer<app::PointingFrame> frame = frames().front();
  ASSERT_TRUE(window().close());
  // Qt goes through a list of the children while it hides them: each has to be there until it is through.
  EXPECT_FALSE(frame.isNull()) << "the window hid a child that was gone";
  settle();
  EXPECT_TRUE(frame.isNull());
}

TEST_F(Tour, MayBeUnderWayWhenTheWindowEnds) {
  next();
  ASSERT_TRUE(waitUntil([this] { return framesFit(); }));
  const QPointer<app::PointingFrame> frame = frames().front();
  endWindow();
  EXPECT_TRUE(frame.isNull()) << "the window takes its frames with it";
}

} // namespace
} // namespace viscera::tests
