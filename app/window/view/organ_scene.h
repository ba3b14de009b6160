#pragma once

#include <QObject>

#include <map>
#include <memory>

#include "viscera/scene/ghost_outline.h"
#include "viscera/scene/organ_view.h"
#include "window/workspace.h"

namespace viscera::app {

/// Keeps the organs in the 3D view as the document and its live binding have them: points without a copy,
/// colours, visibility, selection, the ghost of the rest shape, and the influence of the current handle with
/// its legend.
class OrganScene final : public QObject {
  Q_OBJECT

public:
  OrganScene(Workspace& workspace, scene::OrganView& view, QObject* parent = nullptr);
  ~OrganScene() override;

  /// The organ that an actor of the view shows, or none.
  document::OrganId organOf(const scene::OrganActor* actor) const;
  /// The actor that shows an organ, or null.
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const;

  void setGhostShown(bool shown);
  bool ghostShown() const { return ghostShown_; }
  void setInfluenceShown(bool shown);
  bool influenceShown() const { return influenceShown_; }
  /// While somebody else decides what is seen of the organs and how they are coloured by numbers; afterwards
  /// everything is as the document has it.
  void setSuspended(bool suspended);
  /// The colour of ghost outlines.
  void setGhostColor(const Vec3& color);

Q_SIGNALS:
  /// Something looks different: render when convenient.
  void changed();
  /// Organs came or went.
  void organsChanged();
  /// Looks were taken from the document: whoever has suspended this applies its own again.
  void looksApplied();

private:
  struct Shown {
    std::shared_ptr<const document::Organ> organ;
    std::shared_ptr<scene::OrganActor> actor;
    std::unique_ptr<scene::GhostOutline> ghost;
  };

  void syncOrgans();
  void addOrgan(const std::shared_ptr<const document::Organ>& organ);
  void applyLook(Shown& shown);
  void onLive(const live::LiveEvent& event);
  void syncSelection();
  void syncGhosts();
  void syncInfluence();

  Workspace& workspace_;
  scene::OrganView& view_;
  std::map<document::OrganId, Shown> shown_;
  Vec3 ghostColor_ = Vec3(0.6, 0.65, 0.7);
  bool ghostShown_ = false;
  bool influenceShown_ = false;
  bool suspended_ = false;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
