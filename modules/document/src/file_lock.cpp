#include "file_lock.h"

#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace viscera::document {
namespace {

/// Whether the open file is still the one of that name: another program may have removed it before this one
/// got the lock.
bool isStillThere(int descriptor, const std::filesystem::path& file) {
  struct stat open, named;
  return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

} // namespace

std::shared_ptr<FileLock> FileLock::take(const std::filesystem::path& file) {
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

FileLock::~FileLock() {
  ::close(descriptor_);
}

void FileLock::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

} // namespace viscera::document
