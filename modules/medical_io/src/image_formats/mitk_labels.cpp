#include "image_formats/mitk_labels.h"

#include <cstdio>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"
#include "xml_tree.h"

namespace viscera::medical_io {
namespace {

using LabelJson = nlohmann::json;

constexpr int kMostMitkLabels = 65535; ///< In a layer.

/// A property, which is {"type": ..., "value": V} or V itself.
const LabelJson& valueOf(const LabelJson& property) {
  return property.is_object() && property.contains("value") ? property["value"] : property;
}

std::optional<Vec3> colorOf(const LabelJson& value) {
  if (!value.is_array() || value.size() < 3)
    return std::nullopt;
  Vec3 color;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!value[i].is_number())
      return std::nullopt;
    color[static_cast<int>(i)] = value[i].get<double>();
    if (!(color[static_cast<int>(i)] >= 0 && color[static_cast<int>(i)] <= 1))
      return std::nullopt;
  }
  return color;
}

/// Nothing for a label without a number. The label 0 is what no label covers.
std::optional<StatedSegment> segmentOf(const LabelJson& label, int layer) {
  if (!label.is_object() || !label.contains("value") || !valueOf(label["value"]).is_number_integer())
    return std::nullopt;
  StatedSegment segment;
  segment.label = valueOf(label["value"]).get<std::int64_t>();
  segment.layer = layer;
  if (label.contains("name") && valueOf(label["name"]).is_string())
    segment.name = valueOf(label["name"]).get<std::string>();
  if (label.contains("color"))
    segment.color = colorOf(valueOf(label["color"]));
  return segment;
}

void add(RawImage& raw, std::optional<StatedSegment> segment, int layer) {
  if (!segment || layer >= raw.layers)
    raw.warnings.push_back(phrase("one of its labels in group %1 has no valid number or image", layer + 1));
  else if (segment->label != 0)
    raw.stated.push_back(std::move(*segment));
}

void readGroups(const std::string& text, RawImage& raw) {
  try {
    const LabelJson parsed = parseJson<LabelJson>(text, "labelgroups", kUsualAdvice);
    const LabelJson& groups = parsed.is_object() && parsed.contains("groups") ? parsed["groups"] : parsed;
    if (!groups.is_array())
      return raw.warnings.push_back("the table of names in it cannot be read");
    int layer = 0;
    for (const LabelJson& group : groups) {
      const LabelJson& labels = group.is_object() && group.contains("labels") ? group["labels"] : group;
      if (labels.is_array())
        for (const LabelJson& label : labels)
          add(raw, segmentOf(label, layer), layer);
      ++layer;
    }
  } catch (const Error&) {
    raw.warnings.push_back("the table of names in it cannot be read");
  }
}

/// The element that holds the value of a property: <property key="name"><string value="Liver"/></property>.
const XmlElement* propertyOf(const XmlElement& label, std::string_view key) {
  for (const XmlElement& property : label.children)
    if (property.name == "property" && property.attribute("key") == key && !property.children.empty())
      return &property.children.front();
  return nullptr;
}

std::optional<StatedSegment> segmentOfXml(const std::string& text, int layer) {
  const XmlTree tree = parseXml(trimmed(text));
  if (!tree.error.empty())
    return std::nullopt;
  const XmlElement* nested = tree.root.child("Label");
  const XmlElement& label = nested != nullptr ? *nested : tree.root;
  const XmlElement *name = propertyOf(label, "name"), *value = propertyOf(label, "value"),
                   *color = propertyOf(label, "color");
  const auto number = value != nullptr ? parseInteger(value->attribute("value")) : std::nullopt;
  if (!number)
    return std::nullopt;
  StatedSegment segment{*number, layer, name != nullptr ? std::string(name->attribute("value")) : "", {}};
  if (color != nullptr) {
    const auto red = parseNumber(color->attribute("r")), green = parseNumber(color->attribute("g")),
               blue = parseNumber(color->attribute("b"));
    const auto isChannel = [](const auto& c) { return c && *c >= 0 && *c <= 1; };
    if (isChannel(red) && isChannel(green) && isChannel(blue))
      segment.color = Vec3(*red, *green, *blue);
  }
  return segment;
}

/// The key of a label, or of a layer's number of labels for a label below zero.
std::string keyOf(int layer, int label) {
  char text[64];
  if (label < 0)
    std::snprintf(text, sizeof text, "layer_%03d", layer);
  else
    std::snprintf(text, sizeof text, "org.mitk.label_%03d_%05d", layer, label);
  return text;
}

void readXmlLabels(const std::map<std::string, std::string>& keys, RawImage& raw) {
  for (int layer = 0; keys.contains(keyOf(layer, -1)) || keys.contains(keyOf(layer, 0)); ++layer)
    for (int label = 0; label < kMostMitkLabels; ++label) {
      const auto found = keys.find(keyOf(layer, label));
      if (found == keys.end())
        break;
      add(raw, segmentOfXml(found->second, layer), layer);
    }
}

} // namespace

void readMitkLabels(const std::map<std::string, std::string>& keys, RawImage& raw) {
  if (const auto groups = keys.find("org.mitk.multilabel.segmentation.labelgroups"); groups != keys.end())
    readGroups(groups->second, raw);
  else
    readXmlLabels(keys, raw);
}

} // namespace viscera::medical_io
