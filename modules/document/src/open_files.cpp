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
#include "viscera/document/scan_item.h"
#include "viscera/document/session_file.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/heart_labels.h"
#include "viscera/medical_io/organ_names.h"
#include "viscera/medical_io/scan.h"

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

/// The files without those voxel files (.img) whose header (.hdr), and those points (.pts) whose elements
/// (.elem) are in the list too, because reading the one half reads both.
std::vector<std::filesystem::path> withoutHalves(const std::vector<std::filesystem::path>& files) {
  constexpr std::array<std::pair<const char*, const char*>, 2> kHalves = {
      {{".hdr", ".img"}, {".elem", ".pts"}}};
  std::vector<std::filesystem::path> rest = files;
  for (const auto& [named, other] : kHalves) {
    std::set<std::pair<std::filesystem::path, std::string>> first;
    for (const auto& file : files)
      first.emplace(file.parent_path(), withoutEnding(file, named));
    std::erase_if(rest, [&, ending = other](const std::filesystem::path& file) {
      const std::string half = withoutEnding(file, ending);
      return !half.empty() && first.contains({file.parent_path(), half});
    });
  }
  return rest;
}

/// What a file or folder is; throws for what is not opened as an organ or as handles.
medical_io::FileKind kindToOpen(const std::filesystem::path& file, Sessions sessions) {
  using medical_io::FileKind;
  std::error_code error;
  const bool folder = std::filesystem::is_directory(file, error);
  const FileKind kind = folder                ? FileKind::labelMap
                        : isSessionFile(file) ? FileKind::session
                                              : medical_io::fileKind(file);
  if (kind == FileKind::session && sessions == Sessions::nowhere)
    throw UsageError("A session cannot be opened beside another", file.string(), "open it with File > Open");
  if (kind == FileKind::session)
    throw UsageError("A session is opened alone", file.string(),
                     "open it by itself, and the other files after it");
  if (kind == FileKind::scan || (folder && !medical_io::isLabelMap(file) && medical_io::isScan(file)))
    throw UsageError(
        "It is a scan, not an organ", file.string(),
        "open it beside the organs (File > Open a scan), or make a label map of it first, with 3D "
        "Slicer or TotalSegmentator");
  if (kind == FileKind::unknown || kind == FileKind::sequence)
    medical_io::refuse(file);
  return kind;
}

void addWarnings(std::vector<Text>& all, const std::filesystem::path& file,
                 const std::vector<Text>& warnings) {
  for (const Text& warning : warnings)
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

/// Makes the organ without a parent, and keeps the surface as the file has it. `alone`: the file has no
/// other.
std::pair<NewOrgan, ReadSurface> readBoth(medical_io::SurfaceFile surface, const std::filesystem::path& file,
                                          bool alone) {
  ReadSurface read{std::make_shared<const geometry::TriangleMesh>(std::move(surface.mesh)),
                   surface.spaceStated ? std::optional(surface.space) : std::nullopt};
  const bool asFile = surface.name.empty() || (alone && medical_io::saysNothing(surface.name));
  const std::string name = asFile ? file.stem().string() : surface.name;
  Organ organ = makeOrgan(name, read.mesh, surface.report);
  organ.file = file;
  if (alone) // A session cannot name one organ of a file, so it holds the surfaces of several.
    organ.origin.fileHash = sha256OfFile(file);
  // Both looked at the surface and say the same of it; only the file knows of units and axes.
  for (Text& warning : organ.warnings)
    if (std::find(surface.warnings.begin(), surface.warnings.end(), warning) == surface.warnings.end())
      surface.warnings.push_back(std::move(warning));
  organ.warnings = std::move(surface.warnings);
  return {NewOrgan{std::move(organ), -1, surface.report}, std::move(read)};
}

/// Organs of the parts of a file, with their looks and, as places in the list, the parents of cavities.
std::vector<std::pair<NewOrgan, ReadSurface>> bothOf(std::vector<medical_io::SurfacePart> parts,
                                                     const std::filesystem::path& file) {
  std::vector<std::pair<NewOrgan, ReadSurface>> made;
  for (medical_io::SurfacePart& part : parts) {
    made.push_back(readBoth(std::move(part.surface), file, parts.size() == 1));
    NewOrgan& item = made.back().first;
    if (part.color && item.organ.look.vertexColors) // A single paint is the colour already.
      item.organ.look.color = *part.color;
    item.organ.look.opacity = part.opacity;
    item.parentInBatch = part.cavityOf;
  }
  return made;
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

/// Chambers are called as those of the sample heart.
void nameChambers(medical_io::LabelMap& map, const medical_io::HeartLabels& heart) {
  for (const medical_io::HeartLabels::Cavity& cavity : heart.cavities)
    map.segments[cavity.segment].name = cavity.chamber;
}

} // namespace

bool isHandleFile(const std::filesystem::path& file) {
  const std::string name = lowerName(file);
  return endsWith(name, ".mrk.json") || endsWith(name, ".fcsv");
}

Organ readOrgan(const std::filesystem::path& file, medical_io::SeveralOrgans several) {
  return readBoth(medical_io::readSurface(file, several), file, true).first.organ;
}

std::vector<NewOrgan> readOrgans(const std::filesystem::path& file, const std::string& part) {
  std::vector<medical_io::SurfacePart> parts = medical_io::readSurfaces(file);
  const std::size_t chosen = part.empty() ? 0 : medical_io::partNamed(parts, part, file.string());
  std::vector<NewOrgan> organs;
  for (auto& [item, read] : bothOf(std::move(parts), file))
    organs.push_back(std::move(item));
  if (part.empty())
    return organs;
  organs[chosen].parentInBatch = -1;
  return {std::move(organs[chosen])};
}

std::vector<Organ> organsFrom(const medical_io::LabelMap& map, std::vector<medical_io::LabelSurface> surfaces,
                              const std::filesystem::path& file) {
  std::vector<Organ> organs;
  for (medical_io::LabelSurface& surface : surfaces) {
    const medical_io::Segment& segment = map.segments[surface.segment];
    auto mesh = std::make_shared<const geometry::TriangleMesh>(std::move(surface.mesh));
    Organ organ = makeOrgan(segment.name, std::move(mesh), surface.report);
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
  return labelBatch(medical_io::readLabelMap(file, progress), file, labels, progress, arrives);
}

std::vector<NewOrgan> labelBatch(medical_io::LabelMap map, const std::filesystem::path& file,
                                 const std::vector<std::string>& labels, Progress& progress,
                                 const ArrivingOrganListener& arrives) {
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
  std::vector<medical_io::LabelSurface> surfaces =
      medical_io::labelSurfaces(map, options, progress, {}, made);
  std::vector<geometry::SurfaceReport> reports;
  std::vector<std::optional<medical_io::ImageCut>> cuts;
  for (const medical_io::LabelSurface& surface : surfaces) {
    reports.push_back(surface.report);
    cuts.push_back(surface.cut);
  }
  std::vector<Organ> organs = organsFrom(map, std::move(surfaces), file);
  std::vector<NewOrgan> batch;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    // The label decides and not the name: a file may call another organ "LV".
    const bool cavity =
        joined && std::any_of(heart->cavities.begin(), heart->cavities.end(),
                              [&](const auto& one) { return one.segment == options.segments[i]; });
    batch.push_back({std::move(organs[i]), cavity ? 0 : -1, reports[i], std::move(cuts[i])});
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

void addSurfaces(OpenedFiles& opened, const std::filesystem::path& file,
                 const ArrivingOrganListener& arrives) {
  auto made = bothOf(medical_io::readSurfaces(file), file); // All of them, before any is added.
  const auto first = static_cast<int>(opened.organs.size());
  for (auto& [item, read] : made) {
    const Organ& organ = item.organ;
    if (arrives)
      arrives({organ.name, organ.look.color, organ.mesh, boundsOf(organ.mesh->points)});
    opened.surfaces.emplace(opened.organs.size(), std::move(read));
    if (item.parentInBatch >= 0)
      item.parentInBatch += first;
    for (const Text& warning : organ.warnings)
      opened.warnings.push_back(phrase("%1: %2",
                                       made.size() == 1
                                           ? Text(file.filename().string())
                                           : phrase("%1: %2", file.filename().string(), named(organ.name)),
                                       warning));
    opened.organs.push_back(std::move(item));
  }
}

void addLabels(OpenedFiles& opened, medical_io::LabelMap map, const std::filesystem::path& file,
               Progress& progress, const ArrivingOrganListener& arrives) {
  const auto before = static_cast<int>(opened.organs.size());
  for (NewOrgan& item : labelBatch(std::move(map), file, {}, progress, arrives)) {
    for (const Text& warning : item.organ.warnings)
      opened.warnings.push_back(
          phrase("%1: %2", phrase("%1: %2", file.filename().string(), named(item.organ.name)), warning));
    if (item.parentInBatch >= 0)
      item.parentInBatch += before;
    opened.organs.push_back(std::move(item));
  }
}

/// Adds what a file holds; nothing when it throws.
void addFile(OpenedFiles& opened, const std::filesystem::path& file, Progress& progress,
             const ArrivingOrganListener& arrives, Sessions sessions, const ScanItem* scan) {
  const medical_io::FileKind kind = kindToOpen(file, sessions);
  if (kind == medical_io::FileKind::handles) {
    if (opened.rig)
      throw UsageError("Two handle files cannot be opened at a time", file.string(), "choose one of them");
    const medical_io::HandleFile handles = medical_io::readHandles(file);
    opened.rig = rigFrom(handles, file.string());
    addWarnings(opened.warnings, file, handles.warnings);
  } else if (kind == medical_io::FileKind::labelMap) {
    const std::optional<int> phase = phaseOfLabels(file, scan, progress);
    addLabels(opened, medical_io::readLabelMap(file, progress, phase), file, progress, arrives);
  } else {
    addSurfaces(opened, file, arrives);
  }
}

/// Whether a scan is looked for among the files.
enum class Scans { leave, take };

/// Opens file after file. A file that cannot be read is listed and left out.
class Opening {
public:
  Opening(const ArrivingOrganListener& arrives, Sessions sessions, Scans scans,
          std::shared_ptr<const ScanItem> present = nullptr)
      : arrives_(arrives), sessions_(sessions), scans_(scans), present_(std::move(present)) {}

  OpenedFiles run(const std::vector<std::filesystem::path>& named, Progress& progress) {
    if (named.empty())
      throw UsageError("There is no file to open");
    const std::vector<std::filesystem::path> files = withoutHalves(named);
    std::vector<std::filesystem::path> others; // Than the scan.
    for (std::size_t i = 0; i < files.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(files.size()),
                      files[i].filename().string());
      progress.throwIfCancelled();
      if (!tookImage(files[i], progress)) {
        others.push_back(files[i]);
        const ScanItem* scan = opened_.scan ? opened_.scan.get() : present_.get();
        attempt(files[i], failed_, [&] { addFile(opened_, files[i], progress, arrives_, sessions_, scan); });
      } else if (labels_) {
        others.push_back(files[i]);
        attempt(files[i], failed_, [&] {
          addLabels(opened_, *std::exchange(labels_, std::nullopt), files[i], progress, arrives_);
        });
      }
    }
    finish(others);
    progress.report(1);
    return std::move(opened_);
  }

private:
  struct Failed {
    std::vector<Error> errors;
    std::vector<std::filesystem::path> files;
    std::exception_ptr first;
  };

  template <class Work>
  static void attempt(const std::filesystem::path& file, Failed& failed, const Work& work) {
    try {
      explainingShortMemory(file.string(), work);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      failed.errors.push_back(error);
      failed.files.push_back(file);
      if (!failed.first)
        failed.first = std::current_exception();
    }
  }

  /// Whether the file was a scan, or a label map, which then is `labels_`, or a scan that is damaged.
  bool tookImage(const std::filesystem::path& file, Progress& progress) {
    if (scans_ == Scans::leave || opened_.scan)
      return false;
    const std::size_t before = failedScans_.files.size();
    std::optional<ScanItemOrLabels> image;
    attempt(file, failedScans_, [&] { image = openImage(file, progress); });
    if (!image)
      return failedScans_.files.size() > before;
    if (auto* scan = std::get_if<ScanItem>(&*image))
      opened_.scan = std::make_shared<const ScanItem>(std::move(*scan));
    else
      labels_ = std::get<medical_io::LabelMap>(std::move(*image));
    return true;
  }

  /// Damaged scans are told first. Without a scan, nothing left is an error.
  void finish(const std::vector<std::filesystem::path>& others) {
    if (opened_.organs.empty() && !opened_.rig && !opened_.scan)
      if (const auto first = failed_.first ? failed_.first : failedScans_.first)
        std::rethrow_exception(first);
    for (const Failed* failed : {&failedScans_, &failed_}) {
      opened_.failures.insert(opened_.failures.end(), failed->errors.begin(), failed->errors.end());
      opened_.leftOut.insert(opened_.leftOut.end(), failed->files.begin(), failed->files.end());
    }
    opened_.name = others.size() == 1 ? phrase("Open %1", others.front().filename().string())
                                      : phrase("Open %n {file|files}", others.size());
  }

  const ArrivingOrganListener& arrives_;
  Sessions sessions_;
  Scans scans_;
  std::shared_ptr<const ScanItem> present_;
  OpenedFiles opened_;
  std::optional<medical_io::LabelMap> labels_;
  Failed failedScans_, failed_;
};

} // namespace

OpenedFiles openFiles(const std::vector<std::filesystem::path>& files, Progress& progress,
                      const ArrivingOrganListener& arrives, Sessions sessions) {
  return Opening(arrives, sessions, Scans::leave).run(files, progress);
}

OpenedFiles openPatient(const std::vector<std::filesystem::path>& files, Progress& progress,
                        const ArrivingOrganListener& arrives, Sessions sessions,
                        std::shared_ptr<const ScanItem> present) {
  return Opening(arrives, sessions, Scans::take, std::move(present)).run(files, progress);
}

Command OpenedFiles::command() const {
  std::vector<Command> commands;
  if (!organs.empty())
    commands.push_back(addOrgans(organs));
  if (rig)
    commands.push_back(replaceRig(*rig));
  return combined(name, std::move(commands));
}

Command openCommand(Text name, OpenedFiles files, bool replacing, PlaceHandles place) {
  return {std::move(name), [files = std::move(files), replacing,
                            place = std::move(place)](DocumentState state, IdSource& ids) {
            const bool organs = !files.organs.empty();
            if (replacing && organs)
              state = removeAllOrgans().apply(state, ids);
            if (replacing && organs && !files.rig)
              state = replaceRig({}).apply(state, ids);
            const std::size_t firstNew = state.organs->size();
            state = files.command().apply(state, ids);
            if (organs && state.rig->handles.empty())
              state = place(*(*state.organs)[firstNew], *state.organs).apply(state, ids);
            return state;
          }};
}

Rig rigFrom(const medical_io::HandleFile& file, const std::string& where) {
  Rig rig;
  std::map<std::tuple<double, double, double>, int> known;
  for (const medical_io::HandleGroupRecord& list : file.groups) {
    std::vector<int> rows;
    for (const medical_io::HandleRecord& record : list.handles) {
      const Vec3& p = record.position;
      const auto [found, isNew] =
          known.emplace(std::tuple(p.x(), p.y(), p.z()), static_cast<int>(rig.handles.size()));
      if (isNew)
        rig.handles.push_back({HandleId{found->second + 1}, record.label, p, record.locked, record.visible,
                               record.description});
      if (std::find(rows.begin(), rows.end(), found->second) != rows.end())
        throw DataError("two handles are at one place",
                        phrase("%1, handles %2 and %3", where,
                               rig.handles[static_cast<std::size_t>(found->second)].label, record.label),
                        "remove one of them from the file");
      rows.push_back(found->second);
    }
    rig.addGroup(list.name, list.color, rows);
  }
  if (rig.handles.size() < kFewestHandles)
    throw DataError(phrase("coordinates need at least four handles, there are %1", rig.handles.size()), where,
                    "add handles, or place them automatically");
  try {
    geometry::ConvexHull hull(rig.restPositions());
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

Organ organFrom(const sample_organs::SampleSurface& surface, std::string name) {
  Organ organ = makeOrgan(std::move(name), surface.mesh);
  organ.look.color = surface.color;
  organ.look.vertexColors =
      true; // A cavity has one paint, which is its blood's, while `color` is the tissue's.
  organ.places = surface.places;
  organ.ways = surface.ways;
  organ.look.visible = !surface.hidden;
  return organ;
}

std::vector<NewOrgan> organsFrom(const sample_organs::SampleOrgan& sample) {
  std::vector<NewOrgan> list;
  for (const sample_organs::SampleSurface& surface : sample.surfaces) {
    const bool outer = list.empty();
    const bool own = outer || !surface.organ.empty();
    const std::string name =
        !surface.organ.empty() ? surface.organ : displayName(outer ? sample.name : surface.name);
    NewOrgan item{organFrom(surface, name), own ? -1 : 0};
    item.organ.origin.sample = sample.name + "@" + sample_organs::nameOf(sample.resolution);
    item.organ.origin.surface = surface.name;
    list.push_back(std::move(item));
  }
  return list;
}

} // namespace viscera::document
