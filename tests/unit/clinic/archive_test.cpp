#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include "dicom_slices.h"
#include "run_process.h"
#include "temporary_folder.h"
#include "viscera/clinic/archive.h"
#include "viscera/core/error.h"

/// A real archive (Orthanc) on this machine: what goes in comes back, and each broken connection is told in
/// a sentence and leaves nothing.
namespace viscera::clinic {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr auto kOrthanc = "/usr/sbin/Orthanc";
constexpr auto kWebPlugin = "/usr/share/orthanc/plugins/libOrthancDicomWeb.so";
constexpr auto kArchivePassword = "s3cret-of-the-test";
constexpr auto kArchivedStudy = "1.2.840.4711.7";

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

int freePort() {
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

/// Answers one caller after another with the same bytes, then hangs up.
class CuttingServer {
public:
  explicit CuttingServer(std::string answer) : answer_(std::move(answer)) {
    ::listen(listener_.descriptor, 4);
    thread_ = std::thread([this] {
      while (true) {
        const int caller = ::accept(listener_.descriptor, nullptr, nullptr);
        if (caller < 0 || ended_)
          return;
        char request[4096];
        if (::read(caller, request, sizeof request) > 0)
          static_cast<void>(!::write(caller, answer_.data(), answer_.size()));
        ::close(caller);
      }
    });
  }
  ~CuttingServer() {
    ended_ = true;
    ::shutdown(listener_.descriptor, SHUT_RDWR);
    thread_.join();
  }
  CuttingServer(const CuttingServer&) = delete;
  CuttingServer& operator=(const CuttingServer&) = delete;
  int port() const { return listener_.port; }

private:
  Listener listener_;
  std::string answer_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

std::string webAddress(int port, const std::string& scheme = "http") {
  return scheme + "://127.0.0.1:" + std::to_string(port) + "/dicom-web";
}

ArchiveConnection webTo(int port) {
  ArchiveConnection web;
  web.name = "Ward";
  web.address = webAddress(port);
  web.user = "nurse";
  web.patienceSeconds = 5;
  return web;
}

ArchiveConnection dimseTo(int port) {
  ArchiveConnection dimse;
  dimse.name = "Ward";
  dimse.kind = ArchiveKind::dimse;
  dimse.address = "127.0.0.1";
  dimse.port = port;
  dimse.calledTitle = "WARD";
  dimse.patienceSeconds = 5;
  return dimse;
}

/// What `work` says is wrong; empty: nothing.
template <class Work>
std::string complaint(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::Not(HasSubstr(kArchivePassword)));
    return error.what();
  }
  return {};
}

/// Eight slices of a series, each with its own values.
std::vector<std::filesystem::path> madeSeries(const tests::TemporaryFolder& folder) {
  tests::LabelImage image = tests::emptyLabels({64, 48, 8});
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] = std::int16_t(i % 977);
  std::vector<std::filesystem::path> files;
  for (int k = 0; k < image.size[2]; ++k) {
    tests::DicomElements slice = tests::dicomSlice(image, k, "1.2.840.4711.7.1");
    slice[0x00080005] = "CSISO_IR 100";
    slice[0x00080020] = "DA20240301";
    slice[0x00081030] = "LOAbdomen";
    slice[0x00100010] = "PNM\xFCller^Jane"; // Latin-1.
    slice[0x00100020] = "LOPID0815";
    slice[0x0020000D] = std::string("UI") + kArchivedStudy;
    files.push_back(folder.put("slice" + std::to_string(k), tests::dicomBytes(slice)));
  }
  return files;
}

/// The data set behind the file's own head, where pixels and identifiers are.
std::string pixelsOf(const std::filesystem::path& file) {
  const std::string bytes = tests::contentsOf(file);
  return bytes.substr(bytes.rfind(std::string("\xE0\x7F\x10\x00OW", 6)));
}

class Archive : public testing::Test {
protected:
  static void SetUpTestSuite() {
    if (!std::filesystem::exists(kOrthanc) || !std::filesystem::exists(kWebPlugin))
      return;
    folder_.emplace();
    dimsePort_ = freePort();
    webPort_ = freePort();
    const std::string store = (*folder_ / "store").string();
    folder_->put("orthanc.json", R"({"Name": "Ward", "DicomAet": "WARD", "DicomCheckCalledAet": true,
      "DicomPort": )" + std::to_string(dimsePort_) +
                                     R"(, "HttpPort": )" + std::to_string(webPort_) +
                                     R"(, "StorageDirectory": ")" + store + R"(", "IndexDirectory": ")" +
                                     store +
                                     R"(", "RemoteAccessAllowed": false, "AuthenticationEnabled": true,
      "RegisteredUsers": {"nurse": ")" +
                                     kArchivePassword + R"("}, "Plugins": [")" + kWebPlugin +
                                     R"("], "DicomWeb": {"Enable": true, "Root": "/dicom-web/"},
      "DicomAlwaysAllowEcho": true, "DicomAlwaysAllowStore": true, "DicomAlwaysAllowFind": true,
      "DicomAlwaysAllowGet": true})");
    archive_.emplace(std::vector<std::string>{kOrthanc, (*folder_ / "orthanc.json").string()});
    Progress quiet;
    for (int tries = 0; tries < 100; ++tries) {
      if (complaint([&] { testArchive(webTo(webPort_), kArchivePassword, quiet); }).empty())
        return;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  static void TearDownTestSuite() {
    archive_.reset();
    folder_.reset();
  }
  void SetUp() override {
    if (folder_)
      return;
    if (std::getenv("CI") != nullptr)
      FAIL() << "there is no Orthanc with its plugin for DICOMweb";
    GTEST_SKIP() << "there is no Orthanc with its plugin for DICOMweb";
  }

  /// What comes back by both ways is what was sent.
  void expectBack() {
    for (const ArchiveConnection& way : {webTo(webPort_), dimseTo(dimsePort_)}) {
      ArchiveQuery query;
      query.patientId = "PID08*";
      query.from = "20240201";
      query.to = "20240331";
      query.studyUid = kArchivedStudy;
      const auto studies = queryArchive(way, kArchivePassword, query, progress_);
      ASSERT_THAT(studies, SizeIs(1));
      EXPECT_EQ(studies[0].patientName, "M\xC3\xBCller^Jane");
      EXPECT_EQ(studies[0].patientId, "PID0815");
      EXPECT_EQ(studies[0].date, "20240301");
      EXPECT_EQ(studies[0].description, "Abdomen");
      ASSERT_THAT(studies[0].series, SizeIs(1));
      EXPECT_EQ(studies[0].series[0].modality, "CT");
      EXPECT_EQ(studies[0].series[0].description, "Abdomen 5.0");
      const std::filesystem::path into = own_ / ("got" + std::to_string(++fetched_));
      const auto files = retrieveSeries(way, kArchivePassword, studies[0].studyUid,
                                        studies[0].series[0].seriesUid, into, progress_);
      ASSERT_THAT(files, SizeIs(8));
      for (int k = 0; k < 8; ++k) {
        const auto file = into / ("1.2.840.4711.7.1." + std::to_string(k + 1) + ".dcm");
        EXPECT_EQ(pixelsOf(file), pixelsOf(own_ / ("slice" + std::to_string(k)))) << file;
        EXPECT_THAT(tests::contentsOf(file), HasSubstr("M\xFCller^Jane"));
      }
    }
  }

  static std::optional<tests::TemporaryFolder> folder_;
  static std::optional<Background> archive_;
  static int dimsePort_, webPort_;
  tests::TemporaryFolder own_;
  Progress progress_;
  int fetched_ = 0;
};

std::optional<tests::TemporaryFolder> Archive::folder_;
std::optional<Background> Archive::archive_;
int Archive::dimsePort_ = 0;
int Archive::webPort_ = 0;

TEST_F(Archive, GivesBackWhatCStoreBrought) {
  testArchive(dimseTo(dimsePort_), {}, progress_);
  sendToArchive(dimseTo(dimsePort_), {}, madeSeries(own_), progress_);
  expectBack();
}

TEST_F(Archive, GivesBackWhatStowBrought) {
  sendToArchive(webTo(webPort_), kArchivePassword, madeSeries(own_), progress_);
  expectBack();
}

TEST_F(Archive, SaysThatPasswordOrTitleIsWrong) {
  EXPECT_THAT(complaint([&] { testArchive(webTo(webPort_), "wrong", progress_); }),
              HasSubstr("refuses the user name or the password"));
  ArchiveConnection other = dimseTo(dimsePort_);
  other.calledTitle = "KITCHEN";
  EXPECT_THAT(complaint([&] { testArchive(other, {}, progress_); }), HasSubstr("it is called KITCHEN"));
}

TEST_F(Archive, KeepsNothingOfASeriesThatDoesNotFitOnTheDisk) {
  sendToArchive(dimseTo(dimsePort_), {}, madeSeries(own_), progress_);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const ArchiveConnection& way : {webTo(webPort_), dimseTo(dimsePort_)}) {
    const rlimit small{3000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string said = complaint([&] {
      retrieveSeries(way, kArchivePassword, kArchivedStudy, "1.2.840.4711.7.1", own_ / "full", progress_);
    });
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(said, HasSubstr("Is the disk full?"));
    for (const auto& entry : std::filesystem::directory_iterator(own_.path()))
      EXPECT_THAT(entry.path().filename().string(), testing::StartsWith("slice"));
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(Archive, LeavesNothingOfACancelledRetrieval) {
  sendToArchive(dimseTo(dimsePort_), {}, madeSeries(own_), progress_);
  for (const ArchiveConnection& way : {webTo(webPort_), dimseTo(dimsePort_)}) {
    std::atomic<Progress*> job = nullptr;
    Progress stopped([&](double, const Text& step) {
      if (step.english() != "Ask the archive Ward")
        job.load()->cancel();
    });
    job = &stopped;
    EXPECT_THROW(
        retrieveSeries(way, kArchivePassword, kArchivedStudy, "1.2.840.4711.7.1", own_ / "part", stopped),
        Cancelled);
    for (const auto& entry : std::filesystem::directory_iterator(own_.path()))
      EXPECT_THAT(entry.path().filename().string(), testing::StartsWith("slice"));
  }
}

TEST_F(Archive, SaysThatThereIsNoSuchSeries) {
  for (const ArchiveConnection& way : {webTo(webPort_), dimseTo(dimsePort_)})
    EXPECT_THAT(complaint([&] {
                  retrieveSeries(way, kArchivePassword, "1.2.99", "1.2.99.1", own_ / "none", progress_);
                }),
                HasSubstr("no such series"));
  EXPECT_FALSE(std::filesystem::exists(own_ / "none"));
}

TEST(BrokenArchive, SaysThatNobodyListens) {
  Progress progress;
  const int port = freePort();
  for (const ArchiveConnection& way : {webTo(port), dimseTo(port)})
    EXPECT_THAT(complaint([&] { testArchive(way, {}, progress); }), HasSubstr("cannot be reached"));
}

TEST(BrokenArchive, SaysThatTheConnectionWasCut) {
  Progress progress;
  const tests::TemporaryFolder folder;
  const CuttingServer server(
      "HTTP/1.1 200 OK\r\nContent-Type: multipart/related; boundary=x\r\n"
      "Content-Length: 100000\r\n\r\n--x\r\nContent-Type: application/dicom\r\n\r\nDICM");
  for (const ArchiveConnection& way : {webTo(server.port()), dimseTo(server.port())}) {
    EXPECT_THAT(complaint([&] { retrieveSeries(way, {}, "1.2", "1.3", folder / "cut", progress); }),
                HasSubstr("was cut"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(BrokenArchive, SaysThatNoAnswerComes) {
  Progress progress;
  Listener listener;
  ::listen(listener.descriptor, 4); // The system connects, nobody answers.
  for (ArchiveConnection way : {webTo(listener.port), dimseTo(listener.port)}) {
    way.patienceSeconds = 1;
    EXPECT_THAT(complaint([&] { testArchive(way, {}, progress); }), HasSubstr("does not answer"));
  }
}

TEST(BrokenArchive, SaysThatItIsNoArchive) {
  Progress progress;
  const CuttingServer server("HTTP/1.1 200 OK\r\nContent-Length: 6\r\n\r\n<html>");
  EXPECT_THAT(complaint([&] { testArchive(webTo(server.port()), {}, progress); }), HasSubstr("is not DICOM"));
}

TEST(BrokenArchive, SaysThatTheCertificateIsNotTrusted) {
  const std::string openssl = "/usr/bin/openssl";
  if (!std::filesystem::exists(openssl))
    GTEST_SKIP() << "there is no openssl";
  const tests::TemporaryFolder folder;
  const std::string key = (folder / "key.pem").string(), certificate = (folder / "own.pem").string();
  test::runProcess({openssl, "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1",
                    "-nodes", "-keyout", key, "-out", certificate, "-subj", "/CN=127.0.0.1", "-addext",
                    "subjectAltName=IP:127.0.0.1", "-days", "2"});
  const int port = freePort();
  const Background server({openssl, "s_server", "-accept", "127.0.0.1:" + std::to_string(port), "-key", key,
                           "-cert", certificate, "-www", "-quiet"});
  Progress progress;
  ArchiveConnection web = webTo(port), dimse = dimseTo(port);
  web.address = webAddress(port, "https");
  dimse.tls = true;
  std::string said = "cannot be reached";
  for (int tries = 0; tries < 50 && said.find("cannot be reached") != std::string::npos; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    said = complaint([&] { testArchive(web, {}, progress); });
  }
  EXPECT_THAT(said, HasSubstr("is not trusted"));
  EXPECT_THAT(complaint([&] { testArchive(dimse, {}, progress); }), HasSubstr("is not trusted"));
  web.certificates = certificate; // Now it is; what answers is a page for people.
  EXPECT_THAT(complaint([&] { testArchive(web, {}, progress); }), HasSubstr("is not DICOM"));
}

TEST(ArchiveConnections, AreKeptWithoutAPassword) {
  const tests::TemporaryFolder folder;
  const auto file = folder / "deeper/archives.json";
  EXPECT_THAT(readArchiveConnections(file), SizeIs(0));
  ArchiveConnection dimse = dimseTo(11112);
  dimse.tls = true;
  writeArchiveConnections(file, {webTo(8042), dimse});
  const auto read = readArchiveConnections(file);
  ASSERT_THAT(read, SizeIs(2));
  EXPECT_EQ(read[0].address, webAddress(8042));
  EXPECT_EQ(read[0].user, "nurse");
  EXPECT_EQ(read[1].kind, ArchiveKind::dimse);
  EXPECT_EQ(read[1].port, 11112);
  EXPECT_EQ(read[1].calledTitle, "WARD");
  EXPECT_TRUE(read[1].tls);
  EXPECT_THAT(tests::contentsOf(file), testing::Not(HasSubstr("assword")));
  folder.put("broken.json", R"({"connections": [{"kind": 3}]})");
  EXPECT_THROW(readArchiveConnections(folder / "broken.json"), DataError);
}

TEST(ArchiveConnections, MustBePossible) {
  ArchiveConnection web = webTo(80);
  web.address = "ftp://archive";
  EXPECT_THROW(checkArchiveConnection(web), UsageError);
  web.address = "https://nurse:secret@archive";
  EXPECT_THROW(checkArchiveConnection(web), UsageError);
  ArchiveConnection dimse = dimseTo(0);
  EXPECT_THROW(checkArchiveConnection(dimse), UsageError);
  dimse.port = 104;
  dimse.calledTitle = "LONGER THAN SIXTEEN";
  EXPECT_THROW(checkArchiveConnection(dimse), UsageError);
}

} // namespace
} // namespace viscera::clinic
