#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "run_process.h"

namespace viscera::app::cli {

using nlohmann::json;

constexpr int kOk = 0;
constexpr int kUsage = 64;
constexpr int kBadData = 65;
constexpr int kNoInput = 66;
constexpr int kCannotCreate = 73;
constexpr int kCancelled = 130;

/// A fixture that runs the real binary as a process in a folder of its own, without a display.
class CliTest : public testing::Test {
protected:
  void SetUp() override;
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// A path in the test's folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a file into the test's folder and returns its path.
  std::string put(const std::string& name, const std::string& contents) const {
    std::ofstream(folder_ / name, std::ios::binary) << contents;
    return path(name);
  }

  static std::string contents(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::ProcessResult run(std::vector<std::string> arguments) const;

  /// Runs with --json; the command has to succeed and to print one object and nothing else.
  json runJson(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const test::ProcessResult result = run(arguments);
    EXPECT_EQ(result.exitCode, kOk) << result.err;
    json parsed = json::parse(result.out, nullptr, false);
    EXPECT_TRUE(parsed.is_object()) << "not one JSON object:\n" << result.out;
    return parsed.is_object() ? parsed : json::object();
  }

  /// Runs and interrupts after this time. If the command has ended before, as on a quick machine, removes the
  /// files of these names from the test's folder and tries again with a shorter time.
  test::ProcessResult interrupted(const std::vector<std::string>& arguments, std::chrono::milliseconds after,
                                  const std::vector<std::string>& written) {
    options_.interruptAfter = after;
    test::ProcessResult result = run(arguments);
    while (result.exitCode == kOk && options_.interruptAfter->count() > 1) {
      for (const std::string& name : written)
        std::filesystem::remove_all(folder_ / name);
      *options_.interruptAfter /= 2;
      result = run(arguments);
    }
    return result;
  }

  /// Runs with and without --json; both have to fail with `exitCode` and with one line on stderr that holds
  /// `says`. On stdout there is nothing, with --json one object with the error.
  void expectFailure(std::vector<std::string> arguments, int exitCode, const std::string& says) const {
    for (const bool withJson : {false, true}) {
      if (withJson)
        arguments.push_back("--json");
      const test::ProcessResult result = run(arguments);
      EXPECT_EQ(result.exitCode, exitCode) << result.err;
      if (withJson)
        expectError(result.out, exitCode);
      else
        EXPECT_EQ(result.out, "");
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
      EXPECT_NE(result.err.find(says), std::string::npos) << "should say \"" << says << "\": " << result.err;
    }
  }

  /// The text has to be the object that --json prints of an error, and nothing else.
  static void expectError(const std::string& text, int exitCode) {
    const json object = json::parse(text, nullptr, false);
    ASSERT_TRUE(object.is_object()) << text;
    EXPECT_EQ(object.value("exitCode", -1), exitCode) << text;
    const json error = object.value("error", json::object());
    for (const char* key : {"what", "where", "try"})
      EXPECT_TRUE(error.contains(key) && error[key].is_string()) << key << " in " << text;
    EXPECT_NE(error.value("what", ""), "") << text;
    EXPECT_EQ(object.size(), 2U) << text;
  }

  /// The number of entries in the test's folder, to check that no half-written file stays.
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  }

  /// An axis-parallel cube of that half side as OFF, 12 outward triangles.
  static std::string cubeOff(double half) {
    const std::string h = std::to_string(half);
    std::string text = "OFF\n8 12 0\n";
    for (int i = 0; i < 8; ++i)
      text += (i & 1 ? h : "-" + h) + " " + (i & 2 ? h : "-" + h) + " " + (i & 4 ? h : "-" + h) + "\n";
    return text + "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n"
                  "3 1 3 7\n3 1 7 5\n";
  }

  /// A Slicer markup list with these positions, labelled H-1, H-2, ...
  static std::string markups(const std::vector<std::array<double, 3>>& positions) {
    json points = json::array();
    for (std::size_t i = 0; i < positions.size(); ++i)
      points.push_back({{"id", std::to_string(i + 1)},
                        {"label", "H-" + std::to_string(i + 1)},
                        {"position", positions[i]},
                        {"positionStatus", "defined"}});
    return json{{"@schema",
                 "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
                 "Schema/markups-schema-v1.0.3.json#"},
                {"markups", json::array({{{"type", "Fiducial"},
                                          {"coordinateSystem", "LPS"},
                                          {"coordinateUnits", "mm"},
                                          {"controlPoints", points}}})}}
        .dump();
  }

  /// The corners of a cube of that half side, as handles.
  static std::vector<std::array<double, 3>> corners(double half) {
    std::vector<std::array<double, 3>> result;
    for (int i = 0; i < 8; ++i)
      result.push_back({i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half});
    return result;
  }

  std::filesystem::path folder_;
  test::ProcessOptions options_;
};

} // namespace viscera::app::cli
