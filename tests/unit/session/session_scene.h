#pragma once

#include <string>

#include "monkey.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/session/measurement_commands.h"
#include "viscera/session/open_files.h"
#include "viscera/session/recording_commands.h"
#include "viscera/session/session_file.h"

/// Sessions to save and open, for tests.
namespace viscera::session::tests {

inline OpenedSession readBack(const std::filesystem::path& file) {
  Progress progress;
  return readSession(file, organs::standardLibrary(), progress);
}

inline void write(const std::filesystem::path& file, const SessionContents& contents) {
  Progress progress;
  writeSession(file, contents, progress);
}

/// A file of a ball, made by the writer of the program.
inline std::filesystem::path ballFile(const viscera::tests::TemporaryFolder& folder, const std::string& name,
                                      double radius = 30) {
  medical_io::writeSurface(folder / name, viscera::tests::sphere(2, radius));
  return folder / name;
}

/// One of everything: organs from a file, edited and with a cavity, handles, groups, a cage, a pose,
/// parameters, locks, a recording, measurements, a view.
inline SessionContents fullContents(const viscera::tests::TemporaryFolder& folder) {
  Session s;
  s.undo.perform(addOrgans({{readOrgan(ballFile(folder, "liver.vtp")), -1}}));
  const OrganId liver = s.organ(1);
  NewOrgan cavity = ball("Cavity", 10.1);
  cavity.organ.parent = liver;
  auto painted = std::make_shared<geometry::TriangleMesh>(*cavity.organ.mesh);
  painted->colors = Colors::Constant(painted->points.rows(), 3, 77);
  cavity.organ.mesh = painted;
  s.undo.perform(addOrgans({cavity}));
  s.undo.perform(setOrganLook(liver, {{0.1, 1.0 / 3, 1}, false, 0.7, true, false}));
  s.undo.perform(setVolumeLocked(liver, true));
  s.undo.perform(addGroup("Front \"one\"\n", {1, 0.5, 1e-17}, {s.handle(1), s.handle(3)}));
  s.undo.perform(addGroup("Over\xC3\xBC", {0, 0, 1}, {s.handle(3), s.handle(4)}));
  s.undo.perform(editHandles({s.handle(2)}, {std::nullopt, "why it is here", true, false, true}));
  s.undo.perform(moveHandles({s.handle(0), s.handle(9)}, [] {
    Points moved(2, 3);
    moved << -60.1, 1e-310, -0.0, 41.0 / 3, 4.9e-324, -1.7976931348623157e308;
    return moved;
  }()));
  s.undo.perform(takeCage({"cube.off", cubeCage()}));
  s.undo.perform(setSystem({"t-celestial", {}}));
  s.undo.perform(setParameter("softness", 0.1 + 0.2));
  s.undo.perform(recordKey(0.25, sequences::Easing::hold));
  s.undo.perform(recordKey(1.0 / 3));
  s.undo.perform(removeHandles({s.handle(9)})); // The keys still know it.
  const MeasuredPoint onLiver = surfacePoint(*s.document.organ(liver), 3, {0.1, 0.2, 0.7});
  s.undo.perform(addMeasurement({onLiver, surfacePoint(*s.document.organ(s.organ()), 7, {1, 0, 0})}));
  MeasuredPoint fixed;
  fixed.rest = {0.1, -1e-310, 1.0 / 3};
  s.undo.perform(addMeasurement({onLiver, fixed, {}}, "Angle \"at\" the \xC3\xBC"));
  SessionContents contents;
  contents.state = s.document.state();
  contents.view = R"({"mode":"deform","camera":{"position":[0.1,-0.0,1e+300]},"other":[1,"two",null]})";
  return contents;
}

} // namespace viscera::session::tests
