#include "sampled_motion.h"

#include <array>
#include <cmath>

namespace viscera::lesson {
namespace {

constexpr double kJustBeforeTheEnd = 1 - 1e-9;
constexpr double kJumpMm = 0.01; ///< From the end of a cycle to its beginning.
constexpr double kSameMm = 1e-6;

/// Sampled when it is asked for; carriers that are vertices are too many for more.
Eigen::Index mostSamples(const CarrierWeights& weights) {
  return weights.cols() > 0 ? kMostSamples : 2 * kFewestSamples;
}

CourseEnd endOf(double rate, const CarriersAt& carriersAt) {
  Points first, last;
  carriersAt(0, rate, first);
  carriersAt(kJustBeforeTheEnd, rate, last);
  return (last - first).cwiseAbs().maxCoeff() > kJumpMm ? CourseEnd::stops : CourseEnd::cycles;
}

bool sameMotion(double a, double b, const CarriersAt& carriersAt) {
  constexpr std::array<double, 5> kTried = {0.07, 0.23, 0.41, 0.66, 0.89};
  Points one, other;
  for (const double fraction : kTried) {
    carriersAt(fraction, a, one);
    carriersAt(fraction, b, other);
    if ((one - other).cwiseAbs().maxCoeff() > kSameMm)
      return false;
  }
  return true;
}

/// Which rates are to be sampled: each that moves in another way than those before it.
void shareCourses(const std::vector<double>& rates, const CarriersAt& carriersAt, SampledMotion& motion) {
  for (const double rate : rates) {
    std::size_t course = 0;
    while (course < motion.rates.size() && !sameMotion(motion.rates[course], rate, carriersAt))
      ++course;
    if (course == motion.rates.size())
      motion.rates.push_back(rate);
    motion.courseOfRate.push_back(static_cast<int>(course));
  }
}

/// The instants of all courses: samples, with one more in the middle between two.
Instants instantsOf(const SampledMotion& motion, Eigen::Index samples, const CarriersAt& carriersAt,
                    Progress& progress) {
  const Eigen::Index each = motion.end == CourseEnd::cycles ? 2 * samples : 2 * samples - 1;
  const Eigen::Index all = each * static_cast<Eigen::Index>(motion.rates.size());
  Instants instants;
  Points carriers;
  for (Eigen::Index row = 0; row < all; ++row) {
    progress.throwIfCancelled();
    const double fraction = fractionOf(row % each, each, motion.end);
    carriersAt(std::min(fraction, kJustBeforeTheEnd), motion.rates[static_cast<std::size_t>(row / each)],
               carriers);
    if (row == 0)
      for (Course* axis : {&instants.x, &instants.y, &instants.z})
        axis->resize(all, carriers.rows());
    instants.x.row(row) = carriers.col(0).transpose();
    instants.y.row(row) = carriers.col(1).transpose();
    instants.z.row(row) = carriers.col(2).transpose();
  }
  return instants;
}

/// Splines through every second instant, and how far they are off at the others.
void takeCourses(const MotionModes& found, SampledMotion& motion) {
  const Eigen::Index each = found.course.rows() / static_cast<Eigen::Index>(motion.rates.size());
  const Eigen::Index samples = (each + 1) / 2, between = each / 2;
  motion.courses.clear();
  motion.worst.clear();
  motion.betweenMm = 0;
  for (std::size_t i = 0; i < motion.rates.size(); ++i) {
    const auto rows = found.course.middleRows(static_cast<Eigen::Index>(i) * each, each);
    Course kept(samples, rows.cols()), off(between, rows.cols());
    for (Eigen::Index s = 0; s < samples; ++s)
      kept.row(s) = rows.row(2 * s);
    const Course spline = splineThrough(kept, motion.end);
    for (Eigen::Index s = 0; s < between; ++s)
      off.row(s) = valueAt(spline, motion.end, fractionOf(2 * s + 1, each, motion.end)).transpose() -
                   rows.row(2 * s + 1);
    const LargestDifference largest = largestDifference(found.modes, off);
    motion.betweenMm = std::max(motion.betweenMm, largest.mm);
    motion.worst.push_back(fractionOf(2 * largest.row + 1, each, motion.end));
    motion.courses.push_back(spline);
  }
}

} // namespace

SampledMotion sampledMotion(const std::vector<double>& rates, const CarrierWeights& weights,
                            const CarriersAt& carriersAt, const Accuracy& accuracy, Progress& progress,
                            Threads threads) {
  SampledMotion motion;
  if (rates.empty())
    return motion;
  motion.end = endOf(rates.front(), carriersAt);
  shareCourses(rates, carriersAt, motion);
  for (Eigen::Index samples = kFewestSamples;; samples *= 2) {
    MotionModes found = modesOf(instantsOf(motion, samples, carriersAt, progress), weights, accuracy.modesMm,
                                progress, threads);
    takeCourses(found, motion);
    motion.modes = std::move(found.modes);
    if (motion.betweenMm <= accuracy.betweenMm || 2 * samples > mostSamples(weights))
      return motion;
  }
}

} // namespace viscera::lesson
