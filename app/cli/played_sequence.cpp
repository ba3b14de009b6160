#include "cli/played_sequence.h"

#include <optional>

#include "cli/inputs.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/session/player.h"
#include "viscera/session/sequence_setup.h"

namespace viscera::app::cli {
namespace {

/// An organ of the command line as it appears in tables: "outer" where it has cavities.
std::vector<PlayedSurface> surfacesOf(const organs::SampleOrgan& sample) {
  std::vector<PlayedSurface> surfaces;
  for (const organs::SampleSurface& surface : sample.surfaces) {
    session::Organ organ = session::makeOrgan(surface.name, surface.mesh);
    organ.look.color = surface.color;
    surfaces.push_back({surface.name, std::move(organ), nullptr, false});
  }
  surfaces.front().wall = surfaces.size() > 1;
  return surfaces;
}

/// The resolution of ORGAN when it is the sequence's own organ as a whole; else nothing.
std::optional<organs::Resolution> resolutionOf(const std::string& organ, const std::string& own) {
  if (organ.empty())
    return organs::Resolution::medium;
  if (!isSample(organ))
    return std::nullopt;
  const SampleReference reference = sampleReference(organ);
  const bool same = reference.organ == own && reference.surface.empty();
  return same ? std::optional(reference.resolution) : std::nullopt;
}

std::string ownOrgan(const std::string& sequence) {
  for (const session::SampleSequence& sample : session::sampleSequences())
    if (sample.id == sequence)
      return sample.organ;
  return {};
}

/// Throws when the handles of a file are not the sequence's own.
void requireOwnHandles(const std::string& file, const sequences::Sequence& sequence,
                       std::vector<std::string>& warnings) {
  const RigInput input = rigInput(file, warnings);
  session::Rig rig;
  for (const auto& position : input.handles.positions.rowwise()) {
    session::Handle handle;
    handle.rest = position.transpose();
    rig.handles.push_back(handle);
  }
  session::requireFits(rig, sequence);
}

} // namespace

const PlayedSurface* PlayedSequence::find(const std::string& name) const {
  for (const PlayedSurface& surface : surfaces)
    if (surface.name == name)
      return &surface;
  return nullptr;
}

PlayedSequence playedSequence(const std::string& name, const std::string& organ, const std::string& handles,
                              Surroundings& surroundings) {
  const std::optional<organs::Resolution> resolution = resolutionOf(organ, ownOrgan(name));
  const session::SequenceSetup setup =
      session::setUpSequence(surroundings.samples, name, resolution.value_or(organs::Resolution::medium),
                             surroundings.progress, surroundings.threads);
  PlayedSequence played;
  played.sequence = setup.sequence;
  if (!handles.empty())
    requireOwnHandles(handles, *setup.sequence, played.warnings);
  if (resolution) {
    played.surfaces = surfacesOf(setup.organ);
  } else {
    session::Organ other = organInput(organ, surroundings.samples, surroundings.progress);
    played.warnings.insert(played.warnings.end(), other.warnings.begin(), other.warnings.end());
    played.surfaces.push_back({"outer", std::move(other), nullptr, false});
  }
  const auto system = surroundings.systems.find(setup.system.id);
  coordinates::HandleSet rest;
  rest.positions = setup.sequence->restHandles();
  for (PlayedSurface& surface : played.surfaces)
    surface.deformer = std::make_shared<deformation::Deformer>(
        surface.organ.mesh,
        deformation::bindOrgan(*system, rest, surface.organ.mesh->points,
                               {setup.system.parameters, surroundings.threads}, surroundings.progress),
        rest.positions, surroundings.threads);
  return played;
}

} // namespace viscera::app::cli
