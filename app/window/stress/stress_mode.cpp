#include "window/stress/stress_mode.h"

#include <QAction>

#include "window/stress/probe_card.h"
#include "window/stress/stress_chart.h"
#include "window/stress/stress_export.h"
#include "window/stress/stress_page.h"
#include "window/view/view_area.h"

namespace viscera::app {
namespace {
constexpr const char* kActionIds[] = {
    "stress.next",      "stress.maximum", "stress.pinProbe",    "stress.peak",      "stress.peakTime",
    "stress.surface",   "stress.pin",     "stress.logarithmic", "stress.sameRange", "stress.cut",
    "stress.threshold", "stress.glyphs",  "stress.handles",     "stress.others"};
} // namespace

StressMode::StressMode(const ModeParts& parts, Actions& actions)
    : Mode(parts, {"stress", "stress", 4, tr("Stress"),
                   tr("How much the pose distorts the tissue (rotational stress): click the organ to read "
                      "the values of a point; C cuts it open; the map follows while you drag a handle")}),
      actions_(actions), model_(parts.workspace, parts.playback, parts.settings, parts.view, parts.picture),
      cut_(parts.workspace, model_, *parts.area.view(), parts.picture, parts.handles),
      exports_(new StressExport(workspace_, parts.playback, model_, parts.settings, &parts.area)) {
  Playback& playback = parts.playback;
  makeActions();
  card_ = new ProbeCard(model_, actions_["stress.pinProbe"], &parts.area);
  parts_.area.addCard(card_, Qt::AlignVCenter | Qt::AlignLeft);
  exports_->addTo(actions_);
  connect(&model_, &StressModel::lookChanged, this, &StressMode::syncActions);
  connect(&model_, &StressModel::statusChanged, this, &StressMode::syncActions);
  connect(&model_, &StressModel::activeChanged, this, &StressMode::syncActions);
  connect(&model_, &StressModel::probeChanged, this, &StressMode::syncActions);
  connect(&model_, &StressModel::updated, this, [this] { // A map may come with a pose alone.
    if (actions_["stress.maximum"]->isEnabled() != model_.hasMap())
      syncActions();
  });
  connect(&playback, &Playback::stateChanged, this, &StressMode::syncActions);
  connect(&playback, &Playback::stateChanged, this, &Mode::shownChanged);
  connect(&playback, &Playback::advanced, this, [this] {
    if (!model_.active()) // Another mode shows the sequence again.
      posed_ = false;
    Q_EMIT shownChanged(); // Dragging the timeline shows it too.
  });
  subscription_ = workspace_.onChange([this, &playback](const document::Change& change) {
    if (change.pose() && playback.wantedPose() == live::WantedPose::document)
      posed_ = !document::atRest(change.after);
  });
  syncActions();
}

void StressMode::makeActions() {
  actions_.add("stress.next", {tr("&Next map"), "stress", {Qt::Key_M}, tr("The next stress map")}, [this] {
    model_.change([](StressLook& look) {
      const auto& all = live::stressQuantities();
      do // Past those that lack their material.
        look.quantity = all[(static_cast<std::size_t>(look.quantity) + 1) % all.size()].quantity;
      while (!look.measure().known());
    });
  });
  actions_.add("stress.maximum",
               {tr("&Go to the maximum"),
                "focus",
                {tr("Shift+X")},
                tr("Show the values where the map is largest, and cut the organ open there")},
               [this] { model_.goToMaximum(); });
  actions_.add("stress.pinProbe",
               {tr("P&in the probe"),
                "place",
                {tr("Shift+P")},
                tr("Keep the point that was clicked: its place and value follow the pose in the table")},
               [this] { model_.pinProbe(); });
  actions_.add("stress.peakTime",
               {tr("Go to the &time of the maximum"),
                "chart",
                {},
                tr("Show the sequence at the instant at which the rotational stress is largest")},
               [this] { model_.goToPeak(); });
  actions_.addToggle("stress.peak",
                     {tr("&Maximum over the sequence"),
                      "chart",
                      {tr("Shift+M")},
                      tr("The most extreme value that each point reaches in one cycle of the sequence")},
                     false, [this](bool on) {
                       model_.setPeakShown(on);
                       syncActions();
                     });
  addSwitches();
}

void StressMode::addSwitches() {
  const auto toggle = [this](const char* id, const Actions::Description& description,
                             bool StressLook::*member) {
    actions_.addToggle(id, description, model_.look().*member, [this, member](bool on) {
      model_.change([&](StressLook& look) { look.*member = on; });
    });
  };
  toggle("stress.surface",
         {tr("Map on the organ's &surface"),
          nullptr,
          {},
          tr("Draw the map on the organ's surface instead of the outer tetrahedra")},
         &StressLook::onSurface);
  toggle("stress.pin",
         {tr("&Keep the legend's range"),
          nullptr,
          {},
          tr("Keep the range of colours, so that poses can be compared")},
         &StressLook::pinned);
  toggle("stress.logarithmic",
         {tr("&Logarithmic range"),
          nullptr,
          {},
          tr("Use a logarithmic colour scale, which separates small values")},
         &StressLook::logarithmic);
  toggle("stress.sameRange",
         {tr("Same range in both &views"),
          nullptr,
          {},
          tr("Beside another view: one range of colours for both stress maps, so that they can be compared")},
         &StressLook::sameRange);
  toggle("stress.cut", {tr("&Cut open"), nullptr, {Qt::Key_C}, tr("Cut the organ open by a plane")},
         &StressLook::cut);
  actions_.addToggle(
      "stress.threshold",
      {tr("&Only beyond a limit"), nullptr, {Qt::Key_T}, tr("Show only tissue above or below a limit")},
      model_.look().threshold, [this](bool on) {
        if (model_.look().threshold == on) // The mark follows the look: of a session, say.
          return;
        model_.change([&](StressLook& look) {
          look.threshold = on;
          const bool smallest = look.quantity == live::StressQuantity::stretchMin;
          look.below = smallest;
          look.limit = model_.shown().ready() ? model_.shown().summary().mean : 0;
        });
      });
  actions_.add(
      "stress.glyphs",
      {tr("&Glyphs of the stretch"), nullptr, {tr("Shift+G")}, tr("No glyphs, ellipsoids or crosses")},
      [this] {
        model_.change([](StressLook& look) {
          look.glyphs = static_cast<GlyphChoice>((static_cast<int>(look.glyphs) + 1) % 3);
        });
      });
  toggle("stress.handles", {tr("&Handles"), nullptr, {}, tr("Show the handles, so that they can be dragged")},
         &StressLook::handles);
  toggle("stress.others", {tr("O&ther organs"), nullptr, {}, tr("Show the other organs as well")},
         &StressLook::others);
}

/// Actions do something only in the mode; the window's other modes may give their keys another meaning.
void StressMode::syncActions() {
  const StressLook& look = model_.look();
  const auto check = [this](const char* id, bool on) {
    if (actions_[id]->isChecked() != on)
      actions_[id]->setChecked(on);
  };
  check("stress.surface", look.onSurface);
  check("stress.pin", look.pinned);
  check("stress.logarithmic", look.logarithmic);
  check("stress.sameRange", look.sameRange);
  check("stress.cut", look.cut);
  check("stress.threshold", look.threshold);
  check("stress.handles", look.handles);
  check("stress.others", look.others);
  check("stress.peak", look.peak);
  for (const char* id : kActionIds)
    actions_[id]->setEnabled(model_.active());
  actions_["stress.maximum"]->setEnabled(model_.hasMap());
  actions_["stress.peakTime"]->setEnabled(model_.active() && model_.peakInstant() &&
                                          parts_.playback.sequence());
  actions_["stress.pinProbe"]->setEnabled(model_.active() && model_.probe() >= 0);
  actions_["stress.peak"]->setEnabled(model_.active() && model_.shown().ready() &&
                                      parts_.playback.sequence());
}

std::vector<const char*> StressMode::actions() const {
  return {std::begin(kActionIds), std::end(kActionIds)};
}

void StressMode::enter() {
  if (posed_ && parts_.playback.showing())
    parts_.playback.stop();
}

QWidget* StressMode::makePage(const Actions& actions) {
  page_ = new StressPage(workspace_, parts_.playback, model_, cut_, actions);
  return page_;
}

QWidget* StressMode::makeChart() {
  chart_ = new StressChart(model_);
  return chart_;
}

presentation::Shown StressMode::shown() const {
  const bool movable = !parts_.playback.showing();
  return {.handles = movable, .movable = movable, .stress = true};
}

void StressMode::setTheme(const Theme& theme) {
  if (chart_)
    chart_->setTheme(theme);
  if (page_)
    page_->setTheme(theme);
}

bool StressMode::escape() {
  if (cut_.planeWidget()->IsDragging()) {
    cut_.planeWidget()->CancelDrag();
    return true;
  }
  if (!model_.active() || model_.probe() < 0)
    return false;
  model_.setProbe(-1);
  return true;
}

} // namespace viscera::app
