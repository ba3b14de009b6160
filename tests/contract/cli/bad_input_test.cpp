#include "cli_test.h"

namespace viscera::app::cli {

/// Each kind of bad input is one clear message, a code of sysexits.h and nothing on standard output.
class CliBadInput : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    organ_ = put("cube.off", cubeOff(4));
    handles_ = put("good.mrk.json", markups(corners(10)));
  }

  void expectBadOrgan(const std::string& file, int code, const std::string& says) const {
    expectFailure({"info", file}, code, says);
    expectFailure({"bind", file, "--handles", handles_}, code, says);
  }

  void expectBadHandles(const std::string& file, int code, const std::string& says) const {
    expectFailure({"bind", organ_, "--handles", file}, code, says);
    expectFailure({"deform", organ_, "--handles", file, "--pose", handles_}, code, says);
  }

  std::string organ_;
  std::string handles_;
};

TEST_F(CliBadInput, MissingFiles) {
  expectBadOrgan(path("missing.stl"), kNoInput, "missing.stl");
  expectBadHandles(path("missing.mrk.json"), kNoInput, "missing.mrk.json");
  EXPECT_EQ(run({path("missing.stl"), "--screenshot", path("window.png")}).exitCode, kNoInput)
      << "for the window, which opens without them else";
}

TEST_F(CliBadInput, EmptyFiles) {
  for (const std::string name : {"a.stl", "a.obj", "a.ply", "a.off", "a.vtk", "a.vtp", "a.glb"})
    expectBadOrgan(put(name, ""), kBadData, name);
  expectBadHandles(put("empty.mrk.json", ""), kBadData, "empty.mrk.json");
}

TEST_F(CliBadInput, TruncatedFiles) {
  for (const std::string ending : {"stl", "obj", "ply", "off", "vtk", "vtp", "glb"}) {
    const std::string whole = path("whole." + ending);
    ASSERT_EQ(run({"sample", "stomach", "--resolution", "low", "-o", whole}).exitCode, kOk) << ending;
    const std::string bytes = contents(whole);
    ASSERT_GT(bytes.size(), 1000u) << ending;
    // Text formats without counts lose their end without a trace when cut between lines; so cut within one.
    const std::string cut = put("cut." + ending, bytes.substr(0, bytes.size() * 2 / 3));
    if (ending == "obj")
      continue; // Nothing in an OBJ file says how long it is: a shorter one is another, open surface.
    expectBadOrgan(cut, kBadData, "cut." + ending);
  }
  expectBadHandles(put("cut.mrk.json", markups(corners(10)).substr(0, 300)), kBadData, "cut.mrk.json");
}

TEST_F(CliBadInput, WronglyNamedFiles) {
  expectBadOrgan(put("is_off.stl", cubeOff(4)), kBadData, "is_off.stl");
  expectBadOrgan(put("is_off.ply", cubeOff(4)), kBadData, "is_off.ply");
  expectBadOrgan(put("is_text.vtp", "Dear reader, this is a letter.\n"), kBadData, "is_text.vtp");
  expectBadOrgan(put("is_png.obj", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)), kBadData, "is_png.obj");
  expectBadHandles(put("is_off.mrk.json", cubeOff(4)), kBadData, "is_off.mrk.json");
  EXPECT_EQ(runJson({"info", put("cube.xyz", cubeOff(4))})["triangles"], 12) << "no format ends so";
  expectFailure({"info", put("heart.step", "ISO-10303-21;\n")}, kBadData, "a CAD model");
}

TEST_F(CliBadInput, AFolderOfOneFileIsThatFile) {
  std::filesystem::create_directory(path("study"));
  put("study/organ", cubeOff(4));
  EXPECT_EQ(runJson({"info", path("study")})["triangles"], 12);
  put("study/organ", "ISO-10303-21;\n");
  std::filesystem::rename(path("study/organ"), path("study/heart.step"));
  expectFailure({"info", path("study")}, kBadData, "a CAD model");
  std::filesystem::create_directory(path("empty"));
  expectFailure({"info", path("empty")}, kNoInput, "a folder");
}

TEST_F(CliBadInput, DegenerateSurfaces) {
  expectBadOrgan(put("no_triangles.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), kBadData, "no_triangles.off");
  expectBadOrgan(put("one_place.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n"), kBadData,
                 "one_place.off");
  expectBadOrgan(put("bad_index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"), kBadData,
                 "bad_index.off");
}

TEST_F(CliBadInput, CoordinatesThatAreNotNumbers) {
  expectBadOrgan(put("nan.off", "OFF\n4 2 0\n0 0 0\nnan 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n"), kBadData,
                 "nan.off");
  expectBadOrgan(put("inf.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n"), kBadData, "inf.obj");
  json file = json::parse(markups(corners(10)));
  file["markups"][0]["controlPoints"][2]["position"][1] = nullptr;
  expectBadHandles(put("null.mrk.json", file.dump()), kBadData, "point 3");
  std::string text = markups(corners(10));
  text.replace(text.find("-10.0"), 5, "NaN");
  expectBadHandles(put("nan.mrk.json", text), kBadData, "nan.mrk.json");
}

TEST_F(CliBadInput, AnOrganOutsideTheHullSaysHowManyVertices) {
  const std::string large = put("large.off", cubeOff(20));
  expectFailure({"bind", large, "--handles", handles_}, kBadData, "8 ");
  expectFailure({"bind", large, "--handles", handles_}, kBadData, "outside");
  expectFailure({"bind", large, "--handles", handles_}, kBadData, "enclosing");
  const std::string out = path("out.stl");
  expectFailure({"deform", large, "--handles", handles_, "--pose", handles_, "-o", out}, kBadData, "outside");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(CliBadInput, FewerThanFourHandles) {
  expectBadHandles(put("three.mrk.json", markups({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}})), kBadData, "four");
  expectBadHandles(put("none.mrk.json", markups({})), kBadData, "none.mrk.json");
}

TEST_F(CliBadInput, HandlesInOnePlane) {
  expectBadHandles(
      put("flat.mrk.json", markups({{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}, {0, 3, 0}})),
      kBadData, "plane");
}

TEST_F(CliBadInput, TwoHandlesAtOnePlace) {
  auto positions = corners(10);
  positions.push_back(positions[5]);
  expectBadHandles(put("twice.mrk.json", markups(positions)), kBadData, "H-9");
}

TEST_F(CliBadInput, APoseOfOtherHandles) {
  auto positions = corners(10);
  positions.push_back({1, 2, 30});
  const std::string pose = put("other.mrk.json", markups(positions));
  expectFailure({"deform", organ_, "--handles", handles_, "--pose", pose}, kBadData, "H-9");
}

TEST_F(CliBadInput, OutputsThatCannotBeWritten) {
  const std::string nowhere = path("no such folder/out");
  expectFailure({"bind", organ_, "--handles", handles_, "-o", nowhere + ".npy"}, kCannotCreate, "out.npy");
  expectFailure({"handles", organ_, "-o", nowhere + ".mrk.json", "--count", "8"}, kCannotCreate,
                "out.mrk.json");
  expectFailure({"deform", organ_, "--handles", handles_, "--pose", handles_, "-o", nowhere + ".stl"},
                kCannotCreate, "out.stl");
  expectFailure({"render", organ_, "-o", nowhere + ".png"}, kCannotCreate, "out.png");
  expectFailure({"sample", "stomach@low", "-o", nowhere + ".stl"}, kCannotCreate, "out.stl");
}

TEST_F(CliBadInput, LeavesExistingOutputsAlone) {
  const std::string out = put("weights.npy", "precious");
  expectFailure({"bind", put("large.off", cubeOff(20)), "--handles", handles_, "-o", out}, kBadData,
                "outside");
  EXPECT_EQ(contents(out), "precious");
}

} // namespace viscera::app::cli
