#include <map>
#include <random>

#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"

/// Whatever somebody does, going back and forth has to restore it to the last bit. A seeded monkey does 500
/// things.
namespace viscera::session {
namespace {

using tests::Session;

class Monkey {
public:
  Monkey(Session& session, unsigned seed) : s_(session), random_(seed) {}

  /// Does one thing: a command, perhaps one that is refused, a drag, a step back or forth.
  void act() {
    switch (number(12)) {
    case 0:
      drag();
      break;
    case 1:
      s_.undo.undo();
      break;
    case 2:
      s_.undo.redo();
      break;
    default:
      attempt(anyCommand());
    }
    if (number(8) == 0)
      s_.undo.seal();
  }

  int refused() const { return refused_; }

private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 place() { return {real(-90, 90), real(-90, 90), real(-90, 90)}; }
  Vec3 color() { return {real(0, 1), real(0, 1), real(0, 1)}; }

  void attempt(const Command& command) {
    const DocumentState before = s_.document.state();
    try {
      s_.undo.perform(command);
    } catch (const Error&) {
      ++refused_;
      EXPECT_EQ(s_.document.state(), before) << command.name << " was refused and left a trace";
    }
  }

  void drag() {
    s_.undo.beginStep("Drag");
    const auto handles = someHandles();
    for (int i = 0; i < 5; ++i)
      attempt(moveHandles(handles, places(handles.size())));
    number(4) == 0 ? s_.undo.cancelStep() : s_.undo.endStep();
  }

  Points places(std::size_t count) {
    Points out(static_cast<Eigen::Index>(count), 3);
    for (Eigen::Index i = 0; i < out.rows(); ++i)
      out.row(i) = place().transpose();
    return out;
  }

  std::vector<HandleId> someHandles() {
    std::vector<HandleId> out;
    for (const Handle& handle : s_.document.rig().handles)
      if (number(4) == 0)
        out.push_back(handle.id);
    return out;
  }

  /// One that is there, or one that is not.
  template <class AnyId, class List, class IdOf>
  AnyId pick(const List& list, IdOf idOf) {
    const int index = number(static_cast<int>(list.size()) + 1);
    return index < static_cast<int>(list.size()) ? idOf(list[static_cast<std::size_t>(index)])
                                                 : AnyId{12345678};
  }
  OrganId anOrgan() {
    return pick<OrganId>(s_.document.organs(), [](const auto& organ) { return organ->id; });
  }
  GroupId aGroup() {
    return pick<GroupId>(s_.document.rig().groups, [](const Group& group) { return group.id; });
  }

  Command anyCommand() {
    const std::string text = "T" + std::to_string(number(12));
    switch (number(19)) {
    case 0:
      return addOrgans({tests::ball(text, real(5, 40), 1, place())});
    case 1:
      return removeOrgans({anOrgan()});
    case 2:
      return setOrganLook(anOrgan(), {color(), number(2) == 0, real(0, 1), number(2) == 0, number(2) == 0});
    case 3:
      return renameOrgan(anOrgan(), text);
    case 4:
      return addHandles(newHandles(places(static_cast<std::size_t>(1 + number(4)))));
    case 5:
      return removeHandles(someHandles());
    case 6:
      return restMove();
    case 7:
      return replaceRig({newHandles(places(12)), {{text, color(), {0, 3, 5}}}});
    case 8:
      return editHandles(someHandles(), {std::nullopt, text, number(2) == 0, number(2) == 0, number(2) == 0});
    case 9:
      return addGroup(text, color(), someHandles());
    case 10:
      return number(4) == 0 ? removeGroup(aGroup())
                            : editGroup(aGroup(), {std::nullopt, color(), std::nullopt});
    case 11:
      return addToGroup(aGroup(), someHandles());
    case 12:
      return removeFromGroup(aGroup(), someHandles());
    case 13:
      return number(2) == 0 ? resetPose() : resetHandles(someHandles());
    case 14:
      return setSystem({number(2) == 0 ? "s-celestial" : "t-celestial", {}});
    case 15:
      return setParameter("locality", real(0, 3));
    case 16:
      return setVolumeLocked(anOrgan(), number(2) == 0);
    case 17:
      return closeHoles(anOrgan());
    default:
      return poseMove();
    }
  }

  Command restMove() {
    const auto handles = someHandles();
    return moveRestHandles(handles, places(handles.size()));
  }
  Command poseMove() {
    const auto handles = someHandles();
    return moveHandles(handles, places(handles.size()));
  }

  Session& s_;
  std::mt19937 random_;
  int refused_ = 0;
};

class RandomCommands : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomCommands, AreTakenBackAndDoneAgainToTheLastBit) {
  Session s;
  const DocumentState begin = s.document.state();
  std::map<std::size_t, DocumentState> seen; // The state at each number of steps.
  Monkey monkey(s, GetParam());
  for (int i = 0; i < 500; ++i) {
    monkey.act();
    seen[s.undo.position()] = s.document.state();
  }
  EXPECT_GT(s.undo.position(), 200u) << "the monkey did next to nothing";
  EXPECT_GT(monkey.refused(), 0) << "nothing was refused";
  while (s.undo.canRedo())
    s.undo.redo();
  const DocumentState end = s.document.state();

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
    const Rig& rig = s.document.rig();
    ASSERT_EQ(s.document.pose().rows(), static_cast<Eigen::Index>(rig.handles.size()));
    ASSERT_TRUE(s.document.pose().allFinite());
    for (const Group& group : rig.groups)
      for (const HandleId id : group.handles)
        ASSERT_GE(rig.indexOf(id), 0) << group.name;
    for (const auto& organ : s.document.organs())
      ASSERT_TRUE(!organ->parent || s.document.organ(organ->parent));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCommands, ::testing::Values(1u, 2u, 3u, 4u, 5u));

} // namespace
} // namespace viscera::session
