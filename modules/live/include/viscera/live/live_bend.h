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

/// Inverts the present deformation of space, so that a scan can be warped with the organs.
namespace viscera::live {

/// The accuracy that `LiveBend` aims at when it finds where a point of the posed space lies at rest, mm.
inline constexpr double kBendToleranceMm = 0.03;

/// Keeps the inverse of the present deformation up to date, so that a scan can be deformed with the organs.
/// While somebody wants it, the space around the handles is bound on the job queue (slot "bend") for the
/// handles and the system there are, anew when those become others; a pose takes a few milliseconds. For the
/// document's thread.
class LiveBend {
public:
  struct Options {
    /// About as long a plane may ask the system itself; of one that binds slowly only the roughest places
    /// are.
    double refineSeconds = 0.008;
    Threads threads = {};
  };

  /// All must live longer.
  LiveBend(const document::Document& document, LiveBinding& live, const plugin::Registry& registry,
           JobQueue& jobs, Options options);
  LiveBend(const document::Document& document, LiveBinding& live, const plugin::Registry& registry,
           JobQueue& jobs)
      : LiveBend(document, live, registry, jobs, Options()) {}
  ~LiveBend();
  LiveBend(const LiveBend&) = delete;
  LiveBend& operator=(const LiveBend&) = delete;

  /// Whether anybody looks; nothing is bound before.
  void setWanted(bool wanted);

  /// The map in the pose that organs are shown in, brought up to date by the call; null at rest, while it is
  /// bound, and where it cannot be.
  const deformation::InverseMap* map();
  /// Where the samples of a plane are at rest, by `map`, which must not be null, and by the system itself
  /// where the map's grid is too coarse: as near as `kBendToleranceMm`, or, of systems that bind slowly, as
  /// many of the roughest places as take about a hundredth of a second.
  void restPlane(const deformation::SamplePlane& plane, deformation::RestPoints& rest);
  /// How much tissue at rest the pose turns inside out, ml; 0 without a map.
  double foldedMl();
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
