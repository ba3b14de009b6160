#include "viscera/document/validate.h"

#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session_scene.h"
#include "viscera/core/text.h"

/// What a command accepts, a session can save, and what was saved can be read.
namespace viscera::document {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using tests::Session;
using tests::TemporaryFolder;

/// Does what nobody in his right mind does, seeded.
class Vandal {
public:
  Vandal(Session& session, unsigned seed) : s_(session), random_(seed) {}

  void act() {
    try {
      s_.undo.perform(command());
      ++accepted_;
    } catch (const Error&) {
      ++refused_;
    }
  }
  int accepted() const { return accepted_; }
  int refused() const { return refused_; }

private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }

  double value() {
    static const double values[] = {
        0,     -0.0,  1,      -1,  0.5,   1e-3, 1e308,        -1e9,
        1e300, 2e-17, 5e-324, 0.7, 37.25, -41,  std::nan(""), std::numeric_limits<double>::infinity()};
    return number(3) == 0 ? values[number(static_cast<int>(std::size(values)))] : number(2000) / 10.0 - 100;
  }
  Vec3 place() { return {value(), value(), value()}; }
  Vec3 color() { return {number(5) / 4.0, number(9) == 0 ? value() : 0.5, 1}; }
  std::string text() {
    static const char* texts[] = {
        "",  "H-2147483647",     "H-99999999999999999999", "N\xE4hte", "N\xE5hte", "a",
        "b", "\xF0\x9F\xAB\x80", "\xED\xA0\x80",           "\"\n\t\\", "H--5"};
    return texts[number(static_cast<int>(std::size(texts)))];
  }

  /// Some of these ids, now and then twice, or one that there is not.
  template <class AnyId, class List>
  std::vector<AnyId> some(const List& list) {
    std::vector<AnyId> ids;
    for (const auto& item : list)
      for (int times = number(5); times > 2; --times)
        ids.push_back(item.id);
    if (number(10) == 0)
      ids.push_back(AnyId{std::int64_t{1} << 53});
    return ids;
  }
  std::vector<HandleId> handles() { return some<HandleId>(s_.document.rig().handles); }
  template <class AnyId>
  AnyId one(std::vector<AnyId> ids) {
    return ids.empty() ? AnyId{} : ids.front();
  }
  GroupId group() { return one(some<GroupId>(s_.document.rig().groups)); }
  KeyId key() { return one(some<KeyId>(s_.document.keySequence().keys)); }
  MeasurementId measurement() { return one(some<MeasurementId>(s_.document.measurements())); }
  OrganId organ() { return s_.document.organs().empty() ? OrganId{} : s_.document.organs().front()->id; }
  Points places(std::size_t count) {
    Points points(static_cast<Eigen::Index>(count), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) = place().transpose();
    return points;
  }

  Command rigCommand() {
    std::vector<HandleId> some = handles();
    switch (number(8)) {
    case 0:
      return addHandles({{place(), std::nullopt, text(), text()}});
    case 1:
      return addHandles({{Vec3(number(99), number(99), number(99)), place()}});
    case 2:
      return moveRestHandles(some, places(some.size()));
    case 3:
      return moveHandles(some, places(some.size()));
    case 4:
      return removeHandles(some.size() > 2 ? std::vector<HandleId>{some[0]} : some);
    case 5:
      return editHandles({one(some)}, {text(), text(), false, true});
    case 6: {
      Points corners(4, 3);
      corners << 0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9;
      Rig rig = rigAt(corners);
      rig.handles[0].label = text();
      rig.addGroup(text(), color(), {0, 2});
      return replaceRig(std::move(rig));
    }
    default:
      return addGroup(text(), color(), some);
    }
  }
  Command keySequenceCommand() {
    static const double times[] = {0.5, 0.5005, 0.5012, 0.501, 1.9995, 0};
    const double seconds = number(4) == 0 ? value() : times[number(6)];
    switch (number(6)) {
    case 0:
      return editKeySequence({text(), value(), number(2) == 0});
    case 1:
      return removeKeys(some<KeyId>(s_.document.keySequence().keys));
    case 2: {
      KeySequence keySequence = s_.document.keySequence();
      keySequence.name = text();
      return replaceKeySequence(keySequence);
    }
    case 3:
      return recordKey(seconds);
    default:
      return moveKey(key(), seconds);
    }
  }
  Command organCommand() {
    NewOrgan ball = tests::ball(text(), 10 + number(20), 1);
    ball.organ.warnings = {text()};
    ball.organ.look.opacity = number(4) == 0 ? value() : 0.5;
    switch (number(4)) {
    case 0:
      return addOrgans({ball});
    case 1:
      return renameOrgan(organ(), text());
    case 2:
      return setOrganLook(organ(), {color(), true, value()});
    default:
      return s_.document.organs().size() > 3 ? removeOrgans({s_.document.organs().back()->id})
                                             : setVolumeLocked(organ(), true);
    }
  }
  Command command() {
    coordinates::ParameterValues parameters;
    parameters.set("locality", value());
    MeasuredPoint point;
    point.rest = place();
    point.organ = number(2) == 0 ? organ() : OrganId{};
    point.triangle = number(100);
    point.weights = {value(), 0.5, 0.5};
    switch (number(10)) {
    case 0:
      return setSystem({text(), parameters});
    case 1:
      return setParameter(text(), value());
    case 2:
      return addMeasurement({point, {}}, text());
    case 3:
      return number(2) == 0 ? renameMeasurement(measurement(), text())
                            : removeMeasurements(some<MeasurementId>(s_.document.measurements()));
    case 4:
      return editGroup(group(), {text(), color(), handles()});
    case 5:
    case 6:
      return keySequenceCommand();
    case 7:
      return organCommand();
    default:
      return rigCommand();
    }
  }

  Session& s_;
  std::mt19937 random_;
  int accepted_ = 0;
  int refused_ = 0;
};

class HostileCommands : public testing::TestWithParam<unsigned> {};

TEST_P(HostileCommands, LeaveAStateThatIsSavedAndReadBackToTheLastBit) {
  const TemporaryFolder folder;
  Session s;
  Vandal vandal(s, GetParam());
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < 40; ++i)
      vandal.act();
    SessionContents contents;
    contents.state = s.document.state();
    ASSERT_NO_THROW(tests::write(folder / "a.viscera", contents)) << "round " << round;
    OpenedSession opened;
    ASSERT_NO_THROW(opened = tests::readBack(folder / "a.viscera")) << "round " << round;
    ASSERT_TRUE(identical(opened.contents.state, contents.state)) << "round " << round;
  }
  EXPECT_GT(vandal.accepted(), 60);
  EXPECT_GT(vandal.refused(), 60);
}

INSTANTIATE_TEST_SUITE_P(Seeds, HostileCommands, testing::Range(1u, 13u));

TEST(Validate, TextsOfFilesBecomeUtf8AndStayApart) {
  Session s;
  s.undo.perform(
      addHandles({{Vec3(1, 2, 3), std::nullopt, "N\xE4hte"}, {Vec3(3, 2, 1), std::nullopt, "N\xE5hte"}}));
  const auto& handles = s.document.rig().handles;
  EXPECT_EQ(handles[10].label, "N\xC3\xA4hte");
  EXPECT_EQ(handles[11].label, "N\xC3\xA5hte");
  EXPECT_THROW(s.undo.perform(renameOrgan(s.organ(), "N\xE4hte")), DataError);
}

TEST(Validate, WhatHasNoNameInAFileIsGivenOne) {
  Session s;
  s.undo.perform(addOrgans({tests::ball(""), tests::ball("")}));
  EXPECT_EQ(s.document.organs()[1]->name, "Organ");
  EXPECT_EQ(s.document.organs()[2]->name, "Organ 2");
  Rig unnamed = tests::cubeRig();
  unnamed.addGroup("", {1, 0, 0}, {0, 1});
  s.undo.perform(replaceRig(unnamed));
  EXPECT_EQ(s.document.rig().groups[0].name, "Group");
  KeySequence keySequence;
  keySequence.name.clear();
  keySequence.loop = false;
  s.undo.perform(replaceKeySequence(keySequence));
  EXPECT_EQ(s.document.keySequence().name, "Recorded");
}

TEST(Validate, ALabelWithTheLargestNumberIsNotCountedOnFrom) {
  Session s;
  s.undo.perform(addHandles({{Vec3(1, 2, 3), std::nullopt, "H-2147483647"}}));
  s.undo.perform(addHandles({{Vec3(3, 2, 1)}}));
  EXPECT_EQ(s.document.rig().handles.back().label, "H-11");
}

/// What reading says after `spoil` has changed the JSON of a sound session.
std::string failureOf(const std::function<void(ordered_json&)>& spoil) {
  const TemporaryFolder folder;
  tests::write(folder / "a.viscera", tests::fullContents(folder));
  auto root = ordered_json::parse(tests::contentsOf(folder / "a.viscera"));
  spoil(root);
  try {
    tests::readBack(folder.put("bad.viscera", root.dump()));
  } catch (const DataError& error) {
    return error.what();
  }
  return "was opened";
}

TEST(Validate, RefusesDamagedFilesThatWouldMakeTheNextSaveUnreadable) {
  EXPECT_THAT(failureOf([](ordered_json& root) {
                root["rig"]["handles"][3]["rest"] = root["rig"]["handles"][4]["rest"];
              }),
              HasSubstr("at one place"));
  EXPECT_THAT(failureOf([](ordered_json& root) { root["rig"]["handles"][9]["id"] = std::int64_t{1} << 53; }),
              HasSubstr("1 to 2^52"));
  EXPECT_THAT(failureOf([](ordered_json& root) {
                root["recording"]["keys"][1]["seconds"] = root["recording"]["keys"][0]["seconds"];
              }),
              HasSubstr("behind the key before it"));
  EXPECT_THAT(failureOf([](ordered_json& root) {
                root["measurements"][0]["points"][0] = {
                    {"rest", {0, 0, 0}}, {"organ", 4711}, {"triangle", 0}, {"weights", {1, 0, 0}}};
              }),
              HasSubstr("There is no organ 4711"));
  EXPECT_EQ(failureOf([](ordered_json&) {}), "was opened");
}

TEST(Validate, TheWriterRefusesWhatTheReaderWould) {
  const TemporaryFolder folder;
  SessionContents contents = tests::fullContents(folder);
  KeySequence keySequence = *contents.state.keySequence;
  keySequence.keys.at(1).seconds = keySequence.keys.at(0).seconds;
  contents.state.keySequence = std::make_shared<const KeySequence>(keySequence);
  EXPECT_THROW(tests::write(folder / "a.viscera", contents), DataError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.viscera"));
}

TEST(Validate, ASessionThatIsLatin1IsRead) {
  const TemporaryFolder folder;
  tests::write(folder / "a.viscera", tests::fullContents(folder));
  std::string text = tests::contentsOf(folder / "a.viscera");
  const auto at = text.find("Over\xC3\xBC");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 6, "Over\xFC");
  const OpenedSession opened = tests::readBack(folder.put("latin1.viscera", text));
  EXPECT_EQ(opened.contents.state.rig->groups.at(1).name, "Over\xC3\xBC");
}

} // namespace
} // namespace viscera::document
