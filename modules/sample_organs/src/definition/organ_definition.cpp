#include "definition/organ_definition.h"

#include <set>
#include <system_error>

#include "definition/fields.h"
#include "definition/node_fields.h"
#include "definition/vessel_builder.h"
#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::sample_organs {
namespace {

using nlohmann::json;

constexpr int kFewestTriangles = 100;
constexpr int kMostTriangles = 5'000'000;

/// Reads one file after the other into one definition.
class Reader {
public:
  OrganDefinition read(const std::filesystem::path& path) {
    readFile(path, true);
    return std::move(definition_);
  }

private:
  void readFile(const std::filesystem::path& path, bool main) {
    const std::string where = path.filename().string();
    std::error_code unreachable;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, unreachable);
    if (!files_.insert(unreachable ? path.lexically_normal() : real).second) // Reading says why.
      throw DataError("the file is included twice, or includes itself", where, "remove one of the includes");
    const std::string text = readText(path);
    definition_.contentHash = contentHash(text, definition_.contentHash);
    const auto content = parseJson<json>(text, where, "mend the place that is named", JsonComments::skipped);
    Fields fields(content, where);
    const std::string name = fields.text("name");
    checkFrame(fields);
    if (fields.optional("include"))
      for (const json& other : fields.list("include", 0)) {
        if (!other.is_string())
          fields.fail("include", "is not a list of file names");
        readFile(path.parent_path() / other.get<std::string>(), false);
      }
    if (fields.optional("nodes"))
      for (const json& node : fields.list("nodes", 0))
        addNode(node, where);
    if (main) {
      definition_.name = name;
      definition_.file = where;
      for (const json& surface : fields.list("surfaces"))
        addSurface(surface, where);
    }
    fields.ignore("surfaces");
    fields.requireNothingElse();
  }

  static void checkFrame(Fields& fields) {
    if (fields.text("units") != "mm")
      fields.fail("units", "is not \"mm\"", "convert the numbers to mm");
    if (fields.text("frame") != "LPS")
      fields.fail("frame", "is not \"LPS\"", "turn the signs of x and y of numbers in RAS");
  }

  void addNode(const json& node, const std::string& file) {
    Fields fields(node, file + ", \"nodes\"");
    const std::string name = fields.text("name");
    const std::string where = file + ", node \"" + name + "\"";
    if (!definition_.nodes.emplace(name, NodeDefinition{node, where}).second)
      throw DataError("there is another node of this name", where, "rename one of them");
  }

  void addSurface(const json& content, const std::string& file) {
    Fields named(content, file + ", \"surfaces\"");
    SurfaceDefinition surface;
    surface.name = named.text("name");
    surface.where = file + ", surface \"" + surface.name + "\"";
    Fields fields(content, surface.where);
    fields.ignore("name");
    surface.checkOnly = readSwitch(fields, "check_only");
    surface.hidden = readSwitch(fields, "hidden");
    if (fields.optional("organ"))
      surface.organ = fields.text("organ");
    surface.color = fields.vector("color", surface.color);
    surface.largestSpacing = fields.positive("spacing", surface.largestSpacing);
    if (const json* triangles = fields.optional("triangles"))
      readLevels(*triangles, surface);
    if (fields.optional("places"))
      readPlaces(fields, surface);
    if (fields.optional("ways"))
      readWays(fields, surface);
    if (fields.optional("vessels"))
      readVessels(fields, surface);
    if (fields.optional("less"))
      readParts(fields, surface);
    else
      surface.root = fields.get("root");
    fields.requireNothingElse();
    for (const SurfaceDefinition& other : definition_.surfaces)
      if (other.name == surface.name)
        throw DataError("there is another surface of this name", surface.where, "rename one of them");
    definition_.surfaces.push_back(std::move(surface));
  }

  static bool readSwitch(Fields& fields, const std::string& key) {
    const json* on = fields.optional(key);
    if (on && !on->is_boolean())
      fields.fail(key, "is neither true nor false", "write true or false, without quotation marks");
    return on && on->get<bool>();
  }

  static void readLevels(const json& content, SurfaceDefinition& surface) {
    Fields levels(content, surface.where + ", \"triangles\"");
    for (const Resolution resolution : {Resolution::low, Resolution::medium, Resolution::high}) {
      int& count = surface.triangles[static_cast<std::size_t>(resolution)];
      levels.get(nameOf(resolution));
      count = levels.integer(nameOf(resolution), count, kFewestTriangles, kMostTriangles);
    }
    levels.requireNothingElse();
  }

  /// Only surfaces before this one can be parts of it, so that none is made of itself.
  void readParts(Fields& fields, SurfaceDefinition& surface) const {
    const auto known = [&](const std::string& key, const std::string& name) {
      for (const SurfaceDefinition& other : definition_.surfaces)
        if (other.name == name && !other.joined())
          return name;
      fields.fail(key, "names \"" + name + "\", which is no surface with a root before this one",
                  "put its parts first, or look for a misspelling");
    };
    if (const json* paint = fields.optional("paint"))
      surface.paint = *paint;
    const json& from = fields.get("from");
    for (std::size_t level = 0; level < surface.from.size(); ++level) {
      const json& name = from.is_array() && from.size() == surface.from.size() ? from[level] : from;
      surface.from[level] = known("from", name.is_string() ? name.get<std::string>() : name.dump());
    }
    for (const json& part : fields.list("less"))
      surface.less.push_back(known("less", part.is_string() ? part.get<std::string>() : part.dump()));
  }

  static void readPlaces(Fields& fields, SurfaceDefinition& surface) {
    for (const json& content : fields.list("places", 0)) {
      Fields place(content, surface.where + ", \"places\"");
      surface.places.push_back({place.text("name"), place.vector("at"), place.number("ring", 0)});
      place.requireNothingElse();
    }
  }

  /// Each point is [x, y, z, radius].
  static void readVessels(Fields& fields, SurfaceDefinition& surface) {
    for (const json& content : fields.list("vessels", 0)) {
      Fields vessel(content, surface.where + ", \"vessels\"");
      const Vec3 color = vessel.vector("paint", geometry::NamedVessel{}.color);
      surface.vessels.push_back(vesselAlong(axisFrom(vessel), color));
      surface.vessels.back().name = vessel.text("name");
      surface.vessels.back().inWall = true;
      vessel.requireNothingElse();
    }
  }

  /// Each point is [x, y, z, ms].
  static void readWays(Fields& fields, SurfaceDefinition& surface) {
    for (const json& content : fields.list("ways", 0)) {
      Fields fieldsOfWay(content, surface.where + ", \"ways\"");
      geometry::NamedWay way{fieldsOfWay.text("name"), fieldsOfWay.positive("width", 1), {}, {}};
      const json& points = fieldsOfWay.list("points", 2);
      way.points.resize(static_cast<Eigen::Index>(points.size()), 3);
      way.reachedMs.resize(way.points.rows());
      for (Eigen::Index i = 0; i < way.points.rows(); ++i) {
        const json& point = points[static_cast<std::size_t>(i)];
        const std::string key = "points[" + std::to_string(i) + "]";
        if (!point.is_array() || point.size() != 4 || !point[3].is_number())
          fieldsOfWay.fail(key, "is " + point.dump(), "write each point as [x, y, z, ms]");
        way.points.row(i) =
            vectorFrom(json::array({point[0], point[1], point[2]}), fieldsOfWay.where(), key).transpose();
        way.reachedMs[i] = point[3].get<double>();
        if (!(way.reachedMs[i] >= 0) || (i > 0 && way.reachedMs[i] < way.reachedMs[i - 1]))
          fieldsOfWay.fail(key, "has the time " + point[3].dump(), "times ascend from 0 ms");
      }
      fieldsOfWay.requireNothingElse();
      surface.ways.push_back(std::move(way));
    }
  }

  OrganDefinition definition_;
  std::set<std::filesystem::path> files_;
};

} // namespace

const SurfaceDefinition& OrganDefinition::surface(const std::string& surfaceName) const {
  std::set<std::string> names;
  for (const SurfaceDefinition& candidate : surfaces) {
    if (candidate.name == surfaceName)
      return candidate;
    names.insert(candidate.name);
  }
  throw UsageError("the organ has no surface \"" + surfaceName + "\"", name, "it has " + listed(names));
}

OrganDefinition readDefinition(const std::filesystem::path& path) {
  return Reader().read(path);
}

} // namespace viscera::sample_organs
