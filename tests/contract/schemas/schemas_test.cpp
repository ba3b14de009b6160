#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "run_process.h"
#include "session_scene.h"
#include "viscera/medical_io/handle_file.h"

/// What is written for other programs follows the schemas that say what it is; a validator that is not ours
/// says so.
namespace viscera::document {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

constexpr int kFollows = 0;
constexpr int kBreaks = 1;
constexpr int kNoValidator = 77;

const std::string kMarkups = VISCERA_SCHEMAS "/markups-1.0.3.schema.json";
const std::string kSession = VISCERA_SOURCE_DIR "/resources/schema/session-2.schema.json";

/// Exit code 0: every file follows the schema; 1: the output says which does not, where and why.
test::ProcessResult validate(const std::string& schema, const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> command = {VISCERA_PYTHON, VISCERA_SCHEMAS "/validate.py", schema};
  for (const auto& file : files)
    command.push_back(file.string());
  return test::runProcess(command);
}

class Schemas : public testing::Test {
protected:
  void SetUp() override {
    const test::ProcessResult result = validate(kSession, {});
    if (result.exitCode == kNoValidator || result.exitCode == 127)
      GTEST_SKIP() << "python3 has no module jsonschema (Debian's package python3-jsonschema)";
    ASSERT_EQ(result.exitCode, kFollows) << result.err;
  }

  void expectFollows(const std::string& schema, const std::vector<std::filesystem::path>& files) const {
    const test::ProcessResult result = validate(schema, files);
    EXPECT_EQ(result.exitCode, kFollows) << result.out << result.err;
  }

  /// A file that follows the schema breaks it with `value` at `place`, and that is what is said.
  void expectBreaks(const std::string& schema, const json& good, const std::string& place,
                    const json& value) const {
    json bad = good;
    bad[json::json_pointer(place)] = value;
    const test::ProcessResult result = validate(schema, {folder_.put("bad.json", bad.dump())});
    EXPECT_EQ(result.exitCode, kBreaks) << place << " = " << value << "\n" << result.err;
    const std::string parent = place.substr(0, place.rfind('/'));
    EXPECT_THAT(result.out, HasSubstr("bad.json: " + (parent.empty() ? "/" : parent)));
  }

  void run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), VISCERA_PROGRAM);
    const test::ProcessResult result = test::runProcess(arguments, {{{"DISPLAY", {}}}, {}});
    ASSERT_EQ(result.exitCode, 0) << result.err;
  }

  /// Overlapping groups, a locked handle, a hidden one and one with a description, as the window saves them.
  std::filesystem::path savedHandles() const {
    const SessionContents contents = tests::fullContents(folder_);
    medical_io::writeHandles(folder_ / "saved.mrk.json", handleFile(*contents.state.rig));
    return folder_ / "saved.mrk.json";
  }

  TemporaryFolder folder_;
};

TEST_F(Schemas, HandlesOfTheCommandLineFollowSlicersMarkups) {
  const std::string organ = tests::ballFile(folder_, "ball.vtp").string();
  const auto file = [&](const char* name) { return (folder_ / name).string(); };
  run({"handles", organ, "--count", "20", "--enclosing", "-o", file("plain.mrk.json")});
  run({"handles", organ, "--count", "24", "--groups", "3", "-o", file("groups.mrk.json")});
  run({"convert", file("groups.mrk.json"), file("ras.mrk.json"), "--space", "RAS"});
  expectFollows(kMarkups, {file("plain.mrk.json"), file("groups.mrk.json"), file("ras.mrk.json")});
  EXPECT_GE(json::parse(contentsOf(file("groups.mrk.json")))["markups"].size(), 3u);
}

TEST_F(Schemas, HandlesThatTheWindowSavesFollowSlicersMarkups) {
  const std::filesystem::path saved = savedHandles();
  const json file = json::parse(contentsOf(saved));
  ASSERT_GE(file.at("markups").size(), 2u);
  const std::string text = file.dump();
  ASSERT_THAT(text, HasSubstr("\"locked\":true"));
  ASSERT_THAT(text, HasSubstr("why it is here"));
  tests::Session session;
  medical_io::writeHandles(folder_ / "none.mrk.json", handleFile(Rig{}));
  medical_io::writeHandles(folder_ / "plain.mrk.json", handleFile(session.document.rig()));
  expectFollows(kMarkups, {saved, folder_ / "none.mrk.json", folder_ / "plain.mrk.json"});
}

TEST_F(Schemas, BrokenMarkupsAreRefused) {
  const json good = json::parse(contentsOf(savedHandles()));
  for (const auto& [place, value] :
       {std::pair("/@schema", json(3)), std::pair("/@schema", json("markups-schema-v9.json#")),
        std::pair("/markups", json::object()), std::pair("/markups/0/type", json("Points")),
        std::pair("/markups/0/type", json(nullptr)), std::pair("/markups/0/coordinateSystem", json("lps")),
        std::pair("/markups/0/coordinateUnits", json("cm")), std::pair("/markups/0/locked", json("no")),
        std::pair("/markups/0/colour", json("red")), std::pair("/markups/0/display/opacity", json(1.1)),
        std::pair("/markups/0/display/color", json({1, 2, 0})),
        std::pair("/markups/0/display/glyphType", json("Ball")),
        std::pair("/markups/0/controlPoints/0/id", json(1)),
        std::pair("/markups/0/controlPoints/0/position", json({1, 2})),
        std::pair("/markups/0/controlPoints/0/position", json({1, 2, "3"})),
        std::pair("/markups/0/controlPoints/0/positionStatus", json("set")),
        std::pair("/markups/0/controlPoints/0/lable", json("A"))})
    expectBreaks(kMarkups, good, place, value);
  json without = good;
  without["markups"][0].erase("type");
  const auto bad = folder_.put("without.json", without.dump());
  EXPECT_THAT(validate(kMarkups, {bad}).out, HasSubstr("'type' is a required property"));
}

TEST_F(Schemas, SessionsFollowTheirSchema) {
  SessionContents contents = tests::fullContents(folder_);
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::string& name, const SessionContents& written) {
    tests::write(folder_ / name, written);
    files.push_back(folder_ / name);
  };
  add("empty.viscera", {});
  add("linked.viscera", contents);
  contents.embedSurfaces = true;
  contents.recovers = "/somewhere/a.viscera";
  add("embedded.viscera", contents);
  tests::Session session;
  tests::Monkey monkey(session, 7);
  for (int i = 0; i < 100; ++i)
    monkey.act();
  contents.state = session.document.state();
  add("any.viscera", contents);
  expectFollows(kSession, files);
}

TEST_F(Schemas, BrokenSessionsAreRefused) {
  tests::write(folder_ / "a.viscera", tests::fullContents(folder_));
  const json good = json::parse(contentsOf(folder_ / "a.viscera"));
  for (const auto& [place, value] :
       {std::pair("/version", json(3)), std::pair("/surfaces", json("somewhere")),
        std::pair("/organs/0/id", json(0)), std::pair("/organs/0/look/opacity", json(1.5)),
        std::pair("/rig/handles/0/locked", json(1)), std::pair("/rig/handles/0/rest", json({1, 2})),
        std::pair("/recording/keys/0/easing", json("bouncing")), std::pair("/view", json(nullptr)),
        std::pair("/surplus", json(1))})
    expectBreaks(kSession, good, place, value);
}

} // namespace
} // namespace viscera::document
