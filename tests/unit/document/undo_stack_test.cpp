#include "viscera/document/undo_stack.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "phantom_scan.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/scan_item.h"

namespace viscera::document {
namespace {

using tests::row;
using tests::Session;

TEST(UndoStack, TakesAStepBackAndDoesItAgainExactly) {
  Session s;
  const DocumentState before = s.document.state();
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 50)));
  const DocumentState after = s.document.state();
  ASSERT_FALSE(identical(before, after));
  EXPECT_EQ(s.undo.undoName().english(), "Move handle");
  s.undo.undo();
  EXPECT_TRUE(identical(s.document.state(), before));
  EXPECT_EQ(s.undo.redoName().english(), "Move handle");
  s.undo.redo();
  EXPECT_TRUE(identical(s.document.state(), after));
  EXPECT_FALSE(s.undo.canRedo());
}

TEST(UndoStack, MakesOneStepOfADragOfAHundredMoves) {
  Session s;
  const DocumentState before = s.document.state();
  UndoStack::Step step(s.undo, "Move handle H-9");
  for (int i = 1; i <= 100; ++i)
    s.undo.perform(moveHandles({s.handle(8)}, row(0.1 * i, 0, 40)));
  step.finish();
  EXPECT_EQ(inEnglish(s.undo.names()), std::vector<std::string>{"Move handle H-9"});
  EXPECT_EQ(s.document.pose().row(8), row(0.1 * 100, 0, 40));
  s.undo.undo();
  EXPECT_TRUE(identical(s.document.state(), before));
  EXPECT_FALSE(s.undo.canUndo());
}

TEST(UndoStack, LeavesNothingOfACancelledDrag) {
  Session s;
  s.undo.perform(moveHandles({s.handle(9)}, row(41, 3, 0)));
  s.undo.undo();
  const DocumentState before = s.document.state();
  UndoStack::Step step(s.undo, "Move handle H-9");
  for (int i = 1; i <= 100; ++i)
    s.undo.perform(moveHandles({s.handle(8)}, row(0.1 * i, 0, 40)));
  step.cancel();
  EXPECT_EQ(s.document.state(), before);
  EXPECT_FALSE(s.undo.canUndo());
  EXPECT_TRUE(s.undo.canRedo()) << "the step that had been taken back before the drag is gone";
  EXPECT_TRUE(s.undo.isClean());
}

TEST(UndoStack, CancelsTheOpenStepOfWhoeverOpenedIt) {
  Session s;
  const DocumentState before = s.document.state();
  s.undo.cancelStep(); // None is open.
  UndoStack::Step step(s.undo, "Move handle");
  s.undo.perform(moveHandles({s.handle(8)}, row(9, 9, 40)));
  s.undo.cancelStep();
  EXPECT_EQ(s.document.state(), before);
  s.undo.perform(moveHandles({s.handle(8)}, row(5, 5, 40)));
  step.cancel();
  EXPECT_EQ(s.undo.position(), 1u) << "a step that is over took back what came after it";
  EXPECT_EQ(s.document.pose().row(8), row(5, 5, 40));
}

TEST(UndoStack, MakesNoStepOfADragThatComesBackToWhereItBegan) {
  Session s;
  UndoStack::Step step(s.undo, "Move handle");
  s.undo.perform(moveHandles({s.handle(8)}, row(9, 9, 40)));
  s.undo.perform(moveHandles({s.handle(8)}, row(0, 0, 40)));
  step.finish();
  EXPECT_FALSE(s.undo.canUndo());
  EXPECT_TRUE(s.undo.isClean());
}

TEST(UndoStack, MakesNoStepOfACommandThatChangesNothing) {
  Session s;
  s.undo.perform(resetPose());
  s.undo.perform(setSystem(s.document.system()));
  s.undo.perform(setOrganLook(s.organ(), s.document.organs()[0]->look));
  EXPECT_FALSE(s.undo.canUndo());
}

TEST(UndoStack, RefusesUndoDuringADrag) {
  Session s;
  s.undo.perform(moveHandles({s.handle(9)}, row(41, 3, 0)));
  UndoStack::Step step(s.undo, "Move handle");
  s.undo.perform(moveHandles({s.handle(8)}, row(9, 9, 40)));
  EXPECT_FALSE(s.undo.canUndo());
  s.undo.undo();
  EXPECT_EQ(s.document.pose().row(8), row(9, 9, 40));
  step.finish();
  EXPECT_EQ(s.undo.position(), 2u);
}

TEST(UndoStack, JoinsASliderIntoOneStepUntilItIsLetGo) {
  Session s;
  OrganLook look = s.document.organs()[0]->look;
  for (const double opacity : {0.9, 0.8, 0.7}) {
    look.opacity = opacity;
    s.undo.perform(setOrganLook(s.organ(), look));
  }
  EXPECT_EQ(s.undo.names().size(), 1u);
  s.undo.seal();
  look.opacity = 0.5;
  s.undo.perform(setOrganLook(s.organ(), look));
  EXPECT_EQ(s.undo.names().size(), 2u);
  s.undo.undo();
  EXPECT_EQ(s.document.organs()[0]->look.opacity, 0.7);
  s.undo.undo();
  EXPECT_EQ(s.document.organs()[0]->look.opacity, 1);
}

TEST(UndoStack, MakesNoStepOfASliderThatComesBackToWhereItBegan) {
  Session s;
  s.undo.perform(setParameter("locality", 1));
  s.undo.markSaved();
  s.undo.seal();
  OrganLook look = s.document.organs()[0]->look;
  for (const double opacity : {0.5, 0.7, 1.0}) {
    look.opacity = opacity;
    s.undo.perform(setOrganLook(s.organ(), look));
  }
  EXPECT_EQ(inEnglish(s.undo.names()), std::vector<std::string>{"Set locality"});
  EXPECT_TRUE(s.undo.isClean());
  look.opacity = 0.2;
  s.undo.perform(setOrganLook(s.organ(), look));
  s.undo.undo();
  EXPECT_TRUE(s.undo.isClean());
}

TEST(UndoStack, AStepThatIsLeftIsTakenBackAndAnotherOneEndsTheOneBefore) {
  Session s;
  const DocumentState before = s.document.state();
  {
    UndoStack::Step left(s.undo, "Left");
    s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 50)));
  }
  EXPECT_EQ(s.document.state(), before);
  UndoStack::Step first(s.undo, "First");
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 50)));
  UndoStack::Step second(s.undo, "Second");
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 60)));
  first.cancel();
  EXPECT_TRUE(s.undo.stepOpen()) << "the second one, which the first does not own";
  second.finish();
  EXPECT_EQ(inEnglish(s.undo.names()), (std::vector<std::string>{"First", "Second"}));
}

TEST(UndoStack, AnObserverThatThrowsLeavesDocumentStackAndTheOtherObserversWhole) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 50)));
  int document = 0, stack = 0;
  bool throws = true;
  const Subscription bad = s.document.onChange([&](const Change&) {
    if (throws)
      throw std::out_of_range("a row that is not there");
  });
  const Subscription good = s.document.onChange([&](const Change&) { ++document; });
  const Subscription undo = s.undo.onChange([&] { ++stack; });
  EXPECT_THROW(s.undo.undo(), std::out_of_range);
  EXPECT_EQ(document, 1);
  EXPECT_EQ(stack, 1);
  EXPECT_EQ(s.undo.position(), 0u);
  EXPECT_TRUE(atRest(s.document.state()));
  throws = false;
  s.undo.redo();
  EXPECT_EQ(document, 2);
  EXPECT_EQ(s.undo.position(), 1u);
  EXPECT_EQ(s.document.pose().row(8), row(1, 2, 50));
}

TEST(UndoStack, RefusesWhatAnObserverWantsToChangeAndStaysWhole) {
  Session s;
  const Subscription subscription = s.document.onChange([&](const Change&) { s.undo.perform(resetPose()); });
  EXPECT_THROW(s.undo.perform(moveHandles({s.handle(8)}, row(1, 2, 50))), std::logic_error);
  EXPECT_EQ(s.undo.position(), 1u);
  EXPECT_EQ(s.document.pose().row(8), row(1, 2, 50));
}

TEST(UndoStack, DoesNotJoinAcrossAnotherCommandOrAnotherOrgan) {
  Session s;
  s.undo.perform(setParameter("locality", 1));
  s.undo.perform(setParameter("locality", 2));
  s.undo.perform(setParameter("softness", 2));
  s.undo.perform(setParameter("locality", 3));
  EXPECT_EQ(s.undo.names().size(), 3u);
}

TEST(UndoStack, KeepsTheSavedStateReachable) {
  Session s;
  s.undo.perform(setParameter("locality", 1));
  s.undo.markSaved();
  EXPECT_TRUE(s.undo.isClean());
  s.undo.perform(setParameter("locality", 2));
  EXPECT_FALSE(s.undo.isClean());
  s.undo.undo();
  EXPECT_TRUE(s.undo.isClean());
  s.undo.undo();
  EXPECT_FALSE(s.undo.isClean());
  s.undo.redo();
  EXPECT_TRUE(s.undo.isClean());
}

TEST(UndoStack, ForgetsWhatCouldBeDoneAgainAfterANewCommand) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 40)));
  s.undo.undo();
  s.undo.perform(moveHandles({s.handle(8)}, row(2, 0, 40)));
  EXPECT_FALSE(s.undo.canRedo());
  EXPECT_EQ(s.undo.names().size(), 1u);
}

TEST(UndoStack, LeavesEverythingAsItWasWhenACommandThrows) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 40)));
  const DocumentState before = s.document.state();
  const Command half = combined("Half", {resetPose(), moveHandles({HandleId{-1}}, row(0, 0, 0))});
  EXPECT_THROW(s.undo.perform(half), UsageError);
  EXPECT_EQ(s.document.state(), before);
  EXPECT_EQ(s.undo.names().size(), 1u);
}

TEST(UndoStack, DoesACombinedCommandAsOneStep) {
  Session s;
  s.undo.perform(combined("Both", {moveHandles({s.handle(8)}, row(1, 0, 40)), setParameter("locality", 2)}));
  EXPECT_EQ(s.undo.undoName().english(), "Both");
  s.undo.undo();
  EXPECT_TRUE(atRest(s.document.state()));
  EXPECT_TRUE(s.document.system().parameters.all().empty());
}

TEST(UndoStack, NeverGivesAnIdTwice) {
  Session s;
  s.undo.perform(addHandles({{Vec3(1, 2, 70)}}));
  const HandleId first = s.document.rig().handles.back().id;
  s.undo.undo();
  s.undo.perform(addHandles({{Vec3(1, 2, 71)}}));
  EXPECT_NE(s.document.rig().handles.back().id, first);
}

TEST(UndoStack, KeepsIdsOfALoadedDocumentApartFromNewOnes) {
  Session loaded;
  Document document;
  UndoStack undo(document);
  undo.reset(loaded.document.state());
  undo.perform(addHandles({{Vec3(1, 2, 70)}}));
  const HandleId added = document.rig().handles.back().id;
  EXPECT_GT(added.value, loaded.document.rig().handles.back().id.value);
  EXPECT_EQ(document.rig().indexOf(added), 10);
}

TEST(UndoStack, TellsObserversOfADragThatMoreFollowsAndThenThatItEnded) {
  Session s;
  std::vector<bool> interactive;
  std::vector<bool> posed;
  const Subscription subscription = s.document.onChange([&](const Change& change) {
    interactive.push_back(change.interactive);
    posed.push_back(change.pose());
    EXPECT_FALSE(change.organs() || change.rig() || change.system());
  });
  UndoStack::Step step(s.undo, "Drag");
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 40)));
  s.undo.perform(moveHandles({s.handle(8)}, row(2, 0, 40)));
  step.finish();
  EXPECT_EQ(interactive, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(posed, (std::vector<bool>{true, true, false}));
}

TEST(UndoStack, StopsTellingWhenTheSubscriptionEnds) {
  Session s;
  int calls = 0;
  {
    const Subscription subscription = s.undo.onChange([&calls] { ++calls; });
    s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 40)));
  }
  EXPECT_EQ(calls, 1);
  s.undo.undo();
  EXPECT_EQ(calls, 1);
}

TEST(UndoStack, GoesToAnyStepAndTellsOnce) {
  Session s;
  std::vector<DocumentState> states = {s.document.state()};
  for (int i = 1; i <= 5; ++i) {
    s.undo.perform(moveHandles({s.handle(8)}, row(i, 0, 40)));
    states.push_back(s.document.state());
  }
  int calls = 0;
  const Subscription subscription = s.document.onChange([&calls](const Change&) { ++calls; });
  for (const std::size_t step : {2u, 5u, 0u, 3u}) {
    s.undo.goTo(step);
    EXPECT_TRUE(s.document.state() == states[step]) << step;
    EXPECT_EQ(s.undo.position(), step);
  }
  EXPECT_EQ(calls, 4);
  s.undo.goTo(3);
  s.undo.goTo(99);
  EXPECT_EQ(calls, 4) << "there is nowhere to go";
  EXPECT_EQ(s.undo.redoName().english(), "Move handle");
}

TEST(UndoStack, ForgetsTheOldestStepsBeyondItsMemoryAndKeepsTheLast) {
  Document document;
  UndoStack undo(document, 200000);
  undo.perform(addHandles(tests::cubeHandles()));
  for (int i = 0; i < 40; ++i) // Each a surface of 26 kB.
    undo.perform(addOrgans({tests::ball("Ball", 10, 3)}));
  EXPECT_LT(undo.names().size(), 12u);
  EXPECT_GT(undo.names().size(), 4u);
  EXPECT_EQ(undo.position(), undo.names().size());
  const auto steps = undo.position();
  while (undo.canUndo())
    undo.undo();
  EXPECT_EQ(document.organs().size(), 40 - steps) << "what is forgotten stays done";
  undo.perform(addOrgans({tests::ball("Large", 10, 6)})); // More than the memory by itself.
  EXPECT_EQ(inEnglish(undo.names()), std::vector<std::string>{"Add Large"});
  undo.undo();
  EXPECT_EQ(document.organs().size(), 40 - steps);
}

TEST(UndoStack, CountsTheVoxelsOfScansThatItAloneKeeps) {
  const auto scan = [](const Vec3& place) {
    return scanItem(tests::phantomScan({32, 32, 32}, Vec3::Ones(), place, tests::slope), {}); // 66 kB.
  };
  Document document;
  UndoStack undo(document, 220000);
  for (int i = 0; i < 20; ++i)
    undo.perform(openScan(scan({double(i), 0, 0})));
  EXPECT_EQ(undo.names().size(), 3u);
  Document other;
  UndoStack small(other, 50000);
  small.perform(addHandles(tests::cubeHandles()));
  small.perform(openScan(scan(Vec3::Zero())));
  small.perform(addHandles({{Vec3(-35, 1, 2)}}));
  EXPECT_EQ(small.names().size(), 3u) << "the scan is the document's";
  small.perform(closeScan());
  EXPECT_EQ(small.names().size(), 1u);
}

TEST(UndoStack, AnOrganThatStaysCostsAStepNextToNothing) {
  Document document;
  UndoStack undo(document, 4000000);
  undo.perform(addOrgans({tests::ball("Large", 10, 6)})); // About 1.5 MB.
  const OrganId organ = document.organs().front()->id;
  for (int i = 0; i < 500; ++i) {
    undo.perform(setOrganLook(organ, {{i / 500.0, 0, 0}}));
    undo.seal();
  }
  EXPECT_EQ(undo.names().size(), 501u);
}

TEST(UndoStack, RemembersTheStateThatWasSavedWhileWorkWentOn) {
  Session s;
  s.undo.perform(moveHandles({s.handle(8)}, row(1, 0, 40)));
  const DocumentState saved = s.document.state();
  s.undo.perform(moveHandles({s.handle(8)}, row(2, 0, 40)));
  s.undo.markSaved(saved);
  EXPECT_FALSE(s.undo.isClean());
  s.undo.undo();
  EXPECT_TRUE(s.undo.isClean());
  s.undo.markUnsaved();
  EXPECT_FALSE(s.undo.isClean());
}

TEST(UndoStack, KeepsEveryUntouchedStateCleanUntilTheNextSave) {
  Session s;
  s.undo.perform(setParameter("locality", 1));
  s.undo.markUntouched();
  s.undo.perform(setParameter("locality", 2));
  EXPECT_FALSE(s.undo.isClean());
  s.undo.undo();
  EXPECT_TRUE(s.undo.isClean());
  s.undo.undo();
  EXPECT_TRUE(s.undo.isClean());
  s.undo.redo();
  s.undo.redo();
  s.undo.markSaved();
  s.undo.undo();
  EXPECT_FALSE(s.undo.isClean()) << "the file holds another state";
}

} // namespace
} // namespace viscera::document
