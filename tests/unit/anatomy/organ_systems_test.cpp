#include "viscera/anatomy/organ_facts.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace viscera::anatomy {
namespace {

TEST(OrganSystems, KnowsTheNamesOfSegmentersAndAtlases) {
  const std::map<std::string, std::string> known = {{"kidney_left", "Urinary system"},
                                                    {"urinary_bladder", "Urinary system"},
                                                    {"right renal pelvis", "Urinary system"},
                                                    {"right renal artery", "Arteries"},
                                                    {"celiac trunk", "Arteries"},
                                                    {"iliac_vena_left", "Veins"},
                                                    {"portal vein and superior mesenteric vein", "Veins"},
                                                    {"heart_atrium_left", "Heart"},
                                                    {"LV myocardium", "Heart"},
                                                    {"lung_upper_lobe_left", "Respiratory system"},
                                                    {"gallbladder", "Digestive system"},
                                                    {"colon and ileum", "Digestive system"},
                                                    {"adrenal_gland_right", "Endocrine glands"},
                                                    {"Spleen", "Lymphatic system"},
                                                    {"splenic artery", "Arteries"},
                                                    {"brain", "Nervous system"},
                                                    {"spinal_cord", "Nervous system"},
                                                    {"right external oblique muscle", "Muscles"},
                                                    {"gluteus_maximus_left", "Muscles"},
                                                    {"Thoracic12", "Bones and joints"},
                                                    {"L1-T12-IntervertebralDisc", "Bones and joints"},
                                                    {"vertebrae_L3", "Bones and joints"},
                                                    {"rib_left_1", "Bones and joints"},
                                                    {"costal_cartilages", "Bones and joints"},
                                                    {"Pelvis", "Bones and joints"},
                                                    {"prostate", "Reproductive system"},
                                                    {"skin", "Skin and fat"}};
  for (const auto& [name, system] : known)
    EXPECT_EQ(systemNamed(name), system) << name;
}

/// As TotalSegmentator (brain_structures), FreeSurfer and the atlases of 3D Slicer name them.
TEST(OrganSystems, TellsTheBrainFromHipAndHeart) {
  for (const char* name : {"hippocampus",
                           "Left-Hippocampus",
                           "right amygdala",
                           "brainstem",
                           "subarachnoid_space",
                           "septum_pellucidum",
                           "cerebellum",
                           "caudate_nucleus",
                           "Left-Caudate",
                           "lentiform_nucleus",
                           "insular_cortex",
                           "internal_capsule",
                           "ventricle",
                           "central_sulcus",
                           "frontal_lobe",
                           "temporal_lobe",
                           "thalamus",
                           "left lateral ventricle",
                           "Left-Lateral-Ventricle",
                           "Left-Inf-Lat-Vent",
                           "3rd-Ventricle",
                           "4th-Ventricle",
                           "third ventricle",
                           "LateralVentricle",
                           "CSF",
                           "Left-Cerebral-White-Matter",
                           "Left-VentralDC",
                           "corpus callosum",
                           "pons",
                           "optic nerve",
                           "sympathetic trunk"})
    EXPECT_EQ(systemNamed(name), "Nervous system") << name;
  const std::map<std::string, std::string> others = {{"hip_left", "Bones and joints"},
                                                     {"left hip bone", "Bones and joints"},
                                                     {"Hips", "Bones and joints"},
                                                     {"temporal bone", "Bones and joints"},
                                                     {"left ventricle", "Heart"},
                                                     {"heart_ventricle_right", "Heart"},
                                                     {"interventricular septum", "Heart"},
                                                     {"ventricular septum", "Heart"},
                                                     {"caudate lobe", "Digestive system"},
                                                     {"lung_lower_lobe_left", "Respiratory system"},
                                                     {"middle cerebral artery", "Arteries"},
                                                     {"venous_sinuses", "Veins"}};
  for (const auto& [name, system] : others)
    EXPECT_EQ(systemNamed(name), system) << name;
}

TEST(OrganSystems, OfANameThatSaysNothingIsTheLastOne) {
  for (const char* name : {"", "label 699", "Mesh1", "Attribute", "distribution", "\xC3\xA4\xC3\xB6"})
    EXPECT_EQ(systemNamed(name), organSystems().back()) << name;
}

TEST(OrganSystems, IsOneOfTheList) {
  const auto& all = organSystems();
  EXPECT_EQ(std::count(all.begin(), all.end(), systemNamed("liver")), 1);
}

} // namespace
} // namespace viscera::anatomy
