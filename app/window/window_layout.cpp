#include "window/window_layout.h"

#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

#include <algorithm>
#include <map>
#include <utility>

#include "window/widgets/panel_dock.h"

namespace viscera::app {
namespace {

constexpr int kWindowWidth = 1440;
constexpr int kWindowHeight = 900;
constexpr int kLeftWidth = 304;
constexpr int kRightWidth = 288;
constexpr int kImportWidth = 360;
/// A narrower window leaves the panels less than these widths.
constexpr int kWidthForPanels = 1200;
constexpr int kDockedChartHeight = 200;
constexpr int kHandlesHeight = 300;
/// What a window manager draws around the window, at most.
constexpr QSize kWindowFrame(16, 48);

/// The key of a panel in a mode, for the settings and the user's choices.
QString nameIn(const std::string& mode, const QDockWidget& dock) {
  return QString::fromStdString(mode) + QLatin1Char('/') + dock.objectName();
}

} // namespace

WindowLayout::WindowLayout(QMainWindow& window, Actions& actions) : QObject(&window), window_(window) {
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks);
  actions.add("view.layout",
              {tr("&Standard layout"), "reset", {}, tr("Restore the first arrangement of all panels")},
              [this] { bringBack(); });
  actions.addToggle(
      "view.fullScreen",
      {tr("&Full screen"), nullptr, {QKeySequence(Qt::Key_F11)}, tr("The window takes the whole screen")},
      false, [this](bool on) { setFullScreen(on); });
}

PanelDock* WindowLayout::addDock(const QString& title, const char* id, Qt::DockWidgetArea area,
                                 QWidget* contents, bool scrolling) {
  auto* dock = new PanelDock(title, id, &window_);
  dock->setContents(contents, scrolling);
  window_.addDockWidget(area, dock);
  docks_.push_back(dock);
  connect(dock, &PanelDock::chosen, this,
          [this, dock](bool shown) { chosen_[nameIn(mode_, *dock)] = shown; });
  return dock;
}

void WindowLayout::placeRail(QWidget* rail) {
  auto* bar = new QToolBar(tr("Modes"), &window_);
  bar->setObjectName(QStringLiteral("modes"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->toggleViewAction()->setVisible(false);
  bar->layout()->setContentsMargins(0, 0, 0, 0);
  bar->setStyleSheet(QStringLiteral("QToolBar { border: none; padding: 0; spacing: 0; }"));
  bar->addWidget(rail);
  window_.addToolBar(Qt::LeftToolBarArea, bar);
  rail_ = bar;
}

void WindowLayout::place(const Panels& panels) {
  placeRail(panels.rail);
  auto* organs = addDock(tr("Organs"), "organs", Qt::LeftDockWidgetArea, panels.organs, true);
  auto* handles = addDock(tr("Handles"), "handles", Qt::LeftDockWidgetArea, panels.handles, true);
  properties_ = addDock(tr("Properties"), "properties", Qt::RightDockWidgetArea, panels.properties, false);
  auto* timeline = timeline_ =
      addDock(tr("Timeline"), "timeline", Qt::BottomDockWidgetArea, panels.timeline, false);
  timeline->setTitleBarWidget(new QWidget(timeline));
  panels.timeline->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  panels.timeline->installEventFilter(this);
  auto* chart = charts_ = addDock(tr("Volumes"), "volumes", Qt::BottomDockWidgetArea, panels.charts, false);
  chart->setTitleBarWidget(new QWidget(chart));
  window_.splitDockWidget(timeline, chart, Qt::Vertical);
  window_.resizeDocks({organs, properties_}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
  window_.resizeDocks({organs, handles}, {2, 3}, Qt::Vertical);
  window_.resizeDocks({chart}, {kDockedChartHeight}, Qt::Vertical);
  heights_ = {{chart, kDockedChartHeight}, {handles, kHandlesHeight}};
  widths_ = {{organs, {kLeftWidth, kWidthForPanels}}, {properties_, {kRightWidth, kWidthForPanels}}};
  window_.installEventFilter(this);
  auto* slides = addDock(tr("Slides"), "slides", Qt::LeftDockWidgetArea, panels.slides, false);
  slides->hide();
  imports_ = new PanelDock(tr("Import"), "import", &window_);
  imports_->setContents(panels.imports, false);
  window_.tabifyDockWidget(properties_, imports_);
  imports_->hide();
}

void WindowLayout::showImports() {
  importing_ = true;
  imports_->show();
  imports_->raise();
  window_.resizeDocks({imports_}, {kImportWidth}, Qt::Horizontal);
}

void WindowLayout::hideImports() {
  importing_ = false;
  imports_->hide();
  window_.resizeDocks({properties_}, {kRightWidth}, Qt::Horizontal);
}

void WindowLayout::follow(const Mode& mode) {
  const std::string id = mode.description().id;
  const UsefulPanels useful = mode.panels();
  if (id == mode_ && useful == useful_)
    return;
  mode_ = id;
  useful_ = useful;
  arrange();
}

void WindowLayout::arrange() {
  if (bare_ || mode_.empty())
    return;
  const std::map<QString, bool> useful = {{QStringLiteral("organs"), true},
                                          {QStringLiteral("handles"), useful_.handles},
                                          {QStringLiteral("properties"), true},
                                          {QStringLiteral("timeline"), useful_.timeline},
                                          {QStringLiteral("volumes"), useful_.charts},
                                          {QStringLiteral("slides"), false}};
  learnHeights();
  for (PanelDock* dock : docks_)
    dock->setVisible(chosen_.value(nameIn(mode_, *dock), useful.at(dock->objectName())).toBool());
  keepHeights();
}

/// The height of the timeline depends on the number of its rows, which depends on the sequence. When it
/// changes, Qt resizes the chart and gives the difference to the view, so the heights are set again. This
/// filter receives the event before Qt has laid out the window.
bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_) {
    watchWindow(*event);
  } else if (event->type() == QEvent::LayoutRequest && timeline_->isVisible()) {
    const int height = timeline_->widget()->sizeHint().height();
    if (std::exchange(timelineHeight_, height) != height) {
      learnHeights();
      keepHeights();
    }
  }
  return QObject::eventFilter(watched, event);
}

/// Qt makes panels narrower in a narrow window and does not widen them again. The separators between panels
/// belong to the window: widths that change while the mouse is pressed there were set by the user.
void WindowLayout::watchWindow(const QEvent& event) {
  if (event.type() == QEvent::Resize) {
    if (window_.width() > std::exchange(windowWidth_, window_.width()))
      QTimer::singleShot(0, this, &WindowLayout::widenPanels); // Qt lays the panels out first.
  } else if (event.type() == QEvent::MouseButtonPress) {
    for (auto known = widths_.constBegin(); known != widths_.constEnd(); ++known)
      pressed_[known.key()] = known.key()->width();
  } else if (event.type() == QEvent::MouseButtonRelease) {
    for (auto known = widths_.begin(); known != widths_.end(); ++known)
      if (known.key()->width() != pressed_.value(known.key(), known.key()->width()))
        known.value() = {known.key()->width(), window_.width()};
    pressed_.clear();
  }
}

/// Restores the widths that the user has set, in proportion if the window is narrower than it was then.
void WindowLayout::widenPanels() {
  QList<QDockWidget*> docks;
  QList<int> widths;
  for (auto known = widths_.constBegin(); known != widths_.constEnd(); ++known) {
    const Width& wish = known.value();
    const int wide = std::min(wish.panel, wish.panel * window_.width() / wish.window);
    if (known.key()->isVisible() && !known.key()->isFloating() && known.key()->width() < wide) {
      docks.push_back(known.key());
      widths.push_back(wide);
    }
  }
  if (!docks.isEmpty())
    window_.resizeDocks(docks, widths, Qt::Horizontal);
}

/// Remembers the heights that the user has set. Heights that differ from the requested ones because of Qt's
/// layout are ignored; otherwise panels would shrink with every change of the mode.
void WindowLayout::learnHeights() {
  for (auto known = heights_.begin(); known != heights_.end(); ++known)
    if (known.key()->isVisible() && !resizing_ && heightOf(*known.key()) != settled_.value(known.key(), -1))
      known.value() = heightOf(*known.key());
}

void WindowLayout::keepHeights() {
  giveHeights();
  // Qt shares the room anew once more when it lays the panels out.
  if (!std::exchange(resizing_, true))
    QTimer::singleShot(0, this, [this] {
      giveHeights();
      resizing_ = false;
      QTimer::singleShot(0, this, [this] {
        for (auto known = heights_.constBegin(); known != heights_.constEnd(); ++known)
          settled_[known.key()] = heightOf(*known.key());
      });
    });
}

/// Without the height that a table beside the charts has taken for itself.
int WindowLayout::heightOf(const QDockWidget& dock) const {
  return &dock == charts_ ? chartsBefore_.value_or(charts_->height()) : dock.height();
}

/// Panels are as high as they were, also those that stay while others come and go.
void WindowLayout::giveHeights() {
  QList<QDockWidget*> docks;
  QList<int> heights;
  if (timeline_->isVisible()) { // Otherwise its height would be taken from the chart.
    docks.push_back(timeline_);
    heights.push_back(timeline_->sizeHint().height());
  }
  for (auto known = heights_.constBegin(); known != heights_.constEnd(); ++known)
    if (known.key()->isVisible() && !(known.key() == charts_ && chartsBefore_)) {
      docks.push_back(known.key());
      heights.push_back(known.value());
    }
  window_.resizeDocks(docks, heights, Qt::Vertical);
}

void WindowLayout::setFullScreen(bool full) {
  window_.setWindowState(full ? window_.windowState() | Qt::WindowFullScreen
                              : window_.windowState() & ~Qt::WindowFullScreen);
}

void WindowLayout::setBare(bool bare) {
  if (bare == bare_)
    return;
  bare_ = bare;
  if (bare) {
    wasFullScreen_ = window_.isFullScreen();
    const std::vector<QWidget*> around = {window_.menuBar(), window_.statusBar(), rail_};
    for (QWidget* part : around)
      if (!part->isHidden())
        putAway_.push_back(part);
    for (PanelDock* dock : docks_)
      dock->hide();
  }
  for (QWidget* part : putAway_)
    part->setVisible(!bare);
  if (!bare) {
    putAway_.clear();
    arrange();
  }
  if (!wasFullScreen_)
    setFullScreen(bare);
}

void WindowLayout::fitCharts(std::optional<int> height) {
  if (height && *height > charts_->height() && charts_->isVisible()) {
    if (!chartsBefore_)
      chartsBefore_ = charts_->height();
    window_.resizeDocks({charts_}, {*height}, Qt::Vertical);
  } else if (!height && chartsBefore_) {
    window_.resizeDocks({charts_}, {*std::exchange(chartsBefore_, std::nullopt)}, Qt::Vertical);
  }
}

void WindowLayout::bringBack() {
  chosen_.clear();
  for (auto known = widths_.begin(); known != widths_.end(); ++known)
    known.value() = {known.key() == properties_ ? kRightWidth : kLeftWidth, kWidthForPanels};
  window_.restoreState(standard_);
  arrange();
  if (importing_)
    showImports();
}

void WindowLayout::restore(const Settings& settings) {
  const QSize room = window_.screen()->availableSize() - kWindowFrame;
  window_.resize(QSize(kWindowWidth, kWindowHeight).boundedTo(room));
  standard_ = window_.saveState();
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  window_.restoreState(settings.value("window/layout").toByteArray());
  if (!window_.isMaximized() && !window_.isFullScreen())
    window_.resize(window_.size().boundedTo(room));
  chosen_ = settings.value("window/panels").toMap();
  const QVariantMap widths = settings.value("window/panelWidths").toMap();
  for (auto known = widths_.begin(); known != widths_.end(); ++known)
    if (const QSize wish = widths.value(known.key()->objectName()).toSize(); !wish.isEmpty())
      known.value() = {wish.width(), wish.height()};
  arrange();
}

void WindowLayout::save(Settings& settings) const {
  settings.setValue("window/geometry", window_.saveGeometry());
  settings.setValue("window/layout", window_.saveState());
  settings.setValue("window/panels", chosen_);
  QVariantMap widths; // Each with that of the window.
  for (auto known = widths_.constBegin(); known != widths_.constEnd(); ++known)
    widths[known.key()->objectName()] = QSize(known.value().panel, known.value().window);
  settings.setValue("window/panelWidths", widths);
}

} // namespace viscera::app
