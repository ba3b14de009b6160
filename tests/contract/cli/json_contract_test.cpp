#include <cmath>

#include "cli_test.h"

namespace viscera::app::cli {

/// The keys that scripts rely on, their types, and that they say what is so.
class CliJson : public CliTest {
protected:
  static void expectNumbers(const json& object, const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
      EXPECT_TRUE(object.contains(key) && object[key].is_number()) << key << " in " << object.dump(2);
  }
  static void expectBooleans(const json& object, const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
      EXPECT_TRUE(object.contains(key) && object[key].is_boolean()) << key << " in " << object.dump(2);
  }
  static void expectStrings(const json& object, const std::vector<std::string>& keys) {
    for (const std::string& key : keys)
      EXPECT_TRUE(object.contains(key) && object[key].is_string()) << key << " in " << object.dump(2);
  }
};

TEST_F(CliJson, InfoOfAnOrgan) {
  const json info = runJson({"info", put("cube.off", cubeOff(10))});
  expectStrings(info, {"kind", "space"});
  expectNumbers(info, {"vertices", "triangles", "components", "volumeMl", "areaCm2"});
  expectBooleans(info, {"closed", "manifold", "outward"});
  EXPECT_TRUE(info["warnings"].is_array());
  EXPECT_EQ(info["kind"], "organ");
  EXPECT_EQ(info["vertices"], 8);
  EXPECT_EQ(info["triangles"], 12);
  EXPECT_EQ(info["components"], 1);
  EXPECT_EQ(info["closed"], true);
  EXPECT_EQ(info["manifold"], true);
  EXPECT_EQ(info["outward"], true);
  EXPECT_EQ(info["space"], "LPS");
  EXPECT_NEAR(info["volumeMl"].get<double>(), 8.0, 1e-12);
  EXPECT_NEAR(info["areaCm2"].get<double>(), 24.0, 1e-12);
  EXPECT_EQ(info["boundsMm"], json::array({-10.0, 10.0, -10.0, 10.0, -10.0, 10.0}));
}

TEST_F(CliJson, InfoOfAnOpenOrganHasNoVolume) {
  const json info =
      runJson({"info", put("open.off", "OFF\n4 2 0\n0 0 0\n9 0 0\n0 9 0\n9 9 1\n3 0 1 2\n3 1 3 2\n")});
  EXPECT_EQ(info["closed"], false);
  EXPECT_TRUE(info["volumeMl"].is_null());
  EXPECT_FALSE(info["warnings"].empty());
}

TEST_F(CliJson, InfoOfHandles) {
  const json info = runJson({"info", put("h.mrk.json", markups(corners(10)))});
  EXPECT_EQ(info["kind"], "handles");
  EXPECT_EQ(info["handles"], 8);
  EXPECT_EQ(info["labels"].size(), 8u);
  EXPECT_EQ(info["labels"][0], "H-1");
}

TEST_F(CliJson, Systems) {
  const json systems = runJson({"systems"})["systems"];
  ASSERT_TRUE(systems.is_array());
  bool celestial = false;
  for (const json& system : systems) {
    expectStrings(system, {"id", "name", "source"});
    EXPECT_TRUE(system["traits"].is_object());
    ASSERT_TRUE(system["parameters"].is_array());
    for (const json& parameter : system["parameters"]) {
      expectStrings(parameter, {"name", "help"});
      expectNumbers(parameter, {"minimum", "maximum", "standard"});
    }
    if (system["id"] == "s-celestial") {
      celestial = true;
      EXPECT_EQ(system["source"], "built-in");
      EXPECT_EQ(system["traits"]["positive"], true);
      EXPECT_EQ(system["traits"]["needsCage"], false);
    }
  }
  EXPECT_TRUE(celestial);
}

TEST_F(CliJson, SampleListAndSample) {
  const json organs = runJson({"sample", "--list"})["organs"];
  EXPECT_NE(std::find(organs.begin(), organs.end(), "heart"), organs.end());
  EXPECT_NE(std::find(organs.begin(), organs.end(), "stomach"), organs.end());

  const std::string file = path("heart.vtp");
  const json heart = runJson({"sample", "heart", "-o", file, "--resolution", "low"});
  expectStrings(heart, {"organ"});
  expectNumbers(heart, {"vertices", "triangles", "volumeMl"});
  EXPECT_EQ(heart["organ"], "heart");
  ASSERT_EQ(heart["surfaces"].size(), 5u);
  for (const json& surface : heart["surfaces"]) {
    EXPECT_EQ(surface["closed"], true);
    const json info = runJson({"info", surface["file"].get<std::string>()});
    EXPECT_EQ(info["vertices"], surface["vertices"]);
    EXPECT_EQ(info["triangles"], surface["triangles"]);
    EXPECT_NEAR(info["volumeMl"].get<double>(), surface["volumeMl"].get<double>(), 1e-3);
  }
  EXPECT_EQ(files(), 5);
  const json cavity = runJson({"info", "sample:heart/lv@low"});
  EXPECT_EQ(cavity["vertices"], heart["surfaces"][1]["vertices"]);
  const json walls = runJson({"info", "sample:heart/tissue@low"});
  EXPECT_GT(walls["triangles"], heart["surfaces"][0]["triangles"])
      << "inside and outside, and no organ of its own";
}

TEST_F(CliJson, HandlesBindAndDeform) {
  const std::string organ = put("cube.off", cubeOff(10));
  const std::string handles = path("h.mrk.json");
  const json placed = runJson({"handles", organ, "-o", handles, "--count", "8", "--enclosing"});
  expectNumbers(placed, {"handles", "outsideHull"});
  EXPECT_EQ(placed["handles"], 8);
  EXPECT_EQ(placed["outsideHull"], 0);

  const std::string weights = path("w.npy");
  const json bound = runJson(
      {"bind", organ, "--handles", handles, "--system", "s-celestial", "-o", weights, "--threads", "1"});
  expectStrings(bound, {"system"});
  expectNumbers(bound, {"vertices", "handles", "seconds", "threads", "identityError", "unityError",
                        "minWeight", "failures"});
  EXPECT_EQ(bound["system"], "s-celestial");
  EXPECT_EQ(bound["vertices"], 8);
  EXPECT_EQ(bound["threads"], 1);
  EXPECT_EQ(bound["failures"], 0);

  const std::string out = path("same.off");
  const json deformed = runJson(
      {"deform", organ, "--handles", handles, "--pose", handles, "--system", "s-celestial", "-o", out});
  expectNumbers(deformed, {"volumeRestMl", "volumeMl", "relativeVolumeError", "movedHandles",
                           "maxDisplacementMm", "seconds"});
  EXPECT_EQ(deformed["movedHandles"], 0);
  EXPECT_NEAR(deformed["volumeRestMl"].get<double>(), 8.0, 1e-12);
  EXPECT_LT(deformed["maxDisplacementMm"].get<double>(), 1e-7);
}

TEST_F(CliJson, HandlesEncloseTheOrganUnlessToldOtherwise) {
  const std::string organ = put("cube.off", cubeOff(10));
  const auto place = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"handles", organ, "-o", path("h.mrk.json")});
    return runJson(more);
  };
  const json standard = place({"--count", "12"});
  EXPECT_EQ(standard["enclosing"], true);
  EXPECT_EQ(standard["outsideHull"], 0);
  EXPECT_EQ(place({"--count", "12", "--enclosing"}), standard) << "the old word is still taken";
  const json loose = place({"--count", "4", "--no-enclosing"});
  EXPECT_EQ(loose["enclosing"], false);
  EXPECT_EQ(loose["handles"], 4);
  EXPECT_GT(loose["outsideHull"], 0);
  expectFailure({"handles", organ, "-o", path("h.mrk.json"), "--count", "7"}, kUsage, "--no-enclosing");
  expectFailure({"handles", organ, "-o", path("h.mrk.json"), "--enclosing", "--no-enclosing"}, kUsage,
                "--enclosing");
}

TEST_F(CliJson, DeformFollowsTheHandles) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  const std::string pose = put("pose.mrk.json", markups(corners(20))); // Everything twice as large.
  const json deformed =
      runJson({"deform", organ, "--handles", rest, "--pose", pose, "-o", path("large.off")});
  EXPECT_EQ(deformed["movedHandles"], 8);
  EXPECT_NEAR(deformed["volumeMl"].get<double>(), 8.0, 1e-6);
  EXPECT_NEAR(deformed["relativeVolumeError"].get<double>(), 7.0, 1e-6);
  EXPECT_NEAR(deformed["maxDisplacementMm"].get<double>(), 5 * std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(runJson({"info", path("large.off")})["volumeMl"].get<double>(), 8.0, 1e-6);
}

TEST_F(CliJson, HandlesThatAPoseLeavesOutStayAtRest) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  json pose = json::parse(markups(corners(10)));
  json& points = pose["markups"][0]["controlPoints"];
  points = json::array({points[3]});
  points[0]["position"][0] = 15.0;
  const json deformed =
      runJson({"deform", organ, "--handles", rest, "--pose", put("pose.mrk.json", pose.dump())});
  EXPECT_EQ(deformed["movedHandles"], 1);
  EXPECT_GT(deformed["maxDisplacementMm"].get<double>(), 0.1);
}

TEST_F(CliJson, DeformKeepsOrReachesAVolume) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  auto positions = corners(10);
  positions[7] = {14, 15, 13};
  const std::string pose = put("pose.mrk.json", markups(positions));
  const auto deform = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"deform", organ, "--handles", rest, "--pose", pose});
    return runJson(more);
  };
  EXPECT_GT(deform({})["relativeVolumeError"].get<double>(), 0.01);
  const json locked = deform({"--lock-volume"});
  EXPECT_NEAR(locked["volumeMl"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(locked["relativeVolumeError"].get<double>(), 0.0, 1e-12);
  EXPECT_EQ(locked["movedHandles"], 8);
  EXPECT_NEAR(deform({"--target-ml", "1.2"})["volumeMl"].get<double>(), 1.2, 1e-12);
  const json one = deform({"--lock-volume", "--compensate", "H-1"});
  EXPECT_NEAR(one["volumeMl"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(one["movedHandles"], 2);
  expectFailure({"deform", organ, "--handles", rest, "--pose", pose, "--target-ml", "900"}, kBadData,
                "volume");
}

TEST_F(CliJson, FreeHandlesFollowAPoseAndKeepItsVolume) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  auto positions = corners(10);
  positions[7] = {14, 15, 13};
  const std::string pose = put("pose.mrk.json", markups(positions));
  const auto deform = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"deform", organ, "--handles", rest, "--pose", pose, "--hold", "H-1", "--hold",
                               "H-2", "--hold", "H-3"});
    return more;
  };
  const json followed = runJson(deform({"--free-handles-follow", "--lock-volume"}));
  EXPECT_EQ(followed["followingHandles"], 4);
  EXPECT_EQ(followed["movedHandles"], 5);
  EXPECT_NEAR(followed["volumeMl"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(followed["handles"].back()["offMm"].get<double>(), 0, 1e-12)
      << "the moved one is where it is sent";
  EXPECT_GT(runJson(deform({"--free-handles-follow"}))["maxDisplacementMm"].get<double>(), 0.1);
  expectFailure(deform({}), kUsage, "--free-handles-follow");
}

TEST_F(CliJson, ALockedDeformationSaysWhatWasAskedAndGiven) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  auto positions = corners(10);
  positions[7][0] += 6;
  positions[6][0] += 2;
  const std::vector<std::string> deform{"deform",       organ,    "--handles",
                                        rest,           "--pose", put("pose.mrk.json", markups(positions)),
                                        "--lock-volume"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), deform.begin(), deform.end());
    return more;
  };
  const json kept = runJson(deform);
  ASSERT_EQ(kept["handles"].size(), 8U);
  for (const json& handle : kept["handles"]) {
    const double asked = handle["label"] == "H-8" ? 6 : handle["label"] == "H-7" ? 2 : 0;
    EXPECT_NEAR(handle["askedMm"].get<double>(), asked, 1e-9) << handle;
    if (asked > 0) {
      EXPECT_NEAR(handle["offMm"].get<double>(), 0, 1e-9) << "those at rest compensate: " << handle;
    }
  }
  const auto warnsOf = [](const json& outcome, const std::string& words) {
    return outcome["warnings"].dump().find(words) != std::string::npos;
  };
  EXPECT_FALSE(warnsOf(kept, "elsewhere")) << kept["warnings"];
  EXPECT_NE(run(deform).out.find("6.00 mm asked, 6.00 mm given"), std::string::npos) << run(deform).out;

  const json changed = runJson(with({"--compensate", "H-8"}));
  ASSERT_EQ(changed["handles"].size(), 2U);
  EXPECT_GT(changed["handles"][1]["offMm"].get<double>(), 0.01);
  EXPECT_TRUE(warnsOf(changed, "elsewhere than it asks: H-8 6.00 mm asked")) << changed["warnings"];
}

TEST_F(CliJson, WeightsAreANumPyFile) {
  const std::string organ = put("cube.off", cubeOff(5));
  const std::string rest = put("rest.mrk.json", markups(corners(10)));
  runJson({"bind", organ, "--handles", rest, "-o", path("w.npy")});
  const std::string bytes = contents(path("w.npy"));
  ASSERT_GT(bytes.size(), 128u);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header =
      10 + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ(header % 64, 0u);
  EXPECT_NE(bytes.find("'<f8'"), std::string::npos);
  EXPECT_NE(bytes.find("(8, 8)"), std::string::npos);
  ASSERT_EQ(bytes.size(), header + 8 * 8 * sizeof(double));
  // By symmetry the corner of the small cube that lies in the large one's corner i depends on that one most.
  const double* weights = reinterpret_cast<const double*>(bytes.data() + header);
  for (int point = 0; point < 8; ++point) {
    double sum = 0;
    for (int handle = 0; handle < 8; ++handle) {
      double weight = 0;
      std::memcpy(&weight, weights + point * 8 + handle, sizeof weight);
      sum += weight;
      double own = 0;
      std::memcpy(&own, weights + point * 8 + point, sizeof own);
      EXPECT_LE(weight, own + 1e-12);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST_F(CliJson, TextModePrintsTheSameForAReader) {
  const test::ProcessResult result = run({"info", put("cube.off", cubeOff(10))});
  EXPECT_EQ(result.exitCode, kOk);
  EXPECT_NE(result.out.find("8.0 ml"), std::string::npos) << result.out;
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << "no progress bar where nobody watches";
}

} // namespace viscera::app::cli
