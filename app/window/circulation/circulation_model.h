#pragma once

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>

#include "viscera/circulation/periodic_state.h"
#include "viscera/core/job_queue.h"
#include "viscera/core/phrase.h"
#include "viscera/heart/course_heartbeat.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/presentation/circulation_figure.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Solves the circulation that the document has chosen and makes the sample heart beat with it. Workers do
/// both. A running computation finishes and is shown before the next one starts with the newest choice, so
/// the view follows a moving control. While a control moves, the heart's beat is derived from the previous
/// choice's beat; as soon as the control rests, the beat is computed anew and checked at all instants. What
/// was solved is told once the heart beats with it, so that curves, numbers and the heart are of one
/// circulation however quickly choices follow each other. Where the document lets the textbook's beat move
/// the heart, the heart gets that back.
class CirculationModel final : public QObject {
  Q_OBJECT

public:
  using Shown = presentation::ShownCirculation;

  CirculationModel(Workspace& workspace, Playback& playback, QObject* parent = nullptr);

  /// Whether the document lets a circulation move the heart.
  bool on() const { return choice().drives; }
  const document::CirculationChoice& choice() const { return workspace_.document().circulation(); }
  /// The one with which the heart beats; without a heart that can follow, the last one that was solved. Null
  /// before the first, and while it is not `on`.
  const Shown* present() const { return present_ ? &present_->shown : nullptr; }
  /// Whether the beat that can be played is that of `present`, so that its instants are those of the curves.
  bool isPlayed() const;
  /// What was kept to compare with; null when nothing was.
  const Shown* kept() const { return kept_ ? &kept_->shown : nullptr; }
  /// The heart's beat of what was kept, for a second view; null without one, and while it is being made.
  std::shared_ptr<const sequences::Sequence> keptBeat() const {
    return kept_ && keptBeatBy_ == kept_ ? keptBeat_ : nullptr;
  }
  /// Why there is no beat that repeats itself, or why the heart cannot follow it; empty when all is well.
  const QString& failureReason() const { return failureReason_; }
  /// Whether there is a heart that can follow: the sample heart.
  bool hasHeart() const { return heartMotion().has_value(); }
  /// Whether nothing is being solved or calibrated.
  bool settled() const { return !solving_ && !following_ && !rests_.isActive(); }

Q_SIGNALS:
  /// The present circulation, the kept one or the failureReason has changed.
  void changed();

private:
  /// A circulation with the state at which the search for a similar one begins.
  struct Solved {
    Shown shown;
    circulation::State start{};
    Text failureReason; ///< Why no periodic beat was found.
  };
  using SolvedPointer = std::shared_ptr<const Solved>;
  struct Solutions {
    SolvedPointer present, kept; ///< Null: as before.
    /// The heart's beat under the present circulation, derived from the beat before; null where there was
    /// none.
    std::shared_ptr<const heart::CourseHeartbeat> similarBeat;
  };
  /// The heart that follows, and its beat.
  struct Followed {
    sample_organs::Resolution resolution{};
    std::shared_ptr<const live::CirculatingHeart> heart;
    std::shared_ptr<const heart::CourseHeartbeat> sequence; ///< Of what is present; null: as before.
    std::shared_ptr<const heart::CourseHeartbeat> keptBeat; ///< Of what was kept; null: as before.
  };

  /// The present beat of the heart and the circulation it belongs to, from which the next beat is derived.
  struct ShownBeat {
    std::shared_ptr<const heart::CourseHeartbeat> beat; ///< Null: none is shown.
    double fraction = 0;
    bool playing = false; ///< Other instants follow soon.

    std::shared_ptr<const heart::CourseHeartbeat> similar(const Shown& shown) const;
  };

  static SolvedPointer solved(Text name, const circulation::Parameters& parameters,
                              const SolvedPointer& nearby, Progress& progress);
  void scheduleSolve();
  void sync();
  void clear();
  bool solve();
  void take(const JobResult<Solutions>& result);
  ShownBeat shownBeat() const;
  bool showSimilar(const std::shared_ptr<const heart::CourseHeartbeat>& beat);
  bool followsOne(const Playback::Motion& motion) const;
  void give(const Playback::Motion& motion, std::shared_ptr<const heart::CourseHeartbeat> beat);
  void follow();
  /// What was to be followed, and with what the heart beat when that began.
  struct Following {
    SolvedPointer by, kept, before;
    document::OrganId organ;
  };
  void take(JobResult<Followed> result, const Following& asked);
  SolvedPointer wantedPresent() const;
  void syncPresent();
  void restoreTextbookBeat();
  std::optional<Playback::Motion> heartMotion() const;

  Workspace& workspace_;
  Playback& playback_;
  SolvedPointer solved_;  ///< Last, and what the heart is to follow.
  SolvedPointer present_; ///< What is told.
  SolvedPointer kept_;
  SolvedPointer refused_; ///< The choice tried last that has no periodic beat, or one that the heart cannot
                          ///< follow.
  QString failureReason_;
  Followed followed_;
  SolvedPointer followedBy_; ///< What `followed_` was made from.
  SolvedPointer beatBy_;     ///< The same of its sequence, which may be one that is similar.
  std::shared_ptr<const sequences::Sequence> keptBeat_;
  SolvedPointer keptBeatBy_;
  /// A heart that follows a circulation.
  struct Follower {
    std::shared_ptr<const sequences::Sequence> textbook; ///< The beat that it had before.
    std::shared_ptr<const sequences::Sequence> given;    ///< The beat that it was given last.
  };
  std::map<document::OrganId, Follower> followers_;
  bool solving_ = false;
  bool following_ = false;
  QTimer rests_;       ///< Runs while a derived beat is shown; when it ends, the exact beat is computed.
  bool asked_ = false; ///< `sync` is scheduled after the present notification.
  Subscription subscription_;
  JobQueue jobs_;
};

} // namespace viscera::app
