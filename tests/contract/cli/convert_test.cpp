#include "cli_test.h"

#include <algorithm>
#include <cstring>

#include "viscera/core/arrays.h"

namespace viscera::app::cli {

/// `viscera convert`, and what `viscera deform` writes for other programs.
class CliConvert : public CliTest {
protected:
  /// The cube with a corner at (60, 70, 80) cut off its side at x = 60: open, if `open`.
  std::string cube(bool open = false) const {
    std::string text = cubeOff(60);
    if (open) {
      text.replace(text.find("8 12 0"), 6, "8 11 0");
      text.resize(text.rfind("3 1 7 5"));
    }
    return put(open ? "open.off" : "cube.off", text);
  }

  static bool saysOf(const json& outcome, const std::string& words) {
    return outcome["warnings"].dump().find(words) != std::string::npos;
  }
};

TEST_F(CliConvert, GoesThroughEveryFormatAndBackToTheSameBytes) {
  const std::string first = path("first.ply");
  EXPECT_EQ(runJson({"convert", cube(), first})["triangles"], 12);
  std::string last = first;
  for (const char* name : {"a.stl", "b.obj", "c.vtp", "d.vtk", "e.off", "f.glb", "g.ply"}) {
    const json outcome = runJson({"convert", last, path(name)});
    EXPECT_EQ(outcome["in"], last);
    EXPECT_EQ(outcome["out"], path(name));
    EXPECT_EQ(outcome["vertices"], 8) << name;
    EXPECT_EQ(outcome["triangles"], 12) << name;
    EXPECT_EQ(outcome["repairs"], json::array());
    last = path(name);
  }
  // The name goes along where the format has a place for it.
  EXPECT_EQ(runJson({"info", path("a.stl")})["name"], "cube");
  EXPECT_EQ(runJson({"info", last})["boundsMm"], runJson({"info", cube()})["boundsMm"]);
}

TEST_F(CliConvert, TheOutputMayBeNamedAsWithOtherCommands) {
  EXPECT_EQ(runJson({"convert", cube(), "-o", path("a.stl")})["out"], path("a.stl"));
  EXPECT_EQ(runJson({"convert", "--output", path("b.stl"), cube()})["vertices"], 8);
  expectFailure({"convert", cube()}, kUsage, "-o");
  expectFailure({"convert", cube(), cube(), "-o", path("d.stl")}, kUsage, "one by one");
}

TEST_F(CliConvert, WritesTheAxesAskedForAndSaysSoInTheFile) {
  EXPECT_EQ(runJson({"convert", cube(), path("ras.stl"), "--space", "RAS"})["space"], "RAS");
  EXPECT_NE(contents(path("ras.stl")).find("SPACE=RAS"), std::string::npos);
  const json info = runJson({"info", path("ras.stl")});
  EXPECT_EQ(info["space"], "RAS");
  EXPECT_EQ(info["spaceStated"], true);
  EXPECT_EQ(info["outward"], true);
}

TEST_F(CliConvert, AFileThatDoesNotSayThatItIsRasIsTurned) {
  const std::string file =
      put("t.off", "OFF\n4 4 0\n0 0 0\n90 0 0\n0 90 0\n0 0 90\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  runJson({"convert", file, path("lps.ply"), "--from-space", "RAS"});
  EXPECT_EQ(runJson({"info", path("lps.ply")})["boundsMm"], json::array({-90.0, 0.0, -90.0, 0.0, 0.0, 90.0}));
}

TEST_F(CliConvert, RepairsBySizeAndWithAResolution) {
  const std::string file = put("stomach.off", cubeOff(2700));
  const json scaled = runJson({"convert", file, path("tenth.ply"), "--scale", "0.1"});
  EXPECT_EQ(scaled["repairs"], json::array({"scale=0.1"}));
  EXPECT_EQ(runJson({"info", path("tenth.ply")})["boundsMm"][1], 270);
  runJson({"convert", file, path("stomach.ply"), "--scale", "life-size"});
  const double volume = runJson({"info", path("stomach.ply")})["volumeMl"];
  EXPECT_GT(volume, 700);
  EXPECT_LT(volume, 1100);
  const json fine = runJson({"convert", path("stomach.ply"), path("fine.ply"), "--resolution", "2"});
  const json coarse = runJson({"convert", path("stomach.ply"), path("coarse.ply"), "--resolution", "8"});
  EXPECT_GT(fine["triangles"], coarse["triangles"]);
  EXPECT_EQ(fine["repairs"], json::array({"remesh"}));
  EXPECT_EQ(
      runJson({"convert", path("fine.ply"), path("same.ply"), "--remove-fragments", "5mm"})["triangles"],
      fine["triangles"]);
  EXPECT_EQ(run({"convert", file, path("no.ply"), "--remove-fragments", "5kg"}).exitCode, 64);
  EXPECT_EQ(run({"convert", put("thing.off", cubeOff(60)), path("no.ply"), "--scale", "life-size"}).exitCode,
            65);
}

TEST_F(CliConvert, UnitsAreThoseOfTheInput) {
  const std::string metres = put("metres.off", cubeOff(0.06));
  EXPECT_TRUE(saysOf(runJson({"info", metres}), "metres"));
  const json outcome = runJson({"convert", metres, path("mm.ply"), "--unit", "m"});
  EXPECT_FALSE(saysOf(outcome, "metres")) << "the converted one is as large as it should be";
  EXPECT_NEAR(runJson({"info", path("mm.ply")})["volumeMl"].get<double>(), 1728, 1e-9);
  EXPECT_EQ(run({"convert", metres, path("x.ply"), "--unit", "yard"}).exitCode, kUsage);
}

TEST_F(CliConvert, RepairsOnlyWhatItIsAskedTo) {
  EXPECT_EQ(runJson({"convert", cube(true), path("same.ply")})["closed"], false);
  EXPECT_EQ(runJson({"info", path("same.ply")})["boundaryEdges"], 3);
  const json filled = runJson({"convert", cube(true), path("filled.ply"), "--fill-holes"});
  EXPECT_EQ(filled["closed"], true);
  EXPECT_EQ(filled["repairs"], json::array({"fill-holes"}));
  EXPECT_FALSE(saysOf(filled, "open"));
  const json mirrored = runJson({"convert", cube(), path("mirrored.ply"), "--mirror"});
  EXPECT_EQ(mirrored["repairs"], json::array({"mirror"}));
  EXPECT_EQ(runJson({"info", path("mirrored.ply")})["outward"], true);
  const json anew = runJson({"convert", cube(), path("anew.ply"), "--remesh", "800"});
  EXPECT_EQ(anew["closed"], true);
  EXPECT_NEAR(anew["triangles"].get<double>(), 800, 100);
  EXPECT_EQ(anew["remesh"]["trianglesBefore"], 12);
  EXPECT_GT(anew["remesh"]["maximumMm"], 0.1) << "the corners of the cube are rounded";
  EXPECT_LT(anew["remesh"]["maximumMm"], 3);
  EXPECT_LE(anew["remesh"]["meanMm"], anew["remesh"]["maximumMm"]);
}

TEST_F(CliConvert, HandlesGoToTheOldTableAndBackBitForBit) {
  const std::string first = put(
      "h.mrk.json", markups({{0.1, 1.0 / 3.0, -57.000000000000007}, {1e-300, 2, 3}, {4, 5, 6}, {7, 8, 1}}));
  EXPECT_EQ(runJson({"convert", first, path("h.fcsv"), "--space", "RAS"})["vertices"], 4);
  EXPECT_NE(contents(path("h.fcsv")).find("CoordinateSystem = RAS"), std::string::npos);
  runJson({"convert", path("h.fcsv"), path("again.mrk.json")});
  const json before = json::parse(contents(first)), after = json::parse(contents(path("again.mrk.json")));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(before["markups"][0]["controlPoints"][i]["position"],
              after["markups"][0]["controlPoints"][i]["position"]);
}

TEST_F(CliConvert, RefusesWhatMakesNoSenseAndLeavesNothing) {
  const std::string handles = put("h.mrk.json", markups(corners(10)));
  const std::string surface = cube();
  const std::ptrdiff_t before = files();
  expectFailure({"convert", handles, path("h.stl")}, kUsage, "h.stl");
  expectFailure({"convert", surface, path("c.mrk.json")}, kUsage, "c.mrk.json");
  expectFailure({"convert", handles, path("h.fcsv"), "--fill-holes"}, kUsage, "Handles");
  expectFailure({"convert", surface, path("c.xyz")}, kCannotCreate, "c.xyz");
  expectFailure({"convert", path("none.stl"), path("c.stl")}, kNoInput, "none.stl");
  EXPECT_EQ(files(), before);
}

TEST_F(CliConvert, InfoSaysWhatTheImportPanelSays) {
  const json info = runJson({"info", cube(true)});
  EXPECT_EQ(info["selfIntersections"], 0);
  bool open = false;
  for (const json& finding : info["findings"])
    if (finding["light"] == "fault") {
      open = true;
      EXPECT_EQ(finding["repairs"][0], "fill-holes");
    }
  EXPECT_TRUE(open);
}

TEST_F(CliConvert, DeformWritesDisplacementsAndAFieldThatLeadsBack) {
  const std::string rest = put("rest.mrk.json", markups(corners(200)));
  auto moved = corners(200);
  for (auto& corner : moved)
    corner[0] += 12; // All of them: the space is shifted by 12 mm.
  const json outcome =
      runJson({"deform", cube(), "--handles", rest, "--pose", put("pose.mrk.json", markups(moved)),
               "--displacement", path("d.vtp"), "--transform", path("t.nrrd"), "--spacing", "20"});
  EXPECT_EQ(outcome["displacement"], path("d.vtp"));
  EXPECT_EQ(outcome["transform"]["unreached"], 0);
  EXPECT_EQ(runJson({"info", path("d.vtp")})["boundsMm"][0], -60.0) << "the rest surface";
  const std::string bytes = contents(path("t.nrrd"));
  const std::size_t begin = bytes.find("\n\n") + 2;
  const auto size = outcome["transform"]["size"];
  const std::size_t points =
      size[0].get<std::size_t>() * size[1].get<std::size_t>() * size[2].get<std::size_t>();
  ASSERT_EQ(bytes.size() - begin, 24 * points);
  double vector[3];
  std::memcpy(vector, bytes.data() + begin + 24 * (points / 2), sizeof vector);
  EXPECT_NEAR(vector[0], -12, 1e-6) << "from the posed space back to rest";
  EXPECT_NEAR(vector[1], 0, 1e-6);
  expectFailure({"deform", cube(), "--handles", rest, "--pose", rest, "--transform", path("t.xyz")},
                kCannotCreate, "t.xyz");
}

/// Boxes in and beside one another, as OFF.
class CliConvertOrgans : public CliConvert {
protected:
  /// A box of that edge with its low corner at that place, on all axes.
  std::string boxFile(const std::string& name, double low, double edge) const {
    return boxFile(name, edge, Vec3::Constant(low + edge / 2));
  }

  /// A box of that edge about a place.
  std::string boxFile(const std::string& name, double edge, const Vec3& middle) const {
    const auto at = [&](int axis, int high) { return std::to_string(middle[axis] + (high - 0.5) * edge); };
    std::string text = "OFF\n8 12 0\n";
    for (int i = 0; i < 8; ++i)
      text += at(0, i & 1) + " " + at(1, i >> 1 & 1) + " " + at(2, i >> 2 & 1) + "\n";
    return put(name, text +
                         "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n"
                         "3 0 6 2\n3 1 3 7\n3 1 7 5\n");
  }
};

TEST_F(CliConvertOrgans, SeveralInputsBecomeOrgansOfOnePrint) {
  const std::string liver = boxFile("liver.off", 0, 80), spleen = boxFile("spleen.off", 100, 40);
  const json outcome = runJson({"convert", liver, spleen, path("all.3mf")});
  ASSERT_EQ(outcome["organs"].size(), 2U);
  EXPECT_EQ(outcome["organs"][1]["name"], "spleen");
  EXPECT_EQ(outcome["triangles"], 24);
  const json again = runJson({"convert", path("all.3mf"), path("all.glb")});
  ASSERT_EQ(again["organs"].size(), 2U);
  EXPECT_EQ(again["organs"][0]["name"], "liver");
  EXPECT_NE(run({"convert", liver, spleen, path("all.stl")}).exitCode, 0);
  EXPECT_NE(run({"convert", liver, spleen, path("all.3mf"), "--mirror"}).exitCode, 0);
}

TEST_F(CliConvertOrgans, SayFirstWhatIsDoubtfulAboutThePatient) {
  struct Place {
    const char* name;
    Vec3 at; ///< In LPS.
  };
  const Place places[] = {{"liver", {-50, -65, 35}},       {"spleen", {90, -28, 45}},
                          {"kidney_left", {62, -23, -10}}, {"kidney_right", {-62, -23, -10}},
                          {"stomach", {45, -92, 40}},      {"bladder", {0, -85, -250}}};
  const auto converted = [&](const std::string& name, const Vec3& signs) {
    std::vector<std::string> arguments{"convert"};
    for (const Place& place : places)
      arguments.push_back(
          boxFile("p_12_" + std::string(place.name) + ".off", 40, signs.cwiseProduct(place.at)));
    arguments.push_back(path(name));
    return runJson(arguments);
  };
  const json lps = converted("lps.glb", {1, 1, 1});
  EXPECT_EQ(lps["patient"]["axes"], "LPS") << lps;
  EXPECT_FALSE(saysOf(lps, "exchanged")) << lps["warnings"];
  const json ras = converted("ras.glb", {-1, -1, 1});
  EXPECT_EQ(ras["patient"]["axes"], "RAS");
  EXPECT_EQ(ras["patient"]["repairs"][0], "ras-to-lps");
  ASSERT_FALSE(ras["warnings"].empty());
  EXPECT_NE(ras["warnings"][0].dump().find("RAS"), std::string::npos) << ras["warnings"];
  EXPECT_EQ(converted("mirrored.glb", {-1, 1, 1})["patient"]["axes"], "mirrored");
  const json again = runJson({"convert", path("ras.glb"), path("ras.3mf")});
  EXPECT_EQ(again["patient"]["axes"], "RAS") << "all organs of one file";
  EXPECT_EQ(
      runJson({"convert", path("ras.glb"), path("turned.3mf"), "--from-space", "RAS"})["patient"]["axes"],
      "LPS");
}

TEST_F(CliConvertOrgans, ASampleOrganIsPrintedWithHollowCavities) {
  const json outcome = runJson({"convert", "sample:heart@low", path("heart.3mf")});
  ASSERT_GT(outcome["organs"].size(), 4U);
  EXPECT_TRUE(outcome["organs"][0]["cavityOf"].is_null());
  EXPECT_EQ(outcome["organs"][1]["cavityOf"], 0);
  const json info = runJson({"info", path("heart.3mf")});
  EXPECT_EQ(info["components"], outcome["organs"].size());
}

TEST_F(CliConvertOrgans, AnOrganBecomesTetrahedraAroundItsCavities) {
  const std::string outer = boxFile("outer.off", 0, 80), cavity = boxFile("ventricle.off", 20, 30);
  const json outcome = runJson({"convert", outer, path("a.inp"), "--cavity", cavity, "--element-size", "12"});
  EXPECT_NEAR(outcome["volumeMl"].get<double>(), 512 - 27, 1e-6);
  ASSERT_EQ(outcome["walls"].size(), 2U);
  EXPECT_EQ(outcome["walls"][0]["name"], "OUTER");
  EXPECT_EQ(outcome["walls"][1]["name"], "ventricle");
  EXPECT_EQ(outcome["walls"][1]["nodes"], 8);
  const std::string inp = contents(path("a.inp"));
  for (const char* part : {"*NODE, NSET=NALL", "TYPE=C3D4, ELSET=OUTER", "*NSET, NSET=OUTER",
                           "*NSET, NSET=VENTRICLE", "*SURFACE, NAME=VENTRICLE_FACES, TYPE=ELEMENT"})
    EXPECT_NE(inp.find(part), std::string::npos) << part;
  const json coarse = runJson({"convert", outer, path("a.vtu")});
  EXPECT_LT(coarse["tetrahedra"], outcome["tetrahedra"]);
  EXPECT_NE(run({"convert", outer, cavity, path("b.inp")}).exitCode, 0) << "two organs";
  EXPECT_NE(run({"convert", outer, path("b.stl"), "--element-size", "3"}).exitCode, 0);
  EXPECT_NE(run({"convert", outer, path("b.inp"), "--cavity", boxFile("out.off", 70, 30)}).exitCode, 0);
}

TEST_F(CliConvertOrgans, TetrahedraAreJudgedAsSurfacesAre) {
  const std::string tiny = boxFile("liver.off", 0, 20);
  const json surface = runJson({"convert", tiny, path("b.stl")});
  ASSERT_FALSE(surface["warnings"].empty()) << "a liver of 8 ml";
  for (const char* ending : {"b.inp", "b.vtu"}) {
    const json solid = runJson({"convert", tiny, path(ending)});
    for (const json& warning : surface["warnings"])
      EXPECT_EQ(std::count(solid["warnings"].begin(), solid["warnings"].end(), warning), 1)
          << warning << " of " << solid["warnings"];
  }
}

TEST_F(CliConvertOrgans, TheSampleHeartIsFilledUpToItsCavities) {
  const json sample = runJson({"sample", "heart", "--resolution", "low"});
  const json outcome = runJson({"convert", "sample:heart@low", path("heart.inp")});
  double volumeMl = sample["volumeMl"].get<double>();
  for (std::size_t i = 1; i < sample["surfaces"].size(); ++i)
    volumeMl -= sample["surfaces"][i]["volumeMl"].get<double>();
  EXPECT_NEAR(outcome["volumeMl"].get<double>(), volumeMl, 1e-4);
  ASSERT_EQ(outcome["walls"].size(), sample["surfaces"].size());
  for (std::size_t i = 0; i < sample["surfaces"].size(); ++i)
    EXPECT_EQ(outcome["walls"][i]["nodes"], sample["surfaces"][i]["vertices"]);
}

} // namespace viscera::app::cli
