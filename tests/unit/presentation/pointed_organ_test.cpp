#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::presentation {
namespace {

/// A ball with handles around it, a second one beside it that only some of them are near to, and a third one
/// that is a cavity of the first.
struct PointedOrgan : testing::Test {
  PointedOrgan() {
    undo.perform(document::addOrgans({tests::ball("Beside", 22, 2, Vec3(0, 0, 70))}));
    document::NewOrgan cavity = tests::ball("Hollow", 5, 2);
    cavity.organ.parent = session.organ(0);
    undo.perform(document::addOrgans({cavity}));
    view.shown.handles = true;
  }

  /// The rows in the background while the mouse is on this organ.
  std::vector<int> background(document::OrganId organ) {
    Scene scene{session.document.state(), session.live, view, session.registry};
    scene.pointedOrgan = organ;
    presenter.update(scene);
    std::vector<int> rows;
    for (int row = 0; row < drawnIn.handles()->GetNumberOfHandles(); ++row)
      if (drawnIn.handles()->GetHandleInBackground(row))
        rows.push_back(row);
    return rows;
  }

  /// The rows nearer to the organ than to the other one, by every vertex of both.
  std::vector<int> nearerTo(std::size_t organ, std::size_t other) {
    const document::DocumentState& state = session.document.state();
    const Points places = state.rig->restPositions();
    const auto distance = [&](Eigen::Index row, std::size_t to) {
      return ((*state.organs)[to]->mesh->points.rowwise() - places.row(row)).rowwise().norm().minCoeff();
    };
    std::vector<int> rows;
    for (Eigen::Index row = 0; row < places.rows(); ++row)
      if (distance(row, organ) < distance(row, other))
        rows.push_back(static_cast<int>(row));
    return rows;
  }

  tests::BoundSession session;
  document::UndoStack& undo = session.undo;
  ViewState view;
  scene::OrganView drawnIn;
  Presenter presenter{drawnIn};
};

TEST_F(PointedOrgan, BringsItsHandlesOutAmongTheOthers) {
  const std::vector<int> ofFirst = nearerTo(0, 1), ofSecond = nearerTo(1, 0);
  ASSERT_FALSE(ofFirst.empty());
  ASSERT_FALSE(ofSecond.empty());
  EXPECT_EQ(background(session.organ(0)), ofSecond);
  EXPECT_EQ(background(session.organ(1)), ofFirst);
  EXPECT_TRUE(background({}).empty());
}

TEST_F(PointedOrgan, HasTheHandlesOfItsCavity) {
  EXPECT_EQ(background(session.organ(2)), nearerTo(1, 0));
}

TEST_F(PointedOrgan, ThatHasLeftTheDocumentChangesNothing) {
  EXPECT_TRUE(background({4711}).empty());
}

} // namespace
} // namespace viscera::presentation
