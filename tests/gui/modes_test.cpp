// What every mode promises, whichever it is.
#include <memory>

#include <QAction>
#include <QLabel>
#include <QToolButton>

#include "click_mode.h"
#include "play_fixture.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/modes/mode_controller.h"

namespace viscera::tests {
namespace {

class Modes : public WindowTest {
protected:
  const presentation::ViewState& state() { return window().viewModel().state(); }
  QStringList pressedButtons() {
    QStringList pressed;
    for (const auto* button : window().findChildren<QToolButton*>(QStringLiteral("modeButton")))
      if (button->isChecked())
        pressed.push_back(button->property("mode").toString());
    return pressed;
  }
};

TEST_F(Modes, TheViewHasWhatThePresentModeWantsAndTheRailShowsIt) {
  open(sphereFile());
  for (const auto& mode : window().modes().all()) {
    const app::Mode::Description& it = mode->description();
    key(static_cast<Qt::Key>(Qt::Key_0 + it.key));
    EXPECT_EQ(state().mode, it.id);
    EXPECT_EQ(state().shown, mode->shown()) << it.id;
    EXPECT_EQ(pressedButtons(), QStringList(QString::fromLatin1(it.id)));
  }
}

TEST_F(Modes, AModeThatIsNotThereIsExplore) {
  window().setMode("deform");
  window().setMode("of another version");
  EXPECT_EQ(window().mode(), "explore");
}

TEST_F(Modes, ADragEndsAndIsTakenBackWhenTheModeChanges) {
  open(sphereFile());
  window().setMode("deform");
  settle();
  const Points before = document().pose();
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const QPoint from = onScreen(handleInView(handle));
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(20, 10));
  QTest::mouseMove(&view(), from + QPoint(40, 20));
  ASSERT_NE(document().pose(), before);
  window().setMode("handles");
  EXPECT_EQ(document().pose(), before);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 20));
  EXPECT_FALSE(window().workspace().undo().canUndo() && window().workspace().undo().stepOpen());
}

/// The parts that the window's modes have.
struct PartsOfModes : app::Mode {
  static const app::ModeParts& of(const app::Mode& mode) { return mode.*(&PartsOfModes::parts_); }
};

TEST_F(Modes, TheExampleOfTheDeveloperGuideSaysWhereAnOrganWasClicked) {
  open(sphereFile());
  app::ClickMode mode(PartsOfModes::of(window().modes().present()));
  const std::unique_ptr<QWidget> page(mode.makePage(window().actions()));
  const auto* said = qobject_cast<QLabel*>(page.get());
  ASSERT_TRUE(said);
  EXPECT_EQ(said->text(), "Nothing was clicked");
  const app::ClickedPlace place{document().organs().front()->id, Vec3(1.5, -2, 30.5)};
  mode.click(&place);
  EXPECT_EQ(said->text(), "1.5, -2.0, 30.5 mm (LPS)");
  EXPECT_EQ(window().workspace().selection().organ(), place.organ);
}

/// The window's own panels know the modes that it was made with, so the example has a controller beside
/// theirs, at the same view.
TEST_F(Modes, TheExampleOfTheDeveloperGuideTakesClicksOnTheView) {
  open(sphereFile());
  const app::ModeParts& parts = PartsOfModes::of(window().modes().present());
  const app::ModeController::Parts uses{parts.playback, parts.view, *parts.area.view(), parts.picture,
                                        parts.handles};
  auto* modes = new app::ModeController(uses, &window());
  app::ClickMode& mode = modes->add(std::make_unique<app::ClickMode>(parts));
  const std::unique_ptr<QWidget> page(mode.makePage(window().actions()));
  const auto* said = qobject_cast<QLabel*>(page.get());
  ASSERT_TRUE(said);
  EXPECT_EQ(state().mode, "click");
  settle();
  click(QPoint(5, view().height() / 2));
  EXPECT_EQ(said->text(), "Nothing was clicked") << "beside the organ";
  click(view().rect().center());
  const QStringList numbers = said->text().remove(QStringLiteral(" mm (LPS)")).split(QStringLiteral(", "));
  ASSERT_EQ(numbers.size(), 3) << said->text().toStdString();
  const Vec3 place(numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble());
  EXPECT_NEAR(place.norm(), 60, 1) << said->text().toStdString() << " is not on the ball";
}

using ModesOfAMotion = PlayMode;

TEST_F(ModesOfAMotion, HandlesInStressModeCannotBeGrabbedWhileTheTimelineIsLookedAt) {
  const auto anyLocked = [this] {
    return view().view().handles()->GetHandleLocked(0) || !window().viewModel().state().shown.movable;
  };
  window().setMode("stress");
  EXPECT_FALSE(anyLocked());
  window().playback().seek(0.3); // Without playing.
  EXPECT_TRUE(anyLocked());
  window().playback().stop();
  EXPECT_FALSE(anyLocked());
}

} // namespace
} // namespace viscera::tests
