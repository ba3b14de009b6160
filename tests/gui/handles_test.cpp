#include "window_test.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <algorithm>

#include "shapes.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/scene/region_hulls.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/handles/position_box.h"
#include "window/widgets/value_slider.h"

namespace viscera::tests {
namespace {

/// "R 110.08 mm", not "Left -110.08 mm".
TEST_F(WindowTest, APositionSaysItsSideAndTakesOneThatIsTyped) {
  open(sphereFile());
  key(Qt::Key_3);
  const document::HandleId id = document().rig().handles[3].id;
  window().workspace().selection().setHandles({id});
  const int row = document().rig().indexOf(id);
  Points pose = document().pose();
  pose.row(row) << -110.08, 12.5, -7;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  settle();
  QList<QDoubleSpinBox*> fields;
  for (auto* box : window().findChildren<app::PositionBox*>())
    if (box->isVisible())
      fields = box->findChildren<QDoubleSpinBox*>();
  ASSERT_EQ(fields.size(), 3);
  QStringList headings; // Above each three numbers.
  for (const QLabel* label : window().findChildren<QLabel*>())
    if (label->isVisible())
      headings << label->text();
  EXPECT_TRUE(headings.contains(QStringLiteral("Place in the patient")));
  EXPECT_TRUE(headings.contains(QStringLiteral("Move by")));
  EXPECT_EQ(fields[0]->text(), QStringLiteral("R 110.08 mm"));
  EXPECT_EQ(fields[1]->text(), QStringLiteral("P 12.50 mm"));
  EXPECT_EQ(fields[2]->text(), QStringLiteral("I 7.00 mm"));
  const auto type = [&](const char* typed) {
    fields[0]->setFocus();
    fields[0]->selectAll();
    QTest::keyClicks(fields[0], QLatin1String(typed));
    QTest::keyClick(fields[0], Qt::Key_Return);
    settle();
    return document().pose()(row, 0);
  };
  EXPECT_NEAR(type("L 20"), 20, 1e-9);
  EXPECT_NEAR(type("R 15.5"), -15.5, 1e-9);
  EXPECT_NEAR(type("-3"), -3, 1e-9) << "a sign, as before";
}

class HandlesMode : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_2);
    ASSERT_EQ(window().mode(), "handles");
  }
};

TEST_F(HandlesMode, AClickOnTheOrganAddsAHandleALittleOffItsSurfaceAndBindsAnew) {
  const std::size_t before = document().rig().handles.size();
  // Somewhere on the ball where no handle is.
  QPoint place(view().width() / 2, view().height() / 2);
  while (view().view().handles()->PickHandle(place.x(), view().height() - 1 - place.y()) >= 0)
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
  const document::HandleId id = document().rig().handles[handle].id;
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
            live::BindingStatus::State::bound);
}

TEST_F(HandlesMode, SaysHowManyHandlesItRemovedAndOffersToUndoThatStepAlone) {
  const std::size_t handles = document().rig().handles.size();
  const auto offer = [this] {
    return window().viewArea().messages()->findChild<QPushButton*>(QStringLiteral("offer"));
  };
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_Delete);
  EXPECT_EQ(message(), QStringLiteral("%1 handles removed").arg(handles));
  ASSERT_NE(offer(), nullptr);
  offer()->click();
  settle();
  EXPECT_EQ(document().rig().handles.size(), handles);
  EXPECT_EQ(message(), QString());
  window().workspace().selection().setHandles({document().rig().handles.front().id});
  key(Qt::Key_Delete);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(message().contains(QStringLiteral("removed"))) << "it is there again";
}

TEST_F(HandlesMode, HasNoControlForAParameterThatChangesNothing) {
  ASSERT_EQ(document().system().id, "s-celestial");
  const auto parameters = window().workspace().registry().find("s-celestial")->parameters();
  const auto lambda = std::find_if(parameters.begin(), parameters.end(),
                                   [](const auto& parameter) { return parameter.name == "lambda"; });
  ASSERT_NE(lambda, parameters.end()) << "the command line takes it";
  EXPECT_TRUE(lambda->withoutEffect);
  EXPECT_EQ(window().findChild<QWidget*>(QStringLiteral("parameter/lambda")), nullptr);
}

/// Handles mode with a ball of 60 mm, mean value coordinates, and a cage of one's own.
class Cage : public HandlesMode {
protected:
  void SetUp() override {
    HandlesMode::SetUp();
    choose("mean-value");
  }
  void choose(const char* system) {
    ASSERT_TRUE(window().workspace().perform(document::setSystem({system, {}})));
    settle();
  }
  /// A box around the middle; `triangles` below 12 leave it open.
  void load(double half, Eigen::Index triangles = 12) {
    auto cage = box(2 * half, 2 * half, 2 * half);
    cage.points.array() -= half;
    cage.triangles.conservativeResize(triangles, 3);
    medical_io::writeSurface(path("cage.off").toStdString(), cage);
    window().files().loadCage(path("cage.off"));
    ASSERT_TRUE(waitUntil([this] { return window().workspace().jobs().idle(); }));
    settle();
  }
  const document::Rig& rig() { return document().rig(); }
  const std::vector<scene::RegionHull>& hulls() { return view().view().regions().hulls(); }
  bool says(const QString& sentence) {
    for (const QLabel* label : window().findChildren<QLabel*>())
      if (label->isVisible() && label->text() == sentence)
        return true;
    return false;
  }
  QPushButton* button(const QString& label) {
    for (QPushButton* button : window().findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == label)
        return button;
    return nullptr;
  }
};

TEST_F(Cage, IsLoadedAndShownAndTakenBack) {
  EXPECT_TRUE(says(QStringLiteral("The cage is the convex hull of the handles.")));
  ASSERT_EQ(hulls().size(), 1u) << "the hull";
  const Eigen::Index hullTriangles = hulls().front().triangles.rows();
  const document::Rig before = rig();
  load(100);
  EXPECT_EQ(rig().handles.size(), 8u);
  EXPECT_EQ(rig().cage.size(), 12u);
  EXPECT_TRUE(message().contains(QStringLiteral("8 vertices of cage.off are now the handles")))
      << message().toStdString();
  EXPECT_TRUE(says(QStringLiteral("The cage has 12 triangles over 8 handles.")));
  ASSERT_EQ(hulls().size(), 1u);
  EXPECT_EQ(hulls().front().triangles.rows(), 12);
  EXPECT_EQ(window().workspace().live().status(document().organs().front()->id).state,
            live::BindingStatus::State::bound);
  load(100);
  EXPECT_TRUE(message().contains(QStringLiteral("corners of the cage"))) << message().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  EXPECT_EQ(rig(), before);
  EXPECT_TRUE(says(QStringLiteral("The cage is the convex hull of the handles.")));
  EXPECT_EQ(hulls().front().triangles.rows(), hullTriangles);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_EQ(rig().cage.size(), 12u);
  key(Qt::Key_R);
  EXPECT_TRUE(hulls().empty());
}

TEST_F(Cage, ThatIsOpenIsRefusedAndNothingChanges) {
  const document::DocumentState before = document().state();
  load(100, 11);
  EXPECT_TRUE(message().contains(QStringLiteral("open at 3 edges"))) << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("cage.off"))) << message().toStdString();
  EXPECT_EQ(document().state(), before);
}

TEST_F(Cage, GivesWayToTheHullByTheButton) {
  QPushButton* hull = button(QStringLiteral("Use the hull as the cage"));
  ASSERT_NE(hull, nullptr);
  EXPECT_FALSE(hull->isEnabled()) << "it is the hull already";
  load(100);
  ASSERT_TRUE(hull->isEnabled());
  hull->click();
  EXPECT_TRUE(rig().cage.empty());
  EXPECT_EQ(rig().handles.size(), 8u);
}

TEST_F(Cage, ThatCannotHoldTheOrganIsSaidWithTheHullAsAnOffer) {
  choose("green");
  load(50);
  EXPECT_TRUE(message().contains(QStringLiteral("have no coordinates in the cage")))
      << message().toStdString();
  QPushButton* offer = nullptr;
  for (auto* button : window().viewArea().messages()->findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == QLatin1String("Use the hull as the cage"))
      offer = button;
  ASSERT_NE(offer, nullptr);
  offer->click();
  settle();
  EXPECT_TRUE(rig().cage.empty());
}

TEST_F(Cage, IsOfferedOnlyForCoordinatesThatNeedOne) {
  EXPECT_TRUE(window().actions()["cage.load"]->isEnabled());
  EXPECT_NE(button(QStringLiteral("Load a cage")), nullptr);
  choose("s-celestial");
  const QAction& load = *window().actions()["cage.load"];
  EXPECT_FALSE(load.isEnabled());
  EXPECT_TRUE(load.toolTip().startsWith(QStringLiteral("For coordinates that need a cage"))) << "why not";
  int menus = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>())
    if (menu->actions().contains(window().actions()["cage.load"])) {
      EXPECT_TRUE(menu->toolTipsVisible()) << menu->title().toStdString();
      ++menus;
    }
  EXPECT_GT(menus, 0);
  EXPECT_EQ(button(QStringLiteral("Load a cage")), nullptr);
  EXPECT_TRUE(hulls().empty());
}

} // namespace
} // namespace viscera::tests
