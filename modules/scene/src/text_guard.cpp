// The overloads for vtkUnicodeString are deprecated, but VTK's own charts call them.
#define VTK_DEPRECATION_LEVEL 0

#include "text_guard.h"

#include <vtkMathTextFreeTypeTextRenderer.h>
#include <vtkObjectFactory.h>
#include <vtkUnicodeString.h>

namespace viscera::scene {
namespace {

/// One for the program, as what it guards. Recursive: a chart holds it and asks the renderer.
std::recursive_mutex& textMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// The renderer that VTK would have made itself, for one thread at a time.
class GuardedTextRenderer : public vtkMathTextFreeTypeTextRenderer {
public:
  static GuardedTextRenderer* New();
  vtkTypeMacro(GuardedTextRenderer, vtkMathTextFreeTypeTextRenderer)

      static void install() {
    GetInstance()->Register(nullptr); // For good: text actors that were made before keep on asking that one.
    GuardedTextRenderer* renderer = New();
    SetInstance(renderer);
    renderer->Delete(); // VTK holds it.
  }

protected:
  bool GetBoundingBoxInternal(vtkTextProperty* style, const vtkStdString& text, int box[4], int dpi,
                              int backend) override {
    const TextGuard guard;
    return Superclass::GetBoundingBoxInternal(style, text, box, dpi, backend);
  }
  bool GetBoundingBoxInternal(vtkTextProperty* style, const vtkUnicodeString& text, int box[4], int dpi,
                              int backend) override {
    const TextGuard guard;
    return Superclass::GetBoundingBoxInternal(style, text, box, dpi, backend);
  }
  bool GetMetricsInternal(vtkTextProperty* style, const vtkStdString& text, Metrics& metrics, int dpi,
                          int backend) override {
    const TextGuard guard;
    return Superclass::GetMetricsInternal(style, text, metrics, dpi, backend);
  }
  bool GetMetricsInternal(vtkTextProperty* style, const vtkUnicodeString& text, Metrics& metrics, int dpi,
                          int backend) override {
    const TextGuard guard;
    return Superclass::GetMetricsInternal(style, text, metrics, dpi, backend);
  }
  bool RenderStringInternal(vtkTextProperty* style, const vtkStdString& text, vtkImageData* picture,
                            int size[2], int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::RenderStringInternal(style, text, picture, size, dpi, backend);
  }
  bool RenderStringInternal(vtkTextProperty* style, const vtkUnicodeString& text, vtkImageData* picture,
                            int size[2], int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::RenderStringInternal(style, text, picture, size, dpi, backend);
  }
  int GetConstrainedFontSizeInternal(const vtkStdString& text, vtkTextProperty* style, int width, int height,
                                     int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::GetConstrainedFontSizeInternal(text, style, width, height, dpi, backend);
  }
  int GetConstrainedFontSizeInternal(const vtkUnicodeString& text, vtkTextProperty* style, int width,
                                     int height, int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::GetConstrainedFontSizeInternal(text, style, width, height, dpi, backend);
  }
  bool StringToPathInternal(vtkTextProperty* style, const vtkStdString& text, vtkPath* path, int dpi,
                            int backend) override {
    const TextGuard guard;
    return Superclass::StringToPathInternal(style, text, path, dpi, backend);
  }
  bool StringToPathInternal(vtkTextProperty* style, const vtkUnicodeString& text, vtkPath* path, int dpi,
                            int backend) override {
    const TextGuard guard;
    return Superclass::StringToPathInternal(style, text, path, dpi, backend);
  }
  void SetScaleToPowerOfTwoInternal(bool scale) override {
    const TextGuard guard;
    Superclass::SetScaleToPowerOfTwoInternal(scale);
  }
};
vtkStandardNewMacro(GuardedTextRenderer)

} // namespace

void guardText() {
  static std::once_flag once;
  std::call_once(once, [] { GuardedTextRenderer::install(); });
}

TextGuard::TextGuard() : lock_(textMutex()) {}

vtkStandardNewMacro(ChartActor);

int ChartActor::RenderOverlay(vtkViewport* viewport) {
  const TextGuard guard;
  return Superclass::RenderOverlay(viewport);
}

} // namespace viscera::scene
