#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"

namespace viscera::document {
namespace {

using ::testing::HasSubstr;
using tests::ball;
using tests::row;
using tests::Session;

/// Performs a command that has to fail, and proves that the document did not change. Returns the message.
template <class Expected>
std::string refusal(Session& s, const Command& command) {
  const DocumentState before = s.document.state();
  std::string message;
  try {
    s.undo.perform(command);
    ADD_FAILURE() << command.name << " was accepted";
  } catch (const Expected& error) {
    message = error.what();
  }
  EXPECT_EQ(s.document.state(), before);
  EXPECT_TRUE(s.undo.names().empty());
  return message;
}

TEST(MakeOrgan, MeasuresAClosedSurfaceAndTurnsOneThatIsInsideOut) {
  const Organ organ = makeOrgan("Box", viscera::tests::box(20, 30, 40));
  EXPECT_TRUE(organ.closed());
  EXPECT_NEAR(organ.restVolumeMm3, 24000, 1e-9);
  EXPECT_TRUE(organ.warnings.empty());
  geometry::TriangleMesh turned = viscera::tests::box(20, 30, 40);
  turned.triangles.col(0).swap(turned.triangles.col(1));
  const Organ mended = makeOrgan("Box", turned);
  EXPECT_NEAR(mended.restVolumeMm3, 24000, 1e-9);
  EXPECT_THAT(inEnglish(mended.warnings),
              ::testing::ElementsAre(HasSubstr("inside out"), HasSubstr("turned around")));
}

TEST(MakeOrgan, GivesAnOpenSurfaceNoVolumeAndSaysSo) {
  geometry::TriangleMesh open = viscera::tests::box(20, 30, 40);
  open.triangles.conservativeResize(11, 3);
  const Organ organ = makeOrgan("Open", open);
  EXPECT_FALSE(organ.closed());
  EXPECT_EQ(organ.boundaryEdges, 3);
  EXPECT_EQ(organ.restVolumeMm3, 0);
  ASSERT_FALSE(organ.warnings.empty());
  EXPECT_THAT(organ.warnings[0].english(), HasSubstr("3 boundary edges"));
}

TEST(MakeOrgan, RefusesASurfaceWithoutTrianglesAndOneThatIsNotFinite) {
  geometry::TriangleMesh mesh = viscera::tests::box(20, 30, 40);
  mesh.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(makeOrgan("NaN", mesh), DataError);
  mesh = viscera::tests::box();
  mesh.triangles.resize(0, 3);
  EXPECT_THROW(makeOrgan("Points", mesh), DataError);
}

TEST(OrganCommands, AddCavitiesToTheirOrganAndRemoveThemWithIt) {
  Session s;
  NewOrgan cavity = ball("Ball", 10);
  cavity.parentInBatch = 0;
  s.undo.perform(addOrgans({ball("Heart", 30), cavity}));
  ASSERT_EQ(s.document.organs().size(), 3u);
  EXPECT_EQ(s.document.organs()[2]->parent, s.document.organs()[1]->id);
  EXPECT_EQ(s.document.organs()[2]->name, "Ball 2") << "the name is taken";
  s.undo.perform(removeOrgans({s.organ(1)}));
  ASSERT_EQ(s.document.organs().size(), 1u);
  EXPECT_EQ(s.document.organs()[0]->name, "Ball");
}

TEST(OrganCommands, RemoveAllOrgansAndUndoBringsThemBack) {
  Session s;
  s.undo.perform(addOrgans({ball("Heart", 30), ball("Liver", 20)}));
  s.undo.perform(removeAllOrgans());
  EXPECT_TRUE(s.document.organs().empty());
  s.undo.undo();
  EXPECT_EQ(s.document.organs().size(), 3u);
}

TEST(OrganCommands, RefuseWhatIsNotThereOrOutOfRange) {
  Session s;
  OrganLook look;
  EXPECT_THAT(refusal<UsageError>(s, setOrganLook(OrganId{99}, look)), HasSubstr("no such organ"));
  look.opacity = 1.5;
  EXPECT_THAT(refusal<DataError>(s, setOrganLook(s.organ(), look)), HasSubstr("opacity"));
  look.opacity = 1;
  look.color[1] = std::nan("");
  EXPECT_THAT(refusal<DataError>(s, setOrganLook(s.organ(), look)), HasSubstr("colour"));
  refusal<UsageError>(s, removeOrgans({OrganId{99}}));
  refusal<DataError>(s, renameOrgan(s.organ(), ""));
}

TEST(RigCommands, LabelNewHandlesOnwardsFromThoseThereAre) {
  Session s;
  s.undo.perform(removeHandles({s.handle(3)}));
  s.undo.perform(addHandles({{Vec3(0, 0, 70)}, {Vec3(0, 0, 71), std::nullopt, "Apex"}, {Vec3(0, 0, 72)}}));
  const auto& handles = s.document.rig().handles;
  ASSERT_EQ(handles.size(), 12u);
  EXPECT_EQ(handles[9].label, "H-11");
  EXPECT_EQ(handles[10].label, "Apex");
  EXPECT_EQ(handles[11].label, "H-12");
}

TEST(RigCommands, KeepTheDisplacementOfAHandleThatMovesAtRest) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 45)));
  s.undo.perform(moveRestHandles({s.handle(8), s.handle(9)}, [] {
    Points positions(2, 3);
    positions << 10, 0, 40, 0.1, 0.2, -41.3;
    return positions;
  }()));
  EXPECT_EQ(s.document.pose().row(8), row(11, 0, 45));
  EXPECT_EQ(s.document.pose().row(9), row(0.1, 0.2, -41.3)) << "a handle at rest stays at rest, exactly";
  EXPECT_EQ(s.document.rig().handles[9].rest, Vec3(0.1, 0.2, -41.3));
}

TEST(RigCommands, LeaveLockedHandlesWhereTheyAre) {
  Session s;
  HandleEdit lock;
  lock.locked = true;
  s.undo.perform(editHandles({s.handle(8)}, lock));
  const DocumentState before = s.document.state();
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 1, 1)));
  s.undo.perform(moveRestHandles({s.handle(8)}, row(1, 1, 1)));
  EXPECT_EQ(s.document.state(), before);
  EXPECT_EQ(inEnglish(s.undo.names()), std::vector<std::string>{"Lock handle"});
}

TEST(RigCommands, RefuseTwoHandlesAtOnePlaceAndPositionsThatAreNotFinite) {
  Session s;
  EXPECT_THAT(refusal<DataError>(s, addHandles({{Vec3(0, 0, 40)}})), HasSubstr("H-9 and H-11"));
  EXPECT_THAT(refusal<DataError>(s, moveRestHandles({s.handle(9)}, row(0, 0, 40 + 1e-8))),
              HasSubstr("one place"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal<DataError>(s, moveRestHandles({s.handle(9)}, row(nan, 0, 0))), HasSubstr("H-10"));
  EXPECT_THAT(refusal<DataError>(s, moveHandles({s.handle(9)}, row(0, nan, 0))), HasSubstr("H-10"));
  refusal<DataError>(s, addHandles({{Vec3(nan, 0, 0)}}));
  refusal<DataError>(s, setPose(Points::Constant(10, 3, nan)));
  refusal<DataError>(s, setPose(Points::Zero(9, 3)));
  refusal<UsageError>(s, moveHandles({s.handle(8), s.handle(9)}, row(0, 0, 0)));
  refusal<UsageError>(s, removeHandles({HandleId{999}}));
}

TEST(RigCommands, FindTwoHandlesAtOnePlaceAmongManyWithTheSameX) {
  Session s;
  std::vector<NewHandle> wall;
  for (int i = 0; i < 200; ++i)
    wall.push_back({Vec3(100, i, 0)});
  s.undo.perform(addHandles(wall));
  s.undo.reset(s.document.state());
  refusal<DataError>(s, addHandles({{Vec3(100, 150, 0)}}));
}

TEST(RigCommands, RemoveAHandleFromItsGroupsAndItsRowFromThePose) {
  Session s;
  s.undo.perform(addGroup("Top", {1, 0, 0}, {s.handle(9), s.handle(8)}));
  s.undo.perform(moveHandles({s.handle(9)}, row(50, 3, -1)));
  const HandleId last = s.handle(9);
  s.undo.perform(removeHandles({s.handle(8)}));
  ASSERT_EQ(s.document.pose().rows(), 9);
  EXPECT_EQ(s.document.pose().row(8), row(50, 3, -1));
  EXPECT_EQ(s.document.rig().groups[0].handles, std::vector<HandleId>{last});
}

TEST(RigCommands, EncloseEveryOrganWithAGroupOfEightHandles) {
  Session s;
  s.undo.perform(addOrgans({ball("Far", 30, 2, Vec3(500, 0, 0))}));
  s.undo.perform(addEnclosingHandles());
  const Rig& rig = s.document.rig();
  ASSERT_EQ(rig.handles.size(), 18u);
  EXPECT_EQ(rig.groups.back().name, "Enclosing");
  EXPECT_EQ(rig.groups.back().handles.size(), 8u);
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i)
    corners.row(i) = rig.handles[static_cast<std::size_t>(10 + i)].rest.transpose();
  const Bounds box = boundsOf(corners);
  EXPECT_GT(box.high.x(), 530);
  EXPECT_LT(box.low.x(), -60);
}

TEST(RigCommands, ReplaceTheRigWithItsGroupsAtRest) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 45)));
  Rig rig = tests::cubeRig(80);
  rig.addGroup("Left", {0, 1, 0}, {2, 0, 2});
  rig.addGroup("Left", {0, 0, 1}, {2, 3});
  s.undo.perform(replaceRig(rig, "Place automatically"));
  EXPECT_EQ(s.undo.undoName().english(), "Place automatically");
  EXPECT_TRUE(atRest(s.document.state()));
  const Rig& now = s.document.rig();
  ASSERT_EQ(now.groups.size(), 2u);
  EXPECT_EQ(now.groups[0].handles, (std::vector<HandleId>{now.handles[0].id, now.handles[2].id}));
  EXPECT_EQ(now.groups[1].name, "Left 2");
  EXPECT_EQ(now.groupOf(now.handles[2].id), &now.groups[0]) << "a handle may be in several groups";
}

TEST(RigCommands, CompleteARigThatIsInNoDocument) {
  Rig rig = tests::cubeRig();
  rig.handles[3].label = "Apex";
  rig.addGroup("Left", {0, 1, 0}, {3, 2});
  const Rig whole = completed(rig);
  ASSERT_EQ(whole.handles.size(), 10u);
  EXPECT_EQ(whole.handles[0].label, "H-1");
  EXPECT_EQ(whole.handles[3].label, "Apex");
  EXPECT_EQ(whole.groups[0].handles, (std::vector<HandleId>{whole.handles[2].id, whole.handles[3].id}))
      << "in the order of the rig";
  EXPECT_EQ(handleSet(rig).groups[0].handles, (std::vector<int>{3, 2})) << "as they were given";
  EXPECT_THROW(rig.addGroup("Right", {0, 0, 1}, {10}), UsageError);
  EXPECT_EQ(rig.groups.size(), 1u);
  rig.groups[0].handles.push_back(HandleId{99});
  EXPECT_THROW(completed(rig), UsageError);
}

TEST(RigCommands, RefuseLabelsThatAreEmptyOrTaken) {
  Session s;
  HandleEdit rename;
  rename.label = "H-1";
  EXPECT_THAT(refusal<DataError>(s, editHandles({s.handle(5)}, rename)), HasSubstr("H-1"));
  rename.label = "";
  refusal<DataError>(s, editHandles({s.handle(5)}, rename));
  rename.label = "Apex";
  refusal<DataError>(s, editHandles({s.handle(5), s.handle(6)}, rename));
}

TEST(GroupCommands, KeepMembersInTheOrderOfTheRig) {
  Session s;
  s.undo.perform(addGroup("A", {1, 0, 0}, {s.handle(5), s.handle(1)}));
  const GroupId group = s.document.rig().groups[0].id;
  s.undo.perform(addToGroup(group, {s.handle(3), s.handle(5)}));
  EXPECT_EQ(s.document.rig().groups[0].handles,
            (std::vector<HandleId>{s.handle(1), s.handle(3), s.handle(5)}));
  s.undo.perform(removeFromGroup(group, {s.handle(1)}));
  EXPECT_EQ(s.document.rig().groups[0].handles, (std::vector<HandleId>{s.handle(3), s.handle(5)}));
  GroupEdit edit;
  edit.name = "B";
  edit.handles = std::vector<HandleId>{s.handle(2)};
  s.undo.perform(editGroup(group, edit));
  EXPECT_EQ(s.document.rig().groups[0].name, "B");
  const coordinates::HandleSet set = handleSet(s.document.rig());
  ASSERT_EQ(set.groups.size(), 1u);
  EXPECT_EQ(set.groups[0].handles, std::vector<int>{2});
  s.undo.perform(removeGroup(group));
  EXPECT_TRUE(s.document.rig().groups.empty());
  EXPECT_EQ(s.document.rig().handles.size(), 10u);
}

TEST(GroupCommands, RefuseNamesThatAreTakenAndHandlesThatAreNotThere) {
  Session s;
  s.undo.perform(addGroup("A", {1, 0, 0}, {}));
  s.undo.reset(s.document.state());
  refusal<DataError>(s, addGroup("A", {1, 0, 0}, {}));
  refusal<DataError>(s, addGroup("", {1, 0, 0}, {}));
  refusal<UsageError>(s, addGroup("B", {1, 0, 0}, {HandleId{999}}));
  refusal<DataError>(s, addGroup("B", {2, 0, 0}, {}));
  refusal<UsageError>(s, removeGroup(GroupId{999}));
  refusal<UsageError>(s, addHandles({{Vec3(9, 9, 9)}}, GroupId{999}));
}

TEST(PoseCommands, ResetToRestExactly) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8), s.handle(9)}, Points::Constant(2, 3, 1.0 / 3)));
  EXPECT_FALSE(atRest(s.document.state()));
  s.undo.perform(resetPose());
  EXPECT_TRUE(atRest(s.document.state()));
}

TEST(SystemCommands, KeepTheOtherParameters) {
  Session s;
  s.undo.perform(setParameter("locality", 2));
  s.undo.perform(setParameter("softness", 20));
  EXPECT_EQ(s.document.system().parameters.all().at("locality"), 2);
  s.undo.perform(setSystem({"t-celestial", {}}));
  EXPECT_TRUE(s.document.system().parameters.all().empty());
  s.undo.undo();
  EXPECT_EQ(s.document.system().id, "s-celestial");
  EXPECT_EQ(s.document.system().parameters.all().at("softness"), 20);
}

TEST(SystemCommands, RefuseValuesThatAreNoNumbers) {
  Session s;
  refusal<DataError>(s, setParameter("locality", std::nan("")));
  coordinates::ParameterValues notNumbers;
  notNumbers.set("locality", std::nan(""));
  refusal<DataError>(s, setSystem({"s-celestial", notNumbers}));
}

} // namespace
} // namespace viscera::document
