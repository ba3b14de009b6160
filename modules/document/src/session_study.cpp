#include "session_study.h"

#include <memory>
#include <optional>
#include <utility>

#include "session_scan.h"
#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/core/phrase.h"

namespace viscera::document {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json sessionStudyJson(const StudyItem& item, const fs::path& folder) {
  const fs::path absolute = absolutePath(item.place).lexically_normal();
  ordered_json json{{"name", item.name},
                    {"relative", absolute.lexically_relative(folder).generic_string()},
                    {"absolute", absolute.generic_string()}};
  addArchiveOrigin(json, item.place);
  if (!item.study->studyUid.empty())
    json["uid"] = item.study->studyUid;
  if (!item.hash.empty())
    json["hash"] = item.hash;
  return json;
}

void readSessionStudy(SessionReader& reader, const ordered_json& item, const fs::path& folder,
                      const std::vector<fs::path>& alsoIn, OpenedSession& opened, Progress& progress) {
  reader.takeObject(item, {"name", "relative", "absolute", "uid", "hash", "archive"}, "study");
  const std::string name = reader.textOf(item, "name", "study");
  const fs::path relative = reader.textOf(item, "relative", "study");
  const fs::path absolute = reader.textOf(item, "absolute", "study");
  const std::string uid = reader.optionalText(item, "uid", "study");
  const std::string hash = reader.optionalText(item, "hash", "study");
  const auto missing = [&](const Text& problem) {
    opened.contents.missingStudy = item;
    opened.warnings.push_back(phrase("%1: %2", name, problem));
  };
  const std::optional<fs::path> place = findImage(relative, absolute, folder, alsoIn);
  if (!place)
    return missing(lostImages(
        item, phrase("the study %1 is not there any more (put it beside the session and open that again)",
                     absolute.string())));
  try {
    StudyItem study = explainingShortMemory(place->string(), [&] { return readStudy(*place, progress); });
    study.name = name;
    if ((!uid.empty() && uid != study.study->studyUid) || (!hash.empty() && hash != study.hash))
      opened.warnings.push_back(
          phrase("%1: %2", name, phrase("%1 has changed since the session was saved", place->string())));
    opened.contents.state.study = std::make_shared<const StudyItem>(std::move(study));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    missing(phrase("the study cannot be opened: %1", error.explanation()));
  }
}

} // namespace viscera::document
