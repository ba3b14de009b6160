#include "cli/session_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <vtkImageData.h>

#include "cli/listing.h"
#include "cli/patient_info.h"
#include "viscera/core/error.h"
#include "viscera/document/axes_commands.h"
#include "viscera/document/measured_values.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/session_motion.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/space_parts.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

ordered_json organJson(const document::Organ& organ) {
  return {
      {"name", organ.name},
      {"vertices", organ.mesh->points.rows()},
      {"triangles", organ.mesh->triangles.rows()},
      {"closed", organ.closed()},
      {"volumeMl", organ.closed() ? ordered_json(organ.restVolumeMm3 / kMm3PerMl) : ordered_json(nullptr)},
      {"volumeLocked", organ.volumeLocked},
      {"visible", organ.look.visible}};
}

/// Each with its value at rest.
ordered_json measurementsJson(const document::DocumentState& state) {
  const auto atRest = [&](document::OrganId id) -> const Points& { return state.organ(id)->mesh->points; };
  ordered_json list = ordered_json::array();
  for (const document::Measurement& measurement : *state.measurements) {
    const double value = document::measure(measurement, state, atRest).rest;
    list.push_back({{"name", measurement.name},
                    {"kind", document::nameOf(measurement.kind)},
                    {"valueAtRest", std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr)},
                    {"unit", document::unitOf(measurement, state)}});
  }
  return list;
}

/// A view that cannot be read is as at first where a side is asked for.
presentation::ViewState viewOf(const document::OpenedSession& opened, bool fromSide) {
  try {
    return presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation);
  } catch (const DataError& error) {
    if (fromSide)
      return {};
    throw DataError(error.problem(), error.where(), "give --view for a picture from another side");
  }
}

/// Sets the valves and the clock of the sample heart at the instant that the view shows.
void setInstant(presentation::Scene& scene) {
  const presentation::ViewState& view = scene.view;
  if (!view.playing || !view.playing->shown)
    return;
  const auto chosen = static_cast<std::size_t>(view.playing->motion);
  if (view.playing->motion < 0 || chosen >= view.motions.size())
    return;
  Progress quiet;
  const live::MotionRecipe& recipe = view.motions[chosen].recipe;
  const double fraction = view.playing->fraction, rate = view.playing->ratePerMinute;
  scene.valves = live::heartValves(recipe, *scene.state.circulation, fraction, rate, quiet);
  if (view.conduction)
    scene.clock = live::heartClock(recipe, *scene.state.circulation, fraction, rate, quiet);
}

} // namespace

std::shared_ptr<const sequences::Sequence> sequenceOf(const document::DocumentState& state,
                                                      const presentation::ViewState& view,
                                                      CommandContext& context) {
  return live::makeSequence(state, presentation::motionOf(view), context.samples, context.progress,
                            context.threads);
}

std::unique_ptr<workbench::Workbench> benchFor(CommandContext& context) {
  return std::make_unique<workbench::Workbench>(
      workbench::Setup{context.systems, context.samples, context.threads}, &context.progress);
}

std::unique_ptr<workbench::Workbench> posedSession(const document::DocumentState& state,
                                                   const presentation::ViewState& view,
                                                   CommandContext& context) {
  auto bench = benchFor(context);
  document::SessionContents contents;
  contents.state = state;
  contents.view = live::viewOf(presentation::motionOf(view));
  bench->restore(std::move(contents));
  if (view.shown.rest)
    bench->showRest();
  else if (view.shownPose.rows() == state.pose->rows())
    bench->showPose(view.shownPose);
  return bench;
}

Text makeStress(workbench::Workbench& bench, const presentation::ViewState& view) {
  const auto organ = presentation::currentOrgan(bench.state(), view.selection.organ);
  Text missing = bench.tryStress(organ ? organ->id : document::OrganId(), view.stress.witnesses);
  if (missing.empty() && view.playing)
    bench.findStressCycle(live::CycleParts::curveAndPeak);
  return missing;
}

Outcome describeSession(const std::string& file, CommandContext& context) {
  const document::OpenedSession opened = document::readSession(file, context.samples, context.progress);
  const document::DocumentState& state = opened.contents.state;
  Listing listing;
  listing.add("kind", "session");
  ordered_json organs = ordered_json::array();
  auto organ = state.organs->begin();
  for (const document::SurfaceFinding& finding : opened.surfaces) {
    const bool there = finding.state != document::SurfaceFinding::State::missing;
    ordered_json item = there ? organJson(**organ++) : ordered_json{{"name", finding.organ}};
    item["surface"] = nameOf(finding.state);
    item["source"] = finding.source;
    listing.add("organ", finding.organ + ": " + nameOf(finding.state) +
                             (finding.source.empty() ? "" : ", " + finding.source));
    organs.push_back(std::move(item));
  }
  ordered_json groups = ordered_json::array();
  for (const document::Group& group : state.rig->groups)
    groups.push_back({{"name", group.name}, {"handles", group.handles.size()}});
  ordered_json parameters = ordered_json::object();
  for (const auto& [name, value] : state.system->parameters.all())
    parameters[name] = value;
  Outcome outcome;
  outcome.json = {{"kind", "session"},
                  {"file", file},
                  {"surfaces", opened.contents.embedSurfaces ? "embedded" : "linked"},
                  {"organs", std::move(organs)},
                  {"handles", state.rig->handles.size()},
                  {"groups", std::move(groups)},
                  {"cageTriangles", state.rig->cage.size()},
                  {"posed", !document::atRest(state)},
                  {"system", {{"id", state.system->id}, {"parameters", std::move(parameters)}}},
                  {"recordedKeys", state.keySequence->keys.size()},
                  {"measurements", measurementsJson(state)},
                  {"warnings", opened.warnings}};
  listing.add("handles", std::to_string(state.rig->handles.size()) +
                             (document::atRest(state) ? ", at rest" : ", posed"));
  for (const document::Group& group : state.rig->groups)
    listing.add("group", group.name + ": " + std::to_string(group.handles.size()));
  if (!state.rig->cage.empty())
    listing.add("cage", std::to_string(state.rig->cage.size()) + " triangles");
  listing.add("coordinates", state.system->id)
      .add("keyframes", std::to_string(state.keySequence->keys.size()));
  for (const ordered_json& item : outcome.json["measurements"]) {
    const ordered_json& value = item["valueAtRest"];
    listing.add("measurement", item["name"].get<std::string>() + ": " +
                                   (value.is_null() ? "no value, the scan is not there"
                                                    : fixed(value.get<double>(), 1) + ' ' +
                                                          item["unit"].get<std::string>() + " at rest"));
  }
  outcome.text = listing.text();
  outcome.warnings = opened.warnings;
  appendPatient(outcome, document::placedOrgans(*state.organs));
  return outcome;
}

std::optional<ShownBeat> shownBeat(const document::OpenedSession& opened, CommandContext& context) {
  const document::DocumentState& state = opened.contents.state;
  const presentation::ViewState view = viewOf(opened, false);
  if (!view.playing || !view.playing->shown)
    return std::nullopt;
  const auto sequence = sequenceOf(state, view, context);
  if (!sequence)
    return std::nullopt;
  return ShownBeat{toldBeat(*sequence, live::drivingCirculation(state, presentation::motionOf(view)),
                            view.playing->ratePerMinute),
                   view.playing->fraction};
}

SliceOutcome sessionSlice(const document::OpenedSession& opened, const SliceRequest& slice, double level,
                          double width, const StageOptions& options, CommandContext& context) {
  presentation::ViewState view = viewOf(opened, true);
  if (width > 0) {
    view.scan.level = level;
    view.scan.width = width;
  }
  const auto posed = posedSession(opened.contents.state, view, context);
  std::optional<presentation::Warping> warping;
  if (view.scan.warped)
    if (live::LiveWarp* warp = posed->warp())
      warping = presentation::warpingOf(*warp);
  return slicePicture({posed->state(), posed->organs(), view, warping ? &*warping : nullptr}, slice, options,
                      context.threads);
}

SessionPicture sessionPicture(const document::OpenedSession& opened, const StageOptions& options,
                              bool fromSide, CommandContext& context) {
  const document::DocumentState& state = opened.contents.state;
  const presentation::ViewState view = viewOf(opened, fromSide);
  const auto posed = posedSession(state, view, context);
  SessionPicture picture;
  if (view.shown.stress)
    if (const Text missing = makeStress(*posed, view); !missing.empty())
      picture.leftOut.push_back("the stress map (" + missing.english() + ")");
  if (view.strain.onOrgan && !view.shown.stress && (view.mode == "play" || view.mode == "deform"))
    picture.leftOut.emplace_back("the segments on the organ (--strain draws those of a pose)");
  const live::StressFrame frame = posed->stressMap().frame();
  std::optional<presentation::Warping> warping;
  if (state.scan && view.scan.warped && (view.scan.standing || !state.measurements->empty()))
    if (live::LiveWarp* warp = posed->warp())
      warping = presentation::warpingOf(*warp);
  presentation::Stage stage = stageFor(options, context.threads);
  presentation::Scene scene{posed->state(), posed->organs(), view, context.systems, &frame};
  scene.warping = warping ? &*warping : nullptr;
  setInstant(scene);
  scene.heartTissue =
      presentation::heartTissueFor(posed->state(), view, context.samples, context.progress, context.threads);
  stage.presenter().update(scene);
  if (!fromSide && view.camera)
    presentation::lookFrom(*view.camera, stage.view());
  else
    stage.compose(scene::standardViewFromName(options.view));
  picture.image = stage.picture();
  return picture;
}

} // namespace viscera::app::cli
