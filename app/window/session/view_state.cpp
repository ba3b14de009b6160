#include "window/session/view_state.h"

#include <QAction>

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>
#include <vtkRenderer.h>

#include "camera_json.h"
#include "stress_json.h"
#include "viscera/motion/motion_recipe.h"

namespace viscera::app {
namespace {

using nlohmann::ordered_json;

/// Switches that show what the document has, or are the user's own.
constexpr const char* kNotOfTheView[] = {"view.seeThrough", "handles.compensate", "theme.dark", "theme.light",
                                         "volume.lock"};
constexpr const char* kParts[] = {"view.", "handles.", "play.", "mirror."};

bool isOfTheView(const QAction& action) {
  const std::string id = action.objectName().toStdString();
  const auto begins = [&id](const char* part) { return id.starts_with(part); };
  return action.isCheckable() && std::any_of(std::begin(kParts), std::end(kParts), begins) &&
         std::find(std::begin(kNotOfTheView), std::end(kNotOfTheView), id) == std::end(kNotOfTheView);
}

ordered_json rowsJson(const Points& points) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : points.rowwise())
    rows.push_back({row[0], row[1], row[2]});
  return rows;
}

} // namespace

/// The motions that a view asks for, and what is to be seen of the present one.
struct ViewState::Wanted {
  struct Motion {
    std::shared_ptr<const document::Organ> organ;
    std::string recipe;
    std::shared_ptr<const sequences::Sequence> sequence; ///< Once it is made.
  };
  std::vector<Motion> motions;
  int present = -1; ///< Among them; -1: the one that the document holds.
  double fraction = 0;
  double ratePerMinute = 0;
  double speed = 1;
  bool shown = false;
};

ViewState::ViewState(Window window, QObject* parent) : QObject(parent), window_(std::move(window)) {}

std::string ViewState::gather() const {
  const document::Selection& selection = window_.workspace.selection();
  ordered_json view;
  for (const ModeDescription& description : modeDescriptions())
    if (description.mode == window_.mode())
      view["mode"] = description.id;
  view["camera"] = cameraJson(*window_.area.view()->view().renderer());
  view["switches"] = ordered_json::object();
  for (const QAction* action : window_.actions.all())
    if (isOfTheView(*action))
      view["switches"][action->objectName().toStdString()] = action->isChecked();
  view["stress"] = stressJson(window_.stress.look());
  view["selection"] = {{"organ", selection.organ().value}, {"group", selection.group().value}};
  view["selection"]["handles"] = ordered_json::array();
  for (const document::HandleId id : selection.handles())
    view["selection"]["handles"].push_back(id.value);
  const auto motions = window_.playback.motions();
  const motion::Player& player = window_.playback.player();
  ordered_json list = ordered_json::array();
  int present = -1;
  for (const Playback::Motion& motion : motions) {
    if (motion.recipe.empty())
      continue;
    if (motion.sequence.get() == window_.playback.sequence())
      present = static_cast<int>(list.size());
    list.push_back({{"organ", motion.organ.value}, {"recipe", ordered_json::parse(motion.recipe)}});
  }
  view["motions"] = std::move(list);
  if (window_.playback.sequence())
    view["playing"] = {{"motion", present},
                       {"fraction", player.fraction()},
                       {"ratePerMinute", player.ratePerMinute()},
                       {"speed", player.speed()},
                       {"shown", window_.playback.showing()}};
  if (window_.playback.showing())
    view["shownPose"] = rowsJson(window_.workspace.live().shownPose());
  return view.dump();
}

void ViewState::apply(const std::string& text) {
  try {
    const ordered_json view = ordered_json::parse(text);
    window_.setMode(modeFromId(QString::fromStdString(view.value("mode", std::string()))));
    const ordered_json switches = view.value("switches", ordered_json::object());
    for (QAction* action : window_.actions.all())
      if (isOfTheView(*action) && switches.contains(action->objectName().toStdString()))
        action->setChecked(switches.at(action->objectName().toStdString()).get<bool>());
    if (view.contains("stress"))
      window_.stress.setLook(stressLookOf(view.at("stress")));
    if (view.contains("selection")) {
      const ordered_json& chosen = view.at("selection");
      std::vector<document::HandleId> handles;
      for (const ordered_json& id : chosen.at("handles"))
        handles.push_back({id.get<std::int64_t>()});
      window_.workspace.selection().setOrgan({chosen.at("organ").get<std::int64_t>()});
      window_.workspace.selection().setGroup({chosen.at("group").get<std::int64_t>()});
      window_.workspace.selection().setHandles(handles);
    }
    if (view.contains("camera"))
      setCamera(view.at("camera"), *window_.area.view()->view().renderer());
    window_.area.view()->scheduleRender();
    Wanted wanted;
    for (const ordered_json& motion : view.value("motions", ordered_json::array()))
      wanted.motions.push_back({window_.workspace.document().organ({motion.at("organ").get<std::int64_t>()}),
                                motion.at("recipe").dump(), nullptr});
    if (view.contains("playing")) {
      const ordered_json& playing = view.at("playing");
      wanted.present = playing.value("motion", -1);
      wanted.fraction = playing.value("fraction", 0.0);
      wanted.ratePerMinute = playing.value("ratePerMinute", 0.0);
      wanted.speed = playing.value("speed", 1.0);
      wanted.shown = playing.value("shown", false);
    }
    makeMotions(wanted);
  } catch (const ordered_json::exception&) {
    throw DataError("not all of what the window showed could be brought back", "the session's view",
                    "the organs and the handles are complete");
  }
}

void ViewState::makeMotions(const Wanted& wanted) {
  if (wanted.motions.empty())
    return show(wanted);
  window_.workspace.jobs().submit<Wanted>(
      tr("Preparing the motion").toStdString(), "motions",
      [wanted, library = sample_organs::standardLibrary()](Progress& progress) {
        Wanted made = wanted;
        for (Wanted::Motion& motion : made.motions)
          if (motion.organ)
            motion.sequence = motion::makeMotion(motion.recipe, *motion.organ, library, progress);
        return made;
      },
      [this](JobResult<Wanted> result) {
        if (result.error)
          window_.workspace.report(*result.error);
        if (result.value)
          show(*result.value);
      });
}

void ViewState::show(const Wanted& wanted) {
  Playback& playback = window_.playback;
  for (const Wanted::Motion& motion : wanted.motions)
    if (motion.sequence && window_.workspace.document().organ(motion.organ->id))
      playback.offer(motion.sequence, motion.organ->id, motion.recipe);
  if (wanted.present >= 0 && wanted.present < static_cast<int>(wanted.motions.size()))
    playback.choose(wanted.motions[static_cast<std::size_t>(wanted.present)].sequence.get());
  if (playback.sequence() && wanted.ratePerMinute > 0) {
    playback.setRate(wanted.ratePerMinute);
    playback.setSpeed(wanted.speed);
    playback.setLooping(window_.actions["play.loop"]->isChecked());
    if (wanted.shown)
      playback.seek(wanted.fraction);
  }
  Q_EMIT applied();
}

} // namespace viscera::app
