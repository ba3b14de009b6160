#include "window_test.h"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <vtkActor2D.h>
#include <vtkActor2DCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include "session_fixture.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/guide/help_cards.h"
#include "window/style/theme.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

class ViewTest : public WindowTest {
protected:
  std::optional<QSize> viewSize() const override { return std::nullopt; }
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
  }
  Vec3 sight() {
    double direction[3];
    view().view().renderer()->GetActiveCamera()->GetDirectionOfProjection(direction);
    return {direction[0], direction[1], direction[2]};
  }
  QByteArray pixels() {
    const auto picture = scene::grabPicture(view().renderWindow());
    return {static_cast<const char*>(picture->GetScalarPointer()),
            static_cast<int>(picture->GetNumberOfPoints() * picture->GetNumberOfScalarComponents())};
  }
  QTreeWidget& list() { return *window().findChild<QTreeWidget*>(QStringLiteral("organList")); }
};

/// What each frame of the view was drawn with, from now on.
class Frames {
public:
  struct Frame {
    int samples = 0;
    bool allTriangles = false;
    bool smoothAsPeeled = false; ///< The edges of organs that are peeled are smoothed afterwards.
  };

  explicit Frames(app::ViewWidget& view) : view_(view) {
    command_->SetClientData(this);
    command_->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Frames*>(self)->add(); });
    tag_ = view.renderWindow()->AddObserver(vtkCommand::EndEvent, command_);
  }
  ~Frames() { view_.renderWindow()->RemoveObserver(tag_); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  std::vector<Frame> drawn;

private:
  void add() {
    const auto& organ = *view_.view().organs().front();
    drawn.push_back({view_.renderWindow()->GetMultiSamples(),
                     organ.polyData()->GetNumberOfPolys() == organ.mesh().triangles.rows(),
                     view_.view().renderer()->GetUseFXAA()});
  }

  app::ViewWidget& view_;
  vtkNew<vtkCallbackCommand> command_;
  unsigned long tag_ = 0;
};

TEST_F(ViewTest, WhatHappensToALargeOrganIsDrawnQuicklyFirstAndSmoothWhenNothingElseDoes) {
  if (!scene::rendersInSoftware(view().renderWindow()))
    GTEST_SKIP() << "a graphics processor draws here";
  window().workspace().perform(document::removeAllOrgans());
  window().workspace().perform(document::addOrgans({ball("Large", 60, 7)}));
  settle();
  const std::vector<std::pair<const char*, std::function<void()>>> events = {
      {"a mode", [this] { QTest::keyClick(&window(), Qt::Key_3); }},
      {"a click", [this] { QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(5, 5)); }},
      {"a size", [this] { window().resize(1200, 780); }},
  };
  for (const auto& [name, event] : events) {
    Frames frames(view());
    event();
    ASSERT_TRUE(waitUntil([&] { return !frames.drawn.empty(); })) << name;
    EXPECT_FALSE(view().atRest()) << name;
    EXPECT_EQ(frames.drawn.front().samples, 0) << name;
    EXPECT_FALSE(frames.drawn.front().allTriangles) << name;
    ASSERT_TRUE(waitUntil([this] { return view().atRest(); })) << name;
    EXPECT_GT(frames.drawn.back().samples, 1) << name;
    EXPECT_TRUE(frames.drawn.back().allTriangles) << name;
  }
}

TEST_F(ViewTest, AChangeOfATranslucentOrganIsDrawnQuicklyFirstAndPeeledWhenNothingElseHappens) {
  if (!scene::rendersInSoftware(view().renderWindow()))
    GTEST_SKIP() << "a graphics processor draws here";
  document::OrganLook look = document().organs().front()->look;
  look.opacity = 0.5;
  window().workspace().perform(document::setOrganLook(document().organs().front()->id, look));
  settle();
  Frames frames(view());
  QTest::keyClick(&window(), Qt::Key_3);
  ASSERT_TRUE(waitUntil([&] { return !frames.drawn.empty(); }));
  EXPECT_FALSE(frames.drawn.front().smoothAsPeeled);
  EXPECT_TRUE(frames.drawn.front().allTriangles) << "it has few";
  ASSERT_TRUE(waitUntil([this] { return view().atRest(); }));
  EXPECT_TRUE(frames.drawn.back().smoothAsPeeled);
}

TEST_F(ViewTest, ASmallOrganIsDrawnSmoothAtOnceAndOnceForAClick) {
  Frames frames(view());
  QTest::mouseClick(&view(), Qt::LeftButton, {}, view().rect().center());
  ASSERT_TRUE(waitUntil([&] { return !frames.drawn.empty() && view().atRest(); }));
  EXPECT_EQ(frames.drawn.size(), 1u) << "neither the press nor the release draws one of its own";
  EXPECT_GT(frames.drawn.back().samples, 1);
}

/// Each of the two is one of the handle's.
TEST_F(ViewTest, ADoubleClickOnAHandleHidesNoOrgan) {
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({ball("other", 10, 2, Vec3(0, 0, 40))})));
  settle();
  key(Qt::Key_3);
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const QPoint place = onScreen(handleInView(handle));
  clickTwice(place, place);
  for (const auto& organ : document().organs())
    EXPECT_TRUE(organ->look.visible) << organ->name;
  EXPECT_EQ(window().workspace().selection().handles().size(), 1u);
  EXPECT_FALSE(view().view().handleWidget()->IsDragging());
}

TEST_F(ViewTest, KeypadDigitsLookAlongTheBodysAxes) {
  key(Qt::Key_1, Qt::KeypadModifier);
  EXPECT_LT((sight() - Vec3(0, 1, 0)).norm(), 1e-6) << "from the front one looks to the back";
  key(Qt::Key_1, Qt::KeypadModifier | Qt::ShiftModifier);
  EXPECT_LT((sight() - Vec3(0, -1, 0)).norm(), 1e-6);
  key(Qt::Key_3, Qt::KeypadModifier);
  EXPECT_LT((sight() - Vec3(-1, 0, 0)).norm(), 1e-6) << "from the left one looks to the right";
  key(Qt::Key_7, Qt::KeypadModifier);
  EXPECT_LT((sight() - Vec3(0, 0, -1)).norm(), 1e-6);
  EXPECT_EQ(window().mode(), "explore") << "the keypad does not choose modes";
}

TEST_F(ViewTest, AClickOnASideOfTheOrientationCubeLooksFromThereAndDoesNothingElse) {
  key(Qt::Key_2); // Handles: a click on the organ would add one.
  key(Qt::Key_1, Qt::KeypadModifier);
  settle();
  const auto handles = window().workspace().state().rig->handles.size();
  const auto whole = view().view().renderer()->GetActiveCamera()->GetDistance();
  const QPoint middle(52, view().height() - 52), left = middle + QPoint(38, 0);
  const QByteArray before = pixels();
  QTest::mouseMove(&view(), left);
  EXPECT_TRUE(waitUntil([this] { return view().cursor().shape() == Qt::PointingHandCursor; }));
  settle();
  EXPECT_NE(pixels(), before) << "the letter under the mouse is highlighted";
  QTest::mouseClick(&view(), Qt::LeftButton, {}, left);
  settle();
  EXPECT_LT((sight() - Vec3(-1, 0, 0)).norm(), 1e-6) << "from the left one looks to the right";
  EXPECT_NEAR(view().view().renderer()->GetActiveCamera()->GetDistance(), whole, 1e-6 * whole);
  QTest::mousePress(&view(), Qt::LeftButton, {}, left);
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, view().rect().center());
  settle();
  EXPECT_LT((sight() - Vec3(-1, 0, 0)).norm(), 1e-6) << "it was released elsewhere";
  EXPECT_EQ(window().workspace().state().rig->handles.size(), handles);
  QTest::mouseMove(&view(), view().rect().center());
  EXPECT_TRUE(waitUntil([this] { return view().cursor().shape() != Qt::PointingHandCursor; }));
}

TEST_F(ViewTest, AnEmptyViewHasNoOrientationCubeAndNoScaleBar) {
  const auto lengthShown = [this] {
    vtkActor2DCollection* actors = view().view().renderer()->GetActors2D();
    vtkCollectionSimpleIterator each;
    actors->InitTraversal(each);
    while (vtkActor2D* actor = actors->GetNextActor2D(each))
      if (auto* label = vtkTextActor::SafeDownCast(actor);
          label && label->GetVisibility() && label->GetInput() && QString(label->GetInput()).endsWith(" mm"))
        return true;
    return false;
  };
  EXPECT_TRUE(view().view().orientationSideAt(52, 52));
  EXPECT_TRUE(lengthShown());
  window().actions()["organ.remove"]->trigger();
  settle();
  EXPECT_FALSE(view().view().orientationSideAt(52, 52));
  EXPECT_FALSE(lengthShown());
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_TRUE(lengthShown());
}

TEST_F(ViewTest, TheOpenedOrganFillsTheView) {
  const QPoint left = onScreen(Vec3(-60, 0, 0));
  const QPoint right = onScreen(Vec3(60, 0, 0));
  const QPoint top = onScreen(Vec3(0, 0, 60));
  const QPoint bottom = onScreen(Vec3(0, 0, -60));
  EXPECT_TRUE(view().rect().contains(left) && view().rect().contains(right));
  EXPECT_TRUE(view().rect().contains(top) && view().rect().contains(bottom));
  EXPECT_GT(bottom.y() - top.y(), view().height() / 2);
}

TEST_F(ViewTest, AClickSelectsTheOrganAndOneBesideItNothing) {
  window().workspace().selection().clear();
  click(view().rect().center());
  EXPECT_EQ(window().workspace().selection().organ(), document().organs().front()->id);
  click(QPoint(5, view().height() / 2));
  EXPECT_FALSE(window().workspace().selection().organ());
}

TEST_F(ViewTest, AmongSeveralOrgansTheSelectedOneIsOutlinedAndNotBrightened) {
  const document::OrganId first = document().organs().front()->id;
  const auto& picture = window().picture();
  window().workspace().selection().setOrgan(first);
  EXPECT_TRUE(picture.actorOf(first)->selected()) << "alone it is a little lighter";
  open(sphereFile(QStringLiteral("second.stl"), 30));
  window().workspace().selection().setOrgan({});
  settle();
  const auto none = grab(window());
  window().workspace().selection().setOrgan(first);
  settle();
  EXPECT_FALSE(picture.actorOf(first)->selected());
  const double outline = scene::comparePictures(none, grab(window())).differing;
  EXPECT_GT(outline, 0.0005);
  EXPECT_LT(outline, 0.03) << "a thin line";
}

TEST_F(ViewTest, ADragRotatesTheCamera) {
  const Vec3 before = sight();
  drag(view().rect().center(), view().rect().center() + QPoint(120, 0));
  EXPECT_GT((sight() - before).norm(), 0.1);
  EXPECT_FALSE(document().organs().empty());
}

TEST_F(ViewTest, TheEyeHidesTheOrganAndUndoShowsItAgain) {
  const auto index = list().model()->index(0, 0);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, Qt::NoModifier, list().visualRect(index).center());
  settle();
  EXPECT_FALSE(document().organs().front()->look.visible);
  EXPECT_FALSE(view().view().organs().front()->visible());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(view().view().organs().front()->visible());
}

TEST_F(ViewTest, AnOrganIsRenamedInTheListAndAnEmptyNameIsRefused) {
  list().topLevelItem(0)->setText(1, QStringLiteral("Left kidney"));
  settle();
  EXPECT_EQ(document().organs().front()->name, "Left kidney");
  list().topLevelItem(0)->setText(1, QString());
  settle();
  EXPECT_EQ(document().organs().front()->name, "Left kidney");
  EXPECT_EQ(list().topLevelItem(0)->text(1), QStringLiteral("Left kidney"));
  EXPECT_NE(message(), QString());
}

TEST_F(ViewTest, ANarrowListLeavesTheVolumeOutAndKeepsTheName) {
  constexpr int kNames = 1, kVolumes = 2, kSquare = 24, kNarrow = 150, kLetters = 4;
  ASSERT_TRUE(window().workspace().perform(
      document::renameOrgan(document().organs().front()->id, "inferior mesenteric artery")));
  settle();
  EXPECT_FALSE(list().isColumnHidden(kVolumes));
  list().setMaximumWidth(kNarrow);
  settle();
  EXPECT_TRUE(list().isColumnHidden(kVolumes));
  EXPECT_GE(list().columnWidth(kNames), kSquare + kLetters * list().fontMetrics().averageCharWidth());
  list().setMaximumWidth(QWIDGETSIZE_MAX);
  settle();
  EXPECT_FALSE(list().isColumnHidden(kVolumes));
}

TEST_F(ViewTest, TheCutOpensTheOrganAndItsFaceFollowsThePose) {
  key(Qt::Key_1, Qt::KeypadModifier);
  const auto nearestAt = [this](const QPoint& place) {
    const auto pick = view().pickNear(place);
    return pick ? pick->position.y() : 1e9;
  };
  const QPoint middle = onScreen(Vec3::Zero());
  EXPECT_NEAR(nearestAt(middle), -60, 1) << "from the front one meets the front";
  const auto whole = grab(window());
  window().actions()["view.cut"]->trigger();
  settle();
  EXPECT_NEAR(nearestAt(middle), 60, 1) << "the front half is gone";
  const auto cut = grab(window());
  EXPECT_GT(scene::comparePictures(whole, cut).differing, 0.02);
  // The face hides the hollow behind it, where a plane through nothing shows nothing.
  window().viewModel().change([](presentation::ViewState& state) { state.cut.offset = 0.9; });
  settle();
  EXPECT_GT(scene::comparePictures(cut, grab(window())).differing, 0.02);
  window().viewModel().change([](presentation::ViewState& state) { state.cut.offset = 0; });
  ASSERT_TRUE(window().workspace().perform(document::setPose(0.7 * document().rig().restPositions())));
  settle();
  EXPECT_GT(scene::comparePictures(cut, grab(window())).differing, 0.02) << "a smaller ball, a smaller face";
  EXPECT_EQ(presentation::viewFromJson(presentation::toJson(window().viewModel().state())).cut,
            window().viewModel().state().cut);
}

TEST_F(ViewTest, FocusBringsTheOrganBackIntoThePicture) {
  view().view().renderer()->GetActiveCamera()->SetFocalPoint(900, 0, 0);
  view().view().renderer()->GetActiveCamera()->SetPosition(900, -400, 0);
  ASSERT_FALSE(view().rect().contains(onScreen(Vec3::Zero())));
  key(Qt::Key_F);
  EXPECT_TRUE(view().rect().contains(onScreen(Vec3::Zero())));
}

TEST_F(ViewTest, TheGhostIsALineWhereTheOrganWasAtRest) {
  const Points smaller = 0.6 * document().rig().restPositions();
  key(Qt::Key_1, Qt::KeypadModifier);
  ASSERT_TRUE(window().workspace().perform(document::setPose(smaller)));
  // The contrast across the outline of the ball of 60 mm, which is no more there.
  const auto contrast = [this] {
    const auto picture = grab(window());
    const double ratio = view().devicePixelRatioF();
    const QPoint edge = onScreen(Vec3(60, 0, 0));
    const int height = picture->GetDimensions()[1];
    int darkest = 255, brightest = 0;
    for (int x = edge.x() - 3; x <= edge.x() + 20; ++x) {
      const auto* pixel = static_cast<const unsigned char*>(
          picture->GetScalarPointer(qRound(ratio * x), height - 1 - qRound(ratio * edge.y()), 0));
      darkest = std::min(darkest, int(pixel[1]));
      brightest = std::max(brightest, int(pixel[1]));
    }
    return brightest - darkest;
  };
  EXPECT_LT(contrast(), 5);
  key(Qt::Key_G);
  EXPECT_GT(contrast(), 30);
  key(Qt::Key_G);
  EXPECT_LT(contrast(), 5);
}

TEST_F(ViewTest, KeysShowTheEdgesOfTrianglesAndEachOfThemFlat) {
  const auto picture = [this] { return grab(window()); };
  const auto smooth = picture();
  key(Qt::Key_W);
  EXPECT_TRUE(window().actions()["view.edges"]->isChecked());
  const auto edges = picture();
  EXPECT_GT(scene::comparePictures(smooth, edges, 30).differing, 0.02);
  key(Qt::Key_W, Qt::ShiftModifier);
  EXPECT_TRUE(window().actions()["view.flat"]->isChecked());
  EXPECT_GT(scene::comparePictures(edges, picture(), 2).differing, 0.005);
  key(Qt::Key_W);
  key(Qt::Key_W, Qt::ShiftModifier);
  EXPECT_EQ(scene::comparePictures(smooth, picture(), 0).differing, 0) << "and back";
  const auto& card = *window().findChild<app::ShortcutCard*>();
  const auto labels = card.findChildren<QLabel*>();
  for (const char* keys : {"W", "Shift+W"})
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->text() == QLatin1String(keys);
    })) << keys;
}

} // namespace
} // namespace viscera::tests
