#include <chrono>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "fuzz_target.h"
#include "session_scene.h"
#include "temporary_folder.h"
#include "viscera/document/validate.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/lesson/lesson_spec.h"
#include "viscera/live/sequence_file.h"
#include "viscera/sequences/volume_curve.h"

/// Sessions, key sequences, curves, lessons and the definitions of organs.
namespace viscera::fuzz {
namespace {

/// No sample organs: making one takes seconds, and its definition has a target of its own.
sample_organs::SampleLibrary noSamples() {
  return {scratchFolder() / "none", scratchFolder() / "none"};
}

void openSession(Bytes bytes) {
  Progress progress;
  const document::OpenedSession opened =
      document::readSession(scratchFile("a.viscera", bytes), noSamples(), progress);
  document::validate(opened.contents.state);
  const auto first = scratchFolder() / "b.viscera", second = scratchFolder() / "c.viscera";
  document::writeSession(first, opened.contents, progress);
  document::writeSession(second, document::readSession(first, noSamples(), progress).contents, progress);
  require(viscera::tests::contentsOf(first) == viscera::tests::contentsOf(second),
          "A session that is written, read and written again has the same bytes.");
}

/// What one of the small sessions has beside a tetrahedron and its handles.
using SessionEdit = void (*)(document::UndoStack& undo, const document::Document& document);

std::string smallSession(SessionEdit edit) {
  document::Document document;
  document::UndoStack undo(document);
  undo.perform(
      document::addOrgans({{document::makeOrgan("T", viscera::tests::tetrahedron(60, 60, 60)), -1}}));
  undo.perform(document::addHandles(viscera::tests::cubeHandles(90)));
  edit(undo, document);
  const viscera::tests::TemporaryFolder folder;
  document::SessionContents contents;
  contents.state = document.state();
  contents.view["mode"] = "deform";
  viscera::tests::write(folder / "a.viscera", contents);
  return viscera::tests::contentsOf(folder / "a.viscera");
}

/// Many small files instead of a large one: most of that would be coordinates in base64, which mutations only
/// break.
std::vector<std::string> sessionSeeds() {
  const std::vector<SessionEdit> edits = {
      [](auto&, const auto&) {},
      [](auto& undo, const auto& document) {
        undo.perform(document::addGroup("Front", {1, 0.5, 0}, {document.rig().handles[1].id}));
        undo.perform(document::setSystem({"t-celestial", {}}));
        undo.perform(document::setParameter("softness", 0.5));
      },
      [](auto& undo, const auto& document) {
        undo.perform(document::setVolumeLocked(document.organs()[0]->id, true));
        undo.perform(document::moveHandles({document.rig().handles[0].id}, viscera::tests::row(-80, 1, 2)));
        undo.perform(document::recordKey(0.25, sequences::Easing::hold));
        undo.perform(document::recordKey(0.5));
      },
      [](auto& undo, const auto& document) {
        const document::MeasuredPoint point =
            document::surfacePoint(*document.organs()[0], 3, {0.1, 0.2, 0.7});
        undo.perform(document::addMeasurement({point, point}));
      },
      [](auto& undo, const auto& document) {
        undo.perform(document::addStressProbe(document.organs()[0]->id, {9, 9, 9}));
        undo.perform(document::addStressProbe(document.organs()[0]->id, {9, 9, 12}));
        const auto& probes = document.stressMarks().probes;
        undo.perform(document::addStressLine(probes[0].id, probes[1].id));
      },
      [](auto& undo, const auto&) {
        undo.perform(document::takeCage({"cube.off", viscera::tests::cubeCage(90)}));
      },
      [](auto& undo, const auto&) {
        undo.perform(document::chooseScenario("exercise"));
        undo.perform(document::setCirculationParameter("lvEes", 2));
      }};
  std::vector<std::string> out;
  for (const SessionEdit edit : edits)
    out.push_back(smallSession(edit));
  return out;
}

void openSequence(Bytes bytes) {
  const live::SequenceFile read = live::readSequence(scratchFile("a.sequence.json", bytes));
  require(read.track.restHandles.allFinite(), "A sequence has handles at places.");
  const std::string text = live::textOf(read);
  std::ofstream(scratchFolder() / "b.sequence.json") << text;
  require(live::textOf(live::readSequence(scratchFolder() / "b.sequence.json")) == text,
          "A sequence that is written and read is the same.");
}

std::vector<std::string> sequenceSeeds() {
  const viscera::tests::TemporaryFolder folder;
  return {live::textOf(live::sequenceFile(viscera::tests::fullContents(folder).state))};
}

void readCurve(Bytes bytes) {
  const sequences::Curve curve = sequences::readVolumeCurve(scratchFile("a.csv", bytes), 0.8);
  for (int i = 0; i <= 16; ++i)
    require(curve.at(i / 16.0) > 0, "A volume is positive between its keys.");
}

std::vector<std::string> curveSeeds() {
  return {"fraction,ml\n0,120\n0.35,50\n0.6,100\n1,120\n", "time;volume\n0;120.5\n0.4;50\n0.8;120.5\n"};
}

void readLesson(Bytes bytes) {
  lesson::readSpec(textOf(bytes), "a.lesson.json");
}

std::vector<std::string> lessonSeeds() {
  return {R"({"title": "A heart", "notes": "To try.", "names": {"lv": "Left ventricle"}, "rates": [60, 90],
              "labels": [{"surface": "outer", "text": "Apex", "at": [56, -40, -30]}], "handles": 20,
              "slides": [{"title": "Two pumps", "text": "Red.", "side": "anterior", "seeThrough": 0.3},
                         {"title": "Here", "position": [0, -300, 40], "focus": [0, 0, 10], "fraction": 0.25}]})"};
}

/// Surfaces that are made, not only read: small ones, that a run may take some milliseconds.
constexpr int kMostTrianglesMade = 800;
constexpr double kLeastSpacingMade = 4, kMostCoordinateMade = 150; ///< mm
constexpr std::chrono::seconds kLongestMaking{3};

/// The largest number anywhere in a definition, such as a radius or a scale.
double largestNumber(const nlohmann::json& value) {
  if (value.is_number())
    return std::abs(value.get<double>());
  double most = 0;
  if (value.is_structured())
    for (const nlohmann::json& part : value)
      most = std::max(most, largestNumber(part));
  return most;
}

/// The name of the first surface where it is small enough to be made at low resolution; else empty.
std::string smallSurface(Bytes bytes) {
  const auto content = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false, true);
  if (!content.is_object() || !content.contains("surfaces") || !content["surfaces"].is_array() ||
      content["surfaces"].empty() || content.contains("include"))
    return {};
  const nlohmann::json first = content["surfaces"].front();
  const auto number = [&](const nlohmann::json::json_pointer& at) {
    return first.contains(at) && first[at].is_number() ? first[at].get<double>() : 0.0;
  };
  const double triangles = number(nlohmann::json::json_pointer("/triangles/low"));
  const bool small = triangles > 0 && triangles <= kMostTrianglesMade &&
                     number(nlohmann::json::json_pointer("/spacing")) >= kLeastSpacingMade &&
                     largestNumber(first.value("root", nlohmann::json())) <= kMostCoordinateMade &&
                     largestNumber(content.value("nodes", nlohmann::json())) <= kMostCoordinateMade;
  return small && first.contains("name") && first["name"].is_string() ? first["name"].get<std::string>() : "";
}

void readOrganDefinition(Bytes bytes) {
  const std::filesystem::path file = scratchFile("organ.json", bytes);
  const sample_organs::SampleLibrary library{file.parent_path(), {}};
  const std::string small = smallSurface(bytes);
  if (small.empty()) { // Reads all of the definition, then refuses the surface.
    sample_organs::implicitSurface(library, "organ", "surf no such surface", sample_organs::Resolution::low);
    return;
  }
  const auto end = std::chrono::steady_clock::now() + kLongestMaking;
  Progress* running = nullptr;
  Progress progress({}, [&] {
    if (std::chrono::steady_clock::now() > end)
      running->cancel(); // Scales of scales are large as well.
  });
  running = &progress;
  const sample_organs::SampleSurface made =
      sample_organs::sampleSurface(library, "organ", small, sample_organs::Resolution::low, progress, {1});
  geometry::requireValid(*made.mesh, "the surface that was made");
  require(made.mesh->colors.rows() == made.mesh->points.rows(), "Every point has its colour.");
  const geometry::SurfaceReport report = geometry::checkSurface(*made.mesh);
  require(report.closed() && report.manifold(), "A surface that was made is closed and manifold.");
}

/// A pear with a little of everything that is quick to make.
constexpr const char* kSmallDefinition = R"({"name": "organ", "units": "mm", "frame": "LPS", "nodes": [
  {"name": "body", "type": "tube", "paint": [0.8, 0.7, 0.3],
   "points": [[0, 0, 0, 30], [0, 0, 40, 22], [0, 0, 70, 14]]},
  {"name": "ball", "type": "ellipsoid", "center": [20, 0, 10], "radii": [20, 24, 18]}],
  "surfaces": [{"name": "outer", "spacing": 5, "triangles": {"low": 400, "medium": 400, "high": 400},
    "places": [{"name": "tip", "at": [0, 0, 84]}],
    "root": {"type": "ROOT"}}]})";

std::string smallDefinition(const std::string& root) {
  std::string text = kSmallDefinition;
  const std::string place = R"("type": "ROOT")";
  text.replace(text.find(place), place.size(), root);
  return text;
}

std::vector<std::string> definitionSeeds() {
  std::vector<std::string> out;
  for (const char* organ : {"heart", "kidney_left", "liver", "stomach"})
    out.push_back(
        nlohmann::json::parse(viscera::tests::contentsOf(sample_organs::standardLibrary().definitions /
                                                         (std::string(organ) + ".json")))
            .dump());
  for (const char* root :
       {R"("type": "displace", "amplitude": 0.6, "wavelength": 20, "child": "body")",
        R"("type": "union", "k": 6, "children": ["body", "ball"])",
        R"("type": "subtract", "from": "body", "k": 3, "children": ["ball"])",
        R"("type": "offset", "distance": 3, "child": {"type": "intersect", "k": 2, "children": ["body",
           {"type": "half_space", "point": [0, 0, 50], "normal": [0, 0, 1]}]})",
        R"("type": "frame", "origin": [5, 5, 5], "rotate_deg": [10, 20, 30], "scale": 1.2, "child": "ball")"})
    out.push_back(smallDefinition(root));
  return out;
}

} // namespace

std::vector<Target> documentTargets() {
  return {{"sessions", openSession, sessionSeeds},
          {"sequences", openSequence, sequenceSeeds},
          {"volume_curves", readCurve, curveSeeds},
          {"lessons", readLesson, lessonSeeds},
          {"organ_definitions", readOrganDefinition, definitionSeeds}};
}

} // namespace viscera::fuzz
