#include "cli_test.h"
#include "viscera/medical_io/file_kind.h"

namespace viscera::app::cli {

using CliUsage = CliTest;

TEST_F(CliUsage, HelpAndVersionGoToStandardOutput) {
  const test::ProcessResult help = run({"--help"});
  EXPECT_EQ(help.exitCode, kOk);
  EXPECT_EQ(help.err, "");
  for (const medical_io::FileFormat& format : medical_io::fileFormats())
    EXPECT_NE(help.out.find('(' + format.endings.front()), std::string::npos) << format.name;
  for (const std::string command : {"info", "systems", "sample", "handles", "bind", "deform", "play",
                                    "render", "properties", "reproduce", "circulate"}) {
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
    const test::ProcessResult one = run({command, "--help"});
    EXPECT_EQ(one.exitCode, kOk) << command;
    EXPECT_NE(one.out.find("--json"), std::string::npos) << command << "\n" << one.out;
    EXPECT_EQ(one.err, "") << command;
  }
  const test::ProcessResult version = run({"--version"});
  EXPECT_EQ(version.exitCode, kOk);
  EXPECT_EQ(version.out.rfind("viscera ", 0), 0u) << version.out;
  EXPECT_EQ(version.err, "");
}

TEST_F(CliUsage, UnknownOptionsAndCommandsAreUsageErrors) {
  for (const std::string command : {"info", "systems", "sample", "handles", "bind", "deform", "play",
                                    "render", "properties", "reproduce", "circulate"})
    expectFailure({command, "--no-such-option"}, kUsage, "--help");
  EXPECT_EQ(run({"--no-such-option"}).exitCode, kUsage);
  EXPECT_EQ(run({"nosuchcommand"}).exitCode, kUsage);
}

TEST_F(CliUsage, AMisspeltCommandOrOptionSaysWhatWasMeant) {
  const std::string organ = put("cube.off", cubeOff(4));
  const std::pair<const char*, const char*> words[] = {{"defrom", "deform"}, {"paly", "play"},
                                                       {"inof", "info"},     {"Render", "render"},
                                                       {"seg", "segment"},   {"circulat", "circulate"}};
  for (const auto& [typed, meant] : words)
    expectFailure({typed, organ, "--handles", "h.mrk.json"}, kUsage,
                  "'" + std::string(typed) + "' is no command; did you mean '" + meant + "'?");
  EXPECT_EQ(run({"defrom", organ}).err, "viscera: 'defrom' is no command; did you mean 'deform'?\n");
  expectFailure({"patient", organ}, kUsage, "neither a command nor a file");
  expectFailure({"info", organ, "--serise", "1"}, kUsage, "did you mean '--series'?");
}

TEST_F(CliUsage, ANumberOutOfRangeIsRefusedInAShortSentence) {
  const std::string organ = put("cube.off", cubeOff(4));
  const std::string handles = put("h.mrk.json", markups(corners(10)));
  const std::string out = path("o.mrk.json");
  expectFailure({"play", "heartbeat", "--rate", "75bpm"}, kUsage, "75bpm is no number; it has to be above 0");
  expectFailure({"play", "heartbeat", "--rate", "-3"}, kUsage, "-3 is out of range; it has to be above 0");
  expectFailure({"play", "heartbeat", "--fps", "inf"}, kUsage, "it has to be 0.1 to 240");
  expectFailure({"handles", organ, "-o", out, "--count", "8.5"}, kUsage, "8.5 is no whole number");
  expectFailure({"handles", organ, "-o", out, "--count", "3"}, kUsage, "it has to be 4 to 10000");
  expectFailure({"render", organ, "-o", path("p.png"), "--opacity", "1,5"}, kUsage, "it has to be 0 to 1");
  for (const std::string command : {"play", "deform", "track", "lesson", "stress"})
    EXPECT_EQ(run({command, "--help"}).out.find("1.79769"), std::string::npos) << command;
}

TEST_F(CliUsage, TheWindowOpensOneSampleOrganThatThereIs) {
  const auto refusal = [this](const std::vector<std::string>& arguments) {
    const test::ProcessResult result = run(arguments);
    EXPECT_EQ(result.exitCode, kUsage);
    return result.err;
  };
  EXPECT_NE(refusal({"sample:spleen"}).find("sample --list"), std::string::npos);
  EXPECT_NE(refusal({"sample:heart", "sample:liver"}).find("together"), std::string::npos);
}

TEST_F(CliUsage, FilesThatAreNotThereAreAllNamedBesideTheWindow) {
  constexpr int kNoDisplay = 69; // Here is none for the window.
  const test::ProcessResult result = run({path("none.stl"), path("lost.vtp")});
  EXPECT_EQ(result.exitCode, kNoDisplay);
  EXPECT_NE(result.err.find("none.stl"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("lost.vtp"), std::string::npos) << result.err;
  const test::ProcessResult partly = run({put("cube.off", cubeOff(4)), path("cube.off") + "/lost"});
  EXPECT_EQ(partly.exitCode, kNoDisplay);
  EXPECT_NE(partly.err.find("cube.off/lost"), std::string::npos) << "beside one that is: " << partly.err;
  const test::ProcessResult picture = run({path("none.stl"), "--screenshot", path("p.png")});
  EXPECT_EQ(picture.exitCode, kNoInput);
  EXPECT_NE(picture.err.find("none.stl"), std::string::npos) << picture.err;
}

TEST_F(CliUsage, MissingArgumentsAreUsageErrors) {
  expectFailure({"info"}, kUsage, "FILE");
  expectFailure({"bind", "sample:heart"}, kUsage, "--handles");
  expectFailure({"handles", "sample:heart"}, kUsage, "--output");
  expectFailure({"sample"}, kUsage, "--list");
}

TEST_F(CliUsage, NamesThatDoNotExistAreUsageErrorsThatSayWhatThereIs) {
  expectFailure({"sample", "spleen", "-o", path("s.stl")}, kUsage, "heart");
  expectFailure({"info", "sample:heart@huge"}, kUsage, "medium");
  expectFailure({"info", "sample:heart/lvv@low"}, kUsage, "lv");
  const std::string organ = put("cube.off", cubeOff(4));
  const std::string handles = put("h.mrk.json", markups(corners(10)));
  expectFailure({"bind", organ, "--handles", handles, "--system", "nosuch"}, kUsage, "s-celestial");
  expectFailure({"bind", organ, "--handles", handles, "--param", "nosuch=1"}, kUsage, "locality");
  expectFailure({"bind", organ, "--handles", handles, "--param", "locality"}, kUsage, "NAME=VALUE");
  expectFailure({"bind", organ, "--handles", handles, "--param", "locality=-3"}, kUsage, "locality");
  expectFailure({"bind", organ, "--handles", handles, "--threads", "-1"}, kUsage, "--threads");
  expectFailure({"render", organ, "-o", path("p.png"), "--view", "sideways"}, kUsage, "anterior");
  expectFailure({"render", organ, "-o", path("p.png"), "--size", "10"}, kUsage, "1600x1000");
  expectFailure({"render", organ, handles, "-o", path("p.png"), "--influence", "H-99"}, kUsage, "H-1");
  expectFailure({"play", "nosuch"}, kUsage, "heartbeat");
  expectFailure({"play", "heartbeat", "--rate", "1000"}, kUsage, "rate");
}

} // namespace viscera::app::cli
