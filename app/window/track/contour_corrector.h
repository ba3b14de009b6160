#pragma once

#include <QObject>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/document/key_sequence.h"
#include "viscera/live/cine_motion.h"
#include "viscera/medical_io/cine_study.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Corrects contours of a motion that was found in images: fits it anew on a worker, so that it meets them,
/// and replaces the keys that change and the document's list of corrections in one undo step. The first
/// correction of a motion follows its images again, which takes as long as finding it; those that follow take
/// a second.
class ContourCorrector final : public QObject {
  Q_OBJECT

public:
  /// How the motion of the document was found.
  struct Origin {
    live::CineRequest request;
    live::TrackOptions options;
    std::vector<std::size_t> labelled; ///< Phases, ascending.
    /// The document's organs that it moves, and their surfaces in the request.
    std::vector<std::pair<document::OrganId, std::string>> surfaces;
  };
  /// Returns the origin of the document's motion; none for a motion without images.
  using Source = std::function<std::optional<Origin>()>;

  explicit ContourCorrector(Workspace& workspace, QObject* parent = nullptr);
  ~ContourCorrector() override;

  void setSource(Source source) { source_ = std::move(source); }
  /// Whether the document has a motion from the images of its study.
  bool available() const;
  /// Why no contour of that phase (from 0) of an organ can be corrected; empty when it can.
  QString refusal(std::size_t phase, document::OrganId organ) const;
  /// The surface of the motion that an organ is; empty for another organ.
  std::string surfaceOf(document::OrganId organ) const;
  /// The phase of the motion nearest to a part of the cycle, and its own part.
  std::pair<std::size_t, double> phaseAt(double fraction) const;
  bool working() const { return working_; }

  /// Fits the motion to one more contour. `covered` has points of the contour as it was where this one takes
  /// its place. `ended` follows.
  void correct(const live::ContourCorrection& correction, const Points& covered);
  /// Fits it without one of the document's corrections.
  void remove(std::size_t index);
  void cancel();

Q_SIGNALS:
  /// The fit has ended, with or without a change of the document.
  void ended();
  /// The document's key sequence is this motion: after a correction, and after undo or redo of one.
  void corrected(const std::shared_ptr<const viscera::live::CineMotion>& motion);

private:
  struct Fitted;

  void fit(std::vector<live::ContourCorrection> corrections);
  void take(const Fitted& fitted);
  void tell(const live::CineMotion& motion, std::size_t changed);
  void know(const std::vector<document::CorrectedContour>& corrections,
            std::shared_ptr<const live::CineMotion> motion);
  std::vector<live::ContourCorrection> present() const;

  Workspace& workspace_;
  Source source_;
  std::shared_ptr<const live::CineTracker> tracker_;
  std::shared_ptr<const medical_io::CineStudy> tracked_; ///< The images that it followed.
  live::CineRequest request_;                            ///< Its own.
  /// The motions of the latest corrections, for undo.
  std::vector<std::pair<std::vector<document::CorrectedContour>, std::shared_ptr<const live::CineMotion>>>
      known_;
  int fits_ = 0;
  bool working_ = false;
  Subscription subscription_;
};

} // namespace viscera::app
