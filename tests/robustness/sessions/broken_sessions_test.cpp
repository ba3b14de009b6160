#include <functional>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session_scene.h"
#include "viscera/core/error.h"

/// Session files that somebody's disk, editor or program has damaged: each is refused as bad data that names
/// the file, or opened; none brings the program down.
namespace viscera::document {
namespace {

using nlohmann::ordered_json;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

enum class Outcome { opened, refused };

class BrokenSession : public testing::Test {
protected:
  BrokenSession() {
    SessionContents contents = tests::fullContents(folder_);
    contents.embedSurfaces = true;
    tests::write(folder_ / "good.viscera", contents);
    text_ = contentsOf(folder_ / "good.viscera");
    contents.embedSurfaces = false;
    tests::write(folder_ / "linked.viscera", contents);
    linked_ = ordered_json::parse(contentsOf(folder_ / "linked.viscera"));
  }

  Outcome open(const std::string& bytes, const std::string& what) {
    ++files_;
    const auto file = folder_.put("broken.viscera", bytes);
    try {
      tests::readBack(file);
      return Outcome::opened;
    } catch (const DataError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("broken.viscera")) << what;
      EXPECT_FALSE(error.problem().empty()) << what;
      return Outcome::refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << what << ": " << error.what();
      return Outcome::refused;
    }
  }

  /// Every place of a JSON document but those in "view", which is nobody's business here.
  static std::vector<ordered_json::json_pointer> placesOf(const ordered_json& root) {
    std::vector<ordered_json::json_pointer> places;
    const std::function<void(const ordered_json&, const ordered_json::json_pointer&)> walk =
        [&](const ordered_json& item, const ordered_json::json_pointer& place) {
          if (place.to_string().starts_with("/view/"))
            return;
          if (!place.empty())
            places.push_back(place);
          if (item.is_object())
            for (const auto& [key, value] : item.items())
              walk(value, place / key);
          if (item.is_array())
            for (std::size_t i = 0; i < item.size(); ++i)
              walk(item[i], place / i);
        };
    walk(root, ordered_json::json_pointer());
    return places;
  }

  TemporaryFolder folder_;
  std::string text_;
  ordered_json linked_;
  int files_ = 0;
};

TEST_F(BrokenSession, CutOffAnywhereIsRefused) {
  for (int i = 0; i < 60; ++i) {
    const std::size_t length = text_.size() * static_cast<std::size_t>(i) / 60;
    EXPECT_EQ(open(text_.substr(0, length), "cut at " + std::to_string(length)), Outcome::refused);
  }
  // The last line end carries nothing.
  EXPECT_EQ(open(text_.substr(0, text_.size() - 2), "without its last bracket"), Outcome::refused);
}

TEST_F(BrokenSession, WithFlippedBitsIsRefusedOrOpened) {
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string bytes = text_;
    for (int flips = 1 + i % 3; flips > 0; --flips)
      bytes[random() % bytes.size()] ^= static_cast<char>(1 << (random() % 8));
    refused += open(bytes, "flipped bits " + std::to_string(i)) == Outcome::refused;
  }
  EXPECT_GT(refused, 130) << "most of the file is surfaces, whose damage is noticed";
}

TEST_F(BrokenSession, OfWrongTypesIsRefused) {
  for (const auto& root : {linked_, ordered_json::parse(text_)}) {
    for (const auto& place : placesOf(root)) {
      ordered_json broken = root;
      ordered_json& item = broken[place];
      if (item.is_string())
        item = 17;
      else if (item.is_number() || item.is_boolean())
        item = "17";
      else
        item = nullptr;
      EXPECT_EQ(open(broken.dump(), "type of " + place.to_string()), Outcome::refused) << place.to_string();
    }
  }
  EXPECT_GT(files_, 100);
}

TEST_F(BrokenSession, WithoutAKeyIsRefusedUnlessItMayBeLeftOut) {
  int refused = 0;
  for (const auto& place : placesOf(linked_)) {
    ordered_json broken = linked_;
    ordered_json& parent = broken[place.parent_pointer()];
    if (!parent.is_object())
      continue;
    parent.erase(place.back());
    refused += open(broken.dump(), "without " + place.to_string()) == Outcome::refused;
  }
  EXPECT_GT(refused, 80);
}

TEST_F(BrokenSession, WithNumbersOutOfAllBoundsIsRefusedOrOpened) {
  for (const char* number : {"1e308", "-1", "9223372036854775807", "18446744073709551615", "1e999", "-0.0"}) {
    for (const auto& place : placesOf(linked_)) {
      if (!linked_.at(place).is_number())
        continue;
      ordered_json broken = linked_;
      broken[place] = "@@@";
      std::string bytes = broken.dump();
      bytes.replace(bytes.find("\"@@@\""), 5, number);
      open(bytes, std::string(number) + " at " + place.to_string());
    }
  }
  EXPECT_GT(files_, 300);
}

TEST_F(BrokenSession, ThatPromisesMoreThanItHoldsTakesNoMemoryForIt) {
  for (const double count : {0.0, 1.0, 1e6, 1e9, 1e12, 9007199254740992.0}) {
    for (const char* key : {"vertices", "triangles"}) {
      ordered_json broken = ordered_json::parse(text_);
      broken["organs"][0]["surface"][key] = static_cast<std::int64_t>(count);
      EXPECT_EQ(open(broken.dump(), key + std::to_string(count)), Outcome::refused);
    }
  }
}

TEST_F(BrokenSession, NestedWithoutEndIsRefused) {
  for (const int depth : {100, 100000, 3000000}) {
    ordered_json broken = linked_;
    broken["view"] = {{"deep", "@@@"}};
    std::string bytes = broken.dump();
    const std::string nested =
        std::string(static_cast<std::size_t>(depth), '[') + std::string(static_cast<std::size_t>(depth), ']');
    bytes.replace(bytes.find("\"@@@\""), 5, nested);
    EXPECT_EQ(open(bytes, "nested"), Outcome::refused);
  }
}

TEST_F(BrokenSession, WhoseNamesAndIdsClashIsRefused) {
  const auto twice = [&](const char* from, const char* to) {
    ordered_json broken = linked_;
    broken[ordered_json::json_pointer(to)] = broken[ordered_json::json_pointer(from)];
    EXPECT_EQ(open(broken.dump(), to), Outcome::refused) << to;
  };
  twice("/organs/0/id", "/organs/1/id");
  twice("/organs/0/id", "/rig/handles/0/id");
  twice("/rig/handles/0/label", "/rig/handles/1/label");
  twice("/rig/groups/0/name", "/rig/groups/1/name");
  twice("/rig/groups/0/handles/0", "/rig/groups/0/handles/1");
  twice("/recording/keys/1/seconds", "/recording/keys/0/seconds");
  twice("/recording/keys/1/displacements/0/handle", "/recording/keys/1/displacements/1/handle");
  twice("/organs/2/id", "/organs/2/parent");
  twice("/organs/2/id", "/organs/1/parent");
}

TEST_F(BrokenSession, ThatIsNoSessionSaysWhatItIs) {
  for (const char* bytes : {"", "\n", "null", "[]", "{}", "\"format\"", "{\"format\": \"viscera-sequence\"}",
                            "solid ball\nendsolid\n", "\xff\xfe", "{\"format\": \"viscera-session\"}"})
    EXPECT_EQ(open(bytes, bytes), Outcome::refused);
  EXPECT_EQ(open(std::string(100000, '\0'), "zeros"), Outcome::refused);
}

} // namespace
} // namespace viscera::document
