#include "surface_formats/three_mf_model.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "scalar.h"
#include "surface_formats/three_mf_settings.h"
#include "text_scanner.h"
#include "viscera/core/text.h"
#include "xml_stream.h"
#include "zip_archive.h"

// Own reader: file_formats.md says why not lib3mf.
namespace viscera::medical_io {
namespace {

constexpr auto kRelations = "_rels/.rels";
constexpr auto kUsualModel = "3D/3dmodel.model";
constexpr std::string_view kModelRelation = "3dmodel"; ///< The relation's type ends so.
constexpr std::string_view kModelEnding = ".model";
constexpr std::uint64_t kMostModelBytes = std::uint64_t{8} << 30U;
/// Settings of PrusaSlicer, and of Bambu Studio and OrcaSlicer.
constexpr std::array<const char*, 2> kSettings = {"Metadata/Slic3r_PE_model.config",
                                                  "Metadata/model_settings.config"};
constexpr std::uint64_t kMostSettingBytes = std::uint64_t{1} << 24U;
constexpr std::uint64_t kMostRelationBytes = std::uint64_t{1} << 20U;
constexpr std::size_t kLongestComment = 4096;
constexpr PackedColor kOpaque = 0xFF;

constexpr std::array<std::pair<std::string_view, double>, 6> kThreeMfUnits = {{{"micron", 1e-3},
                                                                               {"millimeter", 1},
                                                                               {"centimeter", 10},
                                                                               {"inch", 25.4},
                                                                               {"foot", 304.8},
                                                                               {"meter", 1000}}};

/// "#RRGGBB" or "#RRGGBBAA".
PackedColor packedColor(std::string_view text) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
    return kNoColor;
  PackedColor color = 0;
  for (const char c : text.substr(1)) {
    const bool digit = c >= '0' && c <= '9', small = c >= 'a' && c <= 'f', large = c >= 'A' && c <= 'F';
    if (!digit && !small && !large)
      return kNoColor;
    color = color * 16 + static_cast<PackedColor>(digit ? c - '0' : small ? c - 'a' + 10 : c - 'A' + 10);
  }
  return text.size() == 7 ? color << 8U | kOpaque : color;
}

/// The target of the model's relation.
class RelationListener final : public XmlListener {
public:
  std::string target;

  void startElement(std::string_view name, const XmlAttributes& attributes) override {
    if (name == "Relationship" && lowered(attributes.value("Type")).ends_with(kModelRelation) &&
        target.empty())
      target = std::string(attributes.value("Target"));
  }
  void endElement(std::string_view) override {}
  void characters(std::string_view) override {}
  bool hasEnough() const override { return !target.empty(); }
};

/// Fills the model from one model part. A mistake ends the reading and is kept, since nothing may be thrown
/// through the parser.
class ModelListener final : public XmlListener {
public:
  ModelListener(ThreeMfModel& model, std::string path, bool isRoot)
      : model_(model), path_(std::move(path)), isRoot_(isRoot) {}

  Text mistake;
  std::set<std::string> otherPaths; ///< To which components and items refer.

  bool hasEnough() const override { return !mistake.empty(); }

  void startElement(std::string_view name, const XmlAttributes& attributes) override {
    if (!mistake.empty())
      return;
    if (name == "vertex")
      startVertex(attributes);
    else if (name == "triangle")
      startTriangle(attributes);
    else if (name == "object")
      startObject(attributes);
    else if (name == "component" && object_ != nullptr)
      addUse(object_->components, attributes);
    else if (name == "item" && isRoot_)
      addUse(model_.printed, attributes);
    else
      startOther(name, attributes);
  }

  void endElement(std::string_view name) override {
    if (name == "object")
      object_ = nullptr;
    else if (name == "metadata" && takesComment_) {
      takesComment_ = false;
      model_.comment += '\n';
    }
  }

  void characters(std::string_view text) override {
    if (takesComment_ && model_.comment.size() < kLongestComment)
      model_.comment += text;
  }

private:
  void startOther(std::string_view name, const XmlAttributes& attributes) {
    if (name == "model" && isRoot_) {
      model_.unit = std::string(attributes.value("unit"));
      model_.mm = model_.unit.empty() ? 1 : lookUp(kThreeMfUnits, model_.unit).value_or(0);
    } else if (name == "metadata" && isRoot_ && object_ == nullptr) {
      takesComment_ = attributes.value("name") == "Description" || attributes.value("name") == "Title";
    } else if (name == "basematerials" || name == "colorgroup") {
      palette_ = &palettes_[std::string(attributes.value("id"))];
    } else if (name == "base" && palette_ != nullptr) {
      palette_->push_back(packedColor(attributes.value("displaycolor")));
    } else if (name == "color" && palette_ != nullptr) {
      palette_->push_back(packedColor(attributes.value("color")));
    } else if (name == "texture2dgroup" || name == "compositematerials" || name == "multiproperties") {
      model_.unreadColors = true;
    } else if (name == "beamlattice" || name == "slicestack" || name == "levelset" ||
               name == "volumetricstack") {
      model_.unreadShapes = true;
    }
  }

  void startObject(const XmlAttributes& attributes) {
    const std::string key = threeMfKey(path_, attributes.value("id"));
    const auto [place, isNew] = model_.objects.try_emplace(key);
    if (!isNew) {
      mistake = diagnostic("two objects have the number %1", inQuotes(attributes.value("id")));
      return;
    }
    model_.order.push_back(key);
    object_ = &place->second;
    object_->name = toUtf8(std::string(attributes.value("name")));
    if (object_->name.empty())
      object_->name = toUtf8(std::string(attributes.value("partnumber")));
    object_->type = std::string(attributes.value("type"));
    id_ = std::string(attributes.value("id"));
    propertyOfObject_ = std::string(attributes.value("pid"));
    colorOfObject_ = colorIn(propertyOfObject_, attributes.value("pindex"), kNoColor);
  }

  void startVertex(const XmlAttributes& attributes) {
    if (object_ == nullptr)
      return;
    for (const char* axis : {"x", "y", "z"}) {
      const std::optional<double> value = parseNumber(trimmed(attributes.value(axis)));
      if (!value) {
        mistake = diagnostic("object %1, point %2: expected a number, found %3", inQuotes(id_),
                             object_->coordinates.size() / 3, inQuotes(attributes.value(axis)));
        return;
      }
      object_->coordinates.push_back(*value);
    }
  }

  void startTriangle(const XmlAttributes& attributes) {
    if (object_ == nullptr)
      return;
    std::array<std::int64_t, 3> corners{};
    std::size_t at = 0;
    for (const char* corner : {"v1", "v2", "v3"}) {
      const std::optional<std::int64_t> value = parseInteger(trimmed(attributes.value(corner)));
      if (!value) {
        mistake = diagnostic("object %1, triangle %2: expected the number of a point, found %3",
                             inQuotes(id_), object_->triangles.size(), inQuotes(attributes.value(corner)));
        return;
      }
      corners[at++] = *value;
    }
    object_->triangles.push_back(corners);
    addColors(attributes);
  }

  void addColors(const XmlAttributes& attributes) {
    const std::string_view first = attributes.value("p1");
    std::array<PackedColor, 3> colors = {colorOfObject_, colorOfObject_, colorOfObject_};
    if (!first.empty()) {
      const std::string_view stated = attributes.value("pid");
      const std::string property = stated.empty() ? propertyOfObject_ : std::string(stated);
      colors[0] = colorIn(property, first, colorOfObject_);
      colors[1] = colorIn(property, attributes.value("p2"), colors[0]);
      colors[2] = colorIn(property, attributes.value("p3"), colors[0]);
    }
    std::vector<std::array<PackedColor, 3>>& all = object_->colors;
    const bool painted = colors != std::array<PackedColor, 3>{};
    if (!painted && all.empty())
      return;
    all.resize(object_->triangles.size() - 1);
    all.push_back(colors);
  }

  PackedColor colorIn(const std::string& property, std::string_view number, PackedColor otherwise) const {
    const auto palette = palettes_.find(property);
    const std::optional<std::int64_t> place = parseInteger(number);
    if (palette == palettes_.end() || !place || *place < 0 ||
        static_cast<std::uint64_t>(*place) >= palette->second.size())
      return otherwise;
    return palette->second[static_cast<std::size_t>(*place)];
  }

  void addUse(std::vector<ThreeMfUse>& uses, const XmlAttributes& attributes) {
    const std::string path(attributes.value("path"));
    if (!path.empty())
      otherPaths.insert(path);
    ThreeMfUse use;
    use.object = threeMfKey(path.empty() ? path_ : path, attributes.value("objectid"));
    std::string_view rest = trimmed(attributes.value("transform"));
    // Column after column: points are rows, which are multiplied from the left.
    for (Eigen::Index k = 0; k < 12 && !attributes.value("transform").empty(); ++k) {
      const std::optional<double> value = parseNumber(takeWord(rest));
      if (!value) {
        mistake = diagnostic("the transform of object %1 has not twelve numbers",
                             inQuotes(attributes.value("objectid")));
        return;
      }
      use.transform(k % 3, k / 3) = *value;
    }
    uses.push_back(std::move(use));
  }

  ThreeMfModel& model_;
  std::string path_;
  bool isRoot_;
  ThreeMfObject* object_ = nullptr;
  std::string id_;
  std::string propertyOfObject_;
  PackedColor colorOfObject_ = kNoColor;
  std::map<std::string, std::vector<PackedColor>> palettes_;
  std::vector<PackedColor>* palette_ = nullptr;
  bool takesComment_ = false;
};

/// The model part that the package names, or the usual one, or the first that ends in .model.
const ZipArchive::Part& rootPart(const ZipArchive& archive) {
  if (const ZipArchive::Part* relations = archive.find(kRelations)) {
    ZipPartReader reader(archive, *relations, kMostRelationBytes);
    RelationListener listener;
    streamXml([&](char* out, std::size_t count) { return reader.read(out, count); }, listener);
    if (const ZipArchive::Part* named = archive.find(listener.target); named && !listener.target.empty())
      return *named;
  }
  if (const ZipArchive::Part* usual = archive.find(kUsualModel))
    return *usual;
  for (const ZipArchive::Part& part : archive.parts())
    if (lowered(part.name).ends_with(kModelEnding))
      return part;
  archive.file().fail("It is a ZIP archive without a 3D model", "unpack it and open the files in it");
}

} // namespace

std::string threeMfKey(std::string_view path, std::string_view id) {
  return plainPartName(path) + '#' + std::string(id);
}

ThreeMfModel readThreeMfModel(const FileBytes& file) {
  const ZipArchive archive(file);
  const ZipArchive::Part& root = rootPart(archive);
  ThreeMfModel model;
  std::set<std::string> known = {threeMfKey(root.name, {})};
  std::vector<const ZipArchive::Part*> waiting = {&root};
  std::uint64_t left = kMostModelBytes;
  while (!waiting.empty()) {
    const ZipArchive::Part& part = *waiting.back();
    waiting.pop_back();
    ZipPartReader reader(archive, part, left);
    left -= part.bytes;
    ModelListener listener(model, part.name, &part == &root);
    const Text broken =
        streamXml([&](char* out, std::size_t count) { return reader.read(out, count); }, listener);
    if (!listener.mistake.empty() || !broken.empty())
      file.fail(diagnostic("its part \"%1\" is damaged: %2", part.name,
                           listener.mistake.empty() ? broken : listener.mistake));
    for (const std::string& path : listener.otherPaths) {
      const ZipArchive::Part* other = archive.find(path);
      if (other == nullptr)
        file.fail(diagnostic("its part \"%1\" is missing", path));
      if (known.insert(threeMfKey(path, {})).second)
        waiting.push_back(other);
    }
  }
  for (const char* name : kSettings)
    if (const ZipArchive::Part* part = archive.find(name)) {
      std::string settings(static_cast<std::size_t>(std::min(part->bytes, kMostSettingBytes)), '\0');
      ZipPartReader reader(archive, *part, kMostSettingBytes);
      settings.resize(reader.read(settings.data(), settings.size()));
      applySettings(settings, root.name, model);
    }
  return model;
}

} // namespace viscera::medical_io
