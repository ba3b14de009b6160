#include "session_scan.h"

#include <optional>
#include <system_error>

#include "viscera/core/error.h"

namespace viscera::document {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Relative to the session file, where it was, beside the session file: the first that is there.
std::optional<fs::path> findScan(const fs::path& relative, const fs::path& absolute, const fs::path& folder) {
  const fs::path name = absolute.has_filename() ? absolute.filename() : absolute.parent_path().filename();
  std::error_code error;
  for (const fs::path& place : {folder / relative, absolute, folder / name})
    if (!place.empty() && fs::exists(place, error))
      return fs::absolute(place, error).lexically_normal();
  return std::nullopt;
}

} // namespace

ordered_json sessionScanJson(const ScanItem& item, const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::absolute(item.file, error).lexically_normal();
  ordered_json json{{"name", item.name},
                    {"relative", absolute.lexically_relative(folder).generic_string()},
                    {"absolute", absolute.generic_string()}};
  if (!item.series.empty())
    json["series"] = item.series;
  if (item.phase != 0)
    json["phase"] = item.phase;
  return json;
}

void readSessionScan(SessionReader& reader, const ordered_json& item, const fs::path& folder,
                     OpenedSession& opened, Progress& progress) {
  reader.takeObject(item, {"name", "relative", "absolute", "series", "phase"}, "scan");
  const std::string name = reader.textOf(item, "name", "scan");
  const fs::path relative = reader.textOf(item, "relative", "scan");
  const fs::path absolute = reader.textOf(item, "absolute", "scan");
  medical_io::ScanOptions options;
  options.series = reader.optionalText(item, "series", "scan");
  if (item.contains("phase"))
    options.phase = static_cast<int>(reader.wholeOf(item.at("phase"), "scan.phase"));
  const auto missing = [&](const std::string& problem) {
    opened.contents.missingScan = item.dump();
    opened.warnings.push_back(name + ": " + problem);
  };
  const auto file = findScan(relative, absolute, folder);
  if (!file)
    return missing("the scan " + absolute.string() +
                   " is not there any more (put it beside the session and open that again)");
  try {
    ScanItem scan = openScanFile(*file, options, progress);
    scan.name = name;
    opened.contents.state.scan = std::make_shared<const ScanItem>(std::move(scan));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    missing("the scan cannot be opened: " + std::string(error.what()));
  }
}

} // namespace viscera::document
