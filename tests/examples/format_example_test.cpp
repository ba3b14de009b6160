#include <gtest/gtest.h>

#include "file_bytes.h"
#include "plain_format.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {

TEST(DeveloperGuide, ItsFormatIsReadAndNamesTheLineThatIsWrong) {
  const RawSurface surface = readPlain({"t.plain", "3 1\n0 0 0\n1 0 0\n0 1 0\n0 1 2\n"});
  EXPECT_EQ(surface.pointCount(), 3u);
  EXPECT_EQ(surface.polygonCount(), 1u);
  try {
    readPlain({"t.plain", "3 1\n0 0 0\n1 zero 0\n0 1 0\n0 1 2\n"});
    FAIL() << "a word is no number";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("Line 3"), std::string::npos) << error.what();
  }
}

TEST(DeveloperGuide, ItsFormatRefusesACountThatTheFileCannotHold) {
  EXPECT_THROW(readPlain({"t.plain", "999999999 1\n0 0 0\n"}), DataError);
}

} // namespace viscera::medical_io
