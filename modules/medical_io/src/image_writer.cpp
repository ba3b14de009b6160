#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <zlib.h>

#include "file_bytes.h"
#include "text_scanner.h"
#include "vector_image.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {
namespace {

static_assert(std::endian::native == std::endian::little, "the headers say so");

constexpr std::size_t kNiftiHeader = 352;
constexpr int kLongestNiftiAxis = 32767;
constexpr std::size_t kWrittenBlock = std::size_t{1} << 20U;

/// The header data of both formats, and the values of an image.
struct WrittenImage {
  std::array<int, 3> size = {};
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
  int layers = 1; ///< Beside each other, as NRRD has them.
  int phases = 1; ///< In NIfTI one after the other; in NRRD `layers`.
  double intervalMs = 0;
  bool vectors = false; ///< Three components, one after the other: NIfTI only.
  int niftiType = 0, bits = 0;
  std::string nrrdType;
  double slope = 1, intercept = 0;
  const char* data = nullptr;
  std::size_t bytes = 0;
  std::string keys; ///< Further lines of an NRRD header.
};

template <class Sample>
void setType(WrittenImage& image) {
  struct Names {
    int nifti;
    const char* nrrd;
  };
  const Names names = std::is_same_v<Sample, std::int8_t>     ? Names{256, "signed char"}
                      : std::is_same_v<Sample, std::uint8_t>  ? Names{2, "unsigned char"}
                      : std::is_same_v<Sample, std::int16_t>  ? Names{4, "short"}
                      : std::is_same_v<Sample, std::uint16_t> ? Names{512, "unsigned short"}
                      : std::is_same_v<Sample, std::int32_t>  ? Names{8, "int"}
                      : std::is_same_v<Sample, std::uint32_t> ? Names{768, "unsigned int"}
                                                              : Names{16, "float"};
  image.niftiType = names.nifti;
  image.nrrdType = names.nrrd;
  image.bits = static_cast<int>(8 * sizeof(Sample));
}

template <class Sample>
void setValues(WrittenImage& image, const std::vector<Sample>& samples) {
  setType<Sample>(image);
  image.data = reinterpret_cast<const char*>(samples.data());
  image.bytes = samples.size() * sizeof(Sample);
}

template <typename T>
void put(std::string& header, std::size_t offset, T value) {
  std::memcpy(header.data() + offset, &value, sizeof value);
}

/// The fields of nifti1.h.
std::string niftiBytes(const WrittenImage& image) {
  std::string header(kNiftiHeader, '\0');
  put<std::int32_t>(header, 0, 348);
  put<std::int16_t>(header, 40, image.vectors ? 5 : image.phases > 1 ? 4 : 3);
  put<float>(header, 76, 1);
  const Eigen::Affine3d ras = Eigen::Scaling(-1.0, -1.0, 1.0) * image.indexToLps;
  for (std::size_t d = 0; d < 7; ++d)
    put<std::int16_t>(header, 42 + 2 * d, static_cast<std::int16_t>(d < 3 ? image.size[d] : 1));
  put<std::int16_t>(header, 48, static_cast<std::int16_t>(image.phases));
  if (image.phases > 1)
    put<float>(header, 92, static_cast<float>(image.intervalMs));
  if (image.vectors) {
    constexpr std::int16_t kIntentVector = 1007;
    put<std::int16_t>(header, 50, 3);
    put<std::int16_t>(header, 68, kIntentVector);
  }
  for (int d = 0; d < 3; ++d)
    put<float>(header, 80 + 4 * std::size_t(d), static_cast<float>(ras.linear().col(d).norm()));
  put<std::int16_t>(header, 70, static_cast<std::int16_t>(image.niftiType));
  put<std::int16_t>(header, 72, static_cast<std::int16_t>(image.bits));
  put<float>(header, 108, static_cast<float>(kNiftiHeader));
  put<float>(header, 112, static_cast<float>(image.slope));
  put<float>(header, 116, static_cast<float>(image.intercept));
  header[123] = static_cast<char>(image.phases > 1 ? 2 + 16 : 2); // mm, ms
  put<std::int16_t>(header, 254, 1);                              // The sform is the scanner's.
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      put<float>(header, 280 + 16 * row + 4 * column,
                 static_cast<float>(ras.matrix()(static_cast<int>(row), static_cast<int>(column))));
  std::memcpy(header.data() + 344, "n+1", 4);
  return header;
}

std::string vectorText(const Vec3& v) {
  return "(" + exactNumber(v.x()) + "," + exactNumber(v.y()) + "," + exactNumber(v.z()) + ")";
}

std::string nrrdText(const WrittenImage& image) {
  const bool listed = image.layers > 1;
  std::string text = "NRRD0005\ntype: " + image.nrrdType + "\ndimension: " + (listed ? "4" : "3") +
                     "\nspace: left-posterior-superior\nsizes:";
  if (listed)
    text += " " + std::to_string(image.layers);
  for (const int n : image.size)
    text += " " + std::to_string(n);
  text += std::string("\nspace directions:") + (listed ? " none" : "");
  for (int axis = 0; axis < 3; ++axis)
    text += " " + vectorText(image.indexToLps.linear().col(axis));
  return text + "\nkinds:" + (listed ? " list" : "") +
         " domain domain domain\nendian: little\nencoding: gzip\nspace origin: " +
         vectorText(image.indexToLps.translation()) + "\n" + image.keys + "\n";
}

/// gzip, block by block.
class Packer {
public:
  explicit Packer(std::ostream& out) : out_(out), buffer_(kWrittenBlock) {
    constexpr int kGzip = MAX_WBITS + 16;
    if (deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw CannotCreateError(misuse("It cannot be packed: zlib does not start"));
  }
  ~Packer() { deflateEnd(&stream_); }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;

  void write(const char* data, std::size_t size) {
    for (std::size_t at = 0; at < size; at += kWrittenBlock)
      push(data + at, std::min(kWrittenBlock, size - at), Z_NO_FLUSH);
  }
  void finish() { push(nullptr, 0, Z_FINISH); }

private:
  void push(const char* data, std::size_t size, int flush) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data));
    stream_.avail_in = static_cast<uInt>(size);
    do {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      if (const int state = deflate(&stream_, flush);
          state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
        throw std::bad_alloc();
      out_.write(reinterpret_cast<const char*>(buffer_.data()),
                 static_cast<std::streamsize>(buffer_.size() - stream_.avail_out));
    } while (stream_.avail_out == 0);
  }

  std::ostream& out_;
  std::vector<Bytef> buffer_;
  z_stream stream_{};
};

bool isNrrd(const std::filesystem::path& file) {
  const std::string ending = extensionOf(file);
  if (ending == ".nrrd" || ending == ".seg.nrrd")
    return true;
  if (ending != ".nii" && ending != ".nii.gz")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(ending)), file.string(),
                            phrase("let its name end in %1", ".nii.gz, .nii, .nrrd"));
  return false;
}

void writeImage(const std::filesystem::path& file, const WrittenImage& image) {
  const bool nrrd = isNrrd(file);
  if (!nrrd && *std::max_element(image.size.begin(), image.size.end()) > kLongestNiftiAxis)
    throw DataError("It has more than 32767 voxels along a side, which NIfTI cannot hold", file.string(),
                    phrase("let its name end in %1", ".nrrd"));
  writeAtomically(file, [&](std::ostream& out) {
    const std::string header = nrrd ? nrrdText(image) : niftiBytes(image);
    if (extensionOf(file) == ".nii") {
      out << header;
      out.write(image.data, static_cast<std::streamsize>(image.bytes));
      return;
    }
    if (nrrd)
      out << header; // Only its voxels are packed.
    Packer packer(out);
    if (!nrrd)
      packer.write(header.data(), header.size());
    packer.write(image.data, image.bytes);
    packer.finish();
  });
}

/// The values of all samples as `Out`.
template <class Out>
std::vector<Out> valuesOf(const Scan& scan) {
  std::vector<Out> values;
  values.reserve(scan.voxelCount());
  std::visit(
      [&](const auto& samples) {
        for (const auto sample : samples) {
          const double value = scan.slope * double(sample) + scan.intercept;
          values.push_back(static_cast<Out>(value));
        }
      },
      scan.samples);
  return values;
}

bool isWhole(double value) {
  return value == std::floor(value);
}

/// Values instead of samples, for a format that knows no slope.
void writeValues(const std::filesystem::path& file, const Scan& scan, WrittenImage image) {
  const bool fractions = std::holds_alternative<std::vector<float>>(scan.samples);
  const auto [low, high] = std::visit(
      [&](const auto& samples) -> std::array<double, 2> {
        if (samples.empty())
          return {0, 0};
        const auto [a, b] = std::minmax_element(samples.begin(), samples.end());
        const double x = scan.slope * double(*a) + scan.intercept,
                     y = scan.slope * double(*b) + scan.intercept;
        return {std::min(x, y), std::max(x, y)};
      },
      scan.samples);
  const auto fits = [low = low, high = high]<class T>(T) {
    return low >= double(std::numeric_limits<T>::min()) && high <= double(std::numeric_limits<T>::max());
  };
  const auto write = [&](const auto& values) {
    setValues(image, values);
    writeImage(file, image);
  };
  if (fractions || !isWhole(scan.slope) || !isWhole(scan.intercept) || !fits(std::int32_t()))
    write(valuesOf<float>(scan));
  else if (fits(std::int16_t()))
    write(valuesOf<std::int16_t>(scan));
  else
    write(valuesOf<std::int32_t>(scan));
}

std::string colorText(const Vec3& color) {
  return exactNumber(color.x()) + " " + exactNumber(color.y()) + " " + exactNumber(color.z());
}

/// The keys as 3D Slicer writes them.
std::string segmentKeys(const LabelMap& map) {
  std::string keys;
  for (std::size_t s = 0; s < map.segments.size(); ++s) {
    const Segment& segment = map.segments[s];
    const std::string prefix = "Segment" + std::to_string(s) + "_";
    std::string name = segment.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r' || c == '\\'; }, ' ');
    keys += prefix + "ID:=Segment_" + std::to_string(s + 1) + "\n" + prefix + "Name:=" + name + "\n" +
            prefix + "LabelValue:=" + std::to_string(segment.label) + "\n" + prefix +
            "Layer:=" + std::to_string(segment.layer) + "\n" + prefix + "Color:=" + colorText(segment.color) +
            "\n";
  }
  return keys;
}

/// The labels of all layers that are written, beside each other.
template <class Label>
std::vector<Label> labelsOf(const LabelMap& map, std::size_t layers) {
  std::vector<Label> values(map.voxelCount() * layers, 0);
  for (std::size_t layer = map.layers.size(); layer-- > 0;)
    for (std::size_t v = 0; v < map.voxelCount(); ++v)
      if (const std::uint16_t number = map.layers[layer][v]; number > 0)
        values[layers == 1 ? v : v * layers + layer] =
            static_cast<Label>(map.segments[std::size_t{number} - 1].label);
  return values;
}

/// Labels are all that NIfTI keeps of segments.
void requireLabelsOfTheirOwn(const LabelMap& map, const std::filesystem::path& file) {
  std::set<std::int64_t> labels;
  for (const Segment& segment : map.segments)
    if (!labels.insert(segment.label).second)
      throw DataError(
          phrase("Two of its segments have the label %1, which NIfTI cannot tell apart", segment.label),
          file.string(), phrase("let its name end in %1", ".seg.nrrd"));
}

/// Fails where a series cannot be one image: without phases, or of different grids.
template <class Image>
void requireOneGrid(const std::filesystem::path& file, std::span<const Image> phases) {
  if (phases.empty())
    throw DataError(misuse("there is no phase to write"), file.string());
  for (const Image& phase : phases)
    if (phase.size != phases.front().size || !phase.indexToLps.isApprox(phases.front().indexToLps))
      throw DataError(misuse("its phases have different grids"), file.string());
}

/// The keys of 3D Slicer's sequences.
std::string sequenceKeys(std::size_t phases, double intervalMs) {
  std::string keys = "axis 0 index type:=numeric\naxis 0 index unit:=ms\naxis 0 index values:=";
  for (std::size_t phase = 0; phase < phases; ++phase)
    keys += (phase > 0 ? " " : "") + exactNumber(static_cast<double>(phase) * intervalMs);
  return keys + "\n";
}

/// Writes whole volumes of one grid and one type over time.
template <class Sample>
void writePhases(const std::filesystem::path& file, const std::vector<const std::vector<Sample>*>& phases,
                 double intervalMs, WrittenImage image) {
  const bool nrrd = isNrrd(file);
  const std::size_t count = phases.size(), voxels = phases.front()->size();
  std::vector<Sample> all(count * voxels);
  for (std::size_t phase = 0; phase < count; ++phase)
    for (std::size_t v = 0; v < voxels; ++v)
      all[nrrd ? v * count + phase : phase * voxels + v] = (*phases[phase])[v];
  image.phases = static_cast<int>(count);
  image.layers = nrrd ? image.phases : 1;
  image.intervalMs = intervalMs;
  if (nrrd)
    image.keys = sequenceKeys(count, intervalMs) + image.keys;
  setValues(image, all);
  writeImage(file, image);
}

} // namespace

void writeScanSeries(const std::filesystem::path& file, std::span<const Scan> phases, double intervalMs) {
  requireOneGrid(file, phases);
  WrittenImage image;
  image.size = phases.front().size;
  image.indexToLps = phases.front().indexToLps;
  std::visit(
      [&](const auto& first) {
        using Samples = std::decay_t<decltype(first)>;
        std::vector<const Samples*> all;
        for (const Scan& phase : phases) {
          const auto* samples = std::get_if<Samples>(&phase.samples);
          if (!samples || phase.slope != 1 || phase.intercept != 0)
            throw DataError(misuse("its phases have samples of different types, or a slope"), file.string());
          all.push_back(samples);
        }
        writePhases(file, all, intervalMs, image);
      },
      phases.front().samples);
}

void writeLabelSeries(const std::filesystem::path& file, std::span<const LabelMap> phases,
                      double intervalMs) {
  requireOneGrid(file, phases);
  WrittenImage image;
  image.size = phases.front().size;
  image.indexToLps = phases.front().indexToLps;
  std::vector<std::vector<std::int16_t>> labels;
  for (const LabelMap& phase : phases) {
    requireLabelsOfTheirOwn(phase, file);
    for (const Segment& segment : phase.segments)
      if (segment.label > std::numeric_limits<std::int16_t>::max())
        throw DataError(misuse("a series has labels up to 32767"), file.string());
    labels.push_back(labelsOf<std::int16_t>(phase, 1));
  }
  std::vector<const std::vector<std::int16_t>*> all;
  for (const std::vector<std::int16_t>& phase : labels)
    all.push_back(&phase);
  if (isNrrd(file))
    image.keys = segmentKeys(phases.front());
  writePhases(file, all, intervalMs, image);
}

void writeVectorImage(const std::filesystem::path& file, const std::array<int, 3>& size,
                      const Eigen::Affine3d& indexToLps, const Points& vectors) {
  WrittenImage image;
  image.size = size;
  image.indexToLps = indexToLps;
  image.vectors = true;
  constexpr int kNiftiDouble = 64;
  image.niftiType = kNiftiDouble;
  image.bits = kNiftiDouble;
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::ColMajor> components = vectors;
  image.data = reinterpret_cast<const char*>(components.data());
  image.bytes = sizeof(double) * static_cast<std::size_t>(components.size());
  writeImage(file, image);
}

void writeScan(const std::filesystem::path& file, const Scan& scan) {
  WrittenImage image;
  image.size = scan.size;
  image.indexToLps = scan.indexToLps;
  if (isNrrd(file) && (scan.slope != 1 || scan.intercept != 0)) {
    writeValues(file, scan, image);
    return;
  }
  image.slope = scan.slope;
  image.intercept = scan.intercept;
  std::visit([&](const auto& samples) { setValues(image, samples); }, scan.samples);
  writeImage(file, image);
}

void writeLabelMap(const std::filesystem::path& file, const LabelMap& map) {
  WrittenImage image;
  image.size = map.size;
  image.indexToLps = map.indexToLps;
  if (isNrrd(file)) {
    image.layers = static_cast<int>(std::max<std::size_t>(map.layers.size(), 1));
    image.keys = segmentKeys(map);
  } else {
    requireLabelsOfTheirOwn(map, file);
  }
  std::int64_t largest = 0;
  for (const Segment& segment : map.segments)
    largest = std::max(largest, segment.label);
  const auto write = [&](const auto& values) {
    setValues(image, values);
    writeImage(file, image);
  };
  const auto layers = static_cast<std::size_t>(image.layers);
  if (largest <= std::numeric_limits<std::int16_t>::max())
    write(labelsOf<std::int16_t>(map, layers));
  else if (largest <= std::numeric_limits<std::int32_t>::max())
    write(labelsOf<std::int32_t>(map, layers));
  else
    throw DataError("It has a label above 2147483647", file.string(), "give its labels smaller numbers");
}

} // namespace viscera::medical_io
