#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/motion_series.h"

namespace viscera::live {

/// The role of a label or surface in a motion: cavity, tissue or unused.
enum class SeriesPart {
  cavity, ///< A surface that is within the others.
  tissue, ///< A part of the outer surface; of files of surfaces: used as it is.
  unused
};

/// A label or surface of a series, with its role.
struct SeriesItem {
  std::string name;                     ///< "LV", "heart_myocardium"
  std::string label;                    ///< Its name in a request: the label's value; empty for surfaces.
  SeriesPart part = SeriesPart::unused; ///< Its probable role, by its name or its box.
};

/// The labels or surfaces that a series holds, before the user chooses among them.
struct SeriesContents {
  bool labels = false;    ///< Label maps, else surfaces.
  std::size_t phases = 0; ///< The number of phases for which there are files or volumes.
  std::vector<SeriesItem> items;
  std::optional<double> periodSeconds; ///< As stated in the files.
  Text doubt;                          ///< An assumption about their times, as a sentence; or empty.
};

/// Reads which labels or surfaces the files of a series hold: names of surfaces, or labels of the first
/// phase, with a proposal for cavities and tissue. Labels of a heart are recognised by their names; else the
/// label with the largest box is tissue, the others are cavities. Reads the first label map, or the whole of
/// a file of several. Throws what `readMotionSeries` throws of files, `Cancelled`.
SeriesContents lookIntoSeries(const std::vector<std::filesystem::path>& inputs, Progress& progress);

/// The same of the labels of one phase, as `CineRequest` has them: one label map, or surfaces. Throws what
/// `joinStudy` throws of files, `Cancelled`.
SeriesContents lookIntoPhase(const PhaseLabels& labels, Progress& progress);

/// The surfaces of a request from the items: one for each cavity; of label maps with tissue, or with several
/// cavities, also an outer surface `outerName` of all labels that are used. Throws `UsageError` when nothing
/// is used.
std::vector<LabelledSurface> chosenSurfaces(const SeriesContents& contents, const std::string& outerName);

} // namespace viscera::live
