#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QTest>

#include <functional>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "play_fixture.h"
#include "viscera/document/organ_commands.h"
#include "window/circulation/circulation_panel.h"
#include "window/compare/comparison.h"
#include "window/lecture/lecture_signs.h"
#include "window/lecture/slides.h"
#include "window/modes/window_layout.h"
#include "window/session/session_files.h"
#include "window/stress/stress_mode.h"
#include "window/style/language.h"
#include "window/view/view_actions.h"
#include "window/view/view_area.h"

namespace viscera::tests {
namespace {

/// The window as it gives room to the view: panels of modes, the whole screen, slides.
class Room : public PlayMode {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  bool shown(const char* panel) {
    return window().findChild<QDockWidget*>(QLatin1String(panel))->isVisible();
  }
  Vec3 eye() { return Vec3(view().view().renderer()->GetActiveCamera()->GetPosition()); }
  QString caption() { return window().findChild<QLabel*>(QStringLiteral("lectureCaption"))->text(); }
  QString numbers() {
    return window()
        .findChild<QLabel*>(QStringLiteral("lectureNumbers"))
        ->text()
        .replace(QChar(QChar::Nbsp), QLatin1Char(' '));
  }
};

TEST_F(Room, AModeShowsThePanelsItHasAUseFor) {
  EXPECT_TRUE(shown("timeline") && shown("volumes"));
  EXPECT_FALSE(shown("handles"));
  const int inPlay = view().height();
  key(Qt::Key_2);
  EXPECT_TRUE(shown("handles"));
  EXPECT_FALSE(shown("timeline") || shown("volumes"));
  EXPECT_GT(view().height(), 1.3 * inPlay) << "what folds away is the view's";
  key(Qt::Key_1);
  EXPECT_TRUE(shown("timeline")) << "the heart still beats";
  EXPECT_FALSE(shown("handles") || shown("volumes"));
  EXPECT_TRUE(shown("organs") && shown("properties"));
}

TEST_F(Room, TheChartKeepsItsHeightOnAWalkThroughTheModesAndIsAwayWhereItIsEmpty) {
  auto* chart = window().findChild<QDockWidget*>(QStringLiteral("volumes"));
  const int height = chart->height();
  key(Qt::Key_3);
  EXPECT_NEAR(chart->height(), height, 4);
  key(Qt::Key_4);
  EXPECT_NEAR(chart->height(), height, 4)
      << "it is there before a drag along the timeline shows the sequence";
  key(Qt::Key_1);
  EXPECT_FALSE(chart->isVisible()) << "nothing is charted";
  key(Qt::Key_3);
  key(Qt::Key_5);
  EXPECT_NEAR(chart->height(), height, 4) << "the timeline took its room from the view";
  window().playback().seek(0.3);
  key(Qt::Key_4);
  EXPECT_TRUE(chart->isVisible()) << "the map is of the sequence";
}

TEST_F(Room, APanelThatTheUserHasShownOrHiddenStaysSoInThatMode) {
  auto* handles = window().findChild<QDockWidget*>(QStringLiteral("handles"));
  handles->toggleViewAction()->trigger();
  EXPECT_TRUE(shown("handles"));
  key(Qt::Key_1);
  EXPECT_FALSE(shown("handles")) << "another mode";
  key(Qt::Key_5);
  EXPECT_TRUE(shown("handles"));
  reopenWindow();
  key(Qt::Key_5);
  EXPECT_TRUE(shown("handles")) << "the settings keep it";
  window().actions()["view.layout"]->trigger();
  settle();
  EXPECT_FALSE(shown("handles"));
}

TEST_F(Room, TheChartKeepsItsHeightOnAWalkThroughTheModes) {
  const auto* chart = window().findChild<QDockWidget*>(QStringLiteral("volumes"));
  const int height = chart->height();
  for (const Qt::Key mode : {Qt::Key_1, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_4, Qt::Key_2, Qt::Key_5}) {
    key(mode);
    settle();
    if (chart->isVisible()) {
      EXPECT_NEAR(chart->height(), height, 4) << char(mode);
    }
  }
}

TEST_F(Room, PanelsDoNotShrinkFromModeToMode) {
  const auto* handles = window().findChild<QDockWidget*>(QStringLiteral("handles"));
  key(Qt::Key_3);
  settle();
  const int height = handles->height();
  for (int round = 0; round < 6; ++round) {
    key(Qt::Key_1);
    settle();
    key(Qt::Key_3);
    settle();
    EXPECT_NEAR(handles->height(), height, 4) << "round " << round;
  }
}

TEST_F(Room, TheChartKeepsItsHeightFromSequenceToSequenceAndBesideSigns) {
  const auto* chart = window().findChild<QDockWidget*>(QStringLiteral("volumes"));
  const auto* timeline = window().findChild<QDockWidget*>(QStringLiteral("timeline"));
  const int height = chart->height(), rows = timeline->height();
  for (const char* sequence : {"breathing", "heartbeat"}) {
    parts().chooseSequence(QLatin1String(sequence));
    ASSERT_TRUE(waitUntil([&] {
      const auto* present = window().playback().sequence();
      return present && present->id() == sequence;
    })) << message().toStdString();
    window().playback().pause();
    settle();
    EXPECT_NEAR(chart->height(), height, 4) << sequence;
  }
  EXPECT_EQ(timeline->height(), rows);
  for (const bool signs : {true, false}) {
    window().actions()["play.beatSigns"]->trigger();
    settle();
    EXPECT_EQ(timeline->height() > rows, signs);
    EXPECT_NEAR(chart->height(), height, 4) << (signs ? "with" : "without") << " signs";
  }
}

/// Also one of 1366 x 768 pixels at twice the scale, and one of 1920 x 1200.
TEST_F(Room, TheWindowIsNoLargerThanTheScreen) {
  window().stress().model().change([](app::StressLook& look) { look.witnesses = 200; });
  for (const QSize& screen : {QSize(683, 384), QSize(960, 600), QSize(1024, 768), QSize(1280, 800)}) {
    window().resize(app::firstWindowSize(screen));
    settle();
    for (const auto& mode : window().modes().all()) {
      window().setMode(mode->description().id);
      settle();
      EXPECT_LE(window().width(), screen.width()) << window().mode();
      EXPECT_LE(window().height(), screen.height()) << window().mode();
    }
  }
}

TEST_F(Room, ALectureIsTheViewAloneAndEscapeEndsIt) {
  const QSize before = view().size();
  key(Qt::Key_F5);
  EXPECT_TRUE(window().isFullScreen());
  EXPECT_TRUE(window().menuBar()->isHidden() && window().statusBar()->isHidden());
  for (const char* panel : {"organs", "handles", "properties", "timeline", "volumes"})
    EXPECT_FALSE(shown(panel)) << panel;
  EXPECT_EQ(view().width(), window().width());
  EXPECT_TRUE(numbers().contains(QStringLiteral("LV ")) && numbers().contains(QStringLiteral(" ml")))
      << numbers().toStdString();
  key(Qt::Key_Escape);
  EXPECT_FALSE(window().isFullScreen());
  EXPECT_FALSE(window().menuBar()->isHidden());
  EXPECT_TRUE(shown("timeline") && shown("organs"));
  EXPECT_TRUE(waitUntil([&] { return view().size() == before; }))
      << view().width() << " x " << view().height() << ", " << before.width() << " x " << before.height()
      << " before";
}

TEST_F(Room, ALectureHasTheSignsOfTheTextbooksBeatThatAreChosen) {
  const auto& signs = find<app::LectureSigns>("lectureSigns");
  const auto& strip = *signs.findChild<app::BeatStrip*>();
  EXPECT_FALSE(signs.isVisible());
  key(Qt::Key_F5);
  settle();
  ASSERT_TRUE(strip.isVisible());
  window().playback().pause();
  QStringList mitral;
  for (const double fraction : {0.45, 0.95}) {
    window().playback().seek(fraction);
    mitral << strip.openValves().join(QLatin1Char('|'));
  }
  EXPECT_NE(mitral[0], mitral[1]) << "the strip is at the instant";
  const int height = strip.height(), view = this->view().height();
  EXPECT_LE(signs.mapTo(&window(), signs.rect().bottomLeft()).y(), window().height());
  window().actions()["signs.valves"]->trigger();
  settle();
  EXPECT_LT(strip.height(), height);
  EXPECT_GT(this->view().height(), view) << "the view gets the room";
  window().actions()["signs.ecg"]->trigger();
  window().actions()["signs.sounds"]->trigger();
  settle();
  EXPECT_FALSE(signs.isVisible()) << "the textbook's beat has no pressures";
  key(Qt::Key_Escape);
}

TEST_F(Room, ALectureHasTheChartsOfTheCirculationAtTheInstant) {
  find<QAbstractButton>("scenario.rest").click();
  ASSERT_TRUE(waitUntil([this] {
    return parts().circulation().settled() && parts().circulation().isPlayed();
  })) << message().toStdString();
  window().playback().pause();
  const auto* below = window().findChild<app::CirculationPanel*>()->findChild<app::ChartCursor*>();
  window().playback().seek(0.2);
  settle();
  const app::ChartCursor::Marks former = below->marks();
  key(Qt::Key_F5);
  settle();
  const auto& signs = find<app::LectureSigns>("lectureSigns");
  const auto* cursor = signs.findChild<app::ChartCursor*>();
  ASSERT_NE(cursor, nullptr);
  ASSERT_TRUE(cursor->isVisible());
  ASSERT_TRUE(waitUntil([&] { return !cursor->marks().rings.empty(); }));
  EXPECT_EQ(cursor->marks().lines.size(), former.lines.size()) << "the same charts as below the view";
  EXPECT_EQ(cursor->marks().rings.size(), former.rings.size());
  const double before = cursor->marks().lines[0].x;
  window().playback().seek(0.6);
  EXPECT_GT(cursor->marks().lines[0].x, before + 0.05);
  window().actions()["signs.loops"]->trigger();
  settle();
  EXPECT_TRUE(cursor->marks().rings.empty());
  key(Qt::Key_Escape);
}

TEST_F(Room, ASessionKeepsTheSignsThatAreChosen) {
  window().actions()["signs.sounds"]->trigger();
  const QString file = path(QStringLiteral("signs.viscera"));
  window().sessions().saveTo(file, false);
  settle();
  window().actions()["signs.sounds"]->trigger();
  ASSERT_TRUE(window().viewModel().state().heartSigns.sounds);
  window().sessions().open(file);
  EXPECT_TRUE(waitUntil([this] { return !window().viewModel().state().heartSigns.sounds; }));
  EXPECT_FALSE(window().actions()["signs.sounds"]->isChecked());
}

TEST_F(Room, MessagesWaitUntilTheLectureEnds) {
  const auto& bar = *window().viewArea().messages();
  const auto say = [this](const char* text) {
    window().workspace().say({app::Message::Severity::warning, QString::fromLatin1(text), {}, 0});
  };
  say("before");
  ASSERT_TRUE(bar.isVisible());
  key(Qt::Key_F5);
  EXPECT_FALSE(bar.isVisible());
  say("meanwhile");
  EXPECT_FALSE(bar.isVisible());
  key(Qt::Key_Escape);
  EXPECT_TRUE(bar.isVisible());
  EXPECT_EQ(message(), QStringLiteral("meanwhile"));
  key(Qt::Key_F5);
  window().workspace().retract(QStringLiteral("meanwhile"));
  key(Qt::Key_Escape);
  EXPECT_FALSE(bar.isVisible()) << "what no longer holds is not said afterwards";
}

/// Where names of organs and phases are long.
class SpanishRoom : public Room {
  app::InstalledLanguage language_{QStringLiteral("es")};
};

TEST_F(SpanishRoom, ALectureHasARowOfNumbersForEachViewWhichDoesNotBreak) {
  key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(parts().comparison().on());
  app::Workspace& second = parts().comparison().workspace();
  ASSERT_TRUE(waitUntil([&] { return !second.live().busy() && second.jobs().idle(); }));
  key(Qt::Key_F5);
  window().resize(1280, 800); // Whatever the screen's size is.
  settle();
  const auto& numbers = find<QLabel>("lectureNumbers");
  ASSERT_LE(numbers.width(), 1280);
  std::vector<double> sizes;
  for (const double fraction : {0.05, 0.2, 0.45, 0.8}) {
    window().playback().seek(fraction);
    settle();
    const QStringList rows = numbers.text().split(QLatin1Char('\n'));
    EXPECT_EQ(rows.size(), 2);
    for (const QString& row : rows)
      EXPECT_LE(numbers.fontMetrics().horizontalAdvance(row), numbers.width()) << row.toStdString();
    sizes.push_back(numbers.font().pointSizeF());
  }
  EXPECT_GT(sizes.back(), 1.15 * window().font().pointSizeF()) << "still large";
  EXPECT_NEAR(sizes.back(), sizes.front(), 0.05 * sizes.front()) << "the same in every phase";
}

TEST_F(Room, KeyF11TakesTheWholeScreenWithAllPanelsAndGivesItBack) {
  const QAction& full = *window().actions()["view.fullScreen"];
  const QSize before = window().size();
  key(Qt::Key_F11);
  EXPECT_TRUE(window().isFullScreen() && full.isChecked());
  EXPECT_FALSE(window().menuBar()->isHidden()) << "it is no lecture";
  EXPECT_TRUE(shown("organs") && shown("timeline"));
  key(Qt::Key_F5);
  key(Qt::Key_Escape);
  EXPECT_TRUE(window().isFullScreen() && full.isChecked()) << "as before the lecture";
  key(Qt::Key_F11);
  EXPECT_FALSE(window().isFullScreen() || full.isChecked());
  EXPECT_TRUE(waitUntil([&] { return window().size() == before; }));
}

TEST_F(Room, AWindowThatComesBackOnTheWholeScreenLeavesItByOneKey) {
  key(Qt::Key_F11);
  reopenWindow();
  ASSERT_TRUE(window().isFullScreen()) << "as it was left";
  EXPECT_TRUE(window().actions()["view.fullScreen"]->isChecked());
  key(Qt::Key_F11);
  EXPECT_FALSE(window().isFullScreen());
}

TEST_F(Room, KeyBDarkensTheScreenOfALectureAndLightensIt) {
  constexpr int kDark = 16; // Of 255.
  auto& dark = find<QWidget>("lectureDark");
  key(Qt::Key_B);
  EXPECT_FALSE(dark.isVisible()) << "there is no lecture";
  key(Qt::Key_F5);
  key(Qt::Key_B);
  ASSERT_TRUE(dark.isVisible());
  EXPECT_EQ(dark.geometry(), window().viewArea().rect());
  EXPECT_EQ(window().viewArea().childAt(dark.geometry().center()), &dark) << "something lies over it";
  EXPECT_LT(dark.grab().toImage().pixelColor(dark.rect().center()).lightness(), kDark);
  key(Qt::Key_B);
  EXPECT_FALSE(dark.isVisible());
  key(Qt::Key_B);
  key(Qt::Key_Escape);
  EXPECT_FALSE(dark.isVisible()) << "it goes with the lecture";
  key(Qt::Key_F5);
  EXPECT_FALSE(dark.isVisible()) << "and does not come back with the next one";
}

/// Remotes send a B or a full stop, which shows the next frame outside a lecture.
TEST_F(Room, TheFullStopOfARemoteDarkensALectureOnly) {
  auto& dark = find<QWidget>("lectureDark");
  window().playback().pause();
  window().playback().seek(0.25);
  settle();
  key(Qt::Key_F5);
  const double instant = window().playback().player().fraction();
  key(Qt::Key_Period);
  EXPECT_TRUE(dark.isVisible());
  key(Qt::Key_Period);
  EXPECT_FALSE(dark.isVisible());
  EXPECT_EQ(window().playback().player().fraction(), instant) << "no frame forward";
  key(Qt::Key_Escape);
  key(Qt::Key_Period);
  EXPECT_FALSE(dark.isVisible());
  EXPECT_GT(window().playback().player().fraction(), instant);
}

TEST_F(Room, SlidesBringBackTheViewAndTheInstant) {
  window().playback().pause();
  window().playback().seek(0.25);
  settle();
  const Vec3 first = eye();
  const double volume = volumeOf("LV");
  window().actions()["slides.add"]->trigger();
  window().views().lookFrom(scene::StandardView::left);
  window().playback().seek(0.6);
  window().actions()["slides.add"]->trigger();
  const Vec3 second = eye();
  ASSERT_GT((first - second).norm(), 10);
  window().slides().rename(0, QStringLiteral("The ventricles eject"));
  window().views().lookFrom(scene::StandardView::superior);
  key(Qt::Key_F5);
  EXPECT_EQ(window().slides().current(), 1) << "the one shown last";
  key(Qt::Key_PageUp);
  EXPECT_LT((eye() - first).norm(), 1e-9);
  EXPECT_NEAR(volumeOf("LV"), volume, 1e-9);
  EXPECT_EQ(caption(), QStringLiteral("The ventricles eject"));
  key(Qt::Key_PageDown);
  EXPECT_LT((eye() - second).norm(), 1e-9);
  EXPECT_FALSE(window().actions()["slides.next"]->isEnabled()) << "there is no third";
}

/// Slides that hide and cut.
class Looks : public Room {
protected:
  void SetUp() override {
    Room::SetUp();
    key(Qt::Key_1);
    wall_ = document().organs().front()->id;
  }
  void setView(bool cut, bool names) {
    window().viewModel().change([&](presentation::ViewState& state) {
      state.cut.on = cut;
      state.cut.offset = cut ? 0.2 : 0;
      state.partNames = names;
    });
  }
  void look(document::OrganId organ, const std::function<void(document::OrganLook&)>& change) {
    document::OrganLook look = document().organ(organ)->look;
    change(look);
    ASSERT_TRUE(window().workspace().perform(document::setOrganLook(organ, look)));
  }
  /// A slide of the heart that is cut open, with names and without its wall, and one of the whole heart.
  void makeSlides() {
    setView(true, true);
    look(wall_, [](document::OrganLook& look) { look.visible = false; });
    window().actions()["slides.add"]->trigger();
    setView(false, false);
    look(wall_, [](document::OrganLook& look) { look.visible = true; });
    window().actions()["slides.add"]->trigger();
  }
  const presentation::ViewState& state() { return window().viewModel().state(); }
  bool wallSeen() { return window().picture().actorOf(wall_)->visible(); }

  document::OrganId wall_;
};

TEST_F(Looks, ASlideBringsBackWhatIsCutHiddenAndNamedAndTheDocumentStays) {
  makeSlides();
  const document::DocumentState before = document().state();
  key(Qt::Key_F5);
  EXPECT_FALSE(state().cut.on);
  key(Qt::Key_PageUp);
  EXPECT_TRUE(state().cut.on && state().partNames);
  EXPECT_EQ(state().cut.offset, 0.2);
  EXPECT_FALSE(wallSeen());
  key(Qt::Key_PageDown);
  EXPECT_FALSE(state().cut.on || state().partNames);
  EXPECT_TRUE(wallSeen());
  key(Qt::Key_PageUp);
  EXPECT_TRUE(state().cut.on);
  EXPECT_FALSE(wallSeen());
  key(Qt::Key_Escape);
  EXPECT_FALSE(state().cut.on || state().partNames) << "all is as before the lecture";
  EXPECT_TRUE(wallSeen());
  EXPECT_FALSE(window().actions()["slides.leave"]->isEnabled());
  EXPECT_TRUE(document().state() == before);
  key(Qt::Key_F5);
  EXPECT_TRUE(state().cut.on) << "the slide whose caption is there";
}

TEST_F(Looks, OutsideOfALectureTheUserGoesBackOrGoesOnFromASlide) {
  makeSlides();
  window().slides().show(0);
  EXPECT_FALSE(wallSeen());
  ASSERT_TRUE(window().actions()["slides.leave"]->isEnabled());
  window().actions()["slides.leave"]->trigger();
  EXPECT_TRUE(wallSeen());
  EXPECT_FALSE(state().cut.on);
  EXPECT_FALSE(window().actions()["slides.leave"]->isEnabled());
  window().slides().show(0);
  look(wall_, [](document::OrganLook& look) { look.opacity = 0.5; });
  EXPECT_TRUE(wallSeen()) << "who changes its look wants to see it";
  window().actions()["slides.add"]->trigger();
  EXPECT_EQ(window().slides().all().size(), 3u);
  const auto& kept = window().slides().all()[1].look;
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->cut.on);
  EXPECT_EQ(kept->organs.at(wall_), (presentation::OrganSeen{true, 0.5}));
}

TEST_F(Looks, ASlideOfAnOlderSessionLeavesOrgansAsTheyAre) {
  makeSlides();
  window().viewModel().change([](presentation::ViewState& state) {
    for (presentation::Slide& slide : state.slides)
      slide.look.reset();
  });
  setView(true, false);
  window().slides().show(0);
  EXPECT_TRUE(state().cut.on);
  EXPECT_TRUE(wallSeen());
  window().slides().show(1);
  EXPECT_TRUE(state().cut.on);
}

TEST_F(Looks, ASessionKeepsThemAndTheLookFromBeforeTheSlideThatIsShown) {
  makeSlides();
  window().slides().show(0);
  const auto kept = window().slides().all();
  ASSERT_EQ(state().organsSeen.size(), 1u);
  const QString file = path(QStringLiteral("cut.viscera"));
  window().sessions().saveTo(file, false);
  settle();
  window().sessions().begin();
  EXPECT_TRUE(state().organsSeen.empty());
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([this] { return !window().slides().all().empty(); }));
  EXPECT_EQ(window().slides().all(), kept);
  EXPECT_TRUE(state().organsSeen.empty());
  EXPECT_FALSE(state().cut.on || state().partNames);
  EXPECT_TRUE(waitUntil([this] { return wallSeen(); }));
  window().slides().show(0);
  EXPECT_FALSE(wallSeen());
  window().slides().show(1);
  EXPECT_TRUE(wallSeen());
}

TEST_F(Looks, ASlideShowsTheSameOrgansInBothViewsAlike) {
  makeSlides();
  app::Comparison& comparison = parts().comparison();
  comparison.showKeptPose();
  ASSERT_TRUE(waitUntil(
      [&] { return !comparison.workspace().live().busy() && comparison.workspace().jobs().idle(); }));
  const auto secondWall = [&] { return comparison.picture().actorOf(wall_); };
  ASSERT_NE(secondWall(), nullptr);
  EXPECT_TRUE(secondWall()->visible());
  window().slides().show(0);
  EXPECT_FALSE(secondWall()->visible());
  window().slides().leave();
  EXPECT_TRUE(secondWall()->visible());
}

TEST_F(Room, ALectureHasLargeTypeAndTheStrongestContrastUntilItEnds) {
  for (const app::ThemeKind kind : {app::ThemeKind::dark, app::ThemeKind::light}) {
    window().setTheme(kind);
    const bool dark = kind == app::ThemeKind::dark;
    const scene::Theme usual = view().view().theme();
    EXPECT_EQ(usual.typeScale, 1);
    key(Qt::Key_F5);
    const scene::Theme& large = view().view().theme();
    EXPECT_EQ(large.typeScale, scene::kLectureTypeScale);
    EXPECT_EQ(large.text, dark ? Vec3(1, 1, 1) : Vec3(0, 0, 0));
    EXPECT_EQ(large.backgroundTop, dark ? Vec3(0, 0, 0) : Vec3(1, 1, 1));
    const QColor ground = dark ? Qt::black : Qt::white, letters = dark ? Qt::white : Qt::black;
    auto& caption = find<QLabel>("lectureNumbers");
    EXPECT_EQ(caption.palette().color(QPalette::WindowText), letters);
    const QImage card = find<QFrame>("lectureCard").grab().toImage();
    EXPECT_EQ(card.pixelColor(card.width() / 2, 4), ground);
    key(Qt::Key_Escape);
    EXPECT_EQ(view().view().theme().typeScale, 1);
    EXPECT_EQ(view().view().theme().text, usual.text);
    EXPECT_EQ(view().view().theme().backgroundTop, usual.backgroundTop);
  }
}

TEST_F(Room, TheCardOfALectureCoversNoPartOfAnOrgan) {
  window().actions()["slides.add"]->trigger();
  window().slides().rename(0, QStringLiteral("The ventricles eject,\nand the atria fill"));
  window().slides().show(0);
  key(Qt::Key_F5);
  settle();
  const auto& card = find<QFrame>("lectureCard");
  const auto& caption = find<QLabel>("lectureCaption");
  ASSERT_TRUE(card.isVisible());
  ASSERT_GT(caption.height(), 1.8 * caption.fontMetrics().height()) << "two lines";
  ASSERT_GE(card.height(), caption.height() + find<QLabel>("lectureNumbers").height());
  QRect box;
  for (const auto& organ : document().organs()) {
    const Points& points = window().workspace().live().points(organ->id);
    for (Eigen::Index row = 0; row < points.rows(); row += 7)
      box |= QRect(view().mapTo(&window(), onScreen(points.row(row).transpose())), QSize(1, 1));
  }
  ASSERT_GT(box.height(), 0.4 * view().height()) << "the organ fills the view";
  const QRect there(card.mapTo(&window(), QPoint(0, 0)), card.size());
  EXPECT_FALSE(box.intersects(there)) << box.bottom() << " and " << there.top();
  EXPECT_TRUE(window().rect().contains(there));
  const int height = view().height();
  key(Qt::Key_Escape);
  EXPECT_GT(window().height(), height);
  EXPECT_FALSE(card.isVisible());
}

TEST_F(Room, SlidesAreMovedAndRemovedInTheList) {
  for (int i = 0; i < 3; ++i)
    window().actions()["slides.add"]->trigger();
  auto* list = window().findChild<QListWidget*>(QStringLiteral("slideList"));
  ASSERT_EQ(list->count(), 3);
  window().slides().move(2, 0);
  EXPECT_EQ(list->item(0)->text(), QStringLiteral("Slide 3"));
  list->item(1)->setText(QStringLiteral("Rest"));
  EXPECT_EQ(window().slides().all()[1].caption, "Rest");
  window().slides().show(1);
  window().actions()["slides.remove"]->trigger();
  ASSERT_EQ(list->count(), 2);
  EXPECT_EQ(list->item(1)->text(), QStringLiteral("Slide 2"));
}

TEST_F(Room, ASessionKeepsTheSlides) {
  window().actions()["slides.add"]->trigger();
  window().slides().rename(0, QStringLiteral("Kammer <b>links</b>"));
  const auto kept = window().slides().all();
  const QString file = path(QStringLiteral("slides.viscera"));
  window().sessions().saveTo(file, false);
  settle();
  window().actions()["slides.remove"]->trigger();
  ASSERT_TRUE(window().slides().all().empty());
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([this] { return !window().slides().all().empty(); }));
  EXPECT_EQ(window().slides().all(), kept);
}

} // namespace
} // namespace viscera::tests
