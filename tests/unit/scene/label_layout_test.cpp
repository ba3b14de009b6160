#include "viscera/scene/label_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace viscera::scene {
namespace {

TEST(SpreadApart, LeavesIntervalsWhereTheyAreWhenTheyDoNotMeet) {
  const auto placed = spreadApart({10, 50, 30}, {8, 8, 8}, 0, 100, 2);
  ASSERT_TRUE(placed);
  EXPECT_EQ(*placed, (std::vector<double>{10, 50, 30}));
}

TEST(SpreadApart, MovesTwoThatMeetByTheSameWay) {
  const auto placed = spreadApart({50, 52}, {10, 10}, 0, 100, 2);
  ASSERT_TRUE(placed);
  EXPECT_DOUBLE_EQ((*placed)[0], 45);
  EXPECT_DOUBLE_EQ((*placed)[1], 57);
}

TEST(SpreadApart, KeepsInsideAndSaysWhenThereIsNoRoom) {
  const auto placed = spreadApart({-20, 0, 5}, {10, 10, 10}, 0, 40, 1);
  ASSERT_TRUE(placed);
  EXPECT_DOUBLE_EQ((*placed)[0], 5);
  EXPECT_DOUBLE_EQ((*placed)[1], 16);
  EXPECT_FALSE(spreadApart({1, 2, 3}, {10, 10, 10}, 0, 31, 1));
  EXPECT_TRUE(spreadApart({1, 2, 3}, {10, 10, 10}, 0, 32, 1));
  EXPECT_TRUE(spreadApart({}, {}, 0, 1, 1)->empty());
}

TEST(SpreadApart, NeverOverlapsAndIsAtLeastAsNearAsPackingFromBelow) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 300);
  std::uniform_real_distribution<double> length(5, 40);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> centers(7);
    std::vector<double> sizes(7);
    std::generate(centers.begin(), centers.end(), [&] { return place(random); });
    std::generate(sizes.begin(), sizes.end(), [&] { return length(random); });
    const auto placed = spreadApart(centers, sizes, 0, 400, 3);
    ASSERT_TRUE(placed);
    std::vector<std::size_t> order(7);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return (*placed)[a] < (*placed)[b]; });
    double end = -3;
    double cost = 0;
    double packed = 0;
    double packedEnd = -3;
    for (const std::size_t i : order) {
      EXPECT_GE((*placed)[i] - sizes[i] / 2, end + 3 - 1e-9);
      end = (*placed)[i] + sizes[i] / 2;
      cost += std::pow((*placed)[i] - centers[i], 2);
      const double greedy = std::max(centers[i], packedEnd + 3 + sizes[i] / 2);
      packedEnd = greedy + sizes[i] / 2;
      packed += std::pow(greedy - centers[i], 2);
    }
    EXPECT_LE(end, 400 + 1e-9);
    EXPECT_LE(cost, packed + 1e-6);
  }
}

/// A round organ in the middle of a view.
Footprint disc(double x, double y, double radius) {
  Footprint covered(400);
  for (double angle = 0; angle < 2 * M_PI; angle += 0.05)
    for (double r = 0; r <= radius; r += 5)
      covered.cover(x + r * std::cos(angle), y + r * std::sin(angle), 4);
  return covered;
}

LabelSpace view(double width = 600, double height = 400) {
  LabelSpace space;
  space.width = width;
  space.height = height;
  return space;
}

void expectApart(const std::vector<std::optional<ScreenBox>>& boxes, const Footprint& covered,
                 const LabelSpace& space) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i])
      continue;
    EXPECT_FALSE(covered.touches(*boxes[i])) << "label " << i << " lies on the organ";
    EXPECT_GE(boxes[i]->left, space.margin);
    EXPECT_GE(boxes[i]->bottom, space.margin);
    EXPECT_LE(boxes[i]->right, space.width - space.margin);
    EXPECT_LE(boxes[i]->top, space.height - space.margin);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(boxes[j] && boxes[i]->overlaps(*boxes[j])) << "labels " << i << " and " << j;
    for (const ScreenBox& reserved : space.reserved)
      EXPECT_FALSE(boxes[i]->overlaps(reserved)) << "label " << i;
  }
}

TEST(LabelLayout, PutsEachLabelOnItsSideAndLevelWithWhatItNames) {
  const Footprint covered = disc(300, 200, 100);
  const auto boxes = placeLabels({{250, 240, 80, 16}, {350, 180, 80, 16}}, covered, view());
  ASSERT_TRUE(boxes[0] && boxes[1]);
  EXPECT_LT(boxes[0]->right, 200);
  EXPECT_GT(boxes[1]->left, 400);
  EXPECT_NEAR((boxes[0]->bottom + boxes[0]->top) / 2, 240, 1e-9);
  EXPECT_NEAR((boxes[1]->bottom + boxes[1]->top) / 2, 180, 1e-9);
  expectApart(boxes, covered, view());
}

TEST(LabelLayout, NoLabelMeetsAnotherOrTheOrganHoweverManyThereAre) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Footprint covered = disc(300, 200, 130);
  LabelSpace space = view();
  space.reserved = {{0, 0, 600, 44}, {0, 0, 100, 100}};
  for (const int count : {1, 4, 12, 30}) {
    std::vector<LabelRequest> labels;
    for (int i = 0; i < count; ++i)
      labels.push_back({300 + 90 * unit(random), 200 + 90 * unit(random), 90 + 20 * unit(random), 16});
    const auto boxes = placeLabels(labels, covered, space);
    expectApart(boxes, covered, space);
    const auto shown = std::count_if(boxes.begin(), boxes.end(), [](const auto& box) { return !!box; });
    EXPECT_EQ(shown, count) << "there is room for all of them";
  }
}

TEST(LabelLayout, GoesToTheOtherSideAndLeavesOutWhatHasNoRoom) {
  const Footprint atLeft = disc(110, 200, 100);
  const auto moved = placeLabels({{60, 200, 80, 16}}, atLeft, view());
  ASSERT_TRUE(moved[0]);
  EXPECT_GT(moved[0]->left, 210);
  Footprint everything(400);
  for (double y = 0; y <= 400; y += 4) {
    everything.cover(2, y, 4);
    everything.cover(598, y, 4);
  }
  EXPECT_FALSE(placeLabels({{300, 200, 80, 16}}, everything, view())[0]);
}

TEST(LabelLayout, FindsTheFreeCornerBesideALargeOrgan) {
  // A diamond that fills the view but for its corners.
  Footprint covered(400);
  for (double y = 0; y <= 400; y += 2) {
    const double half = 300 - 1.45 * std::abs(y - 200);
    for (double x = 300 - half; x <= 300 + half; x += 4)
      covered.cover(x, y, 3);
  }
  const auto boxes = placeLabels({{200, 210, 90, 16}, {420, 190, 90, 16}}, covered, view());
  ASSERT_TRUE(boxes[0] && boxes[1]);
  expectApart(boxes, covered, view());
}

TEST(LabelLayout, BreaksALongNameInANarrowViewSoThatItStandsNearby) {
  const Footprint covered = disc(180, 200, 60);
  LabelRequest name{200, 200, 190, 16};
  const auto far = placeLabels({name}, covered, view(360));
  name.brokenWidth = 80;
  name.brokenHeight = 34;
  const auto near = placeLabels({name}, covered, view(360));
  ASSERT_TRUE(far[0] && near[0]);
  EXPECT_GT(std::abs((far[0]->bottom + far[0]->top) / 2 - 200), 60) << "beside it there is no room";
  EXPECT_NEAR((near[0]->bottom + near[0]->top) / 2, 200, 1e-9);
  EXPECT_DOUBLE_EQ(near[0]->height(), 34);
  expectApart(near, covered, view(360));
  const auto wide = placeLabels({name}, disc(300, 200, 60), view(700));
  EXPECT_DOUBLE_EQ(wide[0]->height(), 16) << "in one line where there is room";
}

/// Which lines run through which names.
std::vector<std::pair<std::size_t, std::size_t>>
crossings(const std::vector<LabelRequest>& labels, const std::vector<std::optional<ScreenBox>>& boxes) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < labels.size(); ++j) {
      if (i == j || !boxes[i] || !boxes[j])
        continue;
      const ScreenPlace end = leaderEnd(labels[i], *boxes[i]);
      const ScreenPlace start = leaderStart(*boxes[i], end, 4);
      bool through = false;
      for (double part = 0; part <= 1; part += 0.005) {
        const double x = start.x + part * (end.x - start.x);
        const double y = start.y + part * (end.y - start.y);
        through = through || ScreenBox{x, y, x, y}.overlaps(*boxes[j]);
      }
      if (through)
        found.emplace_back(i, j);
    }
  return found;
}

TEST(LabelLayout, MovesALabelWhoseLineWouldRunThroughAnothersName) {
  const Footprint covered = disc(180, 200, 90);
  const std::vector<LabelRequest> labels = {{155, 210, 100, 16}, {220, 220, 120, 16}, {230, 225, 120, 16}};
  const auto boxes = placeLabels(labels, covered, view(360));
  expectApart(boxes, covered, view(360));
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_TRUE(boxes[i]) << i;
  for (const auto& [line, name] : crossings(labels, boxes))
    ADD_FAILURE() << "the line of " << line << " runs through name " << name;
}

TEST(LabelLayout, LeavesOutTheLaterOfTwoLabelsWhereItsLineWouldRunThroughANameAnywhere) {
  const Footprint covered = disc(180, 200, 95);
  LabelSpace space = view(360);
  space.reserved = {{0, 0, 360, 44}};
  for (unsigned crowd = 100; crowd < 140; ++crowd) {
    std::mt19937 random(crowd);
    std::uniform_real_distribution<double> part(0, 1);
    std::vector<LabelRequest> labels;
    for (int i = 0; i < 9; ++i) {
      const double away = 90 * std::sqrt(part(random));
      const double angle = 2 * M_PI * part(random);
      labels.push_back({180 + away * std::cos(angle), 200 + away * std::sin(angle), 110, 16});
    }
    const auto boxes = placeLabels(labels, covered, space);
    expectApart(boxes, covered, space);
    for (const auto& [line, name] : crossings(labels, boxes))
      ADD_FAILURE() << "crowd " << crowd << ": the line of " << line << " runs through name " << name;
    EXPECT_TRUE(boxes[0]) << "the first is the most important one";
    EXPECT_GE(std::count_if(boxes.begin(), boxes.end(), [](const auto& box) { return !!box; }), 6);
  }
}

TEST(LabelLayout, KeepsLabelsWhereTheyAreAndMovesOnlyThoseThatNoLongerFit) {
  std::vector<LabelRequest> labels = {{250, 240, 80, 16}, {350, 180, 80, 16}};
  const auto before = placeLabels(labels, disc(300, 200, 100), view());
  ASSERT_TRUE(before[0] && before[1]);
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i].kept = before[i];
  const auto same = [](const ScreenBox& a, const ScreenBox& b) {
    return a.left == b.left && a.bottom == b.bottom && a.right == b.right && a.top == b.top;
  };
  Footprint larger = disc(300, 200, 80);
  const auto smaller = placeLabels(labels, larger, view());
  ASSERT_TRUE(smaller[0] && smaller[1]);
  EXPECT_TRUE(same(*smaller[0], *before[0]) && same(*smaller[1], *before[1]));
  larger.cover(420, 180, 10);
  const auto moved = placeLabels(labels, larger, view());
  ASSERT_TRUE(moved[0] && moved[1]);
  EXPECT_TRUE(same(*moved[0], *before[0]));
  EXPECT_GT(moved[1]->left, 430) << "it was covered";
}

TEST(LabelLayout, LinesRunThroughNoNameWhereverWhatTheyNameMoves) {
  const std::vector<std::optional<ScreenBox>> boxes = {ScreenBox{20, 192, 100, 208},
                                                       ScreenBox{120, 242, 200, 258}};
  std::vector<LabelRequest> labels = {{300, 200, 80, 16}, {300, 250, 80, 16}};
  EXPECT_TRUE(linesAreClear(labels, boxes, view()));
  labels[0].reach = ScreenBox{300, 190, 310, 320};
  EXPECT_FALSE(linesAreClear(labels, boxes, view())) << "there its line runs through the other name";
}

TEST(LabelLayout, ALineToAnEdgeEndsInsideItLevelWithItsLabel) {
  const Footprint covered = disc(300, 200, 60);
  LabelRequest label{300, 230, 80, 16};
  const auto end = [&](const ScreenBox& box) {
    const ScreenPlace place = leaderEnd(label, box);
    return std::vector<double>{place.x, place.y};
  };
  const ScreenBox left{100, 192, 180, 208}, right{420, 192, 500, 208}, above{260, 300, 340, 316};
  EXPECT_EQ(end(left), (std::vector<double>{300, 230})) << "it names a place";
  label.edge = &covered;
  label.inside = 10;
  const auto level = covered.between(192, 208);
  ASSERT_TRUE(level);
  EXPECT_EQ(end(left), (std::vector<double>{level->left + 10, 200}));
  EXPECT_EQ(end(right), (std::vector<double>{level->right - 10, 200}));
  EXPECT_EQ(end(above), (std::vector<double>{300, 230})) << "nothing is covered level with it";
}

TEST(LabelLayout, PutsALabelAboveEverythingIntoTheViewWhereverItsOrganIs) {
  const Footprint covered = disc(180, 150, 140);
  const auto boxes = placeLabels({{60, 200, 300, 16}}, covered, view(360));
  ASSERT_TRUE(boxes[0]);
  expectApart(boxes, covered, view(360));
}

TEST(LabelLayout, BeginsTheLineAtTheSideThatIsTurnedToWhatIsNamed) {
  const ScreenBox box{100, 50, 200, 70};
  const auto start = [&](double x, double y) {
    const ScreenPlace place = leaderStart(box, {x, y}, 3);
    return std::vector<double>{place.x, place.y};
  };
  EXPECT_EQ(start(300, 10), (std::vector<double>{203, 60}));
  EXPECT_EQ(start(20, 200), (std::vector<double>{97, 60}));
  EXPECT_EQ(start(150, 200), (std::vector<double>{150, 73})) << "not through the name";
  EXPECT_EQ(start(120, 10), (std::vector<double>{120, 47}));
}

} // namespace
} // namespace viscera::scene
