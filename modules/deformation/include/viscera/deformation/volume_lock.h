#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/restoration_model.h"
#include "viscera/deformation/volume_form.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// A surface whose volume is to have a certain value in every pose.
struct LockedSurface {
  std::string name; ///< For messages.
  std::shared_ptr<const geometry::TriangleMesh> rest;
  std::shared_ptr<const coordinates::Binding>
      binding; ///< All surfaces of a lock are bound to the same handles.
  double targetMm3 = 0;
};

/// The result of restoring locked volumes: the pose, and how exactly it has them.
struct RestoredPose {
  Points pose;               ///< `n x 3`; the wanted pose when it failed.
  bool restored = false;     ///< The volumes are met to `VolumeLock::kRelativeTolerance`.
  double largestShiftMm = 0; ///< How far a compensating handle had to move.
  double relativeError = 0;  ///< max |V - V*| / V* over the surfaces.
  Text reason;               ///< Why it failed, for the user; empty when restored.
};

/// Keeps the volume of surfaces exactly constant, or at prescribed values, while their handles move.
///
/// Linear coordinates make the volume affine in the common translation of any set of handles (the
/// thesis's 5.1.3 for one handle; for several because det(u, u, .) = 0), so such a drag is projected onto a
/// plane and stays exact. Any other change of pose is followed by a compensation: the free handles move along
/// a direction U, and as the volume of `H + s U` is a cubic in s, its root is exact as well. Several surfaces
/// at once, and coordinates that are not linear in the pose, are finished by Newton steps.
///
/// Compensations work on each surface's `VolumeForm`, so that they do not pass over the surface again and
/// again; the reported volumes are measured on the surface itself. If a form does not exist, is not made yet
/// (`Forms`) or would take too long to make, compensations evaluate the surface: the volumes are then as
/// exact, the pose differs by rounding.
///
/// Immutable but for the targets; const members may be called from several threads.
class VolumeLock {
public:
  static constexpr double kRelativeTolerance = 1e-10;

  /// When the volume forms are made.
  enum class Forms {
    whenAsked, ///< On the first compensation, which takes a second or two for a large surface.
    given      ///< Never: the lock uses those that exist when it is made.
  };

  /// Throws `DataError` for an open surface (it names the number of boundary edges), or for a target that is
  /// not positive. O(m log m).
  explicit VolumeLock(std::vector<LockedSurface> surfaces, Threads threads = {});
  /// The same, but shares the results that other locks have computed for a surface and its binding. With
  /// `given` all forms of `known` must have been made. Null pointers are ignored.
  VolumeLock(std::vector<LockedSurface> surfaces, Threads threads, Forms forms,
             const std::vector<std::shared_ptr<const VolumeLock>>& known);

  /// Makes the forms now that compensations would ask for. Throws `Cancelled`; they can then be made again.
  void makeForms(Progress& progress) const;

  const std::vector<LockedSurface>& surfaces() const { return surfaces_; }
  void setTarget(std::size_t surface, double targetMm3);
  /// Present volumes at `pose`, mm^3, one for each surface.
  std::vector<double> volumes(const Points& pose) const;

  /// The same by the volume forms, where there are some: within rounding, and quicker.
  std::vector<double> expectedVolumes(const Points& pose) const;
  /// The derivative of each surface's volume with respect to the handles, `n x 3`, mm^2; by the forms, where
  /// there are some.
  std::vector<Points> gradients(const Points& pose) const;

  /// The change of the volumes when the handles `selection` move together: `surfaces x 3`, mm^2. For one
  /// surface the row is the normal of the plane in which the selection may move.
  Points translationGradient(const Points& pose, const std::vector<int>& selection) const;

  /// Moves the handles `free` (ascending) by the least amount, as `model` measures it, that gives `wanted`
  /// the locked volumes. Fails, with a reason, when that takes more than `limitMm`.
  RestoredPose restore(const Points& wanted, const std::vector<int>& free, const RestorationModel& model,
                       double limitMm) const;

private:
  /// Made by the first thread that asks for it, or by the next one where that was cancelled. A `once_flag`
  /// would need a `pthread_once` that allows exceptions, as not every one does.
  struct Form {
    std::mutex making;
    std::atomic<bool> asked{false}; ///< With a result, which is none where a form does not pay.
    std::optional<VolumeForm> made;
  };
  /// Results computed for a surface and its binding.
  struct Surface {
    std::shared_ptr<const geometry::VertexTriangles> around;
    std::shared_ptr<Form> form; ///< Null: no form is made.
  };

  /// A surface in one pose. Each pose is evaluated once while volumes are restored: a pass over the weights
  /// of a large organ costs more than all that is then done with its points.
  struct PosedSurface {
    Points pose; ///< Empty: not evaluated yet.
    Points points;
    double volume = 0;
  };
  using PosedSurfaces = std::vector<PosedSurface>; ///< One for each surface.

  void takeOver(Surface& own, const LockedSurface& surface) const;
  const VolumeForm* form(std::size_t surface) const;
  const VolumeForm* form(std::size_t surface, Progress& progress) const;
  void shape(std::size_t surface, const Points& pose, Points& points) const;
  Points gradientOnSurface(std::size_t surface, const Points& pose) const;
  Points gradientOnSurface(std::size_t surface, const Points& pose, PosedSurfaces& posed) const;
  Points gradient(std::size_t surface, const Points& pose, PosedSurfaces& posed) const;
  const PosedSurface& posedSurface(std::size_t surface, const Points& pose, PosedSurfaces& posed) const;
  double volume(std::size_t surface, const Points& pose, PosedSurfaces& posed) const;
  double volumeOnSurface(std::size_t surface, const Points& pose) const;
  double error(const std::vector<double>& volumes) const;
  double measuredError(const Points& pose, PosedSurfaces& posed) const;
  double expectedError(const Points& pose, PosedSurfaces& posed) const;
  std::array<double, 4> along(const Points& pose, const Points& direction, PosedSurfaces& posed) const;
  double cubicStep(const Points& pose, const Points& direction, double limitMm, PosedSurfaces& posed) const;
  bool newtonStep(Points& pose, const std::vector<int>& free, const RestorationModel& model,
                  PosedSurfaces& posed) const;

  std::vector<LockedSurface> surfaces_;
  std::vector<Surface> known_; ///< Of each surface; shared with copies, for other targets.
  Threads threads_;
};

/// The handles that a pose leaves at rest exactly, ascending: free to compensate for changes of the volume.
std::vector<int> restingHandles(const Points& restHandles, const Points& pose);

/// Poses `deformer` so that it encloses `targetMm3` (mm^3): moves the `compensating` handles at the least
/// cost by `model` and leaves the others. The `VolumeLock` for one surface and one pose, without keeping a
/// lock.
///
/// Throws `UsageError` when there is no compensating handle or one that does not exist, `DataError` for an
/// open surface, or when a handle would have to move farther than the diagonal of the handles at rest. The
/// pose is then as it was.
void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating,
                   const RestorationModel& model = LeastDisplacement());

} // namespace viscera::deformation
