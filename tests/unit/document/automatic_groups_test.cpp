#include "viscera/document/group_commands.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::document {
namespace {

using By = GroupingChoice::By;
using tests::ball;
using tests::row;

/// How many vertices of all organs lie in no group's hull.
int uncovered(const DocumentState& state) {
  std::vector<geometry::ConvexHull> hulls;
  const Points rest = state.rig->restPositions();
  for (const Group& group : state.rig->groups) {
    std::vector<int> rows;
    for (const HandleId id : group.handles)
      rows.push_back(state.rig->indexOf(id));
    hulls.emplace_back(Points(rest(rows, Eigen::all)));
  }
  int count = 0;
  for (const auto& organ : *state.organs)
    for (const auto& vertex : organ->mesh->points.rowwise())
      count += std::none_of(hulls.begin(), hulls.end(),
                            [&](const auto& hull) { return hull.signedDistance(vertex.transpose()) <= 0; });
  return count;
}

std::set<HandleId> grouped(const Rig& rig) {
  std::set<HandleId> all;
  for (const Group& group : rig.groups)
    all.insert(group.handles.begin(), group.handles.end());
  return all;
}

TEST(AutomaticGroups, EveryWayHoldsAllVerticesAndAllHandlesInOneUndoStep) {
  for (const By by : {By::organ, By::axis, By::cluster}) {
    tests::Session s;
    s.undo.perform(addOrgans({ball("Other", 12, 2, Vec3(45, 0, 0))}));
    const DocumentState before = s.document.state();
    s.undo.perform(groupAutomatically({by, 2}));
    EXPECT_EQ(s.document.rig().groups.size(), 2u);
    EXPECT_EQ(uncovered(s.document.state()), 0);
    EXPECT_EQ(grouped(s.document.rig()).size(), s.document.rig().handles.size()) << "a handle in no group";
    EXPECT_NE(s.document.rig().groups[0].color, s.document.rig().groups[1].color);
    EXPECT_EQ(s.document.pose().rows(), Eigen::Index(s.document.rig().handles.size()));
    s.undo.undo();
    EXPECT_EQ(s.document.state(), before);
  }
}

TEST(AutomaticGroups, DoingItAgainTakesTheHandlesAwayThatItHadAdded) {
  tests::Session s;
  const std::size_t own = s.document.rig().handles.size();
  s.undo.perform(groupAutomatically({By::axis, 4}));
  const std::size_t first = s.document.rig().handles.size();
  ASSERT_GT(first, own) << "ten handles cannot hold four parts";
  s.undo.perform(groupAutomatically({By::axis, 4}));
  EXPECT_EQ(s.document.rig().handles.size(), first);
  s.undo.perform(groupAutomatically({By::axis, 1}));
  EXPECT_EQ(s.document.rig().handles.size(), own) << "the cube's corners hold the ball";
}

TEST(AutomaticGroups, KeepsThePoseOfTheHandlesThatStay) {
  tests::Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 55)));
  s.undo.perform(groupAutomatically({By::axis, 3}));
  EXPECT_EQ(s.document.pose().row(8), row(1, 2, 55));
}

TEST(AutomaticGroups, AnOrgansPiecesAreGroupsAndItsCavityIsNot) {
  tests::Session s;
  geometry::TriangleMesh two = viscera::tests::sphere(2, 10, Vec3(-40, 0, 0));
  const geometry::TriangleMesh other = viscera::tests::sphere(2, 10, Vec3(40, 0, 0));
  const auto before = static_cast<std::int32_t>(two.points.rows());
  two.points.conservativeResize(2 * before, 3);
  two.points.bottomRows(before) = other.points;
  const Eigen::Index triangles = two.triangles.rows();
  two.triangles.conservativeResize(2 * triangles, 3);
  two.triangles.bottomRows(triangles) = other.triangles.array() + before;
  s.undo.perform(removeOrgans({s.organ()}));
  s.undo.perform(addOrgans({{makeOrgan("Kidneys", two), -1}}));
  s.undo.perform(addOrgans({{makeOrgan("Pelvis", viscera::tests::sphere(1, 4, Vec3(-40, 0, 0))), -1}}));
  OrganList organs = s.document.organs();
  auto cavity = std::make_shared<Organ>(*organs[1]);
  cavity->parent = organs[0]->id;
  organs[1] = cavity;
  const auto grouping = makeGroups({By::organ, 1}, organs, s.document.rig().restPositions());
  ASSERT_EQ(grouping.groups.size(), 2u);
  EXPECT_EQ(grouping.groups[0].name, "Kidneys 1");
  EXPECT_EQ(grouping.groups[1].name, "Kidneys 2");
}

TEST(AutomaticGroups, SaysWhatIsMissing) {
  Document empty;
  UndoStack undo(empty);
  EXPECT_THROW(undo.perform(groupAutomatically({})), UsageError);
  undo.perform(addHandles(tests::cubeHandles()));
  const DocumentState before = empty.state();
  EXPECT_THROW(undo.perform(groupAutomatically({})), UsageError) << "no organ";
  EXPECT_EQ(empty.state(), before);
  tests::Session s;
  EXPECT_THROW(s.undo.perform(groupAutomatically({By::axis, 0})), UsageError);
  EXPECT_THROW(s.undo.perform(groupAutomatically({By::cluster, 11})), DataError) << "ten handles";
  EXPECT_THROW(groupingFromName("colour"), UsageError);
  EXPECT_EQ(groupingFromName("cluster"), By::cluster);
}

TEST(EnclosingGroup, HoldsTheVerticesAndNoMoreThanThat) {
  tests::Session s;
  const Points& points = s.document.organs()[0]->mesh->points;
  std::vector<int> top;
  for (int v = 0; v < static_cast<int>(points.rows()); ++v)
    if (points(v, 2) > 20)
      top.push_back(v);
  s.undo.perform(addEnclosingGroup(s.organ(), top));
  const Group& group = s.document.rig().groups.back();
  EXPECT_EQ(group.name, "Enclosing");
  ASSERT_EQ(group.handles.size(), 8u);
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i)
    corners.row(i) =
        s.document.rig().handles[std::size_t(s.document.rig().indexOf(group.handles[i]))].rest.transpose();
  const geometry::ConvexHull hull(corners);
  for (int v = 0; v < static_cast<int>(points.rows()); ++v) {
    const double distance = hull.signedDistance(points.row(v).transpose());
    EXPECT_TRUE(points(v, 2) <= 20 || distance < 0);
    EXPECT_TRUE(points(v, 2) >= 15 || distance > 0);
  }
  EXPECT_THROW(s.undo.perform(addEnclosingGroup(s.organ(), {})), UsageError);
  EXPECT_THROW(s.undo.perform(addEnclosingGroup(s.organ(), {99999})), UsageError);
  EXPECT_THROW(s.undo.perform(addEnclosingGroup(OrganId{77}, {0})), UsageError);
}

} // namespace
} // namespace viscera::document
