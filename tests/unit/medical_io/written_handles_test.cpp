// What is written for 3D Slicer: point lists, and its older table. That the lists follow Slicer's schema is
// shown in tests/contract/schemas.
#include <bit>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/handle_file.h"

namespace viscera::medical_io {
namespace {

using tests::contentsOf;
using tests::TemporaryFolder;

HandleFile rigOfTwoGroups() {
  HandleFile rig;
  rig.groups.push_back({"Apex", {0.1, 2.0 / 3.0, 1.0}, {}});
  rig.groups[0].handles = {{"A-1", {0.1, 1.0 / 3.0, -57.000000000000007}, "left, \"upper\"", true, false},
                           {"shared", {5e-324, 1.7976931348623157e308, 1e22}, "", false, true}};
  rig.groups.push_back({"Base", {0, 0, 0}, {rig.groups[0].handles[1], {"B, 1", {1, 2, 3}, "", false, true}}});
  return rig;
}

TEST(WrittenMarkups, InRasComeBackInLps) {
  const TemporaryFolder folder;
  const HandleFile rig = rigOfTwoGroups();
  for (const char* name : {"rig.mrk.json", "rig.fcsv"}) {
    writeHandles(folder / name, rig, {.space = Space::ras});
    EXPECT_NE(contentsOf(folder / name).find("RAS"), std::string::npos);
    EXPECT_EQ(readHandles(folder / name).groups[0].handles[0].position, rig.groups[0].handles[0].position);
  }
}

TEST(WrittenFcsv, KeepsEveryBitAndEveryFieldOfAHandle) {
  const TemporaryFolder folder;
  const HandleFile rig = rigOfTwoGroups();
  writeHandles(folder / "rig.fcsv", rig);
  const HandleFile back = readHandles(folder / "rig.fcsv");
  EXPECT_THAT(inEnglish(back.warnings), testing::IsEmpty());
  ASSERT_EQ(back.groups.size(), 1u);
  const std::vector<HandleRecord> expected = {rig.groups[0].handles[0], rig.groups[0].handles[1],
                                              rig.groups[1].handles[1]};
  ASSERT_EQ(back.groups[0].handles, expected) << "the handle of both groups once";
  for (std::size_t i = 0; i < expected.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.groups[0].handles[i].position[axis]),
                std::bit_cast<std::uint64_t>(expected[i].position[axis]));
}

TEST(WrittenFcsv, ALineBreakInALabelDoesNotEndTheRow) {
  const TemporaryFolder folder;
  HandleFile rig;
  rig.groups.push_back({"G", {1, 0, 0}, {{"a\nb,\"c\"", {1, 2, 3}, "two\r\nlines", false, true}}});
  writeHandles(folder / "rig.fcsv", rig);
  EXPECT_EQ(readHandles(folder / "rig.fcsv").groups[0].handles[0],
            (HandleRecord{"a b,\"c\"", {1, 2, 3}, "two  lines", false, true}));
}

TEST(WrittenFcsv, SaysThatGroupsAreNotKept) {
  EXPECT_THAT(inEnglish(fcsvLoses(rigOfTwoGroups())), testing::ElementsAre(testing::HasSubstr("2 groups")));
  HandleFile one = rigOfTwoGroups();
  one.groups.pop_back();
  EXPECT_THAT(inEnglish(fcsvLoses(one)), testing::IsEmpty());
}

} // namespace
} // namespace viscera::medical_io
