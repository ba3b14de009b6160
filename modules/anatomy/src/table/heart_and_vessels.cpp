#include "table/organ_table.h"

namespace viscera::anatomy {
namespace {

constexpr auto kHeartSystem = "Heart", kArteries = "Arteries", kVeins = "Veins";
constexpr std::array<std::uint8_t, 3> kMuscleOfHeart = {163, 59, 51}, kArterial = {207, 58, 50},
                                      kVenous = {75, 102, 184};

void addHeart(std::vector<OrganFacts>& rows) {
  rows.push_back(
      {.id = "heart",
       .title = "Heart",
       .system = kHeartSystem,
       .color = kMuscleOfHeart,
       .snomed = "80891009",
       .volume = "heart.volume",
       .words = "heart|hearts|herz|coeur|corazon|!cor|"
                "~cardiac|~epicard*|~epi|~coronary sulcus|~heart wall|~apex cordis|~cuspis|~outflow tract"});
  rows.push_back({.id = "myocardium",
                  .title = "Myocardium",
                  .system = kHeartSystem,
                  .rank = 2,
                  .color = kMuscleOfHeart,
                  .snomed = "74281007",
                  .volume = "heart.muscle",
                  .words = "myocard*|myo|heart muscle|cardiac muscle|muscle of heart|muscle of the heart|"
                           "herzmuskel|muscle cardiaque|miocard*|musculo cardiaco|muscul cardiac|"
                           "~interventricular septum|~ventricular septum|~interatrial septum|~atrial septum|"
                           "~papillary muscle|~papillary muscles|~septum interventriculare"});
  rows.push_back({.id = "valve",
                  .title = "Heart valve",
                  .system = kHeartSystem,
                  .place = Place::anywhere,
                  .rank = 4,
                  .color = {242, 230, 199},
                  .words = "mitral|mitral valve|mitralklappe|tricuspid|tricuspid valve|trikuspidalklappe|"
                           "aortic valve|aortenklappe|pulmonary valve|pulmonic valve|pulmonalklappe|"
                           "heart valve|heart valves|herzklappe|herzklappen|valve mitrale|valve aortique|"
                           "valvula mitral|valvula aortica|valva mitralis|valva aortae"});
  rows.push_back({.id = "pericardium",
                  .title = "Pericardium",
                  .system = kHeartSystem,
                  .rank = 2,
                  .color = {224, 189, 158},
                  .snomed = "76848001",
                  .words = "pericard*|herzbeutel"});
}

void addArteries(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "aorta",
                  .title = "Aorta",
                  .system = kArteries,
                  .rank = 4,
                  .color = kArterial,
                  .snomed = "15825003",
                  .words = "aorta|aortae|aorte|hauptschlagader|~aortic arch|~aortenbogen|~arcus aortae|"
                           "~aortic root|~aortenwurzel|~ascending aorta|~descending aorta|~aorta ascendens|"
                           "~aorta descendens|~abdominal aorta|~thoracic aorta|~aorta abdominalis|"
                           "~aorta thoracica"});
  rows.push_back({.id = "pulmonary_artery",
                  .title = "Pulmonary artery",
                  .system = kArteries,
                  .place = Place::anywhere,
                  .rank = 5,
                  .color = kVenous,
                  .snomed = "81040000",
                  .words = "pulmonary artery|pulmonary arteries|pulmonary trunk|truncus pulmonalis|"
                           "arteria pulmonalis|lungenarterie|lungenarterien|artere pulmonaire|"
                           "arteres pulmonaires|arteria pulmonar|tronc pulmonaire"});
  rows.push_back({.id = "artery",
                  .title = "Artery",
                  .system = kArteries,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = kArterial,
                  .snomed = "51114001",
                  .words = "artery|arteries|arteria|arteriae|arterias|arterie|arterien|artere|arteres|"
                           "carotid|carotids|carotis|brachiocephalic trunk|brachiocephalic artery|"
                           "truncus brachiocephalicus|celiac trunk|coeliac trunk|truncus coeliacus|"
                           "leberarterie|nierenarterie|milzarterie|herzkranzgefasse|coronaries|"
                           "common carotid|subclavian artery|iliac artery"});
}

void addVeins(std::vector<OrganFacts>& rows) {
  rows.push_back({.id = "vena_cava",
                  .title = "Vena cava",
                  .system = kVeins,
                  .rank = 4,
                  .color = kVenous,
                  .words = "vena cava|venae cavae|inferior vena cava|superior vena cava|cava|ivc|svc|"
                           "vena cava inferior|vena cava superior|hohlvene|untere hohlvene|obere hohlvene|"
                           "veine cave|veine cave inferieure|veine cave superieure|vena cava inferior|"
                           "postcava"});
  rows.push_back({.id = "portal_vein",
                  .title = "Portal vein",
                  .system = kVeins,
                  .rank = 4,
                  .color = kVenous,
                  .snomed = "32764006",
                  .words = "portal vein|portal veins|vena portae|vena portae hepatis|pfortader|veine porte|"
                           "vena porta|hepatic portal vein|!portal"});
  rows.push_back({.id = "pulmonary_vein",
                  .title = "Pulmonary vein",
                  .system = kVeins,
                  .place = Place::anywhere,
                  .rank = 5,
                  .color = kArterial,
                  .snomed = "122972007",
                  .words = "pulmonary vein|pulmonary veins|vena pulmonalis|venae pulmonales|lungenvene|"
                           "lungenvenen|veine pulmonaire|veines pulmonaires|vena pulmonar|venas pulmonares|"
                           "pulmonary venous|pulmonary venous system"});
  rows.push_back({.id = "vein",
                  .title = "Vein",
                  .system = kVeins,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = kVenous,
                  .snomed = "29092000",
                  .words = "vein|veins|vena|venae|venas|venes|vene|venen|veine|veines|venous|jugular|"
                           "coronary sinus|sinus coronarius|lebervene|nierenvene|milzvene|iliac vena"});
  rows.push_back({.id = "vessel",
                  .title = "Vessel",
                  .system = kArteries,
                  .place = Place::anywhere,
                  .rank = 3,
                  .color = {150, 70, 110},
                  .snomed = "59820001",
                  .words = "vessel|vessels|blood vessel|blood vessels|blutgefass|blutgefasse|gefass|gefasse|"
                           "vaisseau|vaisseaux|vaso sanguineo|vasos sanguineos|vas sanguini|vasos sanguinis|"
                           "vasculature"});
}

} // namespace

void addHeartAndVessels(std::vector<OrganFacts>& rows) {
  addHeart(rows);
  addArteries(rows);
  addVeins(rows);
}

} // namespace viscera::anatomy
