"""What one rank of ranks_test.py does: its part of an organ through the filters, and on rank 0 a line for each case.

Called as: mpirun -np N python3 one_rank.py CASE...
"""

import hashlib
import os
import sys

if "mixed" in sys.argv and os.environ.get("OMPI_COMM_WORLD_RANK") == "1":
    os.environ["VISCERA_VECTOR_BITS"] = "128"  # a rank on an older machine

import numpy as np
from mpi4py import MPI  # first, so that it initialises MPI
from organ_pieces import data_of, handles, piece_data, point_data, solid, surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController
from viscera_vtk.vtkVisceraFilters import vtkVisceraDeformFilter, vtkVisceraStressFilter

PIECES = 4

controller = vtkMPIController()
controller.Initialize()
vtkMultiProcessController.SetGlobalController(controller)
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def part_of(case, points, cells):
    """This rank's share: pieces go round the ranks as blocks, or one piece a rank, or all of it on rank 0."""
    if "serial" in case:
        return data_of(points, cells) if rank == 0 else (vtkUnstructuredGrid if "solid" in case else vtkPolyData)()
    if "blocks" in case:
        blocks = vtkMultiBlockDataSet()
        blocks.SetNumberOfBlocks(PIECES)
        for number in range(rank, PIECES, ranks):
            blocks.SetBlock(number, piece_data(points, cells, PIECES, number))
        return blocks
    return piece_data(points, cells, min(PIECES, ranks), rank)


def handle_part(case, places):
    """The handles: all on every rank, or in parts."""
    if "parts" not in case:
        return point_data(places)
    return point_data(np.array_split(places, ranks)[rank])


def leaves(data):
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    return [data.GetBlock(i) for i in range(data.GetNumberOfBlocks()) if data.GetBlock(i)]


def by_place(given, data, name=None):
    """Values by the rest points they belong to, of all ranks, each once: the order of pieces plays no part."""
    found = {}
    for before, after in zip(leaves(given), leaves(data)):
        if before.GetNumberOfPoints() == 0:
            continue
        at = vtk_to_numpy(before.GetPoints().GetData())
        values = vtk_to_numpy(after.GetPointData().GetArray(name) if name else after.GetPoints().GetData())
        for place, value in zip(at, values):
            found.setdefault(place.tobytes(), set()).add(value.tobytes())
    everything = {}
    for one in MPI.COMM_WORLD.allgather(found):
        for place, values in one.items():
            everything.setdefault(place, set()).update(values)
    assert all(len(values) == 1 for values in everything.values()), "copies of a point differ"
    text = b"".join(place + values.pop() for place, values in sorted(everything.items()))
    return hashlib.sha256(text).hexdigest()[:16], len(everything)


def filters(case, given, rest, pose):
    """The filters that are run, ready."""
    for kind, properties in (
        (vtkVisceraDeformFilter, {}),
        (vtkVisceraDeformFilter, {"LockVolume": True}),
        (vtkVisceraStressFilter, {"Softness": 4.0}),
    ):
        made = kind()
        made.SetInputData(given)
        made.SetRestHandlesData(handle_part(case, rest))
        made.SetPosedHandlesData(handle_part(case, pose))
        for name, value in properties.items():
            getattr(made, "Set" + name)(value)
        made.Update()
        yield made


def results_of(case):
    points, cells = solid() if "solid" in case else surface()
    given = part_of(case, points, cells)
    results = []
    for made in filters(case, given, *handles(points)):
        output = made.GetOutputDataObject(0)
        results.append(by_place(given, output))
        if made.IsA("vtkVisceraStressFilter"):
            results.append(by_place(given, output, "RotationalStress"))
            results += [made.GetMaxRotationalStress().hex(), made.GetMeanRotationalStress().hex()]
        else:
            posed = vtk_to_numpy(made.GetOutput(1).GetPoints().GetData())
            results += [made.GetVolume().hex(), made.GetRestVolume().hex(), made.GetUnboundPoints()]
            results.append(hashlib.sha256(posed.tobytes()).hexdigest()[:16])
    return results


def told_of_other_processors():
    """How often each rank says that the last one computes otherwise."""
    said = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(said)
    points, cells = surface()
    list(filters("surface", part_of("surface", points, cells), *handles(points)))
    vtkOutputWindow.SetInstance(None)
    return MPI.COMM_WORLD.gather(said.GetOutput().count("VISCERA_VECTOR_BITS"))


def told_of_a_failure():
    """How often each rank says what is wrong with the last one's points."""
    points, cells = surface()
    given = part_of("surface", points, cells)
    if rank == ranks - 1:
        given.GetPoints().SetPoint(5, float("nan"), 0, 0)
    said = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(said)
    list(filters("surface", given, *handles(points)))
    vtkOutputWindow.SetInstance(None)
    return MPI.COMM_WORLD.gather(said.GetOutput().count(f"rank {ranks - 1}: Point 5: Its position is not a finite number"))


for case in sys.argv[1:]:
    results = {"broken": told_of_a_failure, "mixed": told_of_other_processors}.get(case, lambda: results_of(case))()
    if rank == 0:
        print("CASE", case, *results, flush=True)
controller.Finalize(1)
