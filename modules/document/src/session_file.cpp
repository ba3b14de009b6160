#include "viscera/document/session_file.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <utility>

#include "organ_source.h"
#include "session_json.h"
#include "session_scan.h"
#include "session_study.h"
#include "stored_surface.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/phrase.h"
#include "viscera/document/open_files.h"
#include "viscera/document/stored_text.h"
#include "viscera/document/validate.h"

namespace viscera::document {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using State = SurfaceFinding::State;

constexpr const char* kEmbedded = "embedded";
constexpr const char* kLinked = "linked";

std::string dumped(const ordered_json& item, int indent = -1) {
  // Names of files need not be UTF-8; JSON is.
  return item.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json fileJson(const FileSource& source) {
  ordered_json file;
  file["relative"] = source.relative.generic_string();
  file["absolute"] = source.absolute.generic_string();
  if (!source.hash.empty()) {
    file["bytes"] = source.bytes;
    file["sha256"] = source.hash;
  }
  return file;
}

/// Whether the session goes to others with everything inside, and so says nothing of this computer's folders.
/// A recovery file stays with its owner.
bool namesNoFolders(const SessionContents& contents, bool inside) {
  return inside && contents.recovers.empty();
}

/// The record of a file in an embedded session: its name, and the hash of its contents.
ordered_json nameOnly(const ordered_json& file, bool inside) {
  const std::string name = fs::path(file.at("absolute").get<std::string>()).filename().generic_string();
  ordered_json only{{"relative", name}, {"absolute", name}};
  if (!inside && file.contains("bytes")) // A missing one is found again by its contents.
    only["bytes"] = file.at("bytes");
  if (file.contains("sha256"))
    only["sha256"] = file.at("sha256");
  return only;
}

/// An organ with its surface, or with the place where that is.
ordered_json organWithSurface(const Organ& organ, bool embed, const fs::path& folder) {
  ordered_json item = organJson(organ);
  const bool sample = !organ.origin.sample.empty();
  std::optional<FileSource> unchanged;
  if (!embed && !sample)
    unchanged = unchangedFile(organ, folder);
  if (sample)
    item["source"] = {{"sample", organ.origin.sample}, {"surface", organ.origin.surface}};
  else if (!organ.file.empty())
    item["source"] = {{"file", fileJson(unchanged ? *unchanged : fileSource(organ, folder))}};
  item["sha256"] = surfaceHash(*organ.mesh);
  if (embed || !(sample || unchanged)) {
    item["surface"] = storedSurface(*organ.mesh);
    item["warnings"] = organ.warnings;
    item["remarks"] = storedTexts(organ.warnings);
  }
  return item;
}

/// The records of all organs, with those that are missing in their places.
class OrganRecords {
public:
  explicit OrganRecords(const SessionContents& contents) : contents_(contents) {
    const DocumentState& state = contents.state;
    for (const auto& organ : *state.organs)
      taken_.insert(organ->id.value);
    for (const Handle& handle : state.rig->handles)
      taken_.insert(handle.id.value);
    for (const Group& group : state.rig->groups)
      taken_.insert(group.id.value);
    for (const SequenceKey& key : state.keySequence->keys) {
      taken_.insert(key.id.value);
      for (const auto& [handle, moved] : key.displacements)
        taken_.insert(handle.value);
    }
    for (const Measurement& measurement : *state.measurements)
      taken_.insert(measurement.id.value);
    for (const StressProbe& probe : state.stressMarks->probes)
      taken_.insert(probe.id.value);
    for (const StressLine& line : state.stressMarks->lines)
      taken_.insert(line.id.value);
  }

  ordered_json write(const fs::path& folder, Progress& progress) {
    ordered_json list = ordered_json::array();
    const OrganList& organs = *contents_.state.organs;
    for (std::size_t i = 0; i < organs.size(); ++i) {
      progress.throwIfCancelled();
      progress.report(static_cast<double>(i) / static_cast<double>(organs.size()), named(organs[i]->name));
      list.push_back(organWithSurface(*organs[i], contents_.embedSurfaces, folder));
    }
    for (const MissingOrgan& missing : contents_.missing)
      insert(missing, list);
    if (namesNoFolders(contents_, contents_.embedSurfaces))
      for (ordered_json& record : list)
        if (record.contains("source") && record.at("source").contains("file"))
          record["source"]["file"] = nameOnly(record.at("source").at("file"), record.contains("surface"));
    return list;
  }

private:
  void insert(const MissingOrgan& missing, ordered_json& list) {
    ordered_json record = missing.record;
    // A new organ, handle or group may have been given the number since.
    const bool isFree = taken_.count(missing.id.value) == 0;
    const std::int64_t id = isFree ? missing.id.value : *taken_.rbegin() + 1;
    taken_.insert(id);
    renumbered_[missing.id.value] = id;
    record["id"] = id;
    std::size_t place = std::min(missing.place, list.size());
    for (std::size_t i = 0; i < list.size(); ++i)
      if (isChild(missing, list[i])) {
        withParent(list[i], id);
        place = std::min(place, i); // A cavity comes behind the organ that it is in.
      }
    place = behindParent(record, list, place);
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), std::move(record));
  }

  /// The first place from `place` on that is behind the record's parent; a parent that is gone is forgotten.
  std::size_t behindParent(ordered_json& record, const ordered_json& list, std::size_t place) const {
    if (!record.contains("parent"))
      return place;
    const auto parent = record.at("parent").get<std::int64_t>();
    const auto renumbered = renumbered_.find(parent);
    record["parent"] = renumbered == renumbered_.end() ? parent : renumbered->second;
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].at("id") == record["parent"])
        return std::max(place, i + 1);
    record.erase("parent");
    return place;
  }

  static bool isChild(const MissingOrgan& missing, const ordered_json& record) {
    const OrganId id{record.at("id").get<std::int64_t>()};
    return std::find(missing.children.begin(), missing.children.end(), id) != missing.children.end();
  }

  /// The record with its parent behind its name, where `organJson` writes it.
  static void withParent(ordered_json& record, std::int64_t parent) {
    ordered_json with;
    for (const auto& [key, value] : record.items()) {
      with[key] = value;
      if (key == "name")
        with["parent"] = parent;
    }
    record = std::move(with);
  }

  const SessionContents& contents_;
  std::set<std::int64_t> taken_;
  std::map<std::int64_t, std::int64_t> renumbered_; ///< Missing organs.
};

/// Whether an organ is in the session, be it as the record of a missing one.
bool isKnown(const SessionContents& contents, OrganId id) {
  return contents.state.organ(id) ||
         std::any_of(contents.missing.begin(), contents.missing.end(),
                     [id](const MissingOrgan& missing) { return missing.id == id; });
}

/// Reads one session file with everything that it names.
class SessionOpener {
public:
  SessionOpener(const fs::path& file, const sample_organs::SampleLibrary& samples, Progress& progress,
                std::vector<fs::path> alsoIn)
      : reader_(file.string()), folder_(absolutePath(file).parent_path()), alsoIn_(std::move(alsoIn)),
        maker_(samples), progress_(progress) {}

  OpenedSession read(const std::string& text) {
    const ordered_json root = reader_.parse(text);
    reader_.takeObject(root,
                       {"format", "version", "coordinateSystem", "units", "surfaces", "recovers", "organs",
                        "rig", "system", "recording", "measurements", "stressMarks", "circulation", "scan",
                        "study", "view"},
                       "");
    SessionContents& contents = opened_.contents;
    const std::string surfaces = reader_.textOf(root, "surfaces", "");
    if (surfaces != kEmbedded && surfaces != kLinked)
      reader_.fail(diagnostic("It is neither \"embedded\" nor \"linked\""), "surfaces");
    contents.embedSurfaces = surfaces == kEmbedded;
    contents.embedScan = contents.embedSurfaces;
    contents.recovers = reader_.optionalText(root, "recovers", "");
    // Reads the quick parts first, so that a damaged file is refused before a sample organ is made.
    reader_.readRig(reader_.field(root, "rig", ""), contents.state);
    reader_.readSystem(reader_.field(root, "system", ""), contents.state);
    reader_.readKeySequence(reader_.field(root, "recording", ""), contents.state);
    reader_.readMeasurements(root, contents.state);
    reader_.readStressMarks(root, contents.state);
    reader_.readCirculation(root, contents.state);
    const DocumentState cheap = contents.state;
    reader_.requireValid(cheap, {});
    const ordered_json& view = reader_.field(root, "view", "");
    reader_.requireObject(view, "view");
    contents.view = view;
    readOrgans(reader_.listOf(root, "organs", ""));
    placeMeasurements();
    if (root.contains("scan"))
      readSessionScan(reader_, root.at("scan"), folder_, alsoIn_, opened_, progress_);
    if (root.contains("study"))
      readSessionStudy(reader_, root.at("study"), folder_, alsoIn_, opened_, progress_);
    reader_.requireValid(contents.state, cheap);
    for (const std::string& key : reader_.unknownKeys())
      opened_.warnings.push_back(
          phrase("%1: nothing is known about \"%2\"; it will not be saved again", reader_.where(), key));
    progress_.report(1);
    return std::move(opened_);
  }

private:
  void readOrgans(const ordered_json& list) {
    std::vector<Organ> records;
    std::set<OrganId> earlier;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string place = SessionReader::at("organs", i);
      records.push_back(reader_.readOrganRecord(list[i], place));
      if (records[i].parent && !earlier.count(records[i].parent))
        reader_.fail(diagnostic("its parent is not an organ before it"), place + ".parent");
      earlier.insert(records[i].id);
    }
    requireMeasuredOrgans(earlier);
    requireProbedOrgans(earlier);
    OrganList organs;
    for (std::size_t i = 0; i < list.size(); ++i) {
      progress_.throwIfCancelled();
      progress_.report(static_cast<double>(i) / static_cast<double>(list.size()), records[i].name);
      if (auto organ = complete(records[i], list[i], i)) {
        if (opened_.surfaces.back().state == State::changed)
          changed_.insert(organ->id);
        organs.push_back(std::make_shared<const Organ>(std::move(*organ)));
      }
    }
    opened_.contents.state.organs = std::make_shared<const OrganList>(std::move(organs));
  }

  /// Calls `visit` with every measured point and its place in the file; takes over what it changes.
  template <class Visit>
  void eachMeasuredPoint(Visit visit) {
    MeasurementList measurements = *opened_.contents.state.measurements;
    for (std::size_t i = 0; i < measurements.size(); ++i)
      for (std::size_t k = 0; k < measurements[i].points.size(); ++k)
        visit(measurements[i].points[k],
              SessionReader::at(SessionReader::at("measurements", i) + ".points", k));
    opened_.contents.state.measurements = std::make_shared<const MeasurementList>(std::move(measurements));
  }

  void requireMeasuredOrgans(const std::set<OrganId>& organs) {
    eachMeasuredPoint([&](const MeasuredPoint& point, const std::string& place) {
      if (point.organ && !organs.count(point.organ))
        reader_.fail(diagnostic("there is no organ %1", point.organ.value), place + ".organ");
    });
  }

  void requireProbedOrgans(const std::set<OrganId>& organs) {
    const std::vector<StressProbe>& probes = opened_.contents.state.stressMarks->probes;
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (!organs.count(probes[i].organ))
        reader_.fail(diagnostic("there is no organ %1", probes[i].organ.value),
                     SessionReader::at("stressMarks.probes", i) + ".organ");
  }

  /// Points of a surface that is another one now go to the nearest places of it; those of a missing organ are
  /// kept for when it is there again.
  void placeMeasurements() {
    std::set<std::string> moved;
    eachMeasuredPoint([&](MeasuredPoint& point, const std::string&) {
      const auto organ = point.organ ? opened_.contents.state.organ(point.organ) : nullptr;
      if (!organ)
        return;
      if (changed_.count(organ->id)) {
        point = nearestPoint(*organ, point.rest);
        moved.insert(organ->name);
      }
    });
    for (const std::string& organ : moved)
      warn(organ,
           "its surface has changed: measured points were moved to the nearest places on the new surface");
  }

  /// The organ with its surface; nothing, and a warning, when there is none.
  std::optional<Organ> complete(const Organ& record, const ordered_json& item, std::size_t index) {
    const std::string place = SessionReader::at("organs", index);
    const std::string hash = reader_.textOf(item, "sha256", place);
    SurfaceFinding finding{record.name, {}, State::found};
    std::optional<Organ> organ;
    if (item.contains("surface"))
      organ = embedded(item, place, hash, finding);
    else
      organ = linked(item, place, hash, finding);
    if (organ)
      dress(*organ, record);
    else
      opened_.contents.missing.push_back({record.name, item, index, record.id, {}});
    opened_.surfaces.push_back(std::move(finding));
    return organ;
  }

  /// Gives a surface the record's name, look and place among the organs.
  void dress(Organ& organ, const Organ& record) {
    organ.id = record.id;
    organ.name = record.name;
    organ.look = record.look;
    organ.parent = record.parent;
    organ.mobility = record.mobility;
    organ.volumeLocked = record.volumeLocked && organ.closed();
    if (record.volumeLocked && !organ.closed())
      warn(record.name, "its volume is not locked any more: the surface is open now");
    for (MissingOrgan& missing : opened_.contents.missing)
      if (missing.id == organ.parent) {
        missing.children.push_back(organ.id);
        organ.parent = {};
      }
  }

  /// The remarks with their patterns and parts. A session of an older version has no `remarks`: they are
  /// English.
  std::vector<Text> warningsOf(const ordered_json& item, const std::string& place) {
    const auto english = reader_.valueOf<std::vector<std::string>>(item, "warnings", place);
    if (item.contains("remarks"))
      return textsFrom(reader_, item.at("remarks"), place + ".remarks");
    std::vector<Text> warnings;
    for (const std::string& warning : english)
      warnings.push_back(named(warning));
    return warnings;
  }

  Organ embedded(const ordered_json& item, const std::string& place, const std::string& hash,
                 SurfaceFinding& finding) {
    geometry::TriangleMesh mesh = surfaceFrom(reader_, item.at("surface"), place + ".surface");
    if (surfaceHash(mesh) != hash)
      reader_.fail(diagnostic("It is damaged: its SHA-256 is not %1", hash), place + ".surface");
    Organ organ;
    try {
      organ = makeOrgan(place, std::move(mesh));
    } catch (const DataError& error) {
      reader_.fail(error.problem(), place + ".surface");
    }
    organ.warnings = warningsOf(item, place);
    finding.state = State::embedded;
    if (item.contains("source")) {
      const Origin origin = originOf(item.at("source"), place + ".source");
      organ.origin.sample = origin.sample;
      organ.origin.surface = origin.surface;
      if (!origin.sample.empty()) {
        organ.places = maker_.placesOf(origin.sample, origin.surface);
        organ.ways = maker_.waysOf(origin.sample, origin.surface);
      }
      organ.origin.fileHash = origin.file.hash;
      organ.file = origin.file.absolute;
      if (!organ.file.empty() && organ.file.is_relative()) // A name alone: beside the session, if anywhere.
        organ.file = (folder_ / organ.file.filename()).lexically_normal();
    }
    return organ;
  }

  struct Origin {
    std::string sample, surface;
    FileSource file;
  };

  Origin originOf(const ordered_json& source, const std::string& place) {
    Origin origin;
    if (source.contains("sample")) {
      reader_.takeObject(source, {"sample", "surface"}, place);
      origin.sample = reader_.textOf(source, "sample", place);
      origin.surface = reader_.textOf(source, "surface", place);
      return origin;
    }
    reader_.takeObject(source, {"file"}, place);
    const ordered_json& file = reader_.field(source, "file", place);
    const std::string inFile = place + ".file";
    reader_.takeObject(file, {"relative", "absolute", "bytes", "sha256"}, inFile);
    origin.file.relative = reader_.textOf(file, "relative", inFile);
    origin.file.absolute = reader_.textOf(file, "absolute", inFile);
    origin.file.hash = reader_.optionalText(file, "sha256", inFile);
    if (file.contains("bytes"))
      origin.file.bytes = reader_.wholeOf(file.at("bytes"), inFile + ".bytes");
    return origin;
  }

  std::optional<Organ> linked(const ordered_json& item, const std::string& place, const std::string& hash,
                              SurfaceFinding& finding) {
    const Origin origin = originOf(reader_.field(item, "source", place), place + ".source");
    std::optional<Organ> organ = origin.sample.empty() ? fromFile(origin.file, finding)
                                                       : fromSample(origin.sample, origin.surface, finding);
    if (organ && finding.state != State::changed && surfaceHash(*organ->mesh) != hash) {
      finding.state = State::changed;
      warn(finding.organ, phrase("%1 gives another surface than the one that was saved", finding.source));
    }
    return organ;
  }

  std::optional<Organ> fromSample(const std::string& sample, const std::string& surface,
                                  SurfaceFinding& finding) {
    finding.source = "sample:" + sample;
    finding.source.insert(std::min(finding.source.rfind('@'), finding.source.size()), "/" + surface);
    return orMissing(finding, [&] { return maker_.make(sample, surface, progress_); });
  }

  std::optional<Organ> fromFile(const FileSource& source, SurfaceFinding& finding) {
    finding.source = source.absolute.string();
    const auto found = findFile(source, folder_, alsoIn_);
    if (!found) {
      finding.state = State::missing;
      warn(finding.organ,
           phrase("its file %1 is not there any more (put it beside the session and open that again)",
                  finding.source));
      return std::nullopt;
    }
    finding.source = found->file.string();
    auto organ = orMissing(finding, [&] { return readOrgan(found->file, medical_io::SeveralOrgans::join); });
    const bool expected = found->file == (folder_ / source.relative).lexically_normal();
    if (organ && !found->same) {
      finding.state = State::changed;
      warn(finding.organ, phrase("%1 has changed since the session was saved", finding.source));
    } else if (organ && !expected) {
      finding.state = State::moved;
      warn(finding.organ, phrase("its file was found as %1", finding.source));
    }
    return organ;
  }

  template <class Make>
  std::optional<Organ> orMissing(SurfaceFinding& finding, Make make) {
    try {
      return explainingShortMemory({}, make);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      finding.state = State::missing;
      warn(finding.organ, phrase("cannot be opened: %1", error.explanation()));
      return std::nullopt;
    }
  }

  void warn(const std::string& organ, const Text& problem) {
    opened_.warnings.push_back(phrase("%1: %2", named(organ), problem));
  }

  SessionReader reader_;
  fs::path folder_;
  std::vector<fs::path> alsoIn_; ///< Folders in which organs' files and the scan may be.
  SampleMaker maker_;
  Progress& progress_;
  OpenedSession opened_;
  std::set<OrganId> changed_; ///< Organs whose surface is another one than was saved.
};

} // namespace

std::string nameOf(SurfaceFinding::State state) {
  constexpr const char* kStateNames[] = {"embedded", "found", "moved", "changed", "missing"};
  return kStateNames[static_cast<std::size_t>(state)];
}

bool isSessionFile(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return ending == kSessionEnding;
}

OpenedSession readSession(const fs::path& file, const sample_organs::SampleLibrary& samples,
                          Progress& progress, const std::vector<fs::path>& alsoIn) {
  return SessionOpener(file, samples, progress, alsoIn).read(readText(file));
}

void writeSession(const fs::path& file, const SessionContents& contents, Progress& progress) {
  if (!isSessionFile(file))
    throw CannotCreateError("the name of a session file ends in .viscera", file.string(),
                            phrase("name it %1", file.filename().string() + kSessionEnding));
  const fs::path folder = absolutePath(file).parent_path();
  const DocumentState& state = contents.state;
  validate(state);
  ordered_json root{{"format", kSessionFormat},
                    {"version", kSessionVersion},
                    {"coordinateSystem", "LPS"},
                    {"units", "mm"},
                    {"surfaces", contents.embedSurfaces ? kEmbedded : kLinked}};
  if (!contents.recovers.empty())
    root["recovers"] = contents.recovers.generic_string();
  root["organs"] = OrganRecords(contents).write(folder, progress);
  root["rig"] = rigJson(*state.rig, *state.pose);
  root["system"] = systemJson(*state.system);
  root["recording"] = keySequenceJson(*state.keySequence);
  if (!state.measurements->empty())
    root["measurements"] =
        measurementsJson(*state.measurements, [&](OrganId id) { return isKnown(contents, id); });
  if (!state.stressMarks->empty())
    root["stressMarks"] =
        stressMarksJson(*state.stressMarks, [&](OrganId id) { return isKnown(contents, id); });
  if (!(*state.circulation == CirculationChoice()))
    root["circulation"] = circulationJson(*state.circulation);
  if (state.scan)
    root["scan"] = sessionScanJson(*state.scan, contents.embedScan, folder);
  else if (!contents.missingScan.empty())
    root["scan"] = contents.missingScan;
  if (state.study)
    root["study"] = sessionStudyJson(*state.study, folder);
  else if (!contents.missingStudy.empty())
    root["study"] = contents.missingStudy;
  if (root.contains("study") && namesNoFolders(contents, contents.embedScan))
    forgetFolders(root["study"]);
  if (root.contains("scan") && namesNoFolders(contents, contents.embedScan))
    forgetFolders(root["scan"]);
  root["view"] = contents.view;
  progress.throwIfCancelled();
  writeAtomically(file, [&root](std::ostream& stream) { stream << dumped(root, 1) << '\n'; });
  progress.report(1);
}

} // namespace viscera::document
