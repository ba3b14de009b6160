#include "viscera/sequences/volume_curve.h"

#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

class VolumeCurveFile : public testing::Test {
protected:
  Curve read(const std::string& text, double periodSeconds = 0.8) {
    std::ofstream(file_) << text;
    return readVolumeCurve(file_, periodSeconds);
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const DataError& error) {
      EXPECT_FALSE(error.tryThis().empty()) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "taken: " << text;
    return {};
  }

  // A folder of its own: several tests run at a time, each in a process of its own.
  const tests::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "volume_curve.csv";
};

TEST_F(VolumeCurveFile, HoldsFractionsOfTheCycleWithOrWithoutAHeader) {
  for (const char* header : {"", "fraction,volume_ml\n", "# of a ventricle\n\n"}) {
    const Curve curve = read(std::string(header) + "0,130.5\n0.4;55\r\n0.7\t90\n");
    EXPECT_EQ(curve.at(0), 130.5);
    EXPECT_EQ(curve.at(0.4), 55);
    EXPECT_EQ(curve.at(1.7), 90) << "every cycle is the same";
  }
}

TEST_F(VolumeCurveFile, TakesDecimalCommasBetweenSemicolonsOrTabs) {
  for (const char* rows :
       {"time_s;LV_ml\n0;130,5\n0,4;55,25\n0,8;130,5\n", "time_s\tLV_ml\n0\t130,5\n0,4\t55,25\n"}) {
    const Curve curve = read(rows);
    EXPECT_EQ(curve.at(0), 130.5);
    EXPECT_NEAR(curve.at(0.5), 55.25, 1e-9);
  }
  EXPECT_THAT(refusal("0;130,5,2\n"), testing::HasSubstr("not a number"));
}

TEST_F(VolumeCurveFile, TakesSecondsUnderAHeaderThatSaysSo) {
  const Curve curve = read("time_s,LV_ml\n0,130\n0.4,55\n0.8,130\n");
  EXPECT_NEAR(curve.at(0.5), 55, 1e-9);
  EXPECT_NEAR(curve.at(1), 130, 1e-9);
}

TEST_F(VolumeCurveFile, TakesSecondsBehindAByteOrderMarkAndInCapitals) {
  for (const char* header :
       {"\xEF\xBB\xBFtime_s,LV_ml\n", "Time (s),LV (ml)\n", "\xEF\xBB\xBF\"TIME\";LV\n"}) {
    const Curve curve = read(std::string(header) + "0;130\n0.4;55\n0.8;130\n");
    EXPECT_NEAR(curve.at(0.5), 55, 1e-9) << header;
  }
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "0,130\n0.4,55\n")
                .at(0.4),
            55);
  EXPECT_EQ(read("Phase,ml\n0,130\n0.4,55\n").at(0.4), 55);
}

TEST_F(VolumeCurveFile, RefusesAHeadingThatDoesNotSayWhatInstantsAre) {
  for (const char* header : {"t,LV_ml\n", "Zeit;ml\n", "x\ty\n"})
    EXPECT_THAT(refusal(std::string(header) + "0;130\n0.4;55\n"), testing::HasSubstr("line 1")) << header;
}

TEST(VolumeCurveOfASession, RefusesKeysThatAreNoVolumes) {
  EXPECT_EQ(volumeCurve({{0, 100}, {0.5, 60}}).at(0.5), 60);
  EXPECT_EQ(volumeCurve({{0, 100}, {0.5, 60}}).at(1), 100);
  EXPECT_THROW(volumeCurve({}), DataError);
  EXPECT_THROW(volumeCurve({{0, 100}, {0.5, -1}}), DataError);
  EXPECT_THROW(volumeCurve({{0, 100}, {1.5, 1}}), DataError);
  EXPECT_THROW(volumeCurve({{0.5, 100}, {0.5, 90}}), DataError);
  EXPECT_THROW(volumeCurve({{0, std::numeric_limits<double>::quiet_NaN()}}), DataError);
}

TEST_F(VolumeCurveFile, SaysWhichLineIsWrong) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal(""), HasSubstr("no volume"));
  EXPECT_THAT(refusal("0,130\n0.5\n"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("time_s,Heart_ml,LV_ml\n"), HasSubstr("3 columns"));
  EXPECT_THAT(refusal("0,130\n0.5,many\n"), HasSubstr("not a number"));
  EXPECT_THAT(refusal("0,130\n0.5,60\n0.4,70\n"), HasSubstr("line 3"));
  EXPECT_THAT(refusal("0,130\n1.2,60\n"), HasSubstr("outside the cycle"));
  EXPECT_THAT(refusal("0,130\n0.5,-60\n"), HasSubstr("not positive"));
  EXPECT_THAT(refusal("0,130\n1,60\n"), HasSubstr("differs from the volume at its start"));
  EXPECT_THROW(readVolumeCurve("/nowhere/at/all.csv", 1), NoInputError);
}

} // namespace
} // namespace viscera::sequences
