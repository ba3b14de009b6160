#include "viscera/anatomy/organ_facts.h"

#include <algorithm>

#include "table/organ_table.h"
#include "viscera/core/error.h"

namespace viscera::anatomy {

const std::vector<OrganFacts>& organs() {
  static const std::vector<OrganFacts> rows = [] {
    std::vector<OrganFacts> all;
    addHeartAndVessels(all);
    addTrunk(all);
    addHead(all);
    addBonesAndMuscles(all);
    return all;
  }();
  return rows;
}

const OrganFacts& organ(std::string_view id) {
  const auto& rows = organs();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const OrganFacts& row) { return row.id == id; });
  if (found == rows.end())
    throw UsageError("There is no such organ in the table", std::string(id), "use the id of one of its rows");
  return *found;
}

const std::vector<std::string>& organSystems() {
  static const std::vector<std::string> names = {"Heart",
                                                 "Arteries",
                                                 "Veins",
                                                 "Respiratory system",
                                                 "Digestive system",
                                                 "Urinary system",
                                                 "Reproductive system",
                                                 "Endocrine glands",
                                                 "Lymphatic system",
                                                 "Nervous system",
                                                 "Muscles",
                                                 "Bones and joints",
                                                 "Skin and fat",
                                                 "Other"};
  return names;
}

} // namespace viscera::anatomy
