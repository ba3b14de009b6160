#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/named_place.h"
#include "viscera/geometry/named_vessel.h"
#include "viscera/geometry/named_way.h"
#include "viscera/geometry/triangle_mesh.h"

/// Generates sample organs from the compact definitions in `sample_organs/`.
namespace viscera::sample_organs {

enum class Resolution { low, medium, high };

/// "low", "medium", "high". Throws `UsageError` for anything else.
Resolution resolutionFromName(const std::string& name);
std::string nameOf(Resolution resolution);

/// One closed surface of a sample organ: its outer one, a cavity in that, or an organ that lies beside it.
struct SampleSurface {
  std::string name; ///< "outer", "lv", "rv"
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  Vec3 color = {0.8, 0.45, 0.4};            ///< The surface's own colour, red green blue, 0 to 1.
  std::vector<geometry::NamedPlace> places; ///< Its parts that have names.
  /// The name of an organ of its own: "Liver". Empty for the one surface of an organ, and for cavities in
  /// it.
  std::string organ = {};
  std::vector<geometry::NamedWay> ways = {}; ///< Along which an excitation runs: the conduction system.
  bool hidden = false; ///< Not shown until someone switches it on: it covers other organs.
};

struct SampleOrgan {
  std::string name; ///< "heart"
  Resolution resolution = Resolution::medium;
  std::vector<SampleSurface> surfaces; ///< The outer surface first.
};

/// The folder of definitions and the folder in which generated surfaces are cached.
struct SampleLibrary {
  std::filesystem::path definitions; ///< The folder `sample_organs`.
  std::filesystem::path cache;       ///< Written if possible; may be deleted at any time.
};

/// The library of this build or installation: `VISCERA_SAMPLE_ORGANS` when set, else the installed folder
/// beside the program, else the source tree's; the cache is `$XDG_CACHE_HOME/viscera/organs`.
SampleLibrary standardLibrary();

/// The names of the definitions in the library, sorted.
std::vector<std::string> sampleNames(const SampleLibrary& library);

/// Loads an organ from the cache or makes it (seconds), then caches it under the hash of its definition and
/// of the generator's version; a damaged cache is rebuilt silently. Throws `UsageError` for an unknown organ
/// (it lists the existing ones), `NoInputError` for a definition that cannot be read, `DataError` for a
/// faulty one (it names file, node and field), `Cancelled`. The same definition gives the same surface,
/// whatever the number of threads.
///
///     const SampleLibrary library = standardLibrary();
///     const SampleOrgan liver = sampleOrgan(library, "liver", Resolution::low, progress);
///     const geometry::TriangleMesh& mesh = *liver.surfaces.front().mesh;
SampleOrgan sampleOrgan(const SampleLibrary& library, const std::string& name, Resolution resolution,
                        Progress& progress, Threads threads = {});

/// One surface of an organ by name, also one that is only for checks and so not part of `sampleOrgan` (the
/// heart's "chambers": without the great vessels). As `sampleOrgan`; throws `UsageError` for an unknown
/// surface too.
SampleSurface sampleSurface(const SampleLibrary& library, const std::string& organ,
                            const std::string& surface, Resolution resolution, Progress& progress,
                            Threads threads = {});

/// The parts of a surface that have names, without making it. Throws as `sampleSurface`. Takes some
/// milliseconds.
std::vector<geometry::NamedPlace> namedPlaces(const SampleLibrary& library, const std::string& organ,
                                              const std::string& surface);

/// The ways of a surface, without making it. As `namedPlaces`.
std::vector<geometry::NamedWay> namedWays(const SampleLibrary& library, const std::string& organ,
                                          const std::string& surface);

/// The vessels with names on and in a surface, such as the heart's coronary arteries and veins, with the
/// detail of `resolution`; a surface that is generated has them as part of its shape. As `namedPlaces`, but
/// takes some tenths of a second.
std::vector<geometry::NamedVessel> namedVessels(const SampleLibrary& library, const std::string& organ,
                                                const std::string& surface,
                                                Resolution resolution = Resolution::high);

/// A named implicit surface of a definition: negative inside, about the distance in mm near the surface. For
/// placing handles by the anatomy. Thread-safe.
using ImplicitSurface = std::function<double(const Vec3& point)>;

/// `node` is the name of a node ("ventricles") or "surf " and the name of a surface ("surf rv"), with the
/// detail of `resolution`. Throws as `sampleSurface`. Takes some milliseconds; a call of the result about a
/// microsecond.
ImplicitSurface implicitSurface(const SampleLibrary& library, const std::string& organ,
                                const std::string& node, Resolution resolution = Resolution::high);

} // namespace viscera::sample_organs
