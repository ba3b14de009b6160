#include <algorithm>
#include <cmath>
#include <sstream>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "cli_test.h"
#include "viscera/live/sequence_file.h"

namespace viscera::app::cli {

class CliStress : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = put("cube.off", cubeOff(10));
    rest_ = put("rest.mrk.json", markups(corners(20)));
  }

  /// The corners with their x, y, z stretched.
  std::string stretched(double x, double y, double z) const {
    auto positions = corners(20);
    for (auto& p : positions)
      p = {x * p[0], y * p[1], z * p[2]};
    return put("pose.mrk.json", markups(positions));
  }

  std::vector<std::string> stress(const std::string& pose, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"stress", cube_, "--handles",   rest_,
                                          "--pose", pose,  "--witnesses", "500"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::string cube_;
  std::string rest_;
};

TEST_F(CliStress, OfAnAnisotropicScalingIsTheTextbookAngleEverywhere) {
  const json result = runJson(stress(stretched(3, 2, 1)));
  EXPECT_NEAR(result["witnesses"].get<double>(), 500, 75);
  EXPECT_GT(result["tetrahedra"], 500);
  EXPECT_EQ(result["folded"], 0);
  EXPECT_EQ(result["method"], "analytic");
  EXPECT_EQ(result["sampling"], "surface");
  for (const std::string key : {"min", "mean", "p95", "max"})
    EXPECT_NEAR(result["stressDegrees"][key].get<double>(), 30, 1e-6) << key;
  EXPECT_NEAR(result["volumeRatio"]["min"].get<double>(), 6, 1e-8);
  const std::string warnings = result["warnings"].dump();
  EXPECT_NE(warnings.find("Tissue is swollen to 600 % of its volume"), std::string::npos) << warnings;
  EXPECT_NEAR(result["stretch"]["max"].get<double>(), 3, 1e-8);
}

TEST_F(CliStress, PascalsAreOfAStatedMaterial) {
  const std::string pose = stretched(3, 2, 1);
  expectFailure(stress(pose, {"--quantity", "von-mises"}), kUsage, "--material");
  expectFailure(stress(pose, {"--material", "hair"}), kUsage, "liver");
  expectFailure(stress(pose, {"--poisson", "0.4"}), kUsage, "--young");
  EXPECT_FALSE(runJson(stress(pose)).contains("vonMisesKpa"));
  const json result = runJson(stress(pose, {"--material", "liver", "--quantity", "von-mises", "--histogram",
                                            path("h.csv"), "--csv", path("w.csv")}));
  // Squares of the stretches less one are 8, 3 and 0: von Mises 7 mu / J.
  EXPECT_NEAR(result["vonMisesKpa"]["max"].get<double>(), 7 * 6.27 / 2.98 / 6, 1e-6);
  EXPECT_EQ(result["material"]["doi"], "10.1002/jmri.24084");
  EXPECT_NE(contents(path("h.csv")).find("from_kPa,to_kPa,points,percent,material\n"), std::string::npos);
  EXPECT_NE(contents(path("w.csv")).find("liver (E 6.27 kPa)"), std::string::npos);
}

/// A cube of 20 mm of 4 x 4 x 4 hexahedra, in gmsh's format.
std::string cubeOfCells() {
  std::ostringstream nodes, cells;
  const auto corner = [](int i, int j, int k) { return 1 + i + 5 * j + 25 * k; };
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i) {
        nodes << corner(i, j, k) << ' ' << 5 * i - 10 << ' ' << 5 * j - 10 << ' ' << 5 * k - 10 << '\n';
        if (i == 4 || j == 4 || k == 4)
          continue;
        cells << 1 + i + 4 * j + 16 * k << " 5 2 1 1";
        for (const int up : {k, k + 1})
          cells << ' ' << corner(i, j, up) << ' ' << corner(i + 1, j, up) << ' ' << corner(i + 1, j + 1, up)
                << ' ' << corner(i, j + 1, up);
        cells << '\n';
      }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n125\n" + nodes.str() + "$EndNodes\n$Elements\n64\n" +
         cells.str() + "$EndElements\n";
}

TEST_F(CliStress, KeepsTheCellsOfAMeshUnlessOtherPointsAreAskedFor) {
  const std::string mesh = put("cube.msh", cubeOfCells());
  const std::vector<std::string> command = {"stress", mesh, "--handles", rest_, "--pose", stretched(3, 2, 1)};
  const json own = runJson(command);
  EXPECT_EQ(own["sampling"], "cells");
  EXPECT_EQ(own["witnesses"], 27);
  EXPECT_EQ(own["surfacePoints"], 98);
  EXPECT_NEAR(own["stressDegrees"]["mean"].get<double>(), 30, 1e-6);
  std::vector<std::string> anew = command;
  anew.insert(anew.end(), {"--witnesses", "500"});
  EXPECT_EQ(runJson(anew)["sampling"], "surface");
}

TEST_F(CliStress, ComparesTwoPosesPointByPoint) {
  const json result = runJson(stress(stretched(3, 2, 1), {"--before", rest_, "--difference", path("d.csv")}));
  const json& difference = result["difference"];
  for (const char* key : {"min", "mean", "p95", "max"}) {
    EXPECT_NEAR(difference["stressDegrees"][key].get<double>(), 30, 1e-6) << key;
    EXPECT_NEAR(difference["volumeRatio"][key].get<double>(), 5, 1e-8) << key;
  }
  EXPECT_EQ(difference["stressDegrees"]["missing"], 0);
  std::istringstream table(contents(path("d.csv")));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,stress_degrees_difference,"
                  "volume_ratio_difference,stretch_max_difference,stretch_min_difference");
  int rows = 0;
  while (std::getline(table, line))
    ++rows;
  EXPECT_EQ(rows, result["witnesses"]);
  // Itself before itself is no difference; a map in a fold has no value.
  const std::string pose = stretched(3, 2, 1);
  const json none = runJson(stress(pose, {"--before", pose, "--difference", path("d.vtu")}));
  EXPECT_EQ(none["difference"]["stressDegrees"]["max"], 0);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path("d.vtu").c_str());
  reader->Update();
  EXPECT_TRUE(reader->GetOutput()->GetPointData()->GetArray("stress_degrees_difference"));
  const json folded = runJson(stress(stretched(-1, 1, 1), {"--before", rest_}));
  EXPECT_EQ(folded["difference"]["stressDegrees"]["missing"], folded["witnesses"]);
  expectFailure(stress(pose, {"--difference", path("d.csv")}), kUsage, "--before");
}

TEST_F(CliStress, FollowsTheStressAtAProbeOverTheCycleOfASequence) {
  const auto points = [](double x, double y, double z) {
    Points all(8, 3);
    const auto at = corners(20);
    for (Eigen::Index i = 0; i < 8; ++i)
      all.row(i) << x * at[std::size_t(i)][0], y * at[std::size_t(i)][1], z * at[std::size_t(i)][2];
    return all;
  };
  live::SequenceFile file;
  file.track.restHandles = points(1, 1, 1);
  file.track.periodSeconds = 2;
  file.track.keys = {{0, points(1, 1, 1)}, {1, points(3, 2, 1)}};
  for (int i = 8; i > 0; --i)
    file.labels.push_back("H-" + std::to_string(9 - i));
  live::writeSequence(path("beat.sequence.json"), file);
  const json result = runJson(stress(rest_, {"--sequence", path("beat.sequence.json"), "--instants", "4",
                                             "--probe", "1,2,3", "--curve-csv", path("curve.csv")}));
  const json& course = result["overSequence"];
  EXPECT_EQ(course["periodMs"], 2000);
  EXPECT_EQ(course["timeMs"], (json{0, 500, 1000, 1500}));
  ASSERT_EQ(course["probes"].size(), 1U);
  EXPECT_NEAR(course["probes"][0]["stressDegrees"][0].get<double>(), 0, 1e-6);
  EXPECT_NEAR(course["probes"][0]["stressDegrees"][2].get<double>(), 30, 1e-6);
  EXPECT_NEAR(course["probes"][0]["volumeRatio"][2].get<double>(), 6, 1e-8);
  EXPECT_NEAR(course["stressDegrees"]["max"][2].get<double>(), 30, 1e-6);
  const std::string table = contents(path("curve.csv"));
  EXPECT_EQ(
      table.find("time_s,stress_degrees_min,stress_degrees_mean,stress_degrees_p95,stress_degrees_max,folded,"
                 "probe1_stress_degrees,probe1_volume_ratio,probe1_stretch_max,probe1_stretch_min\n"),
      0U)
      << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  file.labels.back() = "elsewhere";
  live::writeSequence(path("other.sequence.json"), file);
  expectFailure(stress(rest_, {"--sequence", path("other.sequence.json")}), kUsage, "elsewhere");
}

TEST_F(CliStress, OfABoneSaysThatABoneHasNone) {
  const json soft = runJson(stress(stretched(3, 2, 1)));
  EXPECT_EQ(soft["mobility"], "bends");
  std::vector<std::string> arguments = stress(stretched(3, 2, 1));
  arguments[1] = put("left_femur.off", cubeOff(10));
  EXPECT_EQ(runJson(arguments)["mobility"], "rigid");
  EXPECT_NE(run(arguments).err.find("is a bone, which moves as a rigid body and has no stress"),
            std::string::npos);
}

TEST_F(CliStress, CountsFoldedTissue) {
  const json result = runJson(stress(stretched(-1, 1, 1)));
  EXPECT_EQ(result["folded"], result["witnesses"]);
}

TEST_F(CliStress, WritesASolidThatVtkReadsAndATable) {
  const json result = runJson(stress(stretched(3, 2, 1), {"-o", path("s.vtu"), "--csv", path("s.csv")}));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path("s.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  EXPECT_EQ(grid->GetNumberOfCells(), result["tetrahedra"].get<int>());
  EXPECT_EQ(grid->GetNumberOfPoints(), result["witnesses"].get<int>() + result["surfacePoints"].get<int>());
  const auto first = [&](const char* name) {
    vtkDataArray* array = grid->GetPointData()->GetArray(name);
    EXPECT_TRUE(array) << name;
    return array ? array->GetComponent(0, 0) : std::nan("");
  };
  EXPECT_NEAR(first("RotationalStress_deg"), 30, 1e-6);
  EXPECT_NEAR(first("VolumeRatio"), 6, 1e-8);
  EXPECT_NEAR(first("StretchMax"), 3, 1e-8);
  EXPECT_NEAR(first("StretchMin"), 1, 1e-8);
  EXPECT_EQ(first("Folded"), 0);
  EXPECT_EQ(first("Witness"), 1);
  double box[6];
  grid->GetBounds(box); // In the pose.
  EXPECT_NEAR(box[1], 30, 1e-6);
  EXPECT_NEAR(box[5], 10, 1e-6);

  std::istringstream table(contents(path("s.csv")));
  std::string line;
  std::getline(table, line);
  EXPECT_NE(line.find("RotationalStress_deg,VolumeRatio,StretchMax,StretchMin,Folded"), std::string::npos);
  int rows = 0;
  while (std::getline(table, line))
    ++rows;
  EXPECT_EQ(rows, result["witnesses"].get<int>());
}

TEST_F(CliStress, SaysTheValuesAtProbes) {
  const json result =
      runJson(stress(stretched(3, 2, 1), {"--probe", "5,-1,2", "--probe", "-10,10,10", "--probe", "14,0,0",
                                          "--probes-csv", path("p.csv")}));
  const json& probes = result["probes"];
  ASSERT_EQ(probes.size(), 3u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(probes[i]["number"], i + 1);
    EXPECT_EQ(probes[i]["inTissue"], true) << "a corner of the surface is tissue";
    EXPECT_NEAR(probes[i]["stressDegrees"].get<double>(), 30, 1e-6);
    EXPECT_NEAR(probes[i]["volumeRatio"].get<double>(), 6, 1e-6);
    EXPECT_NEAR(probes[i]["stretchMax"].get<double>(), 3, 1e-6);
    EXPECT_NEAR(probes[i]["stretchMin"].get<double>(), 1, 1e-6);
    EXPECT_EQ(probes[i]["folded"], false);
  }
  EXPECT_EQ(probes[0]["restMm"], (json{5, -1, 2}));
  for (const auto& [axis, mm] : {std::pair(0, 15.0), std::pair(1, -2.0), std::pair(2, 2.0)})
    EXPECT_NEAR(probes[0]["positionMm"][static_cast<std::size_t>(axis)].get<double>(), mm, 1e-6);
  EXPECT_EQ(probes[2]["inTissue"], false);
  EXPECT_TRUE(probes[2]["stressDegrees"].is_null());
  const std::string said = run(stress(stretched(3, 2, 1), {"--probe", "14,0,0"})).err;
  EXPECT_NE(said.find("Probe 1 lies 4.0 mm outside"), std::string::npos) << said;
  const std::string table = contents(path("p.csv"));
  EXPECT_EQ(table.find("probe,rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,RotationalStress_deg,VolumeRatio,"
                       "StretchMax,StretchMin,Folded,stress_degrees,volume_ratio,stretch_max,stretch_min\n"
                       "1,5,-1,2,15,-2,2,30,6,3,1,0,30,6,3,1\n"),
            0u)
      << table;
  EXPECT_NE(table.find("\n3,14,0,0,,,,,,,,,,,,\n"), std::string::npos) << table;
}

TEST_F(CliStress, AProbeAtAWitnessSaysWhatItsRowOfTheTableSays) {
  auto positions = corners(20);
  positions[0] = {-31, -17, -24};
  positions[5][2] += 9;
  const std::string pose = put("uneven.mrk.json", markups(positions));
  runJson(stress(pose, {"--csv", path("s.csv")}));
  std::istringstream table(contents(path("s.csv")));
  std::string row;
  for (int line = 0; line < 40; ++line)
    std::getline(table, row);
  std::vector<std::string> cells;
  std::istringstream parts(row);
  for (std::string cell; std::getline(parts, cell, ',');)
    cells.push_back(cell);
  ASSERT_EQ(cells.size(), 15u);
  EXPECT_EQ(cells[11], cells[6]) << "by the names of JSON, too";
  const json probe =
      runJson(stress(pose, {"--probe", cells[0] + "," + cells[1] + "," + cells[2]}))["probes"][0];
  EXPECT_GT(probe["stressDegrees"].get<double>(), 0.1);
  EXPECT_NEAR(probe["stressDegrees"].get<double>(), std::stod(cells[6]), 1e-5);
  EXPECT_NEAR(probe["volumeRatio"].get<double>(), std::stod(cells[7]), 1e-6);
  EXPECT_NEAR(probe["positionMm"][0].get<double>(), std::stod(cells[3]), 1e-5);
}

TEST_F(CliStress, SaysTheValuesAlongALineWithGapsOutside) {
  const json result = runJson(stress(stretched(3, 2, 1), {"--profile", "-20,0,0:20,0,0:41", "--profile",
                                                          "0,0,0:0,5,0", "--profile-csv", path("l.csv")}));
  ASSERT_EQ(result["profiles"].size(), 2u);
  const json& across = result["profiles"][0];
  EXPECT_EQ(across["lengthMm"], 40.0);
  ASSERT_EQ(across["points"].size(), 41u);
  for (const json& point : across["points"]) {
    const double x = point["restMm"][0].get<double>();
    EXPECT_NEAR(point["distanceMm"].get<double>(), x + 20, 1e-9);
    EXPECT_EQ(point["inTissue"].get<bool>(), std::abs(x) <= 10) << x;
    if (std::abs(x) <= 10) {
      EXPECT_NEAR(point["stressDegrees"].get<double>(), 30, 1e-6);
    } else {
      EXPECT_TRUE(point["stressDegrees"].is_null());
    }
  }
  EXPECT_EQ(result["profiles"][1]["points"].size(), 101u);
  const std::string table = contents(path("l.csv"));
  EXPECT_EQ(table.find("profile,distance_mm,rest_x_mm,"), 0u);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 41 + 101);
  EXPECT_NE(table.find("\n1,0,-20,0,0,,,,,,,,,,,,\n"), std::string::npos) << table;
}

TEST_F(CliStress, RefusesProbesAndLinesThatAreNone) {
  const std::string pose = stretched(1, 1, 2);
  expectFailure(stress(pose, {"--probe", "1,2"}), kUsage, "--probe 1,2");
  expectFailure(stress(pose, {"--profile", "1,2,3"}), kUsage, "--profile 1,2,3");
  expectFailure(stress(pose, {"--profile", "1,2,3:4,5,6:1"}), kUsage, "from 2 to");
  expectFailure(stress(pose, {"--profile", "1,2,3:1,2,3"}), kUsage, "two places");
  expectFailure(stress(pose, {"--probes-csv", path("p.csv")}), kUsage, "--probe X,Y,Z");
  expectFailure(stress(pose, {"--profile-csv", path("p.csv")}), kUsage, "--profile X,Y,Z");
}

TEST_F(CliStress, ReadsASampleOrganAndSaysWhenTheSurfaceWasRepaired) {
  const std::string handles = path("h.mrk.json");
  runJson({"handles", "sample:stomach@low", "-o", handles, "--count", "20", "--enclosing"});
  const json result = runJson(
      {"stress", "sample:stomach@low", "--handles", handles, "--pose", handles, "--witnesses", "300"});
  EXPECT_LT(result["stressDegrees"]["max"], 1e-6);
  std::string open = cubeOff(10);
  open.replace(open.find("8 12 0"), 6, "8 10 0");
  open.erase(open.find("3 1 3 7")); // Without the last side.
  const auto said =
      run({"stress", put("open.off", open), "--handles", rest_, "--pose", rest_, "--witnesses", "200"});
  EXPECT_EQ(said.exitCode, kOk) << said.err;
  EXPECT_NE(said.err.find("repaired"), std::string::npos) << said.err;
}

TEST_F(CliStress, RefusesWhatCannotBe) {
  const std::string pose = stretched(1, 1, 2);
  expectFailure(stress(pose, {"-o", path("s.vtk")}), kCannotCreate, ".vtu");
  expectFailure({"stress", cube_, "--handles", rest_, "--pose", pose, "--witnesses", "100"}, kUsage, "200");
  expectFailure(
      {"stress", put("big.off", cubeOff(30)), "--handles", rest_, "--pose", pose, "--witnesses", "500"},
      kBadData, "no coordinates");
  expectFailure({"stress", path("none.stl"), "--handles", rest_, "--pose", pose}, kNoInput, "none.stl");
}

TEST_F(CliStress, LeastStressKeepsTheVolumeExactly) {
  const std::string handles = path("h.mrk.json");
  runJson({"handles", "sample:stomach@low", "-o", handles, "--count", "24", "--enclosing"});
  json moved = json::parse(contents(handles));
  json& position = moved["markups"].back()["controlPoints"][3]["position"];
  position[0] = position[0].get<double>() + 25;
  const std::string pose = put("pose.mrk.json", moved.dump());
  const auto deform = [&](const std::string& how) {
    return runJson({"deform", "sample:stomach@low", "--handles", handles, "--pose", pose, "--lock-volume",
                    "--restore", how, "--witnesses", "400"});
  };
  const json displacement = deform("least-displacement"), least = deform("least-stress");
  EXPECT_LT(std::abs(least["relativeVolumeError"].get<double>()), 1e-9);
  EXPECT_NE(least["maxDisplacementMm"], displacement["maxDisplacementMm"]);
  expectFailure(
      {"deform", "sample:stomach@low", "--handles", handles, "--pose", pose, "--restore", "least-stress"},
      kUsage, "--lock-volume");
}

TEST_F(CliStress, IsDrawnOnTheSurface) {
  const std::string pose = stretched(1, 1.5, 1);
  const auto draw = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render", cube_, rest_, "-o", path(name), "--size", "320x200"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runJson(arguments);
    return contents(path(name));
  };
  const std::string plain = draw("plain.png", {}), posed = draw("posed.png", {"--pose", pose});
  const std::string stressed = draw("stress.png", {"--pose", pose, "--stress"});
  EXPECT_NE(plain, posed);
  EXPECT_NE(posed, stressed);
  expectFailure({"render", cube_, rest_, "-o", path("x.png"), "--stress"}, kUsage, "--pose");
  expectFailure({"render", cube_, "-o", path("x.png"), "--pose", pose, "--stress"}, kUsage, "handle file");
}

} // namespace viscera::app::cli
