#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "viscera/coordinates/systems.h"

namespace viscera::tests {

/// Counts the expensive calls of the bindings of a `CountingSystem`.
struct BindingCounts {
  std::atomic<int> influences{0}; ///< Of one handle each; a volume form asks for all of them.
  std::atomic<int> deforms{0};    ///< Each a pass over all weights.
  std::atomic<int> pullBacks{0};  ///< Each for one gradient of the volume.
  std::function<void()> beforeInfluence = [] {};
};

/// S-Celestial coordinates, counted. Their bindings have no pieces of their own.
class CountingSystem final : public coordinates::DescribedSystem {
public:
  explicit CountingSystem(std::shared_ptr<BindingCounts> counts)
      : DescribedSystem({"counting", "Counting", "of a test"}), counts_(std::move(counts)) {}

  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override {
    coordinates::BindOptions plain;
    plain.threads = options.threads;
    return std::make_unique<Bound>(coordinates::sCelestial()->bind(handles, points, plain, progress),
                                   counts_);
  }

private:
  class Bound final : public coordinates::Binding {
  public:
    Bound(std::unique_ptr<coordinates::Binding> inner, std::shared_ptr<BindingCounts> counts)
        : inner_(std::move(inner)), counts_(std::move(counts)) {}
    Eigen::Index handleCount() const override { return inner_->handleCount(); }
    Eigen::Index pointCount() const override { return inner_->pointCount(); }
    const coordinates::BindingReport& report() const override { return inner_->report(); }
    void deform(const Points& pose, Points& points, Threads threads) const override {
      ++counts_->deforms;
      inner_->deform(pose, points, threads);
    }
    void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                    Threads threads) const override {
      inner_->moveHandle(pose, handle, delta, points, threads);
    }
    void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                  Threads threads) const override {
      ++counts_->pullBacks;
      inner_->pullBack(pose, pointGradient, handleGradient, threads);
    }
    Values influence(int handle) const override {
      counts_->beforeInfluence();
      ++counts_->influences;
      return inner_->influence(handle);
    }

  private:
    std::unique_ptr<coordinates::Binding> inner_;
    std::shared_ptr<BindingCounts> counts_;
  };

  std::shared_ptr<BindingCounts> counts_;
};

} // namespace viscera::tests
