#include <QAction>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include <string>

#include "screen_check.h"
#include "viscera/document/rig_commands.h"
#include "window/export/report_export.h"
#include "window/style/theme.h"
#include "window_probe.h"
#include "window_test.h"

namespace viscera::tests {
namespace {

/// The whole window as a user sees it, with the sample heart in its ejection.
class Screens : public WindowTest {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  void SetUp() override {
    WindowTest::SetUp();
    window().samples().load(QStringLiteral("heart"), false);
    waitUntil([this] { return window().playback().sequence() && atPeace(window()); });
    settle();
  }
  void arrange(const QSize& size, app::ThemeKind theme) {
    window().setTheme(theme);
    window().resize(size);
    QTest::mouseMove(&window(), QPoint(2, 2));
    settle();
  }
  /// In a mode, seen from the front, with all that it makes ready.
  void enter(const char* mode) {
    window().setMode(mode);
    if (window().mode() == "play")
      window().playback().seek(0.3);
    settle();
    waitUntil([this] { return atPeace(window()); });
    view().view().lookFrom(scene::StandardView::anterior);
    view().scheduleRender();
    settle();
  }
  QImage screen() {
    settle();
    return window().grab().toImage();
  }
  /// In every mode, as <mode>_<width>_<theme>.
  void expectModes(const QSize& size, app::ThemeKind theme) {
    Points pose = document().pose();
    pose.row(0) *= 1.15;
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    arrange(size, theme);
    for (const char* mode : {"explore", "handles", "deform", "stress", "play"}) {
      enter(mode);
      expectScreen(screen(), std::string(mode) + '_' + std::to_string(size.width()) + '_' +
                                 app::nameOf(theme).toStdString());
    }
  }
};

TEST_F(Screens, OfAllModesOnASmallScreenAreAsTheyWereLookedAt) {
  expectModes({1280, 800}, app::ThemeKind::dark);
  expectModes({1280, 800}, app::ThemeKind::light);
}

TEST_F(Screens, OfAllModesOnALargeScreenAreAsTheyWereLookedAt) {
  expectModes({1600, 1000}, app::ThemeKind::dark);
  expectModes({1600, 1000}, app::ThemeKind::light);
}

TEST_F(Screens, OfTheCutHeartAndOfALectureAreAsTheyWereLookedAt) {
  arrange({1600, 1000}, app::ThemeKind::dark);
  window().actions()["view.cut"]->trigger();
  window().actions()["view.parts"]->trigger();
  enter("explore");
  expectScreen(screen(), "cut_heart");
  window().actions()["view.cut"]->trigger();
  enter("play");
  window().actions()["view.lecture"]->trigger();
  settle();
  window().resize(1600, 1000);
  view().view().frame();
  view().scheduleRender();
  expectScreen(screen(), "lecture");
}

TEST_F(Screens, OfTheFirstPageOfAReportIsAsItWasLookedAt) {
  const QString program = QStandardPaths::findExecutable(QStringLiteral("pdftoppm"));
  if (program.isEmpty())
    GTEST_SKIP() << "pdftoppm, of the package poppler-utils, draws the page";
  enter("play");
  const QString file = path(QStringLiteral("heart.pdf"));
  window().findChild<app::ReportExport*>()->write(file);
  settle();
  const QString page = path(QStringLiteral("page"));
  QProcess::execute(program,
                    {QStringLiteral("-png"), QStringLiteral("-r"), QStringLiteral("110"),
                     QStringLiteral("-f"), QStringLiteral("1"), QStringLiteral("-singlefile"), file, page});
  const QImage drawn(page + QStringLiteral(".png"));
  ASSERT_FALSE(drawn.isNull()) << message().toStdString();
  expectScreen(drawn, "report_page");
}

} // namespace
} // namespace viscera::tests
