// What is written fits in every language: labels, buttons and the letters of menus.
#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRadioButton>
#include <QScrollArea>
#include <QStyleOptionComboBox>
#include <QTest>
#include <QToolButton>

#include <map>
#include <set>
#include <vector>

#include "play_fixture.h"
#include "shapes.h"
#include "viscera/medical_io/surface_file.h"
#include "window/circulation/circulation_model.h"
#include "window/compare/compared_system.h"
#include "window/compare/comparison.h"
#include "window/compare/side_header.h"
#include "window/import/import_controller.h"
#include "window/language.h"
#include "window/lesson/lesson_dialog.h"
#include "window/lesson/lesson_export.h"
#include "window/track/motion_dialog.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/help_cards.h"
#include "window/widgets/system_combo.h"

namespace viscera::tests {
namespace {

/// A window in the language of its parameter. The locale has to be there before the window is made.
class InLanguage : public PlayMode, public ::testing::WithParamInterface<const char*> {
protected:
  /// The window, with everything that a language changes, made before the fixture's own.
  app::InstalledLanguage language_{QLatin1String(GetParam())};
};

/// Whether a text has to be whole: one that gives way says so by an ellipsis, and has its whole in the tip.
bool mayBeCut(const QString& text, const QWidget& widget) {
  return text.isEmpty() || (text.contains(QChar(0x2026)) && !widget.toolTip().isEmpty()) ||
         qobject_cast<const app::ElidedLabel*>(&widget) != nullptr;
}

/// How many logical pixels a label lacks; 0 when it fits.
int lackOf(const QLabel& label) {
  if (mayBeCut(label.text(), label))
    return 0;
  if (label.wordWrap())
    return std::max(0, label.heightForWidth(label.width()) - label.height());
  return std::max(0, label.sizeHint().width() - label.width());
}

int lackOf(const QAbstractButton& button) {
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
    return 0;
  const bool marked = qobject_cast<const QCheckBox*>(&button) || qobject_cast<const QRadioButton*>(&button);
  const int wide = marked ? button.sizeHint().width()
                          : button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
  return mayBeCut(button.text(), button) ? 0 : std::max(0, wide - button.width());
}

/// Of the entry that a closed list shows. One that shortens its entry leaves some letters, and the tooltip
/// has the whole.
int lackOf(const QComboBox& list) {
  constexpr int kFewestLetters = 3;
  const auto* system = qobject_cast<const app::SystemCombo*>(&list);
  if (system && system->shownText().size() > kFewestLetters)
    return 0;
  QStyleOptionComboBox option;
  option.initFrom(&list);
  option.editable = list.isEditable();
  const int wide =
      list.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &list).width();
  const int icon = list.itemIcon(list.currentIndex()).isNull() ? 0 : list.iconSize().width() + 4;
  return std::max(0, list.fontMetrics().size(0, list.currentText()).width() + icon - wide);
}

QString textOf(const QLabel& label) {
  return label.text();
}
QString textOf(const QAbstractButton& button) {
  return button.text();
}
QString textOf(const QComboBox& list) {
  return list.currentText();
}

/// The texts of a kind of widget that can be seen and are cut off.
template <class Widget>
void collectCut(const QWidget& window, const std::string& where, std::set<std::string>& cut) {
  constexpr int kRounding = 1;
  for (const auto* widget : window.findChildren<Widget*>())
    if (widget->isVisible() && lackOf(*widget) > kRounding)
      cut.insert(where + ": \"" + textOf(*widget).toStdString() + "\" lacks " +
                 std::to_string(lackOf(*widget)) + " pixels");
}

/// Labels, buttons and lists of one parent that lie over each other.
void collectOverlaps(const QWidget& window, const std::string& where, std::set<std::string>& found) {
  const auto nameOf = [](const QWidget& widget) {
    const QString name = widget.objectName().isEmpty() ? widget.accessibleName() : widget.objectName();
    return std::string(widget.metaObject()->className()) + ' ' + name.toStdString();
  };
  std::map<const QWidget*, std::vector<const QWidget*>> siblings;
  for (const auto* widget : window.findChildren<QWidget*>()) {
    const bool speaks = qobject_cast<const QLabel*>(widget) || qobject_cast<const QAbstractButton*>(widget) ||
                        qobject_cast<const QComboBox*>(widget);
    if (!speaks || !widget->isVisible())
      continue;
    for (const QWidget* other : siblings[widget->parentWidget()])
      if (other->geometry().intersects(widget->geometry()))
        found.insert(where + ": " + nameOf(*other) + " lies over " + nameOf(*widget));
    siblings[widget->parentWidget()].push_back(widget);
  }
}

void collectAll(const QWidget& window, const std::string& where, std::set<std::string>& found) {
  collectCut<QLabel>(window, where, found);
  collectCut<QAbstractButton>(window, where, found);
  collectCut<QComboBox>(window, where, found);
  collectOverlaps(window, where, found);
}

/// On a small screen, and on one of 1920 x 1200 pixels at 200 %.
TEST_P(InLanguage, NothingIsCutOffInAnyModeOnASmallScreenOrATwiceAsLargeScale) {
  std::set<std::string> cut;
  for (const QSize& screen : {QSize(1280, 800), QSize(960, 600)}) {
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
  std::set<std::string> cut;
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
  std::set<std::string> cut;
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
  std::set<std::string> cut;
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
  std::set<std::string> cut;
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

INSTANTIATE_TEST_SUITE_P(Windows, InLanguage, ::testing::Values("de", "es", "fr", "ca"),
                         [](const auto& language) { return std::string(language.param); });

} // namespace
} // namespace viscera::tests
