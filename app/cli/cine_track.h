#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/live/cine_motion.h"

/// The part of `viscera track` that finds a motion from images and the labels of a few phases.
namespace viscera::app::cli {

class Listing;

/// The options for images and labelled phases.
class CineTrackOptions {
public:
  void add(CLI::App& options);

  bool given() const { return !images_.empty(); }
  /// What is asked for, without surfaces and period. Throws `UsageError`, and what reading corrections
  /// throws.
  live::CineRequest request() const;
  /// Throws `UsageError` where labels are given without images.
  void requireImages() const;

private:
  std::string images_;
  std::vector<std::string> phases_;
  std::vector<int> leftOutSeries_;
  std::vector<std::string> corrections_;
};

/// Adds to what `viscera track` says of a motion which phases are labelled, what each plane contributed and
/// what is to be known about it.
void addCineReport(const live::CineMotion& found, Outcome& outcome);

/// The same as lines.
void addCineLines(const live::CineMotion& found, Listing& listing);

} // namespace viscera::app::cli
