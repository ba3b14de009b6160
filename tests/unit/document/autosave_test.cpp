#include "viscera/document/autosave.h"

#include <fstream>

#include <gtest/gtest.h>

#include "session_scene.h"

namespace viscera::document {
namespace {

using viscera::tests::TemporaryFolder;

struct Program {
  explicit Program(const TemporaryFolder& folder)
      : autosave(folder / "state", box.post(), [this] { return now; }) {}

  /// Writes as the window does, and waits for it.
  std::shared_ptr<const Error> write(const SessionContents& contents) {
    bool done = false;
    std::shared_ptr<const Error> problem;
    autosave.write(contents, [&](std::shared_ptr<const Error> error) {
      problem = std::move(error);
      done = true;
    });
    box.runUntil([&] { return done; });
    return problem;
  }

  double now = 100;
  ManualEventLoop box;
  Autosave autosave;
};

SessionContents someContents() {
  tests::Session s;
  SessionContents contents;
  contents.state = s.document.state();
  contents.recovers = "/home/somebody/liver.viscera";
  return contents;
}

TEST(Autosave, IsDueAMinuteAfterTheFirstChangeAndNotBefore) {
  TemporaryFolder folder;
  Program program(folder);
  program.now = 1000;
  EXPECT_FALSE(program.autosave.due());
  program.autosave.changed();
  program.now += 30;
  program.autosave.changed(); // Somebody who goes on working does not put it off.
  EXPECT_FALSE(program.autosave.due());
  program.now += 30;
  EXPECT_TRUE(program.autosave.due());
  program.write(someContents());
  EXPECT_FALSE(program.autosave.due());
}

TEST(Autosave, IsNotFoundWhileItsProgramRunsAndFoundWhenThatIsGone) {
  TemporaryFolder folder;
  const SessionContents contents = someContents();
  {
    Program program(folder);
    EXPECT_EQ(program.write(contents), nullptr);
    EXPECT_TRUE(findRecoveries(folder / "state").empty());
  }
  const auto found = findRecoveries(folder / "state");
  ASSERT_EQ(found.size(), 1u);
  const OpenedSession opened = tests::readBack(found[0].file);
  EXPECT_TRUE(identical(opened.contents.state, contents.state));
  EXPECT_EQ(opened.contents.recovers, contents.recovers);
  EXPECT_TRUE(findRecoveries(folder / "state").empty()) << "two programs are offered one recovery";
}

TEST(Autosave, OfTwoProgramsAreTwoFiles) {
  TemporaryFolder folder;
  {
    Program one(folder), other(folder);
    one.write(someContents());
    other.write(someContents());
    EXPECT_NE(one.autosave.file(), other.autosave.file());
  }
  EXPECT_EQ(findRecoveries(folder / "state").size(), 2u);
}

TEST(Autosave, LeavesNothingAfterACleanEnd) {
  TemporaryFolder folder;
  {
    Program program(folder);
    program.write(someContents());
    program.autosave.write(someContents()); // One that is still on its way.
    program.autosave.clear();
    EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
}

TEST(Autosave, ARecoveryThatWasTakenIsThisProgramsFileNow) {
  TemporaryFolder folder;
  { Program(folder).write(someContents()); }
  {
    Program program(folder);
    const auto found = findRecoveries(folder / "state");
    ASSERT_EQ(found.size(), 1u);
    program.autosave.adopt(found[0]);
    EXPECT_EQ(program.autosave.file(), found[0].file);
  }
  ASSERT_EQ(findRecoveries(folder / "state").size(), 1u) << "it is lost when the next program dies too";
  Program program(folder);
  program.autosave.adopt(findRecoveries(folder / "state").front());
  program.autosave.clear();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
}

TEST(Autosave, RemovesWhatInterruptedWritesLeft) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "state");
  folder.put("state/recovery-1-2.lock", "");
  folder.put("state/.99-recovery-1-2.viscera", "{\"format\": \"visc");
  EXPECT_TRUE(findRecoveries(folder / "state").empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
}

TEST(Autosave, SaysWhenItsFolderCannotBeMade) {
  TemporaryFolder folder;
  folder.put("state", "a file");
  Program program(folder);
  const auto problem = program.write(someContents());
  ASSERT_NE(problem, nullptr);
  EXPECT_EQ(problem->exitCode(), 73);
}

TEST(Autosave, DiscardedIsGone) {
  TemporaryFolder folder;
  { Program(folder).write(someContents()); }
  for (const Recovery& recovery : findRecoveries(folder / "state"))
    discard(recovery);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
}

} // namespace
} // namespace viscera::document
