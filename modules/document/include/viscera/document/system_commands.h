#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "viscera/core/progress.h"
#include "viscera/document/command.h"
#include "viscera/geometry/triangle_mesh.h"

/// Commands that choose the coordinate system and the cage that some systems need. The document does not know
/// which systems exist: code that has the registry should check the choice beforehand, and `LiveBinding`
/// reports for every organ what the system does not accept.
namespace viscera::document {

/// Chooses the coordinates and all of their parameters.
Command setSystem(SystemChoice choice);

/// Sets one parameter of the present system. Values of one parameter that follow each other join one step
/// until `UndoStack::seal` (a slider).
Command setParameter(std::string name, double value);

/// A cage is a coarse surface: each of its vertices is a handle.
inline constexpr int kMostCageVertices = 10'000;

/// A surface that can be a cage: closed, outward and without self-intersections.
struct GivenCage {
  std::string name; ///< Of its file, for the undo step.
  std::shared_ptr<const geometry::TriangleMesh> mesh;
};

/// Reads a surface file as a cage; one that is inside out is turned around. Throws what
/// `medical_io::readSurface` throws, `DataError` that names the file for a surface that is open, not
/// manifold, of more than `kMostCageVertices`, or that crosses itself, and `Cancelled`.
GivenCage readCage(const std::filesystem::path& file, Progress& progress);

/// Whether there is one handle at rest at each vertex of the cage. O(handles x vertices).
bool handlesAtAllVertices(const Rig& rig, const geometry::TriangleMesh& cage);

/// Sets the cage. If there are handles at all of its vertices, they become its corners and keep their other
/// properties; further handles stay, without influence. Else the cage's vertices become the handles, at rest,
/// and replace the present handles and their groups. Throws as `replaceRig` and `coordinates::requireCage`.
Command takeCage(GivenCage cage);

/// Removes the cage: the convex hull of the handles is the cage again. All handles stay.
Command dropCage();

} // namespace viscera::document
