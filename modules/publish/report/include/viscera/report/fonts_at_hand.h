#pragma once

#include <memory>

namespace viscera::report {

/// Fonts for text that Qt draws in a program without a window: where no `QGuiApplication` runs, one without a
/// display lives as long as the object. Numbers keep their decimal point. For the main thread, one at a time;
/// what draws with Qt lives shorter.
class FontsAtHand {
public:
  /// Throws `Error` when no font is found.
  FontsAtHand();
  ~FontsAtHand();
  FontsAtHand(const FontsAtHand&) = delete;
  FontsAtHand& operator=(const FontsAtHand&) = delete;

private:
  struct Application;
  std::unique_ptr<Application> own_; ///< Null where the program has one.
};

} // namespace viscera::report
