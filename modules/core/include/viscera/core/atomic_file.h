#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace viscera {

/// Writes a file under a temporary name in the same folder, and renames it when it is complete. A cancelled
/// job, an error or a full disk leave what was there before, and nothing half-written. For one thread.
///
/// A target that is there and is no regular file (`/dev/stdout`, a pipe) cannot be renamed over: it is
/// written to directly.
class AtomicFile {
public:
  /// Creates the temporary file, empty. Throws `CannotCreateError` when the folder does not exist or may not
  /// be written to, or when `target` is a folder.
  explicit AtomicFile(std::filesystem::path target);
  /// Removes the temporary file unless `commit` was called.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// The file to write to. It has the target's extension, for writers that choose the format by the name.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes the contents to the disk, renames the file to the target, and removes temporary files of
  /// programs that were killed while they wrote this target. Before, the caller has to close the file and
  /// check that everything was written. Throws `CannotCreateError`.
  void commit();

private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int lock_ = -1; ///< Lock on the open temporary file, by which `removeAbandonedWrites` knows that its writer
                  ///< still runs.
  bool direct_ = false;
  bool committed_ = false;
};

/// Writes a whole file by `write`, which gets a binary stream, or leaves what was there before. Throws
/// `CannotCreateError` when the stream fails (a full disk), and whatever `write` throws.
void writeAtomically(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write);

/// Removes the temporary files of earlier `AtomicFile`s of `target` whose programs ended before they could (a
/// kill, a power cut); never one of a program that lives, on this or another machine. What cannot be removed
/// stays. Reads the names of all files in the folder. Throws nothing.
void removeAbandonedWrites(const std::filesystem::path& target) noexcept;

} // namespace viscera
