#include "window_test.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QFontInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include <functional>
#include <new>
#include <stdexcept>

#include "viscera/scene/text_font.h"
#include "window/application.h"
#include "window/style/icon.h"
#include "window/style/theme.h"

namespace viscera::tests {
namespace {

double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double channel) {
      return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const double lighter = std::max(luminance(a), luminance(b));
  const double darker = std::min(luminance(a), luminance(b));
  return (lighter + 0.05) / (darker + 0.05);
}

class ThemeTest : public testing::TestWithParam<app::ThemeKind> {};

TEST_P(ThemeTest, TextCanBeReadOnEverySurface) {
  const app::Theme theme = app::themeOf(GetParam());
  for (const QColor& surface : {theme.background, theme.panel, theme.raised, theme.field}) {
    EXPECT_GE(contrast(theme.text, surface), 7);
    EXPECT_GE(contrast(theme.muted, surface), 4.5) << surface.name().toStdString();
    EXPECT_GE(contrast(theme.accent, surface), 3);
  }
  EXPECT_GE(contrast(theme.accentText, theme.accent), 4.5);
}

TEST_P(ThemeTest, TheStyleSheetHasNoWordLeftUnreplaced) {
  const QString sheet = app::styleSheetOf(app::themeOf(GetParam()));
  ASSERT_FALSE(sheet.isEmpty());
  const QString rules = QString(sheet).remove(0, sheet.indexOf(QStringLiteral("*/")));
  EXPECT_FALSE(rules.contains(QLatin1Char('@'))) << rules.mid(rules.indexOf('@'), 40).toStdString();
}

INSTANTIATE_TEST_SUITE_P(Both, ThemeTest, testing::Values(app::ThemeKind::dark, app::ThemeKind::light));

class ModeTest : public WindowTest, public testing::WithParamInterface<int> {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
};

TEST_P(ModeTest, NothingIsClippedInASmallWindow) {
  key(static_cast<Qt::Key>(Qt::Key_0 + GetParam()));
  EXPECT_LE(window().minimumSizeHint().width(), 1280);
  EXPECT_LE(window().minimumSizeHint().height(), 800);
  EXPECT_EQ(window().size(), QSize(1280, 800));
  EXPECT_GE(view().width(), 560);
  EXPECT_GE(view().height(), 400);
  for (const QLabel* label : window().findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty() || label->wordWrap())
      continue;
    EXPECT_GE(label->width() + 1, label->minimumSizeHint().width()) << label->text().toStdString();
  }
  for (const QPushButton* button : window().findChildren<QPushButton*>()) {
    if (!button->isVisible())
      continue;
    EXPECT_GE(button->width() + 1, button->minimumSizeHint().width()) << button->text().toStdString();
  }
}

INSTANTIATE_TEST_SUITE_P(Keys, ModeTest, testing::Values(1, 2, 3, 4, 5));

/// As from a mouse: whoever leaves the event gives it to its parent. Qt does that for real events only.
void turnWheel(QWidget& widget) {
  for (QWidget* taker = &widget; taker; taker = taker->parentWidget()) {
    const QPointF middle = QRectF(taker->rect()).center();
    QWheelEvent event(middle, taker->mapToGlobal(middle.toPoint()), QPoint(), QPoint(0, -120), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    event.ignore();
    QApplication::sendEvent(taker, &event);
    if (event.isAccepted())
      return;
  }
}

class PanelWheelTest : public WindowTest, public testing::WithParamInterface<int> {};

TEST_P(PanelWheelTest, TheWheelScrollsThePanelAndChangesNoValue) {
  key(static_cast<Qt::Key>(Qt::Key_0 + GetParam()));
  settle();
  int turned = 0;
  for (QScrollArea* panel : window().findChildren<QScrollArea*>(QStringLiteral("panelScroll"))) {
    if (!panel->isVisible())
      continue;
    QScrollBar* bar = panel->verticalScrollBar();
    const auto turnOver = [&](QWidget* field, const auto& value) {
      if (!field->isVisible())
        return;
      bar->setValue(0);
      const auto before = value();
      turnWheel(*field);
      EXPECT_EQ(value(), before) << field->metaObject()->className() << ' '
                                 << field->objectName().toStdString();
      EXPECT_EQ(bar->value() > 0, bar->maximum() > 0)
          << field->metaObject()->className() << ' ' << field->objectName().toStdString() << " of "
          << panel->widget()->metaObject()->className();
      ++turned;
    };
    for (QComboBox* field : panel->findChildren<QComboBox*>())
      turnOver(field, [field] { return field->currentIndex(); });
    for (QSpinBox* field : panel->findChildren<QSpinBox*>())
      turnOver(field, [field] { return field->value(); });
    for (QDoubleSpinBox* field : panel->findChildren<QDoubleSpinBox*>())
      turnOver(field, [field] { return field->value(); });
    for (QSlider* field : panel->findChildren<QSlider*>())
      turnOver(field, [field] { return field->value(); });
  }
  EXPECT_GT(turned, 0);
}

// Each of these modes shows fields from the beginning.
INSTANTIATE_TEST_SUITE_P(Keys, PanelWheelTest, testing::Values(2, 4, 5));

TEST_F(WindowTest, TheWindowFitsAScreenAtTwiceTheScale) {
  window().showWelcome(true);
  settle();
  // 1600 x 1000 pixels at 200 % are 800 x 500 logical ones.
  EXPECT_LE(window().minimumSizeHint().width(), 800);
  EXPECT_LE(window().minimumSizeHint().height(), 500);
  const QSize laptop(683, 384); // 1366 x 768 pixels.
  window().resize(laptop);
  settle();
  EXPECT_EQ(window().size(), laptop);
}

TEST_F(WindowTest, PanelsThatANarrowWindowMadeNarrowAreAsBeforeInAWideOneAndTheNextTime) {
  const auto widths = [this] {
    return QList<int>{find<QDockWidget>("organs").width(), find<QDockWidget>("properties").width()};
  };
  const QList<int> before = widths();
  const auto makeNarrow = [this] {
    window().resize(window().minimumSizeHint().width(), 800);
    settle();
  };
  makeNarrow();
  window().resize(1280, 800);
  settle();
  EXPECT_EQ(widths(), before);
  makeNarrow();
  reopenWindow();
  EXPECT_EQ(widths(), before);
}

TEST_F(WindowTest, ViewsWriteInTheFontOfThePanels) {
  const int font = QFontDatabase::addApplicationFont(QString::fromStdString(scene::textFontFile()));
  ASSERT_GE(font, 0) << scene::textFontFile();
  const QString family = QFontInfo(window().font()).family();
  EXPECT_TRUE(QFontDatabase::applicationFontFamilies(font).contains(family)) << family.toStdString();
  QFontDatabase::removeApplicationFont(font);
}

TEST_F(WindowTest, WhatAnEmptyFieldSaysIsNotTakenForItsText) {
  auto& search = find<QLineEdit>("organSearch");
  const app::Theme theme = app::themeOf(app::ThemeKind::dark);
  EXPECT_EQ(search.palette().color(QPalette::PlaceholderText), theme.muted);
  EXPECT_EQ(search.palette().color(QPalette::Text), theme.text);
}

TEST_F(WindowTest, TheViewDrawsTheOrganInItsColour) {
  open(sphereFile());
  const QImage picture = view().grab().toImage();
  const QColor middle = picture.pixelColor(picture.width() / 2, picture.height() / 2);
  EXPECT_GT(middle.red(), middle.blue() + 20) << middle.name().toStdString();
  QSet<QRgb> colors;
  for (int x = 0; x < picture.width(); x += 3)
    colors.insert(picture.pixel(x, picture.height() / 2));
  EXPECT_GT(colors.size(), 20) << "a shaded organ has many tones";
}

TEST_F(WindowTest, TheThemeChangesEverythingAndIsRemembered) {
  ASSERT_EQ(QApplication::palette().color(QPalette::Window), app::themeOf(app::ThemeKind::dark).panel);
  const QColor darkCorner = view().grab().toImage().pixelColor(5, 5);
  window().setTheme(app::ThemeKind::light);
  settle();
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), app::themeOf(app::ThemeKind::light).panel);
  EXPECT_GT(view().grab().toImage().pixelColor(5, 5).lightness(), darkCorner.lightness() + 60);
  reopenWindow();
  EXPECT_EQ(QApplication::palette().color(QPalette::Window), app::themeOf(app::ThemeKind::light).panel);
}

TEST_F(WindowTest, AHiddenPanelStaysHiddenUntilTheStandardLayoutIsAskedFor) {
  auto* organs = window().findChild<QDockWidget*>(QStringLiteral("organs"));
  ASSERT_NE(organs, nullptr);
  organs->toggleViewAction()->trigger();
  reopenWindow();
  organs = window().findChild<QDockWidget*>(QStringLiteral("organs"));
  EXPECT_FALSE(organs->isVisible());
  window().actions()["view.layout"]->trigger();
  EXPECT_TRUE(organs->isVisible());
}

TEST_F(WindowTest, AFaultInAnEventBecomesAMessageAndTheWindowGoesOn) {
  auto& application = *static_cast<app::Application*>(qApp);
  application.setGuard(
      [this](const std::function<void()>& work) { return window().workspace().guarded(work); });
  const auto throwing = [this](const std::function<void()>& fault) {
    QAction action(&window());
    QObject::connect(&action, &QAction::triggered, &action, fault);
    QMetaObject::invokeMethod(&action, "trigger", Qt::QueuedConnection);
    QTest::qWait(50);
    return message();
  };
  EXPECT_TRUE(throwing([] { throw std::logic_error("row 7 of 5"); }).contains(QStringLiteral("Row 7 of 5")));
  EXPECT_TRUE(throwing([] { throw std::bad_alloc(); }).contains(QStringLiteral("not enough memory")));
  EXPECT_TRUE(throwing([] { throw 7; }).contains(QStringLiteral("unknown kind")));
  application.setGuard({});
  key(Qt::Key_3);
  EXPECT_EQ(window().mode(), "deform");
}

/// A name of an organ, as it may stand in a file of somebody else.
const char* const kNameWithTags = "<h1>liver</h1><img src=\"/etc/hostname\">";

TEST(TextsOfFiles, AreShownWithTheirTagsInLabelsAndMessageBoxes) {
  const QString name = QLatin1String(kNameWithTags);
  QLabel plain(QStringLiteral("liver")), tagged(name);
  tagged.show();
  EXPECT_EQ(tagged.textFormat(), Qt::PlainText);
  EXPECT_EQ(tagged.text(), name);
  EXPECT_LT(tagged.sizeHint().height(), 2 * plain.sizeHint().height()) << "one line, no heading";
  QMessageBox box(QMessageBox::Question, QStringLiteral("Save?"), name);
  box.setInformativeText(name);
  box.show();
  for (const QLabel* label : box.findChildren<QLabel*>())
    EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->objectName().toStdString();
  QLabel formatted(QStringLiteral("<b>beat</b>"));
  formatted.setTextFormat(Qt::RichText);
  formatted.show();
  EXPECT_EQ(formatted.textFormat(), Qt::RichText) << "tags of the program's own";
}

TEST_F(WindowTest, TagsInTheNameOfAnOrganAreShownInItsTooltip) {
  QToolTip::showText(window().mapToGlobal(QPoint(50, 50)), QLatin1String(kNameWithTags), &window());
  int tips = 0;
  for (const QWidget* widget : QApplication::topLevelWidgets()) {
    const auto* tip = qobject_cast<const QLabel*>(widget);
    if (!tip || !tip->inherits("QTipLabel") || tip->text() != QLatin1String(kNameWithTags))
      continue;
    ++tips;
    EXPECT_EQ(tip->textFormat(), Qt::PlainText);
  }
  EXPECT_EQ(tips, 1);
  QToolTip::hideText();
}

TEST_F(WindowTest, TheLegendOfACirculationKeepsItsColours) {
  EXPECT_EQ(find<QLabel>("circulationLegend").textFormat(), Qt::RichText);
}

TEST_F(WindowTest, QuestionMarkShowsTheShortcutsAndEscapeHidesThem) {
  const auto shown = [this] {
    for (const QLabel* label : window().findChildren<QLabel*>())
      if (label->isVisible() && label->text() == QLatin1String("Mouse and keys"))
        return true;
    return false;
  };
  EXPECT_FALSE(shown());
  key(Qt::Key_Question, Qt::ShiftModifier);
  EXPECT_TRUE(shown());
  key(Qt::Key_Escape);
  EXPECT_FALSE(shown());
}

TEST_F(WindowTest, AnIconWithoutRoomIsDrawnAsNothingAndInSilence) {
  QPixmap ground(8, 8);
  testing::internal::CaptureStderr();
  {
    QPainter painter(&ground);
    app::icon("lock").paint(&painter, QRect());
    EXPECT_TRUE(app::icon("lock").pixmap(QSize(0, 0)).isNull());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(WindowTest, EveryIconDrawsSomethingAtSixteenPixels) {
  for (const QAction* action : window().actions().all()) {
    if (action->icon().isNull())
      continue;
    const QImage image = action->icon().pixmap(16, 16).toImage();
    int drawn = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        drawn += qAlpha(image.pixel(x, y)) > 100;
    EXPECT_GT(drawn, 8) << action->objectName().toStdString();
  }
}

} // namespace
} // namespace viscera::tests
