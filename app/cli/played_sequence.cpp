#include "cli/played_sequence.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "cli/inputs.h"
#include "cli/session_input.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/session_file.h"
#include "viscera/document/system_commands.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/player.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/live/session_motion.h"
#include "viscera/live/textbook_motion.h"
#include "viscera/live/unsuited_motion.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/presentation/view_state.h"

namespace viscera::app::cli {
namespace {

constexpr double kWallOpacity = 0.35;
constexpr double kSlack = 0.01; ///< Of the diagonal.

/// The surfaces on their way into a document, each with its name in tables.
struct Surfaces {
  std::vector<std::string> names;
  std::vector<document::NewOrgan> organs;

  void add(std::string name, document::Organ organ) {
    organ.look.opacity = 1;
    names.push_back(std::move(name));
    organs.push_back({std::move(organ), -1});
  }

  /// Makes the surface transparent that all others lie in: cavities are seen through the wall around them.
  void showCavities() {
    const auto wall = std::find_if(organs.begin(), organs.end(), [this](const document::NewOrgan& around) {
      return std::all_of(organs.begin(), organs.end(), [&](const document::NewOrgan& other) {
        return !other.organ.look.visible || liesIn(other, around);
      });
    });
    if (organs.size() > 1 && wall != organs.end())
      wall->organ.look.opacity = kWallOpacity;
  }

private:
  /// Up to a part of the size, by which a wall may be thinner than the surfaces are exact.
  static bool liesIn(const document::NewOrgan& inner, const document::NewOrgan& outer) {
    const Bounds inside = boundsOf(inner.organ.mesh->points), around = boundsOf(outer.organ.mesh->points);
    const double slack = kSlack * around.diagonal();
    return (inside.low.array() >= around.low.array() - slack).all() &&
           (inside.high.array() <= around.high.array() + slack).all();
  }
};

Surfaces surfacesOf(const sample_organs::SampleOrgan& sample) {
  Surfaces surfaces;
  for (const sample_organs::SampleSurface& surface : sample.surfaces) {
    document::Organ organ = document::organFrom(surface, surface.name);
    organ.origin.sample = sample.name + "@" + sample_organs::nameOf(sample.resolution);
    organ.origin.surface = surface.name;
    surfaces.add(surface.name, std::move(organ));
  }
  return surfaces;
}

/// The resolution of ORGAN when it is the sequence's own organ as a whole; else nothing.
std::optional<sample_organs::Resolution> resolutionOf(const std::string& organ, const std::string& own) {
  if (organ.empty())
    return sample_organs::Resolution::medium;
  if (!isSample(organ))
    return std::nullopt;
  const SampleReference reference = sampleReference(organ);
  const bool same = reference.organ == own && reference.surface.empty();
  return same ? std::optional(reference.resolution) : std::nullopt;
}

std::string ownOrgan(const std::string& sequence) {
  for (const live::SampleSequence& sample : live::sampleSequences())
    if (sample.id == sequence)
      return sample.organ;
  return {};
}

/// Throws when the handles of a file are not the sequence's own.
void requireOwnHandles(const std::string& file, const sequences::Sequence& sequence,
                       std::vector<Text>& warnings) {
  document::requireFits(rigInput(file, warnings), sequence);
}

/// "apex=1,2,3" taken apart.
live::Landmark landmarkOf(const std::string& text) {
  const std::size_t equal = text.find('=');
  std::istringstream numbers(equal == std::string::npos ? "" : text.substr(equal + 1));
  Vec3 place;
  char comma = 0;
  char second = 0;
  numbers >> place[0] >> comma >> place[1] >> second >> place[2];
  if (!numbers || comma != ',' || second != ',' || !(numbers >> std::ws).eof())
    throw UsageError("It is not a name and three numbers", "--landmark " + text,
                     "as in apex=12.5,-40,7 (mm, LPS)");
  return {text.substr(0, equal), place, false};
}

live::Landmarks givenLandmarks(const PlayRequest& request, std::vector<Text>& warnings) {
  live::Landmarks landmarks;
  for (const std::string& text : request.landmark)
    landmarks.points.push_back(landmarkOf(text));
  if (request.landmarks.empty())
    return landmarks;
  const medical_io::HandleFile file = medical_io::readHandles(request.landmarks);
  for (const Text& warning : file.warnings)
    warnings.push_back(phrase("%1: %2", request.landmarks, warning));
  const live::Landmarks inFile = live::landmarksFrom(file, request.sequence, request.landmarks);
  for (const live::Landmark& landmark : inFile.points)
    if (!landmarks.find(landmark.role) || landmarks.find(landmark.role)->role == "centreline")
      landmarks.points.push_back(landmark);
  return landmarks;
}

/// Puts the surfaces into a document with the handles, and binds them.
void bindAll(PlayedSequence& played, Surfaces surfaces, const document::SystemChoice& system,
             CommandContext& context) {
  surfaces.showCavities();
  played.bench = benchFor(context);
  played.bench->perform(
      document::combined("Play", {document::addOrgans(std::move(surfaces.organs)),
                                  document::replaceRig(played.rig), document::setSystem(system)}));
  played.bench->setSequence(played.sequence);
  const document::OrganList& organs = *played.bench->state().organs;
  for (std::size_t i = 0; i < surfaces.names.size(); ++i)
    played.surfaces.push_back({surfaces.names[i], organs[i]->id});
  for (const auto& organ : organs) {
    const live::BindingStatus status = played.bench->organs().status(organ->id);
    if (status.state != live::BindingStatus::State::bound)
      throw DataError(status.message, organ->name);
  }
}

/// The circulation of the scenario that is asked for; empty: none is.
std::optional<live::DrivingCirculation> scenarioOf(const PlayRequest& request) {
  if (request.scenario.empty())
    return std::nullopt;
  live::DrivingCirculation driving{named(circulation::scenario(request.scenario).name),
                                   circulation::scenarioParameters(request.scenario)};
  if (request.ratePerMinute > 0)
    circulation::setParameter(driving.parameters, "rate", request.ratePerMinute);
  return driving;
}

/// The sequence itself, or the heart that follows a circulation.
live::SequenceSetup setUpFor(const PlayRequest& request,
                             const std::optional<live::DrivingCirculation>& driving,
                             sample_organs::Resolution resolution, CommandContext& context) {
  if (!driving)
    return live::setUpSequence(context.samples, request.sequence, resolution, context.progress,
                               context.threads);
  return live::circulatingHeart(context.samples, driving->name, driving->parameters, resolution,
                                context.progress, context.threads);
}

/// A shipped sequence on its own organ, or on one of that organ's surfaces.
PlayedSequence onOwnOrgan(const PlayRequest& request, CommandContext& context) {
  const std::optional<sample_organs::Resolution> resolution =
      resolutionOf(request.organ, ownOrgan(request.sequence));
  PlayedSequence played;
  played.driving = scenarioOf(request);
  const live::SequenceSetup setup =
      setUpFor(request, played.driving, resolution.value_or(sample_organs::Resolution::medium), context);
  played.sequence = setup.sequence;
  played.rig = setup.rig;
  Surfaces surfaces;
  if (resolution)
    surfaces = surfacesOf(setup.organ);
  else
    surfaces.add("outer", organInput(request.organ, context.samples, context.progress));
  played.hasWalls = std::count(surfaces.names.begin(), surfaces.names.end(), "lv") > 0;
  for (const char* wall : {"chambers", "lv_wall"}) {
    if (!played.hasWalls)
      break;
    const sample_organs::SampleSurface surface = sample_organs::sampleSurface(
        context.samples, "heart", wall, *resolution, context.progress, context.threads);
    surfaces.organs.push_back({document::makeOrgan(wall, surface.mesh), -1});
    surfaces.organs.back().organ.look.visible = false;
  }
  bindAll(played, std::move(surfaces), setup.system, context);
  return played;
}

/// The surfaces in the file of a key sequence.
Surfaces surfacesOf(const live::SequenceFile& file) {
  Surfaces surfaces;
  for (const live::SequenceOrgan& organ : file.organs)
    surfaces.add(organ.name, document::makeOrgan(organ.name, organ.mesh));
  return surfaces;
}

PlayedSequence playRecorded(const live::SequenceFile& file, Surfaces surfaces, CommandContext& context) {
  PlayedSequence played;
  played.sequence = std::make_shared<sequences::KeyframedSequence>(file.track);
  played.rig = live::rigOf(file);
  bindAll(played, std::move(surfaces), file.system.value_or(document::SystemChoice()), context);
  return played;
}

/// The heart with chambers that is asked for: the one that is named, or has the named chamber; else the
/// first.
std::shared_ptr<const document::Organ> heartAmong(const OrgansAround& around) {
  for (const auto& organ : around.organs)
    if (around.name.empty() || organ->name == around.name)
      if (auto heart = live::heartWithCavities(around.organs, *organ))
        return heart;
  return nullptr;
}

/// The textbook's beat in a heart with its chambers; nothing for another organ.
std::optional<PlayedSequence> onHeartWithChambers(const PlayRequest& request, CommandContext& context) {
  if (request.sequence != "heartbeat")
    return std::nullopt;
  const OrgansAround around = organsAround(request.organ, context.samples, context.progress);
  const std::shared_ptr<const document::Organ> heart = heartAmong(around);
  if (!heart)
    return std::nullopt;
  std::vector<Text> warnings = heart->warnings;
  live::TextbookBeat beat;
  beat.given = givenLandmarks(request, warnings);
  if (request.ratePerMinute > 0)
    beat.ratePerMinute = request.ratePerMinute;
  if (request.ejectionFraction > 0)
    beat.ejectionFraction = request.ejectionFraction;
  const live::PatientMotion found =
      live::textbookMotion(around.organs, *heart, beat, context.progress, context.threads);
  PlayedSequence played = playRecorded(found.sequence, surfacesOf(found.sequence), context);
  played.warnings = std::move(warnings);
  played.warnings.insert(played.warnings.end(), found.warnings.begin(), found.warnings.end());
  return played;
}

void requireNoEjectionFraction(const PlayRequest& request) {
  if (request.ejectionFraction > 0)
    throw UsageError("Only a heart with its chambers can be given an ejection fraction",
                     "--ejection-fraction", "name a label map of a heart with --organ");
}

/// A shipped sequence on an organ that it is not made for.
PlayedSequence onOtherOrgan(const PlayRequest& request, CommandContext& context) {
  if (std::optional<PlayedSequence> heart = onHeartWithChambers(request, context))
    return std::move(*heart);
  requireNoEjectionFraction(request);
  PlayedSequence played;
  const live::Landmarks given = givenLandmarks(request, played.warnings);
  const std::string name = request.organ.empty() ? "sample:" + ownOrgan(request.sequence) : request.organ;
  document::Organ organ = organInput(name, context.samples, context.progress);
  live::RetargetedSequence fitted =
      live::retargetSequence(request.sequence, organ, given, context.progress, context.threads);
  played.warnings.insert(played.warnings.begin(), fitted.warnings.begin(), fitted.warnings.end());
  played.warnings.insert(played.warnings.end(), organ.warnings.begin(), organ.warnings.end());
  played.sequence = fitted.sequence;
  played.rig = fitted.rig;
  Surfaces surfaces;
  surfaces.add("outer", std::move(organ));
  bindAll(played, std::move(surfaces), fitted.system, context);
  played.retargeted = std::move(fitted);
  return played;
}

PlayedSequence fromFile(const PlayRequest& request, CommandContext& context) {
  const live::SequenceFile file = live::readSequence(request.sequence);
  if (request.organ.empty() && file.organs.empty())
    throw UsageError("It needs an organ to move", request.sequence, "name one with --organ");
  if (request.organ.empty())
    return playRecorded(file, surfacesOf(file), context);
  Surfaces surfaces;
  std::vector<Text> warnings;
  for (document::Organ& organ : organInputs(request.organ, context.samples, context.progress)) {
    if (Text unsuited = live::unsuitedTo(file, organ.name); surfaces.names.empty() && !unsuited.empty())
      warnings.push_back(std::move(unsuited));
    warnings.insert(warnings.end(), organ.warnings.begin(), organ.warnings.end());
    const std::string name = surfaces.names.empty() ? "outer" : organ.name.substr(organ.name.find('/') + 1);
    surfaces.add(name, std::move(organ));
  }
  PlayedSequence played = playRecorded(file, std::move(surfaces), context);
  played.warnings = std::move(warnings);
  return played;
}

/// Throws for options that a session sets itself.
void requireOnlySession(const PlayRequest& request) {
  const std::pair<bool, const char*> given[] = {{!request.organ.empty(), "--organ"},
                                                {!request.landmarks.empty(), "--landmarks"},
                                                {!request.landmark.empty(), "--landmark"},
                                                {!request.scenario.empty(), "--scenario"},
                                                {request.ejectionFraction > 0, "--ejection-fraction"}};
  for (const auto& [isGiven, option] : given)
    if (isGiven)
      throw UsageError("A session is played as it is", option, std::string("leave ") + option + " out");
}

/// A name for each organ's column, all different.
std::vector<std::string> columnNames(const document::OrganList& organs) {
  std::vector<std::string> names;
  for (const auto& organ : organs) {
    std::string name = organ->name;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = organ->name + '-' + std::to_string(number);
    names.push_back(std::move(name));
  }
  return names;
}

/// The sequence that a session plays, with the session's locks, rate and prescribed volume.
PlayedSequence fromSession(const PlayRequest& request, CommandContext& context) {
  requireOnlySession(request);
  const document::OpenedSession opened =
      document::readSession(request.sequence, context.samples, context.progress);
  const document::DocumentState& state = opened.contents.state;
  const presentation::ViewState view =
      presentation::viewFromJson(opened.contents.view, *opened.contents.state.circulation);
  PlayedSequence played;
  played.ofSession = true;
  played.warnings = opened.warnings;
  played.sequence = sequenceOf(state, view, context);
  if (!played.sequence || state.organs->empty())
    throw UsageError("It moves no organ", request.sequence, "choose a motion in the window and save it");
  const live::SessionMotion motion = presentation::motionOf(view);
  if (Text unsuited = live::unsuitedMotion(state, motion, *played.sequence); !unsuited.empty())
    played.warnings.insert(played.warnings.begin(), std::move(unsuited));
  document::requireFits(*state.rig, *played.sequence);
  played.ratePerMinute = live::rateOf(motion, *played.sequence);
  played.prescribed = live::prescribedVolume(state, motion);
  played.driving = live::drivingCirculation(state, motion);
  played.bench = benchFor(context);
  played.bench->restore(opened.contents);
  played.bench->setSequence(played.sequence, played.ratePerMinute);
  const std::vector<std::string> names = columnNames(*state.organs);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const document::OrganId organ = (*state.organs)[i]->id;
    played.surfaces.push_back({names[i], organ});
    const live::BindingStatus status = played.bench->organs().status(organ);
    if (status.state != live::BindingStatus::State::bound)
      played.warnings.push_back(names[i] + " stays at rest: " + status.message.english());
  }
  return played;
}

/// Whether a shipped sequence is to be fitted: landmarks are given, or the organ is no surface of its own
/// one.
bool isOther(const PlayRequest& request) {
  if (!request.landmarks.empty() || !request.landmark.empty())
    return true;
  const std::string own = ownOrgan(request.sequence);
  return !own.empty() && !request.organ.empty() &&
         !(isSample(request.organ) && sampleReference(request.organ).organ == own);
}

/// A sequence that is named, or in a file of its own.
PlayedSequence namedSequence(const PlayRequest& request, CommandContext& context) {
  const bool isFile = live::isSequenceFile(request.sequence);
  if (isFile && (!request.landmarks.empty() || !request.landmark.empty()))
    throw UsageError("It is played on the handles that it holds", request.sequence,
                     "leave the landmarks out");
  if (!request.scenario.empty() && (request.sequence != "heartbeat" || isOther(request)))
    throw UsageError("Only the sample heart follows a circulation", "--scenario " + request.scenario,
                     "play heartbeat without --organ and landmarks");
  if (isFile || !isOther(request))
    requireNoEjectionFraction(request);
  return isFile             ? fromFile(request, context)
         : isOther(request) ? onOtherOrgan(request, context)
                            : onOwnOrgan(request, context);
}

} // namespace

int PlayedSequence::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name)
      return static_cast<int>(i);
  return -1;
}

PlayedSequence playedSequence(const PlayRequest& request, CommandContext& context) {
  PlayedSequence played = document::isSessionFile(request.sequence) ? fromSession(request, context)
                                                                    : namedSequence(request, context);
  if (!request.handles.empty())
    requireOwnHandles(request.handles, *played.sequence, played.warnings);
  return played;
}

} // namespace viscera::app::cli
