#pragma once

#include <map>
#include <memory>
#include <optional>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/ghost_outline.h"

namespace viscera::presentation {

/// How an organ's surface is drawn when a colour map, a cut or a slide overrides the look that the organ has
/// in the document.
struct Appearance {
  bool visible = true;
  double opacity = 1;
  std::optional<scene::CutPlane> clip = std::nullopt;
  std::shared_ptr<const Values> values = nullptr; ///< Null: its own colours.
  bool drawn = true; ///< Else another surface is drawn in its place, while clicks and names still meet it.
};

/// The colour map that is shared by all surfaces that show numbers.
struct MapColors {
  scene::ColorMap colors;
  scene::ValueRange range{0, 0};
  std::uint64_t revision = 0; ///< A number that changes when values have changed in place.
};

/// Draws the surfaces of a document's organs, the outlines of their rest shapes, and the outline of the
/// selected one among several.
class OrganPicture {
public:
  OrganPicture(scene::OrganView& view, Threads threads) : view_(view), threads_(threads) {}
  ~OrganPicture();

  /// Adds and removes organs and updates their points; returns whether the set of organs has changed.
  bool updateOrgans(const Scene& scene);
  /// Updates the surfaces that are not part of the document.
  void updateTransientSurfaces(const std::vector<TransientSurface>& transient);
  /// Updates how each organ is drawn: by its own look unless `appearances` has an entry for it.
  void updateLooks(const Scene& scene, const std::map<document::OrganId, Appearance>& appearances,
                   const MapColors& colors);

  document::OrganId organOf(const scene::OrganActor* actor) const;
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const;

private:
  struct Shown {
    std::shared_ptr<const document::Organ> organ;
    std::shared_ptr<scene::OrganActor> actor;
    std::shared_ptr<const Points> points;
    std::uint64_t revision = 0;
    std::unique_ptr<scene::GhostOutline> ghost;
    std::unique_ptr<scene::GhostOutline> outline; ///< While it is selected among others.
    std::optional<scene::CutPlane> clip;
    std::shared_ptr<const Values> values;
    bool vertexColors = true;
  };

  void drop(Shown& shown);
  void add(const std::shared_ptr<const document::Organ>& organ);
  void follow(Shown& shown, const live::PosedOrgans& organs);
  void updateGhost(Shown& shown, bool wanted);
  void updateSelection(Shown& shown, bool selected, bool visible);
  bool showsSeveral() const;
  void updateColors(Shown& shown, const Appearance& appearance, const MapColors& colors);

  scene::OrganView& view_;
  Threads threads_;
  std::map<document::OrganId, Shown> shown_;
  std::vector<std::shared_ptr<scene::OrganActor>> transient_;
  MapColors colors_; ///< The colours used in the last update.
};

} // namespace viscera::presentation
