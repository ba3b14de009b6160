#include "viscera/medical_io/handle_file.h"

#include <bit>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::contentsOf;
using tests::TemporaryFolder;

/// Numbers whose decimal form is long, tiny, huge, or a negative zero.
HandleFile awkwardRig() {
  HandleFile rig;
  HandleGroupRecord apex{"Apex \"left\", ünïcode", {0.1, 2.0 / 3.0, 1.0}, {}};
  apex.handles.push_back({"A-1", {0.1, 1.0 / 3.0, -0.0}, "moves\nthe apex", true, false});
  apex.handles.push_back({"A-2", {5e-324, 1.7976931348623157e308, 123456789.123456789}, "", false, true});
  HandleGroupRecord base{"Base", {0, 0, 0}, {}};
  base.handles.push_back({"B-1", {-57.000000000000007, 2.2250738585072014e-308, 1e22}, "", false, true});
  rig.groups = {apex, base};
  return rig;
}

void expectSameBits(const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[axis]), std::bit_cast<std::uint64_t>(b[axis])) << a << "\n" << b;
}

std::string markups(const std::string& points, const std::string& more = {}) {
  return R"({"markups": [{"type": "Fiducial", "name": "F")" + more + R"(, "controlPoints": [)" + points +
         "]}]}";
}

std::string point(const std::string& label, const std::string& position, const std::string& more = {}) {
  return R"({"label": ")" + label + R"(", "position": )" + position + more + "}";
}

std::string problemOfHandles(const std::filesystem::path& file) {
  try {
    readHandles(file);
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    return error.problem().english();
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

TEST(HandleFile, RoundTripKeepsEveryBitAndEveryField) {
  const TemporaryFolder folder;
  const HandleFile rig = awkwardRig();
  writeHandles(folder / "rig.mrk.json", rig);
  const HandleFile back = readHandles(folder / "rig.mrk.json");
  ASSERT_EQ(back.groups.size(), rig.groups.size());
  EXPECT_TRUE(back.warnings.empty());
  for (std::size_t g = 0; g < rig.groups.size(); ++g) {
    EXPECT_EQ(back.groups[g].name, rig.groups[g].name);
    expectSameBits(back.groups[g].color, rig.groups[g].color);
    ASSERT_EQ(back.groups[g].handles.size(), rig.groups[g].handles.size());
    for (std::size_t h = 0; h < rig.groups[g].handles.size(); ++h) {
      EXPECT_EQ(back.groups[g].handles[h], rig.groups[g].handles[h]);
      expectSameBits(back.groups[g].handles[h].position, rig.groups[g].handles[h].position);
    }
  }
}

TEST(HandleFile, WritesWhatSlicerNeedsToShowPoints) {
  const TemporaryFolder folder;
  writeHandles(folder / "rig.mrk.json", awkwardRig());
  const auto written = nlohmann::json::parse(contentsOf(folder / "rig.mrk.json"));
  EXPECT_THAT(written.at("@schema").get<std::string>(), HasSubstr("markups-schema-v1.0.3.json"));
  ASSERT_EQ(written.at("markups").size(), 2U) << "one list a group";
  const auto& list = written.at("markups").at(0);
  EXPECT_EQ(list.at("type"), "Fiducial");
  EXPECT_EQ(list.at("coordinateSystem"), "LPS");
  EXPECT_EQ(list.at("coordinateUnits"), "mm");
  EXPECT_EQ(list.at("locked"), false);
  const auto& first = list.at("controlPoints").at(0);
  EXPECT_TRUE(first.at("id").is_string());
  EXPECT_EQ(first.at("positionStatus"), "defined");
  EXPECT_EQ(first.at("locked"), true);
  EXPECT_EQ(list.at("controlPoints").at(1).at("locked"), false);
  EXPECT_EQ(first.at("orientation").size(), 9U);
}

TEST(HandleFile, WritingLeavesNothingBesideTheFile) {
  const TemporaryFolder folder;
  writeHandles(folder / "rig.mrk.json", awkwardRig());
  HandleFile bad = awkwardRig();
  bad.groups[0].handles[0].position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeHandles(folder / "bad.mrk.json", bad), DataError);
  EXPECT_THROW(writeHandles(folder / "rig.csv", awkwardRig()), CannotCreateError);
  EXPECT_THROW(writeHandles(folder / "missing" / "rig.mrk.json", awkwardRig()), CannotCreateError);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    files += entry.exists() ? 1 : 0;
  EXPECT_EQ(files, 1U);
}

TEST(HandleFile, PositionsAndLabelsRunThroughTheGroups) {
  const HandleFile rig = awkwardRig();
  EXPECT_EQ(rig.count(), 3);
  EXPECT_THAT(rig.labels(), ElementsAre("A-1", "A-2", "B-1"));
  EXPECT_EQ(rig.positions().row(2).transpose(), rig.groups[1].handles[0].position);
}

TEST(HandleFile, RasIsTurnedIntoLps) {
  const TemporaryFolder folder;
  const auto file =
      folder.put("f.mrk.json", markups(point("a", "[1, -2, 3]"), R"(, "coordinateSystem": "RAS")"));
  EXPECT_EQ(readHandles(file).groups[0].handles[0].position, Vec3(-1, 2, 3));
}

TEST(HandleFile, CentimetresBecomeMillimetresWithAWarning) {
  const TemporaryFolder folder;
  const auto file =
      folder.put("f.mrk.json", markups(point("a", "[1, -2, 3]"), R"(, "coordinateUnits": "cm")"));
  const HandleFile read = readHandles(file);
  EXPECT_EQ(read.groups[0].handles[0].position, Vec3(10, -20, 30));
  EXPECT_THAT(inEnglish(read.warnings), ElementsAre(HasSubstr("from cm to mm")));
}

TEST(HandleFile, EqualLabelsOfDifferentHandlesBecomeUnique) {
  const TemporaryFolder folder;
  const auto file =
      folder.put("f.mrk.json", markups(point("a", "[1,0,0]") + "," + point("a", "[2,0,0]") + "," +
                                       point("a-2", "[3,0,0]") + "," + point("", "[4,0,0]")));
  const HandleFile read = readHandles(file);
  EXPECT_THAT(read.labels(), ElementsAre("a", "a-3", "a-2", "F-4"));
  EXPECT_EQ(read.warnings.size(), 2U);
}

TEST(HandleFile, AHandleThatTwoListsShareKeepsItsLabelInBoth) {
  const TemporaryFolder folder;
  HandleFile rig = awkwardRig();
  rig.groups[1].handles.push_back(rig.groups[0].handles[1]);
  writeHandles(folder / "rig.mrk.json", rig);
  EXPECT_THAT(readHandles(folder / "rig.mrk.json").labels(), ElementsAre("A-1", "A-2", "B-1", "A-2"));
}

TEST(HandleFile, LockAndVisibilityOfTheListHoldForItsPoints) {
  const TemporaryFolder folder;
  const auto file = folder.put(
      "f.mrk.json", markups(point("a", "[1,0,0]"), R"(, "locked": true, "display": {"visibility": false})"));
  const HandleRecord handle = readHandles(file).groups[0].handles[0];
  EXPECT_TRUE(handle.locked);
  EXPECT_FALSE(handle.visible);
}

TEST(HandleFile, UnplacedPointsAndOtherMarkupsAreLeftOutWithAWarning) {
  const TemporaryFolder folder;
  const auto file = folder.put(
      "f.mrk.json",
      R"({"markups": [{"type": "Plane", "name": "P"}, {"type": "Fiducial", "controlPoints": [)" +
          point("a", "[1,0,0]") + "," + point("b", "[0,0,0]", R"(, "positionStatus": "undefined")") + "]}]}");
  const HandleFile read = readHandles(file);
  EXPECT_THAT(read.labels(), ElementsAre("a"));
  EXPECT_THAT(inEnglish(read.warnings), ElementsAre(HasSubstr("Plane"), HasSubstr("left out: \"b\"")));
}

TEST(HandleFile, EveryStatusButDefinedIsNoPlace) {
  const TemporaryFolder folder;
  std::string points = point("a", "[1,0,0]", R"(, "positionStatus": "defined")");
  for (const std::string status : {R"("undefined")", R"("missing")", R"("preview")", "0", "1", "3"})
    points +=
        "," + point("no " + std::to_string(points.size()), "[0,0,0]", R"(, "positionStatus": )" + status);
  points += R"(,{"label": "no place", "positionStatus": "undefined"})" // Slicer may leave the position out.
            "," +
            point("b", "[2,0,0]", R"(, "positionStatus": 2)") + "," + point("c", "[3,0,0]");
  const HandleFile read = readHandles(folder.put("f.mrk.json", markups(points)));
  EXPECT_THAT(read.labels(), ElementsAre("a", "b", "c"));
  EXPECT_THAT(inEnglish(read.warnings),
              ElementsAre(HasSubstr("7 points that were never placed are left out: \"no ")));
}

TEST(HandleFile, UnplacedPointsOfAllListsAreOneWarningAndManyAreNotAllNamed) {
  const TemporaryFolder folder;
  std::string unplaced;
  for (int i = 0; i < 10; ++i)
    unplaced += "," + point("u" + std::to_string(i), "[0,0,0]", R"(, "positionStatus": "missing")");
  const std::string list = R"({"type": "Fiducial", "name": "L", "controlPoints": [)";
  const auto file = folder.put("f.mrk.json", R"({"markups": [)" + list + point("a", "[1,0,0]") + unplaced +
                                                 "]}," + list + point("b", "[2,0,0]") + unplaced + "]}]}");
  const HandleFile read = readHandles(file);
  EXPECT_THAT(read.labels(), ElementsAre("a", "b"));
  EXPECT_THAT(inEnglish(read.warnings),
              ElementsAre(testing::AllOf(HasSubstr("20 points"), HasSubstr("\"u7\" and 12 more"))));
  EXPECT_THAT(problemOfHandles(folder.put("none.mrk.json", markups(unplaced.substr(1)))),
              HasSubstr("10 points were never placed"));
}

TEST(HandleFile, AFileWithoutListsOfPointsNamesWhatItHas) {
  const TemporaryFolder folder;
  const auto only = [&](const std::string& type) {
    return problemOfHandles(folder.put("f.mrk.json", R"({"markups": [{"type": ")" + type +
                                                         R"(", "name": "M", "controlPoints": [)" +
                                                         point("a", "[1,0,0]") + "]}]}"));
  };
  EXPECT_EQ(only("Curve"), "It holds no points, but a curve \"M\"");
  EXPECT_EQ(only("ClosedCurve"), "It holds no points, but a closed curve \"M\"");
  EXPECT_EQ(only("Line"), "It holds no points, but a line \"M\"");
  EXPECT_EQ(only("Angle"), "It holds no points, but an angle \"M\"");
  EXPECT_EQ(only("Plane"), "It holds no points, but a plane \"M\"");
  EXPECT_EQ(only("ROI"), "It holds no points, but a box (ROI) \"M\"");
  EXPECT_EQ(only("GridSurface"), "It holds no points, but a markup of another kind \"M\"");
  const std::string several =
      R"({"markups": [{"type": "Curve", "name": "C"}, {"type": "Fiducial", "name": "F"},)"
      R"({"type": "Line", "name": "L"}]})";
  EXPECT_EQ(problemOfHandles(folder.put("g.mrk.json", several)),
            "It holds no points, but a curve \"C\", a line \"L\"");
  const auto mixed =
      folder.put("h.mrk.json", R"({"markups": [{"type": "Curve", "name": "C"}, {"type": "Fiducial",)"
                               R"("controlPoints": [)" +
                                   point("a", "[1,0,0]") + "]}]}");
  EXPECT_THAT(readHandles(mixed).labels(), ElementsAre("a"));
}

TEST(HandleFile, SelectedColourIsTheOneSlicerShows) {
  const TemporaryFolder folder;
  const auto file = folder.put(
      "f.mrk.json", markups(point("a", "[1,0,0]"),
                            R"(, "display": {"color": [0.4, 1, 1], "selectedColor": [1, 0.5, 0.25]})"));
  EXPECT_EQ(readHandles(file).groups[0].color, Vec3(1, 0.5, 0.25));
}

TEST(HandleFile, BadPositionsAreNamedByListAndPoint) {
  const TemporaryFolder folder;
  const std::string good = point("a", "[1,0,0]");
  for (const char* position : {"[1, 2]", "[1, 2, \"x\"]", "[1, 2, null]", "\"here\"", "{}"}) {
    const auto file = folder.put("f.mrk.json", markups(good + "," + point("b", position)));
    EXPECT_THAT(problemOfHandles(file), HasSubstr("List \"F\", point 2")) << position;
  }
  EXPECT_THAT(problemOfHandles(folder.put("f.mrk.json", markups(good + R"(,{"label": "b"})"))),
              HasSubstr("point 2"));
}

TEST(HandleFile, WhatIsNoHandleFileIsRefusedWithAReason) {
  const TemporaryFolder folder;
  EXPECT_THROW(readHandles(folder / "missing.mrk.json"), NoInputError);
  EXPECT_THROW(readHandles(folder.path()), NoInputError);
  EXPECT_THAT(problemOfHandles(folder.put("empty.mrk.json", "")), HasSubstr("empty"));
  EXPECT_THAT(problemOfHandles(folder.put("cut.mrk.json", R"({"markups": [{"type":)")), HasSubstr("JSON"));
  EXPECT_THAT(problemOfHandles(folder.put("other.mrk.json", R"({"handles": []})")),
              HasSubstr("no \"markups\""));
  EXPECT_THAT(problemOfHandles(folder.put("array.mrk.json", "[1, 2]")), HasSubstr("no \"markups\""));
  EXPECT_THAT(problemOfHandles(folder.put("none.mrk.json", markups(""))), HasSubstr("no points"));
  EXPECT_THAT(problemOfHandles(folder.put("axes.mrk.json",
                                          markups(point("a", "[1,0,0]"), R"(, "coordinateSystem": "LAS")"))),
              HasSubstr("LAS"));
  EXPECT_THAT(problemOfHandles(folder.put("off.off", "OFF\n1 0 0\n0 0 0\n")), HasSubstr("looks like OFF"));
}

TEST(Fcsv, ReadsSlicersTable) {
  const TemporaryFolder folder;
  const auto file =
      folder.put("tips.fcsv", "# Markups fiducial file version = 4.11\n"
                              "# CoordinateSystem = RAS\n"
                              "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
                              "n_0,1.5,-2,3,0,0,0,1,1,1,0,F-1,\"left, upper\",\n"
                              "n_1,4,5,6,0,0,0,1,0,1,1,F-2,,\r\n");
  const HandleFile read = readHandles(file);
  ASSERT_EQ(read.count(), 2);
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read.groups[0].name, "tips");
  const auto& handles = read.groups[0].handles;
  EXPECT_EQ(handles[0], (HandleRecord{"F-1", {-1.5, 2, 3}, "left, upper", false, true}));
  EXPECT_EQ(handles[1], (HandleRecord{"F-2", {-4, -5, 6}, "", true, false}));
}

TEST(Fcsv, AxesByNumberAreThoseOfOldSlicers) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& axes) {
    return readHandles(folder.put("f.fcsv", "# CoordinateSystem = " + axes + "\nn,1,2,3,0,0,0,1,1,1,0,a,,\n"))
        .groups[0]
        .handles[0]
        .position;
  };
  EXPECT_EQ(read("0"), Vec3(-1, -2, 3));
  EXPECT_EQ(read("1"), Vec3(1, 2, 3));
  EXPECT_EQ(read("LPS"), Vec3(1, 2, 3));
}

constexpr auto kFcsvColumns = "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID";

TEST(Fcsv, PointsThatWereNeverPlacedAreLeftOut) {
  const TemporaryFolder folder;
  const std::string rows = "1,12,-9,7,0,0,0,1,1,1,0,F-1,,,2,0\n2,0,0,0,0,0,0,1,1,1,0,F-2,,,0,0\n"
                           "3,-4,6,8,0,0,0,1,1,1,0,F-3,\"a, b\",,2,0\n4,0,0,0,0,0,0,1,1,1,0,F-4,,,3,0\n"
                           "5,nan,0,0,0,0,0,1,1,1,0,,,,1,0\n";
  const std::string begin = "# Markups fiducial file version = 5.6\n# CoordinateSystem = LPS\n";
  const std::string header = std::string(kFcsvColumns) + "\n";
  const std::string listed = std::string(kFcsvColumns) + ",positionStatus,autoCreated\n";
  std::string dos = begin + header + rows;
  for (std::size_t at = 0; (at = dos.find('\n', at)) != std::string::npos; at += 2)
    dos.insert(at, 1, '\r');
  for (const std::string& text : {begin + header + rows, begin + listed + rows, begin + rows, dos}) {
    const HandleFile read = readHandles(folder.put("f.fcsv", text));
    EXPECT_THAT(read.labels(), ElementsAre("F-1", "F-3"));
    EXPECT_EQ(read.groups[0].handles[1].position, Vec3(-4, 6, 8));
    EXPECT_THAT(inEnglish(read.warnings),
                ElementsAre("3 points that were never placed are left out: \"F-2\", \"F-4\", \"5\""));
  }
  EXPECT_THAT(problemOfHandles(folder.put("g.fcsv", begin + "2,0,0,0,0,0,0,1,1,1,0,F-2,,,0,0\n")),
              HasSubstr("1 point was never placed (\"F-2\")"));
}

TEST(Fcsv, ARowWithoutAStatusIsAPoint) {
  const TemporaryFolder folder;
  // Slicer 4 wrote commas within labels without quotes, so that its last field comes one later.
  const auto file = folder.put("f.fcsv", "# Markups fiducial file version = 4.8\n# CoordinateSystem = 0\n" +
                                             std::string(kFcsvColumns) +
                                             "\nn_1,1,2,3,0,0,0,1,1,1,0,left, upper,,\n"
                                             "n_2,4,5,6,0,0,0,1,1,1,0,5\" probe,,vtkMRMLScalarVolumeNode1\n");
  const HandleFile read = readHandles(file);
  EXPECT_THAT(read.labels(), ElementsAre("left", "5\" probe"));
  EXPECT_EQ(read.groups[0].handles[0].position, Vec3(-1, -2, 3));
  EXPECT_TRUE(read.warnings.empty());
}

TEST(Fcsv, FilesOfSlicer3AreRas) {
  const TemporaryFolder folder;
  const auto file =
      folder.put("f.fcsv", "# Fiducial List file /data/f.fcsv\n# version = 2\n# name = tips\n"
                           "# numPoints = 2\n# visibility = 1\n# color = 0.4,1,1\n"
                           "# selectedColor = 1,0.5,0.25\n# locked = 1\n"
                           "# columns = label,x,y,z,sel,vis\nL-P,50,100,200,1,1\nL-Q,1,2,3,1,0\n");
  const HandleFile read = readHandles(file);
  ASSERT_EQ(read.count(), 2);
  EXPECT_EQ(read.groups[0].name, "tips");
  EXPECT_EQ(read.groups[0].color, Vec3(1, 0.5, 0.25));
  EXPECT_EQ(read.groups[0].handles[0], (HandleRecord{"L-P", {-50, -100, 200}, "", true, true}));
  EXPECT_EQ(read.groups[0].handles[1], (HandleRecord{"L-Q", {-1, -2, 3}, "", true, false}));
  EXPECT_THAT(inEnglish(read.warnings), ElementsAre(HasSubstr("RAS is assumed")));
  // Other programs write the rows alone.
  const HandleFile bare = readHandles(folder.put("g.fcsv", "L-P,50,100,200,1,0\nL-Q,1,2,3\n"));
  EXPECT_THAT(bare.labels(), ElementsAre("L-P", "L-Q"));
  EXPECT_EQ(bare.groups[0].handles[0].position, Vec3(-50, -100, 200));
  EXPECT_FALSE(bare.groups[0].handles[0].visible);
  EXPECT_THAT(inEnglish(bare.warnings), ElementsAre(HasSubstr("RAS is assumed")));
}

TEST(Fcsv, BadNumbersAreNamedByLine) {
  const TemporaryFolder folder;
  const auto file = folder.put("f.fcsv", "# CoordinateSystem = LPS\nn,1,2,3,0,0,0,1,1,1,0,a,,\nn,1,x,3\n");
  EXPECT_THAT(problemOfHandles(file), HasSubstr("Line 3"));
  EXPECT_THAT(problemOfHandles(folder.put("g.fcsv", "# CoordinateSystem = LPS\nn,1,2\n")),
              HasSubstr("coordinate z"));
  EXPECT_THAT(problemOfHandles(folder.put("h.fcsv", "# CoordinateSystem = LPS\nn,1,2,nan,0\n")),
              HasSubstr("Line 2"));
}

TEST(HandleFiles, LabelsThatAreLatin1BecomeUtf8AndStayApart) {
  const TemporaryFolder folder;
  const auto labels = [&](const std::string& name, const std::string& text) {
    std::vector<std::string> list;
    const HandleFile file = readHandles(folder.put(name, text));
    for (const HandleRecord& handle : file.groups.at(0).handles)
      list.push_back(handle.label);
    return list;
  };
  EXPECT_THAT(labels("a.fcsv", "# CoordinateSystem = LPS\n# columns = id,x,y,z,label\n1,0,0,0,N\xE4hte\n"
                               "2,1,0,0,N\xE5hte\n"),
              ElementsAre("N\xC3\xA4hte", "N\xC3\xA5hte"));
  EXPECT_THAT(labels("a.mrk.json", markups(R"({"label": "N)"
                                           "\xE4"
                                           R"(hte", "position": [0, 0, 0]})")),
              ElementsAre("N\xC3\xA4hte"));
}

} // namespace
} // namespace viscera::medical_io
