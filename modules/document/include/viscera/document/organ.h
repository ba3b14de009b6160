#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/ids.h"
#include "viscera/geometry/named_place.h"
#include "viscera/geometry/named_way.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::document {

/// Colour, opacity and visibility of an organ. Part of the document: it is saved and undone.
struct OrganLook {
  Vec3 color = {0.80, 0.45, 0.40}; ///< Red green blue, 0 to 1.
  bool vertexColors = true;        ///< The mesh's own colours, when it has some, go before `color`.
  double opacity = 1;              ///< 0 to 1.
  bool visible = true;
  bool tracked = true; ///< Its volume is a line of the chart.

  friend bool operator==(const OrganLook&, const OrganLook&) = default;
};

/// The file or sample organ that a surface came from, from which a session reads it again bit for bit. Empty
/// for one that was edited or made otherwise.
struct OrganOrigin {
  std::string fileHash; ///< SHA-256, in hex, of the bytes of `Organ::file` when the surface was read from it.
  std::string sample;   ///< A sample organ with its resolution: "heart@medium".
  std::string surface;  ///< Which of the sample's surfaces: "lv".

  friend bool operator==(const OrganOrigin&, const OrganOrigin&) = default;
};

/// How an organ follows the handles.
enum class Mobility {
  bends, ///< As soft tissue: every vertex by its coordinates.
  rigid, ///< As a whole, by the rotation and translation nearest to that (`deformation::rigidBinding`).
  fixed, ///< Not at all: it stays where it is at rest.
};

/// "bends", "rigid", "fixed".
std::string nameOf(Mobility mobility);
/// What an organ of that name begins with: bones are rigid, all else bends.
Mobility usualMobility(const std::string& name);
/// The mobility of that name; none for another word.
std::optional<Mobility> mobilityFromName(const std::string& name);

/// An organ of the document: a named surface with its colour and other properties. Immutable once in a
/// document.
struct Organ {
  OrganId id;
  std::string name;
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< At rest, mm, LPS; never null.
  OrganLook look;
  OrganId parent;             ///< The organ whose cavity this is; none for an organ of its own.
  std::filesystem::path file; ///< The file from which it was read; empty for one that the program made.
  OrganOrigin origin;
  /// Parts of it that have names, for a sample organ those of its definition; a session names the sample.
  std::vector<geometry::NamedPlace> places;
  /// Along which an excitation runs, from the same source: a heart's conduction system.
  std::vector<geometry::NamedWay> ways;
  std::vector<Text> warnings; ///< What a user should know: assumed space, implausible size, repairs.
  int boundaryEdges = 0;      ///< Edges with one triangle. An open surface has no volume.
  double restVolumeMm3 = 0;   ///< Signed, of the rest mesh; 0 for an open one.

  /// No motion of the handles in the pose may change the volume. Only of a closed surface.
  bool volumeLocked = false;
  Mobility mobility = Mobility::bends;

  bool closed() const { return boundaryEdges == 0; }
};

/// The most by which the largest part of a tissue's colour exceeds the smallest.
inline constexpr double kMostVivid = 0.7;

/// Whether a colour is purer than any tissue: tables of label maps number their labels with such colours.
bool isPure(const Vec3& color);

/// Makes an organ without an id from a surface: checks the indices and coordinates, counts its open edges and
/// measures its volume, O(m log m), so that a worker can do it before the document is touched. What is wrong
/// with the surface becomes a warning each; a closed one that is inside out is turned around. A painted one
/// has the mean of its colours for its own; one that is painted in a single colour is seen as every organ in
/// a colour of its own, and not by its vertices. An organ that its name tells has the colour of
/// `anatomy::colorNamed` where the surface has no colour, or a single one that `isPure`; a bone is rigid.
/// Throws `DataError` for an invalid mesh or one without triangles.
Organ makeOrgan(std::string name, geometry::TriangleMesh mesh);
/// The same for a mesh that is shared; it is copied only when it has to be turned around.
Organ makeOrgan(std::string name, std::shared_ptr<const geometry::TriangleMesh> mesh);
/// The same for a mesh whose report, that of `geometry::checkSurface`, is known.
Organ makeOrgan(std::string name, std::shared_ptr<const geometry::TriangleMesh> mesh,
                geometry::SurfaceReport report);

} // namespace viscera::document
