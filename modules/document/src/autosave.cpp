#include "viscera/document/autosave.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "viscera/core/atomic_file.h"
#include "viscera/document/session_file.h"

namespace viscera::document {

namespace fs = std::filesystem;

/// A file that one program at a time can lock; the system releases the lock when that program ends in any
/// way.
class FileLock {
public:
  /// Takes the lock, making the file when it is not there; null when another program has it or the file
  /// cannot be made.
  static std::shared_ptr<FileLock> take(const fs::path& file) {
    for (;;) {
      const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
      if (descriptor < 0)
        return nullptr;
      if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return nullptr;
      }
      if (isStillThere(descriptor, file))
        return std::shared_ptr<FileLock>(new FileLock(file, descriptor));
      ::close(descriptor);
    }
  }

  ~FileLock() { ::close(descriptor_); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  const fs::path& file() const { return file_; }

  /// Removes the file, so that no program can take this lock any more.
  void remove() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }

private:
  FileLock(fs::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

  /// Whether the open file is still the one of that name: another program may have removed it before this one
  /// got the lock.
  static bool isStillThere(int descriptor, const fs::path& file) {
    struct stat open, named;
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
  }

  fs::path file_;
  int descriptor_;
};

namespace {

constexpr const char* kSlot = "autosave";
constexpr const char* kPrefix = "recovery-";
constexpr const char* kLockEnding = ".lock";

fs::path withEnding(fs::path file, const char* ending) {
  return file.replace_extension(ending);
}

std::vector<fs::path> locksIn(const fs::path& folder) {
  std::vector<fs::path> locks;
  std::error_code error;
  for (fs::directory_iterator item(folder, error), end; !error && item != end; item.increment(error))
    if (item->path().filename().string().starts_with(kPrefix) && item->path().extension() == kLockEnding)
      locks.push_back(item->path());
  return locks;
}

} // namespace

fs::path standardRecoveryFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state)
    return fs::path(state) / "viscera";
  const char* home = std::getenv("HOME");
  return fs::path(home ? home : "") / ".local" / "state" / "viscera";
}

std::vector<Recovery> findRecoveries(const fs::path& folder) {
  std::vector<Recovery> found;
  for (const fs::path& lockFile : locksIn(folder)) {
    auto lock = FileLock::take(lockFile);
    if (!lock)
      continue; // Its program is running.
    const fs::path file = withEnding(lockFile, kSessionEnding);
    removeAbandonedWrites(file);
    std::error_code error;
    const auto written = fs::last_write_time(file, error);
    if (error)
      lock->remove();
    else
      found.push_back({file, written, std::move(lock)});
  }
  std::sort(found.begin(), found.end(),
            [](const Recovery& a, const Recovery& b) { return a.written > b.written; });
  return found;
}

void discard(const Recovery& recovery) {
  std::error_code ignored;
  fs::remove(recovery.file, ignored);
  recovery.lock->remove();
}

/// The file, for the worker that writes it and the thread that gives it up.
class Autosave::Target {
public:
  explicit Target(fs::path folder) : folder_(std::move(folder)) {}

  /// Writes the contents, under a name that no other program has; leaves no file when it was given up.
  void write(const SessionContents& contents, Progress& progress) {
    try {
      const std::lock_guard guard(mutex_);
      progress.throwIfCancelled();
      require();
      writeSession(file_, contents, progress);
    } catch (...) {
      removeIfGivenUp();
      throw;
    }
    removeIfGivenUp();
  }

  /// Removes the file, now or when it has been written. Does not wait.
  void giveUp() {
    givenUp_ = true;
    if (const std::unique_lock guard(mutex_, std::try_to_lock); guard.owns_lock())
      remove();
  }

  void adopt(const Recovery& recovery) {
    const std::lock_guard guard(mutex_);
    file_ = recovery.file;
    lock_ = recovery.lock;
  }

  fs::path file() {
    const std::lock_guard guard(mutex_);
    return lock_ ? file_ : fs::path();
  }

private:
  void require() {
    if (lock_)
      return;
    std::error_code error;
    fs::create_directories(folder_, error);
    fs::permissions(folder_, fs::perms::owner_all, error); // Other users must not read organs of patients.
    const std::string name =
        kPrefix + std::to_string(::getpid()) + "-" + std::to_string(std::random_device()());
    lock_ = FileLock::take(folder_ / (name + kLockEnding));
    if (!lock_)
      throw CannotCreateError("unsaved work cannot be kept safe: the folder cannot be written to",
                              folder_.string(), "save often, or make room there");
    file_ = withEnding(lock_->file(), kSessionEnding);
  }

  /// Call it after the mutex was released: removes the file if it was given up meanwhile.
  void removeIfGivenUp() {
    if (!givenUp_)
      return;
    const std::lock_guard guard(mutex_);
    remove();
  }

  void remove() {
    if (!lock_)
      return;
    std::error_code ignored;
    fs::remove(file_, ignored);
    lock_->remove();
    lock_.reset();
  }

  std::mutex mutex_; ///< Held while the file is written: of the members below.
  fs::path folder_;
  fs::path file_;
  std::shared_ptr<FileLock> lock_;
  std::atomic<bool> givenUp_ = false;
};

Autosave::Autosave(fs::path folder, JobQueue::Post post, Clock clock, double delaySeconds)
    : folder_(std::move(folder)), clock_(std::move(clock)), delaySeconds_(delaySeconds),
      target_(std::make_shared<Target>(folder_)), jobs_(std::move(post)) {}

Autosave::~Autosave() = default;

void Autosave::changed() {
  if (!changedAt_)
    changedAt_ = clock_();
}

bool Autosave::due() const {
  return changedAt_ && clock_() - *changedAt_ >= delaySeconds_;
}

void Autosave::write(SessionContents contents, Done done) {
  changedAt_.reset();
  jobs_.submit<bool>(
      "Autosave", kSlot,
      [target = target_, contents = std::move(contents)](Progress& progress) {
        target->write(contents, progress);
        return true;
      },
      [done = std::move(done)](JobResult<bool> result) {
        if (done && !result.cancelled())
          done(result.error);
      });
}

void Autosave::writeNow(const SessionContents& contents) {
  changedAt_.reset();
  jobs_.cancelSlot(kSlot);
  Progress progress;
  target_->write(contents, progress);
}

void Autosave::clear() {
  changedAt_.reset();
  jobs_.cancelSlot(kSlot);
  target_->giveUp();
  target_ = std::make_shared<Target>(folder_);
}

void Autosave::adopt(const Recovery& recovery) {
  clear();
  target_->adopt(recovery);
}

fs::path Autosave::file() const {
  return target_->file();
}

} // namespace viscera::document
