#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "viscera/core/job_queue.h"
#include "viscera/core/signal.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/document/document.h"
#include "viscera/live/live_binding.h"
#include "viscera/plugin/registry.h"

namespace viscera::live {

/// Where the tissue of the posed patient is at rest, for images that bend along with the organs. While
/// somebody wants it, the space around the handles is bound on the job queue (slot "bend") for the handles
/// and the system there are, anew when those become others; a pose takes a few milliseconds. For the
/// document's thread.
class LiveBend {
public:
  /// All must live longer.
  LiveBend(document::Document& document, LiveBinding& live, const plugin::Registry& registry, JobQueue& jobs);
  ~LiveBend();
  LiveBend(const LiveBend&) = delete;
  LiveBend& operator=(const LiveBend&) = delete;

  /// Whether anybody looks; nothing is bound before.
  void setWanted(bool wanted);

  /// The map in the pose that organs are shown in, brought up to date by the call; null at rest, while it is
  /// bound, and where it cannot be.
  const deformation::InverseMap* map();
  /// Another number whenever `map` says something else.
  std::uint64_t revision() const;
  /// Why there is no map although one is wanted and the organs are posed; empty while there is one, or it is
  /// being bound.
  const std::string& problem() const;

  /// Tells when a map has been bound, or could not be.
  [[nodiscard]] Subscription onChange(std::function<void()> observer);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace viscera::live
