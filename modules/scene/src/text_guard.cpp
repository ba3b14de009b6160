// The overloads for vtkUnicodeString are deprecated, but VTK's own charts call them.
#define VTK_DEPRECATION_LEVEL 0

#include "text_guard.h"

#include <fontconfig/fontconfig.h>

#include <array>
#include <memory>
#include <string>

#include <vtkMathTextFreeTypeTextRenderer.h>
#include <vtkObjectFactory.h>
#include <vtkTextProperty.h>
#if __has_include(<vtkUnicodeString.h>) // VTK 9.2 is the last that has it.
#include <vtkUnicodeString.h>
#define VISCERA_VTK_HAS_UNICODE_STRING
#endif

#include "viscera/scene/text_font.h"

namespace viscera::scene {
namespace {

/// One for the program, as what it guards. Recursive: a chart holds it and asks the renderer.
std::recursive_mutex& textMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// The file of a family's upright face, or of the nearest that this system has; empty when it has no file
/// that VTK can open, which takes the first face of a file.
std::string fontFile(const std::string& family, int weight) {
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(FcPatternCreate(), FcPatternDestroy);
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight);
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result{};
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> found(FcFontMatch(nullptr, wanted.get(), &result),
                                                               FcPatternDestroy);
  FcChar8* file = nullptr;
  int face = 0;
  if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch ||
      (FcPatternGetInteger(found.get(), FC_INDEX, 0, &face) == FcResultMatch && face != 0))
    return {};
  return reinterpret_cast<const char*>(file);
}

/// The renderer that VTK would have made itself, for one thread at a time, in one font of this system instead
/// of the families that VTK provides.
class GuardedTextRenderer : public vtkMathTextFreeTypeTextRenderer {
public:
  static GuardedTextRenderer* New();
  vtkTypeMacro(GuardedTextRenderer, vtkMathTextFreeTypeTextRenderer)

      static void install() {
    GetInstance()->Register(nullptr); // For good: text actors that were made before keep on asking that one.
    GuardedTextRenderer* renderer = New();
    renderer->setFamily(kDefaultFontFamily);
    SetInstance(renderer);
    renderer->Delete(); // VTK holds it.
  }

  /// Writes in this family from now on.
  void setFamily(const std::string& family) {
    files_ = {fontFile(family, FC_WEIGHT_REGULAR), fontFile(family, FC_WEIGHT_BOLD)};
  }

  /// The file of regular, of bold letters; empty: VTK's own font is used.
  const std::string& file(bool bold) const { return files_[bold]; }

protected:
  bool GetBoundingBoxInternal(vtkTextProperty* style, const vtkStdString& text, int box[4], int dpi,
                              int backend) override {
    const TextGuard guard;
    return Superclass::GetBoundingBoxInternal(inOurFont(style), text, box, dpi, backend);
  }
  bool GetMetricsInternal(vtkTextProperty* style, const vtkStdString& text, Metrics& metrics, int dpi,
                          int backend) override {
    const TextGuard guard;
    return Superclass::GetMetricsInternal(inOurFont(style), text, metrics, dpi, backend);
  }
  bool RenderStringInternal(vtkTextProperty* style, const vtkStdString& text, vtkImageData* picture,
                            int size[2], int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::RenderStringInternal(inOurFont(style), text, picture, size, dpi, backend);
  }
  int GetConstrainedFontSizeInternal(const vtkStdString& text, vtkTextProperty* style, int width, int height,
                                     int dpi, int backend) override {
    const TextGuard guard;
    const vtkSmartPointer<vtkTextProperty> ours = inOurFont(style);
    const int size = Superclass::GetConstrainedFontSizeInternal(text, ours, width, height, dpi, backend);
    style->SetFontSize(ours->GetFontSize()); // The size found is part of the answer.
    return size;
  }
  bool StringToPathInternal(vtkTextProperty* style, const vtkStdString& text, vtkPath* path, int dpi,
                            int backend) override {
    const TextGuard guard;
    return Superclass::StringToPathInternal(inOurFont(style), text, path, dpi, backend);
  }
#ifdef VISCERA_VTK_HAS_UNICODE_STRING
  bool GetBoundingBoxInternal(vtkTextProperty* style, const vtkUnicodeString& text, int box[4], int dpi,
                              int backend) override {
    const TextGuard guard;
    return Superclass::GetBoundingBoxInternal(inOurFont(style), text, box, dpi, backend);
  }
  bool GetMetricsInternal(vtkTextProperty* style, const vtkUnicodeString& text, Metrics& metrics, int dpi,
                          int backend) override {
    const TextGuard guard;
    return Superclass::GetMetricsInternal(inOurFont(style), text, metrics, dpi, backend);
  }
  bool RenderStringInternal(vtkTextProperty* style, const vtkUnicodeString& text, vtkImageData* picture,
                            int size[2], int dpi, int backend) override {
    const TextGuard guard;
    return Superclass::RenderStringInternal(inOurFont(style), text, picture, size, dpi, backend);
  }
  int GetConstrainedFontSizeInternal(const vtkUnicodeString& text, vtkTextProperty* style, int width,
                                     int height, int dpi, int backend) override {
    const TextGuard guard;
    const vtkSmartPointer<vtkTextProperty> ours = inOurFont(style);
    const int size = Superclass::GetConstrainedFontSizeInternal(text, ours, width, height, dpi, backend);
    style->SetFontSize(ours->GetFontSize()); // The size found is part of the answer.
    return size;
  }
  bool StringToPathInternal(vtkTextProperty* style, const vtkUnicodeString& text, vtkPath* path, int dpi,
                            int backend) override {
    const TextGuard guard;
    return Superclass::StringToPathInternal(inOurFont(style), text, path, dpi, backend);
  }
#endif
  void SetScaleToPowerOfTwoInternal(bool scale) override {
    const TextGuard guard;
    Superclass::SetScaleToPowerOfTwoInternal(scale);
  }

private:
  /// A copy: VTK remembers fonts by their style, while the owner of `style` may change it.
  vtkSmartPointer<vtkTextProperty> inOurFont(vtkTextProperty* style) const {
    const std::string& font = file(style->GetBold() != 0);
    if (font.empty() || style->GetFontFamily() == VTK_FONT_FILE)
      return style;
    auto ours = vtkSmartPointer<vtkTextProperty>::New();
    ours->ShallowCopy(style);
    ours->SetFontFamily(VTK_FONT_FILE);
    ours->SetFontFile(font.c_str());
    ours->BoldOff(); // The file has the weight.
    return ours;
  }

  std::array<std::string, 2> files_; ///< Regular, bold.
};
vtkStandardNewMacro(GuardedTextRenderer)

} // namespace

void guardText() {
  static std::once_flag once;
  std::call_once(once, [] { GuardedTextRenderer::install(); });
}

void setTextFont(const std::string& family) {
  guardText();
  const TextGuard guard;
  if (auto* renderer = GuardedTextRenderer::SafeDownCast(vtkTextRenderer::GetInstance()))
    renderer->setFamily(family);
}

std::string textFontFile() {
  guardText();
  const TextGuard guard;
  auto* renderer = GuardedTextRenderer::SafeDownCast(vtkTextRenderer::GetInstance());
  return renderer ? renderer->file(false) : std::string();
}

TextGuard::TextGuard() : lock_(textMutex()) {}

vtkStandardNewMacro(ChartActor);

int ChartActor::RenderOverlay(vtkViewport* viewport) {
  const TextGuard guard;
  return Superclass::RenderOverlay(viewport);
}

} // namespace viscera::scene
