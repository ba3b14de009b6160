#include "table/organ_table.h"

namespace viscera::anatomy {
namespace {

constexpr auto kBones = "Bones and joints", kMuscles = "Muscles", kOuter = "Skin and fat";
constexpr std::array<std::uint8_t, 3> kBone = {233, 224, 201}, kCartilage = {185, 205, 215},
                                      kMuscle = {181, 72, 63};

/// A bone of which there are two, or many.
OrganFacts bone(std::string_view id, std::string_view title, Place place, std::string_view snomed,
                std::string_view words) {
  return {.id = id,
          .title = title,
          .system = kBones,
          .place = place,
          .rank = 3,
          .color = kBone,
          .snomed = snomed,
          .rigid = true,
          .words = words};
}

/// Ribs and sternum move in breathing, these do not.
OrganFacts still(OrganFacts row) {
  row.still = true;
  return row;
}

void addBones(std::vector<OrganFacts>& rows) {
  rows.push_back(bone("skull", "Skull", Place::middle, "89546000",
                      "skull|cranium|cranial vault|schadel|schaedel|!crane|craneo|crani|~mandib*|~maxilla|"
                      "~kiefer|~zygomatic arch|~styloid process|~hard palate|~unterkiefer|~calvaria|"
                      "~teeth|~tooth"));
  rows.push_back(still(bone("vertebra", "Vertebra", Place::middle, "51282000",
                            "vertebra*|vertebre|vertebres|spine|spinal column|backbone|vertebral column|"
                            "wirbel|wirbelkorper|wirbelsaule|lendenwirbel|brustwirbel|halswirbel|"
                            "colonne vertebrale|columna vertebral|columna vertebralis|cervical #|thoracic #|"
                            "lumbar #|cervical vertebra*|thoracic vertebra*|lumbar vertebra*|lumbar spine|"
                            "cervical spine|thoracic spine")));
  rows.push_back(still(bone("sacrum", "Sacrum", Place::middle, "54735007",
                            "sacrum|os sacrum|kreuzbein|!sacre|sacro|coccyx|steissbein|os coccygis|coccix")));
  rows.push_back(bone("rib", "Rib", Place::eitherSide, "113197003",
                      "rib|ribs|rippe|rippen|cote costale|cotes|costilla|costillas|costella|costelles|!costa|"
                      "costae|rib cage|ribcage|brustkorb"));
  rows.push_back(bone("sternum", "Sternum", Place::middle, "56873002",
                      "sternum|breastbone|brustbein|esternon|estern|manubrium|xiphoid"));
  rows.push_back(bone("clavicle", "Clavicle", Place::eitherSide, "51299004",
                      "clavicle|clavicles|clavicula|claviculae|schlusselbein|clavicule|collarbone"));
  rows.push_back(bone("scapula", "Scapula", Place::eitherSide, "79601000",
                      "scapula|scapulae|schulterblatt|omoplate|escapula|omoplato|shoulder blade"));
  rows.push_back(bone("humerus", "Humerus", Place::eitherSide, "85050009",
                      "humerus|humeri|oberarmknochen|humero|~humeral head"));
  rows.push_back(
      still(bone("hip_bone", "Hip bone", Place::eitherSide, "",
                 "hip|hips|hip bone|hip bones|hip joint|pelvic bone|os coxae|huftbein|hufte|"
                 "hueftbein|os coxal|coxal|hueso coxal|os coxal|~ilium|~ischium|~pubis|~acetabulum|"
                 "~iliac crest")));
  rows.push_back(still(
      bone("pelvis", "Pelvis", Place::middle, "", "pelvis|bony pelvis|becken|bassin osseux|beckenknochen")));
  rows.push_back(bone("femur", "Femur", Place::eitherSide, "71341001",
                      "femur|femurs|femora|oberschenkelknochen|~femoral head|~femoral neck|~caput femoris|"
                      "thigh bone|thighbone"));
  rows.push_back(bone("bone", "Bone", Place::anywhere, "272673000",
                      "bone|bones|knochen|hueso|huesos|!os|ossa|ossos|skeleton|skelett|squelette|esqueleto|"
                      "esquelet|tibia|fibula|patella|kneecap|schienbein|wadenbein|ulna|carpal|carpals|"
                      "metacarpal|metacarpals|tarsal|tarsals|metatarsal|metatarsals|phalanges|calcaneus|"
                      "talus|hyoid|patellae|kniescheibe|radius bone|temporal bone"));
  rows.push_back({.id = "disc",
                  .title = "Intervertebral disc",
                  .system = kBones,
                  .place = Place::anywhere,
                  .rank = 4,
                  .color = kCartilage,
                  .snomed = "360499006",
                  .words = "intervertebral|intervertebral disc|intervertebral discs|intervertebral disk|"
                           "vertebral disc|spinal disc|bandscheibe|bandscheiben|disque intervertebral|"
                           "disco intervertebral|disc intervertebral|discus intervertebralis"});
  rows.push_back({.id = "cartilage",
                  .title = "Cartilage",
                  .system = kBones,
                  .place = Place::anywhere,
                  .rank = 4,
                  .color = kCartilage,
                  .words = "cartilage|cartilages|costal cartilage|costal cartilages|knorpel|cartilago|"
                           "cartilag|thyroid cartilage|cricoid cartilage|meniscus|meniskus|ligament|"
                           "ligaments|ligamentum|tendon"});
}

void addMuscles(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "diaphragm",
                  .title = "Diaphragm",
                  .system = kMuscles,
                  .rank = 2,
                  .color = kMuscle,
                  .words = "diaphragm|diaphragma|diaphragme|zwerchfell|diafragma"});
  rows.push_back(
      {.id = "muscle",
       .title = "Muscle",
       .system = kMuscles,
       .place = Place::anywhere,
       .rank = 3,
       .color = kMuscle,
       .snomed = "127954009",
       .words =
           "muscle|muscles|muskel|muskeln|muskulatur|musculus|musculi|musculature|musculo|musculos|muscul|"
           "skeletal muscle|gluteus|gluteus maximus|gluteus medius|gluteus minimus|gluteal|psoas|psoas major|"
           "iliopsoas|iliacus|autochthon|erector spinae|quadratus lumborum|quadriceps|quadriceps femoris|"
           "sartorius|deltoid|trapezius|supraspinatus|infraspinatus|subscapularis|coracobrachial|"
           "pectoralis|pectoralis major|pectoralis minor|serratus anterior|latissimus dorsi|teres major|"
           "triceps|triceps brachii|biceps|biceps brachii|rectus abdominis|rectus femoris|masseter|"
           "temporalis|lateral pterygoid|medial pterygoid|digastric|sternocleidomastoid|platysma|"
           "levator scapulae|anterior scalene|middle scalene|posterior scalene|prevertebral|"
           "thigh medial compartment|thigh posterior compartment|hamstrings|superior pharyngeal "
           "constrictor"});
}

void addSkinAndFat(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "skin",
                  .title = "Skin",
                  .system = kOuter,
                  .place = Place::anywhere,
                  .color = {177, 122, 101},
                  .snomed = "39937001",
                  .words = "skin|!haut|peau|piel|pell|cutis|body surface|body contour|body trunc|body trunk|"
                           "body extremities|whole body|body outline"});
  rows.push_back({.id = "fat",
                  .title = "Fat",
                  .system = kOuter,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = {232, 207, 122},
                  .snomed = "55603005",
                  .words = "fat|fatty tissue|fett|fettgewebe|graisse|grasa|greix|adipose|adipose tissue|"
                           "subcutaneous|subcutaneous fat|torso fat|visceral fat|intermuscular fat|"
                           "epicardial fat|pericardial fat"});
}

} // namespace

void addBonesAndMuscles(std::vector<OrganFacts>& rows) {
  addBones(rows);
  addMuscles(rows);
  addSkinAndFat(rows);
}

} // namespace viscera::anatomy
