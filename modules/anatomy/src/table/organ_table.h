#pragma once

#include <vector>

#include "viscera/anatomy/organ_facts.h"

/// The rows of the table of organs, a file for each region. Words are without accents: `nameWords` takes them
/// off. Colours are those of the sample organs where there is one; bones, vessels and nerves have those that
/// atlases give them.
namespace viscera::anatomy {

void addHeartAndVessels(std::vector<OrganFacts>& rows);
void addTrunk(std::vector<OrganFacts>& rows);
void addHead(std::vector<OrganFacts>& rows);
void addBonesAndMuscles(std::vector<OrganFacts>& rows);

} // namespace viscera::anatomy
