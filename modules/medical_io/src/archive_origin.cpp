#include "viscera/medical_io/archive_origin.h"

#include <ostream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::medical_io {
namespace {

using nlohmann::ordered_json;

std::string wordsAt(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

} // namespace

void writeArchiveOrigin(const std::filesystem::path& folder, const ArchiveOrigin& origin) {
  const ordered_json json = {
      {"archive", origin.archive}, {"studyUid", origin.studyUid}, {"seriesUid", origin.seriesUid}};
  const std::string text = json.dump(2, ' ', false, ordered_json::error_handler_t::replace);
  writeAtomically(folder / kArchiveOriginFile, [&](std::ostream& out) { out << text << "\n"; });
}

std::optional<ArchiveOrigin> readArchiveOrigin(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kArchiveOriginFile;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    return std::nullopt;
  try {
    const auto json = parseJson<ordered_json>(readText(file), file.string(), {});
    if (!json.is_object() || wordsAt(json, "archive").empty() || wordsAt(json, "studyUid").empty())
      return std::nullopt;
    return ArchiveOrigin{wordsAt(json, "archive"), wordsAt(json, "studyUid"), wordsAt(json, "seriesUid")};
  } catch (const Error&) {
    return std::nullopt; // The images are there all the same.
  }
}

} // namespace viscera::medical_io
