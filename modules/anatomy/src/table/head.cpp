#include "table/organ_table.h"

namespace viscera::anatomy {
namespace {

constexpr auto kNervous = "Nervous system";
constexpr std::array<std::uint8_t, 3> kNerve = {244, 214, 49};

} // namespace

void addHead(std::vector<OrganFacts>& rows) {
  rows.push_back(
      {.id = "brain",
       .title = "Brain",
       .system = kNervous,
       .color = {227, 196, 184},
       .snomed = "12738006",
       .words =
           "brain|brains|gehirn|hirn|cerveau|encephale|cerebro|encefalo|cervell|encefal|encephalon|"
           "~cerebrum|~cerebell*|~cerebral|~kleinhirn|~grosshirn|~cervelet|~brainstem|~brain stem|~hirnstamm|"
           "~midbrain|~mesenceph*|~dienceph*|~telenceph*|~pons|~medulla oblongata|~oblongata|~mening*|"
           "~subarachn*|~arachnoid*|~dura|~dura mater|~csf|~callosum|~corpus callosum|~thalam*|"
           "~hypothalam*|~subthalam*|~amygdal*|~hippocamp*|~parahippo*|~putamen|~pallid*|~globus pallidus|"
           "~accumbens|~caudate|~caudate nucleus|~lentiform*|~insula|~insular*|~cingul*|~gyrus|~gyri|"
           "~sulcus|~pellucid*|~septum pellucid*|~lateral ventricle*|~lat vent*|~inf lat vent*|"
           "~third ventricle|~rd ventricle|~fourth ventricle|~th ventricle|~ventricular system|"
           "~ventricle frontal horn|~ventricle occipital horn|~ventricle temporal horn|~ventricle body|"
           "~choroid plexus|~internal capsule|~white matter|~gray matter|~grey matter|~frontal lobe|"
           "~parietal lobe|~occipital lobe|~temporal lobe|~substantia nigra|~red nucleus|~ventral dc|"
           "~frontallappen|~lobe frontal|~lobulo frontal"});
  rows.push_back({.id = "spinal_cord",
                  .title = "Spinal cord",
                  .system = kNervous,
                  .rank = 3,
                  .color = kNerve,
                  .snomed = "2748008",
                  .words = "spinal cord|spinal canal|ruckenmark|rueckenmark|moelle epiniere|"
                           "medula espinal|medulla espinal|medulla spinalis|myelon|cauda equina"});
  rows.push_back({.id = "nerve",
                  .title = "Nerve",
                  .system = kNervous,
                  .place = Place::anywhere,
                  .rank = 4,
                  .color = kNerve,
                  .snomed = "3057000",
                  .words = "nerve|nerves|nerv|nerven|nerf|nerfs|nervio|nervios|nervi|nervis|nervus|"
                           "sympathetic trunk|truncus sympathicus|brachial plexus|optic chiasm|sehnerv|"
                           "optic tract"});
  rows.push_back({.id = "eye",
                  .title = "Eye",
                  .system = kNervous,
                  .place = Place::eitherSide,
                  .color = {235, 235, 230},
                  .snomed = "81745001",
                  .words = "eye|eyes|eyeball|auge|augen|augapfel|oeil|yeux|ojo|ojos|ull|ulls|oculus|"
                           "bulbus oculi|~eye lens|~retina|~cornea|~optic disc"});
  rows.push_back({.id = "salivary_gland",
                  .title = "Salivary gland",
                  .system = "Digestive system",
                  .place = Place::eitherSide,
                  .rank = 2,
                  .color = {222, 178, 130},
                  .words = "parotid|parotid gland|parotis|submandibular gland|sublingual gland|"
                           "salivary gland|salivary glands|speicheldruse|glandula parotidea|"
                           "glandula parotida|glande parotide|glandula submandibularis"});
  rows.push_back({.id = "tongue",
                  .title = "Tongue",
                  .system = "Digestive system",
                  .color = {197, 110, 100},
                  .snomed = "21974007",
                  .words = "tongue|zunge|langue|lengua|llengua|lingua"});
}

} // namespace viscera::anatomy
