"""Frank and Starling's curve of a healthy and of a failing heart, and the loops of a narrow aortic valve, as tables."""

import csv

import numpy as np
from _example import results

import viscera

blood = np.linspace(700, 1300, 7)  # ml of stressed volume
with open(results() / "starling.csv", "w", newline="") as file:
    table = csv.writer(file)
    table.writerow(["stressed_volume_ml", "rest_edp_mmHg", "rest_sv_ml", "failing_edp_mmHg", "failing_sv_ml"])
    healthy, failing = (
        [answer["lv"] for answer in viscera.circulation_response("stressedVolume", blood, scenario)]
        for scenario in ("rest", "heart-failure-reduced-ef")
    )
    for volume, one, other in zip(blood, healthy, failing):
        table.writerow([volume, one["edp_mmHg"], one["stroke_volume_ml"], other["edp_mmHg"], other["stroke_volume_ml"]])
assert all(later["stroke_volume_ml"] > earlier["stroke_volume_ml"] for earlier, later in zip(healthy, healthy[1:]))

stenosis = viscera.circulate("aortic-stenosis")
curves = stenosis.curves
np.savetxt(results() / "stenosis.csv", np.stack([curves["lv_ml"], curves["lv_mmHg"]], axis=1), delimiter=",",
           header="lv_ml,lv_mmHg", comments="")
gap = stenosis.indices["aortic_mean_gradient_mmHg"]
print(f"stroke volume at rest {healthy[3]['sv_ml']:.0f} ml, failing {failing[3]['sv_ml']:.0f} ml; "
      f"mean gradient over the narrow valve {gap:.0f} mmHg")
assert gap > 20 and curves["lv_mmHg"].max() > curves["aorta_mmHg"].max() + gap / 2
