#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {

/// The errors of a binding (identity, unity, smallest weight), measured on every bound point when it is made.
struct BindingReport {
  double identityError = 0;  ///< max |sum a_i v_i - p| over the points, mm.
  double unityError = 0;     ///< max |sum a_i - 1|.
  double minWeight = 0;      ///< The smallest coordinate; negative where the system is not positive.
  std::vector<int> failures; ///< Points for which the system has no coordinates, ascending; they do not move.
  double seconds = 0;
  int threads = 1;
  std::vector<Text> notes; ///< Sentences for a user: what the system had to cut or leave out.
};

/// The coordinates of fixed points with respect to handles at rest, by which a pose of the handles gives the
/// points' new positions. Immutable; every member may be called from several threads. A pose is `handleCount
/// x 3`, mm.
///
/// Most systems write a point as `p = sum a_i v_i`; Green coordinates also use the cage's normals. A binding
/// hides the difference: its members take and return poses and points only.
class Binding {
public:
  virtual ~Binding() = default;

  virtual Eigen::Index handleCount() const = 0;
  virtual Eigen::Index pointCount() const = 0;
  virtual const BindingReport& report() const = 0;

  /// Fills `points` (resized to `pointCount x 3`) for `pose`. O(pointCount x handleCount).
  virtual void deform(const Points& pose, Points& points, Threads threads = {}) const = 0;

  /// Updates `points`, which belong to `pose`, for handle `handle` moved by `delta` (mm). One column:
  /// O(pointCount) where the coordinates are linear in the pose.
  virtual void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                          Threads threads = {}) const = 0;

  /// The work of `deform` and `moveHandle`, with the same bits, divided into pieces, for posing several
  /// organs in one parallel loop. `points` is resized at once; it, `pose` and this binding must live until
  /// all pieces are done, and must not be accessed meanwhile. All bindings are divided in the same way, so
  /// that they can be done `inTurn`. The base class returns one piece.
  virtual PiecesOfWork deformInPieces(const Points& pose, Points& points) const {
    return {1, [this, &pose, &points](Eigen::Index) { deform(pose, points, Threads{1}); }};
  }
  virtual PiecesOfWork moveHandleInPieces(const Points& pose, int handle, const Vec3& delta,
                                          Points& points) const {
    return {1, [this, &pose, handle, delta, &points](Eigen::Index) {
              moveHandle(pose, handle, delta, points, Threads{1});
            }};
  }

  /// Given the derivative of a scalar with respect to every point (`pointCount x 3`), fills `handleGradient`
  /// (resized to `handleCount x 3`) with its derivative with respect to every handle at `pose`. Bitwise
  /// independent of the number of threads.
  virtual void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                        Threads threads = {}) const = 0;

  /// The influence of one handle on every point: `pointCount` numbers, its coordinate.
  virtual Values influence(int handle) const = 0;

  /// The influence of one handle on one point: `influence(handle)[point]`. O(pointCount) in the base class,
  /// O(1) for bindings by weights.
  virtual double weight(Eigen::Index point, int handle) const { return influence(handle)[point]; }
};

} // namespace viscera::coordinates
