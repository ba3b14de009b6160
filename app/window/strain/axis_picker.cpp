#include "window/strain/axis_picker.h"

#include <QCoreApplication>
#include <QMenu>

#include <algorithm>
#include <utility>

#include "viscera/document/measured_values.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/view/view_model.h"

namespace viscera::app {

AxisPicker::AxisPicker(StrainModel& model, ViewModel& view, const Picture& picture, ViewWidget& widget,
                       QWidget* parent)
    : QToolButton(parent), model_(model), viewModel_(view), picture_(picture), widget_(widget),
      byShape_(nullptr), glyphs_(widget.view()) {
  setObjectName(QStringLiteral("strainAxes"));
  setToolTip(tr("Axes of the heart, from which segments count: set by clicks"));
  setAccessibleName(toolTip());
  setIcon(app::icon("place"));
  setPopupMode(QToolButton::InstantPopup);
  setMenu(new QMenu(this));
  points_.reserve(3); // `picking_` points into it.
  addPoint(inWords(std::string("Base")), "strainBase", &Look::base);
  addPoint(inWords(std::string("Apex")), "strainApex", &Look::apex);
  addPoint(tr("Anterior insertion of the right ventricle"), "strainInsertion", &Look::insertion);
  menu()->addSeparator();
  byShape_ = menu()->addAction(QCoreApplication::translate("viscera::app::FitBox", "by the shape"));
  byShape_->setObjectName(QStringLiteral("strainByShape"));
  connect(byShape_, &QAction::triggered, this, &AxisPicker::forget);
  connect(&widget, &ViewWidget::clicked, this, &AxisPicker::onClick);
  connect(&view, &ViewModel::changed, this, &AxisPicker::sync);
  widget.addClickTaker([this] { return picking(); });
  Workspace& workspace = model.workspace();
  subscriptions_.push_back(workspace.onChange([this](const document::Change&) { syncGlyphs(); }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (!event.more)
      syncGlyphs();
  }));
  sync();
}

AxisPicker::~AxisPicker() = default;

void AxisPicker::addPoint(const QString& name, const char* objectName, std::optional<Vec3> Look::*place) {
  QAction* action = menu()->addAction(name);
  action->setObjectName(QLatin1String(objectName));
  action->setCheckable(true);
  points_.push_back({place, action});
  connect(action, &QAction::triggered, this,
          [this, point = &points_.back()] { pick(picking_ == point ? nullptr : point); });
}

void AxisPicker::pick(const Point* point) {
  picking_ = point;
  widget_.setCursor(point ? Qt::CrossCursor : Qt::ArrowCursor);
  sync();
  Q_EMIT pickingChanged();
}

void AxisPicker::showEvent(QShowEvent* event) {
  QToolButton::showEvent(event);
  syncGlyphs();
}

void AxisPicker::hideEvent(QHideEvent* event) {
  QToolButton::hideEvent(event);
  if (picking())
    pick(nullptr);
  setGlyphs({}); // Also when the window ends, and what is shown is gone.
}

/// The surface may be in motion: the point is where the clicked place is at rest.
void AxisPicker::onClick(const QPointF& place) {
  if (!picking())
    return;
  const auto hit = widget_.pickNear(place);
  const auto organ = hit ? model_.workspace().document().organ(picture_.organOf(hit->organ)) : nullptr;
  if (!organ)
    return;
  const Vec3 rest =
      document::surfacePoint(*organ, hit->triangle, Vec3(hit->weights[0], hit->weights[1], hit->weights[2]))
          .rest;
  const auto picked = std::exchange(picking_, nullptr)->place;
  viewModel_.change([&](presentation::ViewState& state) {
    Look& look = state.strain;
    if (look.axesOf != model_.leftVentricle())
      look.base = look.apex = look.insertion = std::nullopt; // They were places of another heart.
    look.axesOf = model_.leftVentricle();
    look.*picked = rest;
  });
  pick(nullptr);
}

void AxisPicker::forget() {
  viewModel_.change([](presentation::ViewState& state) {
    state.strain.base = state.strain.apex = state.strain.insertion = std::nullopt;
    state.strain.axesOf = {};
  });
  pick(nullptr);
}

void AxisPicker::sync() {
  const Look& look = viewModel_.state().strain;
  for (const Point& point : points_)
    point.action->setChecked(&point == picking_ || (look.*point.place).has_value());
  byShape_->setEnabled(look.base || look.apex || look.insertion);
  syncGlyphs();
}

/// A point inside the heart moves with the nearest place of the cavity's surface.
void AxisPicker::syncGlyphs() {
  const Look& look = viewModel_.state().strain;
  Workspace& workspace = model_.workspace();
  std::vector<scene::MeasurementGlyphs::Item> items;
  const auto left = isVisible() ? workspace.document().organ(look.axesOf) : nullptr;
  for (const Point& point : points_) {
    if (!left || !(look.*point.place))
      continue;
    const Vec3 rest = *(look.*point.place);
    const document::MeasuredPoint nearest = document::nearestPoint(*left, rest);
    const Vec3 now =
        document::placeNow(nearest, workspace.state(), [&workspace](document::OrganId id) -> const Points& {
          return workspace.live().points(id);
        });
    items.push_back({{rest + (now - nearest.rest)}, point.action->text().toStdString(), true});
  }
  setGlyphs(std::move(items));
}

void AxisPicker::setGlyphs(std::vector<scene::MeasurementGlyphs::Item> items) {
  if (items.empty() && glyphs_.items().empty())
    return;
  glyphs_.setTheme(widget_.view().theme());
  glyphs_.setItems(std::move(items));
  widget_.scheduleRender();
}

} // namespace viscera::app
