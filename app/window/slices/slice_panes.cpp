#include "window/slices/slice_panes.h"

#include <QMenu>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/document/scan_item.h"
#include "viscera/medical_io/slice_frame.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/style/language.h"
#include "window/view/picture.h"

namespace viscera::app {
namespace {

using presentation::ScanLook;
using presentation::ViewState;

/// Logical pixels of a drag that move the level by its width, or double the width.
constexpr double kWindowReach = 300;
constexpr double kLeastWidth = 1;
constexpr double kGripReach = 9; ///< Logical pixels.
constexpr double kLeastZoom = 0.1, kMostZoom = 100;

} // namespace

SlicePanes::SlicePanes(Workspace& workspace, ViewModel& model, Picture& picture, ViewArea& area, QMenu& menu,
                       QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model), picture_(picture), area_(area),
      presenter_({}, translated), cine_(workspace, model) {
  presenter_.setDecimalMark(decimalMark());
  for (int i = 0; i < 3; ++i) {
    auto* widget = new SliceWidget;
    widget->setObjectName(
        QStringLiteral("slice.%1")
            .arg(QLatin1String(medical_io::sliceDirections()[static_cast<std::size_t>(i)].id)));
    widgets_[static_cast<std::size_t>(i)] = widget;
    connectWidget(i);
    connectGrips(i);
    connect(widget, &SliceWidget::menuWanted, &menu, [&menu](const QPoint& place) { menu.popup(place); });
  }
  area.addSlices({widgets_[0], widgets_[1], widgets_[2]});
  subscriptions_.push_back(workspace.onChange([this](const document::Change&) {
    arrange();
    markOutdated();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (!event.more)
      markOutdated();
  }));
  subscriptions_.push_back(workspace.warp().onChange([this] { followWarp(); }));
  subscriptions_.push_back(workspace.selection().onChange([this] { markOutdated(); }));
  connect(&model, &ViewModel::changed, this, [this] {
    workspace_.warp().setWanted(model_.state().scan.warped);
    arrange();
    markOutdated();
  });
  for (SliceWidget* widget : widgets_)
    widget->setContents([this] { bringUpToDate(); });
  arrange();
}

SlicePanes::~SlicePanes() {
  for (SliceWidget* widget : widgets_)
    widget->setContents(nullptr);
}

void SlicePanes::connectWidget(int direction) {
  SliceWidget* widget = widgets_[static_cast<std::size_t>(direction)];
  connect(widget, &SliceWidget::resized, this, &SlicePanes::markOutdated);
  connect(widget, &SliceWidget::crossWanted, this,
          [this, direction](const Eigen::Vector2d& pixel) { moveCross(direction, pixel); });
  connect(widget, &SliceWidget::windowDragged, this, &SlicePanes::dragWindow);
  connect(widget, &SliceWidget::panDragged, this,
          [this, direction](const QPointF& by) { pan(direction, by); });
  connect(
      widget, &SliceWidget::zoomWanted, this,
      [this, direction](double factor, const Eigen::Vector2d& around) { zoom(direction, factor, around); });
  connect(widget, &SliceWidget::scrolled, this,
          [this, direction](double steps) { scroll(direction, steps); });
  connect(widget, &SliceWidget::doubleClicked, this, [this, direction] { isolate(direction); });
  connect(widget, &SliceWidget::hovered, this,
          [this, direction](const std::optional<Eigen::Vector2d>& pixel) { hover(direction, pixel); });
}

std::vector<SliceGrip*> SlicePanes::gripsNow() const {
  std::vector<SliceGrip*> grips = cine_.shown() ? cineGrips_ : std::vector<SliceGrip*>();
  grips.insert(grips.end(), grips_.begin(), grips_.end());
  return grips;
}

void SlicePanes::connectGrips(int direction) {
  SliceWidget* widget = widgets_[static_cast<std::size_t>(direction)];
  widget->setGripper([this, direction](const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers) {
    const std::vector<SliceGrip*> grips = gripsNow();
    const auto taking = std::find_if(grips.begin(), grips.end(), [&](SliceGrip* grip) {
      return grip->press(direction, pixel, modifiers);
    });
    holding_ = taking == grips.end() ? nullptr : *taking;
    return holding_ != nullptr;
  });
  connect(widget, &SliceWidget::gripDragged, this, [this, direction](const Eigen::Vector2d& pixel) {
    holding_->drag(direction, pixel);
    read(direction, pixel);
  });
  connect(widget, &SliceWidget::gripReleased, this,
          [this, direction](const Eigen::Vector2d& pixel, bool moved) {
            std::exchange(holding_, nullptr)->release(direction, pixel, moved);
            hover(direction, pixel);
          });
}

/// The first tool that would grab something there determines the cursor.
void SlicePanes::hover(int direction, const std::optional<Eigen::Vector2d>& pixel) {
  std::optional<Qt::CursorShape> shape;
  for (SliceGrip* grip : gripsNow()) {
    const auto its = grip->hover(direction, shape ? std::nullopt : pixel);
    shape = shape ? shape : its;
  }
  if (shape)
    widget(direction).setCursor(*shape);
  else
    widget(direction).unsetCursor();
  read(direction, pixel);
}

const medical_io::SliceFrame& SlicePanes::frameNow(int direction) {
  bringUpToDate();
  return frame(direction);
}

Vec3 SlicePanes::normalOf(int direction) {
  if (cine_.shown())
    return frameNow(direction).plane().normal;
  return Vec3::Unit(medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis);
}

int SlicePanes::handleAt(int direction, const Eigen::Vector2d& pixel) {
  bringUpToDate();
  return cine_.shown() ? cine_.presenter().handleAt(direction, pixel, reach(direction))
                       : presenter_.handleAt(direction, pixel, reach(direction));
}

std::optional<scene::MeasurementGlyphs::Mark> SlicePanes::measuredAt(int direction,
                                                                     const Eigen::Vector2d& pixel) {
  bringUpToDate();
  return cine_.shown() ? cine_.presenter().measuredAt(direction, pixel, reach(direction))
                       : presenter_.measuredAt(direction, pixel, reach(direction));
}

double SlicePanes::reach(int direction) const {
  return kGripReach * widgets_[static_cast<std::size_t>(direction)]->devicePixelRatioF();
}

Vec3 SlicePanes::restOf(const Vec3& place) const {
  return workspace_.warp().warpsScan() ? workspace_.warp().restOf(place) : place;
}

Vec3 SlicePanes::drawnAt(const Vec3& rest) const {
  return workspace_.warp().warpsScan() ? workspace_.warp().posedOf(rest) : rest;
}

void SlicePanes::setMeasuring(presentation::PendingMeasurement measuring) {
  measuring_ = std::move(measuring);
  markOutdated();
}

void SlicePanes::setBent(std::optional<presentation::BentContour> bent) {
  cine_.setBent(std::move(bent));
  markOutdated();
}

void SlicePanes::setTheme(const Theme& theme) {
  for (SliceWidget* widget : widgets_)
    widget->setTheme(theme);
  markOutdated(); // Texts are placed by their size.
}

/// The 3D view is alone where nothing can be sliced; the chosen layout returns with the next organ or scan.
void SlicePanes::arrange() {
  const document::DocumentState& document = workspace_.state();
  if (!document.scan && !document.study && document.organs->empty())
    return area_.arrange(true, {});
  const std::string& layout = model_.state().scan.layout;
  const auto directions = medical_io::sliceDirections();
  std::array<bool, 3> shown{};
  for (std::size_t i = 0; i < 3; ++i)
    shown[i] = layout == "four" || layout == directions[i].id;
  const bool any = shown[0] || shown[1] || shown[2];
  area_.arrange(!any || layout == "four", shown);
}

std::vector<presentation::SlicePane> SlicePanes::panes() const {
  std::vector<presentation::SlicePane> panes;
  for (int i = 0; i < 3; ++i) {
    const SliceWidget& widget = *widgets_[static_cast<std::size_t>(i)];
    if (widget.isVisible())
      panes.push_back({i, widget.pixelWidth(), widget.pixelHeight()});
  }
  return panes;
}

void SlicePanes::markOutdated() {
  outdated_ = true;
  for (SliceWidget* widget : widgets_)
    if (widget->isVisible())
      widget->scheduleRender();
}

void SlicePanes::bringUpToDate() {
  const auto shown = panes();
  if (!outdated_ || shown.empty())
    return;
  outdated_ = false;
  workspace_.guarded([&] {
    std::optional<presentation::Warping> warping;
    if (model_.state().scan.warped)
      warping = presentation::warpingOf(workspace_.warp());
    const ViewState view = picture_.state(); // With what is selected.
    presentation::SliceScene scene{workspace_.state(), workspace_.live(), view};
    scene.measuring = &measuring_;
    scene.activeHandle = picture_.view().handles()->GetActiveHandle();
    if (cine_.shown())
      cine_.update(scene, shown);
    else
      updateScan(scene, shown, warping ? &*warping : nullptr);
    for (const presentation::SlicePane& pane : shown) {
      widget(pane.direction)
          .setPicture(cine_.shown() ? cine_.picture(pane.direction) : presenter_.picture(pane.direction));
      widget(pane.direction)
          .setVerdict(cine_.shown() && verdicts_ ? verdicts_(cine_.presenter().slice(pane.direction))
                                                 : SliceVerdict());
      read(pane.direction, cursor_[static_cast<std::size_t>(pane.direction)]);
    }
  });
  Q_EMIT changed();
}

void SlicePanes::updateScan(presentation::SliceScene scene, const std::vector<presentation::SlicePane>& shown,
                            const presentation::Warping* warping) {
  scene.warping = warping;
  presenter_.update(scene, shown);
}

/// The frame of what a pane shows now.
const medical_io::SliceFrame& SlicePanes::frame(int direction) const {
  return cine_.shown() ? cine_.frame(direction) : presenter_.frame(direction);
}

void SlicePanes::followWarp() {
  if (const Text& problem = workspace_.warp().problem(); !problem.empty())
    workspace_.note(tr("The scan cannot be warped: %1").arg(inWords(problem)));
  markOutdated();
}

void SlicePanes::moveCross(int direction, const Eigen::Vector2d& pixel) {
  if (cine_.shown())
    return;
  const int axis = medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
  Vec3 place = presenter_.frame(direction).at(pixel.x(), pixel.y());
  place[axis] = presentation::focusOf(workspace_.state(), model_.state().scan)[axis];
  model_.change([&place](ViewState& view) { view.scan.focus = place; });
}

void SlicePanes::scroll(int direction, double steps) {
  if (cine_.shown())
    return cine_.scroll(direction, steps);
  const int axis = medical_io::sliceDirections()[static_cast<std::size_t>(direction)].axis;
  const double towards = axis == 2 ? 1 : -1; // LPS: z grows to the head; front and right are negative.
  Vec3 place = presentation::focusOf(workspace_.state(), model_.state().scan);
  const Bounds box = presentation::boxOfSlices(workspace_.state());
  place[axis] = std::clamp(place[axis] + towards * steps * presentation::stepAlong(workspace_.state(), axis),
                           box.low[axis], box.high[axis]);
  model_.change([&place](ViewState& view) { view.scan.focus = place; });
}

void SlicePanes::dragWindow(const QPointF& by) {
  if (!workspace_.state().scan && !cine_.shown())
    return;
  const medical_io::ValueWindow now =
      cine_.shown() ? cine_.window()
                    : presentation::windowOf(*workspace_.state().scan->scan, model_.state().scan);
  model_.change([&](ViewState& view) {
    view.scan.level = now.level + now.width * by.y() / kWindowReach;
    view.scan.width = std::max(kLeastWidth, now.width * std::exp2(by.x() / kWindowReach));
  });
}

void SlicePanes::pan(int direction, const QPointF& by) {
  const medical_io::SliceFrame& now = frame(direction);
  const double mm = now.right.norm() * widget(direction).devicePixelRatioF();
  model_.change([&](ViewState& view) {
    presentation::SliceFraming& framing = view.scan.framings[static_cast<std::size_t>(direction)];
    framing.rightMm -= mm * by.x();
    framing.upMm -= mm * by.y();
  });
}

/// The place at `around` stays there.
void SlicePanes::zoom(int direction, double factor, const Eigen::Vector2d& around) {
  const medical_io::SliceFrame& now = frame(direction);
  const double mm = now.right.norm();
  const Eigen::Vector2d middle(0.5 * (now.width - 1), 0.5 * (now.height - 1));
  model_.change([&](ViewState& view) {
    presentation::SliceFraming& framing = view.scan.framings[static_cast<std::size_t>(direction)];
    const double zoom = std::clamp(framing.zoom * factor, kLeastZoom, kMostZoom);
    const Eigen::Vector2d kept = mm * (1 - framing.zoom / zoom) * (around - middle);
    framing.rightMm += kept.x();
    framing.upMm += kept.y();
    framing.zoom = zoom;
  });
}

/// A double click shows one slice alone, and another one all four again.
void SlicePanes::isolate(int direction) {
  const char* id = medical_io::sliceDirections()[static_cast<std::size_t>(direction)].id;
  model_.change([id](ViewState& view) { view.scan.layout = view.scan.layout == id ? "four" : id; });
}

void SlicePanes::read(int direction, const std::optional<Eigen::Vector2d>& pixel) {
  cursor_[static_cast<std::size_t>(direction)] = pixel;
  if (outdated_)
    return; // It is read again with the slices.
  SliceWidget& shown = widget(direction);
  if (!pixel)
    return shown.setReading({});
  const presentation::SliceReading reading =
      cine_.shown() ? cine_.read(direction, *pixel) : presenter_.read(direction, *pixel);
  QStringList parts;
  if (reading.value) {
    const std::string unit = cine_.shown() ? std::string() : workspace_.state().scan->scan->unit;
    parts << (formatNumber(*reading.value, 0) + QLatin1Char(' ') + text(unit)).trimmed();
    if (reading.folded)
      parts << tr("folded by the pose: estimated");
  }
  QStringList place;
  for (int axis = 0; axis < 3; ++axis)
    place << text(presentation::formatSlicePosition(axis, reading.position[axis], decimalMark()))
                 .remove(QStringLiteral(" mm"));
  parts << place.join(listSeparator()) + QStringLiteral(" mm");
  if (const auto organ = workspace_.document().organ(reading.organ))
    parts << inWords(presentation::labelOf(*organ));
  shown.setReading(parts.join(QStringLiteral("   ")));
}

} // namespace viscera::app
