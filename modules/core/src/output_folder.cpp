#include "viscera/core/output_folder.h"

#include <system_error>
#include <utility>

#include "viscera/core/error.h"

namespace viscera {

OutputFolder::OutputFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  made_ = std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_, error))
    throw CannotCreateError("the folder cannot be made", folder_.string(), "choose another one");
}

OutputFolder::~OutputFolder() {
  if (kept_)
    return;
  std::error_code ignored;
  for (const std::filesystem::path& file : added_)
    std::filesystem::remove(file, ignored);
  if (made_)
    std::filesystem::remove(folder_, ignored);
}

bool OutputFolder::has(const std::string& name) const {
  std::error_code ignored;
  return std::filesystem::exists(folder_ / name, ignored);
}

std::filesystem::path OutputFolder::place(const std::string& name) {
  const std::filesystem::path file = folder_ / name;
  if (!has(name))
    added_.push_back(file);
  return file;
}

} // namespace viscera
