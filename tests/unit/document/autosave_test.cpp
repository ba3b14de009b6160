#include "viscera/document/autosave.h"

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "session_scene.h"
#include "viscera/document/scan_item.h"

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

/// Of no file, so that a session holds it; without a pattern that would pack fast.
ScanItem scanThatTakesLongToPack() {
  medical_io::Scan scan;
  scan.size = {256, 256, 256};
  std::vector<std::int16_t> samples(std::size_t{256} * 256 * 256);
  std::minstd_rand noise(1);
  for (std::int16_t& sample : samples)
    sample = static_cast<std::int16_t>(noise());
  scan.samples = std::move(samples);
  return scanItem(std::move(scan), {});
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
    program.autosave.clear();
    EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
    program.autosave.write(someContents());
    program.autosave.clear(); // While it is on its way.
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
}

TEST(Autosave, IsClearedWithoutAWaitForWhatIsBeingWritten) {
  TemporaryFolder folder;
  SessionContents contents = someContents();
  contents.state.scan = std::make_shared<const ScanItem>(scanThatTakesLongToPack());
  Program program(folder);
  program.autosave.write(contents);
  const auto begun = [&] {
    return std::filesystem::exists(folder / "state") && !std::filesystem::is_empty(folder / "state");
  };
  program.box.runUntil(begun);
  std::this_thread::sleep_for(std::chrono::milliseconds(50)); // It packs by now, which takes a second.
  program.autosave.clear();
  EXPECT_FALSE(std::filesystem::is_empty(folder / "state")) << "clear() waited for the write";
  EXPECT_EQ(program.autosave.file(), "") << "the next change has a file of its own";
  program.box.runUntil([&] { return std::filesystem::is_empty(folder / "state"); });
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
