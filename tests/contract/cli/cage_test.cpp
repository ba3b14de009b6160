#include "cli_test.h"

namespace viscera::app::cli {
namespace {

/// A cage of one's own: its vertices are the handles, its triangles what cage systems work with.
class CliCage : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    organ_ = put("organ.off", cubeOff(10));
    cage_ = put("cage.off", cubeOff(30));
  }

  std::string organ_, cage_;
};

TEST_F(CliCage, GivesItsVerticesAsHandlesAndBindsThem) {
  const json placed = runJson({"handles", organ_, "--cage", cage_, "-o", path("h.mrk.json")});
  EXPECT_EQ(placed["handles"], 8);
  EXPECT_EQ(placed["outsideHull"], 0);
  for (const char* system : {"mean-value", "green", "harmonic", "positive-mean-value"}) {
    SCOPED_TRACE(system);
    const json bound =
        runJson({"bind", organ_, "--handles", path("h.mrk.json"), "--cage", cage_, "--system", system});
    EXPECT_EQ(bound["failures"], 0);
    EXPECT_LT(bound["identityError"].get<double>(), 1e-9);
  }
}

TEST_F(CliCage, ThatIsConcaveIsFollowedAndNotItsHull) {
  // The corner 30, 30, 30 pushed in beyond the organ's: the organ's own corner is outside.
  std::string text = cubeOff(30);
  const std::string corner = "30.000000 30.000000 30.000000\n";
  text.replace(text.rfind(corner), corner.size(), "5 5 5\n");
  const std::string dented = put("dented.off", text);
  const json placed = runJson({"handles", organ_, "--cage", dented, "-o", path("h.mrk.json")});
  EXPECT_EQ(placed["outsideHull"], 1);
  expectFailure({"bind", organ_, "--handles", path("h.mrk.json"), "--cage", dented, "--system", "green"},
                kBadData, "1 of 8 vertices have no coordinates");
  expectFailure({"bind", organ_, "--handles", path("h.mrk.json"), "--cage", dented, "--system", "wachspress"},
                kBadData, "not convex");
}

TEST_F(CliCage, ThatIsOpenOrFitsNoHandlesIsRefused) {
  std::string text = cubeOff(30);
  text.resize(text.rfind("3 1 7 5"));
  text.replace(text.find("8 12 0"), 6, "8 11 0");
  expectFailure({"handles", organ_, "--cage", put("open.off", text), "-o", path("h.mrk.json")}, kBadData,
                "open at 3 edges");
  std::string crossing = cubeOff(30);
  const std::string corner = "30.000000 30.000000 30.000000\n";
  crossing.replace(crossing.rfind(corner), corner.size(), "-50 0 0\n");
  expectFailure({"handles", organ_, "--cage", put("crossing.off", crossing), "-o", path("h.mrk.json")},
                kBadData, "crosses itself");
  put("h.mrk.json", markups(corners(25)));
  expectFailure({"bind", organ_, "--handles", path("h.mrk.json"), "--cage", cage_, "--system", "green"},
                kBadData, "no handle at vertex 0");
}

TEST_F(CliCage, GreenCoordinatesKeepALockedVolume) {
  runJson({"handles", organ_, "--cage", cage_, "-o", path("h.mrk.json")});
  auto posed = corners(30);
  posed[7] = {45, 38, 33};
  put("pose.mrk.json", markups(posed));
  const json result = runJson({"deform", organ_, "--handles", path("h.mrk.json"), "--pose",
                               path("pose.mrk.json"), "--cage", cage_, "--system", "green", "--lock-volume"});
  EXPECT_LT(result["relativeVolumeError"].get<double>(), 1e-9);
}

} // namespace
} // namespace viscera::app::cli
