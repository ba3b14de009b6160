#include "cli/inputs.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "viscera/coordinates/cage/cage.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/document/system_commands.h"
#include "viscera/document/undo_stack.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::app::cli {
namespace {

constexpr std::string_view kSamplePrefix = "sample:";
constexpr std::size_t kLabelsNamed = 8;

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kLabelsNamed); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kLabelsNamed ? text + " and " + std::to_string(names.size() - kLabelsNamed) + " more"
                                     : text;
}

std::vector<std::string> labelsOf(const document::Rig& rig) {
  std::vector<std::string> labels;
  for (const document::Handle& handle : rig.handles)
    labels.push_back(handle.label);
  return labels;
}

void requireSize(const document::Organ& organ, const std::string& where) {
  if (!(boundsOf(organ.mesh->points).diagonal() > 0))
    throw DataError("all its vertices are at one place", where, "export the surface again");
}

document::Organ organOf(const sample_organs::SampleOrgan& sample,
                        const sample_organs::SampleSurface& surface) {
  const bool outer = &surface == &sample.surfaces.front();
  return document::organFrom(surface, outer ? sample.name : sample.name + "/" + surface.name);
}

/// A surface of a sample that is none of its organs, such as the heart's tissue; nothing where the definition
/// has none of that name.
std::optional<document::Organ> furtherSurface(const SampleReference& reference,
                                              const sample_organs::SampleLibrary& samples,
                                              Progress& progress) {
  try {
    const sample_organs::SampleSurface surface = sample_organs::sampleSurface(
        samples, reference.organ, reference.surface, reference.resolution, progress);
    return document::organFrom(surface, reference.organ + "/" + surface.name);
  } catch (const UsageError&) {
    return std::nullopt;
  }
}

/// A label map and the labels to read from it.
struct LabelReference {
  std::filesystem::path file;
  std::vector<std::string> labels; ///< Empty: all.
};

/// "abdomen.nrrd" or "abdomen.nrrd/liver"; nothing for what is no label map.
std::optional<LabelReference> labelReference(const std::filesystem::path& organ) {
  if (medical_io::isLabelMap(organ))
    return LabelReference{organ, {}};
  std::error_code ignored;
  const std::filesystem::path file = organ.parent_path();
  if (!std::filesystem::exists(organ, ignored) && std::filesystem::exists(file, ignored) &&
      medical_io::isLabelMap(file) && !organ.has_extension())
    return LabelReference{file, {organ.filename().string()}};
  return std::nullopt;
}

/// "organs.obj/Liver" taken apart; nothing for a file alone, and for what is no surface file.
struct SurfaceReference {
  std::filesystem::path file;
  std::string part; ///< Its name, or its number from 1.
};

std::optional<SurfaceReference> surfaceReference(const std::string& organ) {
  // An organ's name may have a slash, too: the file that is there ends the path.
  for (std::size_t slash = organ.find('/'); slash != std::string::npos; slash = organ.find('/', slash + 1)) {
    const std::filesystem::path file = organ.substr(0, slash);
    std::error_code ignored;
    if (slash > 0 && slash + 1 < organ.size() && std::filesystem::is_regular_file(file, ignored) &&
        medical_io::fileKind(file) == medical_io::FileKind::surface)
      return SurfaceReference{file, organ.substr(slash + 1)};
  }
  return std::nullopt;
}

/// The organs of a surface file, or the one that is named; their warnings begin with what was named.
std::vector<document::Organ> surfaceOrgans(const std::string& organ) {
  const std::optional<SurfaceReference> reference = surfaceReference(organ);
  std::vector<document::Organ> organs;
  for (document::NewOrgan& item :
       reference ? document::readOrgans(reference->file, reference->part) : document::readOrgans(organ))
    organs.push_back(std::move(item.organ));
  for (document::Organ& one : organs)
    for (Text& warning : one.warnings)
      warning =
          phrase("%1: %2", organs.size() == 1 ? Text(organ) : phrase("%1: %2", organ, one.name), warning);
  return organs;
}

document::Organ organOf(const SessionReference& reference, const document::OpenedSession& opened) {
  const document::OrganList& organs = *opened.contents.state.organs;
  std::vector<std::string> names;
  for (const auto& organ : organs) {
    if (organ->name == reference.organ)
      return *organ;
    names.push_back(organ->name);
  }
  for (std::size_t i = 0; i < organs.size(); ++i)
    if (std::to_string(i + 1) == reference.organ)
      return *organs[i];
  throw UsageError("The session has no organ \"" + reference.organ + "\"", reference.session.string(),
                   "it has " + listed(names));
}

} // namespace

std::optional<SessionReference> sessionReference(const std::string& text) {
  // A folder may be called like a session: the name of the file that is there ends the path.
  for (std::size_t slash = text.find('/'); slash != std::string::npos; slash = text.find('/', slash + 1)) {
    const std::filesystem::path file = text.substr(0, slash);
    std::error_code ignored;
    if (slash + 1 < text.size() && document::isSessionFile(file) &&
        std::filesystem::is_regular_file(file, ignored))
      return SessionReference{file, text.substr(slash + 1)};
  }
  return std::nullopt;
}

SampleReference sampleReference(const std::string& text) {
  std::string rest = isSample(text) ? text.substr(kSamplePrefix.size()) : text;
  SampleReference reference;
  if (const std::size_t at = rest.rfind('@'); at != std::string::npos) {
    reference.resolution = sample_organs::resolutionFromName(rest.substr(at + 1));
    rest.resize(at);
  }
  if (const std::size_t slash = rest.find('/'); slash != std::string::npos) {
    reference.surface = rest.substr(slash + 1);
    rest.resize(slash);
  }
  if (rest.empty())
    throw UsageError("It names no sample organ", text, "viscera sample --list shows them");
  reference.organ = rest;
  return reference;
}

bool isSample(const std::string& organ) {
  return organ.starts_with(kSamplePrefix);
}

bool namesLabel(const std::string& organ) {
  const auto reference = labelReference(organ);
  return reference && !reference->labels.empty();
}

std::optional<medical_io::SurfacePart> surfacePartInput(const std::string& organ) {
  const auto reference = surfaceReference(organ);
  if (!reference)
    return std::nullopt;
  return medical_io::readSurfacePart(reference->file, reference->part);
}

std::vector<document::Organ> organInputs(medical_io::LabelMap map, const std::string& organ,
                                         Progress& progress) {
  std::vector<document::Organ> result;
  for (document::NewOrgan& item : document::labelBatch(std::move(map), organ, {}, progress)) {
    for (Text& warning : item.organ.warnings)
      warning = phrase("%1: %2", organ + ": " + item.organ.name, warning);
    requireSize(item.organ, organ);
    result.push_back(std::move(item.organ));
  }
  return result;
}

std::vector<document::Organ> organInputs(const std::string& organ,
                                         const sample_organs::SampleLibrary& samples, Progress& progress) {
  std::vector<document::Organ> result;
  if (const auto labels = labelReference(organ)) {
    result = document::readLabelOrgans(labels->file, labels->labels, progress);
    for (document::Organ& one : result)
      for (Text& warning : one.warnings)
        warning = phrase("%1: %2", phrase("%1: %2", organ, one.name), warning);
  } else if (const auto session = isSample(organ) ? std::nullopt : sessionReference(organ)) {
    result.push_back(organOf(*session, document::readSession(session->session, samples, progress)));
  } else if (!isSample(organ)) {
    result = surfaceOrgans(organ);
  } else {
    const SampleReference reference = sampleReference(organ);
    const sample_organs::SampleOrgan sample =
        sample_organs::sampleOrgan(samples, reference.organ, reference.resolution, progress);
    std::vector<std::string> names;
    for (const sample_organs::SampleSurface& surface : sample.surfaces) {
      names.push_back(surface.name);
      if (reference.surface.empty() || reference.surface == surface.name)
        result.push_back(organOf(sample, surface));
      if (reference.surface == surface.name) // Whoever names what is hidden at first wants to see it.
        result.back().look.visible = true;
    }
    if (result.empty())
      if (auto further = furtherSurface(reference, samples, progress))
        result.push_back(std::move(*further));
    if (result.empty())
      throw UsageError("It has no surface \"" + reference.surface + "\"", organ, "it has " + listed(names));
  }
  for (const document::Organ& one : result)
    requireSize(one, organ);
  return result;
}

document::Organ organInput(const std::string& organ, const sample_organs::SampleLibrary& samples,
                           Progress& progress) {
  std::vector<document::Organ> organs = organInputs(organ, samples, progress);
  if (organs.size() > 1 && !isSample(organ)) {
    std::vector<std::string> names;
    for (const document::Organ& one : organs)
      names.push_back(one.name);
    throw UsageError(
        labelReference(organ) ? "It is a label map of several organs" : "It holds several organs", organ,
        "name one of them behind a slash, " + organ + "/" + names.front() + "; there are " + listed(names));
  }
  return std::move(organs.front());
}

OrgansAround organsAround(const std::string& organ, const sample_organs::SampleLibrary& samples,
                          Progress& progress) {
  if (isSample(organ))
    return {};
  if (const auto session = sessionReference(organ)) {
    const document::OpenedSession opened = document::readSession(session->session, samples, progress);
    return {*opened.contents.state.organs, organOf(*session, opened).name};
  }
  const auto labels = labelReference(organ);
  const auto surface = surfaceReference(organ);
  const document::OpenedFiles opened = document::openFiles({labels    ? labels->file
                                                            : surface ? surface->file
                                                                      : std::filesystem::path(organ)},
                                                           progress);
  document::Document holder;
  document::UndoStack undo(holder);
  if (!opened.organs.empty())
    undo.perform(opened.command());
  if (surface)
    return {*holder.state().organs, document::readOrgans(surface->file, surface->part).front().organ.name};
  return {*holder.state().organs, labels && !labels->labels.empty() ? labels->labels.front() : ""};
}

document::Rig rigInput(const std::filesystem::path& file, std::vector<Text>& warnings,
                       const std::filesystem::path& cage) {
  const medical_io::HandleFile contents = medical_io::readHandles(file);
  for (const Text& warning : contents.warnings)
    warnings.push_back(phrase("%1: %2", file.string(), warning));
  document::Rig rig = document::rigFrom(contents, file.string());
  if (!cage.empty()) {
    Progress ignored;
    rig.cage = document::edit::cageOf(
        rig, coordinates::cageOver(rig.restPositions(), *document::readCage(cage, ignored).mesh));
  }
  return rig;
}

document::Rig drawnHandles(const std::filesystem::path& file, std::vector<Text>& warnings) {
  const medical_io::HandleFile contents = medical_io::readHandles(file);
  for (const Text& warning : contents.warnings)
    warnings.push_back(phrase("%1: %2", file.string(), warning));
  document::Rig rig;
  for (const medical_io::HandleGroupRecord& group : contents.groups) {
    std::vector<int> rows;
    for (const medical_io::HandleRecord& record : group.handles) {
      const auto known =
          std::find_if(rig.handles.begin(), rig.handles.end(),
                       [&record](const document::Handle& handle) { return handle.rest == record.position; });
      rows.push_back(static_cast<int>(known - rig.handles.begin()));
      if (known == rig.handles.end()) { // Else it is in another group, too.
        document::Handle& handle = rig.handles.emplace_back();
        handle.id.value = rows.back() + 1;
        handle.label = record.label;
        handle.rest = record.position;
      }
    }
    rig.addGroup(group.name, group.color, rows);
  }
  return rig;
}

int rowOfHandle(const document::Rig& rig, const std::string& label) {
  const int row = rig.indexOf(label);
  if (row < 0)
    throw UsageError("there is no handle \"" + label + "\"", {}, "there are " + listed(labelsOf(rig)));
  return row;
}

Points poseInput(const std::filesystem::path& file, const document::Rig& rest, std::vector<Text>& warnings) {
  const medical_io::HandleFile contents = medical_io::readHandles(file);
  for (const Text& warning : contents.warnings)
    warnings.push_back(phrase("%1: %2", file.string(), warning));
  std::map<std::string, int> rows;
  for (std::size_t i = 0; i < rest.handles.size(); ++i)
    rows.emplace(rest.handles[i].label, static_cast<int>(i));
  Points pose = rest.restPositions();
  std::map<std::string, Vec3> seen;
  for (const medical_io::HandleGroupRecord& group : contents.groups) {
    for (const medical_io::HandleRecord& handle : group.handles) {
      const auto row = rows.find(handle.label);
      if (row == rows.end())
        throw DataError("handle \"" + handle.label + "\" is not among the rest handles", file.string(),
                        "the pose has to use the labels of the rest handles: " + listed(labelsOf(rest)));
      const auto [earlier, isNew] = seen.emplace(handle.label, handle.position);
      if (!isNew && earlier->second != handle.position)
        throw DataError("handle \"" + handle.label + "\" comes twice, at different places", file.string(),
                        "remove one of them");
      pose.row(row->second) = handle.position.transpose();
    }
  }
  return pose;
}

} // namespace viscera::app::cli
