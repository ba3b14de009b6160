#include "viscera/core/atomic_file.h"

#include <cerrno>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "viscera/core/error.h"

namespace viscera {
namespace {

constexpr int kAttempts = 100;
constexpr auto kAdvice = "choose a folder that exists, may be written to and has room";

std::string reason(int error) {
  return "cannot be written: " + std::generic_category().message(error);
}

/// The name that a symbolic link at `target` stands for, so that the link stays.
std::filesystem::path resolved(const std::filesystem::path& target) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::weakly_canonical(target, error);
  return error ? target : real;
}

/// Creates an empty file that nobody else has, hidden, beside `target`, with the rights that new files get.
std::filesystem::path createBeside(const std::filesystem::path& target) {
  std::random_device random;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::filesystem::path candidate = target;
    candidate.replace_filename("." + std::to_string(random()) + "-" + target.filename().string());
    const int file = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      return candidate;
    }
    if (errno != EEXIST)
      throw CannotCreateError(reason(errno), target.string(), kAdvice);
  }
  throw CannotCreateError(reason(EEXIST), target.string(), kAdvice);
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
    throw CannotCreateError("cannot be written: it is a folder", target_.string(), "name a file in it");
  direct_ = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (!direct_)
    target_ = resolved(target_);
  temporary_ = direct_ ? target_ : createBeside(target_);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_ && !direct_)
    std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  if (!direct_) {
    bringToDisk(temporary_, target_);
    std::error_code error;
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      throw CannotCreateError(reason(error.value()), target_.string(), kAdvice);
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

} // namespace viscera
