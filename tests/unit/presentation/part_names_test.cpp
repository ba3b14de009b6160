#include "viscera/presentation/part_names.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"

namespace viscera::presentation {
namespace {

/// Two balls; one has three parts, one has none.
class PartNames : public testing::Test {
protected:
  PartNames() {
    document::Organ ball = document::makeOrgan("Ball", tests::sphere(3, 40));
    ball.id = document::OrganId{7};
    ball.places = {{"Front", {0, -40, 0}}, {"Top", {0, 0, 40}}, {"Left side", {40, 0, 0}}};
    document::Organ plain = document::makeOrgan("Plain", tests::sphere(2, 10));
    plain.id = document::OrganId{8};
    organs_ = {std::make_shared<const document::Organ>(ball), std::make_shared<const document::Organ>(plain)};
  }
  document::OrganList organs_;
};

TEST_F(PartNames, AreOfTheNearestVertices) {
  const std::vector<Part> parts = partsOf(organs_);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(nameOf(parts[1], organs_), "Top");
  for (const Part& part : parts) {
    const auto& place = organs_[0]->places[part.place];
    EXPECT_LT((organs_[0]->mesh->points.row(part.vertex).transpose() - place.at).norm(), 4) << place.name;
  }
}

TEST_F(PartNames, OfHiddenOrgansAreNotThere) {
  document::Organ hidden = *organs_[0];
  hidden.look.visible = false;
  EXPECT_TRUE(partsOf({std::make_shared<const document::Organ>(hidden)}).empty());
}

/// A click meets what is around a cavity.
TEST_F(PartNames, InAVisibleOrganCannotBeClicked) {
  document::Organ cavity = *organs_[0], wall = *organs_[1];
  cavity.parent = wall.id;
  const auto within = [&](bool visible) {
    wall.look.visible = visible;
    return document::OrganList{std::make_shared<const document::Organ>(cavity),
                               std::make_shared<const document::Organ>(wall)};
  };
  EXPECT_EQ(clickableParts(organs_), partsOf(organs_));
  EXPECT_TRUE(clickableParts(within(true)).empty());
  EXPECT_EQ(partsOf(within(true)).size(), 3U);
  EXPECT_EQ(clickableParts(within(false)).size(), 3U);
}

TEST_F(PartNames, TheNearestPartIsToldInThePresentPose) {
  const std::vector<Part> parts = partsOf(organs_);
  Points turned = organs_[0]->mesh->points;
  turned.col(2) *= -1; // Upside down: the top is below now.
  EXPECT_EQ(nameOf(*nearestPart(parts, organs_[0]->id, turned, {1, 2, -39}), organs_), "Top");
  EXPECT_FALSE(nearestPart(parts, organs_[1]->id, organs_[1]->mesh->points, {0, 0, 10}));
}

TEST_F(PartNames, AQuizAsksForAllInAnOrderOfItsSeed) {
  const std::vector<Part> parts = partsOf(organs_);
  std::set<std::size_t> first;
  for (unsigned seed = 0; seed < 20; ++seed) {
    PartQuiz quiz(parts, seed);
    first.insert(quiz.asked()->place);
    EXPECT_EQ(quiz.asked()->place, PartQuiz(parts, seed).asked()->place);
    while (quiz.asked())
      EXPECT_TRUE(quiz.answer(*quiz.asked()));
    EXPECT_EQ(quiz.found().size(), parts.size());
    EXPECT_EQ(quiz.mistakes(), 0);
  }
  EXPECT_EQ(first.size(), 3U);
}

TEST_F(PartNames, WhatIsNotFoundInTwoTriesIsAskedAgainAtTheEnd) {
  const std::vector<Part> parts = partsOf(organs_);
  PartQuiz quiz(parts, 1);
  const Part hard = *quiz.asked();
  const Part wrong = hard == parts[0] ? parts[1] : parts[0];
  EXPECT_FALSE(quiz.answer(wrong));
  EXPECT_EQ(*quiz.asked(), hard) << "once more";
  EXPECT_FALSE(quiz.answer(wrong));
  EXPECT_NE(*quiz.asked(), hard);
  EXPECT_TRUE(quiz.answer(*quiz.asked()));
  EXPECT_TRUE(quiz.answer(*quiz.asked()));
  EXPECT_EQ(*quiz.asked(), hard);
  EXPECT_TRUE(quiz.answer(hard));
  EXPECT_EQ(quiz.asked(), nullptr);
  EXPECT_EQ(quiz.mistakes(), 2);
}

} // namespace
} // namespace viscera::presentation
