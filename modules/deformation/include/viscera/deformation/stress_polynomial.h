#pragma once

#include <Eigen/Core>

namespace viscera::deformation {

/// The thesis's approximation of the rotational stress (figure 5.5): a polynomial of degree six in the
/// largest and the smallest singular value. The program itself uses the closed form (`localDistortion`); this
/// class serves to check the claim. The angle depends on the ratio of the two only, so that s1 up to 1 stands
/// for any size.
class StressPolynomial {
public:
  /// The polynomial whose largest error is about the smallest possible for `lowest <= s3 <= s1 <= 1`, by
  /// least squares with weights that grow where the error is large (Lawson's iteration). 0.1 s.
  explicit StressPolynomial(double lowest);

  double degrees(double s1, double s3) const;
  /// Largest error over the samples that it was fitted to, degrees.
  double largestError() const { return largestError_; }

private:
  double lowest_;
  Eigen::VectorXd coefficients_;
  double largestError_;
};

/// The exact angle of singular values s1 >= s2 >= s3 > 0 in degrees, by `localDistortion`.
double stressDegrees(double s1, double s2, double s3);

/// The same by a stepwise search for the direction that turns most, the thesis's method. Degrees.
double searchedStressDegrees(double s1, double s2, double s3);

} // namespace viscera::deformation
