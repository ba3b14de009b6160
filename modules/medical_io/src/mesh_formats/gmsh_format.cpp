#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh_formats/cell_mesh.h"
#include "mesh_formats/gmsh_values.h"
#include "scalar.h"
#include "viscera/core/phrase.h"

// Own reader: gmsh's library is a whole mesher, of which the reader of its files is a small part.
namespace viscera::medical_io {
namespace {

constexpr CellKind gmshSolid(SolidShape shape, std::size_t points) {
  return {CellKind::Use::solid, shape, points, 0};
}
constexpr CellKind gmshFlat(std::size_t corners, std::size_t points) {
  return {CellKind::Use::flat, SolidShape::tetrahedron, points, corners};
}
constexpr CellKind gmshThin(std::size_t points) {
  return {CellKind::Use::ignore, SolidShape::tetrahedron, points, 0};
}

/// Kinds by gmsh's numbers of its types. The corners come first.
constexpr std::array<std::pair<std::int64_t, CellKind>, 43> kGmshKinds = {{
    {1, gmshThin(2)},
    {2, gmshFlat(3, 3)},
    {3, gmshFlat(4, 4)},
    {4, gmshSolid(SolidShape::tetrahedron, 4)},
    {5, gmshSolid(SolidShape::hexahedron, 8)},
    {6, gmshSolid(SolidShape::wedge, 6)},
    {7, gmshSolid(SolidShape::pyramid, 5)},
    {8, gmshThin(3)},
    {9, gmshFlat(3, 6)},
    {10, gmshFlat(4, 9)},
    {11, gmshSolid(SolidShape::tetrahedron, 10)},
    {12, gmshSolid(SolidShape::hexahedron, 27)},
    {13, gmshSolid(SolidShape::wedge, 18)},
    {14, gmshSolid(SolidShape::pyramid, 14)},
    {15, gmshThin(1)},
    {16, gmshFlat(4, 8)},
    {17, gmshSolid(SolidShape::hexahedron, 20)},
    {18, gmshSolid(SolidShape::wedge, 15)},
    {19, gmshSolid(SolidShape::pyramid, 13)},
    {20, gmshFlat(3, 9)},
    {21, gmshFlat(3, 10)},
    {22, gmshFlat(3, 12)},
    {23, gmshFlat(3, 15)},
    {24, gmshFlat(3, 15)},
    {25, gmshFlat(3, 21)},
    {26, gmshThin(4)},
    {27, gmshThin(5)},
    {28, gmshThin(6)},
    {29, gmshSolid(SolidShape::tetrahedron, 20)},
    {30, gmshSolid(SolidShape::tetrahedron, 35)},
    {31, gmshSolid(SolidShape::tetrahedron, 56)},
    {36, gmshFlat(4, 16)},
    {37, gmshFlat(4, 25)},
    {38, gmshFlat(4, 36)},
    {39, gmshFlat(4, 12)},
    {40, gmshFlat(4, 16)},
    {41, gmshFlat(4, 20)},
    {90, gmshSolid(SolidShape::wedge, 40)},
    {91, gmshSolid(SolidShape::wedge, 75)},
    {92, gmshSolid(SolidShape::hexahedron, 64)},
    {93, gmshSolid(SolidShape::hexahedron, 125)},
    {118, gmshSolid(SolidShape::pyramid, 30)},
    {119, gmshSolid(SolidShape::pyramid, 55)},
}};

class GmshReader {
public:
  explicit GmshReader(const FileBytes& file) : file_(file), values_(file) {}

  CellMesh run() {
    readFormat();
    while (!values_.text().atEnd())
      readSection();
    if (!hasElements_)
      file_.fail(diagnostic("the file is cut off: %1 is missing", "$Elements"));
    resolvePoints();
    for (const auto& [key, name] : names_)
      if (key.first == (mesh_.shapes.empty() ? 2 : 3))
        mesh_.regionNames[key.second] = name;
    return std::move(mesh_);
  }

private:
  void readFormat() {
    const std::string_view word = values_.text().word();
    if (word == "$NOD")
      file_.fail(phrase("It is of gmsh's format %1, which Viscera does not read", 1),
                 "open it with gmsh and save it as version 2 or 4");
    if (word != "$MeshFormat")
      file_.fail(diagnostic("It does not begin with \"$MeshFormat\": it is not a gmsh file"),
                 "check its ending");
    version_ = values_.text().number("the version of the format");
    const std::int64_t type = values_.text().integer("the type of the file");
    const std::int64_t size = values_.text().integer("the size of a number");
    if (!(version_ >= 2 && version_ < 3) && !(version_ >= 4 && version_ < 5))
      file_.fail(phrase("It is of gmsh's format %1, which Viscera does not read", inDigits(version_)),
                 "open it with gmsh and save it as version 2 or 4");
    if (type != 0 && size != 8)
      file_.fail(diagnostic("its numbers have %1 bytes, not 8", size));
    if (type != 0) {
      values_.text().line();
      values_.makeBinary(std::endian::little);
      if (values_.take<std::int32_t>("the order of bytes") != 1)
        values_.makeBinary(std::endian::big);
    }
    values_.skipToEnd("MeshFormat");
  }

  void readSection() {
    const std::string_view word = values_.text().word();
    if (!word.starts_with('$') || word.starts_with("$End"))
      values_.text().fail(diagnostic("expected %2, found %1", inQuotes(word), "a section of a gmsh file"));
    const std::string name(word.substr(1));
    const bool isBinary = values_.isBinary();
    if (name == "PhysicalNames") {
      readNames();
    } else if (name == "Entities" && version_ >= 4) {
      startBinary();
      readEntities();
    } else if (name == "Nodes") {
      readNodes();
    } else if (name == "Elements") {
      hasElements_ = true;
      if (version_ < 4)
        readElements2(isBinary);
      else
        readElements4();
    }
    values_.skipToEnd(name);
  }

  void readNodes() {
    if (version_ < 4)
      readNodes2();
    else if (version_ < 4.1)
      readNodes40();
    else
      readNodes41();
  }

  /// Binary values begin in the line behind the words that announce them.
  void startBinary() {
    if (values_.isBinary())
      values_.text().line();
  }

  void readNames() {
    const std::uint64_t count = values_.text().count("the number of names", 6);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t dimension = values_.text().integer("a dimension");
      const std::int64_t number = values_.text().integer("a group's number");
      std::string_view name = trimmed(values_.text().line());
      if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
      names_[{dimension, number}] = std::string(name);
    }
  }

  // ---- version 4 -----------------------------------------------------------------------------------------

  void readEntities() {
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t& count : counts)
      count = values_.checkedCount(values_.whole("a number of entities"), 1, "a number of entities");
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
      for (std::uint64_t i = 0; i < counts[dimension]; ++i)
        readEntity(static_cast<std::int64_t>(dimension));
  }

  void readEntity(std::int64_t dimension) {
    const std::int64_t tag = values_.integer("an entity's number");
    const int coordinates = dimension == 0 && version_ >= 4.1 ? 3 : 6;
    for (int k = 0; k < coordinates; ++k)
      values_.number("a coordinate");
    const std::uint64_t groups = values_.checkedCount(values_.whole("a number of groups"), 1, "its groups");
    for (std::uint64_t k = 0; k < groups; ++k) {
      const std::int64_t group = values_.integer("a group's number");
      if (k == 0)
        groupOfEntity_[{dimension, tag}] = group;
    }
    if (dimension == 0)
      return;
    const std::uint64_t bounds = values_.checkedCount(values_.whole("a number of bounds"), 1, "its bounds");
    for (std::uint64_t k = 0; k < bounds; ++k)
      values_.integer("a bounding entity");
  }

  void addNode(std::int64_t tag) {
    const double x = values_.number("a coordinate"), y = values_.number("a coordinate");
    pointOfTag_.try_emplace(tag, static_cast<std::int64_t>(mesh_.surface.pointCount()));
    mesh_.surface.addPoint(x, y, values_.number("a coordinate"));
  }

  void skipParameters(std::int64_t parametric, std::int64_t dimension) {
    for (std::int64_t k = 0; parametric != 0 && k < dimension; ++k)
      values_.number("a parameter");
  }

  void readNodes41() {
    startBinary();
    const std::uint64_t blocks = values_.checkedCount(values_.whole("the number of blocks"), 4, "its blocks");
    for (int k = 0; k < 3; ++k)
      values_.whole("the number of nodes");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = values_.integer("a dimension");
      values_.integer("an entity's number");
      const std::int64_t parametric = values_.integer("a mark of parameters");
      const std::uint64_t count =
          values_.checkedCount(values_.whole("the number of nodes"), 2, "the number of nodes");
      std::vector<std::int64_t> tags(static_cast<std::size_t>(count));
      for (std::int64_t& tag : tags)
        tag = values_.whole("a node's number");
      for (const std::int64_t tag : tags) {
        addNode(tag);
        skipParameters(parametric, dimension);
      }
    }
  }

  void readNodes40() {
    startBinary();
    const std::uint64_t blocks = values_.checkedCount(values_.whole("the number of blocks"), 4, "its blocks");
    values_.whole("the number of nodes");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      values_.integer("an entity's number");
      const std::int64_t dimension = values_.integer("a dimension");
      const std::int64_t parametric = values_.integer("a mark of parameters");
      const std::uint64_t count =
          values_.checkedCount(values_.whole("the number of nodes"), 8, "the number of nodes");
      for (std::uint64_t k = 0; k < count; ++k) {
        addNode(values_.integer("a node's number"));
        skipParameters(parametric, dimension);
      }
    }
  }

  void readElements4() {
    startBinary();
    const bool whole = version_ >= 4.1; // The size of tags; in 4.0 they have 4 bytes.
    const std::uint64_t blocks = values_.checkedCount(values_.whole("the number of blocks"), 4, "its blocks");
    for (int k = 0; k < (whole ? 3 : 1); ++k)
      values_.whole("the number of elements");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      std::int64_t dimension = values_.integer("a dimension");
      std::int64_t entity = values_.integer("an entity's number");
      if (!whole)
        std::swap(dimension, entity);
      const CellKind kind = kindOf(values_.integer("a type of elements"));
      const std::uint64_t count =
          values_.checkedCount(values_.whole("the number of elements"), 2 + 2 * kind.points, "its elements");
      const auto group = groupOfEntity_.find({dimension, entity});
      const std::int64_t region = group == groupOfEntity_.end() ? entity : group->second;
      for (std::uint64_t k = 0; k < count; ++k)
        readElement(kind, region, whole);
    }
  }

  void readElement(const CellKind& kind, std::int64_t region, bool whole) {
    const auto next = [&] {
      return whole ? values_.whole("a node's number") : values_.integer("a node's number");
    };
    next(); // The element's own number.
    nodes_.clear();
    for (std::size_t k = 0; k < kind.points; ++k)
      nodes_.push_back(next());
    addCell(mesh_, kind, nodes_, region);
  }

  // ---- version 2 -----------------------------------------------------------------------------------------

  void readNodes2() {
    const std::uint64_t count = values_.text().count("the number of nodes", 7);
    startBinary();
    for (std::uint64_t k = 0; k < count; ++k)
      addNode(values_.integer("a node's number"));
  }

  void readElements2(bool isBinary) {
    const std::uint64_t count = values_.text().count("the number of elements", 6);
    startBinary();
    for (std::uint64_t done = 0; done < count;)
      done += isBinary ? readBlock2(count - done) : readLine2();
  }

  std::uint64_t readLine2() {
    values_.integer("an element's number");
    const CellKind kind = kindOf(values_.integer("a type of elements"));
    readTagsAndNodes(kind, values_.integer("a number of tags"));
    return 1;
  }

  /// Elements of one type.
  std::uint64_t readBlock2(std::uint64_t most) {
    const CellKind kind = kindOf(values_.integer("a type of elements"));
    const std::int64_t count = values_.integer("the number of elements");
    const std::int64_t tags = values_.integer("a number of tags");
    if (count < 1 || static_cast<std::uint64_t>(count) > most)
      file_.fail(diagnostic("a block of %1 elements, where %2 should follow", count, most));
    for (std::int64_t k = 0; k < count; ++k) {
      values_.integer("an element's number");
      readTagsAndNodes(kind, tags);
    }
    return static_cast<std::uint64_t>(count);
  }

  /// The tags are the physical group (0: none), the entity, and parts of a divided mesh.
  void readTagsAndNodes(const CellKind& kind, std::int64_t tags) {
    std::int64_t region = 0;
    for (std::uint64_t k = 0, count = values_.checkedCount(tags, 1, "a number of tags"); k < count; ++k) {
      const std::int64_t tag = values_.integer("a tag");
      if (k == 0 || (k == 1 && region == 0))
        region = tag;
    }
    nodes_.clear();
    for (std::size_t k = 0; k < kind.points; ++k)
      nodes_.push_back(values_.integer("a node's number"));
    addCell(mesh_, kind, nodes_, region);
  }

  // --------------------------------------------------------------------------------------------------------

  CellKind kindOf(std::int64_t type) const {
    const auto kind = lookUp(kGmshKinds, type);
    if (!kind)
      file_.fail(phrase("It has elements of the type %1, which Viscera does not read", type),
                 "save the mesh as tetrahedra");
    return *kind;
  }

  /// Nodes have numbers with gaps.
  void resolvePoints() {
    for (auto* list : {&mesh_.corners, &mesh_.surface.corners})
      for (std::int64_t& corner : *list) {
        const auto point = pointOfTag_.find(corner);
        if (point == pointOfTag_.end())
          file_.fail(diagnostic("an element refers to node %1, which is not there", corner));
        corner = point->second;
      }
  }

  struct KeyHash {
    std::size_t operator()(const std::pair<std::int64_t, std::int64_t>& key) const {
      return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(key.second) * 4 +
                                        static_cast<std::uint64_t>(key.first));
    }
  };
  using Numbered = std::pair<std::int64_t, std::int64_t>; ///< Dimension and number.

  const FileBytes& file_;
  GmshValues values_;
  CellMesh mesh_;
  double version_ = 0;
  bool hasElements_ = false;
  std::vector<std::int64_t> nodes_;
  std::unordered_map<std::int64_t, std::int64_t> pointOfTag_;
  std::unordered_map<Numbered, std::string, KeyHash> names_;
  std::unordered_map<Numbered, std::int64_t, KeyHash> groupOfEntity_;
};

} // namespace

CellMesh readGmshCells(const FileBytes& file) {
  return GmshReader(file).run();
}

} // namespace viscera::medical_io
