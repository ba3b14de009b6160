#include "cli/session_input.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <vtkImageData.h>

#include "camera_json.h"
#include "cli/listing.h"
#include "cli/session_overlays.h"
#include "viscera/core/error.h"
#include "viscera/document/measurement.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/live_binding.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

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

/// The handles of a session as a picture shows them.
RigInput rigOf(const document::Rig& rig) {
  RigInput input;
  input.handles = document::handleSet(rig);
  for (const document::Handle& handle : rig.handles)
    input.labels.push_back(handle.label);
  for (const document::Group& group : rig.groups)
    input.groupColors.push_back(group.color);
  return input;
}

/// The pose that the window showed: an instant of a motion, else the document's.
Points shownPose(const document::DocumentState& state, const ordered_json& view) {
  Points pose = *state.pose;
  const ordered_json rows = view.value("shownPose", ordered_json());
  if (!rows.is_array() || static_cast<Eigen::Index>(rows.size()) != pose.rows())
    return pose;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int k = 0; k < 3; ++k)
      pose(static_cast<Eigen::Index>(i), k) = rows[i].at(static_cast<std::size_t>(k)).get<double>();
  return pose;
}

bool showsHandles(const ordered_json& view) {
  const std::string mode = view.value("mode", std::string());
  return mode == "handles" || mode == "deform" || switchedOn(view, "view.handles", false);
}

/// Each with its value at rest.
ordered_json measurementsJson(const document::DocumentState& state) {
  const auto atRest = [&](document::OrganId id) -> const Points& { return state.organ(id)->mesh->points; };
  ordered_json list = ordered_json::array();
  for (const document::Measurement& measurement : *state.measurements) {
    const auto kind = document::kindOf(measurement);
    list.push_back({{"name", measurement.name},
                    {"kind", document::nameOf(kind)},
                    {"valueAtRest", document::measure(measurement, state, atRest).rest},
                    {"unit", document::unitOf(kind)}});
  }
  return list;
}

std::shared_ptr<scene::OrganActor> addOrgan(Stage& stage, const document::Organ& organ,
                                            const live::LiveBinding& live) {
  auto actor = stage.add(organ, organ.look.opacity);
  actor->setVertexColorsShown(organ.look.vertexColors);
  actor->setVisible(organ.look.visible);
  actor->setPoints(std::make_shared<const Points>(live.points(organ.id)));
  return actor;
}

} // namespace

Outcome describeSession(const std::string& file, Surroundings& surroundings) {
  const document::OpenedSession opened =
      document::readSession(file, surroundings.samples, surroundings.progress);
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
                  {"recordedKeys", state.recording->keys.size()},
                  {"measurements", measurementsJson(state)},
                  {"warnings", opened.warnings}};
  listing.add("handles", std::to_string(state.rig->handles.size()) +
                             (document::atRest(state) ? ", at rest" : ", posed"));
  for (const document::Group& group : state.rig->groups)
    listing.add("group", group.name + ": " + std::to_string(group.handles.size()));
  if (!state.rig->cage.empty())
    listing.add("cage", std::to_string(state.rig->cage.size()) + " triangles");
  listing.add("coordinates", state.system->id)
      .add("recorded keys", std::to_string(state.recording->keys.size()));
  for (const ordered_json& item : outcome.json["measurements"])
    listing.add("measurement", item["name"].get<std::string>() + ": " +
                                   fixed(item["valueAtRest"].get<double>(), 1) + ' ' +
                                   item["unit"].get<std::string>() + " at rest");
  outcome.text = listing.text();
  outcome.warnings = opened.warnings;
  return outcome;
}

SessionPicture sessionPicture(const document::OpenedSession& opened, const StageOptions& options,
                              bool fromSide, Surroundings& surroundings) {
  const document::DocumentState& state = opened.contents.state;
  const auto view = ordered_json::parse(opened.contents.view);
  document::Document document;
  document::UndoStack undo(document);
  PostBox box;
  JobQueue jobs(box.post());
  live::LiveBinding::Options atOnce;
  atOnce.frameSeconds = std::numeric_limits<double>::infinity();
  atOnce.threads = surroundings.threads;
  live::LiveBinding live(document, surroundings.systems, jobs, atOnce);
  undo.reset(state);
  Stage stage(options, surroundings.threads);
  StagedSession staged{document, live, jobs, box, stage, {}};
  std::unique_ptr<SessionOverlays> overlays;
  std::unique_ptr<SessionStress> stress;
  SessionPicture picture;
  try {
    if (view.value("mode", std::string()) == "handles")
      live.showRest();
    else
      live.showPose(shownPose(state, view));
    for (const auto& organ : *state.organs)
      staged.actors[organ->id] = addOrgan(stage, *organ, live);
    if (showsHandles(view)) {
      stage.showHandles(rigOf(*state.rig));
      stage.view().handles()->SetPositions(live.shownPose());
    }
    stage.view().setOrientationCubeShown(switchedOn(view, "view.cube", true));
    stage.view().setScaleBarShown(switchedOn(view, "view.scale", true));
    overlays = std::make_unique<SessionOverlays>(staged, view, surroundings.systems);
    stage.compose();
    if (showsInfluence(view))
      drawInfluence(staged, view);
    if (showsStress(view)) {
      stress = std::make_unique<SessionStress>(staged, view, surroundings.systems, surroundings.threads);
      picture.leftOut = stress->leftOut();
    }
    if (!fromSide && view.contains("camera"))
      setCamera(view.at("camera"), *stage.view().renderer());
  } catch (const ordered_json::exception&) {
    throw DataError("its view is none that Viscera has written", "view", "give --view for another one");
  }
  picture.image = stage.picture();
  return picture;
}

} // namespace viscera::app::cli
