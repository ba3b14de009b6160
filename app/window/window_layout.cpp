#include "window/window_layout.h"

#include <QLayout>
#include <QMainWindow>
#include <QToolBar>

#include <utility>

#include "window/widgets/panel_dock.h"

namespace viscera::app {
namespace {

constexpr int kWidth = 1440;
constexpr int kHeight = 900;
constexpr int kLeftWidth = 272;
constexpr int kRightWidth = 288;
constexpr int kImportWidth = 360;
constexpr int kChartHeight = 200;

} // namespace

WindowLayout::WindowLayout(QMainWindow& window, Actions& actions) : QObject(&window), window_(window) {
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks);
  actions.add("view.layout",
              {tr("&Standard layout"), "reset", {}, tr("Put every panel back where it was at first")},
              [this] { bringBack(); });
}

PanelDock* WindowLayout::addDock(const QString& title, const char* id, Qt::DockWidgetArea area,
                                 QWidget* contents, bool scrolling) {
  auto* dock = new PanelDock(title, id, &window_);
  dock->setContents(contents, scrolling);
  window_.addDockWidget(area, dock);
  docks_.push_back(dock);
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
}

void WindowLayout::place(const Panels& panels) {
  placeRail(panels.rail);
  auto* organs = addDock(tr("Organs"), "organs", Qt::LeftDockWidgetArea, panels.organs, true);
  auto* handles = addDock(tr("Handles"), "handles", Qt::LeftDockWidgetArea, panels.handles, true);
  properties_ = addDock(tr("Properties"), "properties", Qt::RightDockWidgetArea, panels.properties, false);
  auto* timeline = addDock(tr("Timeline"), "timeline", Qt::BottomDockWidgetArea, panels.timeline, false);
  timeline->setTitleBarWidget(new QWidget(timeline));
  auto* chart = charts_ = addDock(tr("Volumes"), "volumes", Qt::BottomDockWidgetArea, panels.charts, false);
  chart->setTitleBarWidget(new QWidget(chart));
  window_.splitDockWidget(timeline, chart, Qt::Vertical);
  window_.resizeDocks({organs, properties_}, {kLeftWidth, kRightWidth}, Qt::Horizontal);
  window_.resizeDocks({organs, handles}, {2, 3}, Qt::Vertical);
  window_.resizeDocks({chart}, {kChartHeight}, Qt::Vertical);
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
  window_.restoreState(standard_);
  if (importing_)
    showImports();
}

void WindowLayout::restore(const Settings& settings) {
  window_.resize(kWidth, kHeight);
  standard_ = window_.saveState();
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  window_.restoreState(settings.value("window/layout").toByteArray());
}

void WindowLayout::save(Settings& settings) const {
  settings.setValue("window/geometry", window_.saveGeometry());
  settings.setValue("window/layout", window_.saveState());
}

} // namespace viscera::app
