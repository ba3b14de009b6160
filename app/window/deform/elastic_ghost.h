#pragma once

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

#include "viscera/elasticity/elastic_organ.h"
#include "viscera/live/elastic_comparison.h"
#include "window/modes/mode.h"

namespace viscera::app {

/// The switch "Beside elasticity" of the mode Deform: while it is on, the elastic organ under the same moved
/// handles is drawn as a ghost, and the current organ is coloured by its distance from it, in mm. A worker
/// solves it when the pose has been the same for a moment; another pose, organ or rig cancels that and takes
/// what was drawn away, so that colours never belong to another pose.
class ElasticGhost final : public QObject {
  Q_OBJECT

public:
  /// All parts have to live longer.
  explicit ElasticGhost(const ModeParts& parts, QObject* parent = nullptr);
  ~ElasticGhost() override;

  /// The distances that are shown; none while there are none.
  const std::optional<live::SurfacesApart>& apart() const { return apart_; }
  /// Why none are shown, as a sentence; empty while they are, and while the switch is off.
  const QString& reason() const { return reason_; }

Q_SIGNALS:
  void changed();

private:
  /// All that the elastic organ depends on.
  struct Cause {
    document::OrganId organ;
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::shared_ptr<const document::Rig> rig;
    std::shared_ptr<const document::SystemChoice> system;
    std::shared_ptr<const Points> pose;
    bool operator==(const Cause&) const = default;
  };
  /// The tetrahedra of a surface, kept from one pose to the next.
  struct Filled {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::shared_ptr<const elasticity::ElasticOrgan> organ;
  };
  struct Solved {
    Filled filled;
    live::ElasticComparison comparison;
  };

  bool wanted() const;
  std::optional<Cause> present() const;
  void follow();
  void drop();
  void solve();
  void take(const Cause& cause, JobResult<Solved> result);
  void draw(const Cause& cause, const live::ElasticComparison& comparison);
  void tell(const QString& reason);

  Workspace& workspace_;
  Playback& playback_;
  ViewModel& view_;
  Picture& picture_;
  QTimer still_;               ///< The pose has to be the same for so long before it is solved.
  std::optional<Cause> cause_; ///< Of what is drawn, being solved or could not be solved.
  Filled filled_;
  bool drawn_ = false;
  std::optional<live::SurfacesApart> apart_;
  QString reason_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
