#include "viscera/document/key_sequence_commands.h"

#include <cmath>

#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/live/sequence_file.h"

namespace viscera::document {
namespace {

using sequences::Easing;
using tests::row;

/// A document in which a ball has been recorded at rest, moved, and at rest.
struct Recorded : tests::Session {
  Recorded() {
    undo.perform(recordKey(0));
    undo.perform(moveHandles({handle(8)}, row(5, 6, 50)));
    undo.perform(recordKey(1, Easing::linear));
    undo.perform(resetPose());
    undo.perform(recordKey(1.5));
  }
  const KeySequence& keySequence() const { return document.keySequence(); }
  KeyId key(std::size_t i) const { return keySequence().keys.at(i).id; }
};

TEST(KeySequence, playsThePosesThatWereRecorded) {
  const Recorded session;
  const auto sequence = sequenceOf(session.keySequence(), session.document.rig());
  ASSERT_TRUE(sequence);
  Points pose;
  sequence->poseAt(1, sequence->standardRatePerMinute(), pose);
  EXPECT_LT((pose.row(8) - row(5, 6, 50)).norm(), 1e-12);
  EXPECT_EQ(pose.row(3), session.document.rig().restPositions().row(3));
  sequence->poseAt(1.25, sequence->standardRatePerMinute(), pose);
  EXPECT_LT((pose.row(8) - row(2.5, 3, 45)).norm(), 1e-12) << "linear: half of the way in half of the time";
}

TEST(KeySequence, everyCommandIsOneUndoStepAndUndoingIsExact) {
  Recorded session;
  const auto check = [&](const Command& command) {
    const DocumentState before = session.document.state();
    const std::size_t steps = session.undo.position();
    session.undo.perform(command);
    EXPECT_EQ(session.undo.position(), steps + 1) << command.name;
    EXPECT_FALSE(session.document.state() == before) << command.name;
    const DocumentState after = session.document.state();
    session.undo.undo();
    EXPECT_TRUE(identical(session.document.state(), before)) << command.name;
    session.undo.redo();
    EXPECT_TRUE(identical(session.document.state(), after)) << command.name;
  };
  check(recordKey(0.5));
  check(moveKey(session.key(1), 0.75));
  check(setEasing({session.key(0), session.key(1)}, Easing::out));
  check(removeKeys({session.key(1)}));
  check(editKeySequence({.name = "Hop", .periodSeconds = 8, .stretch = true}));
  check(editKeySequence({.loop = false, .interpolation = sequences::Interpolation::curve}));
  session.undo.perform(moveHandles({session.handle(8)}, row(1, 1, 41)));
  check(replaceKey(session.key(0)));
  check(replaceKeySequence(KeySequence()));
}

TEST(KeySequence, aKeyRecordedAtTheTimeOfAnotherTakesItsPlace) {
  Recorded session;
  const KeyId first = session.key(0);
  session.undo.perform(moveHandles({session.handle(9)}, row(44, 3, 1)));
  session.undo.perform(recordKey(0));
  EXPECT_EQ(session.keySequence().keys.size(), 3u);
  EXPECT_EQ(session.key(0), first);
  EXPECT_EQ(session.keySequence().keys[0].displacements.at(session.handle(9)), Vec3(4, 0, 2));
}

TEST(KeySequence, movingAKeyPastAnotherKeepsThemInOrderOfTimeAndADragIsOneStep) {
  Recorded session;
  const KeyId first = session.key(0);
  const std::size_t steps = session.undo.position();
  for (const double seconds : {0.3, 0.7, 1.2, 1.7})
    session.undo.perform(moveKey(first, seconds));
  EXPECT_EQ(session.undo.position(), steps + 1);
  EXPECT_EQ(session.key(2), first);
  EXPECT_EQ(session.keySequence().keys[2].seconds, 1.7);
}

TEST(KeySequence, outlivesHandlesThatAreAddedRemovedAndMovedAtRest) {
  Recorded session;
  session.undo.perform(moveRestHandles({session.handle(8)}, row(0, 0, 45)));
  session.undo.perform(removeHandles({session.handle(9)}));
  session.undo.perform(addHandles(newHandles(row(-40, 2, 3))));
  const auto sequence = sequenceOf(session.keySequence(), session.document.rig());
  Points pose;
  sequence->poseAt(1, sequence->standardRatePerMinute(), pose);
  ASSERT_EQ(pose.rows(), 10);
  EXPECT_LT((pose.row(8) - row(5, 6, 55)).norm(), 1e-12);
  EXPECT_EQ(pose.row(9), row(-40, 2, 3));
}

TEST(KeySequence, aKeyIsNotMovedOntoAnotherThatIsNearerThanAMillisecondToIt) {
  Recorded session;
  session.undo.perform(recordKey(0.5));
  session.undo.perform(recordKey(0.5012));
  const KeyId moved = session.key(1);
  session.undo.perform(moveKey(moved, 0.5002));
  EXPECT_THROW(session.undo.perform(moveKey(moved, 0.5012)), DataError);
  EXPECT_EQ(session.keySequence().keys[1].seconds, 0.5002);
}

TEST(KeySequence, aKeyThatIsNamedTwiceIsRemovedOnce) {
  Recorded session;
  session.undo.perform(removeKeys({session.key(1), session.key(1)}));
  EXPECT_EQ(session.keySequence().keys.size(), 2u);
}

TEST(KeySequence, refusesTimesAndKeysThatCannotBe) {
  Recorded session;
  const DocumentState before = session.document.state();
  const auto refused = [&](const Command& command) {
    EXPECT_THROW(session.undo.perform(command), Error) << command.name;
    EXPECT_TRUE(session.document.state() == before);
  };
  refused(recordKey(-0.1));
  refused(recordKey(2));
  refused(recordKey(std::nan("")));
  refused(moveKey(session.key(0), 1));
  refused(moveKey(KeyId{12345}, 0.5));
  refused(removeKeys({KeyId{12345}}));
  refused(editKeySequence({.periodSeconds = 1.2}));
  refused(editKeySequence({.periodSeconds = -1}));
  refused(editKeySequence({.periodSeconds = 1e-4, .stretch = true}));
  refused(editKeySequence({.name = ""}));
  tests::Session empty;
  EXPECT_THROW(live::sequenceFile(empty.document.state()), UsageError);
  EXPECT_EQ(sequenceOf(empty.document.keySequence(), empty.document.rig()), nullptr);
}

TEST(KeySequence, StepsSayKeySequence) {
  EXPECT_EQ(editKeySequence({.loop = false}).name.english(), "Change key sequence");
  EXPECT_EQ(replaceKeySequence(KeySequence()).name.english(), "Replace key sequence");
}

TEST(KeySequence, comesBackFromAFileIntoTheSameHandlesOrIntoItsOwn) {
  Recorded session;
  session.undo.perform(editKeySequence({.name = "Hop", .periodSeconds = 3}));
  const live::SequenceFile file = live::sequenceFile(session.document.state());
  const auto wanted = sequenceOf(session.keySequence(), session.document.rig());
  session.undo.perform(replaceKeySequence(KeySequence()));
  const auto rig = session.document.state().rig;
  session.undo.perform(live::openSequence(file));
  EXPECT_EQ(session.document.state().rig, rig) << "the handles are there already";
  Document other;
  UndoStack undo(other);
  undo.perform(live::openSequence(file));
  EXPECT_EQ(other.rig().restPositions(), session.document.rig().restPositions());
  for (const Document* document : {&session.document, &other}) {
    const auto sequence = sequenceOf(document->keySequence(), document->rig());
    ASSERT_TRUE(sequence);
    EXPECT_EQ(sequence->name().english(), "Hop");
    Points a, b;
    sequence->poseAt(0.8, 20, a);
    wanted->poseAt(0.8, 20, b);
    EXPECT_LT((a - b).norm(), 1e-12);
  }
  undo.undo();
  EXPECT_TRUE(other.rig().handles.empty());
}

TEST(CorrectKeys, ReplacesTheKeysThatAreNamedAndKeepsTheContoursInOneStep) {
  Recorded session;
  live::SequenceFile corrected = live::sequenceFile(session.document.state());
  for (sequences::Keyframe& key : corrected.track.keys)
    key.pose.row(8) = row(7, 8, 60);
  const KeySequence before = session.keySequence();
  const std::vector<CorrectedContour> contours = {{1, 0, "ball", {Vec3(1, 2, 3), Vec3(2, 2, 3)}}};
  session.undo.perform(live::correctKeys(corrected, {1}, contours));
  const KeySequence after = session.keySequence();
  EXPECT_EQ(after.corrections, contours);
  EXPECT_EQ(after.keys[0], before.keys[0]) << "another key stays";
  EXPECT_EQ(after.keys[2], before.keys[2]);
  EXPECT_EQ(after.keys[1].id, before.keys[1].id);
  EXPECT_EQ(after.keys[1].easing, before.keys[1].easing);
  EXPECT_LT((poseOf(after.keys[1], session.document.rig()).row(8) - row(7, 8, 60)).norm(), 1e-12);
  session.undo.undo();
  EXPECT_EQ(session.keySequence(), before);
  session.undo.redo();
  EXPECT_EQ(session.keySequence(), after);
}

TEST(CorrectKeys, RefusesKeysAndHandlesThatAreNoLongerThere) {
  Recorded session;
  const live::SequenceFile corrected = live::sequenceFile(session.document.state());
  session.undo.perform(moveKey(session.key(1), 1.2));
  EXPECT_THROW(session.undo.perform(live::correctKeys(corrected, {1}, {})), UsageError);
  EXPECT_NO_THROW(session.undo.perform(live::correctKeys(corrected, {2}, {})));
  session.undo.perform(removeHandles({session.handle(3)}));
  EXPECT_THROW(session.undo.perform(live::correctKeys(corrected, {2}, {})), UsageError);
}

} // namespace
} // namespace viscera::document
