#include "cli_test.h"

#include <array>
#include <string>

namespace viscera::app::cli {

/// Commands on a file of several organs.
class CliSurfaceParts : public CliTest {
protected:
  /// Two cubes of 216 and 27 ml as OBJ groups with colours.
  std::string groups() const {
    put("groups.mtl", "newmtl m1\nKd 1 0.5 0\nnewmtl m2\nKd 0 0 1\nd 0.5\n");
    return put("groups.obj",
               "mtllib groups.mtl\n" + cube("Liver", "m1", 60, 0, 0) + cube("left_kidney", "m2", 30, 100, 8));
  }

  static std::string cube(const std::string& name, const std::string& material, int size, int at,
                          int before) {
    std::string text = "g " + name + "\nusemtl " + material + "\n";
    for (int i = 0; i < 8; ++i)
      text += "v " + std::to_string(at + ((i & 1) != 0 ? size : 0)) + " " +
              std::to_string((i & 2) != 0 ? size : 0) + " " + std::to_string((i & 4) != 0 ? size : 0) + "\n";
    for (const std::array<int, 4>& face : std::array<std::array<int, 4>, 6>{
             {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}}) {
      text += "f";
      for (const int corner : face)
        text += " " + std::to_string(corner + before);
      text += "\n";
    }
    return text;
  }
};

TEST_F(CliSurfaceParts, InfoListsTheOrgansAndDescribesOne) {
  const json all = runJson({"info", groups()});
  EXPECT_EQ(all["kind"], "organs");
  ASSERT_EQ(all["organs"].size(), 2u);
  EXPECT_EQ(all["organs"][0]["name"], "Liver");
  EXPECT_NEAR(all["organs"][0]["volumeMl"].get<double>(), 216, 1e-6);
  EXPECT_EQ(all["organs"][0]["color"], json::array({1.0, 0.5, 0.0}));
  EXPECT_NEAR(all["organs"][1]["volumeMl"].get<double>(), 27, 1e-6);
  EXPECT_EQ(all["organs"][1]["opacity"], 0.5);
  const json one = runJson({"info", groups() + "/Left kidney"});
  EXPECT_EQ(one["kind"], "organ");
  EXPECT_EQ(one["name"], "left_kidney");
  EXPECT_NEAR(one["volumeMl"].get<double>(), 27, 1e-6);
}

TEST_F(CliSurfaceParts, OneIsConvertedWhereOneIsNamedAndAllGoIntoAGlb) {
  EXPECT_EQ(runJson({"convert", groups() + "/liver", path("liver.stl")})["triangles"], 12);
  EXPECT_NEAR(runJson({"info", path("liver.stl")})["volumeMl"].get<double>(), 216, 1e-3);
  expectFailure({"convert", groups(), path("both.stl")}, kUsage, "2 organs: Liver, left_kidney");
  expectFailure({"convert", groups() + "/heart", path("both.stl")}, kUsage, "heart");
  const json both = runJson({"convert", groups(), path("both.glb"), "--space", "RAS"});
  EXPECT_EQ(both["organs"].size(), 2u);
  const json again = runJson({"info", path("both.glb")});
  EXPECT_EQ(again["space"], "RAS");
  EXPECT_EQ(again["organs"][1]["name"], "left_kidney");
  EXPECT_EQ(again["organs"][1]["color"], json::array({0.0, 0.0, 1.0}));
  EXPECT_EQ(again["organs"][1]["boundsMm"], runJson({"info", groups()})["organs"][1]["boundsMm"]);
}

TEST_F(CliSurfaceParts, ACommandThatTakesAnOrganAsksWhich) {
  expectFailure({"handles", groups(), "-o", path("h.mrk.json")}, kUsage, "left_kidney");
  EXPECT_GT(
      runJson({"handles", groups() + "/left_kidney", "--count", "8", "-o", path("h.mrk.json")})["handles"],
      3);
}

} // namespace viscera::app::cli
