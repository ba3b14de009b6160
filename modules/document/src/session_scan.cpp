#include "session_scan.h"

#include <optional>
#include <system_error>

#include "stored_scan.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/phrase.h"

namespace viscera::document {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The name of a file, or of a folder that may be written with a slash at its end.
fs::path lastNameOf(const fs::path& place) {
  return place.has_filename() ? place.filename() : place.parent_path().filename();
}

/// The hash of the phases of a scan over time; empty without.
std::string timeHashIn(SessionReader& reader, const ordered_json& item) {
  if (!item.contains("time"))
    return {};
  const ordered_json& time = item.at("time");
  reader.takeObject(time, {"phases", "hash"}, "scan.time");
  reader.wholeOf(reader.field(time, "phases", "scan.time"), "scan.time.phases");
  return reader.optionalText(time, "hash", "scan.time");
}

std::string wordsOf(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

} // namespace

std::optional<medical_io::ArchiveOrigin> archiveOriginOf(const ordered_json& record) {
  const auto found = record.is_object() ? record.find("archive") : record.end();
  if (!record.is_object() || found == record.end() || !found->is_object() ||
      wordsOf(*found, "name").empty() || wordsOf(*found, "study").empty())
    return std::nullopt;
  return medical_io::ArchiveOrigin{wordsOf(*found, "name"), wordsOf(*found, "study"),
                                   wordsOf(*found, "series")};
}

void addArchiveOrigin(ordered_json& record, const fs::path& place) {
  std::error_code ignored;
  const auto origin =
      medical_io::readArchiveOrigin(fs::is_directory(place, ignored) ? place : place.parent_path());
  if (!origin)
    return;
  record["archive"] = {{"name", origin->archive}, {"study", origin->studyUid}};
  if (!origin->seriesUid.empty())
    record["archive"]["series"] = origin->seriesUid;
}

Text lostImages(const ordered_json& record, const Text& otherwise) {
  const auto origin = archiveOriginOf(record);
  return origin ? phrase("the images are not there any more (the archive %1 has them)", origin->archive)
                : otherwise;
}

std::optional<fs::path> findImage(const fs::path& relative, const fs::path& absolute, const fs::path& folder,
                                  const std::vector<fs::path>& alsoIn) {
  const fs::path name = lastNameOf(absolute);
  std::vector<fs::path> places = {folder / relative, absolute, folder / name};
  for (const fs::path& also : alsoIn) {
    places.push_back(also / name);
    if (lastNameOf(also) == name)
      places.push_back(also);
  }
  std::error_code error;
  for (const fs::path& place : places)
    if (place.is_absolute() && fs::exists(place, error))
      return absolutePath(place).lexically_normal();
  return std::nullopt;
}

ordered_json sessionScanJson(const ScanItem& item, bool inside, const fs::path& folder) {
  std::error_code error;
  ordered_json json{{"name", item.name}};
  if (!item.file.empty()) {
    const fs::path absolute = absolutePath(item.file).lexically_normal();
    json["relative"] = absolute.lexically_relative(folder).generic_string();
    json["absolute"] = absolute.generic_string();
  }
  if (!item.file.empty())
    addArchiveOrigin(json, item.file);
  if (!item.series.empty())
    json["series"] = item.series;
  if (item.phase != 0)
    json["phase"] = item.phase;
  if (item.time)
    json["time"] = {{"phases", item.time->phasesInCycle()}, {"hash", item.time->hash}};
  if (inside || item.file.empty() || !fs::exists(item.file, error))
    json["image"] = storedScan(*item.scan);
  else if (!item.hash.empty())
    json["hash"] = item.hash;
  return json;
}

void forgetFolders(ordered_json& scan) {
  if (scan.contains("image"))
    scan.erase("archive"); // It is not needed, and its UIDs lead to the patient.
  if (!scan.contains("absolute"))
    return;
  const std::string name = lastNameOf(scan.at("absolute").get<std::string>()).generic_string();
  scan["relative"] = name;
  scan["absolute"] = name;
}

void readSessionScan(SessionReader& reader, const ordered_json& item, const fs::path& folder,
                     const std::vector<fs::path>& alsoIn, OpenedSession& opened, Progress& progress) {
  reader.takeObject(
      item, {"name", "relative", "absolute", "series", "phase", "time", "hash", "archive", "image"}, "scan");
  const std::string name = reader.textOf(item, "name", "scan");
  const bool inside = item.contains("image");
  const auto placeOf = [&](const char* key) -> fs::path {
    return inside ? reader.optionalText(item, key, "scan") : reader.textOf(item, key, "scan");
  };
  const fs::path relative = placeOf("relative"), absolute = placeOf("absolute");
  medical_io::ScanOptions options;
  options.series = reader.optionalText(item, "series", "scan");
  if (item.contains("phase"))
    options.phase = static_cast<int>(reader.wholeOf(item.at("phase"), "scan.phase"));
  if (inside) {
    auto scan = std::make_shared<const medical_io::Scan>(scanFrom(reader, item.at("image"), "scan.image"));
    const auto file = absolute.empty() ? std::nullopt : findImage(relative, absolute, folder, alsoIn);
    const bool nameAlone = !absolute.empty() && absolute.is_relative();
    const fs::path was = nameAlone ? (folder / lastNameOf(absolute)).lexically_normal() : absolute;
    // Saved by its file's name, it has the hash by which a change of that file is noticed.
    std::string hash = scanHash(*scan);
    if (item.contains("time"))
      opened.warnings.push_back(
          phrase("%1: %2", name,
                 Text("the session holds one phase of this scan; open its file again for the others")));
    opened.contents.state.scan = std::make_shared<const ScanItem>(
        ScanItem{name, std::move(scan), file.value_or(was), options.series, options.phase, std::move(hash)});
    return;
  }
  const std::string hash = reader.optionalText(item, "hash", "scan");
  const std::string timeHash = timeHashIn(reader, item);
  const auto missing = [&](const Text& problem) {
    opened.contents.missingScan = item;
    opened.warnings.push_back(phrase("%1: %2", name, problem));
  };
  const auto file = findImage(relative, absolute, folder, alsoIn);
  if (!file)
    return missing(lostImages(
        item, phrase("the scan %1 is not there any more (put it beside the session and open that again)",
                     absolute.string())));
  try {
    ScanItem scan =
        explainingShortMemory(file->string(), [&] { return openScanFile(*file, options, progress); });
    scan.name = name;
    if (!item.contains("time"))
      scan.time = nullptr; // Saved by a version in which a scan was one of its phases.
    if ((!hash.empty() && hash != scan.hash) ||
        (!timeHash.empty() && !(scan.time && timeHash == scan.time->hash)))
      opened.warnings.push_back(
          phrase("%1: %2", name, phrase("%1 has changed since the session was saved", file->string())));
    opened.contents.state.scan = std::make_shared<const ScanItem>(std::move(scan));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    missing(phrase("the scan cannot be opened: %1", error.explanation()));
  }
}

} // namespace viscera::document
