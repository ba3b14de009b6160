#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "organ_picture.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/presentation/opened_heart.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {

/// Draws the tissue of a sample heart that is cut open, its coronary vessels, the fat between its atria and
/// its blood, in place of the heart's own surfaces, which still are what clicks meet and names are on.
class HeartPicture {
public:
  /// Something that is drawn beside the tissue, as a closed surface in the present pose.
  struct Layer {
    geometry::SurfaceView surface;
    Vec3 color;
    enum class Kind { vessels, septum, blood } kind = Kind::vessels;
  };

  HeartPicture(scene::OrganView& view, Threads threads) : view_(view), threads_(threads) {}
  ~HeartPicture();

  /// Updates the tissue to the present pose. `numbers`: organs show numbers as colours, which tissue has not.
  void update(const Scene& scene, bool numbers);
  /// The heart that is drawn as tissue; none while it is whole, and while its tissue is not there yet.
  const std::optional<OpenedHeart>& opened() const { return opened_; }
  /// The tissue in the present pose, while there is an opened heart.
  geometry::SurfaceView surface() const { return {points_.get(), &tissue_->mesh()->triangles}; }
  /// The tissue at rest, while there is an opened heart.
  const std::shared_ptr<const geometry::TriangleMesh>& mesh() const { return tissue_->mesh(); }
  /// A number that changes whenever `opened` or `surface` do.
  std::uint64_t revision() const { return revision_; }

  /// The vessels, the septum between the atria and the blood that are drawn.
  std::vector<Layer> layers() const;
  /// The lines of the vessels in the present pose, all in one; they stay the same object.
  const std::shared_ptr<const Points>& vesselLines() const { return namedLines_; }
  /// Where the name of a vessel is on the lines.
  struct VesselName {
    std::string name;
    Eigen::Index point = 0;
    bool inFace = false; ///< In the face of the cut, which so does not hide it.
    bool operator==(const VesselName&) const = default;
  };
  /// A place for each name of a vessel that the cut leaves something of; in the muscle, of one that it meets.
  std::vector<VesselName> vesselNames(const scene::CutPlane& plane) const;
  /// A septum in the face of the cut.
  struct SeptumName {
    const char* name = "";
    std::shared_ptr<const Points> middle; ///< One point, which follows the pose.
    bool operator==(const SeptumName&) const = default;
  };
  /// The septa that the cut meets.
  std::vector<SeptumName> septa() const;
  /// Updates `septa`. O(1), and O(vertices) for another plane.
  void updateSepta(const scene::CutPlane& plane, const live::PosedOrgans& organs);

  /// Leaves the surfaces of an opened heart undrawn in the appearances.
  void apply(std::map<document::OrganId, Appearance>& appearances) const;
  /// Updates the look of the tissue to that of the heart's outer surface.
  void updateLook(const scene::OrganActor& outer, const scene::CutPlane& plane);

  const scene::OrganActor* actor() const { return opened_ ? actor_.get() : nullptr; }
  /// Whether blood is drawn.
  bool full() const;
  /// Whether an organ is a cavity of the opened heart.
  bool isCavity(document::OrganId organ) const;

private:
  /// A layer with its actor: arteries, veins, the septum between the atria, blood of the left and of the
  /// right side.
  struct Drawn {
    std::shared_ptr<scene::OrganActor> actor; ///< Null where there is nothing of it.
    std::shared_ptr<Points> points = std::make_shared<Points>();
    bool added = false;
  };
  static constexpr std::size_t kVesselLayers = 2, kSeptumLayer = 2, kFirstBlood = 3, kLayers = 5;
  static Layer::Kind kindOf(std::size_t layer);
  std::shared_ptr<const geometry::TriangleMesh> meshOf(std::size_t layer) const;

  bool wanted(std::size_t layer) const;
  void showLayers();
  void moveLayers(const Points& carriers);
  void addActors();
  void take(std::shared_ptr<const live::HeartTissue> tissue);
  void follow(const live::PosedOrgans& organs);
  void leave();
  void findSeptum(const scene::CutPlane& plane);
  void updateAtrialSeptum(const scene::CutPlane& plane);

  scene::OrganView& view_;
  Threads threads_;
  std::optional<OpenedHeart> opened_;
  std::shared_ptr<const live::HeartTissue> tissue_; ///< What the actor draws; kept for the next cut.
  std::shared_ptr<scene::OrganActor> actor_;
  std::shared_ptr<Points> points_;
  std::array<Drawn, kLayers> layers_;
  std::shared_ptr<Points> lines_ = std::make_shared<Points>();
  std::shared_ptr<const Points> namedLines_ = lines_;
  /// The surfaces that the points were made from.
  using Moment = std::vector<std::pair<std::shared_ptr<const Points>, std::uint64_t>>;
  Moment moment_;
  std::optional<scene::CutPlane> plane_;
  std::uint64_t revision_ = 0;
  /// The septum that the plane meets: the vertices on both sides of its middle.
  struct Septum {
    document::OrganId left, right;
    Eigen::Index leftVertex = 0, rightVertex = 0;
  };
  std::optional<Septum> septum_;
  bool atrialMet_ = false;                     ///< Whether the plane meets the septum between the atria.
  std::optional<scene::CutPlane> septumPlane_; ///< For which `septum_` was sought.
  std::shared_ptr<Points> septumPoint_ = std::make_shared<Points>(Points::Zero(1, 3));
  std::shared_ptr<Points> atrialPoint_ = std::make_shared<Points>(Points::Zero(1, 3));
};

} // namespace viscera::presentation
