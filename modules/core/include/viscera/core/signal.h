#pragma once

#include <functional>
#include <map>
#include <memory>
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

/// A list of observers. For one thread. Observers are called in the order in which they were connected and
/// must not throw; one may connect or disconnect any observer while it is being called.
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

  void emit(Arguments... arguments) const {
    const std::shared_ptr<Observers> list = observers_; // An observer may destroy the signal.
    std::vector<int> keys;
    for (const auto& [key, observer] : *list)
      keys.push_back(key);
    for (int key : keys) {
      const auto found = list->find(key);
      if (found == list->end())
        continue;
      const std::shared_ptr<Observer> observer = found->second; // It may disconnect itself.
      (*observer)(arguments...);
    }
  }

private:
  using Observers = std::map<int, std::shared_ptr<Observer>>;
  std::shared_ptr<Observers> observers_ = std::make_shared<Observers>();
  int next_ = 0;
};

} // namespace viscera
