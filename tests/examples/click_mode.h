#pragma once

#include "window/modes/mode.h"

class QLabel;

namespace viscera::app {

/// Says where an organ was clicked, as a worked example of docs/developer_guide.md.
class ClickMode final : public Mode {
  Q_OBJECT

public:
  explicit ClickMode(const ModeParts& parts);

  QWidget* makePage(const Actions& actions) override;
  presentation::Shown shown() const override { return {}; }
  live::WantedPose pose() const override { return live::WantedPose::document; }
  UsefulPanels panels() const override { return {}; }
  void click(const ClickedPlace* place) override;

private:
  QLabel* said_ = nullptr; ///< On the page; null before it is made.
};

} // namespace viscera::app
