#include "cli_test.h"
#include "picture_check.h"

namespace viscera::app::cli {

class CliRender : public CliTest {
protected:
  /// Width and height from a PNG's header.
  static std::pair<int, int> sizeOf(const std::string& png) {
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value = value * 256 + static_cast<unsigned char>(png.at(at + i));
      return value;
    };
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    return {number(16), number(20)};
  }
};

TEST_F(CliRender, WritesAPictureOfTheSizeAskedForWithoutADisplay) {
  const json result = runJson({"render", "sample:stomach@low", "-o", path("s.png"), "--size", "320x200"});
  EXPECT_EQ(result["png"], path("s.png"));
  EXPECT_EQ(sizeOf(contents(path("s.png"))), std::make_pair(320, 200));
}

TEST_F(CliRender, DrawsTheSideAskedForWithHandlesAndTheInfluenceOfOne) {
  const std::string handles = path("h.mrk.json");
  runJson({"handles", "sample:stomach@low", "-o", handles, "--count", "30", "--enclosing"});
  const auto expectReference = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render", "sample:stomach@low", "-o", path("p.png"), "--size",
                                          "320x200"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    runJson(arguments);
    tests::expectLooksLikeReference(scene::readPng(path("p.png")), name);
  };
  for (const std::string view : {"anterior", "posterior", "left", "right", "superior", "inferior"})
    expectReference("stomach_" + view, {"--view", view});
  expectReference("stomach_handles", {handles});
  expectReference("stomach_influence", {handles, "--influence", "H-9"});
}

} // namespace viscera::app::cli
