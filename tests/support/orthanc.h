#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "dicom_slices.h"
#include "temporary_folder.h"
#include "viscera/clinic/archive.h"
#include "viscera/core/error.h"

/// A real archive (Orthanc) on this machine, for tests: on free loopback ports, with a store of its own.
namespace viscera::tests {

inline constexpr auto kOrthanc = "/usr/sbin/Orthanc";
inline constexpr auto kOrthancWeb = "/usr/share/orthanc/plugins/libOrthancDicomWeb.so";
inline constexpr auto kArchivePassword = "s3cret-of-the-test";
inline constexpr auto kArchivedStudy = "1.2.840.4711.7";
inline constexpr auto kArchivedSeries = "1.2.840.4711.7.1";

/// A socket on a free loopback port.
struct Listener {
  int descriptor = -1, port = 0;
  Listener() {
    descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    socklen_t size = sizeof address;
    ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
  }
  ~Listener() { ::close(descriptor); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
};

inline int freePort() {
  return Listener().port;
}

/// A program in the background, ended with the object.
class Background {
public:
  explicit Background(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& argument : command)
      arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    if (::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ) != 0)
      process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
  }
  ~Background() {
    if (process_ <= 0)
      return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

private:
  pid_t process_ = -1;
};

inline std::string webAddress(int port, const std::string& scheme = "http") {
  return scheme + "://127.0.0.1:" + std::to_string(port) + "/dicom-web";
}

inline clinic::ArchiveConnection webTo(int port) {
  clinic::ArchiveConnection web;
  web.name = "Ward";
  web.address = webAddress(port);
  web.user = "nurse";
  web.patienceSeconds = 5;
  return web;
}

inline clinic::ArchiveConnection dimseTo(int port) {
  clinic::ArchiveConnection dimse;
  dimse.name = "Ward";
  dimse.kind = clinic::ArchiveKind::dimse;
  dimse.address = "127.0.0.1";
  dimse.port = port;
  dimse.calledTitle = "WARD";
  dimse.patienceSeconds = 5;
  return dimse;
}

/// Whether the archive's packages are there. Where they must be (CI), a test without them has failed.
inline bool orthancIsThere() {
  return std::filesystem::exists(kOrthanc) && std::filesystem::exists(kOrthancWeb);
}

/// Eight slices of a series, each with its own values.
inline std::vector<std::filesystem::path> madeSeries(const TemporaryFolder& folder,
                                                     const std::string& study = kArchivedStudy) {
  LabelImage image = emptyLabels({64, 48, 8});
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] = std::int16_t(i % 977);
  std::vector<std::filesystem::path> files;
  for (int k = 0; k < image.size[2]; ++k) {
    DicomElements slice = dicomSlice(image, k, study + ".1");
    slice[0x00080005] = "CSISO_IR 100";
    slice[0x00080020] = "DA20240301";
    slice[0x00081030] = "LOAbdomen";
    slice[0x00100010] = "PNM\xFCller^Jane"; // Latin-1.
    slice[0x00100020] = "LOPID0815";
    slice[0x0020000D] = "UI" + study;
    files.push_back(folder.put("slice" + std::to_string(k), dicomBytes(slice)));
  }
  return files;
}

/// An archive that runs as long as the object.
class Orthanc {
public:
  Orthanc() : dimsePort(freePort()), webPort(freePort()) {
    const std::string store = (folder_ / "store").string();
    const std::string file =
        folder_
            .put("orthanc.json", R"({"Name": "Ward", "DicomAet": "WARD",
      "DicomCheckCalledAet": true, "DicomPort": )" +
                                     std::to_string(dimsePort) + R"(, "HttpPort": )" +
                                     std::to_string(webPort) + R"(, "StorageDirectory": ")" + store +
                                     R"(", "IndexDirectory": ")" + store +
                                     R"(", "RemoteAccessAllowed": false,
      "AuthenticationEnabled": true, "RegisteredUsers": {"nurse": ")" +
                                     kArchivePassword + R"("}, "Plugins": [")" + kOrthancWeb +
                                     R"("], "DicomWeb": {"Enable": true, "Root": "/dicom-web/"},
      "DicomAlwaysAllowEcho": true, "DicomAlwaysAllowStore": true, "DicomAlwaysAllowFind": true,
      "DicomAlwaysAllowGet": true})")
            .string();
    program_ = std::make_unique<Background>(std::vector<std::string>{kOrthanc, file});
    Progress quiet;
    for (int tries = 0; tries < 200 && !answers_; ++tries) {
      try {
        clinic::testArchive(webTo(webPort), kArchivePassword, quiet);
        answers_ = true;
      } catch (const Error&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    }
  }
  bool answers() const { return answers_; }

  int dimsePort, webPort;

private:
  TemporaryFolder folder_;
  std::unique_ptr<Background> program_; ///< Ends before its folder.
  bool answers_ = false;
};

} // namespace viscera::tests
