#include "viscera/sequences/keyframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr std::array kAll{Easing::linear, Easing::smooth, Easing::in, Easing::out, Easing::hold};

Points four(double x) {
  Points points = Points::Zero(4, 3);
  points.col(0).setConstant(x);
  points(1, 1) = points(2, 2) = 1;
  points(3, 0) = 7; // Does not move.
  return points;
}

KeyframedSequence::Track track(bool loop = true) {
  KeyframedSequence::Track track;
  track.restHandles = four(0);
  track.periodSeconds = 4;
  track.loop = loop;
  track.keys = {{0.5, four(0), Easing::linear},
                {1.5, four(10), Easing::smooth},
                {2, four(10), Easing::smooth},
                {3, four(-4), Easing::smooth}};
  return track;
}

double xAt(const KeyframedSequence& sequence, double seconds) {
  Points pose;
  sequence.poseAt(seconds, sequence.standardRatePerMinute(), pose);
  return pose(0, 0);
}

TEST(Keyframes, easingsAscendFromNoneToAllOfTheWay) {
  for (const Easing easing : kAll) {
    EXPECT_EQ(eased(easing, 0), 0);
    EXPECT_EQ(eased(easing, 1), easing == Easing::hold ? 0 : 1);
    for (int i = 0; i < 100; ++i)
      EXPECT_LE(eased(easing, i / 100.0), eased(easing, (i + 1) / 100.0)) << nameOf(easing);
    EXPECT_EQ(easingFromName(nameOf(easing)), easing);
  }
  EXPECT_EQ(easingFromName("bouncy"), std::nullopt);
  EXPECT_EQ(interpolationFromName("curve"), Interpolation::curve);
  EXPECT_EQ(interpolationFromName("zigzag"), std::nullopt);
}

TEST(Keyframes, poseIsThatOfTheKeyAtItsTimeAtEveryRateAndInEveryCycle) {
  for (const Interpolation interpolation : {Interpolation::eased, Interpolation::curve}) {
    KeyframedSequence::Track recorded = track();
    recorded.interpolation = interpolation;
    const KeyframedSequence sequence(recorded);
    EXPECT_EQ(sequence.standardRatePerMinute(), 15);
    for (const Keyframe& key : recorded.keys) {
      Points pose;
      sequence.poseAt(key.seconds, 15, pose);
      EXPECT_EQ(pose, key.pose);
      sequence.poseAt(key.seconds / 2 + 6, 30, pose);
      EXPECT_LT((pose - key.pose).norm(), 1e-9);
    }
  }
}

TEST(Keyframes, neverOvershootsAndGoesFromKeyToKeyWithoutTurningBack) {
  for (const Interpolation interpolation : {Interpolation::eased, Interpolation::curve})
    for (const Easing easing : kAll) {
      KeyframedSequence::Track recorded = track();
      recorded.interpolation = interpolation;
      for (Keyframe& key : recorded.keys)
        key.easing = easing;
      const KeyframedSequence sequence(recorded);
      for (int i = 0; i < 100; ++i) {
        EXPECT_LE(xAt(sequence, 0.5 + 0.01 * i), xAt(sequence, 0.51 + 0.01 * i) + 1e-12);
        EXPECT_GE(xAt(sequence, 2 + 0.0099 * i), xAt(sequence, 2.0099 + 0.0099 * i) - 1e-12);
        EXPECT_NEAR(xAt(sequence, 1.5 + 0.005 * i), 10, 1e-12);
      }
    }
}

TEST(Keyframes, aCurveHasNoKinkAtItsKeysAndLinearSpansHave) {
  const auto jump = [](const KeyframedSequence& sequence, double at) {
    constexpr double kStep = 1e-5;
    const double before = (xAt(sequence, at) - xAt(sequence, at - kStep)) / kStep;
    const double after = (xAt(sequence, at + kStep) - xAt(sequence, at)) / kStep;
    return std::abs(after - before);
  };
  KeyframedSequence::Track recorded = track();
  recorded.interpolation = Interpolation::curve;
  const KeyframedSequence curve(recorded);
  for (const Keyframe& key : recorded.keys)
    EXPECT_LT(jump(curve, key.seconds), 0.02) << key.seconds;
  recorded.interpolation = Interpolation::eased;
  EXPECT_GT(jump(KeyframedSequence(recorded), 1.5), 5);
}

TEST(Keyframes, aLoopLeadsBackToTheFirstKeyAndOtherwiseTheLastPoseStays) {
  const KeyframedSequence loop(track(true));
  const KeyframedSequence once(track(false));
  EXPECT_NEAR(xAt(loop, 3.75), -2, 1e-12);
  EXPECT_NEAR(xAt(loop, 0.25), xAt(loop, 4.25), 1e-12);
  EXPECT_EQ(xAt(once, 3.75), -4);
  EXPECT_EQ(xAt(once, 0.25), 0);
}

TEST(Keyframes, phasesCoverThePeriodFromKeyToKey) {
  const auto phases = KeyframedSequence(track()).phases(15);
  ASSERT_EQ(phases.size(), 5u);
  EXPECT_EQ(phases[0].name.english(), "start");
  EXPECT_EQ(phases[4].name.english(), "key 4");
  for (std::size_t i = 1; i < phases.size(); ++i)
    EXPECT_EQ(phases[i].begin, phases[i - 1].end);
  EXPECT_EQ(phases.back().end, 1);
}

/// What a table of the keys marks, the nearest one, has the same number as the name of the instant.
TEST(Keyframes, everyInstantIsNamedAfterTheNearestKey) {
  for (const double first : {0.0, 0.5}) {
    KeyframedSequence::Track recorded = track();
    recorded.keys.front().seconds = first;
    const KeyframedSequence sequence(recorded);
    const std::vector<double> keys = sequence.keys();
    const auto phases = sequence.phases(15);
    for (double second = 0.5 * first + 1e-3; second < recorded.periodSeconds; second += 0.01) {
      std::size_t nearest = 0;
      const auto gap = [&](std::size_t key) {
        const double apart = std::abs(keys[key] - second);
        return first == 0 ? std::min(apart, recorded.periodSeconds - apart) : apart;
      };
      for (std::size_t key = 1; key < keys.size(); ++key)
        if (gap(key) < gap(nearest))
          nearest = key;
      const double part = second / recorded.periodSeconds;
      const auto at =
          std::find_if(phases.begin(), phases.end(), [part](const Phase& phase) { return part < phase.end; });
      ASSERT_NE(at, phases.end());
      EXPECT_EQ(at->name.english(), "key " + std::to_string(nearest + 1)) << second << " s";
    }
  }
}

TEST(Keyframes, oneKeyIsAPoseThatStays) {
  KeyframedSequence::Track recorded = track();
  recorded.keys.resize(1);
  for (const Interpolation interpolation : {Interpolation::eased, Interpolation::curve}) {
    recorded.interpolation = interpolation;
    EXPECT_EQ(xAt(KeyframedSequence(recorded), 3.9), 0);
  }
}

TEST(Keyframes, refusesKeysThatMakeNoSequenceAndNamesThem) {
  const auto refused = [](const std::function<void(KeyframedSequence::Track&)>& spoil) {
    KeyframedSequence::Track recorded = track();
    spoil(recorded);
    try {
      const KeyframedSequence sequence(recorded);
    } catch (const DataError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refused([](auto& t) { t.keys.clear(); }).find("no key"), std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[2].seconds = 1.5; }).find("key 3"), std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[3].seconds = 4; }).find("outside the period"), std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[0].seconds = -1; }).find("key 1"), std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[1].pose.conservativeResize(3, 3); }).find("3 handles instead of 4"),
            std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[1].pose(0, 0) = std::nan(""); }).find("finite"), std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.keys[1].seconds = std::nan(""); }).find("key 2"), std::string::npos);
  EXPECT_NE(
      refused([](auto& t) { t.periodSeconds = std::numeric_limits<double>::infinity(); }).find("period"),
      std::string::npos);
  EXPECT_NE(refused([](auto& t) { t.restHandles(0, 0) = std::nan(""); }).find("rest"), std::string::npos);
}

TEST(Keyframes, tellTheirKeysAndAtEachThePoseIsThatOfTheKey) {
  const auto sequence = std::make_shared<KeyframedSequence>(track());
  EXPECT_EQ(sequence->keys(), (std::vector<double>{0.5, 1.5, 2, 3}));
  Points pose;
  for (std::size_t i = 0; i < sequence->keys().size(); ++i) {
    sequence->poseAt(sequence->keys()[i], sequence->standardRatePerMinute(), pose);
    EXPECT_EQ(pose, sequence->track().keys[i].pose) << "key " << i + 1;
  }
}

} // namespace
} // namespace viscera::sequences
