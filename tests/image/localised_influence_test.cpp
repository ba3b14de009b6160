#include <algorithm>
#include <memory>

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "picture_check.h"
#include "view_fixture.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/localised_scc/localised_s_celestial.h"
#include "viscera/localised_scc/region_layout.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/region_hulls.h"

/// The comparison of the thesis's figure 4.17 on the sample stomach: what one handle reaches with one group
/// of all handles, and with four groups.
namespace viscera::scene {
namespace {

constexpr int kGroups = 4;
constexpr int kHandle = 2;

class LocalisedInfluence : public testing::Test {
protected:
  LocalisedInfluence() {
    Progress progress;
    const auto sample = sample_organs::sampleOrgan(sample_organs::standardLibrary(), "stomach",
                                                   sample_organs::Resolution::low, progress);
    stomach_ = sample.surfaces.front().mesh;
    deformation::Placement placement;
    placement.enclosing = false;
    const Points placed = deformation::placeHandles(*stomach_, placement);
    const auto grouping = deformation::groupsAlongAxis(placed, stomach_->points, kGroups);
    handles_.positions.resize(placed.rows() + grouping.added.rows(), 3);
    handles_.positions << placed, grouping.added;
    handles_.groups = grouping.groups;
  }

  Values influence(const coordinates::CoordinateSystem& system) const {
    Progress progress;
    return system.bind(handles_, stomach_->points, {}, progress)->influence(kHandle);
  }

  vtkSmartPointer<vtkImageData> picture(const Values& influence, double most, const std::string& title,
                                        const std::vector<RegionHull>& hulls) const {
    tests::ViewInWindow window(420, 420);
    const auto organ = std::make_shared<OrganActor>(stomach_);
    window.view.add(organ);
    organ->showScalars(std::make_shared<Values>(influence), viridis(), {0, most});
    window.view.legend().show(title, "", viridis(), {0, most});
    window.view.handles()->SetPositions(handles_.positions.row(kHandle));
    window.view.handles()->SetSelection({0});
    window.view.regions().setHulls(hulls);
    window.view.lookFrom(StandardView::anterior);
    return grabPicture(window.surface.window());
  }

  std::shared_ptr<const geometry::TriangleMesh> stomach_;
  coordinates::HandleSet handles_;
  const std::shared_ptr<const coordinates::CoordinateSystem> plain_ = coordinates::builtInSystems().front();
  const std::shared_ptr<const coordinates::CoordinateSystem> localised_ =
      localised_scc::localisedSCelestial({plain_});
};

TEST_F(LocalisedInfluence, AHandleReachesAllOfTheStomachInOneGroupAndItsOwnPartInFour) {
  const Values global = influence(*plain_), local = influence(*localised_);
  EXPECT_TRUE((global.array() > 0).all());
  const localised_scc::RegionLayout layout(handles_, 10);
  int outside = 0;
  for (Eigen::Index v = 0; v < stomach_->points.rows(); ++v) {
    bool reached = false;
    for (const auto& share : layout.shares(stomach_->points.row(v).transpose())) {
      const auto& own = layout.handlesOf(share.set);
      reached = reached || std::binary_search(own.begin(), own.end(), kHandle);
    }
    if (reached)
      continue;
    ++outside;
    ASSERT_EQ(local[v], 0) << "vertex " << v;
  }
  EXPECT_GT(outside, stomach_->points.rows() / 4);

  const double most = std::max(global.maxCoeff(), local.maxCoeff());
  const auto left = picture(global, most, "Influence, one group", {});
  const auto right = picture(local, most, "Influence, four groups", {});
  tests::expectLooksLikeReference(contactSheet({left, right}, 2), "localised_influence");
}

TEST_F(LocalisedInfluence, RegionsZonesAndSuperRegionsLieAroundTheStomachAsGlass) {
  const std::vector<Vec3> colors = {Vec3(0.90, 0.62, 0.00), Vec3(0.34, 0.71, 0.91), Vec3(0.80, 0.47, 0.65),
                                    Vec3(0.00, 0.62, 0.45)};
  const auto layout = localised_->layout(handles_, {});
  const auto left = picture(Values::Zero(stomach_->points.rows()), 1, "Regions",
                            layoutHulls(layout, colors, {.regions = true}));
  const auto right =
      picture(Values::Zero(stomach_->points.rows()), 1, "Zones and super-regions",
              layoutHulls(layout, colors, {.regions = false, .zones = true, .superRegions = true}));
  tests::expectLooksLikeReference(contactSheet({left, right}, 2), "regions_and_zones");
}

} // namespace
} // namespace viscera::scene
