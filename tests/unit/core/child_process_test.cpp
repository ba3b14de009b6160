#include "viscera/core/child_process.h"

#include <cerrno>
#include <csignal>

#include <gtest/gtest.h>
#include <unistd.h>

namespace viscera {
namespace {

std::vector<char> bytes(const std::string& text) {
  return {text.begin(), text.end()};
}

TEST(ChildProcess, AnswersItsInput) {
  Progress progress;
  const ChildResult result = runChild("/bin/cat", bytes(std::string(3'000'000, 'x')), {}, progress);
  EXPECT_EQ(result.end, ChildResult::End::exited);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.output, bytes(std::string(3'000'000, 'x')));
}

TEST(ChildProcess, SaysWhyAProgramCannotBeStarted) {
  Progress progress;
  const ChildResult result = runChild("/no/such/program", {}, {}, progress);
  EXPECT_EQ(result.end, ChildResult::End::notStarted);
  EXPECT_EQ(result.code, ENOENT);
}

TEST(ChildProcess, IsFoundInThePathAndKeepsItsMessages) {
  ChildProcess child({"sh", "-c", "echo first >&2; echo second >&2; exit 3"}, STDIN_FILENO, -1);
  ASSERT_EQ(child.startError(), 0);
  ChildResult result;
  EXPECT_TRUE(child.ended(result, true));
  EXPECT_EQ(result.end, ChildResult::End::exited);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(child.messages(100), "first\nsecond\n");
  EXPECT_EQ(child.messages(5), "first");
}

TEST(ChildProcess, KeepsItsMessagesInMemoryAndNotInAFolderThatMayBeFull) {
  ChildProcess child({"sh", "-c", "readlink /proc/self/fd/2 >&2"}, STDIN_FILENO, -1);
  ASSERT_EQ(child.startError(), 0);
  ChildResult result;
  EXPECT_TRUE(child.ended(result, true));
  EXPECT_EQ(child.messages(100).rfind("/memfd:", 0), 0u) << child.messages(100);
}

TEST(ChildProcess, WritesNoMoreMessagesThanItMay) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  ChildProcess child({"sh", "-c", "read line; exec yes >&2"}, ends[0], -1);
  child.limit({});
  ASSERT_EQ(write(ends[1], "\n", 1), 1); // Not before: the limits come after the start.
  ChildResult result;
  EXPECT_TRUE(child.ended(result, true));
  EXPECT_EQ(child.messages(std::size_t{8} << 20).size(), std::size_t{1} << 20);
  close(ends[0]);
  close(ends[1]);
}

TEST(ChildProcess, IsEndedWithAllOfItsGroupWhenItGoes) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    const ChildProcess child({"sh", "-c", "sleep 600 & sleep 600"}, STDIN_FILENO, ends[1]);
    ASSERT_EQ(child.startError(), 0);
    close(ends[1]);
  }
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0) << "nobody holds the other end any more";
  close(ends[0]);
}

TEST(ChildProcess, EndsAtItsTimeLimit) {
  Progress progress;
  const ChildResult result = runChild("/usr/bin/yes", {}, {0.2, std::uint64_t{2} << 30}, progress);
  EXPECT_TRUE(result.end == ChildResult::End::timeLimit || result.end == ChildResult::End::outputLimit);
}

} // namespace
} // namespace viscera
