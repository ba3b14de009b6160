#include "window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "window/guide/guide_window.h"
#include "window/guide/help_cards.h"
#include "window/guide/task_card.h"
#include "window/settings_dialog.h"
#include "window/widgets/first_picture.h"
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
  ASSERT_EQ(buttons.size(), 4);
  EXPECT_TRUE(waitUntil([&] { return card.height() <= window().viewArea().height() / 3; })) << card.height();
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

TEST_F(Tour, GoesOnWithReturnAndSpace) {
  next(); // The step that plays.
  ASSERT_TRUE(window().playback().player().playing());
  const QString before = card().findChild<QLabel*>()->text();
  QTest::keyClick(&view(), Qt::Key_Space);
  settle();
  EXPECT_NE(card().findChild<QLabel*>()->text(), before);
  EXPECT_EQ(window().mode(), "handles") << "Space is the tour's as long as it is shown, and is one step";
  for (std::size_t step = 2; step < card().steps().size(); ++step)
    QTest::keyClick(&window(), Qt::Key_Return);
  settle();
  EXPECT_FALSE(card().isVisible());
}

class GuideTest : public WindowTest {
protected:
  app::GuideWindow& guide() { return *window().findChild<app::GuideWindow*>(); }
  QString shownHeading() { return guide().findChild<QTextBrowser*>()->textCursor().block().text(); }
};

TEST_F(GuideTest, OpensInTheWindowAtThePresentMode) {
  const std::vector<std::pair<const char*, const char*>> headings = {{"explore", "User guide"},
                                                                     {"handles", "Groups of handles"},
                                                                     {"deform", "Deform mode"},
                                                                     {"stress", "Stress mode"},
                                                                     {"play", "Play: organs in motion"}};
  for (const auto& [mode, heading] : headings) {
    window().setMode(mode);
    window().actions()["help.guide"]->trigger();
    ASSERT_TRUE(guide().isVisible());
    EXPECT_EQ(shownHeading().toStdString(), heading);
  }
  EXPECT_EQ(window().actions()["help.guide"]->shortcut(), QKeySequence(Qt::Key_F1));
}

TEST_F(GuideTest, FindsTheSectionsThatHaveAllWords) {
  window().actions()["help.guide"]->trigger();
  auto& list = *guide().findChild<QListWidget*>();
  const int all = list.count();
  EXPECT_GT(all, 20);
  guide().findChild<QLineEdit*>(QStringLiteral("guideSearch"))->setText(QStringLiteral("volume LOCK"));
  EXPECT_GT(list.count(), 1);
  for (int row = 0; row < list.count(); ++row) {
    list.setCurrentRow(row);
    const QString page = guide().findChild<QTextBrowser*>()->toPlainText();
    EXPECT_TRUE(page.contains(QStringLiteral("lock"), Qt::CaseInsensitive));
    EXPECT_EQ(shownHeading().trimmed(), list.item(row)->toolTip());
  }
  guide().findChild<QLineEdit*>(QStringLiteral("guideSearch"))->setText(QStringLiteral("xyzzy"));
  EXPECT_EQ(list.count(), 0);
  guide().findChild<QLineEdit*>(QStringLiteral("guideSearch"))->clear();
  EXPECT_EQ(list.count(), all);
}

/// A link leads to the place that it names, on each page that the program has within.
TEST_F(GuideTest, EveryLinkBetweenItsPagesLeadsSomewhere) {
  const auto pages = app::guidePages();
  ASSERT_GT(pages.size(), 10u);
  const QRegularExpression link(QStringLiteral("\\]\\(([a-z_]*\\.md)?(#[^)]*)?\\)"));
  int seen = 0;
  for (const app::GuidePage& page : pages)
    for (auto at = link.globalMatch(page.markdown); at.hasNext();) {
      const auto match = at.next();
      const QString name = match.captured(1).isEmpty() ? page.name : match.captured(1);
      const auto target =
          std::find_if(pages.begin(), pages.end(), [&](const auto& p) { return p.name == name; });
      if (target == pages.end() || match.captured(2).isEmpty())
        continue; // For developers, or the whole page.
      const QString anchor = match.captured(2).mid(1);
      EXPECT_TRUE(std::any_of(target->sections.begin(), target->sections.end(),
                              [&](const auto& section) { return section.anchor == anchor; }))
          << page.name.toStdString() << " -> " << match.captured(0).toStdString();
      ++seen;
    }
  EXPECT_GT(seen, 10);
}

TEST_F(WindowTest, SettingsAreInOneDialogAndApplyAtOnce) {
  window().actions()["edit.settings"]->trigger();
  auto& dialog = *window().findChild<app::SettingsDialog*>();
  ASSERT_TRUE(dialog.isVisible());
  auto& theme = *dialog.findChild<QComboBox*>(QStringLiteral("settingsTheme"));
  theme.setCurrentIndex(1);
  Q_EMIT theme.activated(1);
  EXPECT_TRUE(window().actions()["theme.light"]->isChecked());
  auto& cube = *dialog.findChild<QCheckBox*>(QStringLiteral("settings.view.cube"));
  const bool before = window().viewModel().state().orientationCube;
  cube.click();
  EXPECT_NE(window().viewModel().state().orientationCube, before);
  window().actions()["view.cube"]->trigger();
  EXPECT_EQ(cube.isChecked(), before) << "the menu's change is the dialog's";
  auto& language = *dialog.findChild<QComboBox*>(QStringLiteral("settingsLanguage"));
  language.setCurrentIndex(language.findData(QStringLiteral("de")));
  Q_EMIT language.activated(language.currentIndex());
  dialog.close();
  settle();
  window().actions()["edit.settings"]->trigger();
  auto& again = *window().findChild<app::SettingsDialog*>();
  EXPECT_EQ(again.findChild<QComboBox*>(QStringLiteral("settingsLanguage"))->currentData().toString(),
            QStringLiteral("de"));
  window().actions()["theme.dark"]->trigger();
}

/// Every command of the menus, with the menu that it is in.
void collectEntries(const QList<QAction*>& actions, std::vector<QAction*>& found) {
  for (QAction* action : actions) {
    found.push_back(action);
    if (action->menu())
      collectEntries(action->menu()->actions(), found);
  }
}

TEST_F(WindowTest, MenusHaveOneMarkForWhatIsOnAndAnIconForOneCommand) {
  std::vector<QAction*> entries;
  collectEntries(window().findChild<QMenuBar*>(QStringLiteral("menus"))->actions(), entries);
  std::map<QString, std::set<QString>> commands; // By the icon.
  for (QAction* entry : entries) {
    if (entry->icon().isNull() || !entry->isIconVisibleInMenu() || entry->menu())
      continue;
    EXPECT_FALSE(entry->isCheckable()) << "an icon hides the tick: " << entry->text().toStdString();
    commands[entry->property(app::kIconName).toString()].insert(entry->objectName());
  }
  EXPECT_GT(commands.size(), 10u);
  for (const auto& [icon, ids] : commands)
    EXPECT_EQ(ids.size(), 1u) << icon.toStdString();
  std::set<QString> menus; // In which the coordinates are compared.
  for (const QAction* entry : entries)
    if (entry->menu() && entry->menu()->actions().contains(window().actions()["play.compareSystems"]))
      menus.insert(entry->text().remove(QLatin1Char('&')));
  EXPECT_EQ(menus, std::set<QString>{QStringLiteral("Compare")}) << "it has nothing to do with sequences";
}

TEST_F(WindowTest, AnEmptyWindowShowsTheHeartWhileItIsMade) {
  auto& picture = *window().findChild<app::FirstPicture*>();
  EXPECT_FALSE(picture.isVisible());
  window().samples().load(QStringLiteral("heart"), false);
  EXPECT_TRUE(picture.isVisible()) << "at once";
  EXPECT_GT(picture.grab().toImage().pixelColor(picture.rect().center()).red(), 100) << "it is the heart";
  for (const QLabel* label : window().findChildren<QLabel*>())
    EXPECT_FALSE(label->isVisible() && label->text().startsWith(QLatin1String("No organ yet")));
  settle();
  EXPECT_FALSE(picture.isVisible());
  EXPECT_FALSE(document().organs().empty());
  window().samples().load(QStringLiteral("heart"), false);
  EXPECT_FALSE(picture.isVisible()) << "organs are in its place";
  settle();
}

TEST_F(WindowTest, TheFirstTaskEndsWhenItIsDone) {
  open(sphereFile());
  EXPECT_TRUE(window().actions()["help.task"]->isEnabled());
  window().actions()["help.task"]->trigger();
  settle();
  auto& card = *window().findChild<app::TaskCard*>();
  ASSERT_TRUE(card.isVisible());
  EXPECT_EQ(window().mode(), "deform");
  const auto chosen = window().workspace().selection().handles();
  ASSERT_EQ(chosen.size(), 1u);
  const int row = document().rig().indexOf(chosen.front());
  const QPoint at = onScreen(handleInView(row));
  drag(at, at + QPoint(0, 25));
  settle();
  EXPECT_TRUE(card.done());
  EXPECT_TRUE(waitUntil([&] { return !card.isVisible(); })) << "it goes by itself";
}

} // namespace
} // namespace viscera::tests
