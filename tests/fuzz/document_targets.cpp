#include <fstream>

#include "fuzz_target.h"
#include "session_scene.h"
#include "temporary_folder.h"
#include "viscera/document/validate.h"
#include "viscera/lesson/lesson_spec.h"
#include "viscera/motion/sequence_file.h"
#include "viscera/motion/volume_curve.h"

/// Sessions, recorded sequences, curves, lessons and the definitions of organs.
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

std::vector<std::string> sessionSeeds() {
  const viscera::tests::TemporaryFolder folder;
  document::SessionContents contents = viscera::tests::fullContents(folder);
  std::vector<std::string> out;
  for (const bool embed : {true, false}) {
    contents.embedSurfaces = embed;
    viscera::tests::write(folder / "a.viscera", contents);
    out.push_back(viscera::tests::contentsOf(folder / "a.viscera"));
  }
  return out;
}

void openSequence(Bytes bytes) {
  const motion::SequenceFile read = motion::readSequence(scratchFile("a.sequence.json", bytes));
  require(read.track.restHandles.allFinite(), "A sequence has handles at places.");
  const std::string text = motion::textOf(read);
  std::ofstream(scratchFolder() / "b.sequence.json") << text;
  require(motion::textOf(motion::readSequence(scratchFolder() / "b.sequence.json")) == text,
          "A sequence that is written and read is the same.");
}

std::vector<std::string> sequenceSeeds() {
  const viscera::tests::TemporaryFolder folder;
  return {motion::textOf(motion::sequenceFile(viscera::tests::fullContents(folder).state))};
}

void readCurve(Bytes bytes) {
  const sequences::Curve curve = motion::readVolumeCurve(scratchFile("a.csv", bytes), 0.8);
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

void readOrganDefinition(Bytes bytes) {
  const std::filesystem::path file = scratchFile("organ.json", bytes);
  const sample_organs::SampleLibrary library{file.parent_path(), file.parent_path() / "none"};
  // Reads all of the definition, then refuses the surface.
  sample_organs::implicitSurface(library, "organ", "surf no such surface", sample_organs::Resolution::low);
}

std::vector<std::string> definitionSeeds() {
  std::vector<std::string> out;
  for (const char* organ : {"heart", "kidney_left", "liver", "stomach"})
    out.push_back(viscera::tests::contentsOf(sample_organs::standardLibrary().definitions /
                                             (std::string(organ) + ".json")));
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
