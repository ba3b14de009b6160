#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "orthanc.h"
#include "run_process.h"
#include "viscera/clinic/archive.h"
#include "viscera/clinic/key_ring.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/archive_origin.h"

/// A real archive (Orthanc) on this machine: what goes in comes back, and each broken connection is told in
/// a sentence and leaves nothing.
namespace viscera::clinic {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

using tests::Background;
using tests::dimseTo;
using tests::freePort;
using tests::kArchivedSeries;
using tests::kArchivedStudy;
using tests::kArchivePassword;
using tests::Listener;
using tests::madeSeries;
using tests::orthancIsThere;
using tests::webAddress;
using tests::webTo;

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

/// The data set behind the file's own head, where pixels and identifiers are.
std::string pixelsOf(const std::filesystem::path& file) {
  const std::string bytes = tests::contentsOf(file);
  return bytes.substr(bytes.rfind(std::string("\xE0\x7F\x10\x00OW", 6)));
}

class Archive : public testing::Test {
protected:
  void SetUp() override {
    if (!orthancIsThere() && std::getenv("CI") == nullptr)
      GTEST_SKIP() << "there is no Orthanc with its plugin for DICOMweb";
    ASSERT_TRUE(orthancIsThere()) << "continuous integration must have Orthanc and its plugin for DICOMweb";
    archive_.emplace();
    ASSERT_TRUE(archive_->answers());
  }
  ArchiveConnection web() const { return webTo(archive_->webPort); }
  ArchiveConnection dimse() const { return dimseTo(archive_->dimsePort); }

  /// What comes back by one way is what was sent.
  void expectBack(const ArchiveConnection& way, const std::string& study = kArchivedStudy) {
    ArchiveQuery query;
    query.patientId = "PID08*";
    query.from = "20240201";
    query.to = "20240331";
    query.studyUid = study;
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
      const auto file = into / (study + ".1." + std::to_string(k + 1) + ".dcm");
      EXPECT_EQ(pixelsOf(file), pixelsOf(own_ / ("slice" + std::to_string(k)))) << file;
      EXPECT_THAT(tests::contentsOf(file), HasSubstr("M\xFCller^Jane"));
    }
    const auto origin = medical_io::readArchiveOrigin(into);
    ASSERT_TRUE(origin);
    EXPECT_EQ(origin->archive, "Ward");
    EXPECT_EQ(origin->seriesUid, study + ".1");
    query.patientId = "PID09*";
    EXPECT_THAT(queryArchive(way, kArchivePassword, query, progress_), SizeIs(0));
  }

  /// Nothing but the slices that were sent is in the folder of the test.
  void expectNothingKept() const {
    for (const auto& entry : std::filesystem::directory_iterator(own_.path()))
      EXPECT_THAT(entry.path().filename().string(), testing::StartsWith("slice"));
  }

  std::string fetching(const ArchiveConnection& way, Progress& progress, const std::string& series) const {
    return complaint(
        [&] { retrieveSeries(way, kArchivePassword, kArchivedStudy, series, own_ / "part", progress); });
  }

  std::optional<tests::Orthanc> archive_;
  tests::TemporaryFolder own_;
  Progress progress_;
  int fetched_ = 0;
};

TEST_F(Archive, GivesBackWhatCStoreAndStowBrought) {
  testArchive(dimse(), {}, progress_);
  sendToArchive(dimse(), {}, madeSeries(own_), progress_);
  expectBack(web());
  expectBack(dimse());
  sendToArchive(web(), kArchivePassword, madeSeries(own_, "1.2.840.4711.8"), progress_);
  expectBack(dimse(), "1.2.840.4711.8");
  // A study has each of its series in a folder; what was there gives way.
  const auto study = own_ / "study";
  std::filesystem::create_directory(study);
  EXPECT_THROW(retrieveStudy(web(), kArchivePassword, kArchivedStudy, study, progress_), CannotCreateError);
  own_.put("study/old", "");
  EXPECT_EQ(retrieveStudy(web(), kArchivePassword, kArchivedStudy, study, progress_, Existing::replace), 8U);
  EXPECT_TRUE(std::filesystem::exists(study / kArchivedSeries / medical_io::kArchiveOriginFile));
  EXPECT_FALSE(std::filesystem::exists(study / "old"));
  // The password is in no file that was written.
  for (const auto& entry : std::filesystem::recursive_directory_iterator(own_.path()))
    if (entry.is_regular_file()) {
      EXPECT_THAT(tests::contentsOf(entry.path()), testing::Not(HasSubstr(kArchivePassword)));
    }
}

TEST_F(Archive, SaysWhatIsWrongAndKeepsNothing) {
  sendToArchive(dimse(), {}, madeSeries(own_), progress_);
  EXPECT_THAT(complaint([&] { testArchive(web(), "wrong", progress_); }),
              HasSubstr("refuses the user name or the password"));
  ArchiveConnection other = dimse();
  other.calledTitle = "KITCHEN";
  EXPECT_THAT(complaint([&] { testArchive(other, {}, progress_); }), HasSubstr("it is called KITCHEN"));
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const ArchiveConnection& way : {web(), dimse()}) {
    EXPECT_THAT(fetching(way, progress_, "1.2.99.1"), HasSubstr("no such series"));
    expectNothingKept();
    const rlimit small{3000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string said = fetching(way, progress_, kArchivedSeries);
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(said, HasSubstr("Is the disk full?"));
    expectNothingKept();
    std::atomic<Progress*> job = nullptr;
    Progress stopped([&](double, const Text& step) {
      if (step.english() != "Ask the archive Ward")
        job.load()->cancel();
    });
    job = &stopped;
    EXPECT_THROW(
        retrieveSeries(way, kArchivePassword, kArchivedStudy, kArchivedSeries, own_ / "part", stopped),
        Cancelled);
    expectNothingKept();
  }
  std::signal(SIGXFSZ, handler);
}

TEST(BrokenArchive, SaysThatNobodyListens) {
  Progress progress;
  const int port = freePort();
  for (const ArchiveConnection& way : {webTo(port), dimseTo(port)})
    EXPECT_THAT(complaint([&] { testArchive(way, {}, progress); }), HasSubstr("cannot be reached"));
}

TEST(BrokenArchive, SaysThatTheAddressIsUnknown) {
  Progress progress;
  ArchiveConnection web = webTo(80), dimse = dimseTo(104);
  // A name that no network can have, so that none is asked; and no proxy, which would answer.
  const std::string host = std::string(70, 'a') + ".invalid";
  ::setenv("no_proxy", "*", 1);
  web.address = "http://" + host + "/dicom-web";
  dimse.address = host;
  for (const ArchiveConnection& way : {web, dimse})
    EXPECT_THAT(complaint([&] { testArchive(way, {}, progress); }), HasSubstr("not known to the network"));
}

TEST(BrokenArchive, SaysThatThereIsNoTls) {
  Progress progress;
  const CuttingServer server("HTTP/1.1 400 Bad Request\r\n\r\n");
  ArchiveConnection web = webTo(server.port());
  web.address = webAddress(server.port(), "https");
  EXPECT_THAT(complaint([&] { testArchive(web, {}, progress); }), HasSubstr("no secure connection"));
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

TEST(KeyRing, KeepsAPasswordThroughTheProgramOfTheDesktop) {
  const tests::TemporaryFolder folder;
  const std::string script = "#!/bin/sh\n"
                             "cd '" +
                             folder.path().string() +
                             "'\n"
                             "echo \"$@\" >> calls\n"
                             "case $1 in\n"
                             "store) cat > kept ;;\n"
                             "lookup) cat kept ;;\n"
                             "clear) rm kept ;;\n"
                             "esac\n";
  const auto tool = folder.put("secret-tool", script);
  std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH") != nullptr ? std::getenv("PATH") : "";
  ::setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
  ::setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere", 1);
  Progress progress;
  const auto ring = systemKeyRing();
  EXPECT_TRUE(ring->isThere());
  EXPECT_FALSE(ring->find(webTo(80), progress));
  EXPECT_TRUE(ring->keep(webTo(80), kArchivePassword, progress));
  EXPECT_EQ(ring->find(webTo(80), progress), kArchivePassword);
  ring->forget(webTo(80), progress);
  EXPECT_FALSE(ring->find(webTo(80), progress));
  const std::string calls = tests::contentsOf(folder / "calls");
  EXPECT_THAT(calls, HasSubstr("lookup application viscera address " + webAddress(80) + " user nurse"));
  EXPECT_THAT(calls, testing::Not(HasSubstr(kArchivePassword))) << "Everyone sees arguments of programs.";
  ::setenv("PATH", path.c_str(), 1);
  ::unsetenv("DBUS_SESSION_BUS_ADDRESS");
  EXPECT_FALSE(noKeyRing()->find(webTo(80), progress));
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
