#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "image_formats/unpack.h"
#include "scalar.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"
#include "xml_tree.h"

// GIFTI, in which brain programs keep surfaces (.surf.gii): XML whose arrays are text, base64 or packed. Its
// points are RAS millimetres.
namespace viscera::medical_io {
namespace {

constexpr std::array<std::pair<std::string_view, Scalar>, 11> kGiftiTypes = {
    {{"NIFTI_TYPE_UINT8", Scalar::uint8},
     {"NIFTI_TYPE_INT8", Scalar::int8},
     {"NIFTI_TYPE_INT16", Scalar::int16},
     {"NIFTI_TYPE_UINT16", Scalar::uint16},
     {"NIFTI_TYPE_INT32", Scalar::int32},
     {"NIFTI_TYPE_UINT32", Scalar::uint32},
     {"NIFTI_TYPE_INT64", Scalar::int64},
     {"NIFTI_TYPE_UINT64", Scalar::uint64},
     {"NIFTI_TYPE_FLOAT32", Scalar::float32},
     {"NIFTI_TYPE_FLOAT64", Scalar::float64},
     {"NIFTI_TYPE_FLOAT", Scalar::float32}}};

constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31U;

std::string_view trimmedText(const XmlElement* element) {
  return element == nullptr ? std::string_view() : trimmed(element->text);
}

class GiftiReader {
public:
  explicit GiftiReader(const FileBytes& file) : file_(file) {}

  RawSurface run() {
    const XmlTree tree = parseXml(file_.view());
    if (!tree.error.empty())
      file_.fail(diagnostic("It is not complete XML: %1", tree.error));
    if (tree.root.name != "GIFTI")
      file_.fail(diagnostic("It does not hold \"GIFTI\": it is not a GIFTI file"), "check its ending");
    const XmlElement& points = arrayOf(tree.root, "NIFTI_INTENT_POINTSET");
    const XmlElement& triangles = arrayOf(tree.root, "NIFTI_INTENT_TRIANGLE");
    raw_.space = Space::ras;
    raw_.coordinates = values<double>(points, loadDouble, parseNumber);
    applyTransforms(points);
    const std::vector<std::int64_t> corners = values<std::int64_t>(triangles, loadInteger, parseInteger);
    for (std::size_t i = 0; i < corners.size(); i += 3)
      raw_.addTriangle(corners[i], corners[i + 1], corners[i + 2]);
    nameByFile();
    return std::move(raw_);
  }

private:
  /// The first array of that intent; more of them are said.
  const XmlElement& arrayOf(const XmlElement& root, std::string_view intent) {
    const XmlElement* found = nullptr;
    int others = 0;
    for (const XmlElement& array : root.children) {
      if (array.name != "DataArray" || array.attribute("Intent") != intent)
        continue;
      if (found != nullptr)
        ++others;
      else
        found = &array;
    }
    if (found == nullptr)
      failWithoutSurface(root);
    if (others > 0 && intent == "NIFTI_INTENT_POINTSET")
      raw_.warnings.push_back(phrase("%n further {surface|surfaces} of the file left out", others));
    return *found;
  }

  [[noreturn]] void failWithoutSurface(const XmlElement& root) const {
    for (const XmlElement& array : root.children)
      if (array.name == "DataArray" && array.attribute("Intent") != "NIFTI_INTENT_POINTSET" &&
          array.attribute("Intent") != "NIFTI_INTENT_TRIANGLE")
        file_.fail(phrase("It holds values at the points of a surface (%1), not a surface",
                          std::string(array.attribute("Intent"))),
                   "open the surface to which they belong, which usually ends in .surf.gii");
    file_.fail("It holds no surface of triangles", "export it as a surface of triangles");
  }

  [[noreturn]] void failIn(const XmlElement& array, const Text& problem) const {
    file_.fail(diagnostic("the array %1: %2", inQuotes(array.attribute("Intent")), problem));
  }

  std::uint64_t dimension(const XmlElement& array, std::string_view key) const {
    const std::optional<std::int64_t> size = parseInteger(trimmed(array.attribute(key)));
    if (!size || *size < 0)
      failIn(array, diagnostic("its %1 is no whole number from 0 on", key));
    return static_cast<std::uint64_t>(*size);
  }

  /// The values of an array of n x 3, row by row.
  template <class Number>
  std::vector<Number> values(const XmlElement& array, Number (*load)(const char*, Scalar, std::endian),
                             std::optional<Number> (*parse)(std::string_view)) const {
    const std::uint64_t rows = dimension(array, "Dim0");
    if (array.attribute("Dimensionality") != "2" || dimension(array, "Dim1") != 3)
      failIn(array, diagnostic("it does not have three values for each element"));
    const std::uint64_t count = saturatedProduct(rows, 3);
    if (count > kMostValues)
      failIn(array, diagnostic("it should have %1 values, more than there are", count));
    const std::string_view encoding = array.attribute("Encoding");
    std::vector<Number> list = encoding == "ASCII" || encoding == "GIFTI_ENCODING_ASCII"
                                   ? wordsOf(array, parse)
                                   : loaded<Number>(array, count, encoding, load);
    if (list.size() != count)
      failIn(array, diagnostic("it should have %1 values, but has %2", count, list.size()));
    return array.attribute("ArrayIndexingOrder") == "ColumnMajorOrder" ? byRows(list, rows) : list;
  }

  template <class Number>
  static std::vector<Number> byRows(const std::vector<Number>& columns, std::uint64_t rows) {
    std::vector<Number> list;
    list.reserve(columns.size());
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        list.push_back(columns[column * static_cast<std::size_t>(rows) + row]);
    return list;
  }

  template <class Number>
  std::vector<Number> wordsOf(const XmlElement& array,
                              std::optional<Number> (*parse)(std::string_view)) const {
    std::string_view rest = trimmedText(array.child("Data"));
    std::vector<Number> list;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      const std::optional<Number> value = parse(word);
      if (!value)
        failIn(array, diagnostic("expected %2, found %1", inQuotes(word), "a number"));
      list.push_back(*value);
    }
    return list;
  }

  template <class Number>
  std::vector<Number> loaded(const XmlElement& array, std::uint64_t count, std::string_view encoding,
                             Number (*load)(const char*, Scalar, std::endian)) const {
    const auto type = lookUp(kGiftiTypes, array.attribute("DataType"));
    if (!type || (std::is_integral_v<Number> && !isWhole(*type)))
      failIn(array, diagnostic("it has the type %1", inQuotes(array.attribute("DataType"))));
    const std::uint64_t stated = saturatedProduct(count, sizeOf(*type));
    const std::string bytes = decoded(array, encoding, stated);
    if (bytes.size() != stated)
      failIn(array, diagnostic("its data do not have the %1 values that it states", count));
    const std::string_view endian = array.attribute("Endian");
    const std::endian order =
        endian == "BigEndian" || endian == "GIFTI_ENDIAN_BIG" ? std::endian::big : std::endian::little;
    std::vector<Number> list;
    list.reserve(bytes.size() / sizeOf(*type));
    for (std::size_t at = 0; at + sizeOf(*type) <= bytes.size(); at += sizeOf(*type))
      list.push_back(load(bytes.data() + at, *type, order));
    return list;
  }

  /// Unpacks at most `most` bytes of what is packed, and one more that tells of a wrong size.
  std::string decoded(const XmlElement& array, std::string_view encoding, std::uint64_t most) const {
    if (encoding == "ExternalFileBinary" || encoding == "GIFTI_ENCODING_EXTBIN")
      file_.fail(phrase("Its values are in another file, %1, which Viscera does not read",
                        inQuotes(array.attribute("ExternalFileName"))),
                 "save it with its values inside (GZipBase64Binary)");
    const bool packed = encoding == "GZipBase64Binary" || encoding == "GIFTI_ENCODING_B64GZ";
    if (!packed && encoding != "Base64Binary" && encoding != "GIFTI_ENCODING_B64BIN")
      failIn(array, diagnostic("it has the unknown encoding %1", inQuotes(encoding)));
    const std::optional<std::string> bytes = decodeBase64(trimmedText(array.child("Data")));
    if (!bytes)
      failIn(array, diagnostic("it is not valid base64: the file is damaged"));
    return packed ? unpacked(file_, *bytes, Packing::zlib, saturatedSum(most, 1)) : *bytes;
  }

  /// Points in a space of their program are brought to the scan where the file says how. A matrix to a
  /// standard brain is left, because it would deform the patient's.
  void applyTransforms(const XmlElement& points) {
    for (const XmlElement& child : points.children) {
      if (child.name != "CoordinateSystemTransformMatrix")
        continue;
      const std::string from(trimmedText(child.child("DataSpace"))),
          to(trimmedText(child.child("TransformedSpace")));
      const Eigen::Matrix4d matrix = matrixOf(points, child);
      if (matrix.isIdentity(0))
        continue;
      const bool ofScan = to == "NIFTI_XFORM_SCANNER_ANAT" || to == "NIFTI_XFORM_ALIGNED_ANAT";
      const bool unknown = from.empty() || from == "NIFTI_XFORM_UNKNOWN";
      if (!applied_ && ofScan && unknown) {
        apply(matrix);
        raw_.warnings.push_back("its points were moved to the scan by the matrix that the file states");
      } else {
        raw_.warnings.push_back(phrase("its matrix from %1 to %2 was not applied", from, to));
      }
    }
  }

  Eigen::Matrix4d matrixOf(const XmlElement& points, const XmlElement& element) const {
    std::string_view rest = trimmedText(element.child("MatrixData"));
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        const std::optional<double> value = parseNumber(takeWord(rest));
        if (!value || !std::isfinite(*value))
          failIn(points, diagnostic("its matrix does not have 16 numbers"));
        matrix(row, column) = *value;
      }
    return matrix;
  }

  void apply(const Eigen::Matrix4d& matrix) {
    applied_ = true;
    for (std::size_t i = 0; i < raw_.coordinates.size(); i += 3) {
      Eigen::Map<Vec3> point(raw_.coordinates.data() + i);
      point = (matrix.topLeftCorner<3, 3>() * point + matrix.topRightCorner<3, 1>()).eval();
    }
  }

  /// "lh.pial" for lh.pial.surf.gii.
  void nameByFile() {
    const std::string stem = stemOf(file_.file);
    constexpr std::string_view kSurface = ".surf";
    if (lowered(stem).ends_with(kSurface))
      raw_.name = stem.substr(0, stem.size() - kSurface.size());
  }

  const FileBytes& file_;
  RawSurface raw_;
  bool applied_ = false;
};

} // namespace

RawSurface readGifti(const FileBytes& file) {
  return GiftiReader(file).run();
}

} // namespace viscera::medical_io
