#include "viscera/scene/slice_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <vtkActor2D.h>
#include <vtkCellData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTexturedActor2D.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWeakPointer.h>

#include "flat_shape.h"
#include "grey_square.h"
#include "text_guard.h"
#include "viscera/scene/legend.h"
#include "viscera/scene/organ_view.h"

namespace viscera::scene {
namespace {

constexpr int kSliceViewSamples = 4;
constexpr double kWide = 1.5;      ///< Logical pixels.
constexpr double kThin = 0.75;     ///< Logical pixels.
constexpr double kWordsMargin = 8; ///< Of texts from the edges, logical pixels.
constexpr double kCrossGap = 9;    ///< Of the crosshair around its middle, logical pixels.
constexpr double kCrossOpacity = 0.75;
constexpr double kTextSize = 12; ///< Logical pixels.
constexpr double kLetterSize = 16;
constexpr double kSliceScaleTick = 4;
constexpr double kWordsGround = 0.6; ///< Opacity of the ground behind them: bones are as light as they are.
constexpr double kWordsGap = 8;      ///< Between a place and the words beside it, logical pixels.
/// The scale bar is at most this part of the picture's width.
constexpr double kLongestBar = 0.25;
constexpr double kText[] = {0.90, 0.91, 0.92};

/// Lines with a colour each, of one width.
class ColoredLines {
public:
  ColoredLines() {
    colors_->SetNumberOfComponents(3);
    shape_.data->SetLines(cells_);
    shape_.data->GetCellData()->SetScalars(colors_);
  }

  vtkActor2D* actor() { return shape_.actor; }

  void begin() {
    shape_.begin();
    cells_->Reset();
    colors_->Reset();
  }
  void add(const SliceLine& line) {
    if (line.points.size() < 2)
      return;
    cells_->InsertNextCell(static_cast<int>(line.points.size()) + (line.closed ? 1 : 0));
    vtkIdType first = -1;
    for (const Eigen::Vector2d& point : line.points) {
      const vtkIdType id = shape_.add(point.x() + 0.5, point.y() + 0.5);
      first = first < 0 ? id : first;
      cells_->InsertCellPoint(id);
    }
    if (line.closed)
      cells_->InsertCellPoint(first);
    const Vec3 color = 255 * line.color;
    colors_->InsertNextTuple3(color.x(), color.y(), color.z());
  }
  void end() {
    cells_->Modified();
    colors_->Modified();
    shape_.end();
  }

private:
  FlatShape shape_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

/// Discs with a rim and a colour each.
class ColoredDiscs {
public:
  ColoredDiscs() {
    colors_->SetNumberOfComponents(3);
    shape_.data->SetPolys(cells_);
    shape_.data->GetCellData()->SetScalars(colors_);
  }

  vtkActor2D* actor() { return shape_.actor; }

  void show(const std::vector<SliceMark>& marks, double ratio) {
    shape_.begin();
    cells_->Reset();
    colors_->Reset();
    for (const SliceMark& mark : marks) {
      add(mark, ratio * (mark.radius + mark.rimWidth), mark.rim);
      add(mark, ratio * mark.radius, mark.color);
    }
    cells_->Modified();
    colors_->Modified();
    shape_.end();
  }

private:
  void add(const SliceMark& mark, double radius, const Vec3& color) {
    constexpr int kCorners = 24;
    shape_.addDisc(mark.place.x() + 0.5, mark.place.y() + 0.5, radius, kCorners, cells_);
    colors_->InsertNextTuple3(255 * color.x(), 255 * color.y(), 255 * color.z());
  }

  FlatShape shape_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

/// Grey levels, pixel on pixel.
class GreyLevels {
public:
  GreyLevels() {
    square_.texture()->InterpolateOff();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(square_.data());
    actor_->SetMapper(mapper);
    actor_->SetTexture(square_.texture());
    actor_->VisibilityOff(); // Until there are grey levels.
  }

  vtkActor2D* actor() { return actor_; }

  void show(const SlicePicture& picture) {
    actor_->SetVisibility(!picture.grey.empty());
    if (picture.grey.empty())
      return;
    const double w = picture.width, h = picture.height;
    square_.setCorners({Vec3(0, 0, 0), Vec3(w, 0, 0), Vec3(w, h, 0), Vec3(0, h, 0)});
    square_.setGrey(picture.width, picture.height, picture.grey);
  }

private:
  GreySquare square_;
  vtkNew<vtkTexturedActor2D> actor_;
};

/// The largest of 1, 2, 5 times a power of ten that is at most `limit`.
double roundBelow(double limit) {
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit)
      return factor * power;
  return power;
}

/// Where words of this size stand: right of what is measured, left of it, below or above, the first that is
/// in the picture and covers neither it nor other words; else as near to the first as the picture allows.
Eigen::AlignedBox2d placed(const SliceText& text, const Eigen::Vector2d& size, double gap,
                           const Eigen::AlignedBox2d& picture,
                           const std::vector<Eigen::AlignedBox2d>& others) {
  Eigen::AlignedBox2d around = text.around;
  around.extend(text.place);
  const Eigen::Vector2d middle = around.center();
  const auto at = [&](double left, double low) {
    const Eigen::Vector2d corner(left, low);
    return Eigen::AlignedBox2d(corner, corner + size);
  };
  // Near an edge words move along what they stand beside, to stay in the picture.
  const Eigen::Vector2d most = (picture.max() - size).cwiseMax(picture.min());
  const double besides = std::clamp(text.place.y() - 0.5 * size.y(), picture.min().y(), most.y());
  const double centred = std::clamp(middle.x() - 0.5 * size.x(), picture.min().x(), most.x());
  const std::array<Eigen::AlignedBox2d, 4> places = {
      at(around.max().x() + gap, besides), at(around.min().x() - gap - size.x(), besides),
      at(centred, around.min().y() - gap - size.y()), at(centred, around.max().y() + gap)};
  for (const Eigen::AlignedBox2d& place : places)
    if (picture.contains(place) && std::none_of(others.begin(), others.end(),
                                                [&](const auto& other) { return other.intersects(place); }))
      return place;
  const Eigen::Vector2d low = places[0].min().cwiseMin(picture.max() - size).cwiseMax(picture.min());
  return {low, low + size};
}

} // namespace

struct SliceView::Parts {
  Parts();

  char decimalMark = '.';
  Theme theme = darkTheme();
  /// Grey levels on a layer of their own: flat things of one layer hide each other by a depth that all share.
  vtkNew<vtkRenderer> ground;
  vtkNew<vtkRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  GreyLevels levels;
  ColoredLines thin, wide;
  ColoredDiscs discs;
  std::vector<vtkSmartPointer<vtkTextActor>> captions; ///< One a text of the picture.
  FlatShape cross, bar;
  vtkNew<vtkCellArray> crossLines, barLines;
  std::array<vtkSmartPointer<vtkTextActor>, 4> letters;
  vtkSmartPointer<vtkTextActor> title, note, length;

  double ratio() const { return pixelRatioOf(window); }
  void place(vtkTextActor* text, const std::string& words, double x, double y, double size);
  void keepApart(vtkTextActor* words, double y, double towardsMiddle, vtkTextActor* letter, double width);
  void showCross(const SlicePicture& picture);
  void showBar(const SlicePicture& picture);
  void showTexts(const SlicePicture& picture);
  std::vector<Eigen::AlignedBox2d> boxesOfLetters();
  void showWords(const SlicePicture& picture);
};

// The text actors ask the guarded text renderer from the beginning.
SliceView::Parts::Parts() {
  ground->SetBackground(0, 0, 0);
  ground->AddViewProp(levels.actor());
  ground->InteractiveOff();
  renderer->SetLayer(1);
  renderer->AddViewProp(thin.actor());
  renderer->AddViewProp(wide.actor());
  cross.data->SetLines(crossLines);
  bar.data->SetLines(barLines);
  renderer->AddViewProp(cross.actor);
  renderer->AddViewProp(bar.actor);
  renderer->AddViewProp(discs.actor());
  for (auto& letter : letters)
    letter = newText(static_cast<int>(kLetterSize));
  for (auto* text : {&title, &note, &length})
    *text = newText(static_cast<int>(kTextSize));
  title->GetTextProperty()->SetVerticalJustificationToTop();
  length->GetTextProperty()->SetJustificationToRight();
  for (std::size_t i = 0; i < 2; ++i) {
    letters[i]->GetTextProperty()->SetVerticalJustificationToCentered();
    letters[i + 2]->GetTextProperty()->SetJustificationToCentered();
  }
  letters[1]->GetTextProperty()->SetJustificationToRight();
  letters[3]->GetTextProperty()->SetVerticalJustificationToTop();
  for (vtkTextActor* text : {letters[0].Get(), letters[1].Get(), letters[2].Get(), letters[3].Get(),
                             title.Get(), note.Get(), length.Get()}) {
    text->GetTextProperty()->SetColor(kText[0], kText[1], kText[2]);
    text->GetTextProperty()->SetShadow(1);
    renderer->AddViewProp(text);
  }
  bar.actor->GetProperty()->SetColor(kText[0], kText[1], kText[2]);
}

void SliceView::Parts::place(vtkTextActor* text, const std::string& words, double x, double y, double size) {
  text->SetVisibility(!words.empty());
  text->SetInput(words.c_str());
  text->SetDisplayPosition(static_cast<int>(x), static_cast<int>(y));
  // VTK scales points by the window's DPI itself.
  setTextSize(text, size, theme);
}

void SliceView::Parts::showTexts(const SlicePicture& picture) {
  const double margin = kWordsMargin * ratio(), w = picture.width, h = picture.height;
  place(letters[0], picture.edges[0], margin, h / 2, kLetterSize);
  place(letters[1], picture.edges[1], w - margin, h / 2, kLetterSize);
  place(letters[2], picture.edges[2], w / 2, margin, kLetterSize);
  place(letters[3], picture.edges[3], w / 2, h - margin, kLetterSize);
  place(title, picture.title, margin, h - margin, kTextSize);
  place(note, picture.note, margin, margin, kTextSize);
  keepApart(title, h - margin, -1, letters[3], w);
  keepApart(note, margin, 1, letters[2], w);
}

/// Words that begin at the left edge and reach to the letter in the middle of theirs, at `y`, go a line
/// towards the picture's middle.
void SliceView::Parts::keepApart(vtkTextActor* words, double y, double towardsMiddle, vtkTextActor* letter,
                                 double width) {
  const double margin = kWordsMargin * ratio();
  double size[2] = {0, 0}, letterSize[2] = {0, 0};
  words->GetSize(renderer, size);
  letter->GetSize(renderer, letterSize);
  if (words->GetVisibility() != 0 && letter->GetVisibility() != 0 &&
      2 * margin + size[0] > (width - letterSize[0]) / 2)
    words->SetDisplayPosition(static_cast<int>(margin),
                              static_cast<int>(y + towardsMiddle * (letterSize[1] + margin / 2)));
}

/// Where the letters at the picture's edges are.
std::vector<Eigen::AlignedBox2d> SliceView::Parts::boxesOfLetters() {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const auto& letter : letters) {
    if (letter->GetVisibility() == 0)
      continue;
    double box[4] = {0, 0, 0, 0};
    letter->GetBoundingBox(renderer, box);
    const Eigen::Vector2d at(letter->GetPosition()[0], letter->GetPosition()[1]);
    boxes.emplace_back(at + Eigen::Vector2d(box[0], box[2]), at + Eigen::Vector2d(box[1], box[3]));
  }
  return boxes;
}

/// Shows the texts beside places of the picture.
void SliceView::Parts::showWords(const SlicePicture& picture) {
  while (captions.size() > picture.texts.size()) {
    renderer->RemoveViewProp(captions.back());
    captions.pop_back();
  }
  while (captions.size() < picture.texts.size()) {
    captions.push_back(newText(static_cast<int>(kTextSize)));
    captions.back()->GetTextProperty()->SetBackgroundColor(0, 0, 0);
    captions.back()->GetTextProperty()->SetBackgroundOpacity(kWordsGround);
    captions.back()->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer->AddViewProp(captions.back());
  }
  const double gap = kWordsGap * ratio(), margin = kWordsMargin * ratio();
  const Eigen::AlignedBox2d inner(Eigen::Vector2d(margin, margin),
                                  Eigen::Vector2d(picture.width - margin, picture.height - margin));
  std::vector<Eigen::AlignedBox2d> taken = boxesOfLetters();
  for (std::size_t i = 0; i < captions.size(); ++i) {
    const SliceText& text = picture.texts[i];
    captions[i]->GetTextProperty()->SetColor(text.color.x(), text.color.y(), text.color.z());
    place(captions[i], text.words, 0, 0, kTextSize);
    double size[2] = {0, 0};
    captions[i]->GetSize(renderer, size);
    taken.push_back(placed(text, {size[0], size[1]}, gap, inner, taken));
    captions[i]->SetDisplayPosition(static_cast<int>(taken.back().min().x()),
                                    static_cast<int>(taken.back().center().y()));
  }
}

/// Two lines with a gap where they meet, so that what is there is seen.
void SliceView::Parts::showCross(const SlicePicture& picture) {
  cross.actor->SetVisibility(picture.cross.has_value());
  if (!picture.cross)
    return;
  cross.begin();
  crossLines->Reset();
  const double gap = kCrossGap * ratio();
  const double x = picture.cross->x() + 0.5, y = picture.cross->y() + 0.5;
  const double ends[4][4] = {{0, y, x - gap, y},
                             {x + gap, y, double(picture.width), y},
                             {x, 0, x, y - gap},
                             {x, y + gap, x, double(picture.height)}};
  for (const auto& line : ends)
    crossLines->InsertNextCell({cross.add(line[0], line[1]), cross.add(line[2], line[3])});
  crossLines->Modified();
  cross.end();
  cross.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio()));
  cross.actor->GetProperty()->SetOpacity(kCrossOpacity);
}

void SliceView::Parts::showBar(const SlicePicture& picture) {
  const double pixels = kLongestBar * picture.width;
  const bool shown = picture.mmPerPixel > 0 && pixels > 1;
  bar.actor->SetVisibility(shown);
  length->SetVisibility(shown);
  if (!shown)
    return;
  const double mm = roundBelow(pixels * picture.mmPerPixel);
  const double right = picture.width - kWordsMargin * ratio() - 0.5, left = right - mm / picture.mmPerPixel;
  const double low = kWordsMargin * ratio() + 0.5, tick = kSliceScaleTick * ratio();
  bar.begin();
  barLines->Reset();
  barLines->InsertNextCell(
      {bar.add(left, low + tick), bar.add(left, low), bar.add(right, low), bar.add(right, low + tick)});
  barLines->Modified();
  bar.end();
  bar.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio()));
  char words[32];
  std::snprintf(words, sizeof words, "%g mm", mm);
  place(length, withDecimalMark(words, decimalMark), right, low + tick, kTextSize);
}

SliceView::SliceView() : parts_((guardText(), std::make_unique<Parts>())) {
  setTheme(darkTheme());
}

SliceView::~SliceView() {
  setWindow(nullptr);
}

void SliceView::setWindow(vtkRenderWindow* window) {
  auto& p = *parts_;
  if (p.window) {
    p.window->RemoveRenderer(p.renderer);
    p.window->RemoveRenderer(p.ground);
  }
  p.window = window;
  if (!window)
    return;
  window->SetMultiSamples(kSliceViewSamples);
  window->SetNumberOfLayers(2);
  window->AddRenderer(p.ground);
  window->AddRenderer(p.renderer);
}

vtkRenderWindow* SliceView::window() const {
  return parts_->window;
}

vtkRenderer* SliceView::renderer() const {
  return parts_->renderer;
}

void SliceView::setDecimalMark(char mark) {
  parts_->decimalMark = mark;
}

void SliceView::setTheme(const Theme& theme) {
  parts_->theme = theme;
  // The accent of a light theme is too dark for a black ground.
  const Vec3 accent = darkTheme().dark == theme.dark ? theme.accent : darkTheme().accent;
  parts_->cross.actor->GetProperty()->SetColor(accent.x(), accent.y(), accent.z());
}

double SliceView::pixelRatio() const {
  return parts_->ratio();
}

void SliceView::show(const SlicePicture& picture) {
  auto& p = *parts_;
  p.levels.show(picture);
  p.thin.begin();
  p.wide.begin();
  for (const SliceLine& line : picture.lines)
    (line.thin ? p.thin : p.wide).add(line);
  p.thin.end();
  p.wide.end();
  p.thin.actor()->GetProperty()->SetLineWidth(static_cast<float>(kThin * p.ratio()));
  p.wide.actor()->GetProperty()->SetLineWidth(static_cast<float>(kWide * p.ratio()));
  p.showCross(picture);
  p.showTexts(picture);
  p.showBar(picture);
  p.discs.show(picture.marks, p.ratio());
  p.showWords(picture);
}

} // namespace viscera::scene
