#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "viscera/coordinates/registry.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/phrase.h"
#include "viscera/core/signal.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/live/live_binding.h"

/// Inverts the present deformation of space, so that a scan can be warped with the organs.
namespace viscera::live {

/// The accuracy that `LiveWarp` aims at when it finds where a point of the posed space lies at rest, mm.
inline constexpr double kWarpToleranceMm = 0.03;

/// Keeps the inverse of the present deformation up to date, so that a scan can be deformed with the organs.
/// Organs that do not bend, such as bones, do not bend in the scan either.
/// While `setWanted` is on, the space around the handles is bound on the job queue (slot "bend"), anew when
/// the handles or the system change; a pose takes a few milliseconds. For the document's thread.
class LiveWarp {
public:
  struct Options {
    /// Time that `restPlane` may spend on the system itself; with a system that binds slowly, only the
    /// roughest places are refined.
    double refineSeconds = 0.008;
    Threads threads = {};
  };

  /// All must live longer.
  LiveWarp(const document::Document& document, LiveBinding& live, const coordinates::Registry& registry,
           JobQueue& jobs, Options options);
  LiveWarp(const document::Document& document, LiveBinding& live, const coordinates::Registry& registry,
           JobQueue& jobs)
      : LiveWarp(document, live, registry, jobs, Options()) {}
  ~LiveWarp();
  LiveWarp(const LiveWarp&) = delete;
  LiveWarp& operator=(const LiveWarp&) = delete;

  /// Sets whether the map is needed; nothing is bound before.
  void setWanted(bool wanted);

  /// The map for the pose in which organs are shown, updated by this call; null at rest, while it is being
  /// bound, and if it cannot be bound.
  const deformation::InverseMap* map();
  /// Whether the document has a scan and there is a map for it.
  bool warpsScan();
  /// Where the samples of a plane are at rest, by `map`, which must not be null, and by the system itself
  /// where the map's grid is too coarse: as near as `kWarpToleranceMm`, or, of systems that bind slowly, as
  /// many of the roughest places as take about a hundredth of a second. In organs that do not bend it is by
  /// their own motion.
  void restPlane(const deformation::SamplePlane& plane, deformation::RestPoints& rest);
  /// Where the tissue drawn at a place of the warped scan was at rest, mm, and the reverse, by the map; the
  /// place itself without one.
  Vec3 restOf(const Vec3& place);
  Vec3 posedOf(const Vec3& rest);
  /// The volume of tissue at rest that the pose turns inside out, ml; 0 without a map.
  double foldedMl();
  /// A number that changes whenever `map` returns another result.
  std::uint64_t revision() const;
  /// Why there is no map although one is wanted and the organs are posed; empty while there is one, or it is
  /// being bound.
  const Text& problem() const;

  /// Calls `observer` when a map has been bound or binding has failed, and when a map that there is becomes
  /// wanted or unwanted.
  [[nodiscard]] Subscription onChange(std::function<void()> observer);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How measured places of the scan move while it is shown warped; empty while it is not, at rest and without
/// a scan. `warp` has to live as long as the result.
document::TissueMotion tissueMotionOf(LiveWarp& warp);
/// The same for the points that the document's measurements have now, for another thread: it needs nothing
/// else to live on.
document::TissueMotion measuredTissueOf(LiveWarp& warp, const document::MeasurementList& measurements);

} // namespace viscera::live
