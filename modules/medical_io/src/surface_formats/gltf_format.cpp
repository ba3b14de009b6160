#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "space_tag.h"
#include "surface_formats.h"
#include "surface_formats/gltf_document.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/normals.h"
#include "viscera/medical_io/organ_names.h"

// Own reader: VTK's looks at neither the sizes of a damaged file nor `extras`, and its writer knows no vertex
// colours.
//
// glTF is in metres with y up. A file that Viscera writes holds LPS (or RAS) millimetres in its vertices, a
// node whose matrix turns them upright in metres for other programs, and `"extras": {"SPACE": "LPS", "unit":
// "mm"}` in its asset; with that mark, vertices are taken as they are and nodes are ignored. Without it
// the meaning of a scene's axes is unknown: nodes are applied, numbers are taken as LPS mm, and a warning is
// added.
namespace viscera::medical_io {
namespace {

using Json = nlohmann::json;
using Matrix = Eigen::Matrix4d;

constexpr int kTriangles = 4;
constexpr int kStrip = 5;
constexpr int kFan = 6;

/// A node may be below another one only once, so that as many steps as there are nodes are enough; the number
/// of triangles that a scene of instances may unfold to is limited.
constexpr std::size_t kMostGltfCorners = 300'000'000;

double encodedFromLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linearFromEncoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

class GltfReader {
public:
  explicit GltfReader(const FileBytes& file) : document_(file) {}

  RawSurface run() {
    raw_.warnings = document_.warnings();
    readMark();
    if (marked_)
      readAllMeshes();
    else
      readScene();
    if (parts_.size() == 1)
      raw_.name = parts_.at(0).name;
    if (parts_.allPlain())
      raw_.colors.clear();
    parts_.moveTo(raw_);
    warnOfSkipped();
    if (!marked_)
      raw_.warnings.push_back("glTF does not say which axes a patient's are: its numbers are taken as LPS "
                              "millimetres, though the "
                              "format's convention is metres with y up");
    return std::move(raw_);
  }

private:
  void warnOfSkipped() {
    if (skipped_ > 0)
      raw_.warnings.push_back(phrase("%n {set|sets} of points or lines ignored", skipped_));
  }

  /// Reads the attributes that `writeSurfaces` stores for an organ beside its mesh. Invalid ones are ignored.
  void readOwnLook(std::size_t part, RawPart& read) const {
    if (sizeOf("nodes") != sizeOf("meshes"))
      return;
    const Json& node = document_.entry("nodes", part);
    const auto extras = node.find("extras");
    if (extras == node.end() || !extras->is_object())
      return;
    const auto number = [](const Json& value, double low, double high) {
      return value.is_number() && value.get<double>() >= low && value.get<double>() <= high;
    };
    if (const auto color = extras->find("color"); color != extras->end() && color->is_array() &&
                                                  color->size() == 3 && number((*color)[0], 0, 1) &&
                                                  number((*color)[1], 0, 1) && number((*color)[2], 0, 1))
      read.color = Vec3((*color)[0].get<double>(), (*color)[1].get<double>(), (*color)[2].get<double>());
    if (const auto opacity = extras->find("opacity"); opacity != extras->end() && number(*opacity, 0, 1))
      read.opacity = opacity->get<double>();
    // Outer surfaces go first.
    if (const auto outer = extras->find("cavityOf");
        outer != extras->end() && outer->is_number_unsigned() && outer->get<std::uint64_t>() < part)
      read.cavityOf = outer->get<int>();
  }

  void readMark() {
    const Json& asset = document_.json().at("asset");
    const auto extras = asset.find("extras");
    if (extras == asset.end() || !extras->is_object())
      return;
    const std::string space = textIn(*extras, "SPACE");
    if (!space.empty())
      raw_.space = findSpace("SPACE=" + space, raw_.warnings);
    marked_ = raw_.space.has_value() && textIn(*extras, "unit") == "mm";
    if (!marked_)
      raw_.space.reset();
  }

  std::size_t sizeOf(const char* list) const {
    const auto found = document_.json().find(list);
    return found != document_.json().end() && found->is_array() ? found->size() : 0;
  }

  /// Reads, of a file without nodes, or with the mark, a mesh, a node and a material for each organ.
  void readAllMeshes() {
    raw_.partsAreOrgans = marked_;
    for (std::size_t mesh = 0; mesh < sizeOf("meshes"); ++mesh)
      readMesh(mesh, {}, Matrix::Identity());
  }

  /// The roots of the scene to show; of a file without scenes, all nodes that are below no other one.
  std::vector<std::uint64_t> roots() const {
    if (sizeOf("scenes") > 0)
      return children(document_.entry("scenes", document_.whole(document_.json(), "scene", 0)), "nodes");
    std::vector<bool> isChild(sizeOf("nodes"));
    for (std::size_t node = 0; node < isChild.size(); ++node)
      for (const std::uint64_t child : children(document_.entry("nodes", node), "children"))
        if (child < isChild.size())
          isChild[static_cast<std::size_t>(child)] = true;
    std::vector<std::uint64_t> list;
    for (std::size_t node = 0; node < isChild.size(); ++node)
      if (!isChild[node])
        list.push_back(node);
    return list;
  }

  std::vector<std::uint64_t> children(const Json& object, const char* key) const {
    std::vector<std::uint64_t> list;
    const auto found = object.find(key);
    for (std::size_t i = 0; found != object.end() && i < found->size(); ++i) {
      const Json& child = found->is_array() ? (*found)[i] : *found;
      if (!child.is_number_unsigned())
        document_.fail(diagnostic("a node's children are not numbers"));
      list.push_back(child.get<std::uint64_t>());
    }
    return list;
  }

  void readScene() {
    if (sizeOf("nodes") == 0) {
      readAllMeshes();
      return;
    }
    std::vector<bool> seen(sizeOf("nodes"));
    std::vector<std::pair<std::uint64_t, Matrix>> open;
    for (const std::uint64_t root : roots())
      open.emplace_back(root, Matrix::Identity());
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
      const auto [number, above] = open.back();
      open.pop_back();
      const Json& node = document_.entry("nodes", number);
      if (seen[static_cast<std::size_t>(number)])
        document_.fail(diagnostic("node %1 is in the scene twice", number));
      seen[static_cast<std::size_t>(number)] = true;
      const Matrix here = above * transformOf(node);
      if (node.contains("mesh"))
        readMesh(document_.whole(node, "mesh"), textIn(node, "name"), here);
      if (node.contains("skin"))
        raw_.warnings.push_back(phrase("node %1 is moved by bones, which are ignored", number));
      for (const std::uint64_t child : children(node, "children"))
        open.emplace_back(child, here);
    }
  }

  template <std::size_t count>
  bool readArray(const Json& node, const char* key, std::array<double, count>& values) const {
    const auto found = node.find(key);
    if (found == node.end())
      return false;
    if (!found->is_array() || found->size() != count)
      document_.fail(diagnostic("a node's \"%1\" does not have %2 numbers", key, count));
    for (std::size_t i = 0; i < count; ++i) {
      if (!(*found)[i].is_number())
        document_.fail(diagnostic("a node's \"%1\" holds something that is not a number", key));
      values[i] = (*found)[i].get<double>();
    }
    return true;
  }

  Matrix transformOf(const Json& node) const {
    std::array<double, 16> matrix{};
    if (readArray(node, "matrix", matrix))
      return Eigen::Map<const Matrix>(matrix.data());
    std::array<double, 3> translation = {0, 0, 0};
    std::array<double, 4> rotation = {0, 0, 0, 1};
    std::array<double, 3> scale = {1, 1, 1};
    readArray(node, "translation", translation);
    readArray(node, "rotation", rotation);
    readArray(node, "scale", scale);
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(Vec3(translation[0], translation[1], translation[2]));
    transform.rotate(Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]).normalized());
    transform.scale(Vec3(scale[0], scale[1], scale[2]));
    return transform.matrix();
  }

  /// A scene of one mesh has its primitives as parts, which differ in their material; else a part is a node.
  bool primitivesAreParts() const {
    std::size_t uses = 0;
    for (std::size_t node = 0; node < sizeOf("nodes"); ++node)
      uses += document_.entry("nodes", node).contains("mesh") ? 1 : 0;
    return !marked_ && sizeOf("meshes") == 1 && uses < 2;
  }

  void readMesh(std::uint64_t number, const std::string& node, const Matrix& transform) {
    const Json& mesh = document_.entry("meshes", number);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      document_.fail(diagnostic("mesh %1 has no primitives", number));
    RawPart part;
    part.name = textIn(mesh, "name");
    if (!saysNothing(node) && !marked_)
      part.name = node;
    if (marked_)
      readOwnLook(static_cast<std::size_t>(number), part);
    else
      readMaterial(*primitives, part);
    const bool apart = primitives->size() > 1 && primitivesAreParts();
    std::uint32_t place = apart ? 0 : beginPart(part);
    for (const Json& primitive : *primitives) {
      if (apart)
        place = beginPart(partOf(primitive, part));
      readPrimitive(primitive, number, transform, parts_.at(place));
    }
  }

  std::uint32_t beginPart(RawPart part) {
    const std::uint32_t place = parts_.add(std::move(part));
    parts_.begin(place, raw_.polygonCount());
    return place;
  }

  /// One of the primitives of a mesh, as a part.
  RawPart partOf(const Json& primitive, RawPart mesh) const {
    readMaterial(Json::array({primitive}), mesh);
    if (!saysNothing(mesh.material))
      mesh.name = mesh.material;
    return mesh;
  }

  /// The material that all primitives of a mesh have. One that is not as it should be is ignored: the shape
  /// does not need it.
  void readMaterial(const Json& primitives, RawPart& part) const {
    const auto numberOf = [](const Json& primitive) -> std::optional<std::uint64_t> {
      const auto found = primitive.is_object() ? primitive.find("material") : primitive.end();
      if (!primitive.is_object() || found == primitive.end() || !found->is_number_unsigned())
        return std::nullopt;
      return found->get<std::uint64_t>();
    };
    const auto list = document_.json().find("materials");
    const std::optional<std::uint64_t> number = primitives.empty() ? std::nullopt : numberOf(primitives[0]);
    if (!number || list == document_.json().end() || !list->is_array() || *number >= list->size() ||
        !(*list)[static_cast<std::size_t>(*number)].is_object() ||
        !std::all_of(primitives.begin(), primitives.end(),
                     [&](const Json& primitive) { return numberOf(primitive) == number; }))
      return;
    const Json& material = (*list)[static_cast<std::size_t>(*number)];
    part.material = textIn(material, "name");
    const auto look = material.find("pbrMetallicRoughness");
    if (look == material.end() || !look->is_object())
      return;
    const auto factor = look->find("baseColorFactor");
    if (factor == look->end() || !factor->is_array() || factor->size() != 4 ||
        !std::all_of(factor->begin(), factor->end(), [](const Json& value) { return value.is_number(); }))
      return;
    const auto channel = [&](std::size_t k) { return std::clamp((*factor)[k].get<double>(), 0.0, 1.0); };
    if (!look->contains("baseColorTexture")) // Which it would be multiplied by.
      part.color =
          Vec3(encodedFromLinear(channel(0)), encodedFromLinear(channel(1)), encodedFromLinear(channel(2)));
    if (textIn(material, "alphaMode") == "BLEND" && channel(3) > 0)
      part.opacity = channel(3);
  }

  void readPrimitive(const Json& primitive, std::uint64_t mesh, const Matrix& transform, RawPart& part) {
    const auto attributes = primitive.is_object() ? primitive.find("attributes") : primitive.end();
    if (!primitive.is_object() || attributes == primitive.end() || !attributes->is_object())
      document_.fail(diagnostic("mesh %1 has a primitive without attributes", mesh));
    const std::uint64_t mode = document_.whole(primitive, "mode", kTriangles);
    if (mode < kTriangles || mode > kFan) {
      ++skipped_;
      return;
    }
    document_.requireUncompressed(primitive);
    const std::size_t before = raw_.pointCount();
    readPositions(*attributes, transform);
    if (attributes->contains("COLOR_0")) {
      readColors(*attributes, raw_.pointCount() - before);
    } else {
      raw_.colors.resize(raw_.coordinates.size(), 0);
      part.plain = true;
    }
    std::vector<std::int64_t> list = cornersOf(primitive, raw_.pointCount() - before, mesh);
    for (std::int64_t& corner : list)
      corner += static_cast<std::int64_t>(before);
    if (raw_.corners.size() + 3 * list.size() > kMostGltfCorners)
      document_.fail(diagnostic("With its instances expanded, it has too many triangles"));
    addTriangles(list, mode, transform.topLeftCorner<3, 3>().determinant() < 0);
  }

  void readPositions(const Json& attributes, const Matrix& transform) {
    std::size_t components = 0;
    const std::vector<double> values = document_.numbers(document_.whole(attributes, "POSITION"), components);
    if (components != 3)
      document_.fail(diagnostic("its points have %1 coordinates, not 3", components));
    if (raw_.coordinates.size() + values.size() > kMostGltfCorners)
      document_.fail(diagnostic("With its instances expanded, it has too many points"));
    const bool moved = !transform.isIdentity(0);
    for (std::size_t i = 0; i < values.size(); i += 3) {
      Vec3 point(values[i], values[i + 1], values[i + 2]);
      if (moved)
        point = (transform * point.homogeneous()).head<3>();
      raw_.addPoint(point.x(), point.y(), point.z());
    }
  }

  /// Colours are linear in glTF.
  void readColors(const Json& attributes, std::size_t points) {
    std::size_t components = 0;
    const std::vector<double> values = document_.numbers(document_.whole(attributes, "COLOR_0"), components);
    if ((components != 3 && components != 4) || values.size() != components * points)
      document_.fail(diagnostic("its colours do not fit its points"));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i % components < 3)
        raw_.addChannel(values[i] > 0 ? 255 * encodedFromLinear(std::min(values[i], 1.0)) : 0.0);
  }

  std::vector<std::int64_t> cornersOf(const Json& primitive, std::size_t points, std::uint64_t mesh) const {
    std::vector<std::int64_t> list;
    if (primitive.contains("indices")) {
      list = document_.indices(document_.whole(primitive, "indices"));
    } else {
      for (std::size_t i = 0; i < points; ++i)
        list.push_back(static_cast<std::int64_t>(i));
    }
    for (const std::int64_t corner : list)
      if (static_cast<std::uint64_t>(corner) >= points)
        document_.fail(diagnostic("mesh %1 refers to point %2, but there are %3 (counted from 0)", mesh,
                                  corner, points));
    return list;
  }

  void addTriangles(std::span<const std::int64_t> list, std::uint64_t mode, bool mirrored) {
    const std::size_t first = raw_.corners.size();
    if (mode == kTriangles && list.size() % 3 != 0)
      document_.fail(diagnostic("a list of triangles ends within one"));
    if (mode == kTriangles)
      for (std::size_t i = 0; i + 2 < list.size(); i += 3)
        raw_.addTriangle(list[i], list[i + 1], list[i + 2]);
    else if (mode == kStrip)
      raw_.addStrip(list);
    else
      for (std::size_t i = 1; i + 1 < list.size(); ++i)
        raw_.addTriangle(list[0], list[i], list[i + 1]);
    // A mirroring node turns triangles inside out.
    for (std::size_t i = first; mirrored && i + 2 < raw_.corners.size(); i += 3)
      std::swap(raw_.corners[i + 1], raw_.corners[i + 2]);
  }

  GltfDocument document_;
  RawSurface raw_;
  PartList parts_;
  bool marked_ = false;
  std::uint64_t skipped_ = 0;
};

/// Maps patient millimetres to metres with y to the head and z to the front, column by column.
Json uprightMatrix(Space space) {
  const double side = space == Space::lps ? 0.001 : -0.001;
  return {side, 0, 0, 0, 0, 0, -side, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};
}

/// The binary chunk and the JSON that describes it, written side by side.
class GlbBuilder {
public:
  explicit GlbBuilder(Space space) : space_(space) {}

  /// Adds a surface, whose coordinates are in the builder's space already, as a node of its own.
  void add(const geometry::TriangleMesh& mesh, const std::string& name, const Json& material,
           const Json& extras = {}) {
    Json attributes = {{"POSITION", addPositions(mesh)}, {"NORMAL", addNormals(mesh)}};
    if (mesh.colors.rows() > 0)
      attributes["COLOR_0"] = addColors(mesh);
    const Json primitive = {
        {"attributes", attributes}, {"indices", addIndices(mesh)}, {"material", materials_.size()}};
    nodes_.push_back({{"name", name}, {"mesh", meshes_.size()}, {"matrix", uprightMatrix(space_)}});
    if (!extras.is_null())
      nodes_.back()["extras"] = extras;
    meshes_.push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    materials_.push_back(material);
  }

  std::string run() const {
    const std::string json = padded(document().dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
    const std::uint64_t size = 12 + 8 + json.size() + 8 + binary_.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw CannotCreateError("the surface is too large for GLB, which ends at 4 GB", {},
                              phrase("let its name end in %1", ".ply, .vtp"));
    std::string glb = "glTF";
    appendValue(glb, std::uint32_t{2});
    appendValue(glb, static_cast<std::uint32_t>(size));
    appendChunk(glb, "JSON", json);
    appendChunk(glb, std::string("BIN\0", 4), binary_);
    return glb;
  }

private:
  static std::string padded(std::string text, char with) {
    text.resize((text.size() + 3) / 4 * 4, with);
    return text;
  }

  static void appendChunk(std::string& glb, const std::string& type, const std::string& data) {
    appendValue(glb, static_cast<std::uint32_t>(data.size()));
    glb += type;
    glb += data;
  }

  /// Describes what was appended to the binary chunk since `begin` and gives the accessor's number.
  std::size_t describe(std::size_t begin, Json accessor, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary_.size() - begin}, {"target", target}});
    accessor["bufferView"] = views_.size() - 1;
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }

  static constexpr int kVertexData = 34962;
  static constexpr int kIndexData = 34963;
  static constexpr int kFloat = 5126;
  static constexpr int kUnsignedShort = 5123;
  static constexpr int kUnsignedInt = 5125;

  std::size_t addPositions(const geometry::TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::max());
    Eigen::Array3f high = -low;
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
      const Eigen::Array3f point = mesh.points.row(v).transpose().cast<float>().array();
      low = low.min(point);
      high = high.max(point);
      for (int axis = 0; axis < 3; ++axis)
        appendValue(binary_, point[axis]);
    }
    return describe(begin,
                    {{"componentType", kFloat},
                     {"count", mesh.points.rows()},
                     {"type", "VEC3"},
                     {"min", {low[0], low[1], low[2]}},
                     {"max", {high[0], high[1], high[2]}}},
                    kVertexData);
  }

  std::size_t addNormals(const geometry::TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    const geometry::Normals normals = geometry::vertexNormals(mesh);
    for (Eigen::Index v = 0; v < normals.rows(); ++v) {
      // The format wants unit vectors, even where there is no normal.
      const bool none = normals.row(v).isZero(0);
      for (int axis = 0; axis < 3; ++axis)
        appendValue(binary_, none ? (axis == 2 ? 1.0F : 0.0F) : normals(v, axis));
    }
    return describe(begin, {{"componentType", kFloat}, {"count", normals.rows()}, {"type", "VEC3"}},
                    kVertexData);
  }

  /// 16 bits, so that linear values bring every byte back.
  std::size_t addColors(const geometry::TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    for (Eigen::Index v = 0; v < mesh.colors.rows(); ++v) {
      for (int k = 0; k < 3; ++k)
        appendValue(binary_, static_cast<std::uint16_t>(
                                 std::lround(65535 * linearFromEncoded(mesh.colors(v, k) / 255.0))));
      appendValue(binary_, std::uint16_t{65535});
    }
    return describe(begin,
                    {{"componentType", kUnsignedShort},
                     {"normalized", true},
                     {"count", mesh.colors.rows()},
                     {"type", "VEC4"}},
                    kVertexData);
  }

  std::size_t addIndices(const geometry::TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        appendValue(binary_, static_cast<std::uint32_t>(mesh.triangles(t, k)));
    return describe(begin,
                    {{"componentType", kUnsignedInt}, {"count", mesh.triangles.size()}, {"type", "SCALAR"}},
                    kIndexData);
  }

  Json document() const {
    Json roots = Json::array();
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      roots.push_back(node);
    return {{"asset",
             {{"version", "2.0"},
              {"generator", "Viscera"},
              {"extras", {{"SPACE", spaceName(space_)}, {"unit", "mm"}}}}},
            {"scene", 0},
            {"scenes", Json::array({{{"nodes", roots}}})},
            {"nodes", nodes_},
            {"meshes", meshes_},
            {"materials", materials_},
            {"accessors", accessors_},
            {"bufferViews", views_},
            {"buffers", Json::array({{{"byteLength", binary_.size()}}})}};
  }

  Space space_;
  std::string binary_;
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json materials_ = Json::array();
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

Json plainMaterial() {
  return {{"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.6}}},
          {"doubleSided", true}};
}

/// The material has a colour of its own, which vertex colours would be multiplied by.
Json materialOf(const NamedSurface& surface) {
  Json material = plainMaterial();
  const bool painted = surface.mesh->colors.rows() > 0;
  if (!painted || surface.opacity < 1) {
    Json factor = Json::array();
    for (const double part : surface.color)
      factor.push_back(painted ? 1.0 : linearFromEncoded(part));
    factor.push_back(surface.opacity);
    material["pbrMetallicRoughness"]["baseColorFactor"] = factor;
    if (surface.opacity < 1)
      material["alphaMode"] = "BLEND";
  }
  return material;
}

/// The data that only Viscera reads: colours without conversion to linear values, and the parents of
/// cavities.
Json extrasOf(const NamedSurface& surface) {
  Json extras = {{"color", {surface.color.x(), surface.color.y(), surface.color.z()}},
                 {"opacity", surface.opacity}};
  if (surface.cavityOf >= 0)
    extras["cavityOf"] = surface.cavityOf;
  return extras;
}

} // namespace

RawSurface readGltf(const FileBytes& file) {
  return GltfReader(file).run();
}

void writeGlb(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  GlbBuilder builder(options.space);
  builder.add(mesh, options.name, plainMaterial());
  out << builder.run();
}

void writeGlbParts(std::ostream& out, const std::vector<NamedSurface>& surfaces, Space space) {
  GlbBuilder builder(space);
  for (const NamedSurface& surface : surfaces)
    builder.add(*surface.mesh, surface.name, materialOf(surface), extrasOf(surface));
  out << builder.run();
}

} // namespace viscera::medical_io
