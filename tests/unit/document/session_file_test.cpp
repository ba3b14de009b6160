#include "viscera/document/session_file.h"

#include <array>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

#include "session_scene.h"
#include "starved_zlib.h"
#include "viscera/core/error.h"

namespace viscera::document {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using tests::ballFile;
using tests::fullContents;
using tests::readBack;
using tests::write;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

using Finding = SurfaceFinding::State;

ordered_json jsonOf(const std::filesystem::path& file) {
  return ordered_json::parse(contentsOf(file));
}

std::string joined(const std::vector<Text>& lines) {
  std::string all;
  for (const Text& line : lines)
    all += line.english() + "\n";
  return all;
}

TEST(SessionFile, ComesBackToTheLastBitAndIsWrittenAgainByteForByte) {
  TemporaryFolder folder;
  for (const bool embed : {false, true}) {
    SessionContents contents = fullContents(folder);
    contents.embedSurfaces = embed;
    write(folder / "a.viscera", contents);
    const OpenedSession opened = readBack(folder / "a.viscera");
    EXPECT_EQ(joined(opened.warnings), "");
    EXPECT_TRUE(identical(opened.contents.state, contents.state)) << "embedded: " << embed;
    EXPECT_EQ(opened.contents.view, contents.view);
    EXPECT_EQ(opened.contents.embedSurfaces, embed);
    write(folder / "b.viscera", opened.contents);
    EXPECT_TRUE(contentsOf(folder / "a.viscera") == contentsOf(folder / "b.viscera"));
  }
}

TEST(SessionFile, OfAnEmptyDocumentComesBackToo) {
  TemporaryFolder folder;
  write(folder / "empty.viscera", {});
  const OpenedSession opened = readBack(folder / "empty.viscera");
  EXPECT_TRUE(identical(opened.contents.state, DocumentState()));
}

class RandomSession : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSession, ComesBackToTheLastBitAndIsWrittenAgainByteForByte) {
  TemporaryFolder folder;
  tests::Session s;
  tests::Monkey monkey(s, GetParam());
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 60; ++i)
      monkey.act();
    SessionContents contents;
    contents.state = s.document.state();
    write(folder / "a.viscera", contents);
    const OpenedSession opened = readBack(folder / "a.viscera");
    ASSERT_TRUE(identical(opened.contents.state, contents.state)) << "round " << round;
    write(folder / "b.viscera", opened.contents);
    ASSERT_TRUE(contentsOf(folder / "a.viscera") == contentsOf(folder / "b.viscera")) << "round " << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSession, testing::Range(1u, 9u));

TEST(SessionFile, IdsOfRemovedHandlesThatKeysKnowAreNotGivenAgain) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  Document document;
  UndoStack undo(document);
  undo.reset(readBack(folder / "a.viscera").contents.state);
  undo.perform(addHandles(newHandles(tests::row(1, 2, 3))));
  for (const SequenceKey& key : document.keySequence().keys)
    EXPECT_EQ(key.displacements.count(document.rig().handles.back().id), 0u);
}

TEST(SessionFile, HasACageOnlyWhereOneWasGivenAndRefusesOneOfOtherHandles) {
  TemporaryFolder folder;
  SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  const ordered_json good = jsonOf(folder / "a.viscera");
  EXPECT_EQ(good["rig"]["cage"].size(), 12u);
  EXPECT_EQ(readBack(folder / "a.viscera").contents.state.rig->cage, contents.state.rig->cage);
  const std::int64_t first = good["rig"]["cage"][2][0];
  for (const auto& [triangle, problem] :
       {std::pair(ordered_json({first, 987654, first + 1}), "refers to a handle that does not exist"),
        std::pair(ordered_json({first, first + 1, first}), "a handle at two corners"),
        std::pair(ordered_json({first, first + 1}), "not a triangle of three handles")}) {
    ordered_json bad = good;
    bad["rig"]["cage"][2] = triangle;
    try {
      readBack(folder.put("bad.viscera", bad.dump()));
      ADD_FAILURE() << problem;
    } catch (const DataError& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem));
      EXPECT_THAT(error.what(), HasSubstr("cage"));
    }
  }
  Rig hull = *contents.state.rig;
  hull.cage.clear();
  contents.state.rig = std::make_shared<const Rig>(hull);
  write(folder / "hull.viscera", contents);
  EXPECT_FALSE(jsonOf(folder / "hull.viscera")["rig"].contains("cage"));
}

TEST(SessionFile, HoldsSurfacesThatWereEditedOrMadeAndNamesThoseOfFilesAndSamples) {
  TemporaryFolder folder;
  SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  const ordered_json organs = jsonOf(folder / "a.viscera").at("organs");
  EXPECT_TRUE(organs[0].contains("surface")) << "made by a program";
  EXPECT_FALSE(organs[1].contains("surface")) << "read from a file";
  EXPECT_EQ(organs[1]["source"]["file"]["relative"], "liver.vtp");
  EXPECT_EQ(organs[1]["source"]["file"]["sha256"].get<std::string>().size(), 64u);
}

TEST(SessionFile, HoldsASurfaceWhoseFileIsGoneOrChangedSinceItWasRead) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  ballFile(folder, "liver.vtp", 31);
  write(folder / "a.viscera", contents);
  EXPECT_TRUE(jsonOf(folder / "a.viscera")["organs"][1].contains("surface"));
  EXPECT_TRUE(identical(readBack(folder / "a.viscera").contents.state, contents.state));
  std::filesystem::remove(folder / "liver.vtp");
  write(folder / "a.viscera", contents);
  EXPECT_TRUE(identical(readBack(folder / "a.viscera").contents.state, contents.state));
}

TEST(SessionFile, NamesASampleOrganAndMakesItAgain) {
  TemporaryFolder folder;
  Progress progress;
  const auto liver = sample_organs::sampleOrgan(sample_organs::standardLibrary(), "liver",
                                                sample_organs::Resolution::low, progress);
  tests::Session s;
  s.undo.perform(addOrgans(organsFrom(liver)));
  SessionContents contents;
  contents.state = s.document.state();
  write(folder / "a.viscera", contents);
  const ordered_json organ = jsonOf(folder / "a.viscera")["organs"][1];
  EXPECT_EQ(organ["source"]["sample"], "liver@low");
  EXPECT_FALSE(organ.contains("surface"));
  const OpenedSession opened = readBack(folder / "a.viscera");
  EXPECT_TRUE(identical(opened.contents.state, contents.state));
  EXPECT_EQ(opened.surfaces[1].source, "sample:liver/outer@low");
  EXPECT_EQ(opened.surfaces[1].state, Finding::found);
}

TEST(SessionFile, GivesAHeartItsConductionSystemBackHoweverItIsKept) {
  TemporaryFolder folder;
  Progress progress;
  const auto heart = sample_organs::sampleOrgan(sample_organs::standardLibrary(), "heart",
                                                sample_organs::Resolution::low, progress);
  tests::Session s;
  s.undo.perform(addOrgans(organsFrom(heart)));
  for (const bool embed : {false, true}) {
    SessionContents contents;
    contents.state = s.document.state();
    contents.embedSurfaces = embed;
    write(folder / "a.viscera", contents);
    EXPECT_EQ(contentsOf(folder / "a.viscera").find("Purkinje"), std::string::npos) << "the sample has it";
    const OpenedSession opened = readBack(folder / "a.viscera");
    std::size_t ways = 0;
    ASSERT_EQ(opened.contents.state.organs->size(), contents.state.organs->size());
    for (std::size_t i = 0; i < contents.state.organs->size(); ++i) {
      EXPECT_EQ((*opened.contents.state.organs)[i]->ways, (*contents.state.organs)[i]->ways) << i;
      ways += (*opened.contents.state.organs)[i]->ways.size();
    }
    EXPECT_GT(ways, 20u) << "embedded: " << embed;
  }
}

TEST(SessionFile, FindsAnOrganThatMovedWithTheSessionOrBesideItOrUnderAnotherName) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  std::filesystem::create_directory(folder / "elsewhere");
  for (const char* name : {"liver.vtp", "patient_7.vtp"}) {
    std::filesystem::rename(folder / "liver.vtp", folder / "elsewhere" / name);
    std::filesystem::copy_file(folder / "a.viscera", folder / "elsewhere" / "a.viscera",
                               std::filesystem::copy_options::overwrite_existing);
    const OpenedSession opened = readBack(folder / "elsewhere" / "a.viscera");
    ASSERT_EQ(opened.contents.state.organs->size(), 3u) << name;
    EXPECT_EQ((*opened.contents.state.organs)[1]->file, folder / "elsewhere" / name);
    std::filesystem::rename(folder / "elsewhere" / name, folder / "liver.vtp");
  }
  // Not beside the session, but where it was.
  std::filesystem::copy_file(folder / "a.viscera", folder / "elsewhere" / "b.viscera");
  const OpenedSession opened = readBack(folder / "elsewhere" / "b.viscera");
  EXPECT_EQ(opened.surfaces[1].state, Finding::moved);
  EXPECT_THAT(joined(opened.warnings), HasSubstr("liver.vtp"));
}

TEST(SessionFile, FindsAnOrganInAFolderThatIsNamed) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  for (const char* name : {"liver.vtp", "patient_7.vtp"}) {
    const auto away = folder / "away" / "deeper";
    std::filesystem::create_directories(away);
    std::filesystem::rename(folder / "liver.vtp", away / name);
    Progress progress;
    const OpenedSession opened =
        readSession(folder / "a.viscera", sample_organs::standardLibrary(), progress, {away});
    ASSERT_EQ(opened.contents.state.organs->size(), 3u) << name;
    EXPECT_EQ((*opened.contents.state.organs)[1]->file, away / name);
    EXPECT_EQ(opened.surfaces[1].state, Finding::moved);
    EXPECT_EQ(readBack(folder / "a.viscera").surfaces[1].state, Finding::missing);
    std::filesystem::rename(away / name, folder / "liver.vtp");
  }
}

TEST(SessionFile, NamesAnOrganWhoseFileVanishedOpensTheRestAndKeepsItsRecord) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", contents);
  std::filesystem::rename(folder / "liver.vtp", folder / "liver.hidden");
  ballFile(folder, "liver.hidden2.vtp", 12);
  std::filesystem::remove(folder / "liver.hidden2.vtp");
  std::filesystem::create_directory(folder / "away");
  std::filesystem::rename(folder / "liver.hidden", folder / "away" / "liver.vtp");

  const OpenedSession opened = readBack(folder / "a.viscera");
  ASSERT_EQ(opened.contents.state.organs->size(), 2u);
  EXPECT_EQ(opened.surfaces[1].state, Finding::missing);
  EXPECT_THAT(joined(opened.warnings), HasSubstr("liver.vtp is not there any more"));
  EXPECT_FALSE((*opened.contents.state.organs)[1]->parent) << "its parent is not there";
  write(folder / "b.viscera", opened.contents);
  EXPECT_TRUE(contentsOf(folder / "a.viscera") == contentsOf(folder / "b.viscera"));

  std::filesystem::rename(folder / "away" / "liver.vtp", folder / "liver.vtp");
  const OpenedSession again = readBack(folder / "b.viscera");
  EXPECT_TRUE(identical(again.contents.state, contents.state));
}

TEST(SessionFile, StaysReadableWhenIdsOfMissingOrgansWereGivenAgainAndParentsRemoved) {
  TemporaryFolder folder;
  write(folder / "a.viscera", fullContents(folder));
  std::filesystem::remove(folder / "liver.vtp");
  OpenedSession opened = readBack(folder / "a.viscera");
  Document document;
  UndoStack undo(document);
  undo.reset(opened.contents.state);
  for (int i = 0; i < 3; ++i)
    undo.perform(addOrgans({tests::ball("New", 20, 1)}));
  undo.perform(removeOrgans({document.organs().front()->id}));
  opened.contents.state = document.state();
  opened.contents.missing.front().id = document.organs().back()->id; // As if it had been given again.
  write(folder / "b.viscera", opened.contents);
  const OpenedSession again = readBack(folder / "b.viscera");
  EXPECT_EQ(again.contents.state.organs->size(), document.organs().size());
  EXPECT_EQ(again.contents.missing.size(), 1u);
}

TEST(SessionFile, SaysThatAnOrgansFileHasChangedAndUsesIt) {
  TemporaryFolder folder;
  write(folder / "a.viscera", fullContents(folder));
  ballFile(folder, "liver.vtp", 45);
  const OpenedSession opened = readBack(folder / "a.viscera");
  EXPECT_EQ(opened.surfaces[1].state, Finding::changed);
  EXPECT_THAT(joined(opened.warnings), HasSubstr("liver.vtp has changed"));
  EXPECT_NEAR((*opened.contents.state.organs)[1]->mesh->points.row(0).norm(), 45, 1e-3);
  EXPECT_TRUE((*opened.contents.state.organs)[1]->volumeLocked);
}

/// A session whose only organ has these remarks, as written.
ordered_json sessionWithRemarks(const TemporaryFolder& folder, std::vector<Text> remarks) {
  SessionContents contents = fullContents(folder);
  auto organ = std::make_shared<Organ>(*contents.state.organs->front());
  organ->warnings = std::move(remarks);
  contents.state.organs = std::make_shared<const OrganList>(OrganList{organ});
  contents.embedSurfaces = true;
  write(folder / "remarks.viscera", contents);
  return jsonOf(folder / "remarks.viscera");
}

TEST(SessionFile, KeepsTheRemarksOnAnOrganWithTheirParts) {
  TemporaryFolder folder;
  const std::vector<Text> remarks = {
      phrase("%n {piece|pieces}, the largest of %1 ml", 2, inFixed(1.5, 1)).capitalised(),
      phrase("%1: %2", named("Liver"), listOf({std::string("a|b"), Text(), diagnostic("no %1", "end")})),
      misuse("there is no view %1", 3)};
  const ordered_json written = sessionWithRemarks(folder, remarks);
  EXPECT_EQ(written["organs"][0]["warnings"], inEnglish(remarks));
  const OpenedSession opened = readBack(folder / "remarks.viscera");
  EXPECT_EQ(joined(opened.warnings), "") << "every key is known";
  EXPECT_EQ(opened.contents.state.organs->front()->warnings, remarks);
}

TEST(SessionFile, OfAnOlderVersionHasItsRemarksInEnglish) {
  TemporaryFolder folder;
  const std::vector<Text> remarks = {phrase("%n {piece|pieces}", 2), "it has no volume"};
  ordered_json old = sessionWithRemarks(folder, remarks);
  old["organs"][0].erase("remarks");
  const OpenedSession opened = readBack(folder.put("old.viscera", old.dump()));
  EXPECT_EQ(inEnglish(opened.contents.state.organs->front()->warnings), inEnglish(remarks));
}

TEST(SessionFile, WithARemarkOfNoKnownKindIsRefused) {
  TemporaryFolder folder;
  ordered_json root = sessionWithRemarks(folder, {phrase("%n {piece|pieces}", 2)});
  const auto refusal = [&](const ordered_json& remark) {
    root["organs"][0]["remarks"][0] = remark;
    try {
      readBack(folder.put("b.viscera", root.dump()));
    } catch (const DataError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal({{"kind", "song"}, {"words", "la"}}), HasSubstr("organs[0].remarks[0]"));
  EXPECT_THAT(refusal({{"kind", "sentence"}}), HasSubstr("no text of a known kind"));
  EXPECT_THAT(refusal({{"kind", "list"}, {"parts", {1}}}), HasSubstr("remarks[0].parts[0]"));
  EXPECT_EQ(refusal({{"kind", "message"}, {"words", "%3 {"}}), "") << "a place without a part stays as it is";
}

TEST(SessionFile, ReportsKeysThatNothingIsKnownAbout) {
  TemporaryFolder folder;
  write(folder / "a.viscera", fullContents(folder));
  ordered_json root = jsonOf(folder / "a.viscera");
  root["organs"][0]["look"]["shine"] = 3;
  root["notes"] = "by hand";
  folder.put("b.viscera", root.dump());
  const OpenedSession opened = readBack(folder / "b.viscera");
  EXPECT_THAT(joined(opened.warnings), HasSubstr("\"organs[0].look.shine\""));
  EXPECT_THAT(joined(opened.warnings), HasSubstr("\"notes\""));
}

TEST(SessionFile, OfALaterVersionIsRefusedWithAdvice) {
  TemporaryFolder folder;
  write(folder / "a.viscera", {});
  ordered_json root = jsonOf(folder / "a.viscera");
  root["version"] = 3;
  try {
    readBack(folder.put("b.viscera", root.dump()));
    FAIL() << "a later version was read";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("b.viscera: It is of version 3"));
    EXPECT_THAT(error.tryThis().english(), HasSubstr("update Viscera"));
  }
}

TEST(SessionFile, CannotBeWrittenUnderAnotherEndingOrIntoNoFolder) {
  TemporaryFolder folder;
  EXPECT_THROW(write(folder / "a.json", {}), CannotCreateError);
  EXPECT_THROW(write(folder / "nowhere" / "a.viscera", {}), CannotCreateError);
  EXPECT_THROW(readBack(folder / "none.viscera"), NoInputError);
}

TEST(SessionFile, ACancelledSaveLeavesTheOldOneAndNothingElse) {
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", {});
  const std::string before = contentsOf(folder / "a.viscera");
  Progress progress;
  progress.cancel();
  EXPECT_THROW(writeSession(folder / "a.viscera", contents, progress), Cancelled);
  EXPECT_EQ(contentsOf(folder / "a.viscera"), before);
  const auto entries = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(entries, 2); // The session and the liver.
}

/// Runs `work` in a program of its own that is not the administrator's, and gives what it says.
std::string saidByAUser(const std::function<std::string()>& work) {
  constexpr unsigned kNobody = 65534;
  int ends[2];
  if (::pipe(ends) != 0)
    return "there is no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    const bool isUser = ::geteuid() != 0 || (::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 &&
                                             ::setuid(kNobody) == 0 && ::geteuid() == kNobody);
    const std::string said = isUser ? work() : "still the administrator";
    const bool told = ::write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string said;
  std::array<char, 1024> buffer;
  for (ssize_t count; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
    said.append(buffer.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? said : "the program failed";
}

TEST(SessionFile, ThatIsEmbeddedNamesNoFolder) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sent");
  SessionContents contents = fullContents(folder);
  contents.embedSurfaces = true;
  write(folder / "sent" / "a.viscera", contents);
  const std::string written = contentsOf(folder / "sent" / "a.viscera");
  EXPECT_EQ(written.find(folder.path().string()), std::string::npos);
  EXPECT_EQ(written.find(".."), std::string::npos);
  const OpenedSession opened = readBack(folder / "sent" / "a.viscera");
  EXPECT_EQ(joined(opened.warnings), "");
  int files = 0;
  for (std::size_t i = 0; i < opened.contents.state.organs->size(); ++i) {
    const Organ &was = *contents.state.organs->at(i), &is = *opened.contents.state.organs->at(i);
    if (was.file.empty() || !was.origin.sample.empty())
      continue;
    ++files;
    EXPECT_EQ(is.file, folder / "sent" / was.file.filename()) << "where it would be beside the session";
  }
  EXPECT_GT(files, 0);
  write(folder / "sent" / "b.viscera", opened.contents);
  EXPECT_TRUE(contentsOf(folder / "sent" / "b.viscera") == written);
}

TEST(SessionFile, OfAnEmbeddedSessionKeepsItsFoldersForItsOwnerToRecover) {
  TemporaryFolder folder;
  SessionContents contents = fullContents(folder);
  contents.embedSurfaces = true;
  contents.recovers = folder / "work.viscera";
  write(folder / "recovery.viscera", contents);
  EXPECT_TRUE(identical(readBack(folder / "recovery.viscera").contents.state, contents.state));
  std::filesystem::create_directory(folder / "state");
  write(folder / "state" / "recovery.viscera", contents);
  EXPECT_TRUE(identical(readBack(folder / "state" / "recovery.viscera").contents.state, contents.state));
}

TEST(SessionFile, ThatZlibCannotPackLeavesTheOldOne) {
  TemporaryFolder folder;
  SessionContents contents = fullContents(folder);
  contents.embedSurfaces = true;
  write(folder / "a.viscera", contents);
  const std::string before = contentsOf(folder / "a.viscera");
  {
    const tests::StarvedZlib starved;
    EXPECT_THROW(write(folder / "a.viscera", contents), std::bad_alloc);
  }
  EXPECT_TRUE(contentsOf(folder / "a.viscera") == before);
}

TEST(SessionFile, InAFolderThatMayNotBeWrittenToSaysSoAndLeavesTheOldOne) {
  namespace fs = std::filesystem;
  constexpr auto kReadOnly = static_cast<fs::perms>(0555);
  TemporaryFolder folder;
  const SessionContents contents = fullContents(folder);
  write(folder / "a.viscera", {});
  const std::string before = contentsOf(folder / "a.viscera");
  const auto entries = std::distance(fs::directory_iterator(folder.path()), {});
  fs::permissions(folder.path(), kReadOnly);
  const std::string said = saidByAUser([&] {
    try {
      write(folder / "a.viscera", contents);
    } catch (const CannotCreateError& error) {
      return std::string(error.what());
    }
    return std::string("it was saved");
  });
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_THAT(said, HasSubstr("a.viscera"));
  EXPECT_THAT(said, HasSubstr("cannot be written: Permission denied"));
  EXPECT_THAT(said, HasSubstr("may be written to"));
  EXPECT_EQ(contentsOf(folder / "a.viscera"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), entries);
}

} // namespace
} // namespace viscera::document
