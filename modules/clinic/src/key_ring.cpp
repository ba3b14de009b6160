#include "viscera/clinic/key_ring.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "viscera/core/child_process.h"
#include "viscera/core/error.h"

namespace viscera::clinic {
namespace {

constexpr const char* kSecretTool = "secret-tool";
/// How long a user has to unlock the ring.
constexpr double kUnlockSeconds = 120;
constexpr useconds_t kLookMicroseconds = 5000;
constexpr std::size_t kLongestPassword = 4096;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

bool isInPath(const std::string& program) {
  std::istringstream folders(variable("PATH"));
  std::error_code ignored;
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && ::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0)
      return true;
  return false;
}

/// The ring answers on the session's bus; asking where there is none would start one.
bool hasSessionBus() {
  std::error_code ignored;
  return !variable("DBUS_SESSION_BUS_ADDRESS").empty() ||
         std::filesystem::exists(variable("XDG_RUNTIME_DIR") + "/bus", ignored);
}

/// A file in memory that has no name.
class Nameless {
public:
  explicit Nameless(const std::string& contents) : file_(::memfd_create("viscera", MFD_CLOEXEC)) {
    if (file_ >= 0 && (::write(file_, contents.data(), contents.size()) != ssize_t(contents.size()) ||
                       ::lseek(file_, 0, SEEK_SET) != 0))
      close();
  }
  ~Nameless() { close(); }
  Nameless(const Nameless&) = delete;
  Nameless& operator=(const Nameless&) = delete;

  int descriptor() const { return file_; }
  std::string contents() const {
    std::string bytes(kLongestPassword, '\0');
    const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), 0);
    bytes.resize(std::size_t(std::max<ssize_t>(count, 0)));
    return bytes;
  }

private:
  void close() {
    if (file_ >= 0)
      ::close(file_);
    file_ = -1;
  }

  int file_;
};

class SecretService final : public KeyRing {
public:
  bool isThere() const override { return hasSessionBus() && isInPath(kSecretTool); }

  std::optional<std::string> find(const ArchiveConnection& connection, Progress& progress) override {
    std::optional<std::string> found = told("lookup", {}, connection, {}, progress);
    if (found && found->ends_with('\n'))
      found->pop_back();
    return found && !found->empty() ? found : std::nullopt;
  }

  bool keep(const ArchiveConnection& connection, const std::string& password, Progress& progress) override {
    return told("store", {"--label", "Viscera: " + connection.address}, connection, password, progress)
        .has_value();
  }

  void forget(const ArchiveConnection& connection, Progress& progress) override {
    told("clear", {}, connection, {}, progress);
  }

private:
  /// What the program says when it has done what it was told; none where it has not.
  std::optional<std::string> told(const char* what, const std::vector<std::string>& options,
                                  const ArchiveConnection& connection, const std::string& input,
                                  Progress& progress) const {
    const Nameless in(input), out({});
    if (!isThere() || in.descriptor() < 0 || out.descriptor() < 0)
      return std::nullopt;
    std::vector<std::string> arguments = {kSecretTool, what};
    arguments.insert(arguments.end(), options.begin(), options.end());
    for (const std::string& each :
         {std::string("application"), std::string("viscera"), std::string("address"), connection.address,
          std::string("user"), connection.user})
      arguments.push_back(each);
    ChildProcess program(std::move(arguments), in.descriptor(), out.descriptor());
    ChildResult result;
    for (double waited = 0; program.startError() == 0 && !program.ended(result);
         waited += double(kLookMicroseconds) * 1e-6) {
      progress.throwIfCancelled();
      if (waited > kUnlockSeconds)
        return std::nullopt;
      ::usleep(kLookMicroseconds);
    }
    const bool done = program.startError() == 0 && result.end == ChildResult::End::exited && result.code == 0;
    return done ? std::optional(out.contents()) : std::nullopt;
  }
};

class NoRing final : public KeyRing {
public:
  bool isThere() const override { return false; }
  std::optional<std::string> find(const ArchiveConnection&, Progress&) override { return std::nullopt; }
  bool keep(const ArchiveConnection&, const std::string&, Progress&) override { return false; }
  void forget(const ArchiveConnection&, Progress&) override {}
};

} // namespace

std::shared_ptr<KeyRing> systemKeyRing() {
  return std::make_shared<SecretService>();
}

std::shared_ptr<KeyRing> noKeyRing() {
  return std::make_shared<NoRing>();
}

bool wantsPassword(const ArchiveConnection& connection) {
  return connection.kind == ArchiveKind::dicomWeb && !connection.user.empty();
}

} // namespace viscera::clinic
