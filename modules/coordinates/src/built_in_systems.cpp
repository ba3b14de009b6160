#include "viscera/coordinates/built_in_systems.h"

#include "viscera/coordinates/celestial/s_celestial.h"
#include "viscera/coordinates/celestial/t_celestial.h"
#include "viscera/coordinates/classical/natural_neighbours.h"
#include "viscera/coordinates/classical/wachspress.h"
#include "viscera/coordinates/green/green_coordinates.h"
#include "viscera/coordinates/layered/catalogue_of_layers.h"
#include "viscera/coordinates/mean_value/mean_value.h"
#include "viscera/coordinates/mean_value/positive_mean_value.h"
#include "viscera/coordinates/mean_value/spherical_mean_value.h"
#include "viscera/coordinates/nspace/c_celestial.h"
#include "viscera/coordinates/nspace/determinants_approach.h"
#include "viscera/coordinates/nspace/gradient_method.h"
#include "viscera/coordinates/nspace/lagrange_minimisation.h"
#include "viscera/coordinates/nspace/wire_approach.h"
#include "viscera/coordinates/sphere/delaunay_approach.h"
#include "viscera/coordinates/sphere/incremental_approach.h"
#include "viscera/coordinates/sphere/numerical_integration.h"
#include "viscera/coordinates/sphere/voronoi_regions.h"
#include "viscera/coordinates/tetrahedra/bounded_biharmonic.h"
#include "viscera/coordinates/tetrahedra/harmonic.h"

namespace viscera::coordinates {

std::vector<std::shared_ptr<const CoordinateSystem>> builtInSystems() {
  return {std::make_shared<SCelestial>(),
          std::make_shared<TCelestial>(),
          std::make_shared<CCelestial>(),
          std::make_shared<MeanValue>(),
          std::make_shared<SphericalMeanValue>(),
          std::make_shared<PositiveMeanValue>(),
          std::make_shared<Harmonic>(),
          std::make_shared<GreenCoordinates>(),
          std::make_shared<Wachspress>(),
          std::make_shared<NaturalNeighbours>(),
          std::make_shared<BoundedBiharmonic>(),
          std::make_shared<LagrangeMinimisation>(),
          std::make_shared<GradientMethod>(),
          std::make_shared<DeterminantsApproach>(),
          std::make_shared<WireApproach>(),
          std::make_shared<DelaunayApproach>(),
          std::make_shared<VoronoiRegions>(),
          std::make_shared<IncrementalApproach>(),
          std::make_shared<NumericalIntegration>(),
          std::make_shared<CatalogueOfLayers>()};
}

} // namespace viscera::coordinates
