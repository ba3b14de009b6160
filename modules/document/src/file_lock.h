#pragma once

#include <filesystem>
#include <memory>

namespace viscera::document {

/// A file that one program at a time holds; the system lets go of it when that program ends, however it ends.
class FileLock {
public:
  /// Takes the lock, making the file when it is not there; null when another program has it or the file
  /// cannot be made.
  static std::shared_ptr<FileLock> take(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  const std::filesystem::path& file() const { return file_; }
  /// Removes the file; nobody can take this lock any more.
  void remove() const;

private:
  FileLock(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_;
};

} // namespace viscera::document
