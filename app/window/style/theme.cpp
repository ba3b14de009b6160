#include "window/style/theme.h"

#include <QApplication>
#include <QFile>
#include <QStyle>
#include <QStyleFactory>

#include <utility>
#include <vector>

namespace viscera::app {
namespace {

QColor mixed(const QColor& a, const QColor& b, double part) {
  const auto channel = [part](int x, int y) { return static_cast<int>(x + part * (y - x) + 0.5); };
  return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

Theme darkTheme() {
  Theme theme;
  theme.kind = ThemeKind::dark;
  theme.background = QColor("#1f2428");
  theme.panel = QColor("#262c31");
  theme.raised = QColor("#30373d");
  theme.field = QColor("#1f2428");
  theme.border = QColor("#3a4249");
  theme.text = QColor("#e6e8ea");
  theme.muted = QColor("#9aa5ad");
  theme.disabled = QColor("#69737b");
  theme.accent = QColor("#4fb3bf");
  theme.accentText = QColor("#0e1a1c");
  theme.warning = QColor("#e3ab4f");
  theme.error = QColor("#e8746a");
  return theme;
}

Theme lightTheme() {
  Theme theme;
  theme.kind = ThemeKind::light;
  theme.background = QColor("#f4f6f8");
  theme.panel = QColor("#ffffff");
  theme.raised = QColor("#f1f4f6");
  theme.field = QColor("#ffffff");
  theme.border = QColor("#d3dae0");
  theme.text = QColor("#22272b");
  theme.muted = QColor("#5f6b74");
  theme.disabled = QColor("#a3adb5");
  theme.accent = QColor("#00798c");
  theme.accentText = QColor("#ffffff");
  theme.warning = QColor("#b26a00");
  theme.error = QColor("#c0392b");
  return theme;
}

} // namespace

ThemeKind themeFromName(const QString& name) {
  return name == QLatin1String("light") ? ThemeKind::light : ThemeKind::dark;
}

QString nameOf(ThemeKind kind) {
  return kind == ThemeKind::light ? QStringLiteral("light") : QStringLiteral("dark");
}

Theme themeOf(ThemeKind kind) {
  return kind == ThemeKind::light ? lightTheme() : darkTheme();
}

scene::Theme viewThemeOf(const Theme& theme) {
  const bool dark = theme.kind == ThemeKind::dark;
  if (theme.lecture)
    return scene::lectureTheme(dark);
  return dark ? scene::darkTheme() : scene::lightTheme();
}

QPalette paletteOf(const Theme& theme) {
  QPalette palette;
  palette.setColor(QPalette::Window, theme.panel);
  palette.setColor(QPalette::WindowText, theme.text);
  palette.setColor(QPalette::Base, theme.field);
  palette.setColor(QPalette::AlternateBase, theme.raised);
  palette.setColor(QPalette::Text, theme.text);
  palette.setColor(QPalette::PlaceholderText, theme.muted);
  palette.setColor(QPalette::Button, theme.raised);
  palette.setColor(QPalette::ButtonText, theme.text);
  palette.setColor(QPalette::BrightText, theme.error);
  palette.setColor(QPalette::ToolTipBase, theme.raised);
  palette.setColor(QPalette::ToolTipText, theme.text);
  palette.setColor(QPalette::Highlight, theme.accent);
  palette.setColor(QPalette::HighlightedText, theme.accentText);
  palette.setColor(QPalette::Link, theme.accent);
  palette.setColor(QPalette::LinkVisited, theme.accent);
  palette.setColor(QPalette::Mid, theme.border);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, theme.disabled);
  return palette;
}

QString styleSheetOf(const Theme& theme) {
  QFile file(QStringLiteral(":/viscera/style/viscera.qss"));
  if (!file.open(QIODevice::ReadOnly))
    return {};
  QString sheet = QString::fromUtf8(file.readAll());
  // Longer words first: none may be the beginning of a later one.
  const bool dark = theme.kind == ThemeKind::dark;
  const std::vector<std::pair<const char*, QColor>> words = {
      {"@accentHover", mixed(theme.accent, theme.text, 0.15)},
      {"@accentText", theme.accentText},
      {"@accent", theme.accent},
      {"@background", theme.background},
      {"@border", theme.border},
      {"@disabled", theme.disabled},
      {"@error", theme.error},
      {"@field", theme.field},
      {"@groove", mixed(theme.panel, theme.text, 0.2)},
      {"@hover", mixed(theme.panel, theme.text, 0.08)},
      {"@knobBorder", mixed(theme.panel, theme.text, 0.4)},
      {"@knob", dark ? theme.text : theme.panel},
      {"@muted", theme.muted},
      {"@panel", theme.panel},
      {"@pressed", mixed(theme.panel, theme.text, 0.16)},
      {"@raised", theme.raised},
      {"@lectureText", dark ? Qt::white : Qt::black},
      {"@lecture", dark ? Qt::black : Qt::white},
      {"@selection", mixed(theme.panel, theme.accent, 0.22)},
      {"@text", theme.text},
      {"@warning", theme.warning}};
  for (const auto& [word, color] : words)
    sheet.replace(QLatin1String(word), color.name());
  for (const char* image : {"arrowup", "chevron", "check"})
    sheet.replace(QLatin1Char('@') + QLatin1String(image),
                  QStringLiteral(":/viscera/style/%1_%2.svg").arg(QLatin1String(image), nameOf(theme.kind)));
  return sheet;
}

void applyTheme(QApplication& application, const Theme& theme) {
  constexpr const char* kApplied = "visceraTheme";
  const QString name = nameOf(theme.kind);
  if (application.property(kApplied).toString() == name)
    return; // Each change lets every widget look up its rules again.
  application.setProperty(kApplied, name);
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(paletteOf(theme));
  application.setStyleSheet(styleSheetOf(theme));
}

} // namespace viscera::app
