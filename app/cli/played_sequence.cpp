#include "cli/played_sequence.h"

#include <optional>
#include <sstream>

#include "cli/inputs.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/document/sequence_rig.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/motion/player.h"
#include "viscera/motion/sequence_file.h"
#include "viscera/motion/sequence_setup.h"

namespace viscera::app::cli {
namespace {

/// An organ of the command line as it appears in tables: "outer" where it has cavities.
std::vector<PlayedSurface> surfacesOf(const sample_organs::SampleOrgan& sample) {
  std::vector<PlayedSurface> surfaces;
  for (const sample_organs::SampleSurface& surface : sample.surfaces) {
    document::Organ organ = document::makeOrgan(surface.name, surface.mesh);
    organ.look.color = surface.color;
    surfaces.push_back({surface.name, std::move(organ), nullptr, false});
  }
  surfaces.front().wall = surfaces.size() > 1;
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
  for (const motion::SampleSequence& sample : motion::sampleSequences())
    if (sample.id == sequence)
      return sample.organ;
  return {};
}

/// Throws when the handles of a file are not the sequence's own.
void requireOwnHandles(const std::string& file, const sequences::Sequence& sequence,
                       std::vector<std::string>& warnings) {
  const RigInput input = rigInput(file, warnings);
  document::Rig rig;
  for (const auto& position : input.handles.positions.rowwise()) {
    document::Handle handle;
    handle.rest = position.transpose();
    rig.handles.push_back(handle);
  }
  document::requireFits(rig, sequence);
}

/// "apex=1,2,3" taken apart.
motion::Landmark landmarkOf(const std::string& text) {
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

motion::Landmarks givenLandmarks(const PlayRequest& request, std::vector<std::string>& warnings) {
  motion::Landmarks landmarks;
  for (const std::string& text : request.landmark)
    landmarks.points.push_back(landmarkOf(text));
  if (request.landmarks.empty())
    return landmarks;
  const medical_io::HandleFile file = medical_io::readHandles(request.landmarks);
  for (const std::string& warning : file.warnings)
    warnings.push_back(request.landmarks + ": " + warning);
  const motion::Landmarks inFile = motion::landmarksFrom(file, request.sequence, request.landmarks);
  for (const motion::Landmark& landmark : inFile.points)
    if (!landmarks.find(landmark.role) || landmarks.find(landmark.role)->role == "centreline")
      landmarks.points.push_back(landmark);
  return landmarks;
}

/// Ties surfaces to the handles of a sequence.
class Binder {
public:
  Binder(const sequences::Sequence& sequence, const document::SystemChoice& choice,
         Surroundings& surroundings)
      : choice_(choice), surroundings_(surroundings), system_(surroundings.systems.find(choice.id)) {
    handles_.positions = sequence.restHandles();
    for (const sequences::HandleGroup& group : sequence.groups())
      handles_.groups.push_back({group.name, group.handles});
  }

  std::shared_ptr<deformation::Deformer> bound(std::shared_ptr<const geometry::TriangleMesh> mesh) const {
    auto binding =
        deformation::bindOrgan(*system_, handles_, mesh->points, {choice_.parameters, surroundings_.threads},
                               surroundings_.progress);
    return std::make_shared<deformation::Deformer>(std::move(mesh), std::move(binding), handles_.positions,
                                                   surroundings_.threads);
  }

private:
  const document::SystemChoice& choice_;
  Surroundings& surroundings_;
  std::shared_ptr<const coordinates::CoordinateSystem> system_;
  coordinates::HandleSet handles_;
};

void bindAll(PlayedSequence& played, const document::SystemChoice& system, Surroundings& surroundings) {
  const Binder binder(*played.sequence, system, surroundings);
  for (PlayedSurface& surface : played.surfaces)
    surface.deformer = binder.bound(surface.organ.mesh);
}

/// A shipped sequence on its own organ, or on one of that organ's surfaces.
PlayedSequence onOwnOrgan(const PlayRequest& request, Surroundings& surroundings) {
  const std::optional<sample_organs::Resolution> resolution =
      resolutionOf(request.organ, ownOrgan(request.sequence));
  const motion::SequenceSetup setup = motion::setUpSequence(
      surroundings.samples, request.sequence, resolution.value_or(sample_organs::Resolution::medium),
      surroundings.progress, surroundings.threads);
  PlayedSequence played;
  played.sequence = setup.sequence;
  played.rig = setup.rig;
  if (resolution)
    played.surfaces = surfacesOf(setup.organ);
  else
    played.surfaces.push_back(
        {"outer", organInput(request.organ, surroundings.samples, surroundings.progress), nullptr, false});
  bindAll(played, setup.system, surroundings);
  if (played.find("lv")) {
    const sample_organs::SampleSurface chambers = sample_organs::sampleSurface(
        surroundings.samples, "heart", "chambers", *resolution, surroundings.progress, surroundings.threads);
    played.chambers = Binder(*played.sequence, setup.system, surroundings).bound(chambers.mesh);
  }
  return played;
}

/// A shipped sequence on an organ that it is not made for.
PlayedSequence onOtherOrgan(const PlayRequest& request, Surroundings& surroundings) {
  PlayedSequence played;
  const motion::Landmarks given = givenLandmarks(request, played.warnings);
  const std::string name = request.organ.empty() ? "sample:" + ownOrgan(request.sequence) : request.organ;
  document::Organ organ = organInput(name, surroundings.samples, surroundings.progress);
  motion::RetargetedSequence fitted =
      motion::retargetSequence(request.sequence, organ, given, surroundings.progress, surroundings.threads);
  played.warnings.insert(played.warnings.end(), organ.warnings.begin(), organ.warnings.end());
  played.warnings.insert(played.warnings.end(), fitted.warnings.begin(), fitted.warnings.end());
  played.sequence = fitted.sequence;
  played.rig = fitted.rig;
  played.surfaces.push_back({"outer", std::move(organ), nullptr, false});
  bindAll(played, fitted.system, surroundings);
  played.retargeted = std::move(fitted);
  return played;
}

PlayedSequence fromFile(const PlayRequest& request, Surroundings& surroundings) {
  if (request.organ.empty())
    throw UsageError("It needs an organ to move", request.sequence, "name one with --organ");
  const motion::SequenceFile file = motion::readSequence(request.sequence);
  PlayedSequence played;
  played.sequence = std::make_shared<sequences::KeyframedSequence>(file.track);
  played.rig = motion::rigOf(file);
  for (document::Organ& organ : organInputs(request.organ, surroundings.samples, surroundings.progress)) {
    played.warnings.insert(played.warnings.end(), organ.warnings.begin(), organ.warnings.end());
    const std::string name = played.surfaces.empty() ? "outer" : organ.name.substr(organ.name.find('/') + 1);
    played.surfaces.push_back({name, std::move(organ), nullptr, false});
  }
  played.surfaces.front().wall = played.surfaces.size() > 1;
  bindAll(played, file.system.value_or(document::SystemChoice()), surroundings);
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

} // namespace

const PlayedSurface* PlayedSequence::find(const std::string& name) const {
  for (const PlayedSurface& surface : surfaces)
    if (surface.name == name)
      return &surface;
  return nullptr;
}

PlayedSequence playedSequence(const PlayRequest& request, Surroundings& surroundings) {
  const bool isFile = motion::isSequenceFile(request.sequence);
  if (isFile && (!request.landmarks.empty() || !request.landmark.empty()))
    throw UsageError("It is played on the handles that it holds", request.sequence,
                     "leave the landmarks out");
  PlayedSequence played = isFile             ? fromFile(request, surroundings)
                          : isOther(request) ? onOtherOrgan(request, surroundings)
                                             : onOwnOrgan(request, surroundings);
  if (!request.handles.empty())
    requireOwnHandles(request.handles, *played.sequence, played.warnings);
  return played;
}

} // namespace viscera::app::cli
