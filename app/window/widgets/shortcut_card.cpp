#include "window/widgets/shortcut_card.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QToolButton>

#include <utility>

#include "window/style/icon.h"

namespace viscera::app {
namespace {

/// Rows of keys and meanings, in two columns.
QWidget* makeTable(const std::vector<std::pair<QString, QString>>& rows, QWidget* parent) {
  auto* table = new QWidget(parent);
  table->setObjectName(QStringLiteral("page"));
  table->setAttribute(Qt::WA_StyledBackground);
  auto* grid = new QGridLayout(table);
  grid->setContentsMargins(0, 0, 8, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  const int half = static_cast<int>(rows.size() + 1) / 2;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    auto* keys = new QLabel(rows[i].first, table);
    keys->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* meaning = new QLabel(rows[i].second, table);
    meaning->setObjectName(QStringLiteral("muted"));
    const int column = i < half ? 0 : 3;
    grid->addWidget(keys, i % half, column);
    grid->addWidget(meaning, i % half, column + 1);
  }
  grid->setColumnMinimumWidth(2, 16);
  grid->setRowStretch(half, 1);
  return table;
}

/// Adds the actions with a key, menu by menu, each once.
void collect(const QList<QAction*>& actions, QList<QAction*>& found) {
  for (QAction* action : actions) {
    if (action->menu())
      collect(action->menu()->actions(), found);
    else if (!action->shortcuts().isEmpty() && !found.contains(action))
      found.push_back(action);
  }
}

} // namespace

ShortcutCard::ShortcutCard(const QMenuBar& menus, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcomeCard"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 8, 12);
  auto* heading = new QHBoxLayout;
  auto* title = new QLabel(tr("Mouse and keys"), this);
  QFont font = title->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.25);
  title->setFont(font);
  auto* closeButton = new QToolButton(this);
  closeButton->setIcon(icon("close"));
  closeButton->setIconSize(QSize(14, 14));
  closeButton->setToolTip(tr("Close (Esc)"));
  closeButton->setAccessibleName(tr("Close"));
  connect(closeButton, &QToolButton::clicked, this, &QWidget::hide);
  heading->addWidget(title, 1);
  heading->addWidget(closeButton);
  column->addLayout(heading);
  std::vector<std::pair<QString, QString>> rows = {{tr("Left drag"), tr("Rotate, or move a handle")},
                                                   {tr("Middle, Shift+left drag"), tr("Pan")},
                                                   {tr("Right drag, wheel"), tr("Zoom")},
                                                   {tr("Click"), tr("Select, or add a handle")},
                                                   {tr("Shift or Ctrl+click"), tr("Add to the selection")},
                                                   {tr("Esc"), tr("Cancel a drag, close a message")}};
  QList<QAction*> actions;
  collect(menus.actions(), actions);
  for (const QAction* action : actions) {
    QString meaning = action->text();
    meaning.remove(QLatin1Char('&'));
    rows.emplace_back(action->shortcut().toString(QKeySequence::NativeText), meaning);
  }
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("panelScroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(makeTable(rows, scroll));
  scroll->setMinimumSize(200, 100);
  column->addWidget(scroll, 1);
  const QSize content = scroll->widget()->sizeHint();
  scroll->setMaximumHeight(content.height() + 4);
  setMaximumWidth(content.width() + 48);
  hide();
}

} // namespace viscera::app
