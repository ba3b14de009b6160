#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

#include "viscera/presentation/presenter.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/workspace.h"

namespace viscera::app {

/// A view of the window together with the presenter that draws the document in it. It redraws whenever the
/// document, its organs, the selection, the stress or the view's state have changed. What handles the mouse
/// is given this; it is not needed to see something.
class Picture final : public QObject {
  Q_OBJECT

public:
  /// Who looks: the view where one works, or one beside it that only shows.
  enum class Role { working, showing };

  /// All have to live longer.
  Picture(Workspace& workspace, ViewModel& model, ViewWidget& view, Role role = Role::working,
          QObject* parent = nullptr);

  const presentation::Presenter& presenter() const { return presenter_; }
  scene::OrganView& view() const { return presenter_.view(); }
  document::OrganId organOf(const scene::OrganActor* actor) const { return presenter_.organOf(actor); }
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const {
    return presenter_.actorOf(organ);
  }
  /// The view's state as it is drawn, with what is selected.
  presentation::ViewState state() const;

  /// What is being measured, and organs that are in no document yet.
  void setMeasuring(presentation::PendingMeasurement measuring);
  /// Where they are shown alone, nothing of the document is: they will take its place.
  void setTransientSurfaces(std::vector<presentation::TransientSurface> transient, bool alone = false);
  /// Surfaces that were measured, beside the organs that move through them.
  void setMeasured(std::vector<presentation::TransientSurface> surfaces);
  /// Whether the document is made of the first view's organs, of which the view's state speaks by their ids:
  /// then a slide shows them in both views alike. For one that only shows.
  void setOfSameOrgans(bool same);
  /// Numbers on the organs, in place of the map that the view's state asks for; nothing: as it says.
  void setMap(std::optional<presentation::SurfaceMap> map);
  /// The range of the stress map's colours that another picture has, too, and whether this one has the
  /// legend; nothing: a range of its own.
  void setStressRange(std::optional<scene::ValueRange> range, bool legend = true);
  std::optional<scene::ValueRange> stressRange() const { return stressRange_; }
  bool stressLegend() const { return stressLegend_; }
  /// Where the valves of the heart are found that is shown beating, whenever the picture is drawn.
  using Valves = std::function<std::optional<sequences::ValveInstants>()>;
  void setValves(Valves valves);
  /// Whether it has what a movie of the view leaves out: distances, surfaces of others, bent slices.
  bool hasMoreThanMovies() const;
  /// The organ under the mouse, whose handles stand out among those of other organs; none: all are alike.
  void setPointedOrgan(document::OrganId organ);
  /// Names of these parts alone; nothing: as the view's state says.
  void setNamedParts(std::optional<std::vector<presentation::Part>> parts);

public Q_SLOTS:
  /// Brings the picture up to date and has it rendered soon.
  void refresh();

Q_SIGNALS:
  /// The picture is up to date with something new.
  void changed();

private:
  bool looksOtherwise() const;

  Workspace& workspace_;
  ViewModel& model_;
  ViewWidget& widget_;
  Role role_;
  presentation::Presenter presenter_;
  presentation::PendingMeasurement measuring_;
  std::vector<presentation::TransientSurface> transient_;
  std::vector<presentation::TransientSurface> measured_;
  bool transientAlone_ = false;
  bool ofSameOrgans_ = false;
  std::optional<std::vector<presentation::Part>> namedParts_;
  document::OrganId pointedOrgan_;
  std::optional<presentation::SurfaceMap> map_;
  Valves valves_;
  std::optional<scene::ValueRange> stressRange_;
  bool stressLegend_ = true;
  std::optional<presentation::ViewState> drawn_; ///< The view's state in what was drawn last.
  std::vector<Subscription> subscriptions_;
};

/// Translates a text of the presenter into the language of the window. For any thread.
std::string translated(const char* text);

} // namespace viscera::app
