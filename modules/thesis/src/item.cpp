#include "viscera/thesis/item.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "figures.h"
#include "viscera/core/error.h"

namespace viscera::thesis {
namespace {

std::vector<Item> allItems() {
  std::vector<Item> items;
  for (auto* chapter : {&chapter3, &chapter4, &chapter5})
    for (Item& item : chapter())
      items.push_back(std::move(item));
  items.push_back({"2d", false, planeFigure});
  return items;
}

Result made(const Item& item, const Bench& bench, Progress& progress) {
  Result result;
  result.id = item.id;
  result.table = item.table;
  const auto start = std::chrono::steady_clock::now();
  try {
    item.make(result, bench, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    result.problem = explanationOf(error).english();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace

std::vector<Item> chosenItems(const std::vector<std::string>& names) {
  std::vector<Item> all = allItems(), chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Item& item) { return item.name() == name; });
    if (found != all.end()) {
      chosen.push_back(*found);
      continue;
    }
    std::string known;
    for (const Item& item : all)
      known += (known.empty() ? "" : ", ") + item.name();
    throw UsageError("Not a figure that can be done again", name, "there are " + known);
  }
  return names.empty() ? all : chosen;
}

std::vector<Result> makeAll(const std::vector<Item>& items, const Bench& bench, Progress& progress) {
  std::vector<Result> results;
  for (const Item& item : items) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(results.size()) / static_cast<double>(items.size()), item.name());
    Progress* running = nullptr;
    // A figure binds many times; its own fraction would run to and fro.
    Progress part([&](double, const Text&) {
      if (progress.cancelled())
        running->cancel();
    });
    running = &part;
    results.push_back(made(item, bench, part));
  }
  progress.throwIfCancelled();
  return results;
}

} // namespace viscera::thesis
