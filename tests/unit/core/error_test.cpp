#include "viscera/core/error.h"

#include <gtest/gtest.h>

namespace viscera {

TEST(Error, JoinsWhereWhatAndWhatToTry) {
  const DataError error("the file is truncated", "liver.stl", "export it again");
  EXPECT_STREQ(error.what(), "liver.stl: The file is truncated (export it again)");
  EXPECT_EQ(error.problem(), "The file is truncated");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(UsageError("no such system").what(), "No such system");
}

TEST(Error, LeavesWhatIsNoSmallLetterAsItIs) {
  EXPECT_STREQ(DataError("\"keys\" is missing").what(), "\"keys\" is missing");
  EXPECT_STREQ(DataError("3 handles are too few").what(), "3 handles are too few");
  EXPECT_STREQ(DataError("\u00e4u\u00dfere Form").what(), "\u00e4u\u00dfere Form")
      << "no byte of another letter";
  EXPECT_STREQ(DataError("").what(), "");
}

TEST(Error, CarriesTheExitCodesOfSysexits) {
  EXPECT_EQ(UsageError("").exitCode(), 64);
  EXPECT_EQ(DataError("").exitCode(), 65);
  EXPECT_EQ(NoInputError("").exitCode(), 66);
  EXPECT_EQ(CannotCreateError("").exitCode(), 73);
  EXPECT_EQ(Cancelled().exitCode(), 130);
}

} // namespace viscera
