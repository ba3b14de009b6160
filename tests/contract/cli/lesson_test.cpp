#include "cli_test.h"

namespace viscera::app::cli {
namespace {

class CliLesson : public CliTest {
protected:
  static void expectKeys(const json& lesson) {
    for (const char* key : {"bytes", "frames", "modes", "largestErrorMm", "seconds"})
      EXPECT_TRUE(lesson[key].is_number()) << key << " in " << lesson.dump(2);
    EXPECT_TRUE(lesson["file"].is_string());
    ASSERT_TRUE(lesson["surfaces"].is_array());
    for (const json& surface : lesson["surfaces"])
      for (const char* key : {"title", "vertices", "triangles", "restMl"})
        EXPECT_TRUE(surface.contains(key)) << key;
  }
};

} // namespace

TEST_F(CliLesson, OfASequenceIsAPageOrAScene) {
  for (const std::string ending : {"html", "glb"}) {
    const std::string file = path("breath." + ending);
    const json lesson =
        runJson({"lesson", "breathing", "--organ", "sample:liver@low", "-o", file, "--handles", "8"});
    expectKeys(lesson);
    EXPECT_EQ(lesson["bytes"], std::filesystem::file_size(file));
    EXPECT_GE(lesson["modes"], 1);
    EXPECT_LE(lesson["largestErrorMm"], 0.05);
    EXPECT_GE(lesson["frames"], 9) << "instants where the motion needs them";
    EXPECT_EQ(lesson["surfaces"][0]["title"], "Liver");
  }
  EXPECT_NE(contents(path("breath.html")).find("viscera-lesson"), std::string::npos);
  EXPECT_EQ(contents(path("breath.glb")).substr(0, 4), "glTF");
  EXPECT_EQ(files(), 2);
}

TEST_F(CliLesson, OfTheStomachIsASceneThatCanBeMailed) {
  const json lesson = runJson({"lesson", "peristalsis", "-o", path("stomach.glb")});
  EXPECT_LE(lesson["bytes"], 3'000'000);
  EXPECT_LE(lesson["largestErrorMm"], 0.5);
  EXPECT_GE(lesson["modes"], 8);
}

TEST_F(CliLesson, TakesTitlesAndNames) {
  const std::string file = path("named.html");
  const json lesson = runJson(
      {"lesson", put("cube.off", cubeOff(30)), "-o", file, "--title", "A <b>cube</b>", "--name", "cube=Box"});
  EXPECT_EQ(lesson["surfaces"][0]["title"], "Box");
  EXPECT_EQ(lesson["modes"], 0);
  EXPECT_NE(contents(file).find("<title>A &lt;b&gt;cube&lt;/b&gt;</title>"), std::string::npos);
  const json spoken = runJson(
      {"lesson", path("cube.off"), "-o", file, "--spec", put("s.json", R"({"title": "From the file"})")});
  EXPECT_NE(contents(file).find("<title>From the file</title>"), std::string::npos);
}

TEST_F(CliLesson, SaysWhatIsWrong) {
  const std::string cube = put("cube.off", cubeOff(30));
  expectFailure({"lesson", cube, "-o", path("l.pdf")}, kUsage, ".html or .glb");
  expectFailure({"lesson", "-o", path("l.html")}, kUsage, "name a sequence");
  expectFailure({"lesson", "--ready", "-o", cube}, kCannotCreate, "folder cannot be made");
  expectFailure({"lesson", path("missing.stl"), "-o", path("l.html")}, kNoInput, "missing.stl");
  expectFailure({"lesson", cube, "-o", path("no/folder/l.html")}, kCannotCreate, "folder");
  expectFailure({"lesson", cube, "-o", path("l.html"), "--spec", put("bad.json", "[]")}, kBadData,
                "bad.json");
  expectFailure({"lesson", cube, "-o", path("l.html"), "--spec", path("none.json")}, kNoInput, "none.json");
  expectFailure({"lesson", cube, "-o", path("l.html"), "--name", "cube"}, kUsage, "--name cube");
  expectFailure({"lesson", "breathing", "--organ", "sample:liver@low", "--rate", "500", "-o", path("l.html")},
                kUsage, "a minute");
  EXPECT_EQ(files(), 2) << "nothing half-written is left";
}

} // namespace viscera::app::cli
