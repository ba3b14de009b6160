#include "viscera/presentation/resection.h"

#include <gtest/gtest.h>

#include "session_fixture.h"
#include "shapes.h"
#include "viscera/document/organ_commands.h"

namespace viscera::presentation {
namespace {

/// Two boxes side by side along x, and a flat one below that the plane does not reach.
struct TwoBoxes {
  TwoBoxes() {
    undo.perform(document::addOrgans({{document::makeOrgan("Left", tests::box(20, 30, 40)), -1},
                                      {document::makeOrgan("Right", moved({100, 0, 0})), -1}}));
  }
  static geometry::TriangleMesh moved(const Vec3& by) {
    geometry::TriangleMesh mesh = tests::box(20, 30, 40);
    mesh.points.rowwise() += by.transpose();
    return mesh;
  }
  std::vector<Resected> at(const OrganCut& cut, double shiftMm = 0) {
    std::vector<Points> kept;
    for (const auto& organ : document.organs()) {
      kept.push_back(organ->mesh->points);
      kept.back().col(2).array() += shiftMm;
    }
    return resected(cut, document.state(), [&](document::OrganId id) -> const Points& {
      return kept[document.organs()[0]->id == id ? 0 : 1];
    });
  }
  document::Document document;
  document::UndoStack undo{document};
};

TEST(Resection, GivesBothSidesOfEveryOrganThatThePlaneMeets) {
  TwoBoxes boxes;
  // The middle of both is at z = 20.
  const auto found = boxes.at({true, Vec3::UnitZ(), 0});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].staysMl, 20 * 30 * 20 / 1000.0, 1e-9);
  EXPECT_NEAR(found[0].cutAwayMl, 20 * 30 * 20 / 1000.0, 1e-9);
  EXPECT_NEAR(found[0].faceCm2, 6, 1e-9);
  const auto sagittal = boxes.at({true, -Vec3::UnitX(), 0.9});
  ASSERT_EQ(sagittal.size(), 1u) << "the other one lies on one side";
  EXPECT_EQ(sagittal[0].organ, boxes.document.organs()[0]->id);
  EXPECT_NEAR(sagittal[0].staysMl + sagittal[0].cutAwayMl, 24, 1e-9);
}

TEST(Resection, FollowsAnOrganThatMovesWhileThePlaneStands) {
  TwoBoxes boxes;
  const auto found = boxes.at({true, Vec3::UnitZ(), 0}, 5);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[1].staysMl, 20 * 30 * 25 / 1000.0, 1e-9);
  EXPECT_NEAR(found[1].cutAwayMl, 20 * 30 * 15 / 1000.0, 1e-9);
}

TEST(Resection, LeavesOutHiddenAndOpenOrgans) {
  TwoBoxes boxes;
  document::OrganLook hidden;
  hidden.visible = false;
  boxes.undo.perform(document::setOrganLook(boxes.document.organs()[1]->id, hidden));
  EXPECT_EQ(boxes.at({true, Vec3::UnitZ(), 0}).size(), 1u);
}

} // namespace
} // namespace viscera::presentation
