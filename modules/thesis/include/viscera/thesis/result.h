#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace viscera::thesis {

/// A claim of the thesis as a condition on measured numbers, and whether it is met.
struct Finding {
  std::string criterion; ///< "S-Celestial: no coordinate below 0"
  std::string measured;  ///< "least 0.0012"
  bool met = false;
};

enum class Judgement { holds, differs, doesNotHold, notMeasured };

/// The verdict on a claim of the thesis: it holds where all of its findings are met, differs where some are,
/// else it does not hold. It is computed from the findings.
struct Verdict {
  Judgement judgement = Judgement::notMeasured;
  std::string because; ///< The findings that are not met, with their numbers.

  /// "holds", "differs, because ...".
  std::string text() const;
};
Verdict verdictOf(const std::vector<Finding>& findings);
std::string nameOf(Judgement judgement);

/// A vector picture with its caption.
struct Picture {
  std::string name; ///< Of its file, without ending.
  std::string caption;
  std::string svg;
};

/// Numbers as a table: a CSV file, and on the page when `shown`.
struct Table {
  std::string name;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  bool shown = true;

  std::string csv() const;
};

/// A reproduced figure or table of the thesis.
struct Result {
  std::string id;     ///< "3.14"
  bool table = false; ///< A table, not a figure.
  std::string title;
  std::string claim; ///< The claim of the thesis, in our words.
  std::string setup; ///< What our figure shows, and how it was made.
  std::vector<Finding> findings;
  std::string problem; ///< Why it was not measured; else empty.
  std::vector<Picture> pictures;
  std::vector<Table> tables;
  double seconds = 0;

  Verdict verdict() const;
  std::string label() const { return (table ? "Table " : "Figure ") + id; }
  /// "figure_3_14", for files and links.
  std::string fileName() const;
};

/// Writes `index.html`, `verdicts.md`, the pictures (.svg) and the tables (.csv) into `folder`, which is made
/// when missing. Each file atomically. Throws `CannotCreateError`.
void writePage(const std::filesystem::path& folder, const std::vector<Result>& results);

} // namespace viscera::thesis
