// What is written for 3D Slicer: point lists after its markups schema 1.0.3, and its older table.
#include <bit>
#include <initializer_list>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/handle_file.h"

namespace viscera::medical_io {
namespace {

using nlohmann::json;
using tests::contentsOf;
using tests::TemporaryFolder;

HandleFile rigOfTwoGroups() {
  HandleFile rig;
  rig.groups.push_back({"Apex", {0.1, 2.0 / 3.0, 1.0}, {}});
  rig.groups[0].handles = {{"A-1", {0.1, 1.0 / 3.0, -57.000000000000007}, "left, \"upper\"", true, false},
                           {"shared", {5e-324, 1.7976931348623157e308, 1e22}, "", false, true}};
  rig.groups.push_back({"Base", {0, 0, 0}, {rig.groups[0].handles[1], {"B, 1", {1, 2, 3}, "", false, true}}});
  return rig;
}

/// The properties of an object, their kinds and what they may be, as the published schema has them.
struct Rule {
  const char* key;
  json::value_t type; ///< `number_float` stands for any number.
  bool required = false;
  std::vector<json> allowed = {};
  std::size_t length = 0; ///< Of an array of numbers; 0: any.
};

const std::vector<Rule> kFile = {{"@schema", json::value_t::string, true},
                                 {"markups", json::value_t::array, true}};
const std::vector<Rule> kMarkup = {{"type",
                                    json::value_t::string,
                                    true,
                                    {"Fiducial", "Line", "Angle", "Curve", "ClosedCurve", "Plane", "ROI"}},
                                   {"name", json::value_t::string},
                                   {"coordinateSystem", json::value_t::string, false, {"LPS", "RAS"}},
                                   {"coordinateUnits", json::value_t::string, false, {"mm", "um"}},
                                   {"locked", json::value_t::boolean},
                                   {"fixedNumberOfControlPoints", json::value_t::boolean},
                                   {"labelFormat", json::value_t::string},
                                   {"lastUsedControlPointNumber", json::value_t::number_float},
                                   {"controlPoints", json::value_t::array},
                                   {"measurements", json::value_t::array},
                                   {"display", json::value_t::object}};
const std::vector<Rule> kPoint = {
    {"id", json::value_t::string},
    {"label", json::value_t::string},
    {"description", json::value_t::string},
    {"associatedNodeID", json::value_t::string},
    {"position", json::value_t::array, false, {}, 3},
    {"orientation", json::value_t::array, false, {}, 9},
    {"selected", json::value_t::boolean},
    {"locked", json::value_t::boolean},
    {"visibility", json::value_t::boolean},
    {"positionStatus", json::value_t::string, false, {"undefined", "preview", "defined"}}};
const std::vector<Rule> kDisplay = {{"visibility", json::value_t::boolean},
                                    {"opacity", json::value_t::number_float},
                                    {"color", json::value_t::array, false, {}, 3},
                                    {"selectedColor", json::value_t::array, false, {}, 3},
                                    {"propertiesLabelVisibility", json::value_t::boolean},
                                    {"pointLabelsVisibility", json::value_t::boolean},
                                    {"textScale", json::value_t::number_float},
                                    {"glyphType", json::value_t::string},
                                    {"glyphScale", json::value_t::number_float},
                                    {"glyphSize", json::value_t::number_float},
                                    {"useGlyphScale", json::value_t::boolean}};

bool hasType(const json& value, json::value_t type) {
  return type == json::value_t::number_float ? value.is_number() : value.type() == type;
}

/// What an object breaks of the rules; a property without a rule is named too, since a misspelt one would be.
std::vector<std::string> broken(const json& object, const std::vector<Rule>& rules) {
  std::vector<std::string> list;
  for (const Rule& rule : rules) {
    if (!object.contains(rule.key)) {
      if (rule.required)
        list.push_back(std::string(rule.key) + " is missing");
      continue;
    }
    const json& value = object.at(rule.key);
    const bool known = rule.allowed.empty() ||
                       std::find(rule.allowed.begin(), rule.allowed.end(), value) != rule.allowed.end();
    bool numbers = true;
    for (std::size_t i = 0; rule.length > 0 && i < value.size(); ++i)
      numbers = numbers && value[i].is_number();
    if (!hasType(value, rule.type) || !known || (rule.length > 0 && value.size() != rule.length) || !numbers)
      list.push_back(std::string(rule.key) + " is " + value.dump());
  }
  for (const auto& [key, value] : object.items())
    if (std::none_of(rules.begin(), rules.end(), [&](const Rule& rule) { return key == rule.key; }))
      list.push_back(key + " is unknown");
  return list;
}

TEST(WrittenMarkups, FollowSlicersSchema) {
  const TemporaryFolder folder;
  writeHandles(folder / "rig.mrk.json", rigOfTwoGroups());
  const json file = json::parse(contentsOf(folder / "rig.mrk.json"));
  EXPECT_THAT(broken(file, kFile), testing::IsEmpty());
  for (const json& markup : file.at("markups")) {
    EXPECT_THAT(broken(markup, kMarkup), testing::IsEmpty());
    EXPECT_THAT(broken(markup.at("display"), kDisplay), testing::IsEmpty());
    for (const json& point : markup.at("controlPoints"))
      EXPECT_THAT(broken(point, kPoint), testing::IsEmpty());
  }
}

TEST(WrittenMarkups, TheSchemaCheckFindsWhatIsWrong) {
  EXPECT_THAT(broken({{"position", {1, 2}}, {"locked", "yes"}, {"lable", "A"}}, kPoint), testing::SizeIs(3));
  EXPECT_THAT(broken(json::object(), kMarkup), testing::ElementsAre("type is missing"));
}

TEST(WrittenMarkups, InRasComeBackInLps) {
  const TemporaryFolder folder;
  const HandleFile rig = rigOfTwoGroups();
  for (const char* name : {"rig.mrk.json", "rig.fcsv"}) {
    writeHandles(folder / name, rig, {.space = Space::ras});
    EXPECT_NE(contentsOf(folder / name).find("RAS"), std::string::npos);
    EXPECT_EQ(readHandles(folder / name).groups[0].handles[0].position, rig.groups[0].handles[0].position);
  }
}

TEST(WrittenFcsv, KeepsEveryBitAndEveryFieldOfAHandle) {
  const TemporaryFolder folder;
  const HandleFile rig = rigOfTwoGroups();
  writeHandles(folder / "rig.fcsv", rig);
  const HandleFile back = readHandles(folder / "rig.fcsv");
  EXPECT_THAT(back.warnings, testing::IsEmpty());
  ASSERT_EQ(back.groups.size(), 1u);
  const std::vector<HandleRecord> expected = {rig.groups[0].handles[0], rig.groups[0].handles[1],
                                              rig.groups[1].handles[1]};
  ASSERT_EQ(back.groups[0].handles, expected) << "the handle of both groups once";
  for (std::size_t i = 0; i < expected.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.groups[0].handles[i].position[axis]),
                std::bit_cast<std::uint64_t>(expected[i].position[axis]));
}

TEST(WrittenFcsv, ALineBreakInALabelDoesNotEndTheRow) {
  const TemporaryFolder folder;
  HandleFile rig;
  rig.groups.push_back({"G", {1, 0, 0}, {{"a\nb,\"c\"", {1, 2, 3}, "two\r\nlines", false, true}}});
  writeHandles(folder / "rig.fcsv", rig);
  EXPECT_EQ(readHandles(folder / "rig.fcsv").groups[0].handles[0],
            (HandleRecord{"a b,\"c\"", {1, 2, 3}, "two  lines", false, true}));
}

TEST(WrittenFcsv, SaysThatGroupsAreNotKept) {
  EXPECT_THAT(fcsvLoses(rigOfTwoGroups()), testing::ElementsAre(testing::HasSubstr("2 groups")));
  HandleFile one = rigOfTwoGroups();
  one.groups.pop_back();
  EXPECT_THAT(fcsvLoses(one), testing::IsEmpty());
}

} // namespace
} // namespace viscera::medical_io
