#include "viscera/document/selection.h"

#include <memory>

#include <gtest/gtest.h>

#include "session_fixture.h"

namespace viscera::document {
namespace {

using tests::Session;

TEST(Selection, IsNoPartOfTheDocument) {
  Session s;
  Selection selection(s.document);
  selection.setHandles({s.handle(1), s.handle(2)});
  EXPECT_TRUE(s.undo.isClean());
  EXPECT_FALSE(s.undo.canUndo());
  EXPECT_EQ(selection.currentHandle(), s.handle(2));
}

TEST(Selection, LosesWhatLeavesTheDocument) {
  Session s;
  s.undo.perform(addGroup("A", {1, 0, 0}, {}));
  Selection selection(s.document);
  selection.setHandles({s.handle(1), s.handle(2)});
  selection.setOrgan(s.organ());
  selection.setGroup(s.document.rig().groups[0].id);
  int news = 0;
  const Subscription subscription = selection.onChange([&news] { ++news; });
  const HandleId stays = s.handle(1);
  s.undo.perform(removeHandles({s.handle(2)}));
  EXPECT_EQ(selection.handles(), std::vector<HandleId>{stays});
  s.undo.perform(removeOrgans({s.organ()}));
  EXPECT_FALSE(selection.organ());
  s.undo.perform(removeGroup(s.document.rig().groups[0].id));
  EXPECT_FALSE(selection.group());
  EXPECT_EQ(news, 3);
}

TEST(Selection, ComesBackToAnOrganThatUndoBringsBack) {
  Session s;
  Selection selection(s.document);
  const OrganId organ = s.organ();
  selection.setOrgan(organ);
  s.undo.perform(removeOrgans({organ}));
  s.undo.undo();
  EXPECT_EQ(selection.organ(), organ);
  s.undo.redo();
  EXPECT_FALSE(selection.organ());
  selection.setOrgan({});
  s.undo.undo();
  EXPECT_FALSE(selection.organ()) << "none was selected on purpose";
}

TEST(Selection, IsUpToDateWhoeverHearsFirst) {
  Session s;
  std::unique_ptr<Selection> selection;
  std::size_t seen = 99;
  const Subscription early = s.document.onChange([&](const Change&) { seen = selection->handles().size(); });
  selection = std::make_unique<Selection>(s.document);
  selection->setHandles({s.handle(1), s.handle(2)});
  s.undo.perform(removeHandles({s.handle(2)}));
  EXPECT_EQ(seen, 1u);
}

TEST(Selection, TakesEveryHandleOnceAndOnlyThoseThereAre) {
  Session s;
  Selection selection(s.document);
  int news = 0;
  const Subscription subscription = selection.onChange([&news] { ++news; });
  selection.setHandles({s.handle(1), s.handle(1), HandleId{999}});
  EXPECT_EQ(selection.handles(), std::vector<HandleId>{s.handle(1)});
  selection.setHandles({s.handle(1)});
  EXPECT_EQ(news, 1) << "nothing changed the second time";
  selection.toggle(s.handle(4));
  selection.toggle(s.handle(1));
  EXPECT_EQ(selection.handles(), std::vector<HandleId>{s.handle(4)});
  EXPECT_TRUE(selection.contains(s.handle(4)));
  selection.clear();
  EXPECT_TRUE(selection.handles().empty());
}

} // namespace
} // namespace viscera::document
