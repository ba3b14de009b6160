#include <cmath>
#include <sstream>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "cli_test.h"

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
  EXPECT_NEAR(result["stretch"]["max"].get<double>(), 3, 1e-8);
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
