#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "byte_cursor.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// FreeSurfer's surfaces, which are called lh.white or rh.pial: triangles (FF FF FE), the older quadrilaterals
// (FF FF FF and FF FF FD), and text (.asc). All numbers are big-endian. Points are RAS millimetres from the
// middle of the scan; where that is in the scanner stands at the end of the file.
namespace viscera::medical_io {
namespace {

constexpr std::string_view kTriangleMark = "\xff\xff\xfe", kQuadMark = "\xff\xff\xff",
                           kNewQuadMark = "\xff\xff\xfd";

/// lh.white: the ending is a part of the name.
std::string nameOfFile(const FileBytes& file) {
  std::string name = file.file.filename().string();
  for (const std::string_view ending : {".gz", ".asc"})
    if (lowered(name).ends_with(ending))
      name.resize(name.size() - ending.size());
  return name;
}

/// The place of the scan, in RAS mm.
struct ScanPlace {
  std::array<Vec3, 3> axes = {Vec3(-1, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0)};
  Vec3 middle = Vec3::Zero();
};

std::optional<Vec3> vectorAfter(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == text.npos)
    return std::nullopt;
  std::string_view rest = text.substr(at + key.size());
  if (takeWord(rest) != "=")
    return std::nullopt;
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> value = parseNumber(takeWord(rest));
    if (!value)
      return std::nullopt;
    vector[axis] = *value;
  }
  return vector;
}

/// Read from the lines at the end ("valid = 1", "xras = ...", "cras = ..."); none when there are none, or
/// when they say that they are not valid.
std::optional<ScanPlace> placeIn(std::string_view footer) {
  const std::size_t valid = footer.find("valid = ");
  if (valid == footer.npos || !footer.substr(valid + 8).starts_with('1'))
    return std::nullopt;
  ScanPlace place;
  const auto middle = vectorAfter(footer, "cras");
  if (!middle || !middle->allFinite())
    return std::nullopt;
  place.middle = *middle;
  constexpr std::array<std::string_view, 3> kAxes = {"xras", "yras", "zras"};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    if (const auto direction = vectorAfter(footer, kAxes[axis]); direction && direction->allFinite())
      place.axes[axis] = *direction;
  return place;
}

/// FreeSurfer's own coordinates run along the axes of a scan in its usual order (left, foot, front).
void moveToScan(RawSurface& raw, const ScanPlace& place) {
  for (std::size_t i = 0; i < raw.coordinates.size(); i += 3) {
    double* p = raw.coordinates.data() + i;
    const Vec3 moved = place.middle - p[0] * place.axes[0] + p[1] * place.axes[2] - p[2] * place.axes[1];
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = moved[static_cast<Eigen::Index>(axis)];
  }
}

constexpr auto kWithoutScan = "it does not say where its scan is: its points stay in FreeSurfer's own "
                              "coordinates, which may be some millimetres beside the scan";

class FreeSurferReader {
public:
  explicit FreeSurferReader(const FileBytes& file)
      : file_(file), cursor_(file, file.view(), std::endian::big) {}

  RawSurface run() {
    const std::string_view mark = cursor_.takeBytes(3, "the mark of the format");
    raw_.space = Space::ras;
    raw_.name = nameOfFile(file_);
    if (mark == kTriangleMark)
      readTriangles();
    else if (mark == kQuadMark || mark == kNewQuadMark)
      readQuads(mark == kQuadMark);
    else
      file_.fail(diagnostic("It does not begin with FreeSurfer's mark of a surface"), "check its ending");
    placeInScan();
    return std::move(raw_);
  }

private:
  std::uint64_t checked(std::int64_t count, std::uint64_t bytesEach, std::string_view part) const {
    if (count < 0 || saturatedProduct(static_cast<std::uint64_t>(count), bytesEach) > cursor_.remaining())
      file_.fail(diagnostic("%1 is %2, more than the %3 bytes that are left can hold", part, count,
                            cursor_.remaining()));
    return static_cast<std::uint64_t>(count);
  }

  std::int64_t threeBytes(std::string_view part) {
    const std::string_view bytes = cursor_.takeBytes(3, part);
    std::int64_t value = 0;
    for (const char byte : bytes)
      value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }

  /// Two lines of text, of which the second is usually empty, stand before the numbers.
  void readTriangles() {
    for (int line = 0; line < 2; ++line) {
      const std::string_view rest = file_.view().substr(file_.bytes.size() - cursor_.remaining());
      cursor_.takeBytes(std::min(rest.find('\n'), rest.size()) + 1, "the title");
    }
    const std::int64_t statedPoints = cursor_.take<std::int32_t>("the number of points");
    const std::int64_t statedTriangles = cursor_.take<std::int32_t>("the number of triangles");
    const std::uint64_t points = checked(statedPoints, 12, "the number of points");
    for (std::uint64_t i = 0; i < 3 * points; ++i)
      raw_.coordinates.push_back(static_cast<double>(cursor_.take<float>("a coordinate")));
    const std::uint64_t triangles = checked(statedTriangles, 12, "the number of triangles");
    for (std::uint64_t i = 0; i < triangles; ++i) {
      std::array<std::int64_t, 3> corners{};
      for (std::int64_t& corner : corners)
        corner = cursor_.take<std::int32_t>("a point's number");
      raw_.addPolygon(corners);
    }
  }

  void readQuads(bool inHundredths) {
    if (inHundredths)
      refuseValues();
    const std::int64_t statedPoints = threeBytes("the number of points");
    const std::int64_t statedQuads = threeBytes("the number of quadrilaterals");
    const std::uint64_t points = checked(statedPoints, inHundredths ? 6 : 12, "the number of points");
    for (std::uint64_t i = 0; i < 3 * points; ++i)
      raw_.coordinates.push_back(inHundredths ? cursor_.take<std::int16_t>("a coordinate") / 100.0
                                              : static_cast<double>(cursor_.take<float>("a coordinate")));
    const std::uint64_t quads = checked(statedQuads, 12, "the number of quadrilaterals");
    for (std::uint64_t i = 0; i < quads; ++i) {
      std::array<std::int64_t, 4> q{};
      for (std::int64_t& corner : q)
        corner = threeBytes("a point's number");
      addQuad(q);
    }
  }

  /// FreeSurfer divides them by the first corner's number.
  void addQuad(const std::array<std::int64_t, 4>& q) {
    if (q[0] % 2 == 0) {
      raw_.addTriangle(q[0], q[1], q[3]);
      raw_.addTriangle(q[2], q[3], q[1]);
    } else {
      raw_.addTriangle(q[0], q[1], q[2]);
      raw_.addTriangle(q[0], q[2], q[3]);
    }
  }

  /// Files of curvature and thickness (lh.curv) begin with the same mark, then three numbers of four bytes.
  void refuseValues() const {
    constexpr std::size_t kHead = 15;
    if (file_.bytes.size() < kHead)
      return;
    const auto word = [&](std::size_t at) {
      return loadValue<std::int32_t>(file_.bytes.data() + at, std::endian::big);
    };
    const std::int64_t points = word(3), each = word(11);
    if (points > 0 && each > 0 && each < 100 &&
        kHead + 4 * static_cast<std::uint64_t>(points * each) == file_.bytes.size())
      file_.fail("It holds values at the points of a surface, such as curvature or thickness, not a surface",
                 "open the surface to which they belong, such as lh.white or lh.pial");
  }

  void placeInScan() {
    const std::string_view footer = file_.view().substr(file_.bytes.size() - cursor_.remaining());
    // The second number behind the mark 2 says that points are the scanner's already.
    const bool inScanner = footer.size() >= 8 &&
                           loadValue<std::int32_t>(footer.data(), std::endian::big) == 2 &&
                           loadValue<std::int32_t>(footer.data() + 4, std::endian::big) == 1;
    if (inScanner)
      return;
    const std::optional<ScanPlace> place = placeIn(footer);
    if (place) {
      moveToScan(raw_, *place);
      raw_.warnings.push_back("its points were moved from FreeSurfer's own coordinates to those of its scan");
    } else {
      raw_.warnings.push_back(kWithoutScan);
    }
  }

  const FileBytes& file_;
  ByteCursor cursor_;
  RawSurface raw_;
};

/// "#!ascii version of lh.white", the numbers of points and triangles, then a line for each with a mark
/// behind.
RawSurface readFreeSurferText(const FileBytes& file) {
  RawSurface raw;
  raw.space = Space::ras;
  raw.name = nameOfFile(file);
  TextScanner scanner(file, file.view());
  scanner.line();
  const std::uint64_t points = scanner.count("the number of points", 8);
  const std::uint64_t triangles = scanner.count("the number of triangles", 8);
  for (std::uint64_t i = 0; i < points; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      raw.coordinates.push_back(scanner.number("a coordinate"));
    scanner.number("a mark");
  }
  for (std::uint64_t i = 0; i < triangles; ++i) {
    std::array<std::int64_t, 3> corners{};
    for (std::int64_t& corner : corners)
      corner = scanner.integer("a point's number");
    scanner.number("a mark");
    raw.addPolygon(corners);
  }
  raw.warnings.push_back(kWithoutScan);
  return raw;
}

} // namespace

RawSurface readFreeSurfer(const FileBytes& file) {
  return file.view().starts_with("#!ascii") ? readFreeSurferText(file) : FreeSurferReader(file).run();
}

} // namespace viscera::medical_io
