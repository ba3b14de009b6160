#pragma once

#include <iosfwd>
#include <string>

namespace viscera::app::cli {

/// One line that shows how far a command is, drawn again and again; nothing at all where nobody watches. For
/// one thread at a time, as `Progress` calls its listener.
class ProgressBar {
public:
  /// Draws on `stream` when `terminal` says that somebody watches it.
  ProgressBar(std::ostream& stream, bool terminal);
  /// Removes the line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` in [0, 1] of `step`.
  void show(double fraction, const std::string& step);
  /// Removes the line, so that something else can be said.
  void clear();

private:
  std::ostream& stream_;
  bool terminal_;
  bool shown_ = false;
};

} // namespace viscera::app::cli
