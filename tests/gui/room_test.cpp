#include <QAction>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeWidget>

#include <functional>
#include <string>
#include <utility>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "play_fixture.h"
#include "signs/beat_drawing.h"
#include "window/guide/help_cards.h"
#include "window/stress/stress_mode.h"
#include "window/timeline/phase_scrubber.h"
#include "window/widgets/elided_label.h"

/// How the window shares its room between the view and the panels.
namespace viscera::tests {
namespace {

/// 1366 x 768 and 1920 x 1200 pixels at twice the scale.
constexpr QSize kLaptop(683, 384), kSmallDesk(960, 600), kStandard(1280, 800);

class SharedRoom : public PlayMode {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  void SetUp() override {
    PlayMode::SetUp();
    window().stress().model().change([](app::StressLook& look) { look.witnesses = 200; });
  }
  void resizeTo(const QSize& size) {
    window().resize(size);
    settle();
  }
  void forEachMode(const std::function<void(const std::string& mode)>& look) {
    for (const auto& mode : window().modes().all()) {
      window().setMode(mode->description().id);
      settle();
      look(mode->description().id);
    }
  }
  double partOfView() {
    return double(view().width()) * view().height() / (double(window().width()) * window().height());
  }
  bool shown(const char* panel) { return find<QDockWidget>(panel).isVisible(); }
  app::ElidedLabel& hint() {
    return *window().statusBar()->findChild<app::ElidedLabel*>(QStringLiteral("muted"));
  }
};

TEST_F(SharedRoom, TheViewHasItsPartInEveryModeAndWindow) {
  const std::pair<QSize, double> windows[] = {{kLaptop, 0.25}, {kSmallDesk, 0.25}, {kStandard, 0.29}};
  for (const auto& [size, part] : windows) {
    resizeTo(size);
    forEachMode([&, wanted = part](const std::string& mode) {
      EXPECT_GE(partOfView(), wanted) << mode << " in a window " << window().width() << " wide";
    });
  }
}

TEST_F(SharedRoom, PanelsThatFoldInASmallWindowAreBackInALargeOne) {
  resizeTo(kLaptop);
  EXPECT_FALSE(shown("organs") || shown("volumes"));
  EXPECT_TRUE(shown("timeline") && shown("properties"));
  resizeTo(kStandard);
  EXPECT_TRUE(shown("organs") && shown("volumes") && shown("timeline") && shown("properties"));
  find<QDockWidget>("organs").toggleViewAction()->trigger();
  resizeTo(kLaptop);
  resizeTo(kStandard);
  EXPECT_FALSE(shown("organs")) << "the user has hidden it";
}

TEST_F(SharedRoom, APanelThatTheUserAsksForInASmallWindowStaysAndOthersFoldForIt) {
  resizeTo(kLaptop);
  find<QDockWidget>("organs").toggleViewAction()->trigger();
  settle();
  EXPECT_TRUE(shown("organs"));
  EXPECT_FALSE(shown("properties"));
  EXPECT_GE(partOfView(), 0.2);
  key(Qt::Key_1);
  EXPECT_FALSE(shown("organs")) << "another mode";
  key(Qt::Key_5);
  EXPECT_TRUE(shown("organs"));
}

/// What Qt makes of the heights in a small window is not what the user has wished for.
TEST_F(SharedRoom, TheChartHasItsHeightAgainAfterASmallWindow) {
  const auto& chart = find<QDockWidget>("volumes");
  const int height = chart.height();
  for (const QSize& small : {kLaptop, kSmallDesk}) {
    resizeTo(small);
    key(Qt::Key_4);
    key(Qt::Key_5);
    resizeTo(kStandard);
    EXPECT_NEAR(chart.height(), height, 4) << small.width();
  }
}

TEST_F(SharedRoom, OrgansHaveMoreHeightThanHandles) {
  for (const QSize& size : {kStandard, kSmallDesk}) {
    resizeTo(size);
    key(Qt::Key_3);
    const auto& list = find<QTreeWidget>("organList");
    EXPECT_GT(find<QDockWidget>("organs").height(), find<QDockWidget>("handles").height());
    EXPECT_GE(list.viewport()->height(), 5 * list.visualItemRect(list.topLevelItem(0)).height())
        << "all five of the heart";
  }
}

TEST_F(SharedRoom, NamesOfOrgansHaveTheirWidthWhateverTheirVolumesBecome) {
  resizeTo(kStandard);
  auto& list = find<QTreeWidget>("organList");
  constexpr int kName = 1;
  ASSERT_EQ(list.topLevelItem(0)->text(kName), QStringLiteral("Heart"));
  window().playback().seek(0);
  settle();
  const int width = list.columnWidth(kName);
  for (const double fraction : {0.1, 0.3, 0.6}) {
    window().playback().seek(fraction);
    settle();
    EXPECT_EQ(list.columnWidth(kName), width) << fraction;
  }
  key(Qt::Key_3);
  EXPECT_EQ(list.columnWidth(kName), width) << "at rest";
}

/// Where the view is, and how large it draws.
struct Sight {
  QRect place;
  double distance = 0;
  double scale = 0;

  friend bool operator==(const Sight&, const Sight&) = default;
};

Sight sightOf(app::ViewWidget& view) {
  vtkCamera& camera = *view.view().renderer()->GetActiveCamera();
  return {QRect(view.mapToGlobal(QPoint(0, 0)), view.size()), camera.GetDistance(),
          camera.GetParallelScale()};
}

TEST_F(SharedRoom, TheFirstDragChangesNothingOfTheLayoutAndTheView) {
  for (const QSize& size : {kStandard, QSize(1440, 900)}) {
    resizeTo(size);
    key(Qt::Key_3);
    window().actions()["pose.reset"]->trigger();
    settle();
    EXPECT_TRUE(shown("volumes")) << "the chart waits for the drag";
    const Sight before = sightOf(view());
    const QPoint at = onScreen(handleInView(reachableHandle()));
    QTest::mouseMove(&view(), at);
    QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, at);
    for (int step = 1; step <= 12; ++step) {
      QTest::mouseMove(&view(), at + QPoint(3 * step, 2 * step));
      QTest::qWait(30);
      EXPECT_EQ(sightOf(view()), before) << "in step " << step;
    }
    EXPECT_FALSE(find<QLabel>("handlesMoved").text().startsWith(QLatin1String("0 ")))
        << find<QLabel>("handlesMoved").text().toStdString();
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, at + QPoint(36, 24));
    settle();
    EXPECT_EQ(sightOf(view()), before);
    EXPECT_GE(window().volumes().drags().rows(), 2U);
  }
}

TEST_F(SharedRoom, ADragAlongTheTimelineLeavesTheTimelineWhereItIs) {
  resizeTo(kStandard);
  key(Qt::Key_3);
  key(Qt::Key_4); // The document's own pose.
  settle();
  auto& scrubber = *window().findChild<app::PhaseScrubber*>();
  const QPoint before = scrubber.mapToGlobal(QPoint(0, 0));
  const QPoint from(scrubber.width() / 4, 8);
  QTest::mousePress(&scrubber, Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&scrubber, from + QPoint(40, 0));
  settle();
  EXPECT_EQ(scrubber.mapToGlobal(QPoint(0, 0)), before);
  QTest::mouseRelease(&scrubber, Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 0));
  EXPECT_TRUE(window().playback().showing());
}

TEST_F(SharedRoom, PanelsAtTheBottomEndAtTheProperties) {
  const auto& properties = find<QDockWidget>("properties");
  for (const QSize& size : {kStandard, QSize(1440, 900)}) {
    resizeTo(size);
    for (const char* below : {"timeline", "volumes"}) {
      const auto& dock = find<QDockWidget>(below);
      ASSERT_TRUE(dock.isVisible() && properties.isVisible()) << below;
      EXPECT_LT(dock.geometry().right(), properties.geometry().left()) << below;
      EXPECT_GE(properties.geometry().bottom(), dock.geometry().bottom()) << below;
    }
  }
  resizeTo(kSmallDesk);
  EXPECT_GT(find<QDockWidget>("timeline").geometry().right(), properties.geometry().left())
      << "a narrow window has no width to spare";
}

TEST_F(SharedRoom, NumbersOfABeatAreNotThoseOfAPose) {
  const auto tiles = [this] {
    QStringList texts;
    for (const auto* label : find<QDockWidget>("volumes").findChildren<QLabel*>(QStringLiteral("muted")))
      texts.push_back(label->text());
    return texts.join(QLatin1Char('|'));
  };
  EXPECT_TRUE(tiles().contains(QStringLiteral("EF "))) << tiles().toStdString();
  key(Qt::Key_3);
  EXPECT_FALSE(tiles().contains(QStringLiteral("EF "))) << tiles().toStdString();
}

TEST_F(SharedRoom, TheSourceOfNormalValuesIsSaidWhole) {
  const auto& source = find<app::ElidedLabel>("chartSource");
  for (const QSize& size : {kSmallDesk, kStandard, QSize(1600, 1000)}) {
    resizeTo(size);
    EXPECT_TRUE(source.text().contains(QStringLiteral("Petersen 2017 (UK Biobank)")))
        << source.text().toStdString();
    EXPECT_FALSE(source.text().contains(QChar(0x2026))) << source.text().toStdString();
  }
  EXPECT_TRUE(source.toolTip().contains(QStringLiteral("doi 10.1186"))) << "the rest";
}

TEST_F(SharedRoom, AChangeOfVolumeIsOnePercentageBelowTheVolume) {
  window().playback().seek(0.3);
  settle();
  const auto& list = find<QTreeWidget>("organList");
  constexpr int kVolume = 2;
  EXPECT_FALSE(list.isColumnHidden(kVolume)) << "beside the names at the standard width";
  const QTreeWidgetItem* cavity = list.topLevelItem(0)->child(0);
  const QString change = cavity->data(kVolume, Qt::UserRole).toString();
  EXPECT_TRUE(change.startsWith(QLatin1Char('-')) && change.endsWith(QLatin1Char('%')))
      << change.toStdString();
  EXPECT_FALSE(change.contains(QLatin1Char('\n')));
}

TEST_F(SharedRoom, TheWelcomeKeepsItsCrossInTheFirstRowAndStaysOffTheView) {
  window().showWelcome(true);
  const auto& card = *window().findChild<app::WelcomeCard*>();
  const auto& cross = *card.findChild<QToolButton*>();
  for (const QSize& size : {kStandard, kSmallDesk, kLaptop}) {
    resizeTo(size);
    for (const QWidget* other : card.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (other->isVisible()) {
        EXPECT_LE(cross.y(), other->geometry().bottom()) << size.width();
      }
    const QRect there(view().mapFromGlobal(card.mapToGlobal(QPoint(0, 0))), card.size());
    EXPECT_FALSE(there.intersects(view().rect())) << size.width();
  }
  const int before = view().height();
  window().showWelcome(false);
  settle();
  EXPECT_GT(view().height(), before) << "the room of the card is the view's";
}

TEST_F(SharedRoom, ThePresentPhaseIsNamedOnceInANarrowTimeline) {
  constexpr QSize kLarge(1600, 1000);
  auto& phase = find<QWidget>("phase");
  const auto& scrubber = *window().findChild<app::PhaseScrubber*>();
  resizeTo(kLarge);
  EXPECT_TRUE(phase.isVisible());
  resizeTo(kSmallDesk);
  EXPECT_FALSE(phase.isVisible());
  EXPECT_GE(scrubber.width(), 300);
  resizeTo(kLaptop);
  EXPECT_GE(scrubber.width(), 200);
  resizeTo(kStandard);
  EXPECT_GE(scrubber.width(), 300) << "beside the properties";
  resizeTo(kLarge);
  EXPECT_TRUE(phase.isVisible());
}

TEST_F(SharedRoom, NamesStayBelowTheBarOfTheTimeline) {
  auto& scrubber = *window().findChild<app::PhaseScrubber*>();
  constexpr int kBesideBar = 6, kBelowBar = 29;
  for (const double fraction : {0.05, 0.2, 0.97})
    for (const int width : {120, 150, 200, 260, 400}) {
      scrubber.setFraction(fraction);
      scrubber.resize(width, scrubber.sizeHint().height());
      const QImage drawn = scrubber.grab().toImage();
      const QRgb ground = drawn.pixel(0, drawn.height() - 1);
      for (int y = kBelowBar; y < drawn.height(); ++y)
        for (int x = 0; x < kBesideBar; ++x)
          ASSERT_TRUE(drawn.pixel(x, y) == ground && drawn.pixel(drawn.width() - 1 - x, y) == ground)
              << x << ", " << y << " of a bar " << width << " wide at " << fraction;
    }
}

TEST_F(SharedRoom, BracketsOfTheTimelineReachBesideTheirNames) {
  auto& scrubber = *window().findChild<app::PhaseScrubber*>();
  constexpr double kSystole = 0.4025, kBeside = 8;
  int named = 0;
  for (int width = 100; width <= 400; ++width) {
    scrubber.resize(width, scrubber.height());
    for (const QString& group : scrubber.groupsShown()) {
      if (!group.startsWith(QStringLiteral("systole")))
        continue;
      ++named;
      EXPECT_GE(kSystole * (width - 2 * app::kPhaseMargin),
                scrubber.fontMetrics().horizontalAdvance(group) + kBeside)
          << group.toStdString() << ' ' << width;
    }
  }
  EXPECT_GT(named, 100);
}

TEST_F(SharedRoom, AHintOfAFewLettersIsLeftOut) {
  for (int width = 640; width <= 1280; width += 80) {
    resizeTo({width, 600});
    EXPECT_TRUE(hint().text().isEmpty() || hint().text().size() > 20) << hint().text().toStdString();
  }
  EXPECT_FALSE(hint().text().isEmpty());
}

TEST(ElidedLabel, EndsWithAWholeEllipsisOrTakesAShorterForm) {
  app::ElidedLabel label;
  for (int width = 60; width <= 160; ++width) {
    label.resize(width, 20);
    label.setFullText(
        QStringLiteral("Some text that is too long for %1 pixels, whatever they are").arg(width));
    EXPECT_LT(label.fontMetrics().horizontalAdvance(label.text()), label.contentsRect().width())
        << "the label is drawn a pixel narrower";
  }
  const QString longer = QStringLiteral("Petersen 2017, doi 10.1186"), shorter = QStringLiteral("Petersen");
  label.setFullText(longer, {shorter});
  label.resize(label.widthFor(shorter), 20);
  label.setFullText(longer + QLatin1Char('/'), {shorter});
  EXPECT_EQ(label.text(), shorter);
  EXPECT_EQ(label.toolTip(), longer + QLatin1Char('/'));
  label.setFullText(QStringLiteral("Zieht an einem Griff"));
  label.setFewestLetters(20);
  EXPECT_EQ(label.text(), QString());
}

TEST(ElidedLabel, KeepsToTheRoomThatPaddingAndFontLeave) {
  QWidget window;
  auto* label = new app::ElidedLabel(&window);
  const QString text = QStringLiteral("Shaded: normal for Liver, volume 814 to 1906 ml");
  label->resize(label->widthFor(text), 20);
  label->setFullText(text);
  const auto fits = [&] {
    return label->fontMetrics().horizontalAdvance(label->text()) < label->contentsRect().width();
  };
  for (const char* style : {"QLabel { padding: 0 12px; }", "QLabel { font-size: 40px; }"}) {
    window.setStyleSheet(QLatin1String(style));
    window.show();
    QCoreApplication::processEvents();
    EXPECT_TRUE(fits()) << style;
    EXPECT_LT(label->text().size(), text.size()) << style;
  }
}

} // namespace
} // namespace viscera::tests
