#pragma once

#include <memory>
#include <string>
#include <utility>

#include "monkey.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/document/circulation_commands.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/document/stress_mark_commands.h"
#include "viscera/medical_io/surface_file.h"

/// Sessions to save and open, for tests.
namespace viscera::tests {

inline document::OpenedSession readBack(const std::filesystem::path& file) {
  Progress progress;
  return document::readSession(file, sample_organs::standardLibrary(), progress);
}

inline void write(const std::filesystem::path& file, const document::SessionContents& contents) {
  Progress progress;
  document::writeSession(file, contents, progress);
}

/// A file of a ball, made by the writer of the program.
inline std::filesystem::path ballFile(const viscera::tests::TemporaryFolder& folder, const std::string& name,
                                      double radius = 30) {
  medical_io::writeSurface(folder / name, viscera::tests::sphere(2, radius));
  return folder / name;
}

/// One of everything: organs from a file, edited and with a cavity, handles, groups, a cage, a pose,
/// parameters, locks, a recording, measurements, stress probes, a circulation, a view.
inline document::SessionContents fullContents(const viscera::tests::TemporaryFolder& folder) {
  Session s;
  s.undo.perform(document::addOrgans({{document::readOrgan(ballFile(folder, "liver.vtp")), -1}}));
  const document::OrganId liver = s.organ(1);
  document::NewOrgan cavity = ball("Cavity", 10.1);
  cavity.organ.parent = liver;
  auto painted = std::make_shared<geometry::TriangleMesh>(*cavity.organ.mesh);
  painted->colors = Colors::Constant(painted->points.rows(), 3, 77);
  cavity.organ.mesh = painted;
  s.undo.perform(document::addOrgans({cavity}));
  s.undo.perform(document::setOrganLook(liver, {{0.1, 1.0 / 3, 1}, false, 0.7, true, false}));
  s.undo.perform(document::setVolumeLocked(liver, true));
  s.undo.perform(document::addGroup("Front \"one\"\n", {1, 0.5, 1e-17}, {s.handle(1), s.handle(3)}));
  s.undo.perform(document::addGroup("Over\xC3\xBC", {0, 0, 1}, {s.handle(3), s.handle(4)}));
  s.undo.perform(document::editHandles({s.handle(2)}, {std::nullopt, "why it is here", true, false, true}));
  s.undo.perform(document::moveHandles({s.handle(0), s.handle(9)}, [] {
    Points moved(2, 3);
    moved << -60.1, 1e-310, -0.0, 41.0 / 3, 4.9e-324, -987654321.98765432;
    return moved;
  }()));
  s.undo.perform(document::takeCage({"cube.off", cubeCage()}));
  s.undo.perform(document::setSystem({"t-celestial", {}}));
  s.undo.perform(document::setParameter("softness", 0.1 + 0.2));
  s.undo.perform(document::recordKey(0.25, sequences::Easing::hold));
  s.undo.perform(document::recordKey(1.0 / 3));
  s.undo.perform(document::removeHandles({s.handle(9)})); // The keys still know it.
  const document::MeasuredPoint onLiver =
      document::surfacePoint(*s.document.organ(liver), 3, {0.1, 0.2, 0.7});
  s.undo.perform(document::addMeasurement(
      {onLiver, document::surfacePoint(*s.document.organ(s.organ()), 7, {1, 0, 0})}));
  document::MeasuredPoint fixed;
  fixed.rest = {0.1, -1e-310, 1.0 / 3};
  s.undo.perform(document::addMeasurement({onLiver, fixed, {}}, "Angle \"at\" the \xC3\xBC"));
  s.undo.perform(document::addStressProbe(liver, {1.0 / 3, -1e-310, 4}));
  s.undo.perform(document::addStressProbe(liver, {0.1, 0.2, 20}));
  const auto& probes = s.document.stressMarks().probes;
  s.undo.perform(document::addStressLine(probes[0].id, probes[1].id));
  s.undo.perform(document::chooseScenario("exercise"));
  s.undo.perform(document::keepCirculation());
  s.undo.perform(document::setCirculationParameter("lvEes", 1.0 / 3));
  document::SessionContents contents;
  contents.state = s.document.state();
  document::KeySequence keys = *contents.state.keySequence;
  keys.corrections = {{4, 2, "liver", {Vec3(0.1, -1e-310, 1.0 / 3), Vec3(1, 2, 3)}}};
  contents.state.keySequence = std::make_shared<const document::KeySequence>(std::move(keys));
  contents.view = nlohmann::ordered_json::parse(
      R"({"mode":"deform","camera":{"position":[0.1,-0.0,1e+300]},"other":[1,"two",null]})");
  return contents;
}

} // namespace viscera::tests
