#include "window_test.h"

#include <QSlider>
#include <QTest>

#include "viscera/geometry/convex_hull.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/widgets/value_slider.h"

namespace viscera::tests {
namespace {

class HandlesMode : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_2);
    ASSERT_EQ(window().mode(), app::Mode::handles);
  }
};

TEST_F(HandlesMode, AClickOnTheOrganAddsAHandleALittleOffItsSurfaceAndBindsAnew) {
  const std::size_t before = document().rig().handles.size();
  // Somewhere on the ball where no handle is.
  QPoint place(view().width() / 2, view().height() / 2);
  while (view().view().handles()->Pick(place.x(), view().height() - 1 - place.y()) >= 0)
    place += QPoint(7, 5);
  click(place);
  ASSERT_EQ(document().rig().handles.size(), before + 1);
  const double distance = document().rig().handles.back().rest.norm() - 60;
  EXPECT_GT(distance, 1);
  EXPECT_LT(distance, 15);
  const auto organ = document().organs().front()->id;
  ASSERT_NE(window().workspace().live().deformer(organ), nullptr);
  EXPECT_EQ(window().workspace().live().deformer(organ)->binding().handleCount(), Eigen::Index(before + 1));
  EXPECT_EQ(view().view().handles()->GetNumberOfHandles(), int(before + 1));
}

TEST_F(HandlesMode, AClickBesideTheOrganAddsNothing) {
  const std::size_t before = document().rig().handles.size();
  click(QPoint(view().width() - 6, view().height() / 2));
  EXPECT_EQ(document().rig().handles.size(), before);
}

TEST_F(HandlesMode, DraggingAHandleMovesItAtRestAndLeavesTheOrganAsItIs) {
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const Points organBefore = window().workspace().live().points(document().organs().front()->id);
  const Vec3 before = document().rig().handles[handle].rest;
  const QPoint from = onScreen(handleInView(handle));
  drag(from, from + QPoint(12, 8));
  EXPECT_GT((document().rig().handles[handle].rest - before).norm(), 1);
  const Points organAfter = window().workspace().live().points(document().organs().front()->id);
  EXPECT_LT((organAfter - organBefore).rowwise().norm().maxCoeff(), 1e-6);
  EXPECT_EQ(window().workspace().undo().names().size(), 2u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().rig().handles[handle].rest, before);
}

TEST_F(HandlesMode, DeleteRemovesTheSelectedHandleAndBindsAnew) {
  const std::size_t before = document().rig().handles.size();
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const session::HandleId id = document().rig().handles[handle].id;
  click(onScreen(handleInView(handle)));
  ASSERT_EQ(window().workspace().selection().currentHandle(), id);
  key(Qt::Key_Delete);
  EXPECT_EQ(document().rig().handles.size(), before - 1);
  EXPECT_EQ(document().rig().indexOf(id), -1);
  const auto organ = document().organs().front()->id;
  ASSERT_NE(window().workspace().live().deformer(organ), nullptr);
  EXPECT_EQ(window().workspace().live().deformer(organ)->binding().handleCount(), Eigen::Index(before - 1));
}

TEST_F(HandlesMode, TheCountSliderPlacesHandlesLiveAsOneUndoStep) {
  auto* count = window().findChild<app::ValueSlider*>(QStringLiteral("handleCount"));
  ASSERT_NE(count, nullptr);
  auto* slider = count->findChild<QSlider*>();
  const Points before = document().rig().restPositions();
  slider->setSliderDown(true);
  slider->setValue(slider->value() + 10);
  EXPECT_EQ(document().rig().handles.size(), 40u);
  slider->setValue(slider->value() + 10);
  EXPECT_EQ(document().rig().handles.size(), 50u);
  slider->setSliderDown(false);
  settle();
  EXPECT_EQ(window().workspace().undo().names().size(), 2u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().rig().restPositions(), before);
}

TEST_F(HandlesMode, TheInfluenceMapColoursTheOrganByTheSelectedHandle) {
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  click(onScreen(handleInView(handle)));
  key(Qt::Key_I);
  EXPECT_TRUE(view().view().organs().front()->scalarsShown());
  EXPECT_TRUE(view().view().legend().visible());
  key(Qt::Key_I);
  EXPECT_FALSE(view().view().organs().front()->scalarsShown());
  EXPECT_FALSE(view().view().legend().visible());
}

TEST_F(HandlesMode, RemovingTooManyHandlesSaysWhatIsWrongAndUndoMends) {
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_Delete);
  EXPECT_TRUE(document().rig().handles.empty());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window().workspace().live().status(document().organs().front()->id).state,
            session::BindingStatus::State::bound);
}

} // namespace
} // namespace viscera::tests
