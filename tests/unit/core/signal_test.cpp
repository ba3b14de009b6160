#include "viscera/core/signal.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace viscera {
namespace {

TEST(Signal, OneObserverThatThrowsKeepsNobodyFromHearingAndTheFirstExceptionIsThrown) {
  Signal<int> signal;
  int heard = 0;
  const Subscription first = signal.connect([&](int) { throw std::runtime_error("first"); });
  const Subscription second = signal.connect([&](int value) { heard = value; });
  const Subscription third = signal.connect([&](int) { throw std::runtime_error("third"); });
  try {
    signal.emit(7);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::string("first"));
  }
  EXPECT_EQ(heard, 7);
}

TEST(Signal, AnEmissionForLaterKeepsWhatItTellsAndTellsNobodyOnceTheSignalIsGone) {
  std::string heard;
  std::function<void()> later;
  {
    Signal<const std::string&> signal;
    later = signal.emission(std::string("news"));
    const Subscription subscription = signal.connect([&](const std::string& text) { heard += text; });
    later();
  }
  later();
  EXPECT_EQ(heard, "news");
}

} // namespace
} // namespace viscera
