#pragma once

#include <memory>
#include <vector>

#include "viscera/document/import_draft.h"
#include "viscera/scene/organ_actor.h"

namespace viscera::app {

class Picture;

/// Shows a draft's organs as glass in the view, beside what the document holds.
class ImportPreview {
public:
  explicit ImportPreview(Picture& picture) : picture_(picture) {}
  ~ImportPreview();
  ImportPreview(const ImportPreview&) = delete;
  ImportPreview& operator=(const ImportPreview&) = delete;

  /// Replaces what was shown, and brings it into the picture when it lies elsewhere or is of another size.
  void show(const document::ImportDraft& draft);
  void clear();

private:
  Picture& picture_;
  Bounds shown_;
};

} // namespace viscera::app
