#include "window/modes/window_layout.h"

#include <QAction>
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
constexpr int kWidthForRight = 1200;
/// The names of a segmented patient's organs are whole from here on.
constexpr int kWidthForLeft = 1280;
constexpr int kDockedChartHeight = 176; ///< Three rows of tiles: a heart and its four cavities.
constexpr int kHandlesHeight = 260;
/// Part of the column of organs and handles: the organs have more.
constexpr double kHandlesPart = 0.42;
/// Half a screen of 1366 x 768 pixels, as at twice the scale, is a little larger. What panels ask for does
/// not keep the window from becoming as small: they fold.
constexpr QSize kSmallestWindow(600, 320);
/// The view has that part of the window at least, before panels beside the mode's own page stay;
constexpr double kPartOfView = 0.26;
/// for that page it gives up some of it.
constexpr double kPartBesidePage = 0.2;
/// A smaller view is none.
constexpr QSize kSmallestView(160, 120);
/// The lines between panels.
constexpr int kBetweenPanels = 4;
/// What a window manager draws around the window, at most.
constexpr QSize kWindowFrame(16, 48);

/// The key of a panel in a mode, for the settings and the user's choices.
QString nameIn(const std::string& mode, const QDockWidget& dock) {
  return QString::fromStdString(mode) + QLatin1Char('/') + dock.objectName();
}

} // namespace

QSize firstWindowSize(const QSize& available) {
  return QSize(kWindowWidth, kWindowHeight).boundedTo(available - kWindowFrame);
}

WindowLayout::WindowLayout(QMainWindow& window, Actions& actions) : QObject(&window), window_(window) {
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks);
  window.setMinimumSize(kSmallestWindow);
  actions.add("view.layout",
              {tr("&Standard layout"), "reset", {}, tr("Move all panels to their default places")},
              [this] { bringBack(); });
  fullScreen_ = actions.addToggle(
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
  connect(dock, &PanelDock::chosen, this, [this, dock](bool shown) {
    const QString name = nameIn(mode_, *dock);
    chosen_[name] = shown;
    kept_.remove(name);
    if (shown && withoutRoom().contains(dock))
      kept_.insert(name);
    folded_.remove(dock);
    fitSoon(); // Others may fold for it, or have its room.
  });
  return dock;
}

void WindowLayout::placeRail(QWidget* rail) {
  auto* bar = new QToolBar(tr("Modes"), &window_);
  bar->setObjectName(QStringLiteral("modes"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->toggleViewAction()->setVisible(false);
  bar->setStyleSheet(QStringLiteral("QToolBar { border: none; padding: 0; spacing: 0; }"));
  // After the bar's own sheet: where the application has one already, Qt sets other margins with it.
  bar->layout()->setContentsMargins(0, 0, 0, 0);
  bar->addWidget(rail);
  window_.addToolBar(Qt::LeftToolBarArea, bar);
  rail_ = bar;
}

/// The right column has the whole height, and the panels at the bottom end beside it; in a narrow window they
/// need the whole width. A layout that is restored brings the corners that it was saved with.
void WindowLayout::giveCorners() {
  const Qt::DockWidgetArea area =
      window_.width() < kWidthForRight ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea;
  if (window_.corner(Qt::BottomRightCorner) != area)
    window_.setCorner(Qt::BottomRightCorner, area);
}

void WindowLayout::place(const Panels& panels) {
  giveCorners();
  placeRail(panels.rail);
  auto* organs = organs_ = addDock(tr("Organs"), "organs", Qt::LeftDockWidgetArea, panels.organs, true);
  auto* handles = handles_ = addDock(tr("Handles"), "handles", Qt::LeftDockWidgetArea, panels.handles, true);
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
  window_.resizeDocks({organs, handles}, {3, 2}, Qt::Vertical);
  window_.resizeDocks({chart}, {kDockedChartHeight}, Qt::Vertical);
  heights_ = {{chart, kDockedChartHeight}, {handles, kHandlesHeight}};
  widths_ = {{organs, {kLeftWidth, kWidthForLeft}}, {properties_, {kRightWidth, kWidthForRight}}};
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
  learnHeights();
  folded_ = withoutRoom();
  showPanels();
  keepHeights();
}

void WindowLayout::showPanels() {
  for (PanelDock* dock : docks_)
    dock->setVisible(isWanted(*dock) && !folded_.contains(dock));
}

/// Asks the user's choice, or else the mode.
bool WindowLayout::isWanted(const QDockWidget& dock) const {
  const std::map<QString, bool> useful = {{QStringLiteral("organs"), true},
                                          {QStringLiteral("handles"), useful_.handles},
                                          {QStringLiteral("properties"), true},
                                          {QStringLiteral("timeline"), useful_.timeline},
                                          {QStringLiteral("volumes"), useful_.charts},
                                          {QStringLiteral("slides"), false}};
  return chosen_.value(nameIn(mode_, dock), useful.at(dock.objectName())).toBool();
}

std::vector<WindowLayout::FoldingGroup> WindowLayout::foldingGroups() const {
  const FoldingGroup lists{{organs_, handles_}, kPartOfView};
  const FoldingGroup charts{{charts_}, kPartOfView};
  const FoldingGroup page{{properties_}, kPartBesidePage};
  // A user who works with handles has more use for their list than for the chart.
  return useful_.handles ? std::vector<FoldingGroup>{charts, lists, page}
                         : std::vector<FoldingGroup>{lists, charts, page};
}

QSet<QDockWidget*> WindowLayout::withoutRoom() const {
  QSet<QDockWidget*> folded;
  if (!restored_)
    return folded;
  for (const FoldingGroup& group : foldingGroups()) {
    if (partOfView(folded) >= group.part)
      continue;
    for (QDockWidget* panel : group.panels)
      if (isWanted(*panel) && !kept_.contains(nameIn(mode_, *panel)))
        folded.insert(panel);
  }
  return folded;
}

/// What stays of the window for the view beside the panels, as they will be; not as they are, which has to do
/// with the size that the window had. 0 where there is no view.
double WindowLayout::partOfView(const QSet<QDockWidget*>& folded) const {
  int left = 0, right = 0, high = 0;
  for (PanelDock* dock : docks_) {
    if (!isWanted(*dock) || folded.contains(dock) || dock->isFloating())
      continue;
    const Qt::DockWidgetArea area = window_.dockWidgetArea(dock);
    if (area == Qt::LeftDockWidgetArea)
      left = std::max(left, expectedWidth(*dock) + kBetweenPanels);
    else if (area == Qt::RightDockWidgetArea)
      right = std::max(right, expectedWidth(*dock) + kBetweenPanels);
    else
      high += expectedHeight(*dock) + kBetweenPanels;
  }
  if (importing_ && !imports_->isFloating())
    right = std::max(right, kImportWidth + kBetweenPanels);
  const QSize room = roomForAll();
  const int width = room.width() - left - right, height = room.height() - high;
  if (width < kSmallestView.width() || height < kSmallestView.height())
    return 0;
  return double(width) * height / (double(window_.width()) * window_.height());
}

/// The window without what is always there.
QSize WindowLayout::roomForAll() const {
  return {window_.width() - rail_->sizeHint().width(), window_.height() -
                                                           window_.menuBar()->sizeHint().height() -
                                                           window_.statusBar()->sizeHint().height()};
}

int WindowLayout::expectedWidth(QDockWidget& dock) const {
  const auto wish = widths_.constFind(&dock);
  return std::max(dock.minimumSizeHint().width(), wish == widths_.constEnd() ? 0 : widthOf(wish.value()));
}

int WindowLayout::expectedHeight(QDockWidget& dock) const {
  return &dock == timeline_ ? timeline_->sizeHint().height()
                            : std::max(dock.minimumSizeHint().height(), heights_.value(&dock, 0));
}

/// Once Qt has laid the panels out.
void WindowLayout::fitSoon() {
  if (!std::exchange(fitting_, true))
    QTimer::singleShot(0, this, &WindowLayout::fitPanels);
}

/// Qt squeezes all panels in a small window and leaves them so in a larger one. Nothing of that is learned as
/// a wish.
void WindowLayout::fitPanels() {
  fitting_ = false;
  giveCorners();
  if (bare_ || mode_.empty())
    return;
  if (QSet<QDockWidget*> folded = withoutRoom(); folded != folded_) {
    folded_ = std::move(folded);
    showPanels();
  }
  giveWidths();
  keepHeights();
  QTimer::singleShot(0, this, &WindowLayout::giveWidths); // Those that were shown just now have their place.
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

/// The lines between panels are the window's: what changes while the mouse is pressed there is the user's
/// wish.
void WindowLayout::watchWindow(const QEvent& event) {
  if (event.type() == QEvent::Resize || event.type() == QEvent::Show) {
    fitSoon();
  } else if (event.type() == QEvent::MouseButtonPress) {
    for (auto known = widths_.constBegin(); known != widths_.constEnd(); ++known)
      pressed_[known.key()] = known.key()->width();
  } else if (event.type() == QEvent::MouseButtonRelease) {
    for (auto known = widths_.begin(); known != widths_.end(); ++known)
      if (known.key()->width() != pressed_.value(known.key(), known.key()->width()))
        known.value() = {known.key()->width(), window_.width()};
    pressed_.clear();
    learnHeights();
  } else if (event.type() == QEvent::WindowStateChange) {
    fullScreen_->setChecked(window_.isFullScreen()); // Also as the settings or a lecture have it.
  }
}

/// A panel gets its part of a window that is narrower than the one of the wish.
int WindowLayout::widthOf(const Width& wish) const {
  return std::min(wish.panel, wish.panel * window_.width() / wish.window);
}

void WindowLayout::giveWidths() {
  QList<QDockWidget*> docks;
  QList<int> widths;
  for (auto known = widths_.constBegin(); known != widths_.constEnd(); ++known) {
    const int width = widthOf(known.value());
    if (known.key()->isVisible() && !known.key()->isFloating() && known.key()->width() != width) {
      docks.push_back(known.key());
      widths.push_back(width);
    }
  }
  if (!docks.isEmpty() && !importing_) // Its panel has the place of one of them.
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
  applyPanelHeights();
  // Qt shares the room anew once more when it lays the panels out.
  if (!std::exchange(resizing_, true))
    QTimer::singleShot(0, this, [this] {
      applyPanelHeights();
      resizing_ = false;
      QTimer::singleShot(0, this, [this] {
        for (auto known = heights_.constBegin(); known != heights_.constEnd(); ++known)
          settled_[known.key()] = heightOf(*known.key());
      });
    });
}

/// The height without what a table beside the charts has taken for itself.
int WindowLayout::heightOf(const QDockWidget& dock) const {
  return &dock == charts_ ? chartsBefore_.value_or(charts_->height()) : dock.height();
}

/// Panels are as high as they were, also those that stay while others come and go.
void WindowLayout::applyPanelHeights() {
  QList<QDockWidget*> docks;
  QList<int> heights;
  const auto give = [&](QDockWidget* dock, int height) {
    docks.push_back(dock);
    heights.push_back(height);
  };
  if (timeline_->isVisible()) // Else the chart pays for its height.
    give(timeline_, timeline_->sizeHint().height());
  if (charts_->isVisible() && !chartsBefore_)
    give(charts_, heights_.value(charts_));
  if (handles_->isVisible()) {
    int height = heights_.value(handles_);
    const bool below = organs_->isVisible() && organs_->x() == handles_->x();
    const int both = organs_->height() + handles_->height();
    if (below && height == kHandlesHeight) // Unless the user has set a height, the organs have more.
      height = std::min(height, static_cast<int>(kHandlesPart * both));
    give(handles_, height);
    if (below && both > height) // Else Qt would take half of what they are too high from each.
      give(organs_, both - height);
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
  kept_.clear();
  for (auto known = widths_.begin(); known != widths_.end(); ++known)
    known.value() =
        known.key() == properties_ ? Width{kRightWidth, kWidthForRight} : Width{kLeftWidth, kWidthForLeft};
  window_.restoreState(standard_);
  giveCorners();
  arrange();
  if (importing_)
    showImports();
}

void WindowLayout::restore(const Settings& settings) {
  const QSize room = window_.screen()->availableSize() - kWindowFrame;
  window_.resize(firstWindowSize(window_.screen()->availableSize()));
  standard_ = window_.saveState();
  window_.restoreGeometry(settings.value("window/geometry").toByteArray());
  window_.restoreState(settings.value("window/layout").toByteArray());
  giveCorners();
  if (!window_.isMaximized() && !window_.isFullScreen())
    window_.resize(window_.size().boundedTo(room));
  chosen_ = settings.value("window/panels").toMap();
  const QVariantMap widths = settings.value("window/panelWidths").toMap();
  for (auto known = widths_.begin(); known != widths_.end(); ++known)
    if (const QSize wish = widths.value(known.key()->objectName()).toSize(); !wish.isEmpty())
      known.value() = {wish.width(), wish.height()};
  restored_ = true;
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
