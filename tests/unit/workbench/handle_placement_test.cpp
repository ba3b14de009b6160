#include "viscera/workbench/handle_placement.h"

#include <gtest/gtest.h>

#include "session_fixture.h"

namespace viscera::workbench {

TEST(HandlePlacement, EnclosesAllOrgansAndNamesItsGroups) {
  tests::Session session;
  session.undo.perform(document::addOrgans({tests::ball("Far", 10, 2, Vec3(200, 0, 0))}));
  const document::OrganList& organs = session.document.organs();
  session.undo.perform(placeHandles({organs.front()}, organs, {}, {"Place", "Skin", "Box"}));
  const document::Rig& rig = session.document.rig();
  ASSERT_EQ(rig.groups.size(), 2u);
  EXPECT_EQ(rig.groups[0].name, "Skin");
  EXPECT_EQ(rig.groups[1].name, "Box");
  EXPECT_EQ(rig.groups[1].handles.size(), 8u);
  EXPECT_GT(boundsOf(rig.restPositions()).high.x(), 210) << "the far ball lies within";
  EXPECT_EQ(session.undo.undoName().english(), "Place");
}

TEST(HandlePlacement, LeavesCavitiesOutUnlessThereIsNothingElse) {
  auto outer = std::make_shared<document::Organ>(tests::ball("Outer").organ);
  outer->id = {1};
  auto inner = std::make_shared<document::Organ>(tests::ball("Inner", 10).organ);
  inner->id = {2};
  inner->parent = {1};
  EXPECT_EQ(wholeOrgans({outer, inner}).size(), 1u);
  EXPECT_EQ(wholeOrgans({inner}).size(), 1u);
}

} // namespace viscera::workbench
