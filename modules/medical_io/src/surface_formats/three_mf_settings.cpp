#include "surface_formats/three_mf_settings.h"

#include <cstdint>
#include <optional>
#include <string>

#include "text_scanner.h"
#include "viscera/core/text.h"
#include "xml_tree.h"

namespace viscera::medical_io {
namespace {

/// The value of a `<metadata key="..." value="..."/>` of an element.
std::string setting(const XmlElement& element, std::string_view key) {
  for (const XmlElement& child : element.children)
    if (child.name == "metadata" && child.attribute("key") == key)
      return toUtf8(std::string(child.attribute("value")));
  return {};
}

/// Tells of a volume of PrusaSlicer or a part of Bambu Studio.
bool isShape(const XmlElement& volume) {
  const std::string type = setting(volume, "volume_type");
  const std::string_view subtype = volume.attribute("subtype");
  return (type.empty() || type == "ModelPart") && (subtype.empty() || subtype == "normal_part") &&
         setting(volume, "modifier") != "1";
}

/// The triangles of PrusaSlicer's volumes; all of them, one behind the other, or none.
void addPieces(const XmlElement& settings, ThreeMfObject& object) {
  std::vector<ThreeMfPiece> pieces;
  std::size_t next = 0;
  for (const XmlElement& volume : settings.children) {
    if (volume.name != "volume")
      continue;
    const std::optional<std::int64_t> first = parseInteger(volume.attribute("firstid"));
    const std::optional<std::int64_t> last = parseInteger(volume.attribute("lastid"));
    if (!first || !last || *first != static_cast<std::int64_t>(next) || *last < *first ||
        static_cast<std::uint64_t>(*last) >= object.triangles.size())
      return;
    next = static_cast<std::size_t>(*last) + 1;
    pieces.push_back({next, setting(volume, "name"), isShape(volume)});
  }
  if (next == object.triangles.size() && pieces.size() > 1)
    object.pieces = std::move(pieces);
}

void nameComponents(const XmlElement& settings, ThreeMfModel& model, const ThreeMfObject& object) {
  for (const XmlElement& part : settings.children)
    for (const ThreeMfUse& use : object.components)
      if (part.name == "part" && use.object.ends_with('#' + std::string(part.attribute("id"))))
        if (const auto found = model.objects.find(use.object); found != model.objects.end()) {
          if (found->second.name.empty())
            found->second.name = setting(part, "name");
          if (!isShape(part))
            found->second.type = "support";
        }
}

} // namespace

void applySettings(std::string_view settings, std::string_view path, ThreeMfModel& model) {
  const XmlTree tree = parseXml(settings);
  if (!tree.error.empty())
    return;
  for (const XmlElement& element : tree.root.children) {
    const auto found = model.objects.find(threeMfKey(path, element.attribute("id")));
    if (element.name != "object" || found == model.objects.end())
      continue;
    if (found->second.name.empty())
      found->second.name = setting(element, "name");
    addPieces(element, found->second);
    nameComponents(element, model, found->second);
  }
}

} // namespace viscera::medical_io
