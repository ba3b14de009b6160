#pragma once

#include <memory>
#include <optional>

namespace viscera::scene {

class OrganView;

/// Shades the folds of organs (ambient occlusion) and softens lights (tone mapping), by VTK's passes over the
/// finished picture. Only applied if nothing is translucent and no colours stand for numbers, since
/// translucent layers are peeled, and shading would change colours of a legend. Text is not shaded.
class DepthShading {
public:
  /// Takes a view that has its window already. The view may be destroyed first.
  explicit DepthShading(OrganView& view);
  ~DepthShading();
  DepthShading(const DepthShading&) = delete;
  DepthShading& operator=(const DepthShading&) = delete;

  /// Switches shading on or off. None: on unless the driver is a software renderer, which would need two or
  /// three times as long for a frame.
  void setWanted(std::optional<bool> wanted);
  /// Whether shading is on. The kind of driver is known only after the first frame.
  bool wanted() const;
  /// Whether the last frame was drawn with shading.
  bool drawn() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
