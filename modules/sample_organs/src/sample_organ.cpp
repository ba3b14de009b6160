#include "viscera/sample_organs/sample_organ.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <system_error>
#include <utility>

#include "definition/node_builder.h"
#include "definition/organ_definition.h"
#include "surface/generate_surface.h"
#include "surface/join_sheets.h"
#include "surface_cache.h"
#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sample_organs {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<Resolution, const char*> kNames[] = {
    {Resolution::low, "low"}, {Resolution::medium, "medium"}, {Resolution::high, "high"}};

fs::path fromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

fs::path definitionsFolder() {
  if (fs::path chosen = fromEnvironment("VISCERA_SAMPLE_ORGANS"); !chosen.empty())
    return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path() / VISCERA_ORGANS_FROM_BINDIR;
    if (fs::is_directory(installed, error))
      return installed.lexically_normal();
  }
  return VISCERA_ORGANS_SOURCE_DIR;
}

fs::path cacheFolder() {
  if (const fs::path cache = fromEnvironment("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "viscera/organs";
  if (const fs::path home = fromEnvironment("HOME"); home.is_absolute())
    return home / ".cache/viscera/organs";
  return {};
}

OrganDefinition definitionOf(const SampleLibrary& library, const std::string& organ) {
  const std::vector<std::string> names = sampleNames(library);
  if (std::find(names.begin(), names.end(), organ) == names.end()) {
    const std::set<std::string> known(names.begin(), names.end());
    throw UsageError(misuse("there is no sample organ \"%1\"", organ), library.definitions.string(),
                     phrase("there are %1", listed(known)));
  }
  return readDefinition(library.definitions / (organ + ".json"));
}

/// Makes surfaces of one definition at one resolution; builds the tree only when the cache does not have
/// them.
class Maker {
public:
  Maker(const SampleLibrary& library, OrganDefinition definition, Resolution resolution, Threads threads)
      : definition_(std::move(definition)), resolution_(resolution), threads_(threads), cache_(library.cache),
        builder_(definition_, resolution) {}

  const OrganDefinition& definition() const { return definition_; }

  SampleSurface make(const SurfaceDefinition& surface, Progress& progress) {
    progress.throwIfCancelled();
    progress.report(0, definition_.name + ", " + surface.name);
    const CacheKey key = keyOf(surface);
    std::optional<geometry::TriangleMesh> mesh = cache_.load(key);
    if (!mesh) {
      mesh = generated(surface, progress);
      cache_.store(key, *mesh);
    }
    return {surface.name,  std::make_shared<const geometry::TriangleMesh>(std::move(*mesh)),
            surface.color, surface.places,
            surface.organ, surface.ways,
            surface.hidden};
  }

private:
  CacheKey keyOf(const SurfaceDefinition& surface) const {
    const std::string name = definition_.name + "-" + surface.name + "-" + nameOf(resolution_);
    const std::string all = name + "/" + std::to_string(kGeneratorVersion);
    return {name, contentHash(all, definition_.contentHash)};
  }

  geometry::TriangleMesh generated(const SurfaceDefinition& surface, Progress& progress) {
    if (surface.joined())
      return joined(surface, progress);
    const NodePtr root = builder_.root(surface);
    const SurfaceGoal goal{surface.trianglesAt(resolution_), surface.largestSpacing};
    try {
      return generateSurface(*root, goal, threads_, progress);
    } catch (const DataError& error) {
      throw DataError(error.problem(), surface.where, error.tryThis());
    }
  }

  Sheet sheetOf(const SurfaceDefinition& surface, Progress& progress) {
    return {make(surface, progress).mesh, builder_.root(surface)};
  }

  geometry::TriangleMesh joined(const SurfaceDefinition& surface, Progress& progress) {
    const double parts = 1 + static_cast<double>(surface.less.size());
    Sheet body;
    runPart(progress, 0, 1 / parts,
            [&](Progress& part) { body = sheetOf(definition_.surface(surface.fromAt(resolution_)), part); });
    if (const NodePtr paint = builder_.paint(surface)) {
      geometry::TriangleMesh mesh = *body.mesh;
      paintSurface(*paint, mesh, threads_);
      body.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
    }
    std::vector<Sheet> lumina;
    for (const std::string& name : surface.less) {
      const double from = (1 + static_cast<double>(lumina.size())) / parts;
      runPart(progress, from, from + 1 / parts,
              [&](Progress& part) { lumina.push_back(sheetOf(definition_.surface(name), part)); });
    }
    try {
      return joinSheets(body, lumina, threads_);
    } catch (const DataError& error) {
      throw DataError(error.problem(), surface.where, error.tryThis());
    }
  }

  OrganDefinition definition_;
  Resolution resolution_;
  Threads threads_;
  SurfaceCache cache_;
  NodeBuilder builder_;
};

} // namespace

Resolution resolutionFromName(const std::string& name) {
  for (const auto& [resolution, known] : kNames)
    if (name == known)
      return resolution;
  throw UsageError(misuse("there is no resolution \"%1\"", name), {}, misuse("use low, medium or high"));
}

std::string nameOf(Resolution resolution) {
  for (const auto& [candidate, name] : kNames)
    if (candidate == resolution)
      return name;
  return {};
}

SampleLibrary standardLibrary() {
  return {definitionsFolder(), cacheFolder()};
}

std::vector<std::string> sampleNames(const SampleLibrary& library) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator entry(library.definitions, error), end; !error && entry != end;
       entry.increment(error))
    if (const fs::path& file = entry->path(); file.extension() == ".json" && file.stem().extension().empty())
      names.push_back(file.stem().string());
  if (error)
    throw NoInputError(phrase("the sample organs cannot be listed: %1", error.message()),
                       library.definitions.string(),
                       "set VISCERA_SAMPLE_ORGANS to the folder of the definitions");
  std::sort(names.begin(), names.end());
  return names;
}

SampleOrgan sampleOrgan(const SampleLibrary& library, const std::string& name, Resolution resolution,
                        Progress& progress, Threads threads) {
  Maker maker(library, definitionOf(library, name), resolution, threads);
  const OrganDefinition& definition = maker.definition();
  double triangles = 0;
  for (const SurfaceDefinition& surface : definition.surfaces)
    if (!surface.checkOnly)
      triangles += surface.trianglesAt(resolution);
  SampleOrgan organ{definition.name, resolution, {}};
  double from = 0;
  for (const SurfaceDefinition& surface : definition.surfaces) {
    if (surface.checkOnly)
      continue;
    const double to = from + surface.trianglesAt(resolution) / triangles;
    runPart(progress, from, to, [&](Progress& part) { organ.surfaces.push_back(maker.make(surface, part)); });
    from = to;
  }
  progress.report(1);
  return organ;
}

std::vector<geometry::NamedPlace> namedPlaces(const SampleLibrary& library, const std::string& organ,
                                              const std::string& surface) {
  return definitionOf(library, organ).surface(surface).places;
}

std::vector<geometry::NamedWay> namedWays(const SampleLibrary& library, const std::string& organ,
                                          const std::string& surface) {
  return definitionOf(library, organ).surface(surface).ways;
}

SampleSurface sampleSurface(const SampleLibrary& library, const std::string& organ,
                            const std::string& surface, Resolution resolution, Progress& progress,
                            Threads threads) {
  Maker maker(library, definitionOf(library, organ), resolution, threads);
  return maker.make(maker.definition().surface(surface), progress);
}

std::vector<geometry::NamedVessel> namedVessels(const SampleLibrary& library, const std::string& organ,
                                                const std::string& surface, Resolution resolution) {
  const OrganDefinition definition = definitionOf(library, organ);
  const SurfaceDefinition& found = definition.surface(surface);
  NodeBuilder builder(definition, resolution);
  builder.root(found);
  std::vector<geometry::NamedVessel> vessels = builder.vessels();
  vessels.insert(vessels.end(), found.vessels.begin(), found.vessels.end());
  return vessels;
}

ImplicitSurface implicitSurface(const SampleLibrary& library, const std::string& organ,
                                const std::string& node, Resolution resolution) {
  const OrganDefinition definition = definitionOf(library, organ);
  NodeBuilder builder(definition, resolution);
  const std::string prefix = "surf ";
  const bool surface = node.rfind(prefix, 0) == 0;
  const NodePtr root =
      surface ? builder.root(definition.surface(node.substr(prefix.size()))) : builder.named(node);
  return [root](const Vec3& point) { return root->distance(point); };
}

} // namespace viscera::sample_organs
