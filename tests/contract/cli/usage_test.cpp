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
