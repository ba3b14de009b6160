#include <fstream>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session_scene.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/error.h"
#include "viscera/document/circulation_commands.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using tests::Session;

double parameterOf(const Session& s, const char* name) {
  return circulation::parameter(s.document.circulation().parameters, name);
}

TEST(CirculationChoice, TheTextbooksBeatMovesANewHeart) {
  Session s;
  EXPECT_FALSE(s.document.circulation().drives);
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Rest");
}

TEST(CirculationChoice, AScenarioComesWithAllItsParametersAndIsTakenBackAsOneStep) {
  Session s;
  s.undo.perform(setCirculationParameter("aorticArea", 1));
  s.undo.perform(chooseScenario("exercise"));
  EXPECT_TRUE(s.document.circulation().drives);
  EXPECT_EQ(parameterOf(s, "rate"), 150);
  EXPECT_EQ(parameterOf(s, "aorticArea"), 4) << "what another one had changed is not left behind";
  EXPECT_EQ(s.undo.undoName().english(), "Circulation: Exercise");
  s.undo.undo();
  EXPECT_FALSE(s.document.circulation().drives);
  EXPECT_EQ(parameterOf(s, "rate"), 72);
  EXPECT_EQ(parameterOf(s, "aorticArea"), 1);
}

TEST(CirculationChoice, AControlThatMovesIsOneStepUntilItIsLetGo) {
  Session s;
  const std::size_t before = s.undo.names().size();
  s.undo.perform(setCirculationParameter("rate", 80));
  s.undo.perform(setCirculationParameter("rate", 90));
  EXPECT_EQ(s.undo.names().size(), before + 1);
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Rest, changed");
  s.undo.seal();
  s.undo.perform(setCirculationParameter("rate", 100));
  EXPECT_EQ(s.undo.names().size(), before + 2);
  s.undo.undo();
  EXPECT_EQ(parameterOf(s, "rate"), 90);
}

TEST(CirculationChoice, WhatIsKeptStaysWhileTheCirculationGoesOn) {
  Session s;
  s.undo.perform(chooseScenario("haemorrhage"));
  s.undo.perform(keepCirculation());
  s.undo.perform(chooseScenario("rest"));
  ASSERT_TRUE(s.document.circulation().kept);
  EXPECT_EQ(s.document.circulation().kept->name.english(), "Haemorrhage");
  EXPECT_EQ(circulation::parameter(s.document.circulation().kept->parameters, "stressedVolume"), 745);
  s.undo.perform(forgetKeptCirculation());
  EXPECT_FALSE(s.document.circulation().kept);
}

TEST(CirculationChoice, OneThatWasFittedToAHeartIsNoScenarioUntilOneIsChosen) {
  Session s;
  circulation::Parameters found;
  circulation::setParameter(found, "lvEes", 1.1);
  s.undo.perform(takeCirculation("Circulation of this heart", found));
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Fitted circulation");
  s.undo.perform(setCirculationParameter("rate", 95));
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Fitted circulation, changed");
  s.undo.undo();
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Fitted circulation");
  s.undo.perform(chooseScenario("exercise"));
  EXPECT_EQ(nameOf(s.document.circulation()).english(), "Exercise");
}

TEST(CirculationChoice, RefusesWhatNoCirculationCanHave) {
  Session s;
  EXPECT_THROW(chooseScenario("holiday"), UsageError);
  EXPECT_THROW(s.undo.perform(setCirculationParameter("rate", 500)), UsageError);
  EXPECT_THROW(s.undo.perform(setCirculationParameter("pulse", 70)), UsageError);
  s.undo.perform(setCirculationParameter("aorticArea", 0.4));
  EXPECT_THROW(s.undo.perform(setCirculationParameter("aorticLeak", 0.9)), UsageError)
      << "a valve leaks through no more than it opens to";
  EXPECT_EQ(parameterOf(s, "aorticLeak"), 0);
}

class SavedCirculation : public testing::Test {
protected:
  /// What is said of a session whose circulation was spoilt.
  std::string failureOf(const std::function<void(nlohmann::ordered_json&)>& spoil) {
    SessionContents contents = tests::fullContents(folder_);
    tests::write(folder_ / "a.viscera", contents);
    auto root = nlohmann::ordered_json::parse(viscera::tests::contentsOf(folder_ / "a.viscera"));
    spoil(root["circulation"]);
    std::ofstream(folder_ / "b.viscera") << root.dump();
    try {
      tests::readBack(folder_ / "b.viscera");
    } catch (const DataError& error) {
      return error.what();
    }
    return "it was read";
  }

  viscera::tests::TemporaryFolder folder_;
};

TEST_F(SavedCirculation, IsRefusedWhereItIsDamaged) {
  using Json = nlohmann::ordered_json;
  EXPECT_THAT(failureOf([](Json& item) { item = 7; }), HasSubstr("circulation"));
  EXPECT_THAT(failureOf([](Json& item) { item["scenario"] = "holiday"; }), HasSubstr("no such scenario"));
  EXPECT_THAT(failureOf([](Json& item) { item["parameters"]["rate"] = 1e9; }),
              HasSubstr("circulation.parameters.rate"));
  EXPECT_THAT(failureOf([](Json& item) { item["parameters"]["pulse"] = 70; }),
              HasSubstr("circulation.parameters.pulse"));
  EXPECT_THAT(failureOf([](Json& item) { item["kept"]["parameters"]["rate"] = "fast"; }),
              HasSubstr("circulation.kept.parameters.rate"));
  EXPECT_THAT(failureOf([](Json& item) { item["kept"]["name"] = ""; }), HasSubstr("kept"));
}

TEST_F(SavedCirculation, ThatWasFittedIsNoScenarioWhenItIsOpened) {
  circulation::Parameters found;
  circulation::setParameter(found, "lvEes", 1.1);
  SessionContents contents = tests::fullContents(folder_);
  CirculationChoice choice = *contents.state.circulation;
  choice.fitted = choice.parameters = found;
  contents.state.circulation = std::make_shared<const CirculationChoice>(choice);
  tests::write(folder_ / "a.viscera", contents);
  EXPECT_EQ(*tests::readBack(folder_ / "a.viscera").contents.state.circulation, choice);
}

TEST_F(SavedCirculation, OfATimeWhenAtriaWereSmallerHasThePressuresThatItHadAndTheAtriaOfToday) {
  SessionContents contents = tests::fullContents(folder_);
  tests::write(folder_ / "a.viscera", contents);
  auto root = nlohmann::ordered_json::parse(viscera::tests::contentsOf(folder_ / "a.viscera"));
  root["circulation"]["scenario"] = "haemorrhage";
  root["circulation"]["parameters"] = {{"stressedVolume", 705}};
  root["circulation"]["kept"]["parameters"] = {{"laV0", 5}, {"stressedVolume", 2000}};
  std::ofstream(folder_ / "b.viscera") << root.dump();
  const auto opened = tests::readBack(folder_ / "b.viscera");
  const CirculationChoice& choice = *opened.contents.state.circulation;
  EXPECT_EQ(nameOf(choice).english(), "Haemorrhage");
  EXPECT_EQ(choice.kept->parameters.la.v0, 5) << "of today: it says what its atria hold";
  EXPECT_EQ(choice.kept->parameters.stressedVolume, 2000);

  root["circulation"]["parameters"] = {{"stressedVolume", 1990}};
  std::ofstream(folder_ / "c.viscera") << root.dump();
  EXPECT_EQ(tests::readBack(folder_ / "c.viscera").contents.state.circulation->parameters.stressedVolume,
            2000);
}

} // namespace
} // namespace viscera::document
