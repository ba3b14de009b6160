#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

#include "image_formats/data_file.h"
#include "image_formats/file_list.h"
#include "image_formats/mitk_labels.h"
#include "image_formats/raw_image.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

/// NRRD (teem.sourceforge.net/nrrd/format.html) with the fields of 3D Slicer's segmentations.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kMostNrrdDimensions = 16;
constexpr std::size_t kMostNrrdSegments = 65535;

struct Fields {
  std::map<std::string, std::string> fields; ///< In lower case: "space directions".
  std::map<std::string, std::string> keys;   ///< "Segment0_Name": as written.
  std::vector<std::string> files;            ///< Behind "data file: LIST".
  std::size_t headerEnd = 0;

  using Map = std::map<std::string, std::string>;
  static std::optional<std::string_view> in(const Map& map, const std::string& name) {
    const auto found = map.find(name);
    return found == map.end() ? std::nullopt : std::optional<std::string_view>(found->second);
  }
  std::optional<std::string_view> field(const std::string& name) const { return in(fields, name); }
  std::optional<std::string_view> key(const std::string& name) const { return in(keys, name); }
};

/// Values of keys have a line end written as \n and a backslash twice.
std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == 'n' || text[i + 1] == '\\'))
      result += text[++i] == 'n' ? ' ' : '\\';
    else
      result += text[i];
  }
  return result;
}

Fields fieldsOf(const FileBytes& file) {
  Fields result;
  TextScanner scanner(file, file.view());
  scanner.line();
  while (scanner.remaining() > 0) {
    const std::string_view line = trimmed(scanner.line());
    if (line.empty())
      break;
    if (line.starts_with('#'))
      continue;
    const std::size_t key = line.find(":=");
    const std::size_t field = line.find(": ");
    if (key != line.npos && key < field)
      result.keys[std::string(trimmed(line.substr(0, key)))] = unescaped(trimmed(line.substr(key + 2)));
    else if (const std::size_t colon = line.find(':'); colon != line.npos) {
      const std::string name = lowered(trimmed(line.substr(0, colon)));
      const std::string_view value = trimmed(line.substr(colon + 1));
      result.fields[name] = value;
      if ((name == "data file" || name == "datafile") && isListOfFiles(value)) {
        result.files = namesOfFiles(scanner); // To the file's end.
        break;
      }
    } else
      scanner.fail(diagnostic("this is not a line of an NRRD header: %1", inQuotes(line)));
  }
  result.headerEnd = scanner.position();
  return result;
}

Scalar scalarOf(const FileBytes& file, std::string_view type) {
  struct TypeNames {
    Scalar scalar;
    std::array<std::string_view, 7> names;
  };
  static constexpr std::array<TypeNames, 10> kTypes = {
      {{Scalar::int8, {"signed char", "int8", "int8_t"}},
       {Scalar::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
       {Scalar::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
       {Scalar::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
       {Scalar::int32, {"int", "signed int", "int32", "int32_t"}},
       {Scalar::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
       {Scalar::int64,
        {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
         "int64_t"}},
       {Scalar::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
       {Scalar::float32, {"float"}},
       {Scalar::float64, {"double"}}}};
  for (const TypeNames& known : kTypes)
    if (!type.empty() && std::find(known.names.begin(), known.names.end(), type) != known.names.end())
      return known.scalar;
  file.fail(phrase("its voxels are no plain numbers (%1)", inQuotes(type)),
            "save it with one value per voxel");
}

/// The vectors "(1,0,0) none (0,1,0)"; nothing for an axis that is not of space. Of a space with time as its
/// fourth axis a vector has four numbers, and that of the axis of time only the fourth.
std::vector<std::optional<Vec3>> vectorsOf(const FileBytes& file, std::string_view text, bool withTime) {
  const int count = withTime ? 4 : 3;
  std::vector<std::optional<Vec3>> list;
  while (!(text = trimmed(text)).empty()) {
    if (text.starts_with("none")) {
      list.emplace_back();
      text.remove_prefix(4);
      continue;
    }
    const std::size_t end = text.find(')');
    if (text.front() != '(' || end == text.npos)
      file.fail(diagnostic("its header is damaged: %1 is not a vector", inQuotes(text)));
    std::string_view numbers = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    Eigen::Vector4d vector = Eigen::Vector4d::Zero();
    for (int i = 0; i < count; ++i) {
      const std::size_t comma = std::min(numbers.find(','), numbers.size());
      const auto number = parseNumber(trimmed(numbers.substr(0, comma)));
      if (!number || (i < count - 1) != (comma < numbers.size()))
        file.fail(diagnostic("its header is damaged: a vector in it has not %1 numbers",
                             withTime ? "four" : "three"));
      vector[i] = *number;
      numbers.remove_prefix(std::min(comma + 1, numbers.size()));
    }
    const bool isTime = vector[3] != 0 && vector.head<3>().isZero(0);
    list.push_back(isTime ? std::nullopt : std::optional<Vec3>(vector.head<3>()));
  }
  return list;
}

constexpr std::string_view kAndTime = "-time";

/// "left-posterior-superior-time" or "lpst".
bool isWithTime(std::string_view lowerSpace) {
  return lowerSpace.ends_with(kAndTime) || (lowerSpace.size() == 4 && lowerSpace.ends_with('t'));
}

/// The factors that convert the file's axes to LPS.
Vec3 turnToLps(std::string_view space, RawImage& raw) {
  std::string name = lowered(space);
  if (isWithTime(name))
    name.resize(name.size() - (name.size() == 4 ? 1 : kAndTime.size()));
  const auto is = [&](std::string_view longName, std::string_view shortName) {
    return name == longName || name == shortName;
  };
  const auto say = [&](std::string_view axes, const Vec3& turn) {
    raw.space = axes;
    return turn;
  };
  if (is("left-posterior-superior", "lps"))
    return say("LPS", {1, 1, 1});
  if (is("right-anterior-superior", "ras"))
    return say("RAS", {-1, -1, 1});
  if (is("left-anterior-superior", "las"))
    return say("LAS", {1, -1, 1});
  raw.warnings.push_back(name.empty() ? "the file does not state its axes: LPS is assumed"
                                      : phrase("its axes %1 are unknown; LPS is assumed", inQuotes(space)));
  return say("LPS", {1, 1, 1});
}

/// The unit of `"mm" "mm" "mm"`; one that is not known is taken as mm.
double unitInMm(std::string_view units) {
  std::string unit = lowered(takeWord(units));
  std::erase(unit, '"');
  if (unit == "m")
    return 1000;
  if (unit == "cm")
    return 10;
  return unit == "um" ? 1e-3 : 1;
}

struct Axes {
  std::array<std::size_t, 3> ofSpace = {}; ///< Which axes of the file are i, j and k.
  std::optional<std::size_t> list;
  std::string listKind; ///< In lower case: "list", "time", "rgb-color".
};

/// Kinds of an axis with values that belong to one voxel.
bool isOfOneVoxel(std::string_view kind) {
  return kind.find("color") != kind.npos || kind.find("vector") != kind.npos ||
         kind.find("matrix") != kind.npos || kind.find("gradient") != kind.npos || kind == "complex" ||
         kind == "point" || kind == "quaternion" || kind == "normal";
}

class NrrdReader {
public:
  explicit NrrdReader(const FileBytes& file) : file_(file), header_(fieldsOf(file)) {}

  ImageHeader run() {
    raw_.scalar = scalarOf(file_, lowered(need("type")));
    sizes_ = sizesOf();
    readGrid();
    readMitkLabels(header_.keys, raw_);
    readSegments();
    // Several volumes without a word about segments are phases, as they are for a scan.
    raw_.overTime = raw_.layers > 1 && (saysTime() || (raw_.stated.empty() && !isOfOneVoxel(raw_.listKind)));
    StoredValues stored = storedValues();
    return {std::move(raw_), std::move(stored)};
  }

private:
  std::string_view need(const std::string& name) const {
    const auto value = header_.field(name);
    if (!value)
      file_.fail(diagnostic("its header is cut off or damaged: it has no %1", inQuotes(name)));
    return *value;
  }

  std::vector<std::int64_t> sizesOf() const {
    const auto dimension = parseInteger(need("dimension"));
    std::vector<std::int64_t> sizes;
    std::string_view text = need("sizes");
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
      const auto size = parseInteger(word);
      if (!size || *size < 1 || sizes.size() == kMostNrrdDimensions)
        file_.fail(diagnostic("its header is damaged: %1 is not a size of an axis", inQuotes(word)));
      sizes.push_back(*size);
    }
    if (!dimension || static_cast<std::size_t>(*dimension) != sizes.size())
      file_.fail(diagnostic("its header is damaged: it has %n {size|sizes} for %2 dimensions", sizes.size(),
                            need("dimension")));
    return sizes;
  }

  /// The axis without a direction is the list of layers; of files without directions the one whose kind says
  /// so.
  Axes axesOf(const std::vector<std::optional<Vec3>>& directions) const {
    std::vector<std::size_t> ofSpace;
    Axes axes;
    std::string_view kinds = header_.field("kinds").value_or("");
    for (std::size_t d = 0; d < sizes_.size(); ++d) {
      const std::string kind = lowered(takeWord(kinds));
      const bool isSpace = directions.empty() ? (kind.empty() && ofSpace.size() < 3) || kind == "domain" ||
                                                    kind == "space" || kind == "???"
                                              : directions[d].has_value();
      if (isSpace)
        ofSpace.push_back(d);
      else if (axes.list && sizes_[d] > 1)
        file_.fail("It has several axes that are not of space", "save it as a 3D image");
      else {
        axes.list = d;
        axes.listKind = kind;
      }
    }
    if (ofSpace.size() != 3)
      file_.fail(
          diagnostic("It has %n {axis|axes} in space; an image of an organ has three", ofSpace.size()));
    std::copy(ofSpace.begin(), ofSpace.end(), axes.ofSpace.begin());
    if (axes.list && *axes.list != 0 && *axes.list != 3)
      file_.fail(diagnostic("its layers lie between the axes of space"), "save it as a segmentation");
    return axes;
  }

  std::vector<double> numbers(const std::string& name) const {
    std::vector<double> list;
    std::string_view text = header_.field(name).value_or("");
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
      list.push_back(parseNumber(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    return list;
  }

  /// Reads the grid of a file without directions: spacings, and where the axes begin.
  void readPlainGrid(const Axes& axes) {
    const std::vector<double> spacings = numbers("spacings"), begins = numbers("axis mins");
    std::string_view centers = header_.field("centers").value_or(header_.field("centerings").value_or(""));
    std::vector<std::string> centering;
    for (std::string_view word = takeWord(centers); !word.empty(); word = takeWord(centers))
      centering.push_back(lowered(word));
    for (int i = 0; i < 3; ++i) {
      const std::size_t d = axes.ofSpace[static_cast<std::size_t>(i)];
      const double spacing = d < spacings.size() ? spacings[d] : 1;
      raw_.indexToLps.linear()(i, i) = spacing;
      if (d < begins.size())
        raw_.indexToLps.translation()[i] =
            begins[d] + (d < centering.size() && centering[d] == "cell" ? spacing / 2 : 0);
    }
    if (spacings.empty())
      raw_.warnings.push_back("it does not say how large its voxels are; 1 mm is assumed");
  }

  void readGrid() {
    std::vector<std::optional<Vec3>> directions;
    if (const auto text = header_.field("space directions"))
      directions = vectorsOf(file_, *text, spaceHasTime());
    if (!directions.empty() && directions.size() != sizes_.size())
      file_.fail(diagnostic("its header is damaged: it has %n {direction|directions} for %2 axes",
                            directions.size(), sizes_.size()));
    const Axes axes = axesOf(directions);
    for (std::size_t i = 0; i < 3; ++i)
      raw_.size[i] = axisSize(file_, sizes_[axes.ofSpace[i]], std::string_view("ijk").substr(i, 1));
    if (axes.list) {
      raw_.layers = axisSize(file_, sizes_[*axes.list], "the layers");
      raw_.layersFirst = *axes.list == 0;
      raw_.listKind = axes.listKind;
      readTimes(*axes.list);
    }
    if (directions.empty())
      readPlainGrid(axes);
    for (int i = 0; i < 3 && !directions.empty(); ++i)
      raw_.indexToLps.linear().col(i) = *directions[axes.ofSpace[static_cast<std::size_t>(i)]];
    if (const auto origin = header_.field("space origin")) {
      const auto vectors = vectorsOf(file_, *origin, spaceHasTime());
      if (vectors.size() != 1 || !vectors[0])
        file_.fail(diagnostic("its header is damaged: %1 is not an origin", inQuotes(*origin)));
      raw_.indexToLps.translation() = *vectors[0];
    }
    const Vec3 turn = turnToLps(header_.field("space").value_or(""), raw_);
    raw_.indexToLps =
        Eigen::Scaling(Vec3(turn * unitInMm(header_.field("space units").value_or("")))) * raw_.indexToLps;
    raw_.indexToLps.makeAffine();
  }

  /// A vector has four numbers, then.
  bool spaceHasTime() const {
    const std::string_view vectors = header_.field("space directions").value_or("");
    const std::size_t open = vectors.find('(');
    const std::string_view first = vectors.substr(std::min(open, vectors.size()));
    return isWithTime(lowered(header_.field("space").value_or(""))) ||
           std::count(first.begin(),
                      first.begin() + static_cast<std::ptrdiff_t>(std::min(first.find(')'), first.size())),
                      ',') == 3;
  }

  /// Reads, of 3D Slicer's sequences and multi-volumes, what the axis without a direction counts.
  void readTimes(std::size_t axis) {
    const std::string prefix = "axis " + std::to_string(axis) + " index ";
    raw_.times = RawTimes{};
    std::string text(
        header_.key(prefix + "values").value_or(header_.key("MultiVolume.FrameLabels").value_or("")));
    std::replace(text.begin(), text.end(), ',', ' ');
    std::string_view words = text;
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words))
      raw_.times->values.push_back(parseNumber(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    const auto unit = header_.key(prefix + "unit");
    raw_.times->unit = lowered(
        trimmed(unit ? *unit : header_.key("MultiVolume.FrameIdentifyingDICOMTagUnits").value_or("")));
    timeAxis_ = axis;
  }

  /// Whether anything in the header calls the axis without a direction time.
  bool saysTime() const {
    const std::string prefix = "axis " + std::to_string(timeAxis_) + " ";
    const auto isOfAxis = [&](const auto& key) {
      return lowered(key.first).starts_with(prefix) || key.first.starts_with("MultiVolume.");
    };
    std::string_view labels = header_.field("labels").value_or("");
    for (std::size_t d = 0; d < timeAxis_; ++d)
      takeWord(labels);
    std::string label = lowered(takeWord(labels));
    std::erase(label, '"');
    const std::string name = lowered(file_.file.filename().string());
    return raw_.listKind == "time" || label == "time" || label == "t" || label == "frame" ||
           label == "phase" || spaceHasTime() || name.find(".seq.n") != name.npos ||
           header_.key("DataNodeClassName") ||
           std::any_of(header_.keys.begin(), header_.keys.end(), isOfAxis);
  }

  void readSegments() {
    for (std::size_t n = 0; n < kMostNrrdSegments; ++n) {
      const std::string prefix = "Segment" + std::to_string(n) + "_";
      const auto id = header_.key(prefix + "ID"), name = header_.key(prefix + "Name");
      if (!id && !name)
        return;
      StatedSegment segment;
      // Segmentations of old versions of Slicer have a layer for each segment and no values.
      segment.label = parseInteger(header_.key(prefix + "LabelValue").value_or("1")).value_or(0);
      const bool layered = raw_.layers > 1 && !saysTime();
      const auto layer =
          parseInteger(header_.key(prefix + "Layer").value_or(layered ? std::to_string(n) : "0"));
      if (segment.label == 0 || !layer || *layer < 0 || *layer >= raw_.layers) {
        raw_.warnings.push_back(phrase("its segment %1 has no valid value or layer", n));
        continue;
      }
      segment.layer = static_cast<int>(*layer);
      segment.name = name.value_or(*id);
      segment.color = colorOf(header_.key(prefix + "Color").value_or(""));
      raw_.stated.push_back(std::move(segment));
    }
  }

  static std::optional<Vec3> colorOf(std::string_view text) {
    Vec3 color;
    for (int i = 0; i < 3; ++i) {
      const auto part = parseNumber(takeWord(text));
      if (!part || !(*part >= 0 && *part <= 1))
        return std::nullopt;
      color[i] = *part;
    }
    return color;
  }

  StoredValues storedValues() {
    StoredValues stored;
    stored.headerEnd = header_.headerEnd;
    const std::string encoding = lowered(need("encoding"));
    stored.packing = encoding == "gzip" || encoding == "gz"     ? Packing::zlib
                     : encoding == "bzip2" || encoding == "bz2" ? Packing::bzip2
                                                                : Packing::none;
    stored.text = encoding == "ascii" || encoding == "text" || encoding == "txt";
    if (stored.packing == Packing::none && !stored.text && encoding != "raw")
      file_.fail(phrase("its encoding %1 is not supported", inQuotes(encoding)),
                 "save it with gzip or raw encoding");
    const std::string endian = lowered(header_.field("endian").value_or(""));
    if (endian.empty() && !stored.text && sizeOf(raw_.scalar) > 1)
      file_.fail(diagnostic("its header is cut off or damaged: it has no %1", inQuotes("endian")));
    raw_.order = endian == "big" ? std::endian::big : std::endian::little;
    const auto beside =
        header_.field("data file").has_value() ? header_.field("data file") : header_.field("datafile");
    if (beside) {
      if (isListOfFiles(*beside))
        stored.parts = header_.files;
      else
        stored.parts = filesOfPattern(file_, *beside);
      if (isListOfFiles(*beside) && stored.parts.empty())
        file_.fail(diagnostic("its header is damaged: its list of files is empty"));
      if (stored.parts.empty())
        stored.beside = std::string(*beside);
    }
    readSkips(stored);
    return stored;
  }

  void readSkips(StoredValues& stored) const {
    const auto skip = [&](const std::string& name, const std::string& other) -> std::int64_t {
      const auto text = header_.field(name).has_value() ? header_.field(name) : header_.field(other);
      const auto number = parseInteger(text.value_or("0"));
      if (!number || *number < -1)
        file_.fail(
            diagnostic("its header is damaged: %1 is not a number for %2", inQuotes(*text), inQuotes(name)));
      return *number;
    };
    const std::int64_t bytes = skip("byte skip", "byteskip"), lines = skip("line skip", "lineskip");
    stored.atEnd = bytes == -1;
    stored.skippedBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(bytes, 0));
    stored.skippedLines = static_cast<std::uint64_t>(std::max<std::int64_t>(lines, 0));
  }

  const FileBytes& file_;
  Fields header_;
  RawImage raw_;
  std::vector<std::int64_t> sizes_;
  std::size_t timeAxis_ = 0; ///< The axis that is not of space, where there is one.
};

} // namespace

ImageHeader nrrdHeader(FileBytes& file) {
  return headerBehindGzip(file, [](const FileBytes& plain) { return NrrdReader(plain).run(); });
}

} // namespace viscera::medical_io
