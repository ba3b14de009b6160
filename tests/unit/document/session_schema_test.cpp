#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "phantom_scan.h"
#include "session_scene.h"
#include "viscera/document/scan_item.h"

/// The schema that the project publishes says what sessions are: it takes what the program writes, and not
/// what the program refuses.
namespace viscera::document {
namespace {

using nlohmann::json;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

/// As much of JSON Schema, draft 7, as the schema uses; an unknown word is a failure.
class Schema {
public:
  explicit Schema(json root) : root_(std::move(root)) {}

  bool takes(const json& value) const { return takes(root_, value); }

private:
  bool takes(const json& schema, const json& value) const {
    return std::all_of(schema.items().begin(), schema.items().end(),
                       [&](const auto& rule) { return keeps(rule.key(), rule.value(), schema, value); });
  }

  bool keeps(const std::string& word, const json& rule, const json& schema, const json& value) const {
    if (word == "$ref")
      return takes(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (word == "type")
      return isA(rule.get<std::string>(), value);
    if (word == "const")
      return value == rule;
    if (word == "enum")
      return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (word == "minimum")
      return !value.is_number() || value.get<double>() >= rule.get<double>();
    if (word == "maximum")
      return !value.is_number() || value.get<double>() <= rule.get<double>();
    if (word == "exclusiveMinimum")
      return !value.is_number() || value.get<double>() > rule.get<double>();
    if (word == "anyOf")
      return std::any_of(rule.begin(), rule.end(), [&](const json& one) { return takes(one, value); });
    if (word == "minLength" || word == "minItems")
      return sizeOf(value) >= rule.get<std::size_t>();
    if (word == "maxLength" || word == "maxItems")
      return sizeOf(value) <= rule.get<std::size_t>();
    if (word == "required")
      return std::all_of(rule.begin(), rule.end(), [&](const json& key) { return value.contains(key); });
    if (word == "items")
      return std::all_of(value.begin(), value.end(), [&](const json& item) { return takes(rule, item); });
    if (word == "properties")
      return std::all_of(rule.items().begin(), rule.items().end(), [&](const auto& part) {
        return !value.contains(part.key()) || takes(part.value(), value.at(part.key()));
      });
    if (word == "additionalProperties")
      return std::all_of(value.items().begin(), value.items().end(), [&](const auto& part) {
        const bool named = schema.contains("properties") && schema.at("properties").contains(part.key());
        return named || (rule.is_object() ? takes(rule, part.value()) : rule.get<bool>());
      });
    const bool known = word == "$schema" || word == "$id" || word == "title" || word == "definitions";
    EXPECT_TRUE(known) << "the test does not know \"" << word << "\"";
    return known;
  }

  static std::size_t sizeOf(const json& value) {
    return value.is_string() ? value.get_ref<const std::string&>().size() : value.size();
  }

  static bool isA(const std::string& type, const json& value) {
    return type == "integer"  ? value.is_number_integer()
           : type == "number" ? value.is_number()
                              : type == value.type_name();
  }

  json root_;
};

Schema published() {
  return Schema(json::parse(contentsOf(std::filesystem::path(VISCERA_SOURCE_DIR) / "resources" / "schema" /
                                       "session-2.schema.json")));
}

json written(const TemporaryFolder& folder, const SessionContents& contents) {
  tests::write(folder / "a.viscera", contents);
  return json::parse(contentsOf(folder / "a.viscera"));
}

TEST(SessionSchema, TakesWhatIsWritten) {
  const TemporaryFolder folder;
  const Schema schema = published();
  SessionContents contents = tests::fullContents(folder);
  EXPECT_TRUE(schema.takes(written(folder, contents)));
  contents.embedSurfaces = true;
  contents.recovers = "/somewhere/a.viscera";
  EXPECT_TRUE(schema.takes(written(folder, contents)));
  medical_io::Scan scan = tests::phantomScan({4, 4, 4}, Vec3::Ones(), Vec3::Zero(), tests::slope);
  scan.window = medical_io::ValueWindow();
  scan.findings.push_back({medical_io::ScanFinding::Kind::tilt, "The gantry is tilted"});
  contents.state.scan = std::make_shared<const ScanItem>(scanItem(std::move(scan), {}));
  EXPECT_TRUE(schema.takes(written(folder, contents)));
  EXPECT_TRUE(schema.takes(written(folder, {})));
  for (unsigned seed = 1; seed < 5; ++seed) {
    tests::Session s;
    tests::Monkey monkey(s, seed);
    for (int i = 0; i < 100; ++i)
      monkey.act();
    contents.state = s.document.state();
    EXPECT_TRUE(schema.takes(written(folder, contents))) << seed;
  }
}

TEST(SessionSchema, DoesNotTakeWhatIsRefused) {
  const TemporaryFolder folder;
  const Schema schema = published();
  const json good = written(folder, tests::fullContents(folder));
  for (const auto& [place, value] : {std::pair("/version", json(3)),
                                     std::pair("/format", json("viscera-sequence")),
                                     std::pair("/surfaces", json("somewhere")),
                                     std::pair("/organs/0/id", json(0)),
                                     std::pair("/organs/0/name", json("")),
                                     std::pair("/organs/0/look/opacity", json(1.5)),
                                     std::pair("/organs/0/look/color", json({1, 2})),
                                     std::pair("/rig/handles/0/locked", json(1)),
                                     std::pair("/rig/cage", json("hull")),
                                     std::pair("/rig/cage/0", json({1, 2})),
                                     std::pair("/rig/cage/0/1", json(-1)),
                                     std::pair("/recording/keys/0/easing", json("bouncing")),
                                     std::pair("/view", json(nullptr)),
                                     std::pair("/system/parameters", json({{"softness", "much"}})),
                                     std::pair("/measurements/0/name", json("")),
                                     std::pair("/measurements/0/points", json::array()),
                                     std::pair("/measurements/0/points/0/triangle", json(-1)),
                                     std::pair("/measurements/0/points/0/weights", json({1, 2, -2})),
                                     std::pair("/stressMarks/probes/0/number", json(0)),
                                     std::pair("/stressMarks/probes/0/organ", json(0)),
                                     std::pair("/stressMarks/probes/1/rest", json({1, 2})),
                                     std::pair("/stressMarks/lines/0/to", json("1")),
                                     std::pair("/stressMarks/lines", json(nullptr))}) {
    json bad = good;
    bad[json::json_pointer(place)] = value;
    EXPECT_FALSE(schema.takes(bad)) << place;
    EXPECT_THROW(tests::readBack(folder.put("bad.viscera", bad.dump())), DataError) << place;
  }
}

} // namespace
} // namespace viscera::document
