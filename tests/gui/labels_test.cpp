// What is written fits in every language: labels, buttons and the letters of menus.
#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QToolButton>

#include <set>

#include "play_fixture.h"
#include "window/language.h"
#include "window/widgets/elided_label.h"

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
  const int wide = button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
  return mayBeCut(button.text(), button) ? 0 : std::max(0, wide - button.width());
}

/// The texts of a kind of widget that can be seen and are cut off.
template <class Widget>
void collectCut(const QWidget& window, const std::string& where, std::set<std::string>& cut) {
  constexpr int kRounding = 1;
  for (const auto* widget : window.findChildren<Widget*>())
    if (widget->isVisible() && lackOf(*widget) > kRounding)
      cut.insert(where + ": \"" + widget->text().toStdString() + "\" lacks " +
                 std::to_string(lackOf(*widget)) + " pixels");
}

TEST_P(InLanguage, NothingIsCutOffInAnyModeOnASmallScreen) {
  std::set<std::string> cut;
  for (const auto& mode : window().modes().all()) {
    const std::string id = mode->description().id;
    window().setMode(id);
    settle();
    EXPECT_LE(window().width(), 1280) << id << " needs a larger window";
    EXPECT_LE(window().minimumSizeHint().height(), 800) << id;
    collectCut<QLabel>(window(), id, cut);
    collectCut<QAbstractButton>(window(), id, cut);
  }
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
