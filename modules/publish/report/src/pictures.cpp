#include "pictures.h"

#include <array>

#include "viscera/heart/beating_heart.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/slice_presenter.h"
#include "viscera/presentation/stage.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"
#include "viscera/scene/theme.h"
#include "words.h"

namespace viscera::report {
namespace {

/// Device pixels of a picture, and how many of them a logical one has: so that type is readable in print.
struct Format {
  int width;
  int height;
  double pixelRatio;
};
constexpr Format kWide{1800, 1000, 2.4}; ///< As wide as the text.
constexpr Format kSide{760, 620, 2.2};   ///< Three in a row.
constexpr Format kChart{1800, 640, 2.6};
constexpr int kSidesInARow = 3;
constexpr double kRoom = 0.04;

/// The theme of paper, where nothing stands behind the organs.
scene::Theme paper() {
  scene::Theme theme = scene::lightTheme();
  theme.backgroundTop = theme.backgroundBottom = Vec3::Ones();
  return theme;
}

/// Removes the tools of a mode (gizmos, regions, a map of one handle) and the look of a slide, which are not
/// part of a report.
presentation::ViewState plainView(presentation::ViewState view) {
  view.shown = {};
  view.influence = view.gizmo = false;
  view.mirror = presentation::Mirror::off;
  view.layout = {.regions = false};
  view.organsSeen.clear();
  return view;
}

presentation::Stage stageOf(const Format& format, Threads threads) {
  return {format.width,     format.height, paper(), threads, [](const char* text) { return said(text); },
          format.pixelRatio};
}

PictureGrid alone(Picture picture, const Format& format) {
  return {{std::move(picture)}, 1, static_cast<double>(format.width) / format.height};
}

} // namespace

PictureGrid pictureAsSeen(const ReportSource& source, Threads threads) {
  const presentation::ViewState view = plainView(source.view);
  presentation::Stage stage = stageOf(kWide, threads);
  presentation::Scene scene{source.state, *source.organs, view, *source.systems};
  const presentation::Warping measuredOnly{{}, 0, source.tissue};
  if (source.tissue && !view.scan.standing) // Slices stand in the picture as the scan was recorded.
    scene.warping = &measuredOnly;
  const auto& playing = source.view.playing;
  if (source.sequence && playing && playing->shown && playing->ratePerMinute > 0) {
    const double seconds = playing->fraction * 60 / playing->ratePerMinute;
    scene.valves = heart::valvesAt(*source.sequence, seconds, playing->ratePerMinute);
    scene.clock = heart::clockAt(*source.sequence, seconds, playing->ratePerMinute);
  }
  scene.heartTissue = source.heartTissue;
  stage.presenter().update(scene);
  if (view.camera)
    presentation::lookFrom(*view.camera, stage.view());
  else
    stage.compose(scene::StandardView::anterior, kRoom);
  return alone({scene::pngOf(stage.picture()), {}}, kWide);
}

PictureGrid picturesOfSides(const ReportSource& source, Threads threads, Progress& progress) {
  using Side = scene::StandardView;
  const std::array<std::pair<Side, const char*>, 6> sides = {{{Side::anterior, "From the front"},
                                                              {Side::left, "From the left"},
                                                              {Side::superior, "From above"},
                                                              {Side::posterior, "From behind"},
                                                              {Side::right, "From the right"},
                                                              {Side::inferior, "From below"}}};
  presentation::ViewState view = plainView(source.view);
  view.labels = view.measurements = false; // There is no room for names in a small picture.
  presentation::Stage stage = stageOf(kSide, threads);
  presentation::Scene scene{source.state, *source.organs, view, *source.systems};
  scene.heartTissue = source.heartTissue;
  stage.presenter().update(scene);
  PictureGrid grid{{}, kSidesInARow, static_cast<double>(kSide.width) / kSide.height};
  for (const auto& [side, caption] : sides) {
    progress.throwIfCancelled();
    stage.compose(side, kRoom);
    grid.pictures.push_back({scene::pngOf(stage.picture()), said(caption)});
  }
  return grid;
}

PictureGrid pictureOfStress(const ReportSource& source, const live::StressFrame& frame, Threads threads) {
  presentation::ViewState view = plainView(source.view);
  view.shown.stress = true;
  view.labels = false;
  presentation::Stage stage = stageOf(kWide, threads);
  stage.presenter().update({source.state, *source.organs, view, *source.systems, &frame});
  if (source.view.camera && source.view.shown.stress)
    presentation::lookFrom(*source.view.camera, stage.view());
  else
    stage.compose(scene::StandardView::anterior, kRoom);
  return alone({scene::pngOf(stage.picture()), said("The map as the session shows it")}, kWide);
}

PictureGrid chart(scene::CurvePanel panel, const std::string& caption) {
  panel.left = 0.075;
  panel.right = 0.985;
  panel.bottom = 0.17;
  panel.top = 0.96;
  scene::SurfacelessWindow window(kChart.width, kChart.height, kChart.pixelRatio);
  scene::CurvePanels panels;
  panels.setWindow(window.window());
  panels.setTheme(paper());
  panels.setPanels({std::move(panel)});
  panels.update();
  return alone({scene::pngOf(scene::grabPicture(window.window())), caption}, kChart);
}

PictureGrid bullsEyes(std::vector<scene::BullsEyeFigure> figures, const std::string& caption) {
  scene::SurfacelessWindow window(kChart.width, kChart.height, kChart.pixelRatio);
  scene::BullsEyes eyes;
  eyes.setWindow(window.window());
  eyes.setTheme(paper());
  eyes.setFigures(std::move(figures));
  eyes.update();
  return alone({scene::pngOf(scene::grabPicture(window.window())), caption}, kChart);
}

Vec3 curveColor(std::size_t curve) {
  // Safe for people who do not tell red from green (Okabe and Ito), those that paper swallows left out.
  static const std::array<Vec3, 6> colors = {Vec3(0.84, 0.37, 0.0), Vec3(0.0, 0.45, 0.70),
                                             Vec3(0.0, 0.62, 0.45), Vec3(0.80, 0.24, 0.48),
                                             Vec3(0.90, 0.62, 0.0), Vec3(0.25, 0.30, 0.34)};
  return colors[curve % colors.size()];
}

} // namespace viscera::report
