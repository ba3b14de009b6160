#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "session_scene.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/document/autosave.h"

/// Programs that are killed while they save, and disks with no room: the old session or the new one is there,
/// never a third thing.
namespace viscera::document {
namespace {

using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

constexpr int kKills = 200;

/// Two sessions of some hundred kilobytes that differ.
struct TwoSessions {
  TwoSessions() {
    tests::Session s;
    s.undo.perform(addOrgans({tests::ball("Large", 30, 5)}));
    a.state = s.document.state();
    s.undo.perform(moveHandles({s.handle(8)}, tests::row(1, 2, 41)));
    s.undo.perform(addOrgans({tests::ball("Another", 20, 5)}));
    b.state = s.document.state();
  }

  /// "a", "b", or "" for a third thing.
  std::string which(const DocumentState& state) const {
    return identical(state, a.state) ? "a" : identical(state, b.state) ? "b" : "";
  }

  SessionContents a, b;
};

/// Runs `work` in a program of its own.
pid_t inChild(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child != 0)
    return child;
  work();
  ::_exit(0);
}

/// Calls `work` again and again in a program of its own, and kills that some time after the first one.
void killWhileItRepeats(const std::function<void()>& work, std::chrono::microseconds delay) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = inChild([&] {
    for (bool first = true;; first = false) {
      work();
      if (first && ::write(ends[1], "1", 1) != 1)
        ::_exit(1);
    }
  });
  ::close(ends[1]); // A child that ends by itself is noticed.
  char ready = 0;
  ASSERT_EQ(::read(ends[0], &ready, 1), 1);
  ::close(ends[0]);
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << "the program ended by itself";
}

std::chrono::microseconds anyDelay(std::mt19937& random) {
  return std::chrono::microseconds(std::uniform_int_distribution<int>(500, 60000)(random));
}

int leftoversIn(const std::filesystem::path& folder) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    count += entry.path().filename().string().starts_with('.');
  return count;
}

TEST(KilledSaves, LeaveTheOldSessionOrTheNewOne) {
  const TemporaryFolder folder;
  const TwoSessions two;
  const auto file = folder / "work.viscera";
  tests::write(file, two.a);
  std::mt19937 random(20);
  std::map<std::string, int> seen;
  int killedWhileWriting = 0;
  for (int i = 0; i < kKills; ++i) {
    killWhileItRepeats(
        [&, next = i % 2 == 0]() mutable {
          tests::write(file, next ? two.b : two.a);
          next = !next;
        },
        anyDelay(random));
    ++seen[two.which(tests::readBack(file).contents.state)];
    const int leftovers = leftoversIn(folder.path());
    ASSERT_LE(leftovers, 1) << "the save after a kill left what that had left";
    killedWhileWriting += leftovers;
  }
  EXPECT_EQ(seen[""], 0);
  EXPECT_GT(seen["a"], 10);
  EXPECT_GT(seen["b"], 10);
  EXPECT_GT(killedWhileWriting, kKills / 10) << "hardly any program was killed while it wrote";
}

TEST(KilledSaves, ASaveRemovesWhatAKilledOneLeftButNotWhatALivingOneWrites) {
  const TemporaryFolder folder;
  const TwoSessions two;
  const auto file = folder / "work.viscera";
  tests::write(file, two.a);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const auto stopsWhileItWrites = [&] {
    writeAtomically(file, [&](std::ostream& stream) {
      stream << "half of it" << std::flush;
      if (::write(ends[1], "1", 1) != 1)
        ::_exit(1);
      for (;;)
        ::pause();
    });
  };
  const pid_t killed = inChild(stopsWhileItWrites);
  const pid_t living = inChild(stopsWhileItWrites);
  for (int i = 0; i < 2; ++i) {
    char ready = 0;
    ASSERT_EQ(::read(ends[0], &ready, 1), 1);
  }
  tests::write(file, two.b);
  EXPECT_EQ(leftoversIn(folder.path()), 2) << "both programs live";
  ::kill(killed, SIGKILL);
  ::waitpid(killed, nullptr, 0);
  EXPECT_EQ(leftoversIn(folder.path()), 2);
  tests::write(file, two.a);
  EXPECT_EQ(leftoversIn(folder.path()), 1);
  ::kill(living, SIGKILL);
  ::waitpid(living, nullptr, 0);
  tests::write(file, two.b);
  EXPECT_EQ(leftoversIn(folder.path()), 0);
  EXPECT_EQ(two.which(tests::readBack(file).contents.state), "b");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(KilledSaves, LeaveTheOldRecoveryOrTheNewOne) {
  const TemporaryFolder folder;
  const TwoSessions two;
  std::mt19937 random(21);
  std::map<std::string, int> seen;
  for (int i = 0; i < kKills; ++i) {
    std::unique_ptr<ManualEventLoop> box; // Its thread has to be the other program's.
    std::unique_ptr<Autosave> autosave;
    killWhileItRepeats(
        [&, next = i % 2 == 0]() mutable {
          if (!box) {
            box = std::make_unique<ManualEventLoop>();
            autosave = std::make_unique<Autosave>(folder / "state", box->post(), [] { return 0.0; });
          }
          bool done = false;
          autosave->write(next ? two.b : two.a, [&](const auto&) { done = true; });
          box->runUntil([&] { return done; });
          next = !next;
        },
        anyDelay(random));
    const auto found = findRecoveries(folder / "state");
    ASSERT_EQ(found.size(), 1u);
    ++seen[two.which(tests::readBack(found[0].file).contents.state)];
    discard(found[0]);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "state"));
  }
  EXPECT_EQ(seen[""], 0);
  EXPECT_GT(seen["a"], 10);
  EXPECT_GT(seen["b"], 10);
}

/// Saves over a session and says how that ended: 0, or the exit code of the error.
int saveOver(const std::filesystem::path& file, const SessionContents& contents) {
  try {
    tests::write(file, contents);
    return 0;
  } catch (const Error& error) {
    const bool says = std::string(error.what()).find(file.filename().string()) != std::string::npos &&
                      !error.tryThis().empty();
    return says ? error.exitCode() : 1;
  }
}

TEST(FullDisk, ASaveThatFindsNoRoomSaysSoAndLeavesTheOldSession) {
  const TemporaryFolder folder;
  const TwoSessions two;
  tests::Session small;
  SessionContents old;
  old.state = small.document.state();
  const auto file = folder / "work.viscera";
  tests::write(file, old);
  const std::string before = contentsOf(file);
  const pid_t child = inChild([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100000, 100000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(saveOver(file, two.b));
  });
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 73);
  EXPECT_TRUE(contentsOf(file) == before) << "the old session is gone";
  EXPECT_EQ(leftoversIn(folder.path()), 0);
}

TEST(FullDisk, AnAutosaveThatFindsNoRoomSaysSoAndKeepsTheOldRecovery) {
  const TemporaryFolder folder;
  const TwoSessions two;
  // In a program of its own, which is killed: one that ends by itself takes its recovery along.
  const auto said = folder / "said";
  const pid_t child = inChild([&] {
    ManualEventLoop box;
    Autosave autosave(folder / "state", box.post(), [] { return 0.0; });
    const auto save = [&](const SessionContents& contents) {
      std::optional<std::string> outcome;
      autosave.write(contents, [&](const std::shared_ptr<const Error>& error) {
        outcome = error ? error->tryThis().english() : std::string();
      });
      box.runUntil([&] { return outcome.has_value(); });
      return *outcome;
    };
    std::string outcomes = save(two.a) + "|";
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit full{20000, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
    outcomes += save(two.b);
    std::ofstream(said) << outcomes;
    ::kill(::getpid(), SIGKILL);
  });
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const std::string outcomes = contentsOf(said);
  EXPECT_TRUE(outcomes.starts_with('|')) << "the first found room: " << outcomes;
  EXPECT_GT(outcomes.size(), 1u) << "the second said nothing";
  const auto found = findRecoveries(folder / "state");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(two.which(tests::readBack(found[0].file).contents.state), "a");
}

TEST(FullDisk, ASmallDiskThatIsFullKeepsTheOldSession) {
  const TemporaryFolder folder;
  const auto disk = folder / "disk";
  std::filesystem::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "a disk may not be mounted here";
  const TwoSessions two;
  tests::Session small;
  SessionContents old;
  old.state = small.document.state();
  const auto file = disk / "work.viscera";
  tests::write(file, old);
  const std::string before = contentsOf(file);
  EXPECT_EQ(saveOver(file, two.b), 73);
  EXPECT_TRUE(contentsOf(file) == before) << "the old session is gone";
  EXPECT_EQ(leftoversIn(disk), 0);
  EXPECT_EQ(saveOver(file, old), 0) << "there is room again";
  ::umount(disk.c_str());
}

} // namespace
} // namespace viscera::document
