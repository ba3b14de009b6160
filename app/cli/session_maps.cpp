#include "cli/session_maps.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "stress_json.h"
#include "viscera/deformation/witness_interpolation.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/stress/value_steps.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;
using State = live::StressStatus::State;

constexpr double kPercent = 100;
/// Magenta: in none of the colour maps.
constexpr std::array<std::uint8_t, 3> kFoldedColor = {232, 40, 200};
/// Handles this little on the side that is cut away stay, of the organ's radius; as in the window.
constexpr double kHandleSlack = 0.08;

live::LiveStress::Options atOnce(Threads threads) {
  live::LiveStress::Options options;
  options.frameSeconds = std::numeric_limits<double>::infinity();
  options.threads = options.witnesses.threads = threads;
  return options;
}

/// The organ that was selected, else the first that is no part of another.
document::OrganId chosenOrgan(const document::Document& document, const ordered_json& view) {
  if (view.contains("selection")) {
    const document::OrganId chosen{view.at("selection").at("organ").get<std::int64_t>()};
    if (document.organ(chosen))
      return chosen;
  }
  for (const auto& organ : document.organs())
    if (!organ->parent)
      return organ->id;
  return {};
}

} // namespace

bool switchedOn(const ordered_json& view, const char* name, bool standard) {
  const ordered_json switches = view.value("switches", ordered_json::object());
  return switches.is_object() ? switches.value(name, standard) : standard;
}

bool showsStress(const ordered_json& view) {
  return view.value("mode", std::string()) == "stress";
}

bool showsInfluence(const ordered_json& view) {
  return !showsStress(view) && switchedOn(view, "handles.influence", false);
}

void drawInfluence(const StagedSession& staged, const ordered_json& view) {
  const ordered_json chosen = view.value("selection", ordered_json::object());
  const ordered_json handles = chosen.value("handles", ordered_json::array());
  const document::HandleId handle{handles.empty() ? 0 : handles.back().get<std::int64_t>()};
  const int row = staged.document.rig().indexOf(handle);
  if (row < 0)
    return;
  std::map<document::OrganId, std::shared_ptr<const Values>> influences;
  scene::ValueRange range{0, 0};
  for (const auto& [id, actor] : staged.actors) {
    Values influence = staged.live.influence(id, handle);
    if (influence.size() == 0)
      continue;
    influence *= kPercent;
    if (actor->visible())
      range.high = std::max(range.high, influence.maxCoeff());
    influences[id] = std::make_shared<const Values>(std::move(influence));
  }
  if (influences.empty())
    return;
  if (range.high <= 0)
    range.high = kPercent;
  const scene::ColorMap map = scene::viridis();
  for (const auto& [id, values] : influences)
    staged.actors.at(id)->showScalars(values, map, range);
  const std::string& label = staged.document.rig().handles[static_cast<std::size_t>(row)].label;
  staged.stage.view().legend().show("Influence of " + label, "%", map, range);
}

SessionStress::SessionStress(const StagedSession& staged, const ordered_json& view,
                             const plugin::Registry& systems, Threads threads)
    : staged_(staged), look_(view.contains("stress") ? stressLookOf(view.at("stress")) : StressLook()),
      live_(staged.document, systems, staged.live, staged.jobs, atOnce(threads)) {
  live_.setWanted(look_.witnesses);
  live_.follow(chosenOrgan(staged.document, view));
  const auto busy = [this] {
    const State state = live_.status().state;
    return state == State::sampling || state == State::binding;
  };
  staged.box.runUntil([&busy] { return !busy(); });
  if (live_.status().state == State::ready)
    draw();
  else
    leftOut_.push_back("the stress map (" +
                       (live_.status().message.empty() ? "there is no organ" : live_.status().message) + ")");
}

SessionStress::~SessionStress() {
  if (tissue_)
    for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
      staged_.stage.view().handles()->RemoveOccluder(actor);
}

/// Whether the organ's own surface carries the map; else the tetrahedra do.
bool SessionStress::onSurface() const {
  return look_.onSurface && !(look_.cut && look_.style == scene::CutStyle::crinkle);
}

void SessionStress::draw() {
  if (look_.glyphs != GlyphChoice::none)
    leftOut_.emplace_back("the glyphs of the stretches");
  const live::StressQuantityDescription& quantity = live::describe(look_.quantity);
  live::quantityOf(live_.map(), look_.quantity, *values_);
  const auto summary = live::summaryOf(*values_, live_.mesh()->witnesses);
  const auto range = steppedRange(look_.quantity, {summary.percentile5, summary.percentile95}, {0, 0});
  scene::ColorMap colors = scene::colorMapByName(quantity.ratio ? "diverging" : "viridis");
  colors.missing = kFoldedColor;
  const Bounds box = boundsOf(live_.mesh()->points);
  radius_ = 0.5 * (box.high - box.low).maxCoeff();
  plane_ = {box.center() + look_.offset * radius_ * look_.normal, look_.normal};
  drawTissue(colors, range);
  drawOrgans(colors, range);
  hideHandles();
  scene::Legend& legend = staged_.stage.view().legend();
  legend.show(quantity.name, quantity.unit, colors, range);
  if ((live_.map().volumeRatio.head(live_.mesh()->witnesses).array() <= 0).any())
    legend.setMark("folded", Vec3(kFoldedColor[0], kFoldedColor[1], kFoldedColor[2]) / 255);
}

void SessionStress::drawTissue(const scene::ColorMap& colors, scene::ValueRange range) {
  const auto mesh = live_.mesh();
  tissue_ =
      std::make_unique<scene::TissueActor>(std::shared_ptr<const scene::Tetrahedra>(mesh, &mesh->tetrahedra),
                                           std::make_shared<const Points>(live_.points()));
  scene::OrganView& view = staged_.stage.view();
  tissue_->setRenderer(view.renderer());
  for (vtkActor* actor : {tissue_->faces(), tissue_->cut()})
    view.handles()->AddOccluder(actor);
  tissue_->setValues(values_);
  tissue_->setColors(colors, range);
  tissue_->setOutsideShown(!onSurface());
  tissue_->setVisible(!onSurface() || look_.cut);
  if (look_.cut)
    tissue_->setCut(plane_, look_.style);
}

void SessionStress::drawOrgans(const scene::ColorMap& colors, scene::ValueRange range) {
  for (const auto& [id, actor] : staged_.actors) {
    const auto organ = staged_.document.organ(id);
    if (id == live_.organ()) {
      auto onVertices = std::make_shared<Values>();
      deformation::WitnessInterpolation(*live_.mesh(), organ->mesh->points)(*values_, *onVertices);
      actor->setVisible(onSurface());
      actor->setOpacity(1);
      actor->showScalars(onVertices, colors, range);
      if (look_.cut)
        actor->setClipPlane(plane_.origin, plane_.normal);
      continue;
    }
    // Cavities are left out of the tissue: what is seen there are their walls, cut likewise.
    const bool cavity = organ->parent == live_.organ();
    actor->setVisible(organ->look.visible && (cavity ? look_.cut : look_.others));
    if (cavity && look_.cut)
      actor->setClipPlane(plane_.origin, plane_.normal);
  }
}

/// On the side that is cut away they would hide the cut.
void SessionStress::hideHandles() {
  vtkVisceraHandleSetRepresentation* handles = staged_.stage.view().handles();
  const Points& places = handles->GetPositions();
  for (Eigen::Index row = 0; row < places.rows(); ++row) {
    const double beyond = (places.row(row).transpose() - plane_.origin).dot(plane_.normal);
    handles->SetHandleShown(static_cast<int>(row),
                            look_.handles && (!look_.cut || beyond >= -kHandleSlack * radius_));
  }
}

} // namespace viscera::app::cli
