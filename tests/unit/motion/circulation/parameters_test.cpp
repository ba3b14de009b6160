#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.h"
#include "viscera/circulation/parameters.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"

namespace viscera::circulation {

TEST(CirculationParameters, EachHasARangeAroundItsDefaultAUnitAndASource) {
  std::set<std::string> names;
  for (const ParameterInfo& info : parameterInfos()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_LE(info.lowest, info.rest) << info.name;
    EXPECT_LE(info.rest, info.highest) << info.name;
    EXPECT_FALSE(info.title.empty() || info.source.empty() || info.unit.empty()) << info.name;
    EXPECT_EQ(parameter(Parameters(), info.name), info.rest);
  }
}

TEST(CirculationParameters, TableInTheDocumentationIsTheProgramsOwn) {
  std::ifstream file(VISCERA_SOURCE_DIR "/docs/circulation.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(page, testing::HasSubstr(parameterTable()));
}

TEST(CirculationParameters, EachNameSetsAMemberOfItsOwn) {
  Parameters parameters;
  for (const ParameterInfo& info : parameterInfos())
    setParameter(parameters, info.name, info.lowest + 0.25 * (info.highest - info.lowest));
  for (const ParameterInfo& info : parameterInfos())
    EXPECT_EQ(parameter(parameters, info.name), info.lowest + 0.25 * (info.highest - info.lowest))
        << info.name;
}

TEST(CirculationParameters, UnknownNameIsRefusedWithTheNearestOne) {
  Parameters parameters;
  try {
    setParameter(parameters, "lvEse", 2);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("lvEes"));
  }
}

TEST(CirculationParameters, ValuesOutOfRangeAreRefusedWithTheRange) {
  Parameters parameters;
  for (const double value : {5.0, 1000.0, std::nan("")}) {
    try {
      setParameter(parameters, "rate", value);
      FAIL() << value;
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("30 to 200"));
    }
  }
  EXPECT_EQ(parameters.rate, 72);
}

TEST(CirculationParameters, AValveCannotLeakMoreThanItOpens) {
  Parameters parameters;
  setParameter(parameters, "aorticArea", 0.5);
  setParameter(parameters, "aorticLeak", 0.6);
  EXPECT_THROW(checkParameters(parameters), UsageError);
}

TEST(CirculationParameters, SystoleShortensWithTheRateAsInPeople) {
  EXPECT_GT(endSystoleSeconds(50), endSystoleSeconds(75));
  // At 150 a minute the ejection time is 191 ms against 286 at 75: systole shortens by about a third.
  EXPECT_NEAR(endSystoleSeconds(150) / endSystoleSeconds(75), 0.68, 0.05);
  for (double rate = 30; rate <= 200; rate += 10)
    EXPECT_LT(endSystoleSeconds(rate), 0.62 * 60 / rate) << rate;
}

TEST(CirculationScenarios, AreTheNineOfTheContractAndDifferFromRest) {
  std::vector<std::string> ids;
  for (const Scenario& scenario : scenarios()) {
    ids.push_back(scenario.id);
    EXPECT_EQ(scenario.changes.empty(), scenario.id == "rest");
    for (const auto& [name, value] : scenario.changes)
      EXPECT_NE(value, parameter(Parameters(), name)) << scenario.id << " " << name;
  }
  EXPECT_THAT(ids, testing::ElementsAre("rest", "exercise", "haemorrhage", "heart-failure-reduced-ef",
                                        "heart-failure-preserved-ef", "hypertension", "aortic-stenosis",
                                        "mitral-regurgitation", "tamponade"));
  EXPECT_THROW(scenarioParameters("sleep"), UsageError);
}

} // namespace viscera::circulation
