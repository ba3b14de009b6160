#pragma once

#include "names_of_organs.h"

/// Names of the organs in ten further atlases and data sets for segmenters, as their documentation gives
/// them, with what the program makes of each.
namespace viscera::anatomy::names {

/// AMOS 2022 (abdomen, CT and MR).
constexpr Named kAmos[] = {{"spleen", "spleen"},
                           {"right kidney", "kidney right"},
                           {"left kidney", "kidney left"},
                           {"gall bladder", "gallbladder"},
                           {"esophagus", "esophagus"},
                           {"liver", "liver"},
                           {"stomach", "stomach"},
                           {"aorta", "aorta"},
                           {"postcava", "vena_cava"},
                           {"pancreas", "pancreas"},
                           {"right adrenal gland", "adrenal right"},
                           {"left adrenal gland", "adrenal left"},
                           {"duodenum", "duodenum"},
                           {"bladder", "bladder"},
                           {"prostate/uterus", ""}};

/// BTCV, beyond the cranial vault (abdomen).
constexpr Named kBtcv[] = {{"(1) spleen", "spleen"},
                           {"(2) right kidney", "kidney right"},
                           {"(3) left kidney", "kidney left"},
                           {"(4) gallbladder", "gallbladder"},
                           {"(5) esophagus", "esophagus"},
                           {"(6) liver", "liver"},
                           {"(7) stomach", "stomach"},
                           {"(8) aorta", "aorta"},
                           {"(9) inferior vena cava", "vena_cava"},
                           {"(11) pancreas", "pancreas"},
                           {"(12) right adrenal gland", "adrenal right"},
                           {"(13) left adrenal gland", "adrenal left"}};

/// CHAOS (abdomen, CT and MR).
constexpr Named kChaos[] = {{"Liver", "liver"},
                            {"Right kidney", "kidney right"},
                            {"Left kidney", "kidney left"},
                            {"Spleen", "spleen"}};

/// FLARE 2022 (abdomen).
constexpr Named kFlare[] = {{"01_Liver", "liver"},
                            {"02_Right_Kidney", "kidney right"},
                            {"03_Spleen", "spleen"},
                            {"04_Pancreas", "pancreas"},
                            {"05_Aorta", "aorta"},
                            {"06_Inferior_Vena_Cava", "vena_cava"},
                            {"07_Right_Adrenal_Gland", "adrenal right"},
                            {"08_Left_Adrenal_Gland", "adrenal left"},
                            {"09_Gallbladder", "gallbladder"},
                            {"10_Esophagus", "esophagus"},
                            {"11_Stomach", "stomach"},
                            {"12_Duodenum", "duodenum"},
                            {"13_Left_Kidney", "kidney left"},
                            {"IVC", "vena_cava"}};

/// MM-WHS (the whole heart).
constexpr Named kWholeHeart[] = {{"left ventricle blood cavity", "heart left ventricle"},
                                 {"right ventricle blood cavity", "heart right ventricle"},
                                 {"left atrium blood cavity", "heart left atrium"},
                                 {"right atrium blood cavity", "heart right atrium"},
                                 {"ascending aorta", "aorta piece"},
                                 {"pulmonary artery", "pulmonary_artery"},
                                 {"LV", "heart left ventricle"},
                                 {"RA", "heart right atrium"},
                                 {"Myo", "myocardium"}};

/// ACDC (the heart in short-axis MR).
constexpr Named kAcdc[] = {
    {"RV", "heart right ventricle"},       {"MYO", "myocardium"},
    {"LV", "heart left ventricle"},        {"RV cavity", "heart right ventricle"},
    {"LV cavity", "heart left ventricle"}, {"patient001_frame01_LV", "heart left ventricle"}};

/// SegTHOR (organs at risk in the chest).
constexpr Named kSegThor[] = {
    {"Esophagus", "esophagus"}, {"Heart", "heart"}, {"Trachea", "trachea"}, {"Aorta", "aorta"}};

/// KiTS (kidneys with tumours).
constexpr Named kKits[] = {{"kidney", "kidney"},
                           {"kidney_tumor", "kidney lesion"},
                           {"kidney_cyst", "kidney lesion"},
                           {"left_kidney", "kidney left"},
                           {"renal tumor", "kidney lesion"}};

/// VerSe (vertebrae).
constexpr Named kVerse[] = {{"vertebra C1", "vertebra"},
                            {"vertebra T13", "vertebra"},
                            {"vertebra L6", "vertebra"},
                            {"sacrum", "sacrum"}};

/// BodyParts3D, whose names are those of the Foundational Model of Anatomy, and the Visible Human.
constexpr Named kBodyParts[] = {{"FMA7197 liver", "liver"},
                                {"FMA7205_left kidney", "kidney left"},
                                {"FMA7204_right kidney", "kidney right"},
                                {"spleen", "spleen"},
                                {"upper lobe of left lung", "lung left piece"},
                                {"middle lobe of right lung", "lung right piece"},
                                {"left femur", "femur left"},
                                {"right hip bone", "hip_bone right"},
                                {"superior vena cava", "vena_cava"},
                                {"vermiform appendix", "colon piece"},
                                {"left ureter", "ureter left"},
                                {"right humerus", "humerus right"},
                                {"body of sternum", "sternum"},
                                {"fifth lumbar vertebra", "vertebra"},
                                {"left clavicle", "clavicle left"},
                                {"right scapula", "scapula right"},
                                {"wall of left ventricle", "myocardium left ventricle piece"},
                                {"VHM_left_kidney_cortex", "kidney left piece"},
                                {"VHF_Left_Kidney", "kidney left"},
                                {"VHF_Spleen", "spleen"}};

/// Z-Anatomy, which writes the side behind a dot.
constexpr Named kZAnatomy[] = {{"Kidney.l", "kidney left"},    {"Kidney.r", "kidney right"},
                               {"Femur.r", "femur right"},     {"Clavicle.l", "clavicle left"},
                               {"Scapula.r", "scapula right"}, {"Liver", "liver"},
                               {"Left lung", "lung left"},     {"Suprarenal gland.l", "adrenal left"},
                               {"Ureter.r", "ureter right"},   {"Urinary bladder", "bladder"}};

} // namespace viscera::anatomy::names
