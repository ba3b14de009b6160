#include "viscera/deformation/tetrahedralise.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

using Reason = TetrahedraError::Reason;

/// Tries and says why it failed.
Reason failureOf(const geometry::TriangleMesh& surface, const TetrahedraOptions& options) {
  Progress progress;
  try {
    tetrahedralise(surface, options, progress);
  } catch (const TetrahedraError& error) {
    EXPECT_FALSE(error.problem().empty());
    return error.reason();
  }
  ADD_FAILURE() << "there are tetrahedra";
  return Reason::missing;
}

/// A program in the worker's place.
class FakeWorker {
public:
  explicit FakeWorker(const std::string& script) : file_(folder_.put("worker", "#!/bin/sh\n" + script)) {
    std::filesystem::permissions(file_, std::filesystem::perms::owner_all);
    options_.worker = file_;
    options_.timeLimitSeconds = 200; // A busy machine may take its time.
  }
  TetrahedraOptions options() const { return options_; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

private:
  tests::TemporaryFolder folder_;
  std::filesystem::path file_;
  TetrahedraOptions options_;
};

geometry::TriangleMesh intersectingBoxes() {
  geometry::TriangleMesh mesh = tests::box(10, 10, 10);
  const geometry::TriangleMesh other = tests::box(10, 10, 10);
  mesh.points.conservativeResize(16, 3);
  mesh.triangles.conservativeResize(24, 3);
  mesh.points.bottomRows(8) = other.points.rowwise() + Eigen::RowVector3d(3.1, 4.2, 5.3);
  mesh.triangles.bottomRows(12) = other.triangles.array() + 8;
  return mesh;
}

TEST(Tetrahedralise, FillsASurfaceAndKeepsItsVertices) {
  const geometry::TriangleMesh surface = tests::sphere(3, 20, {5, 6, 7});
  Progress progress;
  TetrahedraOptions options;
  options.maxVolumeMm3 = 40;
  const WitnessMesh mesh = tetrahedralise(surface, options, progress);
  requireUsable(mesh, "test");
  EXPECT_GT(mesh.witnesses, 100);
  EXPECT_EQ(mesh.points.rows() - mesh.witnesses, surface.points.rows());
  EXPECT_EQ(mesh.points.bottomRows(surface.points.rows()), surface.points);
  const Values volumes = tetrahedronVolumes(mesh.points, mesh.tetrahedra);
  const double volume = geometry::volume(surface.points, surface.triangles);
  EXPECT_NEAR(volumes.sum(), volume, 1e-9 * volume);
  EXPECT_LT((volumes.array() > 40).count(), volumes.size() / 100);
  const Triangles skin = skinOf(mesh.tetrahedra);
  EXPECT_EQ(skin.rows(), surface.triangles.rows());
  EXPECT_GE(skin.minCoeff(), mesh.witnesses);
  EXPECT_LT((mesh.points.topRows(mesh.witnesses).rowwise() - Eigen::RowVector3d(5, 6, 7))
                .rowwise()
                .norm()
                .maxCoeff(),
            20);
}

TEST(Tetrahedralise, GivesTheSameMeshTwice) {
  Progress progress;
  TetrahedraOptions options;
  options.maxVolumeMm3 = 100;
  const WitnessMesh one = tetrahedralise(tests::sphere(3, 20), options, progress);
  const WitnessMesh two = tetrahedralise(tests::sphere(3, 20), options, progress);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.tetrahedra, two.tetrahedra);
}

TEST(Tetrahedralise, LeavesACavityEmpty) {
  geometry::TriangleMesh shells = tests::sphere(3, 20);
  geometry::TriangleMesh inner = tests::sphere(2, 10);
  inner.triangles.col(0).swap(inner.triangles.col(1));
  const auto points = shells.points.rows(), triangles = shells.triangles.rows();
  shells.points.conservativeResize(points + inner.points.rows(), 3);
  shells.triangles.conservativeResize(triangles + inner.triangles.rows(), 3);
  shells.points.bottomRows(inner.points.rows()) = inner.points;
  shells.triangles.bottomRows(inner.triangles.rows()) =
      inner.triangles.array() + static_cast<std::int32_t>(points);
  Progress progress;
  TetrahedraOptions options;
  options.maxVolumeMm3 = 100;
  const WitnessMesh mesh = tetrahedralise(shells, options, progress);
  const double volume = geometry::volume(shells.points, shells.triangles);
  EXPECT_NEAR(tetrahedronVolumes(mesh.points, mesh.tetrahedra).sum(), volume, 1e-9 * volume);
  EXPECT_GT(mesh.points.topRows(mesh.witnesses).rowwise().norm().minCoeff(), 9.5);
}

TEST(Tetrahedralise, SurvivesSurfacesThatTetGenRefuses) {
  EXPECT_EQ(failureOf(intersectingBoxes(), {}), Reason::refused);
  geometry::TriangleMesh open = tests::sphere(2, 10);
  open.triangles = open.triangles.topRows(100).eval();
  EXPECT_EQ(failureOf(open, {}), Reason::refused);
  EXPECT_EQ(failureOf({}, {}), Reason::refused);
}

TEST(Tetrahedralise, SurvivesAWorkerThatIsMissingOrCannotRun) {
  TetrahedraOptions options;
  options.worker = "/nonexistent/viscera_tetgen_worker";
  EXPECT_EQ(failureOf(tests::box(), options), Reason::missing);
  options.worker = "/"; // A folder.
  EXPECT_EQ(failureOf(tests::box(), options), Reason::missing);
}

TEST(Tetrahedralise, SurvivesAWorkerThatEndsInAnyWay) {
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("kill -ABRT $$\n").options()), Reason::refused);
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("kill -SEGV $$\n").options()), Reason::refused);
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("cat >/dev/null; exit 3\n").options()), Reason::refused);
  // Says that it is done, and sends nothing, half of something, or anything.
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("exit 0\n").options()), Reason::unusable);
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("cat\n").options()), Reason::unusable);
  EXPECT_EQ(failureOf(tests::box(), FakeWorker("head -c 5000 /dev/urandom\n").options()), Reason::unusable);
}

TEST(Tetrahedralise, EndsAWorkerThatTakesTooLong) {
  for (const std::string script : {"sleep 60\n", "exec >&- <&-; while :; do :; done\n"}) {
    const FakeWorker worker(script);
    TetrahedraOptions options = worker.options();
    options.timeLimitSeconds = 0.3;
    EXPECT_EQ(failureOf(tests::box(), options), Reason::timeLimit);
  }
}

TEST(Tetrahedralise, EndsAWorkerThatTakesTooMuchMemory) {
  // The worker's memory is limited before the request comes, so it waits for that.
  const FakeWorker eater("head -c 1 >/dev/null; tail /dev/zero\n");
  TetrahedraOptions options = eater.options();
  options.memoryLimitBytes = 50u << 20;
  EXPECT_EQ(failureOf(tests::box(), options), Reason::memoryLimit);
  const FakeWorker talker("cat /dev/zero\n");
  options.worker = talker.options().worker;
  EXPECT_EQ(failureOf(tests::box(), options), Reason::memoryLimit);
}

TEST(Tetrahedralise, KeepsTetGenItselfWithinItsLimits) {
  const geometry::TriangleMesh surface = tests::sphere(5, 10);
  TetrahedraOptions options;
  options.maxVolumeMm3 = 1e-4; // Tens of millions of tetrahedra.
  options.memoryLimitBytes = 100u << 20;
  EXPECT_EQ(failureOf(surface, options), Reason::memoryLimit);
  options.memoryLimitBytes = std::uint64_t{4} << 30;
  options.timeLimitSeconds = 0.3;
  EXPECT_EQ(failureOf(surface, options), Reason::timeLimit);
}

TEST(Tetrahedralise, KillsTheWorkerWithItsChildrenWhenCancelled) {
  const FakeWorker worker("echo $$ >\"$(dirname \"$0\")/pid\"\nsleep 60 & wait\n");
  Progress progress;
  std::thread impatient([&] {
    while (tests::contentsOf(worker / "pid").empty())
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    progress.cancel();
  });
  EXPECT_THROW(tetrahedralise(tests::box(), worker.options(), progress), Cancelled);
  impatient.join();
  const int group = std::stoi(tests::contentsOf(worker / "pid"));
  // Whoever adopts the grandchild may take a moment to bury it.
  for (int i = 0; i < 500 && kill(-group, 0) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_NE(kill(group, 0), 0);
}

} // namespace
} // namespace viscera::deformation
