#include "viscera/document/open_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "organ_source.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/session_file.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/medical_io/heart_labels.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

constexpr std::size_t kFewestHandles = 4; ///< Fewer have no inside.

std::string lowerName(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// The name without this ending, packed or not; empty when it ends otherwise.
std::string withoutEnding(const std::filesystem::path& file, const std::string& ending) {
  const std::string name = lowerName(file);
  for (const std::string& form : {ending, ending + ".gz"})
    if (endsWith(name, form))
      return name.substr(0, name.size() - form.size());
  return {};
}

/// The files without voxels (.img) whose header (.hdr) is there too: that brings them along.
std::vector<std::filesystem::path> withoutHalves(const std::vector<std::filesystem::path>& files) {
  std::set<std::pair<std::filesystem::path, std::string>> headers;
  for (const auto& file : files)
    headers.emplace(file.parent_path(), withoutEnding(file, ".hdr"));
  std::vector<std::filesystem::path> rest;
  for (const auto& file : files) {
    const std::string voxelsOf = withoutEnding(file, ".img");
    if (voxelsOf.empty() || !headers.contains({file.parent_path(), voxelsOf}))
      rest.push_back(file);
  }
  return rest;
}

void requireKnown(const std::filesystem::path& file, Sessions sessions) {
  const auto& extensions = medical_io::surfaceExtensions();
  const std::string name = lowerName(file);
  if (endsWith(name, kSessionEnding) && sessions == Sessions::nowhere)
    throw UsageError("A session cannot be opened beside another", file.string(), "open it with File > Open");
  if (endsWith(name, kSessionEnding))
    throw UsageError("A session is opened alone", file.string(),
                     "open it by itself, and the other files after it");
  if (isHandleFile(file) || medical_io::isLabelMap(file) ||
      std::any_of(extensions.begin(), extensions.end(),
                  [&](const std::string& e) { return endsWith(name, e); }))
    return;
  if (medical_io::isScan(file))
    throw UsageError(
        "It is a scan and no organ", file.string(),
        "open it beside the organs (File > Open a scan), or make a label map of it first, with 3D "
        "Slicer or TotalSegmentator");
  std::string known = sessions == Sessions::alone ? std::string(kSessionEnding) + ", " : std::string();
  known += ".mrk.json, .fcsv";
  for (const auto* list : {&extensions, &medical_io::labelMapExtensions()})
    for (const std::string& extension : *list)
      known += ", " + extension;
  throw UsageError("This kind of file is not supported", file.string(), phrase("use one of %1", known));
}

void addWarnings(std::vector<std::string>& all, const std::filesystem::path& file,
                 const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    all.push_back(phrase("%1: %2", file.filename().string(), warning));
}

/// "LV" for "lv", "Outer wall" for "outer wall": the definitions' names are written small.
std::string displayName(std::string name) {
  constexpr std::size_t kLongestAbbreviation = 3;
  const std::size_t upper = name.size() <= kLongestAbbreviation ? name.size() : 1;
  for (std::size_t i = 0; i < upper; ++i)
    name[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[i])));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Whether a program called a surface so because nobody did: "Mesh1", "default", "Object_1".
bool saysNothing(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  name.erase(name.find_last_not_of("0123456789 ._-#") + 1);
  static constexpr std::array kPlainNames = {"mesh",     "default", "object", "obj",     "model",    "group",
                                             "surface",  "solid",   "shape",  "unnamed", "untitled", "node",
                                             "geometry", "scene",   "root",   "noname",  "polydata"};
  return name.empty() || std::find(kPlainNames.begin(), kPlainNames.end(), name) != kPlainNames.end();
}

/// As an organ, and as it is in the file, which has no other surface when it is `alone`.
std::pair<Organ, ReadSurface> readBoth(medical_io::SurfaceFile surface, const std::filesystem::path& file,
                                       bool alone) {
  ReadSurface read{std::make_shared<const geometry::TriangleMesh>(std::move(surface.mesh)),
                   surface.spaceStated ? std::optional(surface.space) : std::nullopt};
  const bool asFile = surface.name.empty() || (alone && saysNothing(surface.name));
  const std::string name = asFile ? file.stem().string() : surface.name;
  Organ organ = makeOrgan(name, read.mesh);
  organ.file = file;
  organ.origin.fileHash = sha256OfFile(file);
  // Both looked at the surface and say the same of it; only the file knows of units and axes.
  for (std::string& warning : organ.warnings)
    if (std::find(surface.warnings.begin(), surface.warnings.end(), warning) == surface.warnings.end())
      surface.warnings.push_back(std::move(warning));
  organ.warnings = std::move(surface.warnings);
  return {std::move(organ), std::move(read)};
}

/// Around the voxels of these segments, mm LPS.
Bounds boxOf(const medical_io::LabelMap& map, const std::vector<std::size_t>& segments) {
  constexpr double kHalf = 0.5;
  Bounds box{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const std::size_t segment : segments)
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 index;
      for (int axis = 0; axis < 3; ++axis) {
        const bool high = ((corner >> axis) & 1) != 0;
        const auto at = static_cast<std::size_t>(axis);
        const medical_io::Segment& one = map.segments[segment];
        index[axis] = high ? one.high[at] + kHalf : one.low[at] - kHalf;
      }
      const Vec3 place = map.indexToLps * index;
      box = {box.low.cwiseMin(place), box.high.cwiseMax(place)};
    }
  return box;
}

/// Chambers are called and, unless the file colours them, coloured as those of the sample heart.
void nameChambers(medical_io::LabelMap& map, const medical_io::HeartLabels& heart) {
  const Vec3 arterial(0.84, 0.16, 0.14), venous(0.20, 0.36, 0.80);
  for (const medical_io::HeartLabels::Cavity& cavity : heart.cavities) {
    medical_io::Segment& segment = map.segments[cavity.segment];
    segment.name = cavity.chamber;
    if (!segment.colored)
      segment.color = cavity.chamber.front() == 'L' ? arterial : venous;
  }
}

} // namespace

bool isHandleFile(const std::filesystem::path& file) {
  const std::string name = lowerName(file);
  return endsWith(name, ".mrk.json") || endsWith(name, ".fcsv");
}

Organ readOrgan(const std::filesystem::path& file) {
  return readBoth(medical_io::readSurface(file), file, true).first;
}

std::vector<Organ> organsFrom(const medical_io::LabelMap& map, std::vector<medical_io::LabelSurface> surfaces,
                              const std::filesystem::path& file) {
  std::vector<Organ> organs;
  for (medical_io::LabelSurface& surface : surfaces) {
    const medical_io::Segment& segment = map.segments[surface.segment];
    Organ organ = makeOrgan(segment.name, std::move(surface.mesh));
    organ.look.color = segment.color;
    organ.file = file;
    organ.warnings.insert(organ.warnings.begin(), surface.warnings.begin(), surface.warnings.end());
    organs.push_back(std::move(organ));
  }
  if (!organs.empty())
    organs.front().warnings.insert(organs.front().warnings.begin(), map.warnings.begin(), map.warnings.end());
  return organs;
}

std::vector<NewOrgan> readLabelBatch(const std::filesystem::path& file,
                                     const std::vector<std::string>& labels, Progress& progress,
                                     const ArrivingOrganListener& arrives) {
  medical_io::LabelMap map = medical_io::readLabelMap(file, progress);
  const auto heart = medical_io::heartLabels(map);
  const auto whole = heart ? medical_io::addWholeHeart(map, *heart) : std::nullopt;
  const bool joined = whole && labels.empty();
  medical_io::LabelSurfaceOptions options;
  options.segments = medical_io::segmentsNamed(map, labels, file.string());
  if (joined) { // Its muscle is what the cavities leave of it.
    std::erase_if(options.segments, [&](std::size_t segment) {
      return segment == *whole || std::count(heart->muscle.begin(), heart->muscle.end(), segment) > 0;
    });
    options.segments.insert(options.segments.begin(), *whole);
    nameChambers(map, *heart);
  }
  medical_io::SurfaceListener made;
  if (arrives)
    made = [&arrives, &map, all = boxOf(map, options.segments)](const medical_io::LabelSurface& surface) {
      const medical_io::Segment& segment = map.segments[surface.segment];
      arrives(
          {segment.name, segment.color, std::make_shared<const geometry::TriangleMesh>(surface.mesh), all});
    };
  std::vector<NewOrgan> batch;
  for (Organ& organ : organsFrom(map, medical_io::labelSurfaces(map, options, progress, {}, made), file)) {
    const bool cavity = joined && std::any_of(heart->cavities.begin(), heart->cavities.end(),
                                              [&](const auto& one) { return one.chamber == organ.name; });
    batch.push_back({std::move(organ), cavity ? 0 : -1});
  }
  return batch;
}

std::vector<Organ> readLabelOrgans(const std::filesystem::path& file, const std::vector<std::string>& labels,
                                   Progress& progress, const ArrivingOrganListener& arrives) {
  std::vector<Organ> organs;
  for (NewOrgan& item : readLabelBatch(file, labels, progress, arrives))
    organs.push_back(std::move(item.organ));
  return organs;
}

namespace {

/// The organs of a surface file: one, or those that a GLB holds with their colours and cavities.
void addSurfaces(OpenedFiles& opened, const std::filesystem::path& file,
                 const ArrivingOrganListener& arrives) {
  std::vector<medical_io::SurfacePart> parts = medical_io::readSurfaces(file);
  std::vector<std::pair<Organ, ReadSurface>> made; // All of them, before any is added.
  for (medical_io::SurfacePart& part : parts)
    made.push_back(readBoth(std::move(part.surface), file, parts.size() == 1));
  const auto first = static_cast<int>(opened.organs.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const medical_io::SurfacePart& part = parts[i];
    auto& [organ, read] = made[i];
    if (parts.size() > 1) // A session cannot name one organ of a file, so it holds the surfaces.
      organ.origin.fileHash.clear();
    if (part.color && organ.look.vertexColors) // A single paint is the colour already.
      organ.look.color = *part.color;
    organ.look.opacity = part.opacity;
    if (arrives)
      arrives({organ.name, part.color, organ.mesh, boundsOf(organ.mesh->points)});
    opened.surfaces.emplace(opened.organs.size(), std::move(read));
    opened.organs.push_back({std::move(organ), part.cavityOf < 0 ? -1 : first + part.cavityOf});
    addWarnings(opened.warnings, file, opened.organs.back().organ.warnings);
  }
}

/// Adds what a file holds; nothing when it throws.
void addFile(OpenedFiles& opened, const std::filesystem::path& file, Progress& progress,
             const ArrivingOrganListener& arrives, Sessions sessions) {
  requireKnown(file, sessions);
  if (isHandleFile(file)) {
    if (opened.rig)
      throw UsageError("Two handle files cannot be opened at a time", file.string(), "choose one of them");
    const medical_io::HandleFile handles = medical_io::readHandles(file);
    opened.rig = rigFrom(handles, file.string());
    addWarnings(opened.warnings, file, handles.warnings);
  } else if (medical_io::isLabelMap(file)) {
    const auto before = static_cast<int>(opened.organs.size());
    for (NewOrgan& item : readLabelBatch(file, {}, progress, arrives)) {
      for (const std::string& warning : item.organ.warnings)
        opened.warnings.push_back(
            phrase("%1: %2", phrase("%1: %2", file.filename().string(), item.organ.name), warning));
      if (item.parentInBatch >= 0)
        item.parentInBatch += before;
      opened.organs.push_back(std::move(item));
    }
  } else {
    addSurfaces(opened, file, arrives);
  }
}

/// `first` becomes what the first file that cannot be read has thrown.
OpenedFiles openEach(const std::vector<std::filesystem::path>& named, Progress& progress,
                     const ArrivingOrganListener& arrives, Sessions sessions, std::exception_ptr& first) {
  if (named.empty())
    throw UsageError("There is no file to open");
  const std::vector<std::filesystem::path> files = withoutHalves(named);
  OpenedFiles opened;
  for (std::size_t i = 0; i < files.size(); ++i) {
    progress.report(static_cast<double>(i) / static_cast<double>(files.size()), files[i].filename().string());
    progress.throwIfCancelled();
    try {
      addFile(opened, files[i], progress, arrives, sessions);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      opened.failures.push_back(error);
      opened.leftOut.push_back(files[i]);
      if (!first)
        first = std::current_exception();
    }
  }
  opened.name = files.size() == 1 ? phrase("Open %1", files.front().filename().string())
                                  : phrase("Open %n {file|files}", files.size());
  progress.report(1);
  return opened;
}

} // namespace

OpenedFiles openFiles(const std::vector<std::filesystem::path>& files, Progress& progress,
                      const ArrivingOrganListener& arrives, Sessions sessions) {
  std::exception_ptr first;
  OpenedFiles opened = openEach(files, progress, arrives, sessions, first);
  if (first && opened.organs.empty() && !opened.rig)
    std::rethrow_exception(first);
  return opened;
}

OpenedFiles openReadable(const std::vector<std::filesystem::path>& files, Progress& progress,
                         const ArrivingOrganListener& arrives, Sessions sessions) {
  std::exception_ptr first;
  return openEach(files, progress, arrives, sessions, first);
}

Command OpenedFiles::command() const {
  std::vector<Command> commands;
  if (!organs.empty())
    commands.push_back(addOrgans(organs));
  if (rig)
    commands.push_back(replaceRig(*rig));
  return combined(name, std::move(commands));
}

NewRig rigFrom(const medical_io::HandleFile& file, const std::string& where) {
  NewRig rig;
  std::map<std::tuple<double, double, double>, int> known;
  for (const medical_io::HandleGroupRecord& list : file.groups) {
    NewGroup group{list.name, list.color, {}};
    std::set<int> inList;
    for (const medical_io::HandleRecord& record : list.handles) {
      const Vec3& p = record.position;
      const auto [found, isNew] =
          known.emplace(std::tuple(p.x(), p.y(), p.z()), static_cast<int>(rig.handles.size()));
      if (isNew)
        rig.handles.push_back(
            {p, std::nullopt, record.label, record.description, record.locked, record.visible});
      if (!inList.insert(found->second).second)
        throw DataError("Two handles are at one place",
                        phrase("%1, handles %2 and %3", where,
                               rig.handles[static_cast<std::size_t>(found->second)].label, record.label),
                        "remove one of them from the file");
      group.handles.push_back(found->second);
    }
    rig.groups.push_back(std::move(group));
  }
  if (rig.handles.size() < kFewestHandles)
    throw DataError(phrase("coordinates need at least four handles, there are %1", rig.handles.size()), where,
                    "add handles, or place them automatically");
  Points positions(static_cast<Eigen::Index>(rig.handles.size()), 3);
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = rig.handles[i].rest.transpose();
  try {
    geometry::ConvexHull hull(positions);
  } catch (const DataError& error) {
    throw DataError(phrase("the handles enclose nothing: %1", error.problem()), where, error.tryThis());
  }
  return rig;
}

medical_io::HandleFile handleFile(const Rig& rig) {
  medical_io::HandleFile file;
  const auto record = [](const Handle& handle) {
    return medical_io::HandleRecord{handle.label, handle.rest, handle.description, handle.locked,
                                    handle.visible};
  };
  for (const Group& group : rig.groups) {
    medical_io::HandleGroupRecord list{group.name, group.color, {}};
    for (const HandleId id : group.handles)
      list.handles.push_back(record(rig.handles[static_cast<std::size_t>(rig.indexOf(id))]));
    file.groups.push_back(std::move(list));
  }
  medical_io::HandleGroupRecord others;
  others.name = "Handles";
  for (const Handle& handle : rig.handles)
    if (!rig.groupOf(handle.id))
      others.handles.push_back(record(handle));
  if (!others.handles.empty())
    file.groups.push_back(std::move(others));
  return file;
}

medical_io::HandleFile handleFile(const NewRig& rig) {
  IdSource ids;
  return handleFile(*replaceRig(rig).apply(DocumentState(), ids).rig);
}

std::vector<NewOrgan> organsFrom(const sample_organs::SampleOrgan& sample) {
  std::vector<NewOrgan> list;
  for (const sample_organs::SampleSurface& surface : sample.surfaces) {
    const bool outer = list.empty();
    const bool own = outer || !surface.organ.empty();
    const std::string name =
        !surface.organ.empty() ? surface.organ : displayName(outer ? sample.name : surface.name);
    NewOrgan item{makeOrgan(name, surface.mesh), own ? -1 : 0};
    item.organ.look.color = surface.color;
    item.organ.look.vertexColors = true;
    item.organ.origin.sample = sample.name + "@" + sample_organs::nameOf(sample.resolution);
    item.organ.origin.surface = surface.name;
    item.organ.places = surface.places;
    list.push_back(std::move(item));
  }
  return list;
}

} // namespace viscera::document
