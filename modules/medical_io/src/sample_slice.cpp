#include "viscera/medical_io/sample_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace viscera::medical_io {
namespace {

constexpr Eigen::Index kRowGrain = 8;
/// Voxels that a row of pixels may stray from one of voxels, and still runs along it.
constexpr double kAlong = 1e-3;
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

  /// Fills the voxels `first` to `last` of a row along `axis`, at `place` in the other two: the samples
  /// between the four rows around it; NaN where one of them is padding.
  void betweenRows(const Vec3& place, int axis, int first, int last, std::vector<float>& row) const {
    std::size_t start = static_cast<std::size_t>(first) * step_[std::size_t(axis)];
    std::array<std::size_t, 2> next{};
    std::array<float, 2> part{};
    for (int n = 0; n < 2; ++n) {
      const auto k = std::size_t((axis + 1 + n) % 3);
      const double inside = std::clamp(place[Eigen::Index(k)], 0.0, static_cast<double>(last_[k]));
      const int low = static_cast<int>(inside);
      part[std::size_t(n)] = static_cast<float>(inside - low);
      next[std::size_t(n)] = low < last_[k] ? step_[k] : 0;
      start += static_cast<std::size_t>(low) * step_[k];
    }
    const float a = (1 - part[0]) * (1 - part[1]), b = part[0] * (1 - part[1]);
    const float c = (1 - part[0]) * part[1], d = part[0] * part[1];
    const Sample *one = samples_ + start, *two = one + next[0], *three = one + next[1],
                 *four = three + next[0];
    const std::size_t stride = step_[std::size_t(axis)];
    const auto count = static_cast<std::size_t>(last - first + 1);
    row.resize(count);
    for (std::size_t i = 0, at = 0; i < count; ++i, at += stride)
      row[i] = a * static_cast<float>(one[at]) + b * static_cast<float>(two[at]) +
               c * static_cast<float>(three[at]) + d * static_cast<float>(four[at]);
    if (!hasPadding_)
      return;
    const auto isPadding = [this](Sample s) { return static_cast<double>(s) == padding_; };
    for (std::size_t i = 0, at = 0; i < count; ++i, at += stride)
      if (isPadding(one[at]) || isPadding(two[at]) || isPadding(three[at]) || isPadding(four[at]))
        row[i] = kNothing;
  }

  /// The value of a sample, or of one between them.
  float valueOf(float sample) const { return static_cast<float>(slope_ * double(sample) + intercept_); }

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

/// Memory that a thread reuses from row to row.
struct Scratch {
  std::vector<float> voxels; ///< Of a row of them.
  std::vector<float> layer;  ///< Of pixels of one layer.
  std::vector<float> counts; ///< Layers that had a value at a pixel.
};

/// Adds a layer to the sum, or the maximum, of the layers before it.
void addLayer(const std::vector<float>& layer, bool maximum, float* out, std::vector<float>& counts) {
  for (std::size_t x = 0; x < layer.size(); ++x) {
    const float value = layer[x];
    const bool valid = value == value; // Not NaN, in a way that the compiler can take eight of at once.
    if (maximum)
      out[x] = valid && (counts[x] == 0 || value > out[x]) ? value : out[x];
    else
      out[x] += valid ? value : 0.0F;
    counts[x] += valid ? 1.0F : 0.0F;
  }
}

/// Takes the rows of one slice.
template <class Sample>
class Slicer {
public:
  Slicer(const Scan& scan, const std::vector<Sample>& samples, const SliceFrame& frame,
         const SampleOptions& options, const Points* rest)
      : scan_(scan), reader_(scan, samples), frame_(frame), nearest_(options.nearest),
        maximum_(options.maximum), rest_(rest), layers_(layersOf(scan, options.slabMm)),
        toIndex_(scan.indexToLps.inverse()), step_(toIndex_.linear() * frame.right),
        normal_(frame.plane().normal) {
    for (int axis = 0; axis < 3 && !nearest_; ++axis)
      if (step_.cwiseAbs().sum() - std::abs(step_[axis]) < kAlong * std::abs(step_[axis]) / frame.width)
        axis_ = axis;
  }

  void row(int y, float* out, Scratch& scratch) const {
    if (layers_.size() == 1)
      return layer(y, 0, out, scratch);
    const auto width = static_cast<std::size_t>(frame_.width);
    scratch.layer.resize(width);
    scratch.counts.assign(width, 0);
    std::fill(out, out + width, 0.0F);
    for (const double at : layers_) {
      layer(y, at, scratch.layer.data(), scratch);
      addLayer(scratch.layer, maximum_, out, scratch.counts);
    }
    for (std::size_t x = 0; x < width; ++x)
      out[x] = scratch.counts[x] == 0 ? kNothing : maximum_ ? out[x] : out[x] / scratch.counts[x];
  }

private:
  float read(const Vec3& place) const {
    return nearest_ ? reader_.nearest(place.data()) : reader_.linear(place.data());
  }

  void layer(int y, double at, float* out, Scratch& scratch) const {
    std::fill(out, out + frame_.width, kNothing);
    if (rest_)
      return bent(y, at, out);
    const Vec3 start = toIndex_ * (frame_.at(0, y) + at * normal_);
    const auto [begin, end] = insideOf(start, step_, scan_.size, frame_.width);
    if (begin < end && axis_ >= 0)
      return along(start, begin, end, out, scratch.voxels);
    for (int x = begin; x < end; ++x)
      out[x] = read(start + x * step_);
  }

  /// The row runs along an axis of the voxels: first between rows of those, then along them.
  void along(const Vec3& start, int begin, int end, float* out, std::vector<float>& voxels) const {
    const int last = scan_.size[std::size_t(axis_)] - 1;
    const double from = start[axis_], by = step_[axis_];
    const auto inside = [last](double place) { return std::clamp(place, 0.0, static_cast<double>(last)); };
    const auto ends = std::minmax({inside(from + begin * by), inside(from + (end - 1) * by)});
    const int low = static_cast<int>(ends.first), high = std::min(static_cast<int>(ends.second) + 1, last);
    reader_.betweenRows(start, axis_, low, high, voxels);
    for (int x = begin; x < end; ++x) {
      const double place = inside(from + x * by);
      const int cell = static_cast<int>(place);
      const auto part = static_cast<float>(place - cell);
      const float a = voxels[std::size_t(cell - low)];
      const float b = voxels[std::size_t(std::min(cell + 1, high) - low)];
      const float value = a + part * (b - a);
      out[x] = std::isnan(value) ? read(start + x * step_) : reader_.valueOf(value); // Padding is near.
    }
  }

  void bent(int y, double at, float* out) const {
    const Vec3 aside = at * normal_;
    for (int x = 0; x < frame_.width; ++x) {
      const Vec3 rest = rest_->row(Eigen::Index(y) * frame_.width + x).transpose();
      if (const Vec3 place = toIndex_ * (rest + aside); inside(place))
        out[x] = read(place);
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
  const Points* rest_;
  std::vector<double> layers_;
  Eigen::Affine3d toIndex_;
  Vec3 step_, normal_;
  int axis_ = -1; ///< Of the voxels, along which rows of pixels run; none where they run otherwise.
};

} // namespace

void sampleSlice(const Scan& scan, const SliceFrame& frame, const SampleOptions& options, ValueImage& image,
                 const Points* rest) {
  image.width = frame.width;
  image.height = frame.height;
  image.values.resize(std::size_t(frame.width) * std::size_t(frame.height));
  if (scan.voxelCount() == 0) {
    std::fill(image.values.begin(), image.values.end(), kNothing);
    return;
  }
  std::visit(
      [&](const auto& samples) {
        const Slicer slicer(scan, samples, frame, options, rest);
        parallelRanges(frame.height, kRowGrain, options.threads, [&](Eigen::Index begin, Eigen::Index end) {
          Scratch scratch;
          for (Eigen::Index y = begin; y < end; ++y)
            slicer.row(static_cast<int>(y), image.values.data() + y * frame.width, scratch);
        });
      },
      scan.samples);
}

void greyOf(const ValueImage& image, const ValueWindow& window, std::uint8_t background,
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

} // namespace viscera::medical_io
