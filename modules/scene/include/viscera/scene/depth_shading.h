#pragma once

#include <memory>
#include <optional>

namespace viscera::scene {

class OrganView;

/// Shades the folds of organs (ambient occlusion) and softens lights (tone mapping), by VTK's passes over the
/// finished picture. Only where nothing is translucent and no colours mean numbers: then layers are peeled,
/// or colours are read off a legend, and the picture is drawn as without. Text stays as clear as it is.
class DepthShading {
public:
  /// Of a view that has its window already. It may go first.
  explicit DepthShading(OrganView& view);
  ~DepthShading();
  DepthShading(const DepthShading&) = delete;
  DepthShading& operator=(const DepthShading&) = delete;

  /// None: where the driver is no software renderer, which needs two or three times as long for a frame.
  void setWanted(std::optional<bool> wanted);
  /// Whether it is wanted, as far as it is known: what the driver is shows with the first frame.
  bool wanted() const;
  /// Whether the last frame was drawn so.
  bool drawn() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::scene
