#pragma once

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::localised_scc {

/// Localised Celestial coordinates (thesis 4.5), id `localised-s-celestial`. A point of one region has that
/// region's coordinates, a point of a swapping zone those of the zone's super-region, and within the offset
/// of a zone the two are blended. Handles of other groups have weight exactly 0. With one group it is the
/// inner system itself.
///
/// Departs from the thesis where its zones are ambiguous; see `RegionLayout`.
class LocalisedSCelestial final : public coordinates::DescribedSystem {
public:
  /// `inner` are the systems that a user may choose inside the regions, positive ones without a cage; the
  /// first is the standard one. At least one.
  explicit LocalisedSCelestial(std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> inner);

  /// Points in no region are failures, as are those for which the inner system has no answer.
  std::unique_ptr<coordinates::Binding> bind(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override;

  /// By the product rule from the inner system's gradients and the blend's.
  coordinates::CoordinateGradients gradients(const coordinates::HandleSet& handles, const Points& points,
                                             const coordinates::BindOptions& options,
                                             Progress& progress) const override;

  /// Regions, zones and super-regions of the groups; the offset's upper bound is the largest among the
  /// regions.
  coordinates::SpaceLayout layout(const coordinates::HandleSet& handles,
                                  const coordinates::ParameterValues& parameters) const override;

private:
  const coordinates::CoordinateSystem& innerFor(const coordinates::ParameterValues& values) const;

  std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> inner_;
};

/// The localised system of the program: its inner systems are the built-in ones that are positive,
/// continuous, defined everywhere and need nothing but handles.
std::shared_ptr<const LocalisedSCelestial> localisedWithBuiltIns();

} // namespace viscera::localised_scc
