#include "viscera/live/sequence_file.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;

SequenceFile sample() {
  SequenceFile file;
  auto& track = file.track;
  track.name = "Knead";
  track.restHandles.resize(5, 3);
  track.restHandles << 0.1, 0, 0, 50, 0, 1.0 / 3, 0, 50, 0, 0, 0, 50, -20, -30, -40;
  track.periodSeconds = 2.5;
  track.loop = false;
  track.interpolation = sequences::Interpolation::curve;
  track.groups = {{"Front", {0.9, 0.6, 0.1}, {0, 2}}, {"Back", {0, 0.5, 1}, {1}}};
  track.keys = {{0, track.restHandles, sequences::Easing::in},
                {1.0 / 3, track.restHandles, sequences::Easing::hold}};
  track.keys[1].pose.row(3) << 3.3, 1e-17, 51.7;
  file.labels = {"A", "B b", "C",
                 "\xC3\x9C"
                 "ber",
                 "E"};
  document::SystemChoice system;
  system.parameters.set("locality", 2.5);
  file.system = system;
  return file;
}

class SequenceFiles : public testing::Test {
protected:
  std::filesystem::path write(const std::string& text) const { return folder_.put("s.sequence.json", text); }
  std::string good() const {
    const std::filesystem::path file = folder_.path() / "good.sequence.json";
    writeSequence(file, sample());
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// What the file is refused with after `spoil` has changed it.
  std::string refusal(const std::function<void(ordered_json&)>& spoil) const {
    ordered_json json = ordered_json::parse(good());
    spoil(json);
    return refusalOf(json.dump());
  }
  std::string refusalOf(const std::string& text) const {
    const std::filesystem::path file = write(text);
    try {
      readSequence(file);
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find("s.sequence.json"), std::string::npos) << error.what();
      return error.what();
    }
    return "accepted";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(SequenceFiles, comeBackToTheLastBit) {
  const std::filesystem::path file = write(good());
  const SequenceFile read = readSequence(file);
  const SequenceFile wanted = sample();
  EXPECT_EQ(read.labels, wanted.labels);
  EXPECT_EQ(read.track.restHandles, wanted.track.restHandles);
  EXPECT_EQ(read.track.name, wanted.track.name);
  EXPECT_EQ(read.track.periodSeconds, wanted.track.periodSeconds);
  EXPECT_EQ(read.track.loop, wanted.track.loop);
  EXPECT_EQ(read.track.interpolation, wanted.track.interpolation);
  ASSERT_EQ(read.track.keys.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.track.keys[i].seconds, wanted.track.keys[i].seconds);
    EXPECT_EQ(read.track.keys[i].easing, wanted.track.keys[i].easing);
    EXPECT_EQ(read.track.keys[i].pose, wanted.track.keys[i].pose);
  }
  ASSERT_EQ(read.track.groups.size(), 2u);
  EXPECT_EQ(read.track.groups[0].handles, wanted.track.groups[0].handles);
  EXPECT_EQ(read.track.groups[1].color, wanted.track.groups[1].color);
  ASSERT_TRUE(read.system);
  EXPECT_EQ(read.system->parameters.all(), wanted.system->parameters.all());
  EXPECT_TRUE(isSequenceFile("a/B.SEQUENCE.JSON"));
  EXPECT_FALSE(isSequenceFile("a/b.mrk.json"));
}

TEST_F(SequenceFiles, areWrittenWhateverBytesANameHas) {
  SequenceFile odd = sample();
  odd.track.name = "Kn\xE9t"; // Latin-1.
  writeSequence(folder_ / "s.sequence.json", odd);
  EXPECT_EQ(readSequence(folder_ / "s.sequence.json").track.name, "Kn\xEF\xBF\xBDt");
}

TEST_F(SequenceFiles, cutOffAnywhereAreRefused) {
  const std::string text = good();
  for (std::size_t length = 0; length + 2 < text.size(); length += 7)
    EXPECT_NE(refusalOf(text.substr(0, length)), "accepted") << length;
}

TEST_F(SequenceFiles, changedAnywhereAreReadOrRefusedButNothingElseHappens) {
  const std::string text = good();
  std::mt19937 random(11);
  for (int i = 0; i < 400; ++i) {
    std::string spoilt = text;
    for (int k = 0; k < 3; ++k)
      spoilt[random() % spoilt.size()] = static_cast<char>(random() % 256);
    refusalOf(spoilt);
  }
}

TEST_F(SequenceFiles, areRefusedWithTheKeyAndFieldThatIsWrong) {
  const auto says = [&](const std::string& words, const std::function<void(ordered_json&)>& spoil) {
    EXPECT_NE(refusal(spoil).find(words), std::string::npos) << refusal(spoil);
  };
  says("\"format\"", [](auto& j) { j["format"] = "something"; });
  says("\"format\"", [](auto& j) { j = ordered_json::array(); });
  says("version 99", [](auto& j) { j["version"] = 99; });
  says("\"version\"", [](auto& j) { j["version"] = "one"; });
  says("instead of \"mm\"", [](auto& j) { j["units"] = "m"; });
  says("instead of \"LPS\"", [](auto& j) { j["coordinateSystem"] = "RAS"; });
  says("has no \"keys\"", [](auto& j) { j.erase("keys"); });
  says("no key", [](auto& j) { j["keys"] = ordered_json::array(); });
  says("has no \"periodSeconds\"", [](auto& j) { j.erase("periodSeconds"); });
  says("finite number", [](auto& j) { j["periodSeconds"] = nullptr; });
  says("period", [](auto& j) { j["periodSeconds"] = -1; });
  says("key 2", [](auto& j) { j["keys"][1]["seconds"] = 0; });
  says("not after", [](auto& j) { j["keys"][1]["seconds"] = 0; });
  says("outside the period", [](auto& j) { j["keys"][1]["seconds"] = 3; });
  says("key 2, seconds", [](auto& j) { j["keys"][1]["seconds"] = "soon"; });
  says("\"Nobody\", which is not among", [](auto& j) { j["keys"][0]["pose"]["Nobody"] = {1, 2, 3}; });
  says("three numbers", [](auto& j) { j["keys"][0]["pose"]["A"] = {1, 2}; });
  says("handle \"A\"", [](auto& j) { j["keys"][0]["pose"]["A"] = {1, 2, nullptr}; });
  says("There is no easing \"bouncy\"", [](auto& j) { j["keys"][0]["easing"] = "bouncy"; });
  says("There is no interpolation", [](auto& j) { j["interpolation"] = "zigzag"; });
  says("comes twice", [](auto& j) { j["handles"][1]["label"] = "A"; });
  says("four at least", [](auto& j) {
    j["handles"].erase(0);
    j["handles"].erase(0);
  });
  says("in two groups", [](auto& j) { j["groups"][1]["handles"].push_back("A"); });
  says("between 0 and 1", [](auto& j) { j["groups"][1]["color"] = {2, 0, 0}; });
  says("neither true nor false", [](auto& j) { j["loop"] = 1; });
  says("system parameter locality", [](auto& j) { j["system"]["parameters"]["locality"] = "much"; });
  std::string infinite = good();
  infinite.replace(infinite.find("2.5"), 3, "1e999");
  EXPECT_NE(refusalOf(infinite), "accepted");
}

TEST_F(SequenceFiles, thatAreMissingOrCannotBeWrittenAreErrorsOfTheirOwn) {
  EXPECT_THROW(readSequence(folder_.path() / "no.sequence.json"), NoInputError);
  EXPECT_THROW(readSequence(folder_.path()), NoInputError);
  EXPECT_THROW(writeSequence(folder_.path() / "s.json", sample()), CannotCreateError);
  EXPECT_THROW(writeSequence(folder_.path() / "no" / "s.sequence.json", sample()), CannotCreateError);
}

} // namespace
} // namespace viscera::live
