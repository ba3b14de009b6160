"""A drag at constant volume, and a cavity that is emptied by a third while the outside keeps its volume."""

import numpy as np
from _example import kidney

import viscera

points, triangles = kidney()
handles = viscera.place_handles(points, triangles)
binding = viscera.bind(points, handles)
rest = viscera.volume(points, triangles)

pose = handles.copy()
pose[9] += [15, 5, 0]
free = binding.pose(pose)
locked = viscera.lock_volume(binding, triangles, pose)
kept = binding.pose(locked.handles)
print(f"dragged: volume {100 * (viscera.volume(free, triangles) / rest - 1):+.2f} %; locked: "
      f"{100 * (viscera.volume(kept, triangles) / rest - 1):+.1e} %, other handles moved by "
      f"{locked.largest_shift:.2f} mm at most")
assert abs(viscera.volume(kept, triangles) / rest - 1) < 1e-12

cavity = points.mean(axis=0) + 0.4 * (points - points.mean(axis=0))
inner = viscera.bind(cavity, handles)
both = viscera.VolumeLock([(binding, triangles, None), (inner, triangles, None)])
whole, hollow = both.targets
for part in [1.0, 0.9, 0.8, 0.67]:
    emptied = both.with_targets([whole, part * hollow]).restore(handles, free=range(len(handles)), limit=80)
    now = both.volumes(emptied.handles)
    print(f"cavity {now[1] / 1000:6.2f} ml, outside {now[0] / 1000:6.2f} ml, handles moved by "
          f"{emptied.largest_shift:5.2f} mm at most")
    assert np.allclose(now, [whole, part * hollow], rtol=1e-9)
