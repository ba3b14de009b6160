#include "window/widgets/panel_dock.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

#include "window/style/icon.h"
#include "window/widgets/wheel_guard.h"

namespace viscera::app {

PanelDock::PanelDock(const QString& title, const char* id, QWidget* parent) : QDockWidget(title, parent) {
  setObjectName(QLatin1String(id));
  setTitleBarWidget(makeTitle(title));
}

QWidget* PanelDock::makeTitle(const QString& title) {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("dockTitle"));
  bar->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(12, 4, 4, 4);
  row->setSpacing(0);
  auto* label = new QLabel(title, bar);
  label->setObjectName(QStringLiteral("dockTitleText"));
  QFont font = label->font();
  font.setCapitalization(QFont::AllUppercase);
  font.setLetterSpacing(QFont::PercentageSpacing, 106);
  font.setPointSizeF(font.pointSizeF() * 0.88);
  font.setBold(true);
  label->setFont(font);
  row->addWidget(label, 1);
  const auto addButton = [&](const char* name, const QString& tip, auto slot) {
    auto* button = new QToolButton(bar);
    button->setIcon(icon(name));
    button->setIconSize(QSize(14, 14));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, slot);
  };
  addButton("float", tr("Float or dock the panel %1").arg(title), [this] { setFloating(!isFloating()); });
  addButton("close", tr("Hide the panel %1 (the View menu shows it again)").arg(title), [this] { close(); });
  return bar;
}

void PanelDock::setContents(QWidget* contents, bool scrolling) {
  if (!scrolling) {
    contents->setAttribute(Qt::WA_StyledBackground);
    setWidget(contents);
    return;
  }
  setWidget(scrolled(contents));
}

QWidget* scrolled(QWidget* contents) {
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("panelScroll"));
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  contents->setObjectName(QStringLiteral("page"));
  contents->setAttribute(Qt::WA_StyledBackground);
  scroll->setWidget(contents);
  new WheelGuard(contents);
  return scroll;
}

} // namespace viscera::app
