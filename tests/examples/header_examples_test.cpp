// The examples in the comments of public headers, as code. One test finds each of them here again.
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <regex>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "build_paths.h"
#include "clouds.h"
#include "session_fixture.h"
#include "shapes.h"
#include "viscera/anatomy/norms.h"
#include "viscera/anatomy/part.h"
#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/coordinates/corner_determinants.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/stiff_bodies.h"
#include "viscera/geometry/carried_points.h"
#include "viscera/geometry/coarse_triangles.h"
#include "viscera/geometry/median_tree.h"
#include "viscera/geometry/surface_gap.h"
#include "viscera/geometry/volume.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/lesson/lesson_plan.h"
#include "viscera/live/cine_draft.h"
#include "viscera/live/cine_motion.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/motion_copy.h"
#include "viscera/live/player.h"
#include "viscera/live/strain_reading.h"
#include "viscera/localised_scc/region_layout.h"
#include "viscera/medical_io/cine_study.h"
#include "viscera/medical_io/contour.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/slice_frame.h"
#include "viscera/plugin/plugin_loader.h"
#include "viscera/presentation/part_names.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/slice_presenter.h"
#include "viscera/report/report_file.h"
#include "viscera/scene/organ_actor.h"
#include "viscera/scene/slice_view.h"
#include "viscera/scene/text_font.h"
#include "viscera/sequences/breathing.h"
#include "viscera/strain/heart_gauge.h"
#include "viscera/thesis/item.h"
#include "viscera/tracking/mask.h"
#include "viscera/workbench/workbench.h"

// VTK's macros end in a semicolon too many.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include "vtkVisceraDeformFilter.h"
#pragma GCC diagnostic pop

namespace viscera::examples {
namespace {

Points cubeCorners() {
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i)
    corners.row(i) << (i & 1 ? 20 : -20), (i & 2 ? 20 : -20), (i & 4 ? 20 : -20);
  return corners;
}

// These are compiled and not run: they draw, or take seconds, or need a file or a program around them.

[[maybe_unused]] void drawReport(const document::Document& document, const presentation::ViewState& viewState,
                                 live::LiveBinding& live, const coordinates::Registry& registry,
                                 Progress& progress) {
  using namespace report; // Pictures from six sides take about a second.
  const ReportSource source{document.state(), viewState, &live, &registry};
  const Report report = makeReport(source, {}, progress);
  writeReport("liver.pdf", report);
}

[[maybe_unused]] std::size_t reproduceFigure(Progress& progress) {
  using namespace thesis; // Up to half a minute.
  const coordinates::Registry systems = coordinates::builtInRegistry();
  const sample_organs::SampleLibrary samples = sample_organs::standardLibrary();
  const auto results = makeAll(chosenItems({"3.14"}), {systems, samples}, progress);
  return results.size();
}

[[maybe_unused]] double longitudinalStrain(const geometry::TriangleMesh& cavity,
                                           const strain::HeartSurface& surface,
                                           const strain::HeartPhases& beat, Progress& progress) {
  using namespace strain; // Its own tests have hearts in motion.
  const FoundAxes axes = findAxes(cavity, nullptr);
  const HeartGauge gauge({.left = surface}, axes, nullptr, {});
  const HeartStrain strain = gauge.read(beat, progress);
  const double gls = strain.gls->peak.value; // -0.17: shorter by 17 %.
  return gls;
}

[[maybe_unused]] live::StrainReading strainOfABeat(const live::MovedOrgans& organs,
                                                   const live::StrainOptions& options, Progress& progress) {
  using namespace live;                               // As above.
  const StrainGauge gauge(organs, options, progress); // Seconds.
  const StrainReading beat = gauge.read(organs, progress);
  return beat;
}

[[maybe_unused]] void sliceWithABone(const std::shared_ptr<const document::Organ>& femur,
                                     const Points& posedFemur, const deformation::InverseMap& map,
                                     const deformation::SamplePlane& plane, deformation::RestPoints& rest,
                                     Progress& progress) {
  using namespace deformation; // Its own tests have bones that move.
  StiffBodies bones({femur->mesh}, {}, progress);
  bones.setPose({&posedFemur}, map);
  map.restPlane(plane, rest);
  bones.stiffen(plane, rest);
}

[[maybe_unused]] double gapAfterADrag(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b,
                                      const Points& moved) {
  using namespace geometry; // Its own tests measure gaps.
  SurfaceBoxes liver(a.points, a.triangles), vessel(b.points, b.triangles);
  SurfaceGap gap = gapBetween(liver, vessel);
  liver.follow(moved); // Each pose of a drag.
  gap = gapBetween(liver, vessel, gap);
  return gap.mm;
}

[[maybe_unused]] Eigen::Index makeLiver(Progress& progress) {
  using namespace sample_organs; // Seconds where the cache does not have it.
  const SampleLibrary library = standardLibrary();
  const SampleOrgan liver = sampleOrgan(library, "liver", Resolution::low, progress);
  const geometry::TriangleMesh& mesh = *liver.surfaces.front().mesh;
  return mesh.points.rows();
}

[[maybe_unused]] std::optional<double> hounsfieldUnits() {
  using namespace medical_io; // There is no such file.
  Progress progress;
  const Scan scan = readScan("ct.nii.gz", {}, progress);
  const std::optional<double> hu = scan.at(Vec3(12, -40, 310));
  return hu;
}

[[maybe_unused]] std::vector<std::shared_ptr<const medical_io::CineImage>> endSystolicImages() {
  using namespace medical_io; // There is no such folder.
  Progress progress;
  const CineStudy study = readCineStudy("patient1", progress);
  std::vector<std::shared_ptr<const CineImage>> endSystole;
  for (const CineSlice& slice : study.slices)
    endSystole.push_back(slice.image(slice.phaseAt(0.35)));
  return endSystole;
}

[[maybe_unused]] void trackBetweenTwoLabels() {
  using namespace live; // There are no such files.
  Progress progress;
  CineRequest request;
  request.images = "patient1";
  request.labels = {{0, {"ed.nrrd"}}, {9, {"es.nrrd"}}};
  const CineMotion found = trackCine(readLabelledStudy(request, progress), {}, progress);
  writeSequence("beat.sequence.json", found.motion.sequence);
}

[[maybe_unused]] live::CineRequest askForTwoLabels(const medical_io::CineStudy& study) {
  using namespace live; // There are no such files.
  Progress progress;
  CineRequest request;
  CineDraft draft;
  draft.setCycle(cycleOf(study, "patient1", progress));
  draft.add({"ed.nrrd", "es.nrrd"});
  if (draft.missing().empty())
    request = draft.request();
  return request;
}

[[maybe_unused]] void writeAsTheWindow() {
  scene::setTextFont("DejaVu Sans"); // The family of the window.
}

[[maybe_unused]] void drawPosed(scene::OrganActor& actor,
                                const std::shared_ptr<deformation::Deformer>& deformer, const Points& pose) {
  actor.setPoints(std::shared_ptr<const Points>(deformer, &deformer->points()));
  deformer->setPose(pose);
  actor.pointsChanged();
}

[[maybe_unused]] void workAtADocument() {
  workbench::Workbench bench;
  bench.restore("ball.viscera");
  bench.lock("ball");
  bench.drag("H-1", Vec3(5, 0, 0));
  std::cout << bench.volume("ball").nowMl << " ml\n";
  for (const workbench::PlayedVolumes& instant : bench.play(25))
    std::cout << instant.seconds << ' ' << instant.milliliters.front() << '\n';
  bench.undo();
  bench.save("posed.viscera");
}

[[maybe_unused]] void drawSlices(const document::Document& document, live::LiveBinding& live,
                                 const presentation::ViewState& viewState, scene::SliceView& view, int width,
                                 int height) {
  using namespace presentation;
  SlicePresenter slices;
  slices.update({document.state(), live, viewState}, {{0, width, height}});
  view.show(slices.picture(0));
}

[[maybe_unused]] void drawScene(const document::Document& document, live::LiveBinding& live,
                                const presentation::ViewState& viewState,
                                const coordinates::Registry& systems, vtkRenderWindow* window) {
  scene::OrganView view;
  presentation::Presenter presenter(view);
  presenter.update({document.state(), live, viewState, systems});
  window->Render();
}

[[maybe_unused]] void askForParts(const document::OrganList& organs, unsigned seed,
                                  const presentation::Part& clicked,
                                  const std::function<void(const char*)>& say) {
  using namespace presentation;
  PartQuiz quiz(partsOf(organs), seed);
  while (quiz.asked())
    say(quiz.answer(clicked) ? "Right" : "No");
}

[[maybe_unused]] void measureVolumes(JobQueue& jobs, live::Player& player, live::LiveBinding& live,
                                     const std::function<void(JobResult<live::CycleCurves>)>& take) {
  using namespace live;
  auto copy = std::make_shared<MotionCopy>(player.runner(), live.copy());
  jobs.submit<CycleCurves>(
      "Volumes", "cycle", [copy](Progress& p) { return measureCycle(copy->runner(), p); }, take);
}

[[maybe_unused]] void playSequence(const document::Document& document, live::LiveBinding& live,
                                   std::shared_ptr<const sequences::Sequence> sequence,
                                   document::OrganId organ) {
  using namespace live;
  Player player(document.state(), live);
  player.setSequence(sequence, organ);
  player.play();
  player.advance(); // With every frame.
}

[[maybe_unused]] live::CycleCurves curvesOf(const document::DocumentState& state, live::LiveBinding& live,
                                            const std::shared_ptr<const sequences::Sequence>& sequence,
                                            Progress& progress) {
  using namespace live;
  live::PosedCopy organs = live.copy();
  MotionRunner runner(state, organs);
  runner.setSequence(sequence);
  const CycleCurves curves = measureCycle(runner, progress);
  return curves;
}

void refusePose(int posed, int count) {
  throw DataError(phrase("The pose has %1 handles, the document %2", posed, count));
}

} // namespace

TEST(HeaderExamples, Circulation) {
  using namespace circulation;
  const Parameters parameters = scenarioParameters("aortic-stenosis");
  Progress progress;
  const PeriodicState found = findPeriodicState(parameters, progress);
  const double gradient = indicesOf(parameters, found.beat).aorticMeanGradient;
  EXPECT_GE(gradient, 40);
}

TEST(HeaderExamples, Texts) {
  const Text step = phrase("Open %1", named("Liver")); // In German "Leber öffnen".
  EXPECT_EQ(step.english(), "Open Liver");
}

TEST(HeaderExamples, Heart) {
  using namespace heart;
  const CardiacBeat beat = CardiacCycle().beat(75);
  const double duringEjection = beat.at(beat.left().outletOpens + 0.1).volumes.leftMl;
  EXPECT_GT(duringEjection, CardiacCycle::kEndSystole.leftMl);
  EXPECT_LT(duringEjection, CardiacCycle::kEndDiastole.leftMl);
}

TEST(HeaderExamples, Contour) {
  using namespace medical_io;
  const std::vector<float> values = {-1, 1, -1, 1, -1, 1, -1, 1};
  const geometry::TriangleMesh plane = contourOf(values, {2, 2, 2}, 0.0);
  const double x = plane.points(0, 0); // 0.5
  EXPECT_EQ(x, 0.5);
}

TEST(HeaderExamples, CoordinatesAndDeformation) {
  using namespace deformation;
  const auto system = coordinates::builtInRegistry().find("s-celestial");
  const coordinates::HandleSet handles{cubeCorners(), {}, {}};
  const Points pose = 2 * handles.positions;
  const auto ball = std::make_shared<const geometry::TriangleMesh>(tests::sphere(2, 5));
  {
    const geometry::TriangleMesh& mesh = *ball;
    Progress progress;
    const auto binding = system->bind(handles, mesh.points, {}, progress);
    Points points;
    binding->deform(pose, points);
    EXPECT_LT((points - 2 * mesh.points).cwiseAbs().maxCoeff(), 1e-9);
  }
  Progress progress;
  const std::shared_ptr<const coordinates::Binding> binding =
      system->bind(handles, ball->points, {}, progress);
  const auto& mesh = ball;
  Deformer deformer(mesh, binding, handles.positions);
  deformer.setPose(pose);
  const double ml = deformer.volumeMm3() / 1000;
  EXPECT_NEAR(ml, 8 * deformer.restVolumeMm3() / 1000, 1e-9);
}

TEST(HeaderExamples, CornerDeterminants) {
  using namespace coordinates;
  HandleSet handles;
  handles.positions = 1.5 * cubeCorners();
  Progress progress;
  const geometry::TriangleMesh mesh = tests::sphere(2, 15);
  const auto bound =
      coordinates::builtInRegistry().find("s-celestial")->bind(handles, mesh.points, {}, progress);
  const Binding& binding = *bound;
  const Triangles& triangles = mesh.triangles;
  const CornerDeterminants determinants(binding, triangles);
  CornerDeterminants::Sums sums;
  determinants.ofHandle(7, sums); // sums(i, j) is D_ij7 for i < j < 7
  EXPECT_GT(sums.topLeftCorner(7, 7).cwiseAbs().maxCoeff(), 0);
}

TEST(HeaderExamples, Core) {
  const Points points = cubeCorners();
  Eigen::VectorXd lengths(points.rows());
  parallelRanges(points.rows(), 1024, {}, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      lengths[i] = points.row(i).norm();
  });
  EXPECT_EQ(lengths, points.rowwise().norm());
  EXPECT_THROW(refusePose(3, 4), DataError);
}

TEST(HeaderExamples, Document) {
  using namespace document;
  const geometry::TriangleMesh mesh = tests::sphere(1, 10);
  Document document;
  UndoStack undo(document);
  undo.perform(addOrgans({{makeOrgan("Ball", mesh), -1}}));
  undo.undo();
  EXPECT_TRUE(document.organs().empty());
  EXPECT_TRUE(undo.canRedo());
}

TEST(HeaderExamples, Geometry) {
  using namespace geometry;
  TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
  requireValid(mesh, "corner");
  EXPECT_NEAR(volume(mesh.points, mesh.triangles), 1000.0 / 6, 1e-9);
  Triangles coarse = coarseTriangles(mesh, 25000);
  EXPECT_EQ(coarse.rows(), 4);
}

TEST(HeaderExamples, Lesson) {
  using namespace lesson;
  const tests::Session session;
  const document::Document& document = session.document;
  LessonSource source{document.state()};
  LessonPlan plan = planLesson(source, {});
  plan.title = "The liver in a breath";
  EXPECT_EQ(plan.surfaces.size(), 1u);
}

TEST(HeaderExamples, Live) {
  using namespace live;
  tests::Session session;
  auto& [document, undo] = session;
  const coordinates::Registry registry = coordinates::builtInRegistry();
  JobQueue jobs{[](std::function<void()> work) { work(); }};
  const document::OrganId organ = document.organs().front()->id;
  const Points pose = 2 * document.pose();
  const double always = std::numeric_limits<double>::infinity(); // No event loop.
  LiveBinding live(document, registry, jobs, {always, {}});
  undo.perform(document::setPose(pose));
  const Points& points = live.points(organ);
  EXPECT_LT((points - 2 * document.organs().front()->mesh->points).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(HeaderExamples, LocalisedScc) {
  using namespace localised_scc;
  const coordinates::HandleSet handles{cubeCorners(), {}, {}};
  const Vec3 point(1, 2, 3);
  const RegionLayout layout(handles, 5);
  double sum = 0; // 1
  for (const RegionLayout::Share& share : layout.shares(point))
    sum += share.weight;
  EXPECT_NEAR(sum, 1, 1e-15);
}

TEST(HeaderExamples, Norms) {
  using namespace anatomy;
  const Norm& volume = norm("lv.edv");
  const Range range = rangeOf(volume, {Sex::women, 1.8});
  const bool usual = range.holds(120);
  EXPECT_EQ(usual, range.low <= 120 && range.high >= 120);
}

TEST(HeaderExamples, Part) {
  using namespace anatomy;
  const std::optional<Part> part = partNamed("lung_upper_lobe_left");
  const bool wholeLung = part == Part{"lung", Side::left}; // No: it is a piece.
  EXPECT_FALSE(wholeLung);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->organ, "lung");
}

TEST(HeaderExamples, MedianTree) {
  using namespace geometry;
  const Points points = tests::onSphere(100, 10);
  const Vec3 wanted(3, 4, 5);
  const int count = static_cast<int>(points.rows());
  const auto boxAround = [&](std::span<const int> items, Vec3& sides) {
    Points within(static_cast<Eigen::Index>(items.size()), 3);
    for (std::size_t i = 0; i < items.size(); ++i)
      within.row(static_cast<Eigen::Index>(i)) = points.row(items[i]);
    const Bounds box = boundsOf(within);
    sides = box.high - box.low;
    return box;
  };
  const auto comesFirst = [&](int a, int b, Eigen::Index axis) { return points(a, axis) < points(b, axis); };
  const auto distanceToBox = [&](const Bounds& box) {
    return (wanted.cwiseMax(box.low).cwiseMin(box.high) - wanted).norm();
  };
  double best = std::numeric_limits<double>::infinity();
  const auto isFartherThanTheBest = [&](const Bounds&, double distance) { return distance > best; };
  const auto compare = [&](const std::vector<int>& order, int begin, int end) {
    for (int place = begin; place < end; ++place)
      best = std::min(best, (points.row(order[std::size_t(place)]).transpose() - wanted).norm());
  };
  const MedianTree<Bounds> tree(count, 4, boxAround, comesFirst);
  const auto searchItems = [&](int begin, int end) { compare(tree.order(), begin, end); };
  tree.searchNearestFirst(distanceToBox, isFartherThanTheBest, searchItems);
  EXPECT_EQ(best, (points.rowwise() - wanted.transpose()).rowwise().norm().minCoeff());
}

TEST(HeaderExamples, CarriedPoints) {
  using namespace geometry;
  const TriangleMesh outer = tests::sphere(3, 40), inner = tests::sphere(3, 30);
  const Points outerNow = outer.points.rowwise() + Eigen::RowVector3d(1, 2, 3);
  const CarriedPoints carried(inner.points, outer.points);
  Points now;
  carried.at(outerNow, now);
  EXPECT_LT((now - inner.points).rowwise().norm().maxCoeff(), 4);
}

TEST(HeaderExamples, Plugin) {
  using namespace coordinates;
  using namespace plugin;
  Registry registry = builtInRegistry();
  const auto reports = loadPlugins(pluginSearchPath({"plugins"}, {}), registry);
  const auto system = registry.find("s-celestial");
  EXPECT_EQ(system->id(), "s-celestial");
  EXPECT_FALSE(reports.empty()); // The folder is not there.
}

TEST(HeaderExamples, Sequences) {
  using namespace sequences;
  const LiverBreathing sequence(cubeCorners(), Bounds(Vec3(-20, -20, -20), Vec3(20, 20, 20)));
  const double rate = sequence.standardRatePerMinute();
  Points pose;
  sequence.poseAt(60 / rate, rate, pose); // As at the beginning.
  EXPECT_LT((pose - sequence.restHandles()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HeaderExamples, Slices) {
  using namespace medical_io;
  const Vec3 center(10, 20, 30);
  const SliceFrame frame = frameAround(sliceDirection("axial"), center, 0.5, 401, 301);
  const Vec3 corner = frame.at(0, 0);
  const Eigen::Vector2d pixel = frame.pixelOf(center); // 200, 150
  EXPECT_LT((pixel - Eigen::Vector2d(200, 150)).norm(), 1e-9);
  EXPECT_EQ(corner.z(), 30);
}

TEST(HeaderExamples, Tracking) {
  using namespace tracking;
  const geometry::TriangleMesh surface = tests::sphere(3, 8);
  Mask grid;
  grid.size = {20, 20, 20};
  grid.indexToLps.translation() = Vec3(-9.5, -9.5, -9.5);
  const Mask filled = voxelised(surface, grid);
  const double ml = filled.volumeMl();
  EXPECT_NEAR(ml, geometry::volume(surface.points, surface.triangles) / 1000, 0.1);
}

TEST(HeaderExamples, VtkFilters) {
  const auto dataOf = [](const Points& points, const Triangles& triangles) {
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      places->InsertNextPoint(points(i, 0), points(i, 1), points(i, 2));
    vtkNew<vtkCellArray> cells;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
      cells->InsertNextCell({triangles(t, 0), triangles(t, 1), triangles(t, 2)});
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(places);
    data->SetPolys(cells);
    return data;
  };
  const geometry::TriangleMesh ball = tests::sphere(2, 5);
  const auto organ = dataOf(ball.points, ball.triangles);
  const auto rest = dataOf(cubeCorners(), {}), posed = dataOf(2 * cubeCorners(), {});
  vtkNew<vtkVisceraDeformFilter> filter;
  filter->SetInputData(organ);
  filter->SetRestHandlesData(rest);
  filter->SetPosedHandlesData(posed);
  filter->Update();
  EXPECT_NEAR(filter->GetVolumeRatio(), 8, 1e-9);
}

namespace {

std::string withoutSpace(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

/// The examples of a header: lines five spaces behind the mark of a comment, after an empty comment line.
std::vector<std::string> examplesIn(const std::filesystem::path& header) {
  static const std::regex code(R"(^\s*(///|\*) {5,}(\S.*)$)"), empty(R"(^\s*(///|\*)\s*$)");
  std::vector<std::string> examples;
  std::ifstream stream(header);
  bool afterEmpty = false, inside = false;
  for (std::string line; std::getline(stream, line);) {
    std::smatch found;
    const bool is = std::regex_match(line, found, code);
    if (is && afterEmpty)
      examples.emplace_back();
    inside = is && (inside || afterEmpty);
    if (inside)
      examples.back() += found[2].str() + "\n";
    afterEmpty = std::regex_match(line, empty);
  }
  return examples;
}

/// The folders include/ of all modules and their parts, and that of the filters for VTK.
std::vector<std::filesystem::path> foldersOfPublicHeaders(const std::filesystem::path& modules) {
  std::vector<std::filesystem::path> folders = {modules / "bindings/vtk/filters"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(modules))
    if (entry.is_directory() && entry.path().filename() == "include")
      folders.push_back(entry.path());
  return folders;
}

} // namespace

TEST(HeaderExamples, EachStandsInTheseFilesAndEachModuleHasOne) {
  const std::filesystem::path root = VISCERA_SOURCE_DIR;
  std::string here;
  for (const char* name : {"header_examples_test.cpp", "phantom_header_examples_test.cpp"}) {
    std::ifstream stream(root / "tests/examples" / name, std::ios::binary);
    here += withoutSpace({std::istreambuf_iterator<char>(stream), {}});
  }
  for (const std::filesystem::path& folder : foldersOfPublicHeaders(root / "modules")) {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
      if (file.path().extension() != ".h")
        continue;
      for (const std::string& example : examplesIn(file.path())) {
        ++count;
        EXPECT_NE(here.find(withoutSpace(example)), std::string::npos) << file.path() << "\n" << example;
      }
    }
    EXPECT_GT(count, 0u) << folder << " has no example in a public header";
  }
}

} // namespace viscera::examples
