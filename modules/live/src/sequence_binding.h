#pragma once

#include <array>
#include <memory>
#include <string>

#include "viscera/coordinates/binding.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/pose_compensation.h"
#include "viscera/sequences/sequence.h"

/// Helper functions to set up sequences on sample organs.
namespace viscera::live {

/// S-Celestial coordinates that are local and smooth.
document::SystemChoice softCoordinates(double softnessMm);

/// Computes the volume of a surface that handles move.
class MovedVolume {
public:
  /// Binds the surface on several threads; measuring is for one.
  MovedVolume(std::shared_ptr<const geometry::TriangleMesh> mesh, const Points& restHandles,
              const document::SystemChoice& system, Threads threads);

  /// The volume with the handles at `pose` (`n x 3`), ml. May be called from several threads.
  double at(const Points& pose) const;
  /// The surface itself with the handles at `pose`.
  geometry::TriangleMesh surfaceAt(const Points& pose) const;

  const coordinates::Binding& binding() const { return *binding_; }

  /// The volume with the handles at `pose + x direction`, as a cubic in x, ml: `sequences::VolumeAlong`.
  std::array<double, 4> along(const Points& pose, const Points& direction) const;

private:
  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  std::unique_ptr<const coordinates::Binding> binding_;
};

/// The same for a sequence that keeps the volume.
sequences::VolumeAlong volumeAlong(std::shared_ptr<const MovedVolume> volume);

/// The breathing of a liver with this surface, by handles spread over it; the far corners are a group.
std::shared_ptr<const sequences::Sequence> liverBreathing(const geometry::TriangleMesh& surface);

/// The compensation that makes handles overshoot to balance the averaging of these coordinates. Handles that
/// have no coordinates of their own are not changed.
sequences::PoseCompensation compensationFor(const Points& restHandles, const document::SystemChoice& system,
                                            Threads threads);

/// The surface of that name. Throws `DataError` when the organ has none.
std::shared_ptr<const geometry::TriangleMesh> surfaceOf(const sample_organs::SampleOrgan& organ,
                                                        const std::string& name);

} // namespace viscera::live
