#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "viscera/scene/label_layout.h"
#include "viscera/scene/organ_actor.h"
#include "viscera/scene/theme.h"

namespace viscera::scene {

class OrganView;

/// Draws labels beside the organs of a view and their parts, each with a line to what it names. Labels follow
/// the camera; they overlap neither each other nor any organ, no line runs through another one, and one that
/// finds no room, or whose opaque organ others hide, is left out; of many, those are named first of which
/// most is seen. While something moves (`OrganView::setMoving`) they stand still and only their lines follow,
/// but for one that would be covered. Belongs to the thread that renders; the view has to live longer.
class OrganLabels {
public:
  /// Where a part is, by which something hides it.
  enum class Lies {
    onSurface, ///< Of its organ, behind the face of a cut.
    inHollow,  ///< In a cavity that a cut leaves open.
    inFace,    ///< In what is cut: seen only in the face of a cut.
  };

  /// What is to be labelled.
  struct Item {
    std::string text; ///< UTF-8.
    std::shared_ptr<const OrganActor> organ;
    bool atEdge = false; ///< The line ends at the organ's edge: its middle is full of other organs.
    /// The line ends at this vertex of the organ while the reader can see it, and the label is left out while
    /// not; -1: anywhere on the organ.
    Eigen::Index vertex = -1;
    /// The vertices of a whole organ's parts that have names. Its line ends where the organ is seen and
    /// away from them; the label is left out where there is no such place.
    std::vector<Eigen::Index> places = {};
    /// When given, `vertex` is one of these points and not of the organ's: of something thin in or on the
    /// organ that has no surface of its own. It is seen from all sides. The points may move as the organ's
    /// do.
    std::shared_ptr<const Points> points = nullptr;
    Lies lies = Lies::onSurface;
  };

  /// A label as it was drawn last, in device pixels from the lower left corner.
  struct Drawn {
    std::string text;
    ScreenBox box;
    double targetX = 0; ///< Where its line ends.
    double targetY = 0;
  };

  explicit OrganLabels(OrganView& view);
  ~OrganLabels();
  OrganLabels(const OrganLabels&) = delete;
  OrganLabels& operator=(const OrganLabels&) = delete;

  void setItems(std::vector<Item> items);
  void setTheme(const Theme& theme);
  void setShown(bool shown);
  bool shown() const;

  /// The labels in the frame that was drawn last; those of invisible organs and those that found no room are
  /// not among them.
  std::vector<Drawn> drawn() const;

private:
  struct Layout;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
