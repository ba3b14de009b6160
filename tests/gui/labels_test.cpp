// What is written fits in every language: labels, buttons, numbers, lists and the letters of menus.
#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>

#include "cut_texts.h"
#include "play_fixture.h"
#include "shapes.h"
#include "viscera/medical_io/surface_file.h"
#include "window/circulation/circulation_model.h"
#include "window/compare/compared_system.h"
#include "window/compare/comparison.h"
#include "window/compare/side_header.h"
#include "window/export/lesson_dialog.h"
#include "window/export/lesson_export.h"
#include "window/guide/help_cards.h"
#include "window/import/import_controller.h"
#include "window/style/language.h"
#include "window/track/motion_dialog.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/system_combo.h"

namespace viscera::tests {
namespace {

/// A window in the language of its parameter. The locale has to be there before the window is made.
class InLanguage : public PlayMode, public ::testing::WithParamInterface<const char*> {
protected:
  /// The window, with everything that a language changes, made before the fixture's own.
  app::InstalledLanguage language_{QLatin1String(GetParam())};
};

/// A window with one text of each kind, each in a widget of that width.
class NarrowTexts : public QWidget {
public:
  explicit NarrowTexts(int wide) {
    auto* number = new QSpinBox(this);
    number->setSpecialValueText(QStringLiteral("special value"));
    number->setSuffix(QStringLiteral(" millilitres"));
    number->setValue(1);
    auto* label = new app::ElidedLabel(this);
    label->setFullText(QStringLiteral("shortened label"));
    auto* tabs = new QTabBar(this);
    tabs->setElideMode(Qt::ElideRight);
    tabs->addTab(QStringLiteral("name of a tab"));
    tabs->addTab(QStringLiteral("another tab")); // No tab is drawn for a panel that is alone.
    auto* tree = new QTreeWidget(this);
    tree->setHeaderLabels({QStringLiteral("name of a column")});
    tree->header()->setStretchLastSection(true);
    new QTreeWidgetItem(tree, {QStringLiteral("entry of a list")});
    (new QTreeWidgetItem(tree, {QStringLiteral("entry with its whole in the tip")}))
        ->setToolTip(0, QStringLiteral("entry with its whole in the tip"));
    resize(wide, 300);
    int top = 0;
    for (QWidget* part : std::initializer_list<QWidget*>{number, label, tabs, tree}) {
      part->setGeometry(0, top, wide, part == tree ? 120 : 30);
      top += 40;
    }
    show();
    QTest::qWait(0);
  }
};

TEST(CutTexts, AreFoundInNumbersShortenedLabelsTabsColumnsAndEntries) {
  CutTexts cut;
  collectAll(NarrowTexts(60), "narrow", cut);
  const auto found = [&cut](const char* text) {
    return std::any_of(cut.begin(), cut.end(),
                       [text](const std::string& one) { return one.find(text) != std::string::npos; });
  };
  for (const char* text : {"special value", "1 millilitres", "shortened label", "name of a tab",
                           "name of a column", "entry of a list"})
    EXPECT_TRUE(found(text)) << text;
  EXPECT_FALSE(found("in the tip")) << "an entry with a tip may be shortened";
  CutTexts none;
  collectAll(NarrowTexts(400), "wide", none);
  for (const std::string& text : none)
    ADD_FAILURE() << text;
}

/// On a small screen, and on one of 1920 x 1200 pixels at 200 %.
TEST_P(InLanguage, NothingIsCutOffInAnyModeOnASmallScreenOrATwiceAsLargeScale) {
  CutTexts cut;
  for (const QSize& screen : {QSize(1440, 900), QSize(1280, 800), QSize(960, 600)}) {
    window().resize(screen);
    for (const auto& mode : window().modes().all()) {
      const std::string id = mode->description().id, where = id + ' ' + std::to_string(screen.width());
      window().setMode(id);
      settle();
      EXPECT_LE(window().width(), screen.width()) << id << " needs a larger window";
      EXPECT_LE(window().minimumSizeHint().height(), screen.height()) << where;
      collectAll(window(), where, cut);
    }
  }
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

TEST_P(InLanguage, NothingIsCutOffInTheDialogsAndTheImport) {
  constexpr int kRoom = 560; // Of a screen of 600 logical pixels, without a frame.
  window().resize(960, 600);
  CutTexts cut;
  const auto look = [&](QDialog& dialog, const char* where) {
    dialog.show();
    settle();
    EXPECT_LE(dialog.height(), kRoom) << where;
    collectAll(dialog, where, cut);
    dialog.close();
  };
  app::LessonDialog lesson(window().lessons().plan());
  look(lesson, "lesson");
  window().actions()["handles.table"]->trigger();
  look(find<QDialog>("handleTable"), "table of handles");
  look(window().play().chooseSeries(), "series");
  geometry::TriangleMesh small = sphere(3, 0.07);
  small.triangles = small.triangles.bottomRows(small.triangles.rows() - 20).eval();
  const QString file = path(QStringLiteral("liver.stl"));
  medical_io::writeSurface(file.toStdString(), small);
  open(file);
  ASSERT_TRUE(window().imports().isOpen());
  collectAll(window(), "import", cut);
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

TEST_P(InLanguage, NothingIsCutOffInTheMovieTheCirculationTheQuizAndTheLecture) {
  window().resize(960, 600);
  CutTexts cut;
  const auto look = [&](const char* where) {
    settle();
    collectAll(window(), where, cut);
  };
  ASSERT_TRUE(find<QWidget>("recordBox").isVisible()) << "the movie's box";
  find<QAbstractButton>("scenario.exercise").click();
  const app::CirculationModel& circulation = window().play().circulation();
  ASSERT_TRUE(waitUntil([&] { return circulation.settled() && circulation.present(); }));
  window().playback().pause();
  EXPECT_TRUE(find<QWidget>("circulationNumbers").isVisible());
  look("circulation");
  window().setMode("explore");
  window().actions()["quiz.start"]->trigger();
  ASSERT_TRUE(find<QLabel>("quizQuestion").isVisible());
  look("quiz");
  window().actions()["quiz.start"]->trigger();
  window().actions()["slides.add"]->trigger();
  window().actions()["view.lecture"]->trigger();
  ASSERT_TRUE(find<QLabel>("lectureCaption").isVisible());
  look("lecture");
  window().actions()["view.lecture"]->trigger();
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

/// In a low view it is scrolled, downwards only.
TEST_P(InLanguage, NothingIsCutOffInTheCardOfKeys) {
  CutTexts cut;
  for (const QSize& screen : {QSize(1600, 1000), QSize(1280, 800), QSize(960, 600)}) {
    const std::string where = "keys " + std::to_string(screen.width());
    window().resize(screen);
    settle();
    window().actions()["help.shortcuts"]->trigger();
    settle();
    const auto& card = *window().findChild<app::ShortcutCard*>();
    ASSERT_TRUE(card.isVisible());
    collectAll(card, where, cut);
    const auto& scroll = *card.findChild<QScrollArea*>();
    EXPECT_LE(scroll.widget()->width(), scroll.viewport()->width()) << where;
    for (const auto* row : scroll.widget()->findChildren<QLabel*>())
      EXPECT_TRUE(scroll.widget()->rect().contains(row->geometry()))
          << where << ": \"" << row->text().toStdString() << "\" lies beside it";
    window().actions()["help.shortcuts"]->trigger();
  }
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

TEST_P(InLanguage, NothingIsCutOffInTheHeadersOfTwoComparedViews) {
  window().resize(960, 600);
  CutTexts cut;
  app::Comparison& comparison = parts().comparison();
  const auto look = [&](const std::string& what) {
    for (const char* mode : {"play", "deform"}) {
      window().setMode(mode);
      settle();
      const std::string where = what + " in " + mode;
      const auto headers = window().findChildren<app::SideHeader*>();
      ASSERT_EQ(headers.size(), 2) << where;
      EXPECT_EQ(headers[0]->height(), headers[1]->height()) << where << ": one view is lower than the other";
      for (const app::SideHeader* header : headers) {
        collectAll(*header, where, cut);
        for (const auto* part : header->findChildren<QWidget*>())
          if (part->isVisible() && part->width() > 0) {
            const QRect place(part->mapTo(header, QPoint()), part->size());
            EXPECT_TRUE(header->rect().contains(place)) << where << ": " << part->metaObject()->className()
                                                        << ' ' << part->objectName().toStdString();
          }
      }
    }
  };
  window().actions()["play.compare"]->trigger();
  look("rates");
  window().actions()["play.compareSystems"]->trigger();
  ASSERT_NE(comparison.comparedSystem(), nullptr);
  look("coordinates");
  const auto& header = find<app::SideHeader>("sideHeader");
  const int inTwoRows = header.height();
  const auto& list = find<app::SystemCombo>("secondSystem");
  window().resize(1900, 1000);
  settle();
  EXPECT_LT(header.height(), inTwoRows) << "there is room for one row";
  EXPECT_EQ(list.shownText(), list.currentText());
  look("coordinates in a large window");
  for (const std::string& text : cut)
    ADD_FAILURE() << text;
}

TEST_P(InLanguage, NoTwoEntriesOfAMenuHaveOneLetter) {
  const auto expectDifferent = [](const QWidget& menu, const QString& title) {
    std::set<QChar> taken;
    for (const QAction* entry : menu.actions()) {
      const int mark = entry->text().indexOf(QLatin1Char('&'));
      if (mark < 0 || mark + 1 >= entry->text().size() || !entry->isVisible())
        continue;
      EXPECT_TRUE(taken.insert(entry->text()[mark + 1].toLower()).second)
          << title.toStdString() << ": " << entry->text().toStdString();
    }
  };
  expectDifferent(*window().menuBar(), QStringLiteral("the bar"));
  for (const QMenu* menu : window().menuBar()->findChildren<QMenu*>())
    expectDifferent(*menu, menu->title());
}

INSTANTIATE_TEST_SUITE_P(Windows, InLanguage, ::testing::Values("en", "de", "es", "fr", "ca"),
                         [](const auto& language) { return std::string(language.param); });

} // namespace
} // namespace viscera::tests
