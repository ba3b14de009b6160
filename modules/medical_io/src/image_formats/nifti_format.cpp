#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "image_formats/analyze_header.h"
#include "image_formats/data_file.h"
#include "image_formats/raw_image.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "xml_tree.h"

/// NIfTI-1 and NIfTI-2, in one file or as header and voxels, as nifti1.h and nifti2.h describe them
/// (nifti.nimh.nih.gov).
namespace viscera::medical_io {
namespace {

/// Where the fields of a version are, and how long its header is.
struct Layout {
  std::size_t bytes, magic, dim, pixdim, datatype, dataOffset, slope, intercept, units;
  std::size_t qformCode, sformCode, quaternion, qOffset, sform;
  std::string_view halfMagic; ///< Of a header whose voxels are in another file.
};
constexpr Layout kNifti1 = {348, 344, 40, 76, 70, 108, 112, 116, 123, 252, 254, 256, 268, 280, "ni1"};
constexpr Layout kNifti2 = {540, 4, 16, 104, 12, 168, 176, 184, 500, 344, 348, 352, 376, 400, "ni2"};
constexpr int kMostNiftiDimensions = 7;
/// The most of a packed header with its extensions: tables of names take some ten kilobytes.
constexpr std::uint64_t kMostNiftiHeaderBytes = std::uint64_t{1} << 22U;
/// Two statements of where the image is that differ by more than this part of a voxel are reported.
constexpr double kAgreement = 0.5;

/// A scale of an Analyze file that is larger comes from a program that kept something else there.
constexpr double kLargestSpmScale = 1e10;
/// Less than this is left of the quaternion's length by rounding alone: a half turn, as in nifti1_io.c.
constexpr double kHalfTurn = 1e-7;

/// The fields that both versions of the header have.
struct Header {
  std::size_t bytes = 0;
  std::endian order = std::endian::little;
  std::array<std::int64_t, kMostNiftiDimensions + 1> dim = {};
  std::array<double, kMostNiftiDimensions + 1> pixdim = {};
  int datatype = 0;
  double dataOffset = 0, slope = 0, intercept = 0;
  int qformCode = 0, sformCode = 0, units = 0;
  std::array<double, 3> quaternion = {};
  Vec3 qOffset = Vec3::Zero();
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> sform = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>::Zero();
  bool twoFiles = false;
  std::optional<AnalyzeGrid> analyze; ///< The place of an image of the older format.
};

template <typename T>
T at(std::string_view bytes, std::size_t offset, std::endian order) {
  return loadValue<T>(bytes.data() + offset, order);
}

/// The byte order in which the header states its own size; nothing for no NIfTI header of that version.
std::optional<std::endian> orderOf(std::string_view bytes, const Layout& layout) {
  for (const std::endian order : {std::endian::little, std::endian::big})
    if (bytes.size() >= layout.bytes && at<std::uint32_t>(bytes, 0, order) == layout.bytes &&
        bytes[layout.magic] == 'n')
      return order;
  return std::nullopt;
}

/// The versions differ in places and in types: of sizes, of real numbers, of the offset, of units and codes.
template <typename Size, typename Real, typename Offset, typename Units, typename Code>
Header headerBy(const Layout& layout, std::string_view bytes, std::endian order) {
  Header h;
  h.bytes = layout.bytes;
  h.order = order;
  const auto real = [&](std::size_t first, std::size_t i = 0) -> double {
    return at<Real>(bytes, first + sizeof(Real) * i, order);
  };
  for (std::size_t d = 0; d <= kMostNiftiDimensions; ++d) {
    h.dim[d] = at<Size>(bytes, layout.dim + sizeof(Size) * d, order);
    h.pixdim[d] = real(layout.pixdim, d);
  }
  h.datatype = at<std::int16_t>(bytes, layout.datatype, order);
  h.dataOffset = static_cast<double>(at<Offset>(bytes, layout.dataOffset, order));
  h.slope = real(layout.slope);
  h.intercept = real(layout.intercept);
  h.units = at<Units>(bytes, layout.units, order);
  h.qformCode = at<Code>(bytes, layout.qformCode, order);
  h.sformCode = at<Code>(bytes, layout.sformCode, order);
  for (std::size_t i = 0; i < 3; ++i) {
    h.quaternion[i] = real(layout.quaternion, i);
    h.qOffset[static_cast<int>(i)] = real(layout.qOffset, i);
  }
  for (std::size_t i = 0; i < 12; ++i)
    h.sform.data()[i] = real(layout.sform, i);
  h.twoFiles = bytes.substr(layout.magic, 3) == layout.halfMagic;
  return h;
}

std::optional<Header> headerIn(std::string_view bytes) {
  if (const auto order = orderOf(bytes, kNifti1))
    return headerBy<std::int16_t, float, float, unsigned char, std::int16_t>(kNifti1, bytes, *order);
  if (const auto order = orderOf(bytes, kNifti2))
    return headerBy<std::int64_t, double, std::int64_t, std::int32_t, std::int32_t>(kNifti2, bytes, *order);
  return std::nullopt;
}

/// The older format has the same fields in the same places, except for the position.
std::optional<Header> analyzeHeaderIn(const FileBytes& file, std::string_view bytes) {
  const std::string extension = extensionOf(file.file);
  const auto order = extension.starts_with(".nii") ? std::nullopt : orderOfAnalyze(bytes);
  if (!order)
    return std::nullopt;
  Header h = headerBy<std::int16_t, float, float, unsigned char, std::int16_t>(kNifti1, bytes, *order);
  h.units = 0;
  h.twoFiles = true;
  // Other programs than SPM, which scales values, leave the rest as it comes.
  h.intercept = 0;
  h.slope = std::abs(h.slope) < kLargestSpmScale ? h.slope : 1;
  h.analyze = analyzeGrid(bytes, *order);
  return h;
}

Header headerOf(const FileBytes& file, std::string_view bytes) {
  if (const auto header = headerIn(bytes))
    return *header;
  if (const auto header = analyzeHeaderIn(file, bytes))
    return *header;
  if (bytes.size() < kNifti1.bytes)
    file.fail(diagnostic("the file is cut off: it has %n {byte|bytes}, a NIfTI header alone has 348",
                         bytes.size()));
  file.fail(diagnostic("It is not a NIfTI image: it has no NIfTI header"),
            "check what the file is and where it came from");
}

/// The fourth axis counts phases.
std::array<int, 3> gridOf(const FileBytes& file, const Header& h) {
  constexpr std::size_t axes = 4;
  if (h.dim[0] < 2 || h.dim[0] > kMostNiftiDimensions)
    file.fail(diagnostic("its header is damaged: an image has 2 to 7 dimensions, not %1", h.dim[0]));
  for (std::size_t d = axes + 1; d <= static_cast<std::size_t>(h.dim[0]); ++d)
    if (h.dim[d] > 1)
      file.fail(phrase("It has several values per voxel (%1)", h.dim[d]), "save it with one value per voxel");
  return {axisSize(file, h.dim[1], "i"), axisSize(file, h.dim[2], "j"),
          h.dim[0] < 3 ? 1 : axisSize(file, h.dim[3], "k")};
}

Scalar scalarOf(const FileBytes& file, int datatype) {
  static constexpr std::array<std::pair<int, Scalar>, 13> kTypes = {{{2, Scalar::uint8},
                                                                     {4, Scalar::int16},
                                                                     {8, Scalar::int32},
                                                                     {16, Scalar::float32},
                                                                     {64, Scalar::float64},
                                                                     {256, Scalar::int8},
                                                                     {512, Scalar::uint16},
                                                                     {768, Scalar::uint32},
                                                                     {1024, Scalar::int64},
                                                                     {1280, Scalar::uint64},
                                                                     // SPM's, in Analyze files.
                                                                     {130, Scalar::int8},
                                                                     {132, Scalar::uint16},
                                                                     {136, Scalar::uint32}}};
  if (const auto scalar = lookUp(kTypes, datatype))
    return *scalar;
  file.fail(phrase("its voxels are no plain numbers (%1)", "NIfTI data type " + std::to_string(datatype)),
            "save it with one value per voxel");
}

bool usable(const Eigen::Affine3d& grid) {
  return grid.matrix().allFinite() && grid.linear().determinant() != 0;
}

Eigen::Affine3d sformOf(const Header& h) {
  Eigen::Affine3d grid;
  grid.matrix() << h.sform, 0, 0, 0, 1;
  return grid;
}

/// Method 2 of nifti1.h: a unit quaternion, the voxel sizes, and a flip of k when pixdim[0] is negative.
Eigen::Affine3d qformOf(const Header& h) {
  const auto [b, c, d] = h.quaternion;
  const double rest = 1 - (b * b + c * c + d * d);
  Eigen::Quaterniond rotation(rest > kHalfTurn ? std::sqrt(rest) : 0.0, b, c, d);
  rotation.normalize();
  Eigen::Affine3d grid = Eigen::Affine3d::Identity();
  grid.linear() = rotation.toRotationMatrix() *
                  Vec3(h.pixdim[1], h.pixdim[2], h.pixdim[0] < 0 ? -h.pixdim[3] : h.pixdim[3]).asDiagonal();
  grid.translation() = h.qOffset;
  return grid;
}

/// How far two grids lie apart at the corners of the image, in voxels.
double differenceInVoxels(const Eigen::Affine3d& a, const Eigen::Affine3d& b,
                          const std::array<int, 3>& size) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index((corner & 1) != 0 ? size[0] - 1 : 0, (corner & 2) != 0 ? size[1] - 1 : 0,
                     (corner & 4) != 0 ? size[2] - 1 : 0);
    largest = std::max(largest, (a.linear().inverse() * (b * index - a * index)).norm());
  }
  return largest;
}

/// The grid in RAS, in the file's unit.
Eigen::Affine3d gridInRas(const FileBytes& file, const Header& h, RawImage& raw) {
  const Eigen::Affine3d sform = sformOf(h), qform = qformOf(h);
  const bool hasQform = h.qformCode > 0 && usable(qform);
  if (h.sformCode > 0 && usable(sform)) {
    if (hasQform && differenceInVoxels(sform, qform, raw.size) > kAgreement)
      raw.warnings.push_back("its sform and qform place the image differently; the sform is used");
    return sform;
  }
  if (h.sformCode > 0)
    raw.warnings.push_back("its sform is singular or not finite and is not used");
  if (hasQform)
    return qform;
  raw.warnings.push_back(
      "it does not say where the patient's sides are; axes are taken as right, front and up");
  Eigen::Affine3d grid = Eigen::Affine3d::Identity();
  for (int d = 0; d < 3; ++d)
    grid.linear()(d, d) = h.pixdim[static_cast<std::size_t>(d) + 1];
  if (!usable(grid))
    file.fail(diagnostic("the sizes of its voxels are missing, zero or not finite"));
  return grid;
}

double unitInMm(int units, std::vector<Text>& warnings) {
  switch (units & 7) {
  case 1:
    warnings.push_back(phrase("converted from %1 to mm", "m"));
    return 1000;
  case 3:
    warnings.push_back(phrase("converted from %1 to mm", "µm"));
    return 1e-3;
  default:
    return 1;
  }
}

std::optional<double> channel(const XmlElement& label, std::string_view name) {
  const auto value = parseNumber(label.attribute(name));
  return value && *value >= 0 && *value <= 1 ? value : std::nullopt;
}

/// The table that TotalSegmentator and Connectome Workbench put into the file.
void addLabelTable(const XmlElement& element, std::vector<StatedSegment>& list) {
  if (element.name == "LabelTable")
    for (const XmlElement& label : element.children)
      if (const auto key = parseInteger(label.attribute("Key")); label.name == "Label" && key && *key != 0) {
        StatedSegment segment{*key, 0, std::string(trimmed(label.text)), {}};
        const auto red = channel(label, "Red"), green = channel(label, "Green"),
                   blue = channel(label, "Blue");
        if (red && green && blue)
          segment.color = Vec3(*red, *green, *blue);
        list.push_back(std::move(segment));
      }
  for (const XmlElement& child : element.children)
    addLabelTable(child, list);
}

/// Extensions lie between the header and the end of `bytes`: size, code, contents. One that is damaged ends
/// the list.
void readExtensions(std::string_view bytes, const Header& h, RawImage& raw) {
  std::size_t position = h.bytes + 4;
  if (bytes.size() < position || bytes[h.bytes] == 0)
    return;
  while (position + 8 <= bytes.size()) {
    const auto size = at<std::int32_t>(bytes, position, h.order);
    if (size < 8 || static_cast<std::size_t>(size) > bytes.size() - position)
      return;
    std::string_view contents = bytes.substr(position + 8, static_cast<std::size_t>(size) - 8);
    contents = contents.substr(0, contents.find('\0'));
    if (contents.find("LabelTable") != contents.npos) {
      const XmlTree tree = parseXml(trimmed(contents));
      if (tree.error.empty())
        addLabelTable(tree.root, raw.stated);
      else
        raw.warnings.push_back("the table of names in it cannot be read");
    }
    position += static_cast<std::size_t>(size);
  }
}

std::uint64_t dataOffset(const FileBytes& file, const Header& h) {
  if (h.dataOffset == 0)
    return h.twoFiles ? 0 : h.bytes + 4;
  if (!(h.dataOffset >= (h.twoFiles ? 0.0 : static_cast<double>(h.bytes))) || h.dataOffset > 1e15)
    file.fail(diagnostic("its header is damaged: the voxels cannot begin at byte %1",
                         std::to_string(h.dataOffset)));
  return static_cast<std::uint64_t>(h.dataOffset);
}

bool isPacked(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

/// Unpacks at most `most` bytes of a file.
std::string beginOf(const FileBytes& file, std::uint64_t most) {
  return isPacked(file.view()) ? unpacked(file, file.view(), Packing::zlib, most)
                               : file.bytes.substr(0, static_cast<std::size_t>(most));
}

/// The file with the other half of an image in two files: `part` is ".hdr" or ".img". As small or large
/// letters as they come, packed or not.
std::optional<std::filesystem::path> otherHalf(const std::filesystem::path& file, std::string_view part) {
  for (const bool large : {false, true})
    for (const char* packed : {"", ".gz"}) {
      std::string ending = std::string(part) + packed;
      if (large)
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
      std::error_code error;
      const std::filesystem::path name = file.parent_path() / (stemOf(file) + ending);
      if (std::filesystem::is_regular_file(name, error))
        return name;
    }
  return std::nullopt;
}

/// A file of voxels alone gives its place to its header; it keeps its name, under which the user knows it.
void replaceByHeader(FileBytes& file) {
  const std::string extension = extensionOf(file.file);
  if ((extension != ".img" && extension != ".img.gz") || headerIn(beginOf(file, kNifti2.bytes)))
    return;
  file.bytes = {};
  const auto header = otherHalf(file.file, ".hdr");
  if (!header)
    throw NoInputError(phrase("the other file that belongs to it, %1, is not beside it",
                              inQuotes(stemOf(file.file) + ".hdr")),
                       file.name(), "put both files into one folder");
  FileBytes other = readWholeFile(*header);
  file.bytes = std::move(other.bytes);
  file.length = other.length;
}

/// Where the voxels of a header alone are.
StoredValues inOtherHalf(const FileBytes& file) {
  const auto voxels = otherHalf(file.file, ".img");
  if (!voxels)
    throw NoInputError(phrase("the other file that belongs to it, %1, is not beside it",
                              inQuotes(stemOf(file.file) + ".img")),
                       file.name(), "put both files into one folder");
  StoredValues stored;
  stored.beside = voxels->filename().string();
  stored.packing = extensionOf(*voxels) == ".img.gz" ? Packing::zlib : Packing::none;
  return stored;
}

/// Times of the volumes, by the fourth axis.
RawTimes timesOf(const Header& h) {
  RawTimes times;
  times.step = std::isfinite(h.pixdim[4]) ? h.pixdim[4] : 0;
  switch (h.units & 0x38) {
  case 8:
    times.unit = "s";
    break;
  case 16:
    times.unit = "ms";
    break;
  case 24:
    times.unit = "us";
    break;
  default:
    break;
  }
  return times;
}

/// The place of the voxels, in mm LPS.
void placeVoxels(const FileBytes& file, const Header& h, RawImage& raw) {
  if (h.analyze) {
    raw.indexToLps = h.analyze->indexToLps;
    raw.space = h.analyze->axes;
    raw.warnings.insert(raw.warnings.end(), h.analyze->warnings.begin(), h.analyze->warnings.end());
    return;
  }
  raw.space = "RAS";
  const Eigen::Affine3d ras = gridInRas(file, h, raw);
  raw.indexToLps = Eigen::Scaling(Vec3(-1, -1, 1) * unitInMm(h.units, raw.warnings)) * ras;
  raw.indexToLps.makeAffine();
}

} // namespace

ImageHeader niftiHeader(FileBytes& file) {
  replaceByHeader(file);
  const Header h = headerOf(file, beginOf(file, kNifti2.bytes));
  ImageHeader result;
  RawImage& raw = result.image;
  raw.size = gridOf(file, h);
  raw.layers = h.dim[0] < 4 ? 1 : axisSize(file, h.dim[4], "the volumes");
  raw.overTime = raw.layers > 1;
  raw.times = timesOf(h);
  raw.scalar = scalarOf(file, h.datatype);
  raw.order = h.order;
  if (h.slope != 0 && std::isfinite(h.slope) && std::isfinite(h.intercept)) {
    raw.slope = h.slope;
    raw.intercept = h.intercept;
  }
  placeVoxels(file, h, raw);
  if (h.twoFiles)
    result.stored = inOtherHalf(file);
  else
    result.stored.packing = isPacked(file.view()) ? Packing::zlib : Packing::none;
  result.stored.skippedBytes = dataOffset(file, h);
  const std::uint64_t most =
      h.twoFiles ? kMostNiftiHeaderBytes : std::min(result.stored.skippedBytes, kMostNiftiHeaderBytes);
  if (!h.analyze)
    readExtensions(beginOf(file, most), h, raw);
  return result;
}

} // namespace viscera::medical_io
