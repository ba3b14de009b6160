#include <csignal>
#include <thread>

#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page_markup.h"
#include "report_scene.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/report/report_file.h"

namespace viscera::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kHostile = "<script>alert('x')</script>\"&\x07";

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// Many rows, and names as a hostile file may have them.
report::Report longReport(int rows) {
  report::Report report{kHostile, "Made by Viscera", {{"", {}}, {kHostile, {}}}};
  report::Table table{{"Organ", "Volume"}, {}, {false, true}};
  for (int i = 0; i < rows; ++i)
    table.rows.push_back({kHostile, std::to_string(i)});
  report.sections.back().blocks = {report::Paragraph{kHostile}, table};
  return report;
}

TEST(ReportFile, HtmlHoldsEverythingAndTakesNoNameForMarkup) {
  ReportedSession session({kHostile});
  const std::string html = report::htmlOf(session.report(session.source()));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&quot;&amp;"));
  EXPECT_EQ(countOf(html, "src=\"data:image/png;base64,"), 7);
  EXPECT_EQ(countOf(html, "src="), 7);
  EXPECT_EQ(countOf(html, "://"), 0) << "nothing is fetched";
  EXPECT_THAT(html, Not(HasSubstr("\x07")));
}

/// Pictures are letters at random, in which any short word may stand.
std::string withoutPictures(std::string html) {
  const std::string begin = "base64,";
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at + begin.size()))
    html.erase(at + begin.size(), html.find('"', at) - at - begin.size());
  return html;
}

TEST(ReportFile, NothingSaysWhereFilesLie) {
  ReportedSession session;
  document::Organ organ = *session.document.organs().front();
  organ.file = "/home/ann/Smith John 1956/liver.stl";
  organ.warnings = {"/home/ann/Smith John 1956/liver.stl: its axes are taken for LPS",
                    "repaired on import: close-holes"};
  document::DocumentState state = session.document.state();
  state.organs = std::make_shared<document::OrganList>(
      document::OrganList{std::make_shared<const document::Organ>(organ)});
  report::ReportSource source = session.source();
  source.state = state;
  source.file = "/home/ann/Smith John 1956/case.viscera";
  source.notes = {"/home/ann/Smith John 1956/liver.stl: it was moved"};
  const std::string html = withoutPictures(report::htmlOf(session.report(source)));
  EXPECT_THAT(html, HasSubstr("liver.stl: its axes are taken for LPS; repaired on import: close-holes"));
  EXPECT_THAT(html, HasSubstr("case.viscera"));
  for (const char* secret : {"/home", "ann", "Smith", "1956"})
    EXPECT_EQ(countOf(html, secret), 0) << secret;
}

TEST(ReportFile, PdfHasItsPagesInA4AndItsTitle) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "r.pdf";
  EXPECT_EQ(report::writeReport(file, longReport(3)), 1);
  const int pages = report::writeReport(file, longReport(150));
  EXPECT_GT(pages, 2);
  const std::string pdf = contentsOf(file);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_EQ(countOf(pdf, "/Type /Page\n"), pages);
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 59"));
  EXPECT_THAT(pdf, HasSubstr("/Title"));
}

/// The window writes reports on threads that are not Qt's.
TEST(ReportFile, PdfIsWrittenInSilenceOnAnyThread) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  std::thread worker([&] { report::writeReport(folder / "r.pdf", longReport(40)); });
  worker.join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// As on a full disk: files of this program end at so many bytes while it lives.
class ShortFiles {
public:
  explicit ShortFiles(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit shorter{bytes, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &shorter);
  }
  ~ShortFiles() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }
  ShortFiles(const ShortFiles&) = delete;
  ShortFiles& operator=(const ShortFiles&) = delete;

private:
  rlimit limit_ = {};
  void (*before_)(int);
};

TEST(ReportFile, ThatFindsNoRoomLeavesTheOldReport) {
  const TemporaryFolder folder;
  for (const char* name : {"r.pdf", "r.html"}) {
    report::writeReport(folder / name, longReport(3));
    const std::string before = contentsOf(folder / name);
    {
      const ShortFiles full(2000);
      EXPECT_THROW(report::writeReport(folder / name, longReport(150)), CannotCreateError) << name;
    }
    EXPECT_TRUE(contentsOf(folder / name) == before) << name;
    std::filesystem::remove(folder / name);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << name;
  }
}

TEST(ReportFile, OfAnotherEndingOrInNoFolderIsRefusedAndLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(report::writeReport(folder / "r.docx", longReport(1)), UsageError);
  EXPECT_THROW(report::writeReport(folder / "no/r.pdf", longReport(1)), CannotCreateError);
  EXPECT_THROW(report::writeReport(folder / "no/r.html", longReport(1)), CannotCreateError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
} // namespace viscera::tests
