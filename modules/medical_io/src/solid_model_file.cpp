#include "viscera/medical_io/solid_model_file.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "space_tag.h"
#include "text_scanner.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/solid_file.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kLongestSetName = 64; ///< Both programs take 80 letters.
constexpr std::size_t kNodesInLine = 12;    ///< And 16 numbers in a line.
constexpr int kNodeDigits = 12;

/// The number of a C3D4 element's face by the corner that is not on it.
constexpr std::array<int, 4> kFaceOpposite = {3, 4, 2, 1};

/// Names of sets: capitals, digits and underscores, the first a letter.
class SetNames {
public:
  std::string add(const std::string& wanted) {
    std::string name;
    for (const char c : wanted.substr(0, kLongestSetName)) {
      const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'), digit = c >= '0' && c <= '9';
      name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : letter || digit ? c : '_';
    }
    if (name.empty() || name[0] < 'A' || name[0] > 'Z')
      name = "SET_" + name;
    const std::string stem = name;
    for (int number = 2; !taken_.insert(name).second; ++number)
      name = stem + "_" + std::to_string(number);
    return name;
  }

private:
  std::set<std::string> taken_ = {"NALL"};
};

void appendNode(std::string& out, Eigen::Index number, const Points& points) {
  appendNumber(out, static_cast<std::int64_t>(number + 1));
  for (int axis = 0; axis < 3; ++axis) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, points(number, axis),
                                   std::chars_format::general, kNodeDigits);
    std::string text(buffer, end.ptr);
    if (text.find_first_of(".e") == text.npos)
      text += '.'; // A number without a point may be taken for an integer.
    out += ", " + text;
  }
  out += '\n';
}

void appendWall(std::string& out, const deformation::OrganSolid::Wall& wall, const std::string& name) {
  out += "*NSET, NSET=" + name + '\n';
  for (std::size_t i = 0; i < wall.nodes.size(); ++i) {
    appendNumber(out, std::int64_t{wall.nodes[i]} + 1);
    out += i + 1 == wall.nodes.size() || (i + 1) % kNodesInLine == 0 ? ",\n" : ", ";
  }
  out += "*SURFACE, NAME=" + name + "_FACES, TYPE=ELEMENT\n";
  for (const auto& [tetrahedron, corner] : wall.faces) {
    appendNumber(out, std::int64_t{tetrahedron} + 1);
    out += ", S" + std::to_string(kFaceOpposite[static_cast<std::size_t>(corner)]) + '\n';
  }
}

std::string inpOf(const deformation::OrganSolid& solid, const std::string& organ) {
  SetNames elementNames, names;
  std::string out = "*HEADING\n" + writtenComment({.name = organ}, 70) + "; mm\n*NODE, NSET=NALL\n";
  for (Eigen::Index i = 0; i < solid.points.rows(); ++i)
    appendNode(out, i, solid.points);
  out += "*ELEMENT, TYPE=C3D4, ELSET=" + elementNames.add(organ) + '\n';
  for (Eigen::Index t = 0; t < solid.tetrahedra.rows(); ++t) {
    appendNumber(out, static_cast<std::int64_t>(t + 1));
    for (int k = 0; k < 4; ++k) {
      out += ", ";
      appendNumber(out, std::int64_t{solid.tetrahedra(t, k)} + 1);
    }
    out += '\n';
  }
  for (const deformation::OrganSolid::Wall& wall : solid.walls)
    appendWall(out, wall, names.add(wall.name));
  return out;
}

std::vector<SolidArray> arraysOf(const deformation::OrganSolid& solid) {
  std::vector<SolidArray> arrays;
  for (const deformation::OrganSolid::Wall& wall : solid.walls) {
    std::vector<std::uint8_t> flags(static_cast<std::size_t>(solid.points.rows()), 0);
    for (const std::int32_t node : wall.nodes)
      flags[static_cast<std::size_t>(node)] = 1;
    arrays.push_back({wall.name, std::move(flags)});
  }
  return arrays;
}

} // namespace

bool isSolidModelFile(const std::filesystem::path& file) {
  return extensionOf(file) == ".inp" || extensionOf(file) == ".vtu";
}

void writeSolidModel(const std::filesystem::path& file, const deformation::OrganSolid& solid,
                     const std::string& organ) {
  if (!isSolidModelFile(file))
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(extensionOf(file))),
                            file.string(), phrase("let its name end in %1", ".inp, .vtu"));
  if (extensionOf(file) == ".inp")
    writeAtomically(file, [&](std::ostream& out) { out << inpOf(solid, organ); });
  else
    writeSolid(file, solid.points, solid.tetrahedra, arraysOf(solid));
}

} // namespace viscera::medical_io
