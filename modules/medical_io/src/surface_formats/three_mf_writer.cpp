#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "space_tag.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "viscera/core/text.h"
#include "viscera/geometry/volume.h"
#include "zip_archive.h"

namespace viscera::medical_io {
namespace {

constexpr auto kPackageTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" )"
    R"(ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" )"
    R"(ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";
constexpr auto kRelationsToModel =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="model" )"
    R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/3D/3dmodel.model"/>)"
    R"(</Relationships>
)";
constexpr auto kModelBegin =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
    R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
)";
constexpr int kMaterials = 1; ///< The number of the list of materials; objects and palettes come behind it.

std::string inXml(const std::string& text) {
  std::string out;
  for (const char c : toUtf8(text)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += byte < ' ' || byte == 0x7F ? ' ' : c;
  }
  return out;
}

std::string hexColor(const std::uint8_t* channels, int count) {
  std::string text = "#";
  for (int k = 0; k < count; ++k) {
    char two[3];
    std::snprintf(two, sizeof two, "%02X", static_cast<unsigned>(channels[k]));
    text += two;
  }
  return text;
}

std::string hexColor(const Vec3& color, double opacity) {
  std::uint8_t channels[4];
  for (int k = 0; k < 3; ++k)
    channels[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
  channels[3] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
  return hexColor(channels, channels[3] == 255 ? 3 : 4);
}

/// The palette of a mesh that is painted by points, and the place of every point in it.
struct PointColors {
  std::vector<std::string> palette;
  std::vector<std::size_t> places;
};

PointColors pointColorsOf(const geometry::TriangleMesh& mesh) {
  PointColors colors;
  std::map<std::string, std::size_t> known;
  for (Eigen::Index v = 0; v < mesh.colors.rows(); ++v) {
    const std::uint8_t channels[3] = {mesh.colors(v, 0), mesh.colors(v, 1), mesh.colors(v, 2)};
    const auto [entry, isNew] = known.try_emplace(hexColor(channels, 3), colors.palette.size());
    if (isNew)
      colors.palette.push_back(entry->first);
    colors.places.push_back(entry->second);
  }
  return colors;
}

/// The text of the model: one object for each organ, whose cavities are turned inwards in its mesh.
class ThreeMfWriter {
public:
  explicit ThreeMfWriter(const WriteSurface& options) {
    text_ += kModelBegin;
    text_ += "<metadata name=\"Application\">Viscera</metadata>\n<metadata name=\"Description\">" +
             inXml(writtenComment(options)) + "</metadata>\n<resources>\n";
  }

  void addMaterials(const std::vector<NamedSurface>& surfaces) {
    text_ += "<basematerials id=\"1\">\n";
    for (const NamedSurface& surface : surfaces)
      if (surface.cavityOf < 0) {
        materials_.push_back(materialCount_++);
        text_ += R"(<base name=")" + inXml(surface.name) + "\" displaycolor=\"" +
                 hexColor(surface.color, surface.opacity) + "\"/>\n";
      } else {
        materials_.push_back(0);
      }
    text_ += "</basematerials>\n";
  }

  /// An organ with all surfaces within it: its cavities, and what stands in these.
  void addObject(const std::vector<NamedSurface>& surfaces, std::size_t which) {
    const NamedSurface& organ = surfaces[which];
    begin(*organ.mesh, organ.name, materials_.empty() ? std::nullopt : std::optional(materials_[which]));
    std::vector<std::pair<const NamedSurface*, int>> within; // Each with its depth: 1 is a cavity.
    for (const NamedSurface& other : surfaces) {
      int depth = 0;
      const NamedSurface* outer = &other;
      for (; outer->cavityOf >= 0; ++depth)
        outer = &surfaces[static_cast<std::size_t>(outer->cavityOf)];
      if (outer == &organ && depth > 0)
        within.emplace_back(&other, depth);
    }
    text_ += "<mesh><vertices>\n";
    addPoints(*organ.mesh);
    for (const auto& [surface, depth] : within)
      addPoints(*surface->mesh);
    text_ += "</vertices><triangles>\n";
    const bool outward = geometry::volume(organ.mesh->points, organ.mesh->triangles) > 0;
    addTriangles(*organ.mesh, 0, false);
    std::int64_t before = organ.mesh->points.rows();
    for (const auto& [surface, depth] : within) {
      colors_ = {};
      const bool alike = (geometry::volume(surface->mesh->points, surface->mesh->triangles) > 0) == outward;
      addTriangles(*surface->mesh, before, alike == (depth % 2 == 1));
      before += surface->mesh->points.rows();
    }
    text_ += "</triangles></mesh>\n</object>\n";
  }

  std::string run() {
    text_ += "</resources>\n<build>\n";
    for (const int object : objects_)
      text_ += R"(<item objectid=")" + std::to_string(object) + "\"/>\n";
    text_ += "</build>\n</model>\n";
    return zipped({{"[Content_Types].xml", kPackageTypes},
                   {"_rels/.rels", kRelationsToModel},
                   {"3D/3dmodel.model", std::move(text_)}});
  }

private:
  /// Opens an object, behind the palette of a mesh that is painted by points.
  void begin(const geometry::TriangleMesh& mesh, const std::string& name, std::optional<int> material) {
    std::string look;
    colors_ = pointColorsOf(mesh);
    if (!colors_.palette.empty()) {
      look = " pid=\"" + std::to_string(next_) + "\" pindex=\"0\"";
      text_ += R"(<m:colorgroup id=")" + std::to_string(next_++) + "\">\n";
      for (const std::string& color : colors_.palette)
        text_ += R"(<m:color color=")" + color + "\"/>\n";
      text_ += "</m:colorgroup>\n";
    } else if (material) {
      look = " pid=\"" + std::to_string(kMaterials) + "\" pindex=\"" + std::to_string(*material) + "\"";
    }
    text_ += R"(<object id=")" + std::to_string(next_) + "\" type=\"model\" name=\"" + inXml(name) + "\"" +
             look + ">\n";
    objects_.push_back(next_++);
  }

  void addPoints(const geometry::TriangleMesh& mesh) {
    static constexpr const char* kAxes[] = {R"(<vertex x=")", "\" y=\"", "\" z=\""};
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        text_ += kAxes[axis];
        appendNumber(text_, mesh.points(v, axis));
      }
      text_ += "\"/>\n";
    }
  }

  void addTriangles(const geometry::TriangleMesh& mesh, std::int64_t before, bool turned) {
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const int order[3] = {0, turned ? 2 : 1, turned ? 1 : 2};
      text_ += "<triangle";
      for (int k = 0; k < 3; ++k) {
        text_ += " v" + std::to_string(k + 1) + "=\"";
        appendNumber(text_, before + mesh.triangles(t, order[k]));
        text_ += '"';
      }
      for (int k = 0; k < 3 && !colors_.places.empty(); ++k) {
        text_ += " p" + std::to_string(k + 1) + "=\"";
        appendNumber(text_, static_cast<std::int64_t>(
                                colors_.places[static_cast<std::size_t>(mesh.triangles(t, order[k]))]));
        text_ += '"';
      }
      text_ += "/>\n";
    }
  }

  std::string text_;
  std::vector<int> materials_; ///< Of each surface.
  std::vector<int> objects_;
  PointColors colors_; ///< Of the mesh that is being written.
  int materialCount_ = 0;
  int next_ = kMaterials + 1;
};

} // namespace

void writeThreeMf(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  ThreeMfWriter writer(options);
  const std::shared_ptr<const geometry::TriangleMesh> borrowed(std::shared_ptr<void>(), &mesh);
  writer.addObject({{borrowed, options.name}}, 0);
  out << writer.run();
}

void writeThreeMfParts(std::ostream& out, const std::vector<NamedSurface>& surfaces, Space space) {
  ThreeMfWriter writer({space, {}});
  writer.addMaterials(surfaces);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].cavityOf < 0)
      writer.addObject(surfaces, i);
  out << writer.run();
}

} // namespace viscera::medical_io
