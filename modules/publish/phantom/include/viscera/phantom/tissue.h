#pragma once

#include <string>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::phantom {

/// What a tissue looks like in the images of the phantom.
struct Tissue {
  std::string name;        ///< "left ventricle"
  int label = 0;           ///< In label maps; 0: around the body.
  double hounsfield = 0;   ///< HU, of a CT with contrast medium in the arteries.
  double textureHu = 0;    ///< Deviation of the grain that moves with the tissue, HU.
  double t1Ms = 0;         ///< Relaxation times at 1.5 T, ms.
  double t2Ms = 0;         ///< See `t1Ms`.
  double protons = 0;      ///< Their density, as a part of that of water.
  double textureShare = 0; ///< Deviation of the grain in MR, as a part of the signal.
  std::string source = {}; ///< Where the relaxation times come from; "chosen" where we chose them.
  bool still = false;      ///< It does not move: chest wall and spine.
  Vec3 color = {1, 1, 1};  ///< Red green blue, 0 to 1.
};

/// All tissues by their labels, 0 to n - 1. Where two surfaces overlap, the tissue of the higher label is
/// there. HU are chosen, within what is usual.
const std::vector<Tissue>& tissues();

/// The row of that name in `tissues`. Throws `UsageError` when there is none.
const Tissue& tissueNamed(const std::string& name);

/// The signal of balanced steady-state free precession on resonance, 0 to 1000:
/// 1000 M0 sin(a) / (1 + cos(a) + (1 - cos(a)) T1 / T2) for a repetition time far below T1 and T2 (Scheffler
/// and Lehnhardt 2003, doi 10.1007/s00330-003-1957-x), with a flip angle of 60 degrees.
double steadyStateSignal(const Tissue& tissue);

} // namespace viscera::phantom
