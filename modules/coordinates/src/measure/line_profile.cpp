#include "viscera/coordinates/measure/line_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace viscera::coordinates {
namespace {

/// Places looked at more closely: those with the greatest changes.
constexpr std::size_t kPlaces = 16;
/// Parts into which such a place is divided, again and again.
constexpr int kDivisions = 16;
constexpr int kJumpLevels = 7; ///< Down to 4e-9 of a part.
constexpr int kKinkLevels = 3; ///< Down to 1/2048 of a part: much closer, slopes are lost in rounding.
/// The smallest jump; a smaller change is the slope over the last distance.
constexpr double kJump = 1e-5;
/// Part of the steepest slope: a smaller change of slope counts for none.
constexpr double kKink = 0.02;
/// A smooth curve's change of slope has gone down by the distance's ratio; a kink's has not.
constexpr double kKept = 0.3;
/// Part of a coordinate's range: less prominent maxima are not counted.
constexpr double kProminent = 1e-3;

/// Part of the line, from 0 to 1.
struct Interval {
  double begin;
  double end;
};

class LineMeter {
public:
  LineMeter(const CoordinateSystem& system, const HandleSet& handles, const Line& line, int parts,
            const BindOptions& options, Progress& progress)
      : system_(system), handles_(handles), line_(line), parts_(parts), options_(options),
        progress_(progress) {}

  /// Coordinates at the places (0 to 1), one row each; not finite where there are none. The whole line is
  /// bound with them: some systems' coordinates depend on all points.
  Eigen::MatrixXd at(const std::vector<double>& places, BindingReport* report = nullptr) const {
    const auto extra = static_cast<Eigen::Index>(places.size());
    Points points(parts_ + 1 + extra, 3);
    for (Eigen::Index i = 0; i <= parts_; ++i)
      points.row(i) = line_.at(static_cast<double>(i) / parts_).transpose();
    for (Eigen::Index i = 0; i < extra; ++i)
      points.row(parts_ + 1 + i) = line_.at(places[static_cast<std::size_t>(i)]).transpose();
    const auto binding = system_.bind(handles_, points, options_, progress_);
    if (report)
      *report = binding->report();
    const Eigen::MatrixXd values = coordinatesOf(*binding);
    if (extra == 0)
      return values;
    return values.bottomRows(extra);
  }

  /// Divides each interval and gives the coordinates at all ends, `kDivisions + 1` rows an interval.
  Eigen::MatrixXd divided(const std::vector<Interval>& intervals) const {
    std::vector<double> places;
    for (const Interval& interval : intervals)
      for (int i = 0; i <= kDivisions; ++i)
        places.push_back(interval.begin + (interval.end - interval.begin) * i / kDivisions);
    return at(places);
  }

private:
  const CoordinateSystem& system_;
  const HandleSet& handles_;
  Line line_;
  int parts_;
  const BindOptions& options_;
  Progress& progress_;
};

/// The largest change of a coordinate from one row to the next; 0 where one of them has no answer.
double changeAfter(const Eigen::MatrixXd& rows, Eigen::Index row) {
  const double change = (rows.row(row + 1) - rows.row(row)).cwiseAbs().maxCoeff();
  return std::isfinite(change) ? change : 0;
}

/// The largest change of a coordinate's slope at a row, with the rows `distance` apart.
double bendAt(const Eigen::MatrixXd& rows, Eigen::Index row, double distance) {
  const double bend =
      (rows.row(row + 1) - 2 * rows.row(row) + rows.row(row - 1)).cwiseAbs().maxCoeff() / distance;
  return std::isfinite(bend) ? bend : 0;
}

/// The change of slope across the part after a row: all of a kink's, wherever in that part it is.
double bendAcross(const Eigen::MatrixXd& rows, Eigen::Index row, double distance) {
  const double bend =
      (rows.row(row + 2) - rows.row(row + 1) - rows.row(row) + rows.row(row - 1)).cwiseAbs().maxCoeff() /
      distance;
  return std::isfinite(bend) ? bend : 0;
}

/// The indices with the greatest values, greatest first.
std::vector<Eigen::Index> greatest(const std::vector<double>& values, std::size_t count) {
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return values[static_cast<std::size_t>(a)] > values[static_cast<std::size_t>(b)];
  });
  order.resize(std::min(count, order.size()));
  return order;
}

/// The rows after which there may be a jump: those of the greatest changes, and those that change much more
/// than the rows beside them, because a small jump may hide behind steep slopes elsewhere.
std::vector<Eigen::Index> suspected(const Eigen::MatrixXd& profile) {
  const Eigen::Index count = profile.rows() - 1;
  std::vector<double> changes, lonely;
  for (Eigen::Index row = 0; row < count; ++row)
    changes.push_back(changeAfter(profile, row));
  for (std::size_t row = 0; row < changes.size(); ++row) {
    const double before = row > 0 ? changes[row - 1] : 0;
    const double after = row + 1 < changes.size() ? changes[row + 1] : 0;
    lonely.push_back(changes[row] - std::max(before, after));
  }
  std::vector<Eigen::Index> rows = greatest(changes, kPlaces);
  for (const Eigen::Index row : greatest(lonely, kPlaces))
    if (std::find(rows.begin(), rows.end(), row) == rows.end())
      rows.push_back(row);
  return rows;
}

double largestJump(const LineMeter& meter, const Eigen::MatrixXd& profile) {
  const auto parts = static_cast<double>(profile.rows() - 1);
  std::vector<Interval> intervals;
  for (const Eigen::Index row : suspected(profile))
    intervals.push_back({static_cast<double>(row) / parts, static_cast<double>(row + 1) / parts});
  double jump = 0;
  for (int level = 0; level < kJumpLevels; ++level) {
    const Eigen::MatrixXd rows = meter.divided(intervals);
    jump = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const auto first = static_cast<Eigen::Index>(i) * (kDivisions + 1);
      Eigen::Index steepest = 0;
      for (Eigen::Index part = 1; part < kDivisions; ++part)
        if (changeAfter(rows, first + part) > changeAfter(rows, first + steepest))
          steepest = part;
      jump = std::max(jump, changeAfter(rows, first + steepest));
      const double width = (intervals[i].end - intervals[i].begin) / kDivisions;
      intervals[i].begin += width * static_cast<double>(steepest);
      intervals[i].end = intervals[i].begin + width;
    }
  }
  return jump > kJump ? jump : 0;
}

/// Looks closer at the rows where slopes change most.
void measureKinks(const LineMeter& meter, const Eigen::MatrixXd& profile, double length,
                  LineProperties& properties) {
  const auto parts = static_cast<double>(profile.rows() - 1);
  double steepest = 0;
  std::vector<double> bends(static_cast<std::size_t>(profile.rows()));
  for (Eigen::Index row = 1; row + 1 < profile.rows(); ++row) {
    steepest = std::max(steepest, changeAfter(profile, row) * parts / length);
    const double bend = bendAt(profile, row, length / parts);
    // Only the sharpest of neighbours stands for a place.
    const bool peak = bend >= bendAt(profile, std::max<Eigen::Index>(row - 1, 1), length / parts) &&
                      bend >= bendAt(profile, std::min(row + 1, profile.rows() - 2), length / parts);
    bends[static_cast<std::size_t>(row)] = peak ? bend : 0;
  }
  const auto places = greatest(bends, kPlaces);
  std::vector<Interval> windows;
  for (const Eigen::Index row : places)
    windows.push_back({(static_cast<double>(row) - 1) / parts, (static_cast<double>(row) + 1) / parts});
  std::vector<double> left(places.size());
  for (int level = 0; level < kKinkLevels; ++level) {
    const Eigen::MatrixXd rows = meter.divided(windows);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const double width = (windows[i].end - windows[i].begin) / kDivisions;
      const auto first = static_cast<Eigen::Index>(i) * (kDivisions + 1);
      Eigen::Index sharpest = 1;
      for (Eigen::Index part = 2; part + 1 < kDivisions; ++part)
        if (bendAcross(rows, first + part, width * length) >
            bendAcross(rows, first + sharpest, width * length))
          sharpest = part;
      left[i] = bendAcross(rows, first + sharpest, width * length);
      const double middle = windows[i].begin + width * (static_cast<double>(sharpest) + 0.5);
      windows[i] = {middle - width, middle + width};
    }
  }
  for (std::size_t i = 0; i < left.size(); ++i)
    if (left[i] > kKink * steepest && left[i] > kKept * bends[static_cast<std::size_t>(places[i])]) {
      ++properties.kinks;
      properties.largestKink = std::max(properties.largestKink, left[i]);
    }
}

/// Maxima that stand out from the minima on both sides.
int prominentMaxima(const Eigen::VectorXd& values) {
  const double range = values.maxCoeff() - values.minCoeff(), least = kProminent * std::max(range, 1e-12);
  int maxima = 0;
  bool rising = true;
  double extreme = values[0];
  for (const double value : values) {
    if (rising ? value > extreme : value < extreme) {
      extreme = value;
    } else if (rising ? value < extreme - least : value > extreme + least) {
      maxima += rising ? 1 : 0;
      rising = !rising;
      extreme = value;
    }
  }
  return maxima + (rising ? 1 : 0);
}

} // namespace

LineProfile profileAlong(const CoordinateSystem& system, const HandleSet& handles, const Line& line,
                         int parts, const BindOptions& options, Progress& progress) {
  LineProfile profile;
  const LineMeter meter(system, handles, line, parts, options, progress);
  profile.coordinates = meter.at({}, &profile.report);
  for (const int failed : profile.report.failures)
    profile.coordinates.row(failed).setZero();
  return profile;
}

LineProperties measureAlong(const CoordinateSystem& system, const HandleSet& handles, const Line& line,
                            int parts, const BindOptions& options, Progress& progress) {
  const LineMeter meter(system, handles, line, parts, options, progress);
  LineProperties properties;
  const Eigen::MatrixXd profile = meter.at({}, &properties.report);
  properties.largestJump = largestJump(meter, profile);
  if (properties.largestJump == 0) // A jump is a kink everywhere.
    measureKinks(meter, profile, (line.to - line.from).norm(), properties);
  for (Eigen::Index handle = 0; handle < profile.cols(); ++handle) {
    Eigen::VectorXd values = profile.col(handle);
    values = values.array().isFinite().select(values, 0.0);
    properties.localMaxima = std::max(properties.localMaxima, prominentMaxima(values));
  }
  return properties;
}

Eigen::MatrixXd coordinatesOf(const Binding& binding) {
  Eigen::MatrixXd values(binding.pointCount(), binding.handleCount());
  for (int handle = 0; handle < static_cast<int>(values.cols()); ++handle)
    values.col(handle) = binding.influence(handle);
  for (const int failed : binding.report().failures)
    values.row(failed).setConstant(std::numeric_limits<double>::quiet_NaN());
  return values;
}

double roughness(const Eigen::MatrixXd& coordinates) {
  double squares = 0;
  int counted = 0;
  for (Eigen::Index row = 1; row + 1 < coordinates.rows(); ++row) {
    const double bend =
        (coordinates.row(row + 1) - 2 * coordinates.row(row) + coordinates.row(row - 1)).squaredNorm();
    squares += std::isfinite(bend) ? bend : 0;
    counted += std::isfinite(bend) ? 1 : 0;
  }
  return std::sqrt(squares / counted);
}

double nearHalfShare(const Points& handles, const Points& points, const Eigen::MatrixXd& coordinates) {
  double sum = 0;
  int counted = 0;
  std::vector<Eigen::Index> order(static_cast<std::size_t>(handles.rows()));
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    const double all = coordinates.row(point).cwiseAbs().sum();
    if (!(all > 0))
      continue;
    const Values distances = (handles.rowwise() - points.row(point)).rowwise().norm();
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return distances[a] < distances[b]; });
    double near = 0;
    for (std::size_t i = 0; i < order.size() / 2; ++i)
      near += std::abs(coordinates(point, order[i]));
    sum += near / all;
    ++counted;
  }
  return counted > 0 ? sum / counted : 0;
}

} // namespace viscera::coordinates
