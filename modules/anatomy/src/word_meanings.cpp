#include "word_meanings.h"

#include <algorithm>
#include <unordered_map>

#include "word_list.h"

namespace viscera::anatomy {
namespace {

struct Words {
  Meaning meaning;
  std::string_view list; ///< Separated by "|"; "*" is any end of a word.
};

constexpr Words kAll[] = {
    {Meaning::left, "left|l|lt|links|linke|linker|linkes|linken|gauche|gauches|izquierdo|izquierda|izq|"
                    "esquerre|esquerra|sinister|sinistra|sinistrum|sinistri|sinistrae"},
    {Meaning::right, "right|r|rt|rechts|rechte|rechter|rechtes|rechten|droit|droite|droits|derecho|derecha|"
                     "dret|dreta|dexter|dextra|dextrum|dextri|dextrae"},
    {Meaning::noise, "the|of|and|in|der|die|das|des|den|dem|und|le|la|les|l|un|une|du|de|d|et|el|los|las|els|"
                     "del|y|i|e|stl|obj|ply|off|vtk|vtp|vtu|nii|gz|nrrd|seg|nhdr|mha|mhd|hdr|img|glb|gltf|"
                     "mrk|json|dcm|mesh|model|surface|organ|patient|label|mask|segment|segmentation|"
                     "segmented|roi|pat|case|subject|final|smooth|smoothed|copy|new|cordis|whole"},
    {Meaning::inside, "cavity|cavities|cavum|hohle|hohlraum|cavite|cavidad|cavitat|endo|endocard*|blood|pool|"
                      "bloodpool|blut|lumen"},
    {Meaning::wall, "wall|walls|wand|paroi|pared|paret|paries"},
    {Meaning::piece,
     "lobe|lobes|lobus|lobi|lappen|lobulo|lobulos|lobul|lobular|upper|lower|middle|pole|half|part|partial|"
     "piece|section|cortex|medulla|capsule|contents|calyx|apex|dome|fundus|antrum|head|tail|neck|septum|"
     "appendage|auricle|leaflet|leaflets|annulus|stump|remnant|resection|bed|fossa|hilum|outflow|tract|horn|"
     "rinde|teil|kopf|schwanz|tete|queue|cabeza|cola|caput|cauda|corpus|sinus|epi|epicard*|rim|margin|"
     "surfaces|oberlappen|unterlappen|mittellappen"},
    {Meaning::lesion,
     "tumor*|tumour*|tumeur*|lesion*|lasion*|laesion*|cyst|cysts|zyste|zysten|kyste|kystes|quiste|quistes|"
     "quist|quists|metast*|nodule|nodules|nodulo|nodulos|nodul|mass|masses|carcinom*|cancer|cancers|adenom*|"
     "hemangiom*|haemangiom*|hamangiom*|abscess*|abszess*|absces*|hematom*|haematom*|hamatom*|infarct*|"
     "infarkt*|scar|scars|narbe|edema|oedema|odem|thromb*|embol*|stone|stones|calcul*|calcif*|aneurysm*|"
     "effusion|effusions|erguss|hemorrhage|haemorrhage|bleeding|bleed|stenosis|fibrosis|necrosis|nekrose|"
     "polyp|polyps|plaque|plaques|fracture|fractures|fraktur|hernia|gtv|ctv|ptv|itv|ablation|defect|"
     "hypointens*|hyperintens*|malign*|sarcom*|lymphom*|gliom*|neoplas*|"
     "lebertumor|lebermetast*|nierentumor|nierenzyste|nierenstein|lungentumor|hirntumor"},
    {Meaning::denial,
     "no|non|not|without|outside|except|background|exclude|excluded|ohne|sans|sense|sin|kein|keine|"
     "hintergrund|fond|fondo|phantom|stent|stents|catheter|pacemaker|prosthesis|implant|implants|screw|"
     "screws|needle|electrode|lead|leads|coil|coils|clip|clips|dish|bean|beans|table|chart|rate|sound|sounds|"
     "function|capacity|dose|pressure|box|bbox|bounding|failure|attack|machine|graft|tube|burn|felt|"
     "necklace|pillow|lvad|shaped|like"}};

/// The words without and with an open end.
struct Table {
  std::unordered_map<std::string_view, Meaning> whole, begin;

  Table() {
    for (const Words& words : kAll)
      forEachWord(words.list, '|', [&](std::string_view word) {
        if (word.back() == kAnyEnd)
          begin.emplace(word.substr(0, word.size() - 1), words.meaning);
        else
          whole.emplace(word, words.meaning);
      });
  }
};

} // namespace

Meaning meaningOf(std::string_view word) {
  static const Table table;
  if (const auto found = table.whole.find(word); found != table.whole.end())
    return found->second;
  for (std::size_t length = word.size(); length >= kShortestBegin; --length)
    if (const auto found = table.begin.find(word.substr(0, length)); found != table.begin.end())
      return found->second;
  return Meaning::unknown;
}

} // namespace viscera::anatomy
