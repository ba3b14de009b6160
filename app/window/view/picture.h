#pragma once

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/presentation/presenter.h"
#include "window/view/heart_opener.h"
#include "window/view/view_model.h"
#include "window/view/view_widget.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// A view of the window together with the presenter that draws the document in it. Every change of the
/// document, its organs, the selection, the stress or the view's state only marks the picture as out of date.
/// It is brought up to date once for all of them: before the next frame, or when something reads it. A reader
/// therefore never meets an outdated presenter or view, and an event of the mouse costs one update. The
/// objects that handle the mouse get a reference to the picture; drawing does not need them.
class Picture final : public QObject {
  Q_OBJECT

public:
  /// The role of a view: the one in which the user works, or a second one for comparison.
  enum class Role { working, showing };

  /// All have to live longer.
  Picture(Workspace& workspace, ViewModel& model, ViewWidget& view, Role role = Role::working,
          QObject* parent = nullptr);

  ~Picture() override;

  /// The presenter and its view, up to date.
  const presentation::Presenter& presenter() const;
  scene::OrganView& view() const { return presenter().view(); }
  document::OrganId organOf(const scene::OrganActor* actor) const { return presenter().organOf(actor); }
  std::shared_ptr<scene::OrganActor> actorOf(document::OrganId organ) const {
    return presenter().actorOf(organ);
  }
  /// The view's state as it is drawn, with the selection.
  presentation::ViewState state() const;

  /// Sets the measurement under way.
  void setMeasuring(presentation::PendingMeasurement measuring);
  /// Sets organs that are in no document yet. `alone`: hides the document's organs, which they will replace.
  void setTransientSurfaces(std::vector<presentation::TransientSurface> transient, bool alone = false);
  /// Sets measured surfaces to show beside the organs that move through them.
  void setMeasured(std::vector<presentation::TransientSurface> surfaces);
  /// Says of a second view whether its document holds the first view's organs, whose ids the view's state
  /// uses; a slide then applies to both views.
  void setOfSameOrgans(bool same);
  /// Shows numbers on the organs instead of the map chosen in the view's state; empty: shows that map.
  void setMap(std::optional<presentation::SurfaceMap> map);
  /// Shows the segments of a heart's wall on the organs where no other map is set; empty: none.
  void setSegments(std::optional<presentation::SurfaceMap> segments);
  /// Sets a range of the stress map's colours that is shared with another picture, and whether this one shows
  /// the legend; empty: a range of its own.
  void setStressRange(std::optional<scene::ValueRange> range, bool legend = true);
  std::optional<scene::ValueRange> stressRange() const { return stressRange_; }
  bool stressLegend() const { return stressLegend_; }
  /// A function that returns the valves of the beating heart, called whenever the picture is brought up to
  /// date.
  using Valves = std::function<std::optional<heart::ValveInstants>()>;
  void setValves(Valves valves);
  /// The same for the instant of its beat.
  using Clock = std::function<std::optional<heart::BeatClock>()>;
  void setClock(Clock clock);
  /// The tissue of the sample heart as far as a cut has asked for it; may be null.
  const std::shared_ptr<const live::HeartTissue>& heartTissue() const { return opener_.tissue(); }
  /// Whether the picture has parts that a movie of the view leaves out: distances, measured surfaces, warped
  /// slices.
  bool hasMoreThanMovies() const;
  /// Sets the organ under the mouse, whose handles are highlighted; none: no handles are.
  void setPointedOrgan(document::OrganId organ);
  /// Shows the labels of these parts only; empty: those chosen in the view's state.
  void setNamedParts(std::optional<std::vector<presentation::Part>> parts);

public Q_SLOTS:
  /// Marks the picture as out of date and schedules its rendering.
  void markOutdated();

Q_SIGNALS:
  /// The picture was brought up to date after changes: once for each frame, before it is rendered, unless
  /// something has read the picture in between. The presenter and its view may be read.
  void changed() const;

private:
  void bringUpToDate() const;
  void update() const;
  bool differsFromDocument() const;
  bool segmentsFit() const;

  Workspace& workspace_;
  ViewModel& model_;
  ViewWidget& widget_;
  Role role_;
  HeartOpener opener_;
  mutable presentation::Presenter presenter_; ///< Follows the document when it is read.
  mutable bool outdated_ = true;
  presentation::PendingMeasurement measuring_;
  std::vector<presentation::TransientSurface> transient_;
  std::vector<presentation::TransientSurface> measured_;
  bool transientAlone_ = false;
  bool ofSameOrgans_ = false;
  std::optional<std::vector<presentation::Part>> namedParts_;
  document::OrganId pointedOrgan_;
  std::optional<presentation::SurfaceMap> map_, segments_;
  Valves valves_;
  Clock clock_;
  std::optional<scene::ValueRange> stressRange_;
  bool stressLegend_ = true;
  mutable std::optional<presentation::ViewState> drawn_; ///< The view's state in the last picture.
  std::vector<Subscription> subscriptions_;
};

/// Translates a text of the presenter into the language of the window. For any thread.
std::string translated(const char* text);

} // namespace viscera::app
