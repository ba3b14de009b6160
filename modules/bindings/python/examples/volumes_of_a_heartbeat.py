"""The volumes of the sample heart's ventricles over one beat."""

import csv

import numpy as np
from _example import results

import viscera

try:
    beat = viscera.sequence("heartbeat", resolution="low")
except viscera.MissingPart as missing:
    print("skipped:", missing)
    raise SystemExit(77)

cavities = {name: beat.surfaces[name] for name in ("lv", "rv")}
bindings = {
    name: viscera.bind(points, beat.rest_handles, beat.system, **beat.parameters)
    for name, (points, triangles) in cavities.items()
}
rate = 75
times = np.arange(0, 60 / rate, 0.02)
volumes = {name: [] for name in cavities}
for seconds in times:
    pose = beat.pose(seconds, rate)
    for name, (points, triangles) in cavities.items():
        volumes[name].append(viscera.volume(bindings[name].pose(pose), triangles) / 1000)

with open(results() / "heartbeat.csv", "w", newline="") as file:
    table = csv.writer(file)
    table.writerow(["time_s", "lv_ml", "rv_ml"])
    table.writerows(zip(times, volumes["lv"], volumes["rv"]))
lv = volumes["lv"]
print(f"left ventricle {max(lv):.1f} to {min(lv):.1f} ml: ejection fraction {100 * (1 - min(lv) / max(lv)):.0f} %")
assert 0.4 < 1 - min(lv) / max(lv) < 0.8
