#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "file_bytes.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// Red, green, blue and opacity in this order of bytes, red highest.
using PackedColor = std::uint32_t;
inline constexpr PackedColor kNoColor = 0; ///< A colour that is not seen at all is none.

/// An object of a 3MF model with a place in another one, or in the print.
struct ThreeMfUse {
  std::string object; ///< Its key among the objects.
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
};

/// Some of the triangles of a mesh, behind those of the piece before.
struct ThreeMfPiece {
  std::size_t end = 0; ///< Of its triangles.
  std::string name;
  bool isShape = true; ///< False: it only changes how a print is made.
};

/// A mesh, or objects that are one.
struct ThreeMfObject {
  std::string name;
  std::string type; ///< "model"; "support" and others are no shape of an organ.
  std::vector<double> coordinates;
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::vector<std::array<PackedColor, 3>> colors; ///< One for each triangle's corners, or none at all.
  std::vector<ThreeMfUse> components;
  std::vector<ThreeMfPiece> pieces; ///< Of all triangles, at least two; empty: the mesh is one piece.
};

/// What the model parts of a 3MF file hold, unchecked.
struct ThreeMfModel {
  double mm = 1;       ///< Of one unit.
  std::string unit;    ///< As the file calls it.
  std::string comment; ///< Its description, in which Viscera states name and axes.
  std::map<std::string, ThreeMfObject> objects;
  std::vector<std::string> order;  ///< The keys of the objects as they came.
  std::vector<ThreeMfUse> printed; ///< What the file says to build.
  bool unreadColors = false;       ///< It has pictures or mixtures for colours.
  bool unreadShapes = false;       ///< It has lattices of beams or other shapes beside triangles.
};

/// The key of an object by the path of its model part and its number.
std::string threeMfKey(std::string_view path, std::string_view id);

/// Reads the model parts of a 3MF file (3MF Core Specification 1.3, with the colours of its materials
/// extension and the paths of its production extension): that which the package names, or the only one, and
/// those to which it refers, and what slicers state of the objects beside it. Packages that lack the lists of
/// the Open Packaging Conventions are read too. Takes memory for what the file holds, a few times its
/// unpacked text at most. Throws `DataError`.
ThreeMfModel readThreeMfModel(const FileBytes& file);

} // namespace viscera::medical_io
