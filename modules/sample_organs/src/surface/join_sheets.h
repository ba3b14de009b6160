#pragma once

#include <memory>
#include <vector>

#include "implicit/implicit_node.h"
#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::sample_organs {

/// A closed, outward surface with colours, and the implicit surface that it was made of.
struct Sheet {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  NodePtr node;
};

/// Joins the surfaces of a body and of its lumina, which are apart, to the one surface of the tissue between
/// them: what a lumen covers of the body's surface (the cut end of a vessel) and what of a lumen is outside
/// the body is cut away, and a narrow band closes each rim. The rest keeps its points and colours, so that
/// walls may be thinner than the triangles' edges. Throws `DataError` when the rims of body and lumina do not
/// match or the result is not closed. O(m). Bitwise independent of the number of threads.
geometry::TriangleMesh joinSheets(const Sheet& body, const std::vector<Sheet>& lumina, Threads threads);

} // namespace viscera::sample_organs
