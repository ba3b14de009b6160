#include "viscera/anatomy/body_place.h"

#include <cmath>

#include <gtest/gtest.h>

namespace viscera::anatomy {
namespace {

double sideOf(const char* name) {
  const auto place = bodyPlaceNamed(name);
  return place ? place->center.x() : 0;
}

TEST(BodyPlace, WordsWithinANameTellWhereAnOrganLies) {
  for (const char* right : {"liver", "Model_51_right_kidney", "patient7_Niere_rechts_final.stl", "foie",
                            "kidney_right.nii.gz", "Pulmo dexter", "riñón derecho", "rein droit",
                            "gallbladder", "lung_upper_lobe_right", "gluteus_maximus_right"})
    EXPECT_LT(sideOf(right), -20) << right;
  for (const char* left : {"spleen", "Milz", "03_rate", "Model_9_stomach", "femur_left", "Niere links",
                           "poumon gauche", "pulmón izquierdo", "ren sinister", "clavicula_left"})
    EXPECT_GT(sideOf(left), 20) << left;
}

TEST(BodyPlace, WhatLiesAnywhereHasNoPlace) {
  for (const char* name : {"renal artery", "skin", "liver tumour", "kidney", "left liver lobe", "label 5",
                           "fat", "hepatic vein", "", "liver and spleen"})
    EXPECT_FALSE(bodyPlaceNamed(name)) << name;
}

TEST(BodyPlace, VertebraeAndRibsLieByTheirNumbers) {
  const auto height = [](const char* name) { return bodyPlaceNamed(name)->center.z(); };
  EXPECT_EQ(height("vertebrae_L1"), 0);
  EXPECT_LT(height("vertebrae_L4"), height("Model_33_Lumbar2_vertebra"));
  EXPECT_GT(height("vertebra T5"), height("vertebrae_T12"));
  EXPECT_GT(height("vertebra C3"), height("vertebrae_T1"));
  EXPECT_GT(height("rib_left_2"), height("Model_3_rib_left_11"));
  EXPECT_GT(bodyPlaceNamed("vertebra")->spread.z(), bodyPlaceNamed("vertebrae_L3")->spread.z());
}

TEST(BodyPlace, OfAPieceOnlyTheSideIsKnown) {
  const auto piece = bodyPlaceNamed("left renal pelvis");
  ASSERT_TRUE(piece);
  EXPECT_TRUE(piece->sided());
  EXPECT_FALSE(std::isfinite(piece->spread.z()));
  EXPECT_FALSE(bodyPlaceNamed("LV")->sided()) << "a left ventricle is no left half of the body";
}

} // namespace
} // namespace viscera::anatomy
