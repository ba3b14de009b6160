#include "window/work/mailbox.h"

#include <QCoreApplication>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace viscera::tests {
namespace {

TEST(Mailbox, CallsOnItsThreadInTheOrderOfEachSender) {
  constexpr std::size_t kSenders = 3;
  constexpr int kFunctions = 200;
  const auto here = std::this_thread::get_id();
  std::array<int, kSenders> called{};
  const JobQueue::Post post = app::mailbox();
  std::vector<std::thread> senders;
  for (std::size_t sender = 0; sender < kSenders; ++sender)
    senders.emplace_back([&, sender] {
      for (int i = 0; i < kFunctions; ++i)
        post([&, sender, i] {
          EXPECT_EQ(std::this_thread::get_id(), here);
          EXPECT_EQ(called[sender]++, i);
        });
    });
  for (std::thread& sender : senders)
    sender.join();
  EXPECT_EQ(called, (std::array<int, kSenders>{})) << "nothing is called at once";
  QCoreApplication::processEvents();
  EXPECT_EQ(called, (std::array<int, kSenders>{kFunctions, kFunctions, kFunctions}));
}

TEST(Mailbox, ForgetsWhatStillWaitsWhenItGoes) {
  bool called = false;
  const auto held = std::make_shared<int>();
  app::mailbox()([&called, held] { called = true; });
  EXPECT_EQ(held.use_count(), 1);
  QCoreApplication::processEvents();
  EXPECT_FALSE(called);
}

TEST(Mailbox, MayGoInTheMiddleOfACall) {
  bool called = false;
  std::optional<JobQueue::Post> post = app::mailbox();
  (*post)([&] {
    post.reset();
    called = true;
  });
  (*post)([] { FAIL() << "it had gone"; });
  QCoreApplication::processEvents();
  EXPECT_TRUE(called);
}

} // namespace
} // namespace viscera::tests
