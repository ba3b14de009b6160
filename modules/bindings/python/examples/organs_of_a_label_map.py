"""From voxels to organs to a pose: a label map (here made with numpy) becomes surfaces, and those follow handles."""

import numpy as np
from _example import results

import viscera

# Two balls in a volume of 2 mm voxels, as an NRRD file: a short header and the raw voxels.
grid = np.indices((40, 40, 60)).astype(float)
labels = np.zeros((40, 40, 60), np.uint8)
labels[((grid - [[[[20]]], [[[20]]], [[[16]]]]) ** 2).sum(axis=0) < 11**2] = 1
labels[((grid - [[[[20]]], [[[20]]], [[[42]]]]) ** 2).sum(axis=0) < 9**2] = 2
file = results() / "labels.nrrd"
header = ("NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 40 40 60\n"
          "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (0,0,0)\nkinds: domain domain domain\n"
          "encoding: raw\n\n")
file.write_bytes(header.encode() + labels.tobytes(order="F"))

try:
    image = viscera.read_label_map(file)
except viscera.MissingPart as missing:
    print("skipped:", missing)
    raise SystemExit(77)
organs = image.surfaces(triangles=2000)
handles = viscera.place_handles(*organs["label 1"], 20)
handles = np.vstack([handles, viscera.enclosing_handles(np.vstack([o.points for o in organs.values()]))])
pose = handles.copy()
pose[:20] += [0, 0, -5]
for segment in image.segments:
    surface = organs[segment.name]
    bound = viscera.bind(surface.points, handles)
    now = viscera.volume(bound.pose(pose), surface.triangles)
    print(f"{segment.name}: voxels {image.volume_ml(segment):.2f} ml, surface "
          f"{viscera.volume(*surface) / 1000:.2f} ml, posed {now / 1000:.2f} ml")
    assert abs(viscera.volume(*surface) / 1000 / image.volume_ml(segment) - 1) < 0.02
viscera.write_surface(results() / "organ.stl", *organs["label 1"])
