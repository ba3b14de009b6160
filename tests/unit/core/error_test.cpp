#include "viscera/core/error.h"

#include <gtest/gtest.h>

namespace viscera {

TEST(Error, JoinsWhereWhatAndWhatToTry) {
  const DataError error("the file is truncated", "liver.stl", "export it again");
  EXPECT_STREQ(error.what(), "liver.stl: the file is truncated (export it again)");
  EXPECT_EQ(error.problem(), "the file is truncated");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(UsageError("no such system").what(), "no such system");
}

TEST(Error, CarriesTheExitCodesOfSysexits) {
  EXPECT_EQ(UsageError("").exitCode(), 64);
  EXPECT_EQ(DataError("").exitCode(), 65);
  EXPECT_EQ(NoInputError("").exitCode(), 66);
  EXPECT_EQ(CannotCreateError("").exitCode(), 73);
  EXPECT_EQ(Cancelled().exitCode(), 130);
}

} // namespace viscera
