#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/live/heart_tissue.h"
#include "viscera/live/live_stress.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/posed_organs.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sequences/sequence.h"

namespace viscera::report {

/// The document, view and motion that a report is made from.
struct ReportSource {
  document::DocumentState state = {};
  presentation::ViewState view = {};
  /// The organs in their present pose. The report poses them over a cycle, and then restores that pose. Lives
  /// longer.
  live::PosedOrgans* organs = nullptr;
  const coordinates::Registry* systems = nullptr; ///< Never null; lives longer.

  live::StressCopy* stress = nullptr; ///< The stress map to report; null: there is none. Lives longer.
  live::StressStatus stressStatus = {};

  /// How measured places of the scan move where the view shows it warped; empty: they do not.
  document::TissueMotion tissue = {};
  /// The tissue of the sample heart where the view cuts it open (`presentation::heartTissueFor`); may be
  /// null.
  std::shared_ptr<const live::HeartTissue> heartTissue = {};

  std::shared_ptr<const sequences::Sequence> sequence = {}; ///< Null: the organs are still.
  double ratePerMinute = 0;                                 ///< 0: the sequence's own.
  std::optional<live::PrescribedVolume> prescribed = {};    ///< As the window plays it.

  std::string title = {}; ///< Empty: the first organ's name.
  std::string file = {};  ///< Of the session or organs; the report shows its name, never its folder. May be
                          ///< empty.
  std::vector<Text> notes = {}; ///< Warnings from opening the files, a sentence each.
  std::string date = {};        ///< As it is to be read; empty: today's.
};

/// A picture of a report with its caption.
struct Picture {
  std::string png; ///< The bytes of a PNG file.
  std::string caption;
};

/// A paragraph of text.
struct Paragraph {
  std::string text;
};

/// A table of a report; every row has as many texts as `numbers`.
struct Table {
  std::vector<std::string> head; ///< Empty: none.
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> numbers;       ///< A column of numbers is aligned to the right.
  std::vector<Vec3> swatches = {}; ///< A colour before the first text of each row; may be empty.
};

/// A grid of pictures, in rows, all as wide as fits.
struct PictureGrid {
  std::vector<Picture> pictures;
  int columns = 1;
  double widthToHeight = 1;
};

using Block = std::variant<Paragraph, Table, PictureGrid>;

struct Section {
  std::string title; ///< Empty for the first.
  std::vector<Block> blocks;
};

/// The contents of a report, before they are laid out on pages. All texts are plain UTF-8.
struct Report {
  std::string title;
  std::string made; ///< "Made by Viscera 1.0 on ..."
  std::vector<Section> sections;

  int pictures() const;
};

/// Makes a report: measures and draws all its contents: pictures from six sides and of the view, volumes,
/// measurements, stress, the sequence over a whole cycle with curves, and the repairs of files. Folders of
/// files are not included. Needs no display. Throws `UsageError` when there are no organs, `Error` when no
/// OpenGL context can be created, what posing throws, and `Cancelled`. About a second for the pictures of
/// 100,000 vertices. For the thread of the organs, which may be any.
///
///     const ReportSource source{document.state(), viewState, &live, &registry};
///     const Report report = makeReport(source, {}, progress);
///     writeReport("liver.pdf", report);
Report makeReport(const ReportSource& source, Threads threads, Progress& progress);

} // namespace viscera::report
