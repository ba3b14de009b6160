#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include "viscera/scene/theme.h"

class QApplication;

namespace viscera::app {

enum class ThemeKind { dark, light };

/// Parses "dark" or "light"; anything else is dark.
ThemeKind themeFromName(const QString& name);
QString nameOf(ThemeKind kind);

/// The colours from which palette, style sheet, icons, chart and 3D view are made.
struct Theme {
  ThemeKind kind = ThemeKind::dark;
  QColor background; ///< Behind and between the panels.
  QColor panel;
  QColor raised; ///< Buttons, cards.
  QColor field;  ///< Input fields.
  QColor border;
  QColor text;
  QColor muted;
  QColor disabled;
  QColor accent;
  QColor accentText; ///< On `accent`.
  QColor warning;
  QColor error;
  bool lecture = false; ///< Views have large type and the strongest contrast.
};

Theme themeOf(ThemeKind kind);

/// The matching theme of 3D views and slices.
scene::Theme viewThemeOf(const Theme& theme);

/// The palette for widgets that no style sheet paints.
QPalette paletteOf(const Theme& theme);

/// The program's style sheet in the theme's colours.
QString styleSheetOf(const Theme& theme);

/// Sets Fusion, palette and style sheet for the whole program; does nothing where this theme is set already.
void applyTheme(QApplication& application, const Theme& theme);

} // namespace viscera::app
