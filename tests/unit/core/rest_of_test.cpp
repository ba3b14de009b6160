#include <fstream>
#include <ios>
#include <istream>
#include <sstream>
#include <streambuf>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viscera/core/error.h"
#include "viscera/core/text.h"

namespace viscera {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Has one line, and fails as a file of a lost disk does when more is read.
class LostDisk final : public std::streambuf {
public:
  LostDisk() { setg(line_.data(), line_.data(), line_.data() + line_.size()); }

protected:
  int_type underflow() override { throw std::ios_base::failure("error reading the file"); }

private:
  std::string line_ = "first line\n";
};

TEST(RestOf, AStreamIsEverythingFromItsPlaceOn) {
  const std::string longText = std::string(200'000, 'x') + '\0' + "end";
  std::istringstream whole(longText), rest("name: liver"), empty("");
  EXPECT_EQ(restOf(whole, "a.txt"), longText);
  std::string name;
  rest >> name;
  EXPECT_EQ(restOf(rest, "a.txt"), " liver");
  EXPECT_EQ(restOf(empty, "a.txt"), "");
}

TEST(RestOf, AFileThatIsNotThereIsNothing) {
  std::ifstream stream("/nowhere/a.txt");
  EXPECT_EQ(restOf(stream, "a.txt"), "");
}

TEST(RestOf, AStreamThatFailsIsAnErrorAndNoShorterText) {
  LostDisk disk;
  std::istream stream(&disk);
  try {
    restOf(stream, "/media/disk/case.viscera");
    FAIL() << "it was taken for a shorter file";
  } catch (const NoInputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("/media/disk/case.viscera"), HasSubstr("read to its end")));
  }
}

TEST(RestOf, LinesOfAStreamThatFailsAreAnErrorToo) {
  LostDisk disk;
  std::istream stream(&disk);
  std::string line;
  ASSERT_TRUE(std::getline(stream, line));
  EXPECT_NO_THROW(requireReadToEnd(stream, "curve.csv"));
  EXPECT_FALSE(std::getline(stream, line));
  EXPECT_THROW(requireReadToEnd(stream, "curve.csv"), NoInputError);
  std::istringstream good("1\n2");
  while (std::getline(good, line)) {
  }
  EXPECT_NO_THROW(requireReadToEnd(good, "curve.csv"));
}

} // namespace
} // namespace viscera
