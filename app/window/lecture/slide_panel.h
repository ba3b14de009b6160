#pragma once

#include <QWidget>

#include "window/lecture/slides.h"

class QListWidget;

namespace viscera::app {

/// A panel with the list of slides: a click shows one, a double click changes its caption, dragging changes
/// the order.
class SlidePanel final : public QWidget {
  Q_OBJECT

public:
  SlidePanel(Slides& slides, const Actions& actions, QWidget* parent = nullptr);

private:
  void fill();

  Slides& slides_;
  QListWidget* list_;
  bool filling_ = false;
};

} // namespace viscera::app
