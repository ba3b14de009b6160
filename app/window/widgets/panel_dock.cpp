#include "window/widgets/panel_dock.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QChildEvent>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

bool takesValuesFromTheWheel(const QObject* object) {
  return qobject_cast<const QComboBox*>(object) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(object) != nullptr ||
         qobject_cast<const QSlider*>(object) != nullptr;
}

/// A panel is as wide as its contents need: some languages have longer words.
class WidthKeeper final : public QObject {
public:
  WidthKeeper(QScrollArea& scroll, QWidget* contents) : QObject(contents), scroll_(scroll) {
    contents->installEventFilter(this);
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest)
      scroll_.setMinimumWidth(std::min(kWidest, static_cast<QWidget*>(watched)->minimumSizeHint().width() +
                                                    scroll_.verticalScrollBar()->sizeHint().width()));
    return QObject::eventFilter(watched, event);
  }

  static constexpr int kWidest = 360;
  QScrollArea& scroll_;
};

/// The wheel over a panel scrolls the panel, also where the pointer happens to be over a list of choices, a
/// number or a slider: those keep their values. Guards all that is in `contents`, now and later; lives as
/// long as `contents`.
class WheelGuard final : public QObject {
public:
  explicit WheelGuard(QWidget* contents) : QObject(contents) { watch(contents); }

protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ChildAdded)
      watch(static_cast<QChildEvent*>(event)->child());
    if (event->type() != QEvent::Wheel || !takesValuesFromTheWheel(watched))
      return QObject::eventFilter(watched, event);
    // Kept from the widget, and not accepted: so Qt offers it to the parents, of which one scrolls.
    event->ignore();
    return true;
  }

private:
  void watch(QObject* object) {
    if (!object->isWidgetType())
      return;
    object->installEventFilter(this);
    for (QObject* child : object->children())
      watch(child);
  }
};

} // namespace

PanelDock::PanelDock(const QString& title, const char* id, QWidget* parent) : QDockWidget(title, parent) {
  setObjectName(QLatin1String(id));
  setTitleBarWidget(makeTitle(title));
  connect(toggleViewAction(), &QAction::triggered, this, &PanelDock::chosen);
}

QWidget* PanelDock::makeTitle(const QString& title) {
  auto* bar = new QWidget(this);
  bar->setObjectName(QStringLiteral("dockTitle"));
  bar->setAttribute(Qt::WA_StyledBackground);
  auto* row = makeLayout<QHBoxLayout>(bar, 0, {12, 4, 4, 4});
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
    auto* button = makeIconButton(name, tip, bar, 14);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, slot);
  };
  addButton("float", tr("Float or dock the panel %1").arg(title), [this] { setFloating(!isFloating()); });
  addButton("close", tr("Hide the panel %1 (the View menu shows it again)").arg(title), [this] {
    close();
    Q_EMIT chosen(false);
  });
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
  new WidthKeeper(*scroll, contents);
  return scroll;
}

} // namespace viscera::app
