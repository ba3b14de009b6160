#include <filesystem>
#include <sstream>

#include "build_paths.h"
#include "cli_test.h"
#include "label_files.h"
#include "packed_bytes.h"

namespace viscera::app::cli {

/// Standard input and output, pipes, formats by ending, and inputs that are not overwritten.
class CliStreams : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    cube_ = put("cube.off", cubeOff(10));
    options_.environment["VISCERA"] = VISCERA_PROGRAM;
  }

  /// Runs a line of the shell in the test's folder, with the program as "$VISCERA".
  test::ProcessResult shell(const std::string& line) const {
    return test::runProcess({"/bin/bash", "-c", "cd '" + folder_.string() + "' && " + line}, options_);
  }

  json shellJson(const std::string& line) const {
    const test::ProcessResult result = shell(line);
    EXPECT_EQ(result.exitCode, kOk) << line << "\n" << result.err;
    const json parsed = json::parse(result.out, nullptr, false);
    EXPECT_TRUE(parsed.is_object()) << result.out;
    return parsed.is_object() ? parsed : json::object();
  }

  /// The command has to refuse to overwrite this file, and to leave it as it was.
  void expectKept(const std::string& line, const std::string& file) const {
    const std::string before = contents(path(file));
    const test::ProcessResult result = shell(line);
    EXPECT_EQ(result.exitCode, kUsage) << line << "\n" << result.err;
    EXPECT_NE(result.err.find("--force"), std::string::npos) << result.err;
    EXPECT_EQ(contents(path(file)), before) << line;
  }

  std::string cube_;
};

TEST_F(CliStreams, StandardInputIsAFileOfTheKindThatItsBytesSay) {
  for (const char* line :
       {"cat cube.off | \"$VISCERA\" info - --json", "\"$VISCERA\" info - --json < cube.off",
        "\"$VISCERA\" info /dev/stdin --json < cube.off", "\"$VISCERA\" info <(cat cube.off) --json",
        "mkfifo pipe.off; cat cube.off > pipe.off & \"$VISCERA\" info pipe.off --json"})
    EXPECT_EQ(shellJson(line)["vertices"], 8) << line;
  EXPECT_EQ(shellJson("cat cube.off | \"$VISCERA\" info - --json")["name"], "stdin");
}

TEST_F(CliStreams, EveryKindOfFileComesThroughAPipe) {
  runJson({"convert", cube_, path("c.stl")});
  runJson({"convert", cube_, path("c.glb")});
  put("h.mrk.json", markups(corners(30)));
  tests::LabelImage labels = tests::emptyLabels();
  labels.fill({2, 2, 2}, {8, 9, 9}, 1);
  put("l.nii.gz", tests::gzipped(tests::niftiFile(labels)));
  const std::pair<const char*, const char*> kinds[] = {
      {"c.stl", "organ"}, {"c.glb", "organ"}, {"h.mrk.json", "handles"}, {"l.nii.gz", "label map"}};
  for (const auto& [file, kind] : kinds)
    EXPECT_EQ(shellJson("cat " + std::string(file) + " | \"$VISCERA\" info - --json")["kind"], kind) << file;
  const json bound = shellJson("cat h.mrk.json | \"$VISCERA\" bind cube.off --handles - --json");
  EXPECT_EQ(bound["handles"], 8);
}

TEST_F(CliStreams, AnErrorAboutAStreamNamesItAsTheUserDid) {
  const test::ProcessResult empty = shell("\"$VISCERA\" info - < /dev/null");
  EXPECT_NE(empty.exitCode, kOk);
  EXPECT_EQ(empty.err.find(std::filesystem::temp_directory_path().string() + "/viscera-"), std::string::npos)
      << empty.err;
  EXPECT_NE(shell("echo nonsense | \"$VISCERA\" info -").exitCode, kOk);
}

TEST_F(CliStreams, TablesAndHandlesGoToStandardOutputAlone) {
  const test::ProcessResult table = shell("\"$VISCERA\" circulate --csv -");
  EXPECT_EQ(table.exitCode, kOk) << table.err;
  EXPECT_EQ(table.out.substr(0, 7), "time_s,");
  EXPECT_NE(table.err.find("beats"), std::string::npos) << "the text goes to stderr: " << table.err;
  EXPECT_FALSE(std::filesystem::exists(path("-")));
  const json handles = shellJson("\"$VISCERA\" handles cube.off --count 12 -o -");
  EXPECT_TRUE(handles.contains("markups"));
  EXPECT_EQ(
      shellJson("\"$VISCERA\" handles cube.off --count 12 -o - | \"$VISCERA\" info - --json")["handles"], 12);
  expectFailure({"render", cube_, "-o", "-"}, kUsage, "standard output");
  const test::ProcessResult both = shell("\"$VISCERA\" circulate --csv - --json");
  EXPECT_EQ(both.exitCode, kUsage);
  expectError(both.out, kUsage);
}

TEST_F(CliStreams, OutputsTakeTheFormatOfTheirEndingOrRefuse) {
  const std::string handles = put("h.mrk.json", markups(corners(30)));
  for (const char* name : {"a.jpg", "a.tiff", "a"})
    expectFailure({"render", cube_, "-o", path(name)}, kUsage, ".png");
  EXPECT_EQ(run({cube_, "--screenshot", path("a.jpg")}).exitCode, kUsage);
  expectFailure({"bind", cube_, "--handles", handles, "-o", path("w.csv")}, kUsage, ".npy");
  expectFailure({"circulate", "--csv", path("c.xlsx")}, kUsage, ".csv or .txt");
  expectFailure({"circulate", "--png", path("c.svg")}, kUsage, ".png");
  expectFailure({"handles", cube_, "-o", path("h.stl")}, kUsage, ".mrk.json");
  expectFailure({"play", "heartbeat", "--sheet", path("s.gif")}, kUsage, ".png");
  EXPECT_EQ(files(), 2) << "nothing was written";
  EXPECT_EQ(run({"circulate", "--csv", "/dev/null"}).exitCode, kOk) << "a device takes what comes";
  EXPECT_EQ(run({"circulate", "--csv", path("C.CSV")}).exitCode, kOk);
}

TEST_F(CliStreams, AnInputIsNeverOverwritten) {
  std::filesystem::create_hard_link(cube_, path("hard.off"));
  std::filesystem::create_symlink("cube.off", path("soft.off"));
  put("h.mrk.json", markups(corners(30)));
  for (const char* out : {"cube.off", "./cube.off", "hard.off", "soft.off"}) {
    expectKept("\"$VISCERA\" convert cube.off " + std::string(out), "cube.off");
    expectKept("\"$VISCERA\" convert cube.off -o " + std::string(out), "cube.off");
    expectKept("\"$VISCERA\" deform cube.off --handles h.mrk.json --pose h.mrk.json -o " + std::string(out),
               "cube.off");
  }
  expectKept("\"$VISCERA\" convert h.mrk.json h.mrk.json --space RAS", "h.mrk.json");
  EXPECT_EQ(shell("\"$VISCERA\" convert cube.off cube.off --unit cm --force").exitCode, kOk);
  EXPECT_EQ(runJson({"info", cube_})["boundsMm"][1], 100.0);
  EXPECT_EQ(
      shell("\"$VISCERA\" convert cube.off other.off && \"$VISCERA\" convert cube.off other.off").exitCode,
      kOk)
      << "other files are written again";
}

TEST_F(CliStreams, AFileOfAFolderThatIsReadIsAnInput) {
  std::filesystem::create_directories(path("masks"));
  tests::LabelImage mask = tests::emptyLabels();
  mask.fill({2, 2, 2}, {8, 9, 9}, 1);
  put("masks/liver.nii", tests::niftiFile(mask));
  put("h.mrk.json", markups(corners(60)));
  expectKept("\"$VISCERA\" warp masks/liver.nii --handles h.mrk.json --pose h.mrk.json -o masks/liver.nii",
             "masks/liver.nii");
  expectKept("\"$VISCERA\" warp masks --handles h.mrk.json --pose h.mrk.json -o masks/liver.nii",
             "masks/liver.nii");
}

TEST_F(CliStreams, AFileThatASessionNamesIsAnInput) {
  put("case.viscera", R"({"organs": [{"name": "cube", "surface": {"file": "./cube.off"}}]})");
  put("h.mrk.json", markups(corners(30)));
  expectKept("\"$VISCERA\" deform case.viscera/cube --handles h.mrk.json --pose h.mrk.json -o cube.off",
             "cube.off");
}

TEST_F(CliStreams, TwoOutputsAreTwoFiles) {
  expectFailure({"play", "heartbeat", "--csv", path("v.csv"), "--write-handles", path("h.mrk.json"),
                 "--write-landmarks", path("h.mrk.json")},
                kUsage, "Two outputs");
}

} // namespace viscera::app::cli
