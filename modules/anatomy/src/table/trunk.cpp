#include "table/organ_table.h"

namespace viscera::anatomy {
namespace {

constexpr auto kDigestion = "Digestive system", kBreathing = "Respiratory system",
               kUrinary = "Urinary system", kGlands = "Endocrine glands", kLymph = "Lymphatic system",
               kReproduction = "Reproductive system";
constexpr std::array<std::uint8_t, 3> kLymphoid = {68, 172, 100};

void addUpperAbdomen(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "liver",
                  .title = "Liver",
                  .system = kDigestion,
                  .place = Place::right,
                  .color = {128, 51, 41},
                  .snomed = "10200004",
                  .volume = "liver.volume",
                  .words = "liver|livers|hepar|leber|foie|higado|fetge|liver parenchyma|~caudate lobe|"
                           "~lobus caudatus|~quadrate lobe|~hepatic lobe|~hepatic segment|~liver segment|"
                           "~hepatic|~leberlappen|~lebersegment|~segment hepatique|~couinaud segment"});
  rows.push_back({.id = "gallbladder",
                  .title = "Gallbladder",
                  .system = kDigestion,
                  .place = Place::right,
                  .color = {92, 133, 64},
                  .snomed = "28231008",
                  .words = "gallbladder|gall bladder|gallenblase|vesica biliaris|vesica fellea|"
                           "vesicule biliaire|vesicula biliar|vejiga biliar|vesicula|cholecyst"});
  rows.push_back({.id = "bile_duct",
                  .title = "Bile duct",
                  .system = kDigestion,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = {115, 153, 77},
                  .words = "bile duct|bile ducts|common bile duct|hepatic duct|cystic duct|gallengang|"
                           "gallengange|biliary tree|biliary system|ductus choledochus|ductus hepaticus|"
                           "canal biliaire|voies biliaires|conducto biliar|conducte biliar|bile"});
  rows.push_back({.id = "spleen",
                  .title = "Spleen",
                  .system = kLymph,
                  .place = Place::left,
                  .color = {141, 74, 99},
                  .snomed = "78961009",
                  .volume = "spleen.volume",
                  .words = "spleen|spleens|milz|bazo|melsa|splen|~splenic|!rate|!lien"});
  rows.push_back({.id = "pancreas",
                  .title = "Pancreas",
                  .system = kDigestion,
                  .color = {224, 189, 128},
                  .snomed = "15776009",
                  .volume = "pancreas.volume",
                  .words = "pancreas|pankreas|bauchspeicheldruse|bauchspeicheldruese|pancrees|~pancreatic|"
                           "~pancreatic head|~pancreatic tail|~pancreatic body|~pankreaskopf|"
                           "~caput pancreatis|~cauda pancreatis|~corpus pancreatis|~uncinate process"});
  rows.push_back({.id = "omentum",
                  .title = "Greater omentum",
                  .system = kDigestion,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = {232, 199, 128},
                  .words = "omentum|greater omentum|omentum majus|grosses netz|grosses omentum|grand omentum|"
                           "grand epiploon|omento mayor|epiplon mayor|oment major|epiplo major"});
  rows.push_back({.id = "stomach",
                  .title = "Stomach",
                  .system = kDigestion,
                  .place = Place::left,
                  .color = {212, 128, 115},
                  .snomed = "69695003",
                  .volume = "stomach.volume",
                  .fills = true,
                  .words = "stomach|magen|estomac|estomago|gaster|~gastric|~gastric antrum|~gastric body|"
                           "~gastric fundus|~pylorus|~cardia|~magenwand|~pilor|~piloro"});
}

void addGut(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "esophagus",
                  .title = "Oesophagus",
                  .system = kDigestion,
                  .color = {204, 133, 120},
                  .snomed = "32849002",
                  .words = "esophagus|oesophagus|osophagus|speiserohre|speiseroehre|oesophage|esofago|esofag|"
                           "gullet"});
  rows.push_back({.id = "duodenum",
                  .title = "Duodenum",
                  .system = kDigestion,
                  .color = {219, 153, 128},
                  .snomed = "38848004",
                  .words = "duodenum|zwolffingerdarm|zwoelffingerdarm|duodeno|duode"});
  rows.push_back({.id = "bowel",
                  .title = "Bowel",
                  .system = kDigestion,
                  .color = {224, 168, 143},
                  .snomed = "30315005",
                  .words = "small bowel|small intestine|small intestines|bowel|bowels|intestine|intestines|"
                           "!gut|dunndarm|duenndarm|darm|intestin grele|intestin|intestins|"
                           "intestino delgado|intestino|intestinos|intesti prim|intesti|intestinum tenue|"
                           "intestinum|jejunum|ileum|leerdarm|krummdarm|jejuno|yeyuno|ileo"});
  rows.push_back(
      {.id = "colon",
       .title = "Colon",
       .system = kDigestion,
       .color = {204, 143, 128},
       .snomed = "71854001",
       .words = "colon|large bowel|large intestine|kolon|dickdarm|gros intestin|"
                "intestino grueso|intesti gros|intestinum crassum|colon transversum|"
                "~cecum|~caecum|~blinddarm|~ciego|~hepatic flexure|~splenic flexure|~sigmoid|~sigmoid colon|"
                "~ascending colon|~descending colon|~transverse colon|~wurmfortsatz|~!appendix|"
                "~vermiform appendix|~appendix vermiformis"});
  rows.push_back({.id = "rectum",
                  .title = "Rectum",
                  .system = kDigestion,
                  .color = {204, 143, 128},
                  .snomed = "34402009",
                  .words = "rectum|rektum|mastdarm|recto|recte|anorectum|anus"});
}

void addChest(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "lung",
                  .title = "Lung",
                  .system = kBreathing,
                  .place = Place::eitherSide,
                  .color = {227, 170, 169},
                  .snomed = "39607008",
                  .words =
                      "lung|lungs|lunge|lungen|lungenflugel|poumon|poumons|pulmon|pulmones|pulmo|pulmons|"
                      "~pulmonary|~lingula|~lungenlappen|~lingula of lung"});
  rows.push_back({.id = "trachea",
                  .title = "Trachea",
                  .system = kBreathing,
                  .rank = 2,
                  .color = {182, 228, 255},
                  .snomed = "44567001",
                  .words = "trachea|windpipe|luftrohre|luftroehre|trachee|traquea|airway|airways|atemwege|"
                           "lung trachea bronchia"});
  rows.push_back({.id = "bronchus",
                  .title = "Bronchus",
                  .system = kBreathing,
                  .place = Place::anywhere,
                  .rank = 2,
                  .color = {182, 228, 255},
                  .snomed = "955009",
                  .words = "bronch*|bronqui*"});
  rows.push_back({.id = "pleura",
                  .title = "Pleura",
                  .system = kBreathing,
                  .place = Place::anywhere,
                  .rank = 2,
                  .color = {224, 189, 178},
                  .snomed = "3120008",
                  .words = "pleura|pleural|brustfell|plevre|pleural cavity"});
  rows.push_back({.id = "larynx",
                  .title = "Larynx",
                  .system = kBreathing,
                  .color = {150, 208, 243},
                  .snomed = "4596009",
                  .words = "larynx|kehlkopf|laringe|~larynx air|pharynx|nasopharynx|oropharynx|hypopharynx|"
                           "rachen|faringe"});
  rows.push_back({.id = "breast",
                  .title = "Breast",
                  .system = kReproduction,
                  .place = Place::eitherSide,
                  .color = {232, 178, 160},
                  .words = "breast|breasts|mamma|mammary gland|mammary glands|brustdruse"});
  rows.push_back({.id = "thymus",
                  .title = "Thymus",
                  .system = kLymph,
                  .color = kLymphoid,
                  .snomed = "9875009",
                  .words = "thymus|timo|thymusdruse"});
  rows.push_back({.id = "lymph_node",
                  .title = "Lymph node",
                  .system = kLymph,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = kLymphoid,
                  .snomed = "59441001",
                  .words = "lymph node|lymph nodes|lymph|lymphknoten|nodus lymphaticus|ganglion lymphatique|"
                           "ganglions lymphatiques|ganglio linfatico|ganglios linfaticos|gangli limfatic|"
                           "nodi lymphatici|tonsil|tonsils"});
}

void addPelvis(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "kidney",
                  .title = "Kidney",
                  .system = kUrinary,
                  .place = Place::eitherSide,
                  .color = {176, 96, 79},
                  .snomed = "64033007",
                  .volume = "kidney.left",
                  .volumeOfRight = "kidney.right",
                  .words = "kidney|kidneys|niere|nieren|!rein|!reins|!ren|!renes|rinon|rinones|ronyo|ronyons|"
                           "~renal|~renal pelvis|~renal cortex|~renal medulla|~renal sinus|~renal calyx|"
                           "~nierenbecken|~nierenrinde|~pelvis renalis|~bassinet|~pelvis renal"});
  rows.push_back({.id = "ureter",
                  .title = "Ureter",
                  .system = kUrinary,
                  .place = Place::eitherSide,
                  .rank = 2,
                  .color = {224, 189, 122},
                  .snomed = "87953007",
                  .words = "ureter|ureters|harnleiter|uretere|ureteres|uretero"});
  rows.push_back({.id = "bladder",
                  .title = "Urinary bladder",
                  .system = kUrinary,
                  .color = {217, 179, 106},
                  .snomed = "89837001",
                  .fills = true,
                  .words = "urinary bladder|bladder|harnblase|!blase|vessie|vejiga|vejiga urinaria|bufeta|"
                           "bufeta urinaria|vesica urinaria"});
  rows.push_back({.id = "urethra",
                  .title = "Urethra",
                  .system = kUrinary,
                  .rank = 2,
                  .color = {217, 179, 106},
                  .snomed = "13648007",
                  .words = "urethra|harnrohre|harnroehre|uretre|uretra"});
  rows.push_back({.id = "prostate",
                  .title = "Prostate",
                  .system = kReproduction,
                  .color = {230, 158, 140},
                  .snomed = "41216001",
                  .words = "prostate|prostata|prostate gland|vorsteherdruse|~seminal vesicle|"
                           "~seminal vesicles|~samenblase|~vesicula seminalis"});
  rows.push_back({.id = "uterus",
                  .title = "Uterus",
                  .system = kReproduction,
                  .color = {232, 170, 158},
                  .snomed = "35039007",
                  .words = "uterus|womb|gebarmutter|gebaermutter|utero|uter|~cervix uteri|~vagina|"
                           "~endometrium"});
  rows.push_back({.id = "ovary",
                  .title = "Ovary",
                  .system = kReproduction,
                  .place = Place::eitherSide,
                  .color = {213, 141, 113},
                  .snomed = "15497006",
                  .words = "ovary|ovaries|ovarium|ovaria|eierstock|eierstocke|ovaire|ovaires|ovario|ovarios|"
                           "ovari"});
  rows.push_back(
      {.id = "testis",
       .title = "Testis",
       .system = kReproduction,
       .place = Place::eitherSide,
       .color = {193, 123, 103},
       .snomed = "40689003",
       .words = "testis|testes|testicle|testicles|hoden|testicule|testicules|testiculo|testiculos"});
}

void addGlands(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "adrenal",
                  .title = "Adrenal gland",
                  .system = kGlands,
                  .place = Place::eitherSide,
                  .rank = 2,
                  .color = {244, 186, 150},
                  .snomed = "23451007",
                  .words = "adrenal|adrenals|adrenal gland|adrenal glands|suprarenal|suprarenal gland|"
                           "suprarenal glands|nebenniere|nebennieren|surrenale|surrenales|glande surrenale|"
                           "suprarrenal|glandula suprarrenal|glandula suprarenal|glandula suprarenalis"});
  rows.push_back({.id = "thyroid",
                  .title = "Thyroid gland",
                  .system = kGlands,
                  .color = {62, 162, 114},
                  .snomed = "69748006",
                  .words = "thyroid|thyroid gland|schilddruse|schilddruese|thyroide|tiroides|tiroide|"
                           "glandula thyroidea|glandula tiroides|glande thyroide|parathyroid|"
                           "parathyroid gland"});
  rows.push_back({.id = "pituitary",
                  .title = "Pituitary gland",
                  .system = kGlands,
                  .rank = 2,
                  .color = {57, 157, 110},
                  .snomed = "56329008",
                  .words = "pituitary|pituitary gland|hypophysis|hypophyse|hipofisis|hipofisi"});
}

} // namespace

void addTrunk(std::vector<OrganFacts>& rows) {
  addUpperAbdomen(rows);
  addGut(rows);
  addChest(rows);
  addPelvis(rows);
  addGlands(rows);
}

} // namespace viscera::anatomy
