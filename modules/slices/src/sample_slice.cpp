#include "viscera/slices/sample_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace viscera::slices {
namespace {

using medical_io::Scan;

constexpr Eigen::Index kRowGrain = 8;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// A scan's samples of one type, read at places in voxels.
template <class Sample>
class Reader {
public:
  Reader(const Scan& scan, const std::vector<Sample>& samples)
      : samples_(samples.data()), slope_(scan.slope), intercept_(scan.intercept),
        hasPadding_(scan.padding.has_value()), padding_(scan.padding.value_or(0)) {
    for (std::size_t k = 0; k < 3; ++k) {
      last_[k] = scan.size[k] - 1;
      step_[k] = k == 0 ? 1 : step_[k - 1] * std::size_t(scan.size[k - 1]);
    }
  }

  /// The trilinear value; at the outer half of the outer voxels that of the voxel.
  float linear(const double* place) const {
    std::size_t first = 0;
    std::array<std::size_t, 3> next;
    std::array<double, 3> part;
    for (std::size_t k = 0; k < 3; ++k) {
      const double inside = std::clamp(place[k], 0.0, static_cast<double>(last_[k]));
      const int low = static_cast<int>(inside);
      part[k] = inside - low;
      next[k] = low < last_[k] ? step_[k] : 0;
      first += static_cast<std::size_t>(low) * step_[k];
    }
    const Sample* s = samples_ + first;
    if (hasPadding_ && anyPadding(s, next))
      return nearest(place);
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    const auto row = [&](const Sample* at) { return mix(double(at[0]), double(at[next[0]]), part[0]); };
    const auto layer = [&](const Sample* at) { return mix(row(at), row(at + next[1]), part[1]); };
    return static_cast<float>(slope_ * mix(layer(s), layer(s + next[2]), part[2]) + intercept_);
  }

  /// The value of the voxel that the place lies in.
  float nearest(const double* place) const {
    std::size_t at = 0;
    for (std::size_t k = 0; k < 3; ++k)
      at += static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(place[k] + 0.5)), 0, last_[k])) *
            step_[k];
    const auto sample = static_cast<double>(samples_[at]);
    return hasPadding_ && sample == padding_ ? kNothing : static_cast<float>(slope_ * sample + intercept_);
  }

private:
  bool anyPadding(const Sample* s, const std::array<std::size_t, 3>& next) const {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const std::size_t at =
          (corner & 1 ? next[0] : 0) + (corner & 2 ? next[1] : 0) + (corner & 4 ? next[2] : 0);
      if (static_cast<double>(s[at]) == padding_)
        return true;
    }
    return false;
  }

  const Sample* samples_;
  double slope_, intercept_;
  bool hasPadding_;
  double padding_;
  std::array<int, 3> last_{};
  std::array<std::size_t, 3> step_{};
};

/// The pixels of a row, from `begin` up to `end`, that lie in the scan's voxels: `start + x * step`, in
/// voxels, is from half a voxel before the first centre to half a voxel behind the last one.
std::array<int, 2> insideOf(const Vec3& start, const Vec3& step, const std::array<int, 3>& size, int width) {
  double low = 0, high = width - 1;
  for (int k = 0; k < 3; ++k) {
    const double first = -0.5 - start[k], last = size[std::size_t(k)] - 0.5 - start[k];
    if (step[k] == 0) {
      if (first > 0 || last < 0)
        return {0, 0};
      continue;
    }
    low = std::max(low, std::min(first / step[k], last / step[k]));
    high = std::min(high, std::max(first / step[k], last / step[k]));
  }
  if (low > high)
    return {0, 0};
  return {static_cast<int>(std::ceil(low)), static_cast<int>(std::floor(high)) + 1};
}

/// The layers of a slab, as distances from the slice's plane, mm.
std::vector<double> layersOf(const Scan& scan, double slabMm) {
  const double finest = scan.spacing().minCoeff();
  const int count = slabMm > 0 ? std::max(1, static_cast<int>(std::lround(slabMm / finest))) : 1;
  std::vector<double> layers(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    layers[std::size_t(i)] = slabMm * ((i + 0.5) / count - 0.5);
  return layers;
}

/// Values of several layers on their way to one.
class Slab {
public:
  Slab(int width, bool maximum, float* out) : maximum_(maximum), out_(out), counts_(std::size_t(width), 0) {
    std::fill(out, out + width, kNothing);
  }

  void add(int x, float value) {
    if (std::isnan(value))
      return;
    int& count = counts_[std::size_t(x)];
    float& out = out_[x];
    if (count++ == 0)
      out = value;
    else
      out = maximum_ ? std::max(out, value) : out + value;
  }

  void finish() {
    for (std::size_t x = 0; x < counts_.size(); ++x)
      if (!maximum_ && counts_[x] > 1)
        out_[x] /= static_cast<float>(counts_[x]);
  }

private:
  bool maximum_;
  float* out_;
  std::vector<int> counts_;
};

/// Takes the rows of one slice.
template <class Sample>
class Slicer {
public:
  Slicer(const Scan& scan, const std::vector<Sample>& samples, const SliceFrame& frame,
         const SampleOptions& options, const RestLattice* bent)
      : scan_(scan), reader_(scan, samples), frame_(frame), nearest_(options.nearest),
        maximum_(options.maximum), bent_(bent), layers_(layersOf(scan, options.slabMm)),
        toIndex_(scan.indexToLps.inverse()), step_(toIndex_.linear() * frame.right),
        normal_(frame.plane().normal) {}

  void row(int y, float* out) const {
    if (layers_.size() == 1 && !bent_) {
      std::fill(out, out + frame_.width, kNothing);
      straight(y, 0, [out](int x, float value) { out[x] = value; });
      return;
    }
    Slab slab(frame_.width, maximum_, out);
    for (const double layer : layers_) {
      const auto add = [&slab](int x, float value) { slab.add(x, value); };
      if (bent_)
        curved(y, layer, add);
      else
        straight(y, layer, add);
    }
    slab.finish();
  }

private:
  float read(const Vec3& place) const {
    return nearest_ ? reader_.nearest(place.data()) : reader_.linear(place.data());
  }

  template <class Take>
  void straight(int y, double layer, Take take) const {
    const Vec3 start = toIndex_ * (frame_.at(0, y) + layer * normal_);
    const auto [begin, end] = insideOf(start, step_, scan_.size, frame_.width);
    for (int x = begin; x < end; ++x)
      take(x, read(start + x * step_));
  }

  template <class Take>
  void curved(int y, double layer, Take take) const {
    const int step = bent_->step;
    const int below = std::min(y / step, bent_->rows - 2);
    const double up = static_cast<double>(y) / step - below;
    const auto place = [&](int column) {
      const Eigen::Index at = Eigen::Index(below) * bent_->columns + column;
      const Vec3 rest =
          ((1 - up) * bent_->rest.row(at) + up * bent_->rest.row(at + bent_->columns)).transpose();
      return Vec3(toIndex_ * (rest + layer * normal_));
    };
    for (int column = 0; column + 1 < bent_->columns; ++column) {
      const Vec3 left = place(column), along = (place(column + 1) - left) / step;
      const int begin = column * step;
      const int end = std::min(begin + step, frame_.width);
      for (int x = begin; x < end; ++x)
        if (const Vec3 at = left + (x - begin) * along; inside(at))
          take(x, read(at));
    }
  }

  bool inside(const Vec3& place) const {
    for (int k = 0; k < 3; ++k)
      if (!(place[k] >= -0.5 && place[k] <= scan_.size[std::size_t(k)] - 0.5)) // NaN is outside.
        return false;
    return true;
  }

  const Scan& scan_;
  Reader<Sample> reader_;
  const SliceFrame& frame_;
  bool nearest_, maximum_;
  const RestLattice* bent_;
  std::vector<double> layers_;
  Eigen::Affine3d toIndex_;
  Vec3 step_, normal_;
};

} // namespace

RestLattice latticeOver(const SliceFrame& frame, int step) {
  RestLattice lattice;
  lattice.step = step;
  const auto reach = [step](int pixels) { return std::max(2, (pixels + step - 2) / step + 1); };
  lattice.columns = reach(frame.width);
  lattice.rows = reach(frame.height);
  lattice.rest.resize(Eigen::Index(lattice.rows) * lattice.columns, 3);
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      lattice.rest.row(Eigen::Index(row) * lattice.columns + column) =
          frame.at(column * step, row * step).transpose();
  return lattice;
}

void sampleSlice(const Scan& scan, const SliceFrame& frame, const SampleOptions& options, ValueImage& image,
                 const RestLattice* bent) {
  image.width = frame.width;
  image.height = frame.height;
  image.values.resize(std::size_t(frame.width) * std::size_t(frame.height));
  if (scan.voxelCount() == 0) {
    std::fill(image.values.begin(), image.values.end(), kNothing);
    return;
  }
  std::visit(
      [&](const auto& samples) {
        const Slicer slicer(scan, samples, frame, options, bent);
        parallelRanges(frame.height, kRowGrain, options.threads, [&](Eigen::Index begin, Eigen::Index end) {
          for (Eigen::Index y = begin; y < end; ++y)
            slicer.row(static_cast<int>(y), image.values.data() + y * frame.width);
        });
      },
      scan.samples);
}

void greyOf(const ValueImage& image, const medical_io::ValueWindow& window, std::uint8_t background,
            std::vector<std::uint8_t>& grey, Threads threads) {
  constexpr float kWhite = 255;
  grey.resize(image.values.size());
  const auto factor = static_cast<float>(kWhite / window.width);
  const auto black = static_cast<float>(window.level - 0.5 * window.width);
  const auto count = static_cast<Eigen::Index>(image.values.size());
  parallelRanges(count, kRowGrain * 4096, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const float value = image.values[static_cast<std::size_t>(i)];
      const float level = std::clamp((value - black) * factor + 0.5F, 0.0F, kWhite);
      grey[static_cast<std::size_t>(i)] = std::isnan(value) ? background : static_cast<std::uint8_t>(level);
    }
  });
}

} // namespace viscera::slices
