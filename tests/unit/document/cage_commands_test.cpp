#include "viscera/document/system_commands.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/live/live_binding.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using tests::cubeCage;
using State = live::BindingStatus::State;

/// A ball of 30 mm, handles at the corners of a cube of 120 mm and two more inside, mean value coordinates,
/// and what keeps it bound.
struct Caged : tests::BoundSession {
  Caged() {
    undo.perform(setSystem({"mean-value", {}}));
    undo.reset(document.state());
  }
  const Rig& rig() const { return document.rig(); }
  void take(std::shared_ptr<const geometry::TriangleMesh> mesh) {
    undo.perform(takeCage({"cage.off", std::move(mesh)}));
  }
  live::BindingStatus status() { return live.status(organ()); }
};

/// The corner 7 of the cube pushed in.
std::shared_ptr<geometry::TriangleMesh> dentedCage(double to) {
  auto cage = cubeCage();
  cage->points.row(7).setConstant(to);
  return cage;
}

class CageFile : public testing::Test {
protected:
  GivenCage read(const geometry::TriangleMesh& mesh) {
    medical_io::writeSurface(folder_ / "cage.off", mesh);
    Progress progress;
    return readCage(folder_ / "cage.off", progress);
  }
  std::string refusal(const geometry::TriangleMesh& mesh) {
    try {
      read(mesh);
    } catch (const DataError& error) {
      return error.what();
    }
    return "nothing was refused";
  }

private:
  viscera::tests::TemporaryFolder folder_;
};

TEST_F(CageFile, IsReadAndTurnedOutward) {
  auto mesh = *cubeCage();
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  const GivenCage cage = read(mesh);
  EXPECT_EQ(cage.name, "cage.off");
  EXPECT_EQ(cage.mesh->points.rows(), 8);
  EXPECT_TRUE(geometry::checkSurface(*cage.mesh).outward());
}

TEST_F(CageFile, ThatCanBeNoCageIsRefusedByNameWithWhatToTry) {
  auto open = *cubeCage();
  open.triangles.conservativeResize(11, 3);
  EXPECT_THAT(refusal(open),
              AllOf(HasSubstr("cage.off"), HasSubstr("open at 3 edges"), HasSubstr("closed cage")));
  EXPECT_THAT(refusal(viscera::tests::sphere(6, 50)),
              AllOf(HasSubstr("cage.off"), HasSubstr("16386 vertices"), HasSubstr("at most 10000")));
  auto crossing = *cubeCage();
  crossing.points.row(7) << -90, 0, 0; // Out through the opposite face.
  EXPECT_THAT(refusal(crossing), AllOf(HasSubstr("cage.off"), HasSubstr("crosses itself")));
  Progress progress;
  EXPECT_THROW(readCage("/nowhere/cage.off", progress), NoInputError);
}

TEST(CageCommands, MakeHandlesAtItsVerticesTheCornersAndKeepWhatTheyAre) {
  Caged s;
  s.undo.perform(addGroup("Top", {1, 0, 0}, {s.handle(7), s.handle(8)}));
  s.undo.perform(moveHandles({s.handle(7)}, tests::row(70, 70, 70)));
  const Rig before = s.rig();
  const Points pose = s.document.pose();
  s.take(cubeCage());
  EXPECT_EQ(s.rig().handles, before.handles);
  EXPECT_EQ(s.rig().groups, before.groups);
  EXPECT_EQ(s.document.pose(), pose);
  ASSERT_EQ(s.rig().cage.size(), 12u);
  EXPECT_EQ(s.rig().cornerCount(), 8);
  EXPECT_EQ(handleSet(s.rig()).cage, cubeCage()->triangles);
  EXPECT_EQ(s.undo.undoName().english(), "Take the cage cage.off");
  const std::size_t steps = s.undo.position();
  s.take(cubeCage());
  EXPECT_EQ(s.undo.position(), steps) << "it was the cage already";
  s.undo.undo();
  EXPECT_EQ(s.rig(), before);
  s.undo.redo();
  EXPECT_EQ(s.rig().cage.size(), 12u);
}

TEST(CageCommands, MakeItsVerticesTheHandlesWhereThoseStandElsewhere) {
  Caged s;
  const Rig before = s.rig();
  EXPECT_FALSE(handlesAtAllVertices(before, *cubeCage(61)));
  EXPECT_TRUE(handlesAtAllVertices(before, *cubeCage(60 + 1e-7)));
  s.take(cubeCage(61));
  EXPECT_EQ(s.rig().restPositions(), cubeCage(61)->points);
  EXPECT_TRUE(atRest(s.document.state()));
  EXPECT_EQ(s.rig().cornerCount(), 8);
  EXPECT_EQ(s.rig().handles.front().label, "H-1");
  s.undo.undo();
  EXPECT_EQ(s.rig(), before);
}

TEST(CageCommands, RefuseACageThatIsOpenAndARigWithACageOfOtherHandles) {
  Caged s;
  const DocumentState before = s.document.state();
  auto open = cubeCage();
  open->triangles.conservativeResize(11, 3);
  EXPECT_THROW(s.take(open), DataError);
  auto empty = cubeCage();
  empty->triangles.resize(0, 3);
  EXPECT_THROW(s.take(empty), DataError);
  Rig rig = rigAt(cubeCage()->points);
  const Triangles corners = cubeCage()->triangles;
  for (const auto& triangle : corners.rowwise())
    rig.cage.push_back({rig.handles[static_cast<std::size_t>(triangle[0])].id,
                        rig.handles[static_cast<std::size_t>(triangle[1])].id,
                        rig.handles[static_cast<std::size_t>(triangle[2])].id});
  rig.handles.pop_back();
  EXPECT_THROW(s.undo.perform(replaceRig(rig)), UsageError);
  EXPECT_EQ(s.document.state(), before);
}

TEST(CageCommands, GiveTheCageUpAndKeepTheHandles) {
  Caged s;
  s.undo.perform(dropCage());
  EXPECT_EQ(s.undo.position(), 0u) << "there was none";
  s.take(dentedCage(40));
  const Rig dented = s.rig();
  s.undo.perform(dropCage());
  EXPECT_TRUE(s.rig().cage.empty());
  EXPECT_EQ(s.rig().handles, dented.handles);
  s.undo.undo();
  EXPECT_EQ(s.rig(), dented);
}

TEST(CageCommands, LoseTheCageWithACornerAndKeepItWithoutAnotherHandle) {
  Caged s;
  s.take(cubeCage());
  const std::vector<CageTriangle> cage = s.rig().cage;
  s.undo.perform(removeHandles({s.handle(9)}));
  EXPECT_EQ(s.rig().cage, cage);
  s.undo.perform(addHandles({{Vec3(0, 0, 45)}}));
  EXPECT_EQ(s.rig().cage, cage);
  s.undo.perform(removeHandles({s.handle(3), s.handle(9)}));
  EXPECT_TRUE(s.rig().cage.empty());
  s.undo.undo();
  EXPECT_EQ(s.rig().cage, cage);
}

TEST(CageCommands, MoveTheCageWithItsCornersAtRest) {
  Caged s;
  s.take(cubeCage());
  s.undo.perform(moveRestHandles({s.handle(7)}, tests::row(50, 50, 50)));
  EXPECT_EQ(s.rig().cage.size(), 12u);
  EXPECT_EQ(s.status().state, State::bound);
}

TEST(CageBinding, FollowsTheCageAndNotTheHull) {
  Caged s;
  const HandleId inner = s.handle(8);
  EXPECT_EQ(s.status().state, State::bound);
  s.take(dentedCage(40)); // Its hull leaves the dent out.
  ASSERT_EQ(s.status().state, State::bound);
  const Values caged = s.live.influence(s.organ(), s.handle(7));
  ASSERT_GT(caged.size(), 0);
  s.undo.perform(dropCage());
  ASSERT_EQ(s.status().state, State::bound);
  EXPECT_GT((s.live.influence(s.organ(), s.handle(7)) - caged).cwiseAbs().maxCoeff(), 0.01);
  s.undo.undo();
  EXPECT_EQ(s.live.influence(s.organ(), s.handle(7)), caged);
  EXPECT_EQ(s.rig().indexOf(inner), -1) << "the dented cage's own vertices are the handles";
}

TEST(CageBinding, IsNotMadeAnewWhereCoordinatesNeedNoCage) {
  Caged s;
  s.undo.perform(setSystem({"s-celestial", {}}));
  const auto* deformer = s.live.deformer(s.organ());
  s.take(cubeCage());
  EXPECT_EQ(s.live.deformer(s.organ()), deformer);
}

TEST(CageBinding, SaysHowManyVerticesHaveNoCoordinatesAndTheHullMends) {
  Caged s;
  s.undo.perform(setSystem({"green", {}}));
  s.take(dentedCage(5));
  const live::BindingStatus status = s.status();
  ASSERT_EQ(status.state, State::failed);
  EXPECT_TRUE(status.givenCage);
  EXPECT_GT(status.outsideCage, 0);
  EXPECT_EQ(status.outsideHull, 0);
  EXPECT_THAT(status.message.english(),
              AllOf(HasSubstr("have no coordinates in the cage"), HasSubstr("convex hull")));
  EXPECT_TRUE(s.live.points(s.organ()).allFinite());
  s.undo.perform(dropCage());
  EXPECT_EQ(s.status().state, State::bound);
  EXPECT_FALSE(s.status().givenCage);
  EXPECT_EQ(s.status().outsideCage, 0);
}

} // namespace
} // namespace viscera::document
