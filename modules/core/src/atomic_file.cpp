#include "viscera/core/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera {
namespace {

constexpr int kAttempts = 100;
constexpr auto kAdvice = "choose a folder that exists, may be written to and has room";

Text reason(int error) {
  return phrase("It cannot be written: %1", std::generic_category().message(error));
}

/// The name that a symbolic link at `target` stands for, so that the link stays.
std::filesystem::path resolved(const std::filesystem::path& target) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::weakly_canonical(target, error);
  return error ? target : real;
}

/// The name of a temporary file is a dot, a number, this character and the target's name.
constexpr char kBehindNumber = '-';

/// Closes a file when it goes, which gives its lock back.
struct OpenFile {
  explicit OpenFile(int number) : file(number) {}
  ~OpenFile() {
    if (file >= 0)
      ::close(file);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int release() { return std::exchange(file, -1); }

  int file;
};

/// Whether the new file is this program's to write: locked, where the disk knows locks, and not removed in
/// the moment before by a program that took it for abandoned.
bool claim(int file) {
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return false;
  struct stat status {};
  return ::fstat(file, &status) == 0 && status.st_nlink > 0;
}

/// Creates a new empty file, hidden, beside `target`, with the rights that new files get; gives its name and
/// the open file, which holds the lock.
std::pair<std::filesystem::path, int> createBeside(const std::filesystem::path& target) {
  std::random_device random;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::filesystem::path candidate = target;
    candidate.replace_filename("." + std::to_string(random()) + kBehindNumber + target.filename().string());
    OpenFile created(::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (created.file >= 0 && claim(created.file))
      return {candidate, created.release()};
    if (created.file < 0 && errno != EEXIST)
      throw CannotCreateError(reason(errno), target.string(), kAdvice);
  }
  throw CannotCreateError(reason(EEXIST), target.string(), kAdvice);
}

/// Whether `name` is one that `createBeside` gives for a target of the name `targetName`.
bool isTemporaryOf(std::string_view targetName, std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(targetName))
    return false;
  const std::string_view number = name.substr(1, name.size() - 1 - targetName.size());
  return number.size() > 1 && number.back() == kBehindNumber &&
         std::all_of(number.begin(), number.end() - 1, [](char c) { return c >= '0' && c <= '9'; });
}

/// Removes a temporary file unless its writer holds its lock, or there is no telling.
void removeIfAbandoned(const std::filesystem::path& file) {
  const OpenFile opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (opened.file >= 0 && ::flock(opened.file, LOCK_EX | LOCK_NB) == 0)
    ::unlink(file.c_str());
}

void bringToDisk(const std::filesystem::path& written, const std::filesystem::path& target) {
  const int file = ::open(written.c_str(), O_RDONLY | O_CLOEXEC);
  const bool failed = file < 0 || ::fsync(file) != 0;
  const int error = errno;
  if (file >= 0)
    ::close(file);
  if (failed)
    throw CannotCreateError(reason(error), target.string(), kAdvice);
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target_, error);
  if (std::filesystem::is_directory(status))
    throw CannotCreateError("It cannot be written: it is a folder", target_.string(), "name a file in it");
  direct_ = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (!direct_)
    target_ = resolved(target_);
  if (direct_)
    temporary_ = target_;
  else
    std::tie(temporary_, lock_) = createBeside(target_);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_ && !direct_)
    std::filesystem::remove(temporary_, ignored);
  if (lock_ >= 0)
    ::close(lock_);
}

void AtomicFile::commit() {
  if (!direct_) {
    bringToDisk(temporary_, target_);
    std::error_code error;
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      throw CannotCreateError(reason(error.value()), target_.string(), kAdvice);
    removeAbandonedWrites(target_);
  }
  committed_ = true;
}

void writeAtomically(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write) {
  AtomicFile file(target);
  std::ofstream stream(file.temporary(), std::ios::binary);
  errno = 0;
  write(stream);
  stream.close();
  if (!stream)
    throw CannotCreateError(reason(errno != 0 ? errno : EIO), target.string(), kAdvice);
  file.commit();
}

void removeAbandonedWrites(const std::filesystem::path& target) noexcept {
  try {
    const std::filesystem::path file = std::filesystem::absolute(resolved(target));
    const std::string name = file.filename().string();
    std::error_code error, ignored;
    for (std::filesystem::directory_iterator item(file.parent_path(), error), end; !error && item != end;
         item.increment(error))
      if (isTemporaryOf(name, item->path().filename().string()) && item->is_regular_file(ignored))
        removeIfAbandoned(item->path());
  } catch (const std::exception&) {
    return; // Files that cannot be removed are left; they do no harm.
  }
}

} // namespace viscera
