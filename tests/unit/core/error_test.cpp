#include "viscera/core/error.h"

#include <cerrno>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include <gtest/gtest.h>

namespace viscera {

TEST(Error, JoinsWhereWhatAndWhatToTry) {
  const DataError error("the file is truncated", "liver.stl", "export it again");
  EXPECT_STREQ(error.what(), "liver.stl: The file is truncated (export it again)");
  EXPECT_EQ(error.problem().english(), "The file is truncated");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(UsageError("no such system").what(), "No such system");
}

TEST(Error, LeavesWhatIsNoSmallLetterAsItIs) {
  EXPECT_STREQ(DataError("\"keys\" is missing").what(), "\"keys\" is missing");
  EXPECT_STREQ(DataError("3 handles are too few").what(), "3 handles are too few");
  EXPECT_STREQ(DataError("\u0151si betegs\u00e9g").what(), "\u0151si betegs\u00e9g")
      << "no byte of another letter";
  EXPECT_STREQ(DataError("").what(), "");
}

TEST(Error, BeginsWithACapitalOfAnotherLanguage) {
  EXPECT_STREQ(DataError("\u00e4u\u00dfere Form").what(), "\u00c4u\u00dfere Form");
  EXPECT_STREQ(DataError("\u00f7 is no letter").what(), "\u00f7 is no letter");
}

TEST(Error, CarriesTheExitCodesOfSysexits) {
  EXPECT_EQ(UsageError("").exitCode(), 64);
  EXPECT_EQ(DataError("").exitCode(), 65);
  EXPECT_EQ(NoInputError("").exitCode(), 66);
  EXPECT_EQ(CannotCreateError("").exitCode(), 73);
  EXPECT_EQ(Cancelled().exitCode(), 130);
}

TEST(ShortMemory, IsReportedByEveryExceptionOfTheStandardLibraryThatMeansIt) {
  EXPECT_TRUE(reportsShortMemory(std::bad_alloc()));
  EXPECT_TRUE(reportsShortMemory(std::bad_array_new_length()));
  EXPECT_TRUE(reportsShortMemory(std::length_error("vector::_M_default_append")));
  EXPECT_TRUE(reportsShortMemory(std::system_error(ENOMEM, std::generic_category())));
  EXPECT_TRUE(reportsShortMemory(std::system_error(EAGAIN, std::system_category()))) << "as a thread does";
  EXPECT_TRUE(
      reportsShortMemory(std::runtime_error("pthread_create has failed: Resource temporarily unavailable")));
  EXPECT_FALSE(reportsShortMemory(std::out_of_range("vector::_M_range_check")));
  EXPECT_FALSE(reportsShortMemory(DataError("the file is truncated")));
  EXPECT_FALSE(reportsShortMemory(
      std::filesystem::filesystem_error("status", "a.stl", std::make_error_code(std::errc::io_error))));
}

TEST(ShortMemory, IsExplainedInPlainWords) {
  EXPECT_EQ(explanationOf(std::bad_alloc()).english(), notEnoughMemory().what());
  EXPECT_EQ(explanationOf(std::bad_alloc()).english().find("bad_alloc"), std::string::npos);
  EXPECT_EQ(explanationOf(std::out_of_range("row 7 of 5")).english(), "row 7 of 5");
}

TEST(ShortMemory, BecomesAnErrorThatNamesWhatNeedsTheMemory) {
  EXPECT_EQ(explainingShortMemory("liver.stl", [] { return 7; }), 7);
  try {
    explainingShortMemory("liver.stl", [] { throw std::bad_alloc(); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().english(), "liver.stl");
    EXPECT_EQ(error.problem().english(), "There is not enough memory");
    EXPECT_EQ(error.exitCode(), 70);
  }
  EXPECT_THROW(explainingShortMemory("liver.stl", [] { throw DataError("torn"); }), DataError);
  EXPECT_THROW(explainingShortMemory("liver.stl", [] { throw std::out_of_range("7"); }), std::out_of_range);
}

} // namespace viscera
