#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/error.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

/// Sets an environment variable for one test.
class Environment {
public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name))
      before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (before_.empty())
      ::unsetenv(name_);
    else
      ::setenv(name_, before_.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  std::string before_;
};

} // namespace

TEST(SampleLibrary, OfTheBuildHasTheProjectsOrgans) {
  const std::vector<std::string> names = sample_organs::sampleNames(sample_organs::standardLibrary());
  const std::vector<std::string> expected = {
      "digestive_system", "heart", "kidney_left", "kidney_right", "liver", "stomach", "stomach_and_bowel"};
  EXPECT_EQ(names, expected);
}

TEST(SampleLibrary, CanBeChosenByTheEnvironment) {
  TemporaryLibrary files;
  files.writeRoot("ball", kBall);
  const Environment chosen("VISCERA_SAMPLE_ORGANS", files.library().definitions.string());
  EXPECT_EQ(sample_organs::sampleNames(sample_organs::standardLibrary()), std::vector<std::string>{"ball"});
}

TEST(SampleLibrary, KeepsItsCacheWhereTheUserWantsIt) {
  const Environment chosen("XDG_CACHE_HOME", "/somewhere/else");
  EXPECT_EQ(sample_organs::standardLibrary().cache, "/somewhere/else/viscera/organs");
}

TEST(SampleLibrary, ThatIsNotThereIsNamed) {
  try {
    sample_organs::sampleNames({"/not/there", {}});
    FAIL() << "no error";
  } catch (const NoInputError& error) {
    EXPECT_NE(std::string(error.what()).find("/not/there"), std::string::npos);
  }
}

TEST(Resolutions, HaveNamesThatReadBack) {
  for (const auto resolution :
       {sample_organs::Resolution::low, sample_organs::Resolution::medium, sample_organs::Resolution::high})
    EXPECT_EQ(sample_organs::resolutionFromName(sample_organs::nameOf(resolution)), resolution);
  EXPECT_THROW(sample_organs::resolutionFromName("huge"), UsageError);
}

} // namespace viscera::tests
