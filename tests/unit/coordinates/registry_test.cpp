#include "viscera/coordinates/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

using ::testing::HasSubstr;

/// A system that has a name and parameters, and binds nothing.
class NamedSystem final : public CoordinateSystem {
public:
  explicit NamedSystem(std::string id, std::vector<Parameter> parameters = {})
      : id_(std::move(id)), parameters_(std::move(parameters)) {}
  std::string id() const override { return id_; }
  std::string name() const override { return id_; }
  std::string summary() const override { return {}; }
  Traits traits() const override { return {}; }
  std::vector<Parameter> parameters() const override { return parameters_; }
  std::unique_ptr<Binding> bind(const HandleSet&, const Points&, const BindOptions&,
                                Progress&) const override {
    return nullptr;
  }

private:
  std::string id_;
  std::vector<Parameter> parameters_;
};

std::shared_ptr<const CoordinateSystem> named(const std::string& id) {
  return std::make_shared<NamedSystem>(id);
}

Parameter parameter(const std::string& name, double minimum, double maximum, double standard) {
  Parameter out;
  out.name = name;
  out.minimum = minimum;
  out.maximum = maximum;
  out.standard = standard;
  return out;
}

/// The message of the `UsageError` that adding throws, or nothing.
std::string refusal(Registry& registry, std::shared_ptr<const CoordinateSystem> system,
                    const std::string& source = "libthird.so") {
  try {
    registry.add(std::move(system), source);
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(Registry, FindsWhatWasAddedAndKeepsTheOrder) {
  Registry registry;
  registry.add(named("b"), "one.so");
  registry.add(named("a-2"), "two.so");
  ASSERT_EQ(registry.list().size(), 2u);
  EXPECT_EQ(registry.list()[0].system->id(), "b");
  EXPECT_EQ(registry.list()[1].source, "two.so");
  EXPECT_EQ(registry.find("a-2")->id(), "a-2");
  EXPECT_TRUE(registry.contains("b"));
  EXPECT_FALSE(registry.contains("c"));
}

TEST(Registry, SaysWhichSystemsThereAreWhenOneIsUnknown) {
  Registry registry;
  registry.add(named("first"), "x");
  registry.add(named("second"), "x");
  try {
    registry.find("third");
    FAIL() << "an unknown system was found";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("third"));
    EXPECT_THAT(error.what(), HasSubstr("first, second"));
    EXPECT_EQ(error.exitCode(), 64);
  }
}

TEST(Registry, RefusesASecondSystemOfOneIdAndNamesBothSources) {
  Registry registry;
  registry.add(named("same"), "built-in");
  const auto first = registry.find("same");
  const std::string message = refusal(registry, named("same"));
  EXPECT_THAT(message, HasSubstr("same"));
  EXPECT_THAT(message, HasSubstr("built-in"));
  EXPECT_THAT(message, HasSubstr("libthird.so"));
  EXPECT_EQ(registry.list().size(), 1u);
  EXPECT_EQ(registry.find("same"), first);
}

TEST(Registry, RefusesIdsThatCannotBeTyped) {
  for (const std::string id : {"", "S-Celestial", "s celestial", "-s", "s-", "s--t", "s/t", "s_t"}) {
    Registry registry;
    EXPECT_FALSE(refusal(registry, named(id)).empty()) << "\"" << id << "\" was taken";
    EXPECT_TRUE(registry.list().empty());
  }
}

TEST(Registry, RefusesNoSystemAndParametersThatCannotBeOffered) {
  Registry registry;
  EXPECT_THAT(refusal(registry, nullptr), HasSubstr("libthird.so"));
  const auto with = [](std::vector<Parameter> parameters) {
    return std::make_shared<NamedSystem>("x", std::move(parameters));
  };
  EXPECT_THAT(refusal(registry, with({parameter("k", 0, 1, 0), parameter("k", 0, 1, 0)})),
              HasSubstr("twice"));
  EXPECT_THAT(refusal(registry, with({parameter("k", 0, 1, 2)})), HasSubstr("range"));
  EXPECT_THAT(refusal(registry, with({parameter("k", 0, 1, std::nan(""))})), HasSubstr("range"));
  EXPECT_THAT(refusal(registry, with({parameter("", 0, 1, 0)})), HasSubstr("without a name"));
  EXPECT_TRUE(registry.list().empty());
}

TEST(Registry, HoldsTheBuiltInSystemsWithTheirSource) {
  const Registry registry = builtInRegistry();
  EXPECT_TRUE(registry.contains("s-celestial"));
  EXPECT_TRUE(registry.contains("t-celestial"));
  for (const auto& entry : registry.list())
    EXPECT_EQ(entry.source, Registry::kBuiltIn) << entry.system->id();
}

} // namespace
} // namespace viscera::coordinates
