#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace viscera {

/// Keeps an observer connected; disconnects when destroyed. May outlive what it observes.
class Subscription {
public:
  Subscription() = default;
  explicit Subscription(std::function<void()> disconnect) : disconnect_(std::move(disconnect)) {}
  Subscription(Subscription&& other) noexcept : disconnect_(std::exchange(other.disconnect_, nullptr)) {}
  Subscription& operator=(Subscription&& other) noexcept {
    if (this != &other) {
      reset();
      disconnect_ = std::exchange(other.disconnect_, nullptr);
    }
    return *this;
  }
  ~Subscription() { reset(); }

  /// Disconnects now.
  void reset() {
    if (auto disconnect = std::exchange(disconnect_, nullptr))
      disconnect();
  }

private:
  std::function<void()> disconnect_;
};

/// Keeps the first exception of several pieces of work that have to be done in any case.
class FirstException {
public:
  template <class Work>
  void watch(Work&& work) {
    try {
      work();
    } catch (...) {
      if (!first_)
        first_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (first_)
      std::rethrow_exception(first_);
  }

private:
  std::exception_ptr first_;
};

/// A list of observers that are called when something happens, after the observer pattern. For one thread.
/// Observers are called in the order in which they were connected; one may connect or disconnect any observer
/// while it is being called. If an observer throws, the others are still called; then the first exception is
/// rethrown.
template <class... Arguments>
class Signal {
public:
  using Observer = std::function<void(Arguments...)>;

  [[nodiscard]] Subscription connect(Observer observer) {
    const int key = next_++;
    observers_->emplace(key, std::make_shared<Observer>(std::move(observer)));
    return Subscription([list = std::weak_ptr<Observers>(observers_), key] {
      if (auto alive = list.lock())
        alive->erase(key);
    });
  }

  void emit(Arguments... arguments) const { tell(observers_, arguments...); }

  /// A function that emits the signal later: it calls the observers connected at that time, and does nothing
  /// if the signal was destroyed.
  std::function<void()> emission(Arguments... arguments) const {
    return [list = std::weak_ptr<Observers>(observers_),
            kept = std::tuple<std::decay_t<Arguments>...>(arguments...)] {
      if (const auto alive = list.lock())
        std::apply([&alive](const auto&... each) { tell(alive, each...); }, kept);
    };
  }

private:
  using Observers = std::map<int, std::shared_ptr<Observer>>;

  /// Holds the list by value, because an observer may destroy the signal.
  static void tell(const std::shared_ptr<Observers> list, const std::decay_t<Arguments>&... arguments) {
    std::vector<int> keys;
    for (const auto& [key, observer] : *list)
      keys.push_back(key);
    FirstException exception;
    for (int key : keys) {
      const auto found = list->find(key);
      if (found == list->end())
        continue;
      const std::shared_ptr<Observer> observer = found->second; // It may disconnect itself.
      exception.watch([&] { (*observer)(arguments...); });
    }
    exception.rethrow();
  }

  std::shared_ptr<Observers> observers_ = std::make_shared<Observers>();
  int next_ = 0;
};

} // namespace viscera
