#include <gmock/gmock.h>

#include "cli_test.h"

namespace viscera::app::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Exit code of an archive that cannot be reached.
constexpr int kNotThere = 69;

} // namespace

/// The list of archives, without one that runs; with one it is tested where its functions are.
class ArchiveOnTheCommandLine : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    options_.environment["XDG_CONFIG_HOME"] = path("config");
    options_.environment["VISCERA_ARCHIVE_PASSWORD"] = "s3cret";
  }
};

TEST_F(ArchiveOnTheCommandLine, IsNamedTestedAndForgottenWithoutItsPassword) {
  const json added = runJson({"archive", "add", "--connection", "Ward", "--address",
                              "https://127.0.0.1:9/dicom-web", "--user", "nurse"});
  ASSERT_EQ(added["connections"].size(), 1u);
  EXPECT_EQ(added["connections"][0]["kind"], "dicomweb");
  EXPECT_EQ(added["connections"][0]["user"], "nurse");
  const test::ProcessResult tested = run({"archive", "test", "--connection", "Ward"});
  EXPECT_EQ(tested.exitCode, kNotThere);
  EXPECT_THAT(tested.err, HasSubstr("The archive Ward cannot be reached"));
  EXPECT_THAT(tested.err + contents(path("config/viscera/archives.json")), Not(HasSubstr("s3cret")));
  EXPECT_EQ(run({"archive", "get", "--connection", "Ward"}).exitCode, kUsage);
  EXPECT_EQ(run({"archive", "query", "--connection", "Kitchen"}).exitCode, kUsage);
  EXPECT_EQ(runJson({"archive", "remove", "--connection", "Ward"})["connections"].size(), 0u);
}

} // namespace viscera::app::cli
