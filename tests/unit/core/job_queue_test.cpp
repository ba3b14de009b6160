#include "viscera/core/job_queue.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace viscera {
namespace {

using ::testing::HasSubstr;

/// Lets a job wait for the test, so that nothing depends on who is faster.
class Gate {
public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void arrive() {
    const std::lock_guard lock(mutex_);
    arrived_ = true;
    changed_.notify_all();
  }
  void waitUntilOpen() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return open_; });
  }
  void waitUntilArrived() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return arrived_; });
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  bool arrived_ = false;
};

/// Works until it is cancelled.
int forever(Progress& progress) {
  for (;;) {
    progress.throwIfCancelled();
    std::this_thread::yield();
  }
}

struct Queue {
  ManualEventLoop box;
  JobQueue jobs{box.post()};
  void finishAll() {
    box.runUntil([this] { return jobs.idle(); });
    box.run();
  }
};

TEST(JobQueue, BringsTheValueToTheThreadThatAsked) {
  Queue q;
  std::thread::id worker, receiver;
  int value = 0;
  q.jobs.submit<int>(
      "Answer", "",
      [&](Progress&) {
        worker = std::this_thread::get_id();
        return 42;
      },
      [&](JobResult<int> result) {
        receiver = std::this_thread::get_id();
        value = result.value.value();
      });
  ASSERT_EQ(q.jobs.jobs().size(), 1u);
  EXPECT_EQ(q.jobs.jobs()[0].name.english(), "Answer");
  q.finishAll();
  EXPECT_EQ(value, 42);
  EXPECT_EQ(receiver, std::this_thread::get_id());
  EXPECT_NE(worker, receiver);
}

TEST(JobQueue, TurnsExceptionsIntoResults) {
  Queue q;
  std::vector<std::shared_ptr<const Error>> errors;
  const auto keep = [&](JobResult<int> result) {
    EXPECT_FALSE(result.value);
    EXPECT_FALSE(result.cancelled());
    errors.push_back(result.error);
  };
  q.jobs.submit<int>(
      "a", "", [](Progress&) -> int { throw DataError("Broken", "file.stl", "another one"); }, keep);
  q.jobs.submit<int>(
      "b", "", [](Progress&) -> int { throw std::runtime_error("odd"); }, keep);
  q.jobs.submit<int>(
      "c", "", [](Progress&) -> int { throw 7; }, keep);
  q.jobs.submit<int>(
      "d", "", [](Progress&) -> int { throw std::bad_alloc(); }, keep);
  q.finishAll();
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_EQ(errors[0]->exitCode(), 65);
  EXPECT_EQ(errors[0]->where().english(), "file.stl");
  EXPECT_EQ(errors[1]->exitCode(), 70);
  EXPECT_THAT(errors[1]->what(), HasSubstr("odd"));
  EXPECT_EQ(errors[2]->exitCode(), 70);
  EXPECT_THAT(errors[3]->what(), HasSubstr("memory"));
}

TEST(JobQueue, BringsItsResultWhenThereWasNoMemoryToPostItAtFirst) {
  ManualEventLoop box;
  std::atomic<int> refusals{3}; // Of the notice that the job has begun, then of the result.
  JobQueue jobs([post = box.post(), &refusals](std::function<void()> function) {
    if (refusals-- > 0)
      throw std::bad_alloc();
    post(std::move(function));
  });
  std::shared_ptr<const Error> error;
  jobs.submit<int>(
      "Large", "", [](Progress&) -> int { throw std::bad_alloc(); },
      [&error](const JobResult<int>& result) { error = result.error; });
  box.runUntil([&jobs] { return jobs.idle(); });
  ASSERT_NE(error, nullptr);
  EXPECT_STREQ(error->what(), notEnoughMemory().what());
}

TEST(JobQueue, CancelsAJobThatRunsAndOneThatWaits) {
  Queue q;
  int cancelled = 0;
  const auto count = [&](JobResult<int> result) { cancelled += result.cancelled(); };
  const auto running = q.jobs.submit<int>("Runs", "", forever, count);
  bool ran = false;
  const auto waiting = q.jobs.submit<int>(
      "Waits", "",
      [&ran](Progress&) {
        ran = true;
        return 1;
      },
      count);
  q.box.runUntil([&] { return q.jobs.jobs()[0].running; });
  q.jobs.cancel(waiting);
  EXPECT_EQ(q.jobs.jobs().size(), 1u) << "a cancelled job is no news for the status bar";
  q.jobs.cancel(running);
  q.box.runUntil([&] { return cancelled == 2; });
  EXPECT_FALSE(ran);
}

TEST(JobQueue, ThrowsAnOldValueAwayWhenANewerOneOfItsSlotWasAskedFor) {
  Queue q;
  Gate first;
  std::vector<std::string> story;
  const auto tell = [&story](const std::string& name) {
    return [&story, name](JobResult<int> result) {
      story.push_back(name + (result.cancelled() ? " cancelled" : " " + std::to_string(*result.value)));
    };
  };
  // This one does not look whether it is cancelled: it brings a value in the end.
  q.jobs.submit<int>(
      "old", "slot",
      [&first](Progress&) {
        first.arrive();
        first.waitUntilOpen();
        return 1;
      },
      tell("old"));
  first.waitUntilArrived();
  for (int i = 2; i <= 5; ++i)
    q.jobs.submit<int>(
        "job", "slot", [i](Progress&) { return i; }, tell("job " + std::to_string(i)));
  q.jobs.submit<int>(
      "other", "another slot", [](Progress&) { return 9; }, tell("other"));
  first.open();
  q.box.runUntil([&] { return story.size() == 6; });
  EXPECT_THAT(story, ::testing::UnorderedElementsAre("old cancelled", "job 2 cancelled", "job 3 cancelled",
                                                     "job 4 cancelled", "job 5 5", "other 9"));
}

TEST(JobQueue, ThrowsAValueAwayThatIsReadyButNotDelivered) {
  Queue q;
  std::vector<int> values;
  const auto keep = [&values](JobResult<int> result) { values.push_back(result.value.value_or(-1)); };
  Gate done;
  q.jobs.submit<int>(
      "old", "slot", [](Progress&) { return 1; }, keep);
  // One worker: when this runs, the value of the first has been posted.
  q.jobs.submit<int>(
      "marker", "",
      [&done](Progress&) {
        done.arrive();
        return 0;
      },
      [](JobResult<int>) {});
  done.waitUntilArrived();
  q.jobs.submit<int>(
      "new", "slot", [](Progress&) { return 2; }, keep);
  q.finishAll();
  EXPECT_EQ(values, (std::vector<int>{-1, 2}));
}

TEST(JobQueue, ReportsProgressOnTheMainThread) {
  Queue q;
  Gate gate;
  q.jobs.submit<int>(
      "Steps", "",
      [&gate](Progress& progress) {
        progress.report(0.5, "half way");
        gate.waitUntilOpen();
        return 0;
      },
      [](JobResult<int>) {});
  std::thread::id teller;
  const Subscription subscription = q.jobs.onChange([&teller] { teller = std::this_thread::get_id(); });
  q.box.runUntil([&] { return q.jobs.jobs()[0].step.english() == "half way"; });
  EXPECT_EQ(q.jobs.jobs()[0].fraction, 0.5);
  q.box.run();
  EXPECT_EQ(teller, std::this_thread::get_id());
  gate.open();
  q.finishAll();
}

TEST(JobQueue, CancelsAndWaitsWhenDestroyedAndDeliversNothingAfterwards) {
  ManualEventLoop box;
  bool delivered = false;
  std::atomic<bool> ended{false};
  {
    JobQueue jobs(box.post(), 2);
    Gate gate;
    jobs.submit<int>(
        "Long", "",
        [&](Progress& progress) -> int {
          gate.arrive();
          try {
            return forever(progress);
          } catch (...) {
            ended = true;
            throw;
          }
        },
        [&delivered](JobResult<int>) { delivered = true; });
    jobs.submit<int>(
        "Short", "", [](Progress&) { return 1; }, [&delivered](JobResult<int>) { delivered = true; });
    gate.waitUntilArrived();
  }
  EXPECT_TRUE(ended);
  box.run();
  EXPECT_FALSE(delivered);
}

TEST(JobQueue, MayBeDestroyedByTheReceiverOfAResult) {
  ManualEventLoop box;
  auto jobs = std::make_unique<JobQueue>(box.post());
  jobs->submit<int>(
      "Last", "", [](Progress&) { return 1; }, [&jobs](JobResult<int>) { jobs.reset(); });
  box.runUntil([&jobs] { return jobs == nullptr; });
}

TEST(JobQueue, CarriesValuesThatCanOnlyBeMoved) {
  Queue q;
  std::unique_ptr<int> value;
  q.jobs.submit<std::unique_ptr<int>>(
      "Move", "", [](Progress&) { return std::make_unique<int>(3); },
      [&value](JobResult<std::unique_ptr<int>> result) { value = std::move(*result.value); });
  q.finishAll();
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 3);
}

} // namespace
} // namespace viscera
