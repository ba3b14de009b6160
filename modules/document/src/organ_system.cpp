#include "viscera/document/organ_system.h"

#include <cctype>

namespace viscera::document {
namespace {

/// A name in which words that follow each other begin with those of one of `beginnings` ("lateral ventric")
/// is of that system; a word that ends in a point has to be the whole word. The first rule that fits counts:
/// vessels, nerves and muscles are named after what they serve, so they come before it.
struct Rule {
  std::string system;
  std::vector<std::string_view> beginnings;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {"Nervous system", {"nerve", "sympathetic"}},
      {"Arteries", {"arter", "aort", "trunk", "carotid"}},
      {"Veins", {"vein", "vena", "venae", "venous", "portal", "cava"}},
      {"Digestive system", {"caudate lobe", "liver"}}, // The brain's caudate is a nucleus.
      {"Nervous system",
       {"brain", "spinal", "optic", "eye", "cerebell", "cerebr", "midbrain", "mesenceph", "dienceph",
        "telenceph", "pons.", "oblongata", "mening", "subarachn", "arachnoid", "dura.", "csf."}},
      {"Nervous system",
       {"callosum", "thalam", "hypothalam", "subthalam", "amygdal", "hippocamp", "parahippo", "putamen",
        "pallid", "accumbens", "caudate", "lentiform", "insula", "cingul", "gyrus", "gyri.", "sulcus",
        "pellucid"}},
      // The brain's ventricles are numbered or lateral, the heart's are left or right.
      {"Nervous system",
       {"lateral ventr", "lat vent", "third ventr", "rd ventr", "fourth ventr", "th ventr",
        "ventricular system"}},
      {"Nervous system",
       {"choroid plexus", "internal capsule", "white matter", "gray matter", "grey matter", "frontal lobe",
        "parietal lobe", "occipital lobe", "temporal lobe", "substantia nigra", "red nucleus",
        "ventral dc."}},
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
      {"Bones and joints", {"vertebra",       "thoracic", "lumbar", "cervical", "sacr",   "coccyx", "disc",
                            "intervertebral", "rib",      "ribs",   "sternum",  "costal", "clavic", "scapula",
                            "humer",          "femur",    "hip.",   "hips.",    "pelvis", "skull",  "cranium",
                            "mandib",         "bone",     "tibia",  "fibula"}},
      {"Skin and fat", {"skin", "body", "fat", "subcutaneous"}}};
  return all;
}

/// The name's words in small letters. Digits, separators and capitals inside ("LumbarDisc") part words.
std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  bool inside = false;
  bool small = false;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool alphabetic = std::isalpha(byte) != 0;
    if (alphabetic && (!inside || (small && std::isupper(byte) != 0)))
      words.emplace_back();
    if (alphabetic)
      words.back() += static_cast<char>(std::tolower(byte));
    inside = alphabetic;
    small = std::islower(byte) != 0;
  }
  return words;
}

/// Whether the words from `at` on begin with those of `beginning`.
bool beginsAt(const std::vector<std::string>& words, std::size_t at, std::string_view beginning) {
  for (; !beginning.empty(); ++at) {
    const std::size_t space = beginning.find(' ');
    std::string_view part = beginning.substr(0, space);
    beginning.remove_prefix(space == std::string_view::npos ? beginning.size() : space + 1);
    const bool whole = part.back() == '.';
    if (whole)
      part.remove_suffix(1);
    if (at >= words.size() || words[at].rfind(part, 0) != 0 || (whole && words[at].size() != part.size()))
      return false;
  }
  return true;
}

bool fits(const Rule& rule, const std::vector<std::string>& words) {
  for (std::size_t at = 0; at < words.size(); ++at)
    for (const std::string_view beginning : rule.beginnings)
      if (beginsAt(words, at, beginning))
        return true;
  return false;
}

/// A segmentation of the brain has one "ventricle"; the heart's have a side.
bool isVentricleAlone(const std::vector<std::string>& words) {
  return words.size() == 1 && (words[0] == "ventricle" || words[0] == "ventricles");
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
  static const std::string nervous = "Nervous system";
  const std::vector<std::string> words = wordsOf(name);
  if (isVentricleAlone(words))
    return nervous;
  for (const Rule& rule : rules())
    if (fits(rule, words))
      return rule.system;
  return organSystems().back();
}

} // namespace viscera::document
