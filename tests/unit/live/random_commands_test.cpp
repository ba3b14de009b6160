#include <map>

#include <gtest/gtest.h>

#include "monkey.h"
#include "session_fixture.h"
#include "viscera/core/error.h"

/// Whatever somebody does, going back and forth has to restore it to the last bit. A seeded monkey does 500
/// things.
namespace viscera::live {
namespace {

using tests::Session;

using tests::Monkey;

class RandomCommands : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomCommands, AreTakenBackAndDoneAgainToTheLastBit) {
  Session s;
  const document::DocumentState begin = s.document.state();
  std::map<std::size_t, document::DocumentState> seen; // The state at each number of steps.
  Monkey monkey(s, GetParam());
  for (int i = 0; i < 500; ++i) {
    monkey.act();
    seen[s.undo.position()] = s.document.state();
  }
  EXPECT_GT(s.undo.position(), 200u) << "the monkey did next to nothing";
  EXPECT_GT(monkey.refused(), 0) << "nothing was refused";
  while (s.undo.canRedo())
    s.undo.redo();
  const document::DocumentState end = s.document.state();

  while (s.undo.canUndo()) {
    s.undo.undo();
    if (s.undo.position() > 0) {
      ASSERT_TRUE(identical(s.document.state(), seen.at(s.undo.position()))) << "step " << s.undo.position();
    }
  }
  EXPECT_EQ(s.undo.position(), 0u);
  EXPECT_TRUE(identical(s.document.state(), begin));
  EXPECT_TRUE(s.undo.isClean());

  while (s.undo.canRedo())
    s.undo.redo();
  EXPECT_TRUE(identical(s.document.state(), end));
}

TEST_P(RandomCommands, GiveTheSameDocumentTwice) {
  Session a, b;
  Monkey first(a, GetParam()), second(b, GetParam());
  for (int i = 0; i < 100; ++i) {
    first.act();
    second.act();
  }
  EXPECT_TRUE(identical(a.document.state(), b.document.state()));
}

TEST_P(RandomCommands, KeepThePoseAndTheGroupsInStepWithTheRig) {
  Session s;
  Monkey monkey(s, GetParam());
  for (int i = 0; i < 200; ++i) {
    monkey.act();
    const document::Rig& rig = s.document.rig();
    ASSERT_EQ(s.document.pose().rows(), static_cast<Eigen::Index>(rig.handles.size()));
    ASSERT_TRUE(s.document.pose().allFinite());
    for (const document::Group& group : rig.groups)
      for (const document::HandleId id : group.handles)
        ASSERT_GE(rig.indexOf(id), 0) << group.name;
    for (const document::CageTriangle& triangle : rig.cage)
      for (const document::HandleId id : triangle)
        ASSERT_GE(rig.indexOf(id), 0) << "a corner of the cage";
    for (const auto& organ : s.document.organs())
      ASSERT_TRUE(!organ->parent || s.document.organ(organ->parent));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCommands, ::testing::Values(1u, 2u, 3u, 4u, 5u));

} // namespace
} // namespace viscera::live
