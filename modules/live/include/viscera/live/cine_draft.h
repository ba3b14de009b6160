#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/live/cine_motion.h"
#include "viscera/medical_io/cine_study.h"

/// A request for a motion from images while a user puts it together.
namespace viscera::live {

/// What cine images say of their cycle before anything is labelled.
struct CineCycle {
  std::filesystem::path place;         ///< Where they were read from.
  std::size_t phases = 0;              ///< Of the cycle.
  std::optional<double> periodSeconds; ///< The median of the slices'; none where no file says it.
  /// The phase whose pictures differ most from those of the first, between a fifth and two thirds of the
  /// cycle: probably the end of systole. 0 where no picture can be read.
  std::size_t emptiest = 0;
};

/// Looks through a study. Decodes each picture once: about a second for 275 of them. Throws `Cancelled`.
CineCycle cycleOf(const medical_io::CineStudy& study, const std::filesystem::path& place, Progress& progress);

/// Files with labels and the phases that they show. Phases are guessed from names until a user says them: by
/// a number ("frame14", "LV_009"), counted from 1 where the names count so; by "ED" and "ES", which are the
/// first phase and the images' emptiest; of a file in a folder such as "es", by the folder's name. Values,
/// for one thread.
///
///     CineDraft draft;
///     draft.setCycle(cycleOf(study, "patient1", progress));
///     draft.add({"ed.nrrd", "es.nrrd"});
///     if (draft.missing().empty())
///       request = draft.request();
class CineDraft {
public:
  /// One file, or a folder of surfaces.
  struct Labels {
    std::filesystem::path file;
    std::optional<std::size_t> phase; ///< From 0; none: it is not stated.
    bool guessed = true;              ///< Not said by the user.
  };

  /// Sets the images; none: not chosen. Guesses again what the user has not said.
  void setCycle(std::optional<CineCycle> cycle);
  const std::optional<CineCycle>& cycle() const { return cycle_; }

  /// Adds files in the order of their names; one that is there stays as it is.
  void add(std::vector<std::filesystem::path> files);
  /// Throws `UsageError` for a row that is not there, as the next one.
  void remove(std::size_t row);
  /// None: it is not known any more.
  void setPhase(std::size_t row, std::optional<std::size_t> phase);
  void clearLabels() { labels_.clear(); }
  const std::vector<Labels>& labels() const { return labels_; }

  /// The phases that have labels, ascending.
  std::vector<std::size_t> labelled() const;
  /// Whether one phase only has labels: all numbers of the others would be estimates.
  bool isEstimate() const { return labelled().size() == 1; }

  /// What is missing, as a sentence that says what to do; empty when it is complete. Texts count phases from
  /// 1.
  Text missing() const;
  /// What to say of a draft that is complete: of one phase, that it is an estimate; of two or more without a
  /// phase near the images' emptiest, that it should be labelled; else empty.
  Text remark() const;

  /// Images, labels, and phases counted from 1 in texts; surfaces and the period are the caller's. Throws
  /// `UsageError` with what is `missing`.
  CineRequest request() const;

private:
  void guess();

  std::optional<CineCycle> cycle_;
  std::vector<Labels> labels_;
};

} // namespace viscera::live
