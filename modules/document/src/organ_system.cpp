#include "viscera/document/organ_system.h"

#include <cctype>

namespace viscera::document {
namespace {

/// Where a word of a name begins with one of `beginnings`, it is of that system. The first that fits counts:
/// vessels, nerves and muscles are named after what they serve, so they come before it.
struct Rule {
  std::string system;
  std::vector<std::string_view> beginnings;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {"Nervous system", {"brain", "spinal", "nerve", "cerebell", "cerebr", "optic", "eye"}},
      {"Arteries", {"arter", "aort", "trunk", "carotid"}},
      {"Veins", {"vein", "vena", "venae", "venous", "portal", "cava"}},
      {"Muscles",
       {"muscle", "musc", "gluteus", "psoas", "iliopsoas", "autochthon", "iliacus", "erector", "diaphragm"}},
      {"Heart",
       {"heart", "ventric", "atri", "myocard", "epicard", "endocard", "pericard", "mitral", "septum"}},
      {"Urinary system", {"kidney", "renal", "ureter", "urinary", "bladder", "urethra"}},
      {"Endocrine glands", {"adrenal", "suprarenal", "thyroid", "parathyroid", "pituitary"}},
      {"Lymphatic system", {"spleen", "lymph", "thymus", "tonsil"}},
      {"Respiratory system", {"lung", "trachea", "bronch", "larynx", "pleura"}},
      {"Digestive system", {"liver",   "hepat",  "gallbladder", "bile",     "biliary", "stomach", "gastr",
                            "pancrea", "duoden", "bowel",       "intestin", "jejun",   "ileum",   "colon",
                            "cecum",   "caecum", "appendix",    "rectum",   "esophag", "oesophag"}},
      {"Reproductive system",
       {"prostate", "uterus", "uterine", "ovar", "testi", "seminal", "vagina", "breast"}},
      {"Bones and joints",
       {"vertebra", "thoracic", "lumbar",  "cervical", "sacr",   "coccyx",  "disc",  "intervertebral",
        "rib",      "ribs",     "sternum", "costal",   "clavic", "scapula", "humer", "femur",
        "hip",      "pelvis",   "skull",   "cranium",  "mandib", "bone",    "tibia", "fibula"}},
      {"Skin and fat", {"skin", "body", "fat", "subcutaneous"}}};
  return all;
}

/// The name's words in small letters. Digits, separators and capitals inside ("LumbarDisc") part words.
std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  bool small = false;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalpha(byte) == 0 || (small && std::isupper(byte) != 0))
      words.emplace_back();
    if (std::isalpha(byte) != 0)
      words.back() += static_cast<char>(std::tolower(byte));
    small = std::islower(byte) != 0;
  }
  return words;
}

bool fits(const Rule& rule, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    for (const std::string_view beginning : rule.beginnings)
      if (word.rfind(beginning, 0) == 0)
        return true;
  return false;
}

} // namespace

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

const std::string& organSystem(std::string_view name) {
  const std::vector<std::string> words = wordsOf(name);
  for (const Rule& rule : rules())
    if (fits(rule, words))
      return rule.system;
  return organSystems().back();
}

} // namespace viscera::document
