#pragma once

#include <memory>
#include <string>

#include "viscera/geometry/signed_distance.h"
#include "viscera/live/retarget.h"
#include "viscera/sequences/centerline.h"
#include "viscera/sequences/rig_parts.h"

namespace viscera::live {

/// Checks the landmarks of an organ's surface and finds missing ones. Thread-safe.
class LandmarkFinder {
public:
  /// Throws `DataError` for an organ that is open or in pieces.
  LandmarkFinder(std::string sequence, const document::Organ& organ);

  /// See `completeLandmarks`.
  Landmarks complete(const Landmarks& given) const;

  const std::shared_ptr<const geometry::TriangleMesh>& mesh() const { return mesh_; }
  /// The organ's surface as a function, in its own size.
  double depth(const Vec3& point) const { return (*distance_)(point); }

private:
  void requireNear(const Landmark& landmark) const;
  void requireBothOrNone(const Landmarks& given, const std::string& one, const std::string& other) const;
  void requireApart(const Landmark& one, const Landmark& other) const;
  Landmarks heart(Landmarks landmarks) const;
  Landmarks stomach(Landmarks landmarks) const;
  void addCenterline(Landmarks& landmarks) const;
  /// A point near the wall, or a little outside, moved away from it.
  Vec3 drawnInside(const Vec3& place) const;
  int vertexNear(const Vec3& point) const;

  std::string sequence_;
  std::string name_;
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  std::shared_ptr<const geometry::SignedDistance> distance_;
  double size_ = 0;
};

/// The centreline of a stomach from complete landmarks, and the places on it, in the organ's own size.
struct StomachLine {
  std::vector<Vec3> points;
  double midBody = 0;
  double pylorus = 0;
};

/// `length` is that of the line when the pylorus is at its end: the waves' course ends a little before.
/// Throws `DataError` when the landmarks are not in order along the line.
StomachLine stomachLine(const Landmarks& landmarks, const std::string& where);

} // namespace viscera::live
