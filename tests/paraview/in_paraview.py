"""What pvbatch and pvpython run for paraview_test.py: organs from files through the plugin.

pvbatch --sym in_paraview.py FOLDER PLUGIN SERVER ORGAN=POINTS,CELLS...: prints for each organ the bits of the volumes and of
the stress. SERVER is HOST:PORT, or "none". The points and cells, ghosts included, have to arrive: readers of ParaView 5.11
lose both, in silence, where libexpat is too new for them.
"""

import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

folder, plugin, server = sys.argv[1:4]


def reader(name):
    kinds = {
        "vtp": simple.XMLPolyDataReader,
        "pvtp": simple.XMLPartitionedPolydataReader,
        "vtu": simple.XMLUnstructuredGridReader,
        "pvtu": simple.XMLPartitionedUnstructuredGridReader,
    }
    return kinds[name.rsplit(".", 1)[1]](FileName=[f"{folder}/{name}"])


def over_ranks(number):
    """The sum over the ranks of pvbatch."""
    one, sums = vtkIdTypeArray(), vtkIdTypeArray()
    one.InsertNextValue(number)
    sums.SetNumberOfValues(1)
    controller = vtkMultiProcessController.GetGlobalController()
    if controller.GetNumberOfProcesses() == 1:
        return number
    controller.AllReduce(one, sums, vtkCommunicator.SUM_OP)
    return sums.GetValue(0)


def require_counts(proxy, points, cells):
    """Ends the run when points or cells were lost on the way, over all ranks."""
    proxy.UpdatePipeline()
    if server != "none":
        found = proxy.GetDataInformation(0)
        there = found.GetNumberOfPoints(), found.GetNumberOfCells()
    else:
        here = proxy.GetClientSideObject().GetOutputDataObject(0)
        there = over_ranks(here.GetNumberOfPoints()), over_ranks(here.GetNumberOfCells())
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


def results_of(source, counts):
    """Bits of what the filters say."""
    require_counts(source, *counts)
    rest, posed = reader("rest.vtp"), reader("posed.vtp")
    results = []
    for lock in (0, 1):
        deform = VisceraDeform(Input=source, RestHandles=rest, PosedHandles=posed, LockVolume=lock)  # noqa: F821
        require_counts(deform, *counts)
        results += [number(deform, name) for name in ("Volume", "RestVolume", "VectorArea")]
    stress = VisceraStress(Input=source, RestHandles=rest, PosedHandles=posed, Softness=4.0)  # noqa: F821
    require_counts(stress, *counts)
    results += [number(stress, name) for name in ("MaxRotationalStress", "MeanRotationalStress")]

    # Handles as ParaView's own sources: dragged in the window, set here.
    box = VisceraHandles()  # noqa: F821
    moved = VisceraHandles(MovedHandle=7, Displacement=[10.0, 0.0, 0.0])  # noqa: F821
    bent = VisceraDeform(Input=source, RestHandles=box, PosedHandles=moved, System="t-celestial")  # noqa: F821
    require_counts(bent, *counts)
    return [*results, number(bent, "Volume")]


if server != "none":
    simple.Connect(server.split(":")[0], int(server.split(":")[1]))
    simple.LoadPlugin(plugin, remote=True, ns=globals())
simple.LoadPlugin(plugin, remote=False, ns=globals())
for argument in sys.argv[4:]:
    organ, counts = argument.split("=")
    results = " ".join(results_of(reader(organ), tuple(map(int, counts.split(",")))))
    sys.stdout.write(f"RESULT {organ} {results}\n")
    sys.stdout.flush()
