"""What pvbatch and pvpython run for paraview_test.py: an organ from files through the plugin.

pvbatch --sym in_paraview.py FOLDER ORGAN POINTS CELLS PLUGIN [HOST PORT]: prints on rank 0 the bits of the volumes and
of the stress. POINTS and CELLS, ghosts included, have to arrive: readers of ParaView 5.11 lose both, in silence, where
libexpat is too new for them.
"""

import sys

from paraview import simple

folder, organ, points, cells, plugin = sys.argv[1:6]
server = sys.argv[6:8]


def reader(name):
    kinds = {
        "vtp": simple.XMLPolyDataReader,
        "pvtp": simple.XMLPartitionedPolydataReader,
        "vtu": simple.XMLUnstructuredGridReader,
        "pvtu": simple.XMLPartitionedUnstructuredGridReader,
    }
    return kinds[name.rsplit(".", 1)[1]](FileName=[f"{folder}/{name}"])


def require_counts(proxy, points, cells):
    """Ends the run when points or cells were lost on the way, over all ranks."""
    proxy.UpdatePipeline()
    found = proxy.GetDataInformation(0)
    there = found.GetNumberOfPoints(), found.GetNumberOfCells()
    if there != (points, cells):
        print(
            f"LOST DATA: {there[0]} points and {there[1]} cells of {points} and {cells} arrived. ParaView 5.11 cannot read "
            "VTK's XML files with appended data when libexpat is newer than 2.5.0-1+deb12u1: write inline (binary) data"
        )
        sys.stdout.flush()
        sys.exit(3)


def number(proxy, name):
    proxy.UpdatePropertyInformation()  # information properties are no attributes in Python
    return float(proxy.SMProxy.GetProperty(name).GetElement(0)).hex()


if server:
    simple.Connect(server[0], int(server[1]))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())

source = reader(organ)
require_counts(source, int(points), int(cells))
rest, posed = reader("rest.vtp"), reader("posed.vtp")
results = []
for lock in (0, 1):
    deform = VisceraDeform(Input=source, RestHandles=rest, PosedHandles=posed, LockVolume=lock)  # noqa: F821
    require_counts(deform, int(points), int(cells))
    results += [number(deform, name) for name in ("Volume", "RestVolume", "VectorArea")]
stress = VisceraStress(Input=source, RestHandles=rest, PosedHandles=posed, Softness=4.0)  # noqa: F821
require_counts(stress, int(points), int(cells))
results += [number(stress, name) for name in ("MaxRotationalStress", "MeanRotationalStress")]

# Handles as ParaView's own sources: dragged in the window, set here.
box = VisceraHandles()  # noqa: F821
moved = VisceraHandles(MovedHandle=7, Displacement=[10.0, 0.0, 0.0])  # noqa: F821
bent = VisceraDeform(Input=source, RestHandles=box, PosedHandles=moved, System="t-celestial")  # noqa: F821
require_counts(bent, int(points), int(cells))
results.append(number(bent, "Volume"))
print("RESULT", *results)
sys.stdout.flush()
