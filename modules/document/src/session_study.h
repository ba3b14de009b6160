#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "session_json.h"
#include "viscera/document/session_file.h"
#include "viscera/document/study_item.h"

/// Reads and writes the cine study of a session file, which names it (docs/session_format.md, "study").
namespace viscera::document {

/// The place of a study, also relative to the session file's `folder`, and what it is.
nlohmann::ordered_json sessionStudyJson(const StudyItem& item, const std::filesystem::path& folder);

/// Reads the study that `item` names into `opened`; it is looked for in `alsoIn`, too. One that is not there,
/// or cannot be read, becomes a warning and stays as `missingStudy`. Throws `DataError` for a record that is
/// none, `Cancelled`.
void readSessionStudy(SessionReader& reader, const nlohmann::ordered_json& item,
                      const std::filesystem::path& folder, const std::vector<std::filesystem::path>& alsoIn,
                      OpenedSession& opened, Progress& progress);

} // namespace viscera::document
