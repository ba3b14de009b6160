#pragma once

#include <QDockWidget>

namespace viscera::app {

/// A dock widget with the program's own title bar: a quiet heading, buttons to float and to hide. Its
/// contents may scroll.
class PanelDock final : public QDockWidget {
  Q_OBJECT

public:
  /// `id` names it in saved layouts.
  PanelDock(const QString& title, const char* id, QWidget* parent = nullptr);

  /// Shows `contents`; with `scrolling` in a scroll area, so that nothing is clipped in a small window.
  void setContents(QWidget* contents, bool scrolling);

Q_SIGNALS:
  /// The user has shown or hidden the panel, by its close button or in the menu.
  void chosen(bool shown);

private:
  QWidget* makeTitle(const QString& title);
};

/// `contents` in an area that scrolls up and down and is as wide as it is given. The wheel scrolls it and
/// changes no value in it.
QWidget* scrolled(QWidget* contents);

} // namespace viscera::app
