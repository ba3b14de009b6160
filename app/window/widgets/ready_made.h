#pragma once

#include <QLabel>
#include <QLayout>
#include <QToolButton>

class QAction;
class QPushButton;

/// Functions that create the layouts, labels and buttons that many panels use.
namespace viscera::app {

/// A layout of `parent` (null: to be put into another one); a negative spacing is the style's.
template <typename Layout>
Layout* makeLayout(QWidget* parent, int spacing = -1, const QMargins& margins = {}) {
  auto* layout = parent ? new Layout(parent) : new Layout;
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  return layout;
}

/// A name from a file for where it has one line: longer than a panel is wide, it gives up letters in its
/// middle. The whole name belongs into the tip there.
QString shortenedName(const QString& name, const QWidget& shownIn);

/// A quiet text of as many lines as it takes.
QLabel* makeRemark(const QString& text, QWidget* parent);

/// A button that is an icon of our own set; `tip` is its name, too. Without a size the icon has the style's.
QToolButton* makeIconButton(const char* icon, const QString& tip, QWidget* parent, int size = 0);

/// A button that does an action of the window and shows its name and state.
QPushButton* makeActionButton(QAction* action, QWidget* parent);

/// Writes the widget's text in bold, `factor` times as large.
void embolden(QWidget* widget, double factor = 1);

} // namespace viscera::app
