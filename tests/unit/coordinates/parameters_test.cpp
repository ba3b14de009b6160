#include "viscera/coordinates/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

std::vector<Parameter> offered() {
  return {{"width", 0.5, 20, 2, "mm", "", false, {}},
          {"layers", 1, 9, 3, "", "", true, {}},
          {"inside", 0, 1, 0, "", "", false, {"mean-value", "harmonic"}}};
}

/// What `setFromText` throws for `name=text`.
UsageError errorOf(const std::string& name, const std::string& text) {
  ParameterValues values;
  try {
    values.setFromText(offered(), name, text);
  } catch (const UsageError& error) {
    return error;
  }
  ADD_FAILURE() << name << "=" << text << " was accepted";
  return UsageError("none");
}

} // namespace

TEST(ParameterValues, GiveTheStandardUntilSet) {
  ParameterValues values;
  EXPECT_EQ(values.get(offered()[0]), 2);
  values.set("width", 7);
  EXPECT_EQ(values.get(offered()[0]), 7);
}

TEST(ParameterValues, ReadNumbersAndChoices) {
  ParameterValues values;
  values.setFromText(offered(), "width", "2.5e0");
  values.setFromText(offered(), "layers", "4");
  values.setFromText(offered(), "inside", "harmonic");
  EXPECT_EQ(values.get(offered()[0]), 2.5);
  EXPECT_EQ(values.get(offered()[1]), 4);
  EXPECT_EQ(values.get(offered()[2]), 1);
}

TEST(ParameterValues, NameWhatIsAllowed) {
  EXPECT_THAT(errorOf("height", "1").tryThis().english(), testing::HasSubstr("width, layers, inside"));
  EXPECT_THAT(errorOf("width", "21").tryThis().english(), testing::HasSubstr("from 0.5 to 20 mm"));
  EXPECT_THAT(errorOf("width", "2mm").tryThis().english(), testing::HasSubstr("a number"));
  EXPECT_THAT(errorOf("width", "").tryThis().english(), testing::HasSubstr("a number"));
  EXPECT_THAT(errorOf("width", "nan").tryThis().english(), testing::HasSubstr("a number"));
  EXPECT_THAT(errorOf("layers", "2.5").tryThis().english(), testing::HasSubstr("a whole number from 1 to 9"));
  EXPECT_THAT(errorOf("inside", "wachspress").tryThis().english(),
              testing::HasSubstr("mean-value, harmonic"));
  EXPECT_EQ(errorOf("inside", "1").exitCode(), 64);
}

TEST(ParameterValues, RefuseUnknownNamesAndValuesOutOfRange) {
  ParameterValues values;
  EXPECT_NO_THROW(values.requireWithin(offered()));
  values.set("layers", 9);
  EXPECT_NO_THROW(values.requireWithin(offered()));
  values.set("layers", 10);
  EXPECT_THROW(values.requireWithin(offered()), UsageError);
  ParameterValues unknown;
  unknown.set("colour", 1);
  EXPECT_THROW(unknown.requireWithin(offered()), UsageError);
  ParameterValues notANumber;
  notANumber.set("width", std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(notANumber.requireWithin(offered()), UsageError);
}

} // namespace viscera::coordinates
