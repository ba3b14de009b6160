#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace viscera {

/// A folder that files are written into, all or none. Unless `keep` is called, the destructor removes the
/// files that were not there before, and the folder if it was made.
class OutputFolder {
public:
  /// Makes the folder where it is missing. Throws `CannotCreateError`.
  explicit OutputFolder(std::filesystem::path folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  bool has(const std::string& name) const;
  /// Returns where to write the file of that name.
  std::filesystem::path place(const std::string& name);
  void keep() { kept_ = true; }

private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> added_;
  bool made_ = false;
  bool kept_ = false;
};

} // namespace viscera
