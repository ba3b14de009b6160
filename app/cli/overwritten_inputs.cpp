#include "cli/overwritten_inputs.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/file_facts.h"
#include "viscera/document/session_file.h"
#include "viscera/medical_io/file_kind.h"

namespace viscera::app::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 4096;

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code unreachable; // Also set for a file that is not there.
  return fs::equivalent(a, b, unreachable) && !unreachable;
}

/// Whether a folder that is read as a whole, or a session, may be read for the sake of a file like this one.
bool isOrganOrImage(const fs::path& file) {
  try {
    const medical_io::FileKind kind = medical_io::fileKind(file);
    return kind == medical_io::FileKind::surface || kind == medical_io::FileKind::labelMap ||
           kind == medical_io::FileKind::scan;
  } catch (const Error&) {
    return false;
  }
}

/// The file or folder that an argument names before the name of a label or of an organ; empty: none.
fs::path existingPart(fs::path argument) {
  std::error_code unreachable;
  while (!argument.empty() && !fs::exists(argument, unreachable)) {
    const fs::path parent = argument.parent_path();
    argument = parent == argument ? fs::path() : parent;
  }
  return argument;
}

/// Whether any text of the session is a path to this file, from the session's folder.
bool names(const nlohmann::json& part, const fs::path& folder, const fs::path& file) {
  if (part.is_string()) {
    const auto& text = part.get_ref<const std::string&>();
    return text.size() < kLongestPath && text.find('.') != std::string::npos && sameFile(folder / text, file);
  }
  return part.is_structured() && std::any_of(part.begin(), part.end(), [&](const nlohmann::json& inner) {
           return names(inner, folder, file);
         });
}

bool sessionNames(const fs::path& session, const fs::path& file) {
  std::ifstream stream(session, std::ios::binary);
  const nlohmann::json root = nlohmann::json::parse(stream, nullptr, false);
  return !root.is_discarded() && names(root, absolutePath(session).parent_path(), file);
}

bool isRead(const fs::path& output, const std::string& argument) {
  std::vector<std::string> readings{argument};
  if (const std::size_t equals = argument.find('='); equals != std::string::npos)
    readings.push_back(argument.substr(equals + 1));
  return std::any_of(readings.begin(), readings.end(), [&](const std::string& reading) {
    const fs::path input = existingPart(reading);
    std::error_code unreachable;
    if (input.empty())
      return false;
    if (fs::is_directory(input, unreachable))
      return sameFile(absolutePath(output).parent_path(), input) && isOrganOrImage(output);
    return sameFile(output, input) ||
           (document::isSessionFile(input) && isOrganOrImage(output) && sessionNames(input, output));
  });
}

} // namespace

void requireDifferent(const std::vector<std::string>& outputs) {
  std::set<fs::path> places;
  for (const std::string& output : outputs) {
    std::error_code unreachable;
    const fs::file_status status = fs::status(output, unreachable);
    const bool isDevice = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
    if (!isDevice && !places.insert(absolutePath(output).lexically_normal()).second)
      throw UsageError("Two outputs have this name", output, "name another file for one of them");
  }
}

void requireNoInput(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (const std::string& output : outputs) {
    std::error_code unreachable;
    if (!fs::is_regular_file(output, unreachable))
      continue;
    if (std::any_of(inputs.begin(), inputs.end(),
                    [&](const std::string& input) { return isRead(output, input); }))
      throw UsageError("It is an input, which the output would overwrite", output,
                       "name another file, or say --force");
  }
}

} // namespace viscera::app::cli
