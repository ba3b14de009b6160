#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/job_queue.h"
#include "viscera/document/session_file.h"

/// Saves the document in a recovery file from time to time, from which work can be restored after a crash.
/// Each running program has one such file, a session like any other (session_file.h).
namespace viscera::document {

class FileLock;

/// A recovery file of a program that has ended without removing it. While this object lives, other programs
/// do not find the file.
struct Recovery {
  std::filesystem::path file;
  std::filesystem::file_time_type written;
  std::shared_ptr<FileLock> lock; ///< Never null.
};

/// `$XDG_STATE_HOME/viscera`, or `~/.local/state/viscera`.
std::filesystem::path standardRecoveryFolder();

/// The recovery files of programs that run no more, the youngest first; leftovers without contents are
/// removed. A folder that is not there holds none.
std::vector<Recovery> findRecoveries(const std::filesystem::path& folder);

/// Removes the file: its contents are not wanted, or are saved.
void discard(const Recovery& recovery);

/// Writes the recovery file of this program, some time after the first unsaved change. The owner calls
/// `changed` and `clear`, checks `due` regularly, and then calls `write` with the contents. These are an
/// immutable state, which a worker writes without blocking the window. For one thread.
///
/// The file stays when the program ends without `clear`; a lock that the system releases tells other programs
/// that this one is gone.
class Autosave {
public:
  /// Returns monotonic seconds.
  using Clock = std::function<double()>;
  /// Called with the result of a write: null, or the error.
  using Done = std::function<void(std::shared_ptr<const Error>)>;

  /// How long a change may be unsaved, s.
  static constexpr double kDelaySeconds = 60;

  /// The folder is made when the first file is written. `post` as for a `JobQueue`.
  Autosave(std::filesystem::path folder, JobQueue::Post post, Clock clock,
           double delaySeconds = kDelaySeconds);
  /// Waits for a write that has begun. The file stays.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Call it when the document has unsaved changes; the delay counts from the first call since the last
  /// write.
  void changed();
  /// Whether the contents should be written now.
  bool due() const;
  /// Writes the contents soon, in place of earlier ones. `done` is called through `post`, unless a later
  /// write or `clear` made this one unnecessary.
  void write(SessionContents contents, Done done = {});
  /// Writes the contents and waits until they are on the disk, for a program that is about to end. Throws as
  /// `writeSession` does.
  void writeNow(const SessionContents& contents);
  /// Call it when everything is saved or discarded: removes the recovery file, at the latest when a write
  /// that has begun is over, and drops pending writes. Does not wait.
  void clear();
  /// Takes over this recovery file instead of a new one, after the document was opened from it.
  void adopt(const Recovery& recovery);

  /// The recovery file of this program, whether it exists or not. Empty before the first write. Waits for a
  /// write that has begun.
  std::filesystem::path file() const;

private:
  class Target;

  std::filesystem::path folder_;
  Clock clock_;
  double delaySeconds_;
  std::optional<double> changedAt_;
  std::shared_ptr<Target> target_;
  JobQueue jobs_;
};

} // namespace viscera::document
