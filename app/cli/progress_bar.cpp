#include "cli/progress_bar.h"

#include <cmath>
#include <ostream>

namespace viscera::app::cli {
namespace {
constexpr int kWidth = 30;
constexpr auto kClearLine = "\r\x1b[K";
} // namespace

ProgressBar::ProgressBar(std::ostream& stream, bool terminal) : stream_(stream), terminal_(terminal) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::show(double fraction, const std::string& step) {
  if (!terminal_)
    return;
  const int full = static_cast<int>(std::lround(fraction * kWidth));
  stream_ << kClearLine << '[' << std::string(full, '#') << std::string(kWidth - full, '.') << "] "
          << static_cast<int>(std::floor(fraction * 100)) << " % " << step << std::flush;
  shown_ = true;
}

void ProgressBar::clear() {
  if (shown_)
    stream_ << kClearLine << std::flush;
  shown_ = false;
}

} // namespace viscera::app::cli
