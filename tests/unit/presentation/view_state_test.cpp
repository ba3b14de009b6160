#include "viscera/presentation/view_state.h"

#include <string>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "viscera/anatomy/norms.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::presentation {
namespace {

using What = Compared::What;
using nlohmann::ordered_json;

ViewState viewOf(const std::string& text) {
  return viewFromJson(ordered_json::parse(text));
}

Compared back(const Compared& compared) {
  ViewState view;
  view.compared = compared;
  return viewFromJson(toJson(view)).compared.value();
}

ViewState withCompared(const std::string& item) {
  return viewOf(R"({"format": 2, "mode": "play", "compared": )" + item + "}");
}

TEST(ViewStateJson, WhatIsComparedComesBack) {
  EXPECT_EQ(back({What::rate, "", 137.25, {}}), (Compared{What::rate, "", 137.25, {}}));
  EXPECT_EQ(back({What::coordinates, "green", 0, {}}), (Compared{What::coordinates, "green", 0, {}}));
  EXPECT_EQ(back({What::sample, "stomach", 3, {}}), (Compared{What::sample, "stomach", 3, {}}));
  Points pose(2, 3);
  pose << 1, 2.5, -3, 0.1, 0, 7;
  EXPECT_EQ(back({What::pose, "", 0, pose}), (Compared{What::pose, "", 0, pose}));
  EXPECT_FALSE(back({What::pose, "", 0, pose}) == (Compared{What::pose, "", 0, Points(2 * pose)}));
  EXPECT_FALSE(viewFromJson(toJson(ViewState())).compared) << "one view";
  EXPECT_FALSE(toJson(ViewState()).contains("compared"));
}

TEST(ViewStateJson, TheSignsOfAHeartComeBackAndOlderViewsHaveAll) {
  EXPECT_EQ(viewOf(R"({"format": 3, "mode": "play"})").heartSigns, HeartSigns());
  for (bool HeartSigns::*sign : {&HeartSigns::pressures, &HeartSigns::loops, &HeartSigns::ecg,
                                 &HeartSigns::valves, &HeartSigns::sounds}) {
    ViewState view;
    view.heartSigns.*sign = false;
    EXPECT_FALSE(view == ViewState());
    EXPECT_EQ(viewFromJson(toJson(view)).heartSigns, view.heartSigns);
  }
  EXPECT_THROW(viewOf(R"({"format": 3, "heartSigns": 1})"), DataError);
}

/// The range of both shades nearly all of a chart.
TEST(ViewState, ShowsTheNormalRangesOfOneSexAtFirst) {
  const anatomy::Person person = ViewState().person;
  EXPECT_NE(person.sex, anatomy::Sex::either);
  for (const char* row : {"lv.edv", "lv.esv", "rv.edv", "rv.esv"}) {
    const anatomy::Range one = rangeOf(anatomy::norm(row), person), both = rangeOf(anatomy::norm(row));
    EXPECT_LT(one.high - one.low, 0.9 * (both.high - both.low)) << row;
  }
}

TEST(ViewStateJson, WhatCannotBeComparedIsLeftOut) {
  EXPECT_FALSE(withCompared(R"({"what": "of a newer version"})").compared);
  EXPECT_FALSE(withCompared(R"({"what": "coordinates"})").compared);
  EXPECT_FALSE(withCompared(R"({"what": "sample", "name": ""})").compared);
  EXPECT_FALSE(withCompared(R"({"what": "pose", "pose": []})").compared);
  EXPECT_EQ(withCompared(R"({"what": "rate", "ratePerMinute": -4})").compared->ratePerMinute, 0);
  EXPECT_EQ(withCompared(R"({"what": "rate", "ratePerMinute": 1e300})").compared->ratePerMinute, 0);
  EXPECT_THROW(withCompared(R"({"what": "pose", "pose": [[1, 2]]})"), DataError);
  EXPECT_THROW(withCompared("[]"), DataError);
}

TEST(ViewStateJson, APrescribedVolumeComesBackToTheLastBit) {
  ViewState view;
  view.playing = Playing{};
  EXPECT_FALSE(toJson(view)["playing"].contains("prescribed"));
  EXPECT_FALSE(viewFromJson(toJson(view)).playing->prescribed);
  view.playing->prescribed = Prescribed{{7}, "beat.csv", {{0, 120}, {1 / 3.0, 49.1}}};
  EXPECT_EQ(viewFromJson(toJson(view)).playing, view.playing);
  EXPECT_THROW(viewOf(R"({"format": 2, "playing": {"prescribed": {"organ": 1}}})"), DataError);
  EXPECT_THROW(viewOf(R"({"format": 2, "playing": {"prescribed": {"organ": 1, "curve": [[1]]}}})"),
               DataError);
}

/// The first versions of format 3 have written this view; most of its values are not the defaults.
TEST(ViewStateJson, OfFormat3IsWrittenAgainByteForByte) {
  const auto saved = ordered_json::parse(
      readText(VISCERA_SOURCE_DIR "/tests/unit/presentation/sessions/view_format_3.json"));
  EXPECT_EQ(toJson(viewFromJson(saved)).dump(), saved.dump());
}

TEST(ViewStateJson, FreeHandlesThatFollowComeBackAndAreLeftOutWhileTheyStay) {
  ViewState view;
  EXPECT_FALSE(toJson(view).contains("freeHandlesFollow")) << "older programs write the same";
  view.freeHandlesFollow = true;
  EXPECT_TRUE(viewFromJson(toJson(view)).freeHandlesFollow);
}

TEST(ViewStateJson, TheElasticGhostComesBackAndIsLeftOutWhileItIsOff) {
  ViewState view;
  EXPECT_FALSE(toJson(view).contains("besideElasticity")) << "older programs write the same";
  view.besideElasticity = true;
  EXPECT_TRUE(viewFromJson(toJson(view)).besideElasticity);
}

TEST(ViewStateJson, MotionsComeBackByTheirRecipes) {
  live::Landmarks landmarks;
  landmarks.points = {{"apex", Vec3(1, 2.5, -3)}, {"base", Vec3(0.1, 0, 7)}};
  ViewState view;
  view.motions = {{{1}, live::SampleMotion{"breathing", sample_organs::Resolution::low}},
                  {{2}, live::FittedMotion{"heartbeat", landmarks}},
                  {{3}, live::FittedMotion{"heartbeat", {}}},
                  {{4}, {}}};
  EXPECT_EQ(viewFromJson(toJson(view)).motions, view.motions);
  // Older versions have written the same.
  const ordered_json motions = toJson(view)["motions"];
  EXPECT_EQ(motions[0].dump(), R"({"organ":1,"recipe":{"resolution":"low","sequence":"breathing"}})");
  EXPECT_EQ(motions[1]["recipe"].dump(),
            R"({"landmarks":[{"position":[1.0,2.5,-3.0],"role":"apex"},)"
            R"({"position":[0.1,0.0,7.0],"role":"base"}],"sequence":"heartbeat"})");
}

TEST(ViewStateJson, ARecipeThatIsDamagedIsNone) {
  for (const char* damaged :
       {"null", "[]", "7", "{}", R"({"sequence": 7, "resolution": "low"})", R"({"sequence": "heartbeat"})",
        R"({"sequence": "heartbeat", "resolution": 7})", R"({"sequence": "heartbeat", "resolution": "huge"})",
        R"({"sequence": "heartbeat", "landmarks": [{"role": "apex"}]})",
        R"({"sequence": "heartbeat", "landmarks": [{"role": "apex", "position": [1, 2]}]})",
        R"({"sequence": "heartbeat", "landmarks": {"apex": [1, 2, 3]}})"}) {
    const ViewState view =
        viewOf(R"({"format": 3, "motions": [{"organ": 5, "recipe": )" + std::string(damaged) + "}]}");
    EXPECT_EQ(view.motions, (std::vector<MotionChoice>{{{5}, {}}})) << damaged;
  }
}

TEST(ViewStateJson, ThatIsDamagedIsRefusedWithThePlaceOfTheMistake) {
  const auto refusal = [](const std::string& view) {
    try {
      viewOf(view);
    } catch (const DataError& error) {
      return error.problem().english() + " / " + error.where().english();
    }
    return std::string("accepted");
  };
  const std::string sentence = "The view cannot be restored completely / the session's view";
  EXPECT_EQ(refusal("[]"), sentence);
  EXPECT_EQ(refusal(R"({"format": 2, "slides": [{"camera": {"position": [0, 0, 9]}}]})"),
            sentence + ", slides[0].camera");
  EXPECT_EQ(refusal(R"({"format": 2, "labels": 1})"), sentence + ", labels");
  EXPECT_EQ(refusal(R"({"format": 2, "shownPose": [[1, 2, 3], [4, null, 6]]})"), sentence + ", shownPose[1]");
  EXPECT_EQ(refusal(R"({"format": 2, "selection": {"organ": 1, "group": 0, "handles": [1.5]}})"),
            sentence + ", selection.handles[0]");
  EXPECT_EQ(refusal(R"({"format": 2, "motions": [{"organ": 1}]})"), sentence + ", motions[0]");
  EXPECT_EQ(refusal(R"({"stress": 7})"), sentence + ", stress");
}

TEST(ViewStateJson, TheLookOfStrainComesBackAndOneThatIsNoneIsTheUsual) {
  ViewState view;
  view.strain = {true, true, live::StrainDirection::radial, live::StrainMoment::timeToPeak, 9};
  EXPECT_EQ(viewFromJson(toJson(view)).strain, view.strain);
  view.strain.direction = live::StrainDirection::thickening;
  view.strain.reference = 4;
  view.strain.axesOf = {12};
  view.strain.apex = Vec3(1, 2, 3.5);
  EXPECT_EQ(viewFromJson(toJson(view)).strain, view.strain);
  view.strain.base = view.strain.insertion = Vec3(-7, 0, 80);
  EXPECT_EQ(viewFromJson(toJson(view)).strain, view.strain);
  EXPECT_FALSE(viewFromJson(toJson(view)) == ViewState());
  EXPECT_EQ(viewOf(R"({"format": 2})").strain, StrainLook());
  EXPECT_EQ(viewOf(R"({"format": 2, "strain": {"segment": 18, "moment": "of a newer version"}})").strain,
            StrainLook());
  EXPECT_THROW(viewOf(R"({"format": 2, "strain": 7})"), DataError);
}

} // namespace
} // namespace viscera::presentation
