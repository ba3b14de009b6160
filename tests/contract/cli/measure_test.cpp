#include "cli_test.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>

#include "shapes.h"

namespace viscera::app::cli {
namespace {

using testing::HasSubstr;

class MeasureCli : public CliTest {
protected:
  /// A box of 20 x 30 x 40 mm whose lowest corner is there.
  std::string box(const std::string& name, const Vec3& corner) const {
    const geometry::TriangleMesh mesh = tests::box(20, 30, 40);
    std::ostringstream off;
    off << "OFF\n" << mesh.points.rows() << ' ' << mesh.triangles.rows() << " 0\n";
    for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
      off << mesh.points(i, 0) + corner.x() << ' ' << mesh.points(i, 1) + corner.y() << ' '
          << mesh.points(i, 2) + corner.z() << '\n';
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      off << "3 " << mesh.triangles(t, 0) << ' ' << mesh.triangles(t, 1) << ' ' << mesh.triangles(t, 2) << '\n';
    return put(name, off.str());
  }
};

TEST_F(MeasureCli, GivesTheDistancesOfAllPairsOrFromOneOrgan) {
  const std::string a = box("a.off", {0, 0, 0}), b = box("b.off", {23, 34, 0}), c = box("c.off", {10, 10, 10});
  const json all = runJson({"measure", a, b, c});
  ASSERT_EQ(all["distances"].size(), 3u);
  EXPECT_EQ(all["distances"][0]["from"], "a");
  EXPECT_EQ(all["distances"][0]["to"], "b");
  EXPECT_NEAR(all["distances"][0]["distanceMm"].get<double>(), 5, 1e-9);
  EXPECT_TRUE(all["distances"][1]["touching"].get<bool>()) << "a and c cross";
  const json from = runJson({"measure", a, b, c, "--from", "b"});
  ASSERT_EQ(from["distances"].size(), 2u);
  EXPECT_EQ(from["distances"][1]["from"], "b");
  expectFailure({"measure", a, b, "--from", "liver"}, kUsage, "no organ of that name");
}

TEST_F(MeasureCli, GivesTheVolumesOnBothSidesOfAPlane) {
  const std::string a = box("a.off", {0, 0, 0});
  const json cut = runJson({"measure", a, "--plane", "0,0,10:0,0,-2"})["resection"];
  EXPECT_NEAR(cut["organs"][0]["frontMl"].get<double>(), 20 * 30 * 10 / 1000.0, 1e-9);
  EXPECT_NEAR(cut["organs"][0]["backMl"].get<double>(), 20 * 30 * 30 / 1000.0, 1e-9);
  EXPECT_NEAR(cut["organs"][0]["faceCm2"].get<double>(), 6, 1e-9);
  EXPECT_NEAR(cut["normal"][2].get<double>(), -1, 1e-12);
  EXPECT_THAT(run({"measure", a, "--plane", "0,0,10:0,0,1"}).out, HasSubstr("ml in front of the plane"));
  expectFailure({"measure", a, "--plane", "0,0,10"}, kUsage, "A plane is");
  expectFailure({"measure", a, "--plane", "0,0,10:0,0,0"}, kUsage, "must not be zero");
}

TEST_F(MeasureCli, MeasuresInThePoseAndMovesABoneAsARigidBody) {
  const std::string tissue = box("tissue.off", {0, 0, 0}), bone = box("left femur.off", {60, 0, 0});
  // Handles around both: those of one box that encloses them.
  const geometry::TriangleMesh around = tests::box(140, 90, 100);
  std::string points, posed;
  for (Eigen::Index i = 0; i < around.points.rows(); ++i) {
    const Vec3 at = around.points.row(i).transpose() - Vec3(30, 30, 30);
    const auto point = [&](const Vec3& p) {
      return R"({"label": "H-)" + std::to_string(i + 1) + R"(", "position": [)" + std::to_string(p.x()) + ", " +
             std::to_string(p.y()) + ", " + std::to_string(p.z()) + "]}";
    };
    points += (i > 0 ? "," : "") + point(at);
    posed += (i > 0 ? "," : "") + point(at.x() > 0 ? Vec3(at + Vec3(25, 0, 15)) : at);
  }
  const auto file = [&](const std::string& name, const std::string& list) {
    return put(name, R"({"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [)" +
                         list + "]}]}");
  };
  const std::string handles = file("rest.mrk.json", points), pose = file("pose.mrk.json", posed);
  const double atRest = runJson({"measure", tissue, bone})["distances"][0]["distanceMm"];
  const double now =
      runJson({"measure", tissue, bone, "--handles", handles, "--pose", pose})["distances"][0]["distanceMm"];
  EXPECT_NEAR(atRest, 40, 1e-9);
  EXPECT_GT(now, 42);
  const std::vector<std::string> deform = {"deform", bone, "--handles", handles, "--pose", pose};
  const json rigid = runJson(deform);
  EXPECT_EQ(rigid["mobility"], "rigid");
  EXPECT_NEAR(rigid["volumeMl"].get<double>(), 24, 1e-6);
  EXPECT_THAT(rigid["warnings"].dump(), HasSubstr("is a bone"));
  std::vector<std::string> bends = deform;
  bends.insert(bends.end(), {"--mobility", "bends"});
  EXPECT_GT(std::abs(runJson(bends)["volumeMl"].get<double>() - 24), 1e-3);
  std::vector<std::string> fixed = deform;
  fixed.insert(fixed.end(), {"--mobility", "fixed"});
  EXPECT_EQ(runJson(fixed)["maxDisplacementMm"], 0);
  std::vector<std::string> exact = deform;
  exact.insert(exact.end(), {"--mobility", "bends", "--lock-volume", "--exact", "--compensate", "H-2"});
  expectFailure(exact, kUsage, "cannot compensate exactly");
}

} // namespace
} // namespace viscera::app::cli
