#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "cine_contours.h"
#include "wall_stiffness.h"

namespace viscera::tracking {

/// How stiff tissue is while handles follow the images, and how far these may lead.
struct CineStiffness {
  double strain, bending, handles; ///< Costs against the mean squared distance, mm^2.
  int steps;                       ///< Of Gauss and Newton.
  int wideSteps;                   ///< The first of them, in which distances count up to twice the gate.

  /// About a pose between two labelled ones.
  static CineStiffness betweenLabels() { return {4, 24, 1e-4, 4, 0}; }
  /// About the only labelled pose, from which tissue moves by a centimetre and more.
  static CineStiffness fromOneLabel() { return {0.5, 3, 1e-5, 10, 5}; }
};

/// What the images say of one phase between two labelled ones, and the pose that fits it.
class CinePose {
public:
  /// Fits the phase at place `at` of a segment. Keeps all references.
  CinePose(const MotionRig& rig, const CineSegment& segment, std::size_t at, const LabelledPose& from,
           const LabelledPose& to, const std::vector<bool>& isLong, const std::vector<CinePlane>& planes,
           const std::vector<std::vector<Eigen::Index>>& caps, const CineStiffness& hold);

  /// How far the phase is from the one label to the other: Gauss-Newton on the distances of followed tissue
  /// along the normals. That of a half cosine where no image shows anything.
  double partOfWay() const;
  /// The pose at such a part of the way.
  Points between(double part) const { return from_.pose + part * (to_.pose - from_.pose); }
  /// The handles about that pose. `heldBack` is set where the tissue would have folded.
  Points fitted(const Points& prior, const WallStiffness& stiffness, bool& heldBack) const;
  /// `pose` changed to such volumes of the surfaces, ml, at the least cost of its fit.
  VolumeResidual giveVolumes(const Values& wantedMl, const WallStiffness& stiffness, Points& pose) const;
  /// `pose` changed as little as the images and the wall's stiffness let it so that no witness is folded, its
  /// volumes kept; whether none is.
  bool unfold(const WallStiffness& stiffness, bool keepVolumes, Points& pose) const;
  /// `pose`, or one nearer to `safe` where tissue would fold that does not fold there; whether it is that.
  static bool holdBack(const Points& safe, const WallStiffness& stiffness, Points& pose);
  /// What each plane contributed.
  std::vector<PlaneShare> shares(const Points& pose) const;

private:
  /// Rows of a least squares problem: weights of the handles, the direction that counts, how far there, mm.
  struct Rows {
    Eigen::MatrixXd handles;
    Points direction;
    Values apart, weight;
  };
  /// Tissue of one contour in this phase.
  struct Tissue {
    const CineContour* contour = nullptr;
    Points at;
    Values weight, likeness;
  };

  void gather(const std::vector<CineContour>& contours, double far, std::size_t step);
  /// `withinMm`: of the rows within long-axis planes; 0: none.
  Rows rowsAt(const Points& pose, double gateMm, double withinMm) const;
  Eigen::Index acrossRows(const Points& vertices, double gateMm, Rows& rows) const;
  void withinRows(const Points& pose, Eigen::Index first, double gateMm, Rows& rows) const;
  /// The normal equations of a Gauss-Newton step, x, y and z of all handles below each other.
  struct System {
    Eigen::LLT<Eigen::MatrixXd> matrix;
    Points gradient;

    Points solve(const Points& right) const;
  };
  System systemAt(const Points& pose, const Points& prior, const WallStiffness& stiffness,
                  double wider = 1) const;

  const MotionRig& rig_;
  const LabelledPose& from_;
  const LabelledPose& to_;
  const std::vector<bool>& isLong_;
  const std::vector<CinePlane>& planes_;
  CineStiffness hold_;
  double time_;                          ///< Part of the way in time.
  std::vector<std::vector<bool>> isCap_; ///< For each surface's triangles.
  std::vector<Tissue> tissue_;
};

} // namespace viscera::tracking
