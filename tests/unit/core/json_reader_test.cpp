#include "viscera/core/json_reader.h"

#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace viscera {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr JsonReader::Format kFormat = {"viscera-shape", 2, "shape", "choose another file", "save it again"};

/// The error with which `read` ends.
JsonError errorOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const JsonError& error) {
    return error;
  }
  return JsonError("no error");
}

JsonError parseError(const std::string& text) {
  return errorOf([&] { parseJson<json>(text, "a.json", "save it again"); });
}

class Reading : public ::testing::Test {
protected:
  std::string refusal(const std::function<void(const JsonReader&, const ordered_json&)>& read) const {
    return errorOf([&] { read(reader_, item_); }).what();
  }

  const JsonReader reader_{"a.json", std::string("save it again")};
  const ordered_json item_ = {{"text", "liver"},
                              {"empty", ""},
                              {"flag", true},
                              {"number", 2.5},
                              {"whole", 7},
                              {"below", -1},
                              {"huge", 3e9},
                              {"endless", 1e300},
                              {"nan", std::numeric_limits<double>::quiet_NaN()},
                              {"place", {1, 2, 3}},
                              {"pair", {4, 5}},
                              {"nothing", nullptr},
                              {"names", {"left", "right"}},
                              {"titles", {{"lv", "Left ventricle"}}}};
};

} // namespace

TEST(ParseJson, GivesTheValueOfATextInEitherType) {
  EXPECT_EQ(parseJson<json>(R"({"b": 1, "a": [2, null]})", "a.json", "").dump(), R"({"a":[2,null],"b":1})");
  EXPECT_EQ(parseJson<ordered_json>(R"({"b": 1, "a": 2, "b": 3})", "a.json", "").dump(), R"({"b":3,"a":2})")
      << "the last of two equal keys counts";
}

TEST(ParseJson, ReadsBytesThatAreNoUtf8AsLatin1) {
  EXPECT_EQ(parseJson<json>("\"Kn\xE9t\"", "a.json", "").get<std::string>(), "Kn\xC3\xA9t");
}

TEST(ParseJson, SaysWhereATextIsNoJsonAndWhatToTry) {
  const JsonError error = parseError("{\n \"name\": \"thing\",\n ]");
  EXPECT_THAT(error.what(),
              AllOf(HasSubstr("a.json"), HasSubstr("It is not complete JSON: parse error at line 3"),
                    HasSubstr("save it again")));
  EXPECT_THAT(error.what(), Not(HasSubstr("json.exception")));
  EXPECT_EQ(error.line, 3u);
}

TEST(ParseJson, RefusesATextThatIsCutOffAnywhere) {
  const std::string whole = R"({"a": [1, 2.5, "three"], "b": {"c": true}})";
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT(parseError(whole.substr(0, length)).what(), HasSubstr("It is not complete JSON")) << length;
}

TEST(ParseJson, RefusesANumberBeyondDoubles) {
  EXPECT_THAT(parseError("[1e999]").what(), HasSubstr("1e999"));
}

TEST(ParseJson, RefusesWhatIsNestedTooDeeplyWithoutAStackForIt) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(parseError(nested(64)).problem().english(), "No error");
  EXPECT_EQ(parseError(nested(66)).problem().english(), "It is nested too deeply");
  EXPECT_EQ(parseError(std::string(3'000'000, '[')).problem().english(), "It is nested too deeply");
}

TEST(ParseJson, SkipsCommentsOnlyWhereTheyAreAllowed) {
  const std::string text = "{ // sizes in mm\n}";
  EXPECT_THAT(parseError(text).what(), HasSubstr("It is not complete JSON"));
  EXPECT_TRUE(parseJson<json>(text, "a.json", "", JsonComments::skipped).empty());
}

TEST(JsonValues, AreGivenOnlyWhereTheyAreOfTheirType) {
  EXPECT_EQ(finiteNumber(json(2)), 2.0);
  EXPECT_EQ(finiteNumber(json("2")), std::nullopt);
  EXPECT_EQ(finiteNumber(json(std::numeric_limits<double>::infinity())), std::nullopt);
  EXPECT_EQ(threeNumbers(json{1, 2.5, -3}), Vec3(1, 2.5, -3));
  for (const json& other : {json{1, 2}, json{1, 2, 3, 4}, json{1, 2, nullptr}, json("123"), json(1)})
    EXPECT_EQ(threeNumbers(other), std::nullopt) << other;
  const json object = {{"name", "liver"}, {"size", 3}, {"locked", true}};
  EXPECT_EQ(textIn(object, "name"), "liver");
  EXPECT_EQ(textIn(object, "size"), "");
  EXPECT_EQ(textIn(json::array(), "name"), "");
  EXPECT_TRUE(flagIn(object, "locked", false));
  EXPECT_TRUE(flagIn(object, "size", true));
  EXPECT_FALSE(flagIn(object, "gone", false));
}

TEST_F(Reading, GivesValuesOfEveryType) {
  EXPECT_EQ(reader_.valueOf<std::string>(item_, "text", ""), "liver");
  EXPECT_EQ(reader_.valueOf<std::string>(item_, "empty", ""), "");
  EXPECT_TRUE(reader_.valueOf<bool>(item_, "flag", ""));
  EXPECT_EQ(reader_.valueOf<double>(item_, "whole", ""), 7);
  EXPECT_EQ(reader_.valueOf<int>(item_, "below", ""), -1);
  EXPECT_EQ(reader_.valueOf<std::int64_t>(item_, "huge", ""), 3'000'000'000);
  EXPECT_EQ(reader_.valueOf<Vec3>(item_, "place", ""), Vec3(1, 2, 3));
  EXPECT_THAT((reader_.valueOf<std::array<double, 2>>(item_, "pair", "")), ElementsAre(4, 5));
  EXPECT_THAT(reader_.valueOf<std::vector<std::string>>(item_, "names", ""), ElementsAre("left", "right"));
  EXPECT_EQ((reader_.valueOf<std::map<std::string, std::string>>(item_, "titles", "").at("lv")),
            "Left ventricle");
  EXPECT_EQ(reader_.textOf(item_, "text", ""), "liver");
  EXPECT_EQ(reader_.wholeOf(item_.at("whole"), "whole"), 7);
}

TEST_F(Reading, LeavesAValueAsItIsWhereTheKeyIsNotThere) {
  double number = 12;
  reader_.readIfThere(item_, "gone", "", number);
  EXPECT_EQ(number, 12);
  reader_.readIfThere(item_, "number", "", number);
  EXPECT_EQ(number, 2.5);
  int visited = 0;
  reader_.eachOf(item_, "gone", "", [&](const ordered_json&, const std::string&) { ++visited; });
  EXPECT_EQ(visited, 0);
}

TEST_F(Reading, NamesTheMissingKeyAndItsPlace) {
  const JsonError error = errorOf([&] { reader_.field(item_, "color", "organs[2].look"); });
  EXPECT_EQ(error.missingKey, "color");
  EXPECT_EQ(error.line, 0u);
  EXPECT_THAT(error.what(), AllOf(HasSubstr("It has no \"color\""), HasSubstr("a.json, organs[2].look"),
                                  HasSubstr("save it again")));
  EXPECT_THAT(refusal([](auto& json, auto&) { json.field(ordered_json::array(), "color", ""); }),
              HasSubstr("It has no \"color\""));
}

TEST_F(Reading, RefusesValuesOfAnotherType) {
  const auto at = [](const char* place) { return HasSubstr(std::string("a.json, ") + place); };
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<std::string>(i, "whole", "look"); }),
              AllOf(HasSubstr("\"whole\" is not a text"), at("look.whole")));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.textOf(i, "empty", "look"); }),
              HasSubstr("\"empty\" is not a text"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<bool>(i, "whole", "look"); }),
              HasSubstr("\"whole\" is neither true nor false"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<double>(i, "text", "look"); }),
              AllOf(HasSubstr("It is not a finite number"), at("look.text")));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<double>(i, "nothing", ""); }),
              HasSubstr("It is not a finite number"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.listOf(i, "whole", ""); }),
              HasSubstr("\"whole\" is not a list"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.requireObject(i.at("place"), "place"); }),
              HasSubstr("It is not an object"));
  EXPECT_THAT(
      refusal([](auto& json, auto& i) { json.template valueOf<std::vector<double>>(i, "names", "look"); }),
      AllOf(HasSubstr("It is not a finite number"), at("look.names[0]")));
  EXPECT_THAT(refusal([](auto& json, auto& i) {
                json.eachOf(i, "titles", "", [](const ordered_json&, const std::string&) {});
              }),
              HasSubstr("\"titles\" is not a list"));
}

TEST_F(Reading, RefusesNumbersThatAreNotFiniteWholeOrInRange) {
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<double>(i, "nan", ""); }),
              HasSubstr("It is not a finite number"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<int>(i, "number", ""); }),
              HasSubstr("2.5"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<int>(i, "huge", ""); }),
              HasSubstr("out of its range"));
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.template valueOf<std::int64_t>(i, "endless", ""); }),
              HasSubstr("out of its range"));
  for (const char* key : {"below", "number", "text", "endless"})
    EXPECT_THAT(refusal([&](auto& json, auto& i) { json.wholeOf(i.at(key), key); }),
                HasSubstr("It is not a whole number from 0 to 2^53"));
  EXPECT_THAT(refusal([](auto& json, auto&) {
                json.colorOf(ordered_json{0, 0.5, 1.5}, "color");
              }),
              HasSubstr("between 0 and 1"));
}

TEST_F(Reading, RefusesListsOfAnotherLength) {
  EXPECT_THAT(refusal([](auto& json, auto& i) { json.vectorOf(i.at("pair"), "pair"); }),
              AllOf(HasSubstr("It is not a list of three numbers"), HasSubstr("a.json, pair")));
  EXPECT_THAT(refusal([](auto& json, auto&) {
                json.vectorOf(ordered_json{1, 2, 3, 4}, "rest");
              }),
              HasSubstr("It is not a list of three numbers"));
  std::array<double, 2> pair{};
  EXPECT_THAT(refusal([&](auto& json, auto&) { json.read(ordered_json{1}, "range", pair); }),
              HasSubstr("It has no \"[1]\""));
}

TEST_F(Reading, RemembersKeysThatItDoesNotKnow) {
  JsonReader reader("a.json", kFormat);
  reader.takeObject({{"color", 1}, {"shine", 2}}, {"color"}, "organs[2].look");
  reader.takeObject({{"new", 1}}, {}, "");
  EXPECT_THAT(reader.unknownKeys(), ElementsAre("organs[2].look.shine", "new"));
}

TEST(JsonFormat, IsRequiredWithItsVersionAndUnits) {
  const JsonReader reader("a.json", kFormat);
  const auto refusal = [&](const char* text) {
    return std::string(errorOf([&] { reader.parse(text); }).what());
  };
  EXPECT_EQ(reader.parse(R"({"format": "viscera-shape", "version": 2, "units": "mm"})").size(), 3u);
  EXPECT_THAT(refusal(R"({"format": "other"})"),
              AllOf(HasSubstr("It is no shape"), HasSubstr("another file")));
  EXPECT_THAT(refusal("[]"), HasSubstr("It is no shape"));
  EXPECT_THAT(refusal(R"({"format": "viscera-shape"})"), HasSubstr("It has no \"version\""));
  EXPECT_THAT(refusal(R"({"format": "viscera-shape", "version": 3})"), HasSubstr("update Viscera"));
  EXPECT_THAT(refusal(R"({"format": "viscera-shape", "version": 1, "units": "cm"})"),
              HasSubstr("\"units\" is \"cm\" instead of \"mm\""));
  EXPECT_THAT(errorOf([] { JsonReader("a.json", std::string()).parse("[]"); }).what(),
              HasSubstr("It is not an object"));
}

} // namespace viscera
