#include "viscera/scene/organ_labels.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

class Labels : public testing::Test {
protected:
  Labels() : window(640, 480), labels(window.view) {
    wall = window.addOrgan(tests::sphere(4, 50));
    left = window.addOrgan(tests::sphere(3, 15, {18, 0, 0}));
    right = window.addOrgan(tests::sphere(3, 15, {-18, 0, 4}));
    wall->setOpacity(0.3);
    labels.setItems({{"Heart", wall, true}, {"Left ventricle", left}, {"Right ventricle", right}});
    labels.setShown(true);
    window.view.lookFrom(StandardView::anterior);
    window.view.renderer()->GetActiveCamera()->Zoom(0.6);
    window.render();
  }
  const OrganLabels::Drawn& named(const std::string& text) {
    drawn = labels.drawn();
    for (const auto& label : drawn)
      if (label.text == text)
        return label;
    ADD_FAILURE() << "no label " << text;
    static const OrganLabels::Drawn nothing;
    return nothing;
  }
  tests::ViewInWindow window;
  OrganLabels labels;
  std::shared_ptr<OrganActor> wall, left, right;
  std::vector<OrganLabels::Drawn> drawn;
};

/// A large organ of many vertices: looked at sparsely it would let what is behind it through.
TEST(LabelsOfParts, AreLeftOutBehindALargeOrganOnItsBackAndWhereItIsCutAway) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  const auto large = window.addOrgan(tests::sphere(6, 100));
  const auto small = window.addOrgan(tests::sphere(3, 5, {30, 130, 0}));
  const auto part = [](const std::string& name, const std::shared_ptr<OrganActor>& organ, const Vec3& place) {
    Eigen::Index nearest = 0;
    (organ->points().rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return OrganLabels::Item{name, organ, false, nearest};
  };
  labels.setItems({part("Front", large, {0, -100, 20}), part("Back", large, {20, 100, 0}),
                   part("Behind", small, {30, 125, 0})});
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  const auto names = [&] {
    window.render();
    std::vector<std::string> texts;
    for (const auto& label : labels.drawn())
      texts.push_back(label.text);
    return texts;
  };
  EXPECT_EQ(names(), std::vector<std::string>{"Front"});
  large->setClipPlane({0, 0, 0}, {0, 1, 0});
  EXPECT_EQ(names(), std::vector<std::string>{}) << "the front is cut away, the back is seen from inside";
  large->clearClipPlane();
  large->setOpacity(0.3);
  EXPECT_EQ(names().size(), 3U) << "one sees through it";
}

/// Its side walls hardly face away, but the cut face lies before them.
TEST(LabelsOfParts, AreLeftOutBehindTheFaceOfACut) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  auto deep = tests::sphere(6, 100);
  deep.points.col(1) *= 3;
  Eigen::Index side = 0;
  (deep.points.rowwise() - Eigen::RowVector3d(80, 180, 0)).rowwise().squaredNorm().minCoeff(&side);
  const auto organ = window.addOrgan(deep);
  organ->setOpacity(0.3);
  organ->setClipPlane({0, 0, 0}, {0, 1, 0});
  labels.setItems({{"Side", organ, false, side}});
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  window.render();
  EXPECT_TRUE(labels.drawn().empty());
  window.view.lookFrom(StandardView::left);
  window.render();
  EXPECT_EQ(labels.drawn().size(), 1U);
}

TEST_F(Labels, LinesEndOnTheOrgansAndBoxesLieBesideThem) {
  for (const auto& [text, center] :
       {std::pair{"Left ventricle", Vec3(18, 0, 0)}, std::pair{"Right ventricle", Vec3(-18, 0, 4)}}) {
    const auto& label = named(text);
    const auto at = window.display(center);
    EXPECT_NEAR(label.targetX, at[0], 10) << text;
    EXPECT_NEAR(label.targetY, at[1], 10) << text;
  }
  const auto rim = window.display({-50, 0, 0});
  for (const auto& label : labels.drawn()) {
    const double nearest = std::min(std::abs(label.box.left - 320), std::abs(label.box.right - 320));
    EXPECT_GT(nearest, 320 - rim[0]) << label.text << " covers the organ";
  }
  const auto middle = window.display(Vec3::Zero());
  const auto& heart = named("Heart");
  const double away = std::hypot(heart.targetX - middle[0], heart.targetY - middle[1]);
  EXPECT_GT(away, 0.6 * (middle[0] - rim[0])) << "the wall is named at its edge";
}

TEST_F(Labels, FollowTheCameraAndStandStillWhileTheOrganBeats) {
  const double before = named("Left ventricle").targetX;
  const ScreenBox box = named("Left ventricle").box;
  auto smaller = std::make_shared<Points>(0.97 * wall->mesh().points);
  wall->setPoints(smaller);
  window.view.setMoving(true);
  window.render();
  EXPECT_EQ(named("Left ventricle").box.left, box.left);
  EXPECT_EQ(named("Left ventricle").box.bottom, box.bottom);
  window.view.renderer()->GetActiveCamera()->Azimuth(180);
  window.render();
  EXPECT_LT(named("Left ventricle").targetX, before - 20) << "seen from behind it is on the other side";
}

/// One without room had every frame laid out anew, and the others went with the heart's size.
TEST_F(Labels, StandStillWhileTheOrganBeatsAlsoBesideOneThatFindsNoRoom) {
  labels.setItems({{"Heart", wall, true}, {"Left ventricle", left}, {std::string(120, 'W'), right}});
  window.render();
  const ScreenBox heart = named("Heart").box, ventricle = named("Left ventricle").box;
  EXPECT_EQ(labels.drawn().size(), 2U);
  window.view.setMoving(true);
  for (const double size : {0.97, 0.9, 0.85, 0.9, 1.0}) {
    wall->setPoints(std::make_shared<Points>(size * wall->mesh().points));
    window.render();
    EXPECT_EQ(named("Heart").box.left, heart.left) << size;
    EXPECT_EQ(named("Heart").box.bottom, heart.bottom) << size;
    EXPECT_EQ(named("Left ventricle").box.left, ventricle.left) << size;
  }
}

TEST_F(Labels, AreBackInTheirPlaceWhenWhatTheyNameWasHiddenForAMoment) {
  wall->setOpacity(1);
  Eigen::Index front = 0;
  wall->mesh().points.col(1).minCoeff(&front);
  labels.setItems({{"Heart", wall, true}, {"Front", wall, false, front}});
  window.render();
  const ScreenBox heart = named("Heart").box, part = named("Front").box;
  window.view.setMoving(true);
  auto turned = std::make_shared<Points>(0.9 * wall->mesh().points);
  turned->leftCols(2) *= -1; // Half a turn about the axis that is upright.
  wall->setPoints(turned);
  window.render();
  EXPECT_EQ(labels.drawn().size(), 1U) << "the part is behind the heart";
  EXPECT_EQ(named("Heart").box.left, heart.left);
  wall->setPoints(std::make_shared<Points>(wall->mesh().points));
  window.render();
  EXPECT_EQ(named("Heart").box.left, heart.left);
  EXPECT_EQ(named("Front").box.left, part.left);
  EXPECT_EQ(named("Front").box.bottom, part.bottom);
}

TEST_F(Labels, MoveAsideOnceForAMotionAndStandStillFromThenOn) {
  window.view.setMoving(true);
  const auto places = [&](double size) {
    wall->setPoints(std::make_shared<Points>(size * wall->mesh().points));
    auto moved = std::make_shared<Points>(left->mesh().points);
    moved->col(2).array() += 60 * (size - 1);
    left->setPoints(moved);
    window.render();
    std::vector<double> boxes;
    for (const auto& label : labels.drawn())
      boxes.insert(boxes.end(), {label.box.left, label.box.bottom});
    return boxes;
  };
  const std::vector<double> cycle = {1, 1.15, 1.3, 1.15};
  for (const double size : cycle)
    places(size);
  const auto after = places(1);
  EXPECT_EQ(after.size(), 6U);
  for (int round = 0; round < 2; ++round)
    for (const double size : cycle)
      EXPECT_EQ(places(size), after) << size;
}

TEST_F(Labels, LinesEndWhereTheyDidWhileTheOrganIsInFrontThere) {
  wall->setVisible(false);
  window.render();
  const OrganLabels::Drawn before = named("Left ventricle");
  window.view.setMoving(true);
  auto moved = std::make_shared<Points>(left->mesh().points);
  moved->col(2).array() += 5;
  left->setPoints(moved);
  window.render();
  EXPECT_EQ(named("Left ventricle").targetX, before.targetX);
  EXPECT_EQ(named("Left ventricle").targetY, before.targetY);
  moved = std::make_shared<Points>(left->mesh().points);
  moved->col(2).array() += 30;
  left->setPoints(moved);
  window.render();
  const auto middle = window.display({18, 0, 30});
  EXPECT_NEAR(named("Left ventricle").targetY, middle[1], 16) << "it left the place where it was";
}

TEST_F(Labels, LinesEndWhereTheOrganIsSeenThoughAnotherOneIsInFrontOfIt) {
  // The right one comes before the left one's inner half; the reader looks along +y.
  auto moved = std::make_shared<Points>(right->mesh().points);
  moved->rowwise() += Eigen::RowVector3d(26, -25, -4);
  right->setPoints(moved);
  window.render();
  const auto covering = window.display({8, -25, 0});
  const auto edge = window.display({8 + 15, -25, 0});
  EXPECT_GT(named("Left ventricle").targetX, edge[0] - 6);
  EXPECT_NEAR(named("Right ventricle").targetX, covering[0], 12);
}

TEST(LabelsOfOrgans, AreLeftOutInAndBehindAnOpaqueOneAndKeptInATranslucentOne) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  const auto muscle = window.addOrgan(tests::sphere(6, 100));
  const auto inside = window.addOrgan(tests::sphere(3, 30, {10, 0, 20}));
  const auto behind = window.addOrgan(tests::sphere(4, 40, {0, 180, 0}));
  const auto beside = window.addOrgan(tests::sphere(3, 20, {130, 60, 0}));
  labels.setItems({{"Inside", inside}, {"Behind", behind}, {"Beside", beside}, {"Muscle", muscle}});
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.6);
  const auto names = [&] {
    window.render();
    std::vector<std::string> texts;
    for (const auto& label : labels.drawn())
      texts.push_back(label.text);
    return texts;
  };
  EXPECT_EQ(names(), (std::vector<std::string>{"Beside", "Muscle"}));
  inside->setOpacity(0.5);
  EXPECT_EQ(names(), (std::vector<std::string>{"Beside", "Muscle"})) << "a translucent one is hidden, too";
  inside->setOpacity(1);
  muscle->setOpacity(0.3);
  EXPECT_EQ(names().size(), 4U) << "one sees through it";
}

Eigen::Index nearestTo(const OrganActor& organ, const Vec3& place) {
  Eigen::Index nearest = 0;
  (organ.points().rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

/// From each side, solid and as glass with a chamber in it.
TEST(LabelsOfOrgans, WithNamedPartsEndOnNoneOfThem) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  const auto wall = window.addOrgan(tests::sphere(5, 60));
  const auto chamber = window.addOrgan(tests::sphere(3, 25));
  OrganLabels::Item whole{"Whole", wall, true};
  const std::vector<Vec3> places = {{0, -60, 0}, {0, 60, 0},  {60, 0, 0},   {-60, 0, 0},
                                    {0, 0, 60},  {0, 0, -60}, {42, -42, 0}, {-42, 42, 0}};
  for (const Vec3& place : places)
    whole.places.push_back(nearestTo(*wall, place));
  labels.setItems({whole, {"Chamber", chamber}});
  labels.setShown(true);
  for (const double opacity : {1.0, 0.3}) {
    wall->setOpacity(opacity);
    for (const auto side : {StandardView::anterior, StandardView::posterior, StandardView::left,
                            StandardView::right, StandardView::superior, StandardView::inferior}) {
      window.view.lookFrom(side);
      window.view.renderer()->GetActiveCamera()->Zoom(0.6);
      window.render();
      std::size_t chambers = 0;
      for (const auto& label : labels.drawn()) {
        chambers += label.text == "Chamber" ? 1 : 0;
        if (label.text != "Whole")
          continue;
        const auto pick = window.view.pick(label.targetX, label.targetY);
        ASSERT_TRUE(pick) << "the line ends beside the organ";
        EXPECT_EQ(pick->organ, wall.get());
        for (const Eigen::Index vertex : whole.places)
          EXPECT_GT((wall->points().row(vertex).transpose() - pick->position).norm(), 8);
      }
      EXPECT_EQ(chambers, opacity < 1 ? 1U : 0U) << "a chamber has its name where it is seen";
    }
  }
}

/// An organ that shows nothing but named parts has no name of its own beside theirs.
TEST(LabelsOfOrgans, AreLeftOutWhereNothingButNamedPartsIsSeen) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  const auto ball = window.addOrgan(tests::sphere(4, 40));
  OrganLabels::Item whole{"Whole", ball};
  for (Eigen::Index vertex = 0; vertex < ball->points().rows(); ++vertex)
    if (ball->points()(vertex, 1) < 0) // In front.
      whole.places.push_back(vertex);
  labels.setItems({whole});
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.6);
  window.render();
  EXPECT_TRUE(labels.drawn().empty());
  window.view.lookFrom(StandardView::posterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.6);
  window.render();
  EXPECT_EQ(labels.drawn().size(), 1U);
}

TEST(LabelsOfOrgans, StandWhereTheyWereWhenAnOpaqueOneHasPassedInFrontOfThem) {
  tests::ViewInWindow window(640, 480);
  OrganLabels labels(window.view);
  const auto still = window.addOrgan(tests::sphere(3, 20));
  const auto passing = window.addOrgan(tests::sphere(4, 40, {-100, -100, 0}));
  labels.setItems({{"Still", still}});
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.5);
  window.view.setMoving(true);
  window.render();
  ASSERT_EQ(labels.drawn().size(), 1U);
  const auto moveTo = [&](double x) {
    auto moved = std::make_shared<Points>(passing->mesh().points);
    moved->col(0).array() += x + 100;
    passing->setPoints(moved);
    window.render();
  };
  for (const double x : {-50.0, 0.0, 50.0, 100.0, 50.0})
    moveTo(x); // The name moves aside once for what comes.
  moveTo(-100);
  ASSERT_EQ(labels.drawn().size(), 1U);
  const ScreenBox before = labels.drawn()[0].box;
  moveTo(0);
  EXPECT_TRUE(labels.drawn().empty());
  moveTo(-100);
  ASSERT_EQ(labels.drawn().size(), 1U);
  EXPECT_EQ(labels.drawn()[0].box.left, before.left);
  EXPECT_EQ(labels.drawn()[0].box.bottom, before.bottom);
}

/// In a low view there is room for some of twenty: those of which most is seen.
TEST(LabelsOfOrgans, AmongManyThoseThatAreSeenMostAreNamedFirst) {
  tests::ViewInWindow window(480, 200);
  OrganLabels labels(window.view);
  std::vector<OrganLabels::Item> items;
  for (int i = 0; i < 20; ++i) {
    const double radius = i < 16 ? 8 : 30; // The large ones come last.
    const double x = i < 16 ? 25 * (i % 4) : 110 + 65 * (i % 2);
    const double z = i < 16 ? 25 * (i / 4) : 65 * ((i - 16) / 2);
    items.push_back({(i < 16 ? "Small organ " : "Large organ ") + std::to_string(i),
                     window.addOrgan(tests::sphere(3, radius, {x, 0, z}))});
  }
  labels.setItems(std::move(items));
  labels.setShown(true);
  window.view.lookFrom(StandardView::anterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.8);
  window.render();
  const auto drawn = labels.drawn();
  EXPECT_LT(drawn.size(), 20U) << "else this shows nothing";
  int large = 0;
  for (const auto& label : drawn)
    large += label.text.rfind("Large", 0) == 0 ? 1 : 0;
  EXPECT_EQ(large, 4);
}

TEST_F(Labels, OfHiddenOrgansAreNotDrawnAndNoneWithoutAsking) {
  left->setVisible(false);
  window.render();
  EXPECT_EQ(labels.drawn().size(), 2u);
  labels.setShown(false);
  window.render();
  EXPECT_TRUE(labels.drawn().empty());
}

TEST_F(Labels, OfPartsEndAtTheirVertexWhileItCanBeSeen) {
  wall->setOpacity(1);
  Eigen::Index front = 0, back = 0;
  wall->mesh().points.col(1).minCoeff(&front);
  wall->mesh().points.col(1).maxCoeff(&back);
  labels.setItems({{"Front", wall, false, front}, {"Back", wall, false, back}});
  window.render();
  ASSERT_EQ(labels.drawn().size(), 1U) << "one is behind the wall";
  auto beaten = std::make_shared<Points>(wall->mesh().points);
  beaten->col(2).array() += 20;
  wall->setPoints(beaten);
  window.render();
  const auto at = window.display(beaten->row(front).transpose());
  EXPECT_NEAR(named("Front").targetX, at[0], 1);
  EXPECT_NEAR(named("Front").targetY, at[1], 1);
  window.view.lookFrom(StandardView::posterior);
  window.view.renderer()->GetActiveCamera()->Zoom(0.6);
  window.render();
  ASSERT_EQ(labels.drawn().size(), 1U);
  EXPECT_EQ(labels.drawn()[0].text, "Back");
}

TEST_F(Labels, AreLeftOutWhereTheOrganFillsTheView) {
  window.view.renderer()->GetActiveCamera()->Zoom(12);
  window.render();
  EXPECT_TRUE(labels.drawn().empty());
}

} // namespace
} // namespace viscera::scene
