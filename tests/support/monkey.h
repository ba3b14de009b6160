#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/stress_mark_commands.h"

namespace viscera::tests {

/// Does seeded random commands, drags, undo and redo on a document.
class Monkey {
public:
  Monkey(Session& session, unsigned seed) : s_(session), random_(seed) {}

  /// Does one action: a command, perhaps one that is refused, a drag, an undo or a redo.
  void act() {
    switch (number(12)) {
    case 0:
      drag();
      break;
    case 1:
      s_.undo.undo();
      break;
    case 2:
      s_.undo.redo();
      break;
    default:
      attempt(anyCommand());
    }
    if (number(8) == 0)
      s_.undo.seal();
  }

  int refused() const { return refused_; }

private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 place() { return {real(-90, 90), real(-90, 90), real(-90, 90)}; }
  Vec3 color() { return {real(0, 1), real(0, 1), real(0, 1)}; }

  void attempt(const document::Command& command) {
    const document::DocumentState before = s_.document.state();
    try {
      s_.undo.perform(command);
    } catch (const Error&) {
      ++refused_;
      EXPECT_EQ(s_.document.state(), before) << command.name << " was refused and left a trace";
    }
  }

  void drag() {
    document::UndoStack::Step step(s_.undo, "Drag");
    const auto handles = someHandles();
    for (int i = 0; i < 5; ++i)
      attempt(document::moveHandles(handles, places(handles.size())));
    number(4) == 0 ? step.cancel() : step.finish();
  }

  Points places(std::size_t count) {
    Points out(static_cast<Eigen::Index>(count), 3);
    for (Eigen::Index i = 0; i < out.rows(); ++i)
      out.row(i) = place().transpose();
    return out;
  }

  std::vector<document::HandleId> someHandles() {
    std::vector<document::HandleId> out;
    for (const document::Handle& handle : s_.document.rig().handles)
      if (number(4) == 0)
        out.push_back(handle.id);
    return out;
  }

  /// One that is there, or one that is not.
  template <class AnyId, class List, class IdOf>
  AnyId pick(const List& list, IdOf idOf) {
    const int index = number(static_cast<int>(list.size()) + 1);
    return index < static_cast<int>(list.size()) ? idOf(list[static_cast<std::size_t>(index)])
                                                 : AnyId{12345678};
  }
  document::OrganId anOrgan() {
    return pick<document::OrganId>(s_.document.organs(), [](const auto& organ) { return organ->id; });
  }
  document::GroupId aGroup() {
    return pick<document::GroupId>(s_.document.rig().groups,
                                   [](const document::Group& group) { return group.id; });
  }

  document::Command anyCommand() {
    const std::string text = "T" + std::to_string(number(12));
    switch (number(26)) {
    case 0:
      return document::addOrgans({ball(text, real(5, 40), 1, place())});
    case 1:
      return document::removeOrgans({anOrgan()});
    case 2:
      return document::setOrganLook(anOrgan(),
                                    {color(), number(2) == 0, real(0, 1), number(2) == 0, number(2) == 0});
    case 3:
      return document::renameOrgan(anOrgan(), text);
    case 4:
      return document::addHandles(document::newHandles(places(static_cast<std::size_t>(1 + number(4)))));
    case 5:
      return document::removeHandles(someHandles());
    case 6:
      return restMove();
    case 7: {
      document::Rig rig = document::rigAt(places(12));
      rig.addGroup(text, color(), {0, 3, 5});
      return document::replaceRig(std::move(rig));
    }
    case 8:
      return document::editHandles(someHandles(),
                                   {std::nullopt, text, number(2) == 0, number(2) == 0, number(2) == 0});
    case 9:
      return document::addGroup(text, color(), someHandles());
    case 10:
      return number(4) == 0 ? document::removeGroup(aGroup())
                            : document::editGroup(aGroup(), {std::nullopt, color(), std::nullopt});
    case 11:
      return document::addToGroup(aGroup(), someHandles());
    case 12:
      return document::removeFromGroup(aGroup(), someHandles());
    case 13:
      return document::resetPose();
    case 14:
      return document::setSystem({number(2) == 0 ? "s-celestial" : "t-celestial", {}});
    case 15:
      return document::setParameter("locality", real(0, 3));
    case 16:
      return document::setVolumeLocked(anOrgan(), number(2) == 0);
    case 17:
      return document::closeHoles(anOrgan());
    case 18:
      return document::recordKey(real(0, 2.2),
                                 number(2) == 0 ? sequences::Easing::hold : sequences::Easing::smooth);
    case 19:
      return anyKeySequenceEdit();
    case 20:
    case 21:
      return number(2) == 0 ? document::addMeasurement({aPoint(), aPoint()})
                            : document::addMeasurement({aPoint(), aPoint(), aPoint()}, text);
    case 22:
      return anyMeasurementEdit(text);
    case 23:
      return anyCageEdit(text);
    case 24:
      return anyStressMark();
    default:
      return poseMove();
    }
  }

  /// A cage whose corners become the handles, one at handles that are there, or none.
  document::Command anyCageEdit(const std::string& text) {
    if (number(3) == 0)
      return document::dropCage();
    auto cage = std::make_shared<geometry::TriangleMesh>(viscera::tests::sphere(1, real(20, 90), place()));
    const Points handles = s_.document.rig().restPositions();
    if (number(2) == 0 && handles.rows() >= cage->points.rows())
      cage->points = handles.topRows(cage->points.rows());
    return document::takeCage({text, cage});
  }

  document::Command anyKeySequenceEdit() {
    document::KeySequenceEdit edit;
    edit.name = "R" + std::to_string(number(5));
    edit.periodSeconds = real(1.5, 4);
    edit.loop = number(2) == 0;
    edit.interpolation = number(2) == 0 ? sequences::Interpolation::curve : sequences::Interpolation::eased;
    return document::editKeySequence(edit);
  }

  document::MeasuredPoint aPoint() {
    document::MeasuredPoint point;
    point.rest = place();
    point.organ = number(3) == 0 ? document::OrganId{} : anOrgan();
    point.triangle = number(100);
    point.weights = {real(0, 0.5), real(0, 0.5), 0};
    point.weights[2] = 1 - point.weights[0] - point.weights[1];
    return point;
  }

  document::Command anyMeasurementEdit(const std::string& text) {
    const auto one = pick<document::MeasurementId>(
        s_.document.measurements(), [](const document::Measurement& measurement) { return measurement.id; });
    switch (number(8)) {
    case 0:
      return document::removeAllMeasurements();
    case 1:
      return document::removeMeasurements({one});
    case 2:
      return document::renameMeasurement(one, text);
    default:
      return document::moveMeasuredPoint(one, static_cast<std::size_t>(number(3)), aPoint());
    }
  }

  document::Command anyStressMark() {
    const auto one = [this] {
      return pick<document::StressProbeId>(s_.document.stressMarks().probes,
                                           [](const document::StressProbe& probe) { return probe.id; });
    };
    switch (number(6)) {
    case 0:
      return document::removeStressProbes({one()});
    case 1:
    case 2:
      return document::addStressLine(one(), one());
    default:
      return document::addStressProbe(anOrgan(), place());
    }
  }

  document::Command restMove() {
    const auto handles = someHandles();
    return document::moveRestHandles(handles, places(handles.size()));
  }
  document::Command poseMove() {
    const auto handles = someHandles();
    return document::moveHandles(handles, places(handles.size()));
  }

  Session& s_;
  std::mt19937 random_;
  int refused_ = 0;
};

} // namespace viscera::tests
