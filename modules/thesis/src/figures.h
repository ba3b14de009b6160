#pragma once

#include <vector>

#include "viscera/thesis/item.h"

/// Lists the figures and tables of the thesis by chapter, and declares those that have a source file of their
/// own, which fill `result` as `Item::make` does.
namespace viscera::thesis {

/// Attempts at cage-free coordinates, along lines.
std::vector<Item> chapter3();
/// Celestial coordinates.
std::vector<Item> chapter4();
/// Volume and stress.
std::vector<Item> chapter5();

/// Newton's method with the thesis's start, a neighbour's solution: how many neighbours are tried (4.5), and
/// how many iterations it takes (4.6).
void figure45(Result& result, const Bench& bench, Progress& progress);
void figure46(Result& result, const Bench& bench, Progress& progress);

/// The cost of binding: T- and S-Celestial on organs (4.12); C-, T- and S-Celestial along the line (4.18);
/// bounded biharmonic weights and S-Celestial on organs (4.23).
void figure412(Result& result, const Bench& bench, Progress& progress);
void figure418(Result& result, const Bench& bench, Progress& progress);
void figure423(Result& result, const Bench& bench, Progress& progress);

/// C-, T- and S-Celestial: rotation invariant, interpolating, efficient.
void table41(Result& result, const Bench& bench, Progress& progress);
/// The same beside mean value coordinates and bounded biharmonic weights.
void table42(Result& result, const Bench& bench, Progress& progress);

/// The influence of one handle in the plane, for every system that has a planar form, in a convex and in a
/// concave polygon.
void planeFigure(Result& result, const Bench& bench, Progress& progress);

} // namespace viscera::thesis
