"""vtkVisceraDeformFilter on a large surface in as many pieces as there are ranks; each rank makes its own.

PYTHONPATH=build/release/python:build/release/lib/python3/dist-packages \\
  mpirun --oversubscribe -np 4 /usr/bin/python3 tests/bench/filter_by_ranks.py 1000 2000 [drop]

About 1000 x 2000 vertices, 30 handles, one thread a rank. `drop`: the coordinates are not kept; `stress`: that too. Prints
one line of JSON: times (s; by the clock of the slowest rank, and of all processors together), memory of each rank (MiB; what
it holds with its piece, and the most that it held while the filter ran) and the bits of the volumes, the same for any number
of ranks. resources/scripts/measure_scaling.py makes the table of docs/scaling.md of such lines.
"""

import json
import sys
import time

import numpy as np
from mpi4py import MPI
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController
from viscera_vtk.vtkVisceraFilters import vtkVisceraDeformFilter, vtkVisceraStressFilter

rings, segments = int(sys.argv[1]), int(sys.argv[2])
controller = vtkMPIController()
controller.Initialize()
vtkMultiProcessController.SetGlobalController(controller)
world = MPI.COMM_WORLD
rank, ranks = world.rank, world.size


def points_of(rows):
    """Rings of the surface; those of one point at both ends are poles."""
    theta = np.pi * rows[:, None] / rings
    phi = 2 * np.pi * np.arange(segments)[None, :] / segments
    radius = 50 * (1 + 0.12 * np.sin(3 * theta) * np.cos(2 * phi) + 0.05 * np.sin(theta) * np.sin(7 * phi))
    sine = np.where((rows == 0) | (rows == rings), 0, np.sin(np.pi * rows / rings))[:, None]
    return (radius[..., None] * np.stack([sine * np.cos(phi), sine * np.sin(phi), np.cos(theta) + 0 * phi], -1)).reshape(-1, 3)


def strip(first, last):
    """The triangles between ring `first` and ring `last`; those at the poles are flat on one side and have no area."""
    a = (np.arange(last - first)[:, None] * segments + np.arange(segments)).ravel()
    b = (np.arange(last - first)[:, None] * segments + (np.arange(segments) + 1) % segments).ravel()
    return np.vstack([np.stack([a, a + segments, b + segments], 1), np.stack([a, b + segments, b], 1)])


def data_of(points, triangles=None, ghosts=None):
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(places)
    if triangles is not None:
        cells = vtkCellArray()
        cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel().astype(np.int64), deep=True))
        data.SetPolys(cells)
        marks = numpy_to_vtk(ghosts.astype(np.uint8), deep=True)
        marks.SetName("vtkGhostType")
        data.GetCellData().AddArray(marks)
    return data


def own_piece():
    """Rings of this rank, and one more on each side as ghosts."""
    first, last = rings * rank // ranks, rings * (rank + 1) // ranks
    low, high = max(first - 1, 0), min(last + 1, rings)
    triangles = strip(low, high)
    row = low + np.tile(np.repeat(np.arange(high - low), segments), 2)
    return data_of(points_of(np.arange(low, high + 1)), triangles, (row < first) | (row >= last))


def timed(job):
    """Seconds by the clock, of the slowest rank, and of processors over all ranks (waiting for others counts)."""
    world.Barrier()
    begin, used = time.perf_counter(), time.process_time()
    job.Update()
    clock, processors = time.perf_counter() - begin, time.process_time() - used
    return [round(world.allreduce(clock, MPI.MAX), 3), round(world.allreduce(processors, MPI.SUM), 3)]


def memory(name):
    """Of each rank, MiB: VmRSS is what it holds now, VmHWM the most since `forget_peak`."""
    with open("/proc/self/status") as status:
        kib = next(int(line.split()[1]) for line in status if line.startswith(name + ":"))
    return [round(each) for each in world.allgather(kib / 1024)]


def forget_peak():
    """What numpy took to make the surface is not the filter's."""
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")


random = np.random.default_rng(1)
ball = random.normal(size=(22, 3))
rest = np.vstack([70.0 * (2 * np.indices((2, 2, 2)).reshape(3, -1).T - 1), 68 * ball / np.linalg.norm(ball, axis=1)[:, None]])
pose = rest.copy()
pose[8:] += random.normal(0, 4, (22, 3)) * (np.arange(22) < 12)[:, None]

before = memory("VmRSS")
piece = own_piece()
vertices = world.allreduce(piece.GetNumberOfPoints(), MPI.SUM)
line = {"ranks": ranks, "vertices": vertices, "keep": "drop" not in sys.argv, "empty_mib": before,
        "piece_mib": memory("VmRSS")}
forget_peak()


def on(kind):
    made = kind()
    made.SetInputData(piece)
    made.SetNumberOfThreads(1)
    made.SetRestHandlesData(data_of(rest))
    made.SetPosedHandlesData(data_of(pose))
    return made


deform = on(vtkVisceraDeformFilter)
deform.SetKeepWeights("drop" not in sys.argv)
line["first_pose_s"] = timed(deform)
line["volume"] = deform.GetVolume().hex()
line["vector_area"] = deform.GetVectorArea()
deform.SetPosedHandlesData(data_of(pose + [1.0, 0, 0]))
line["another_pose_s"] = timed(deform)
line["deform_mib"] = memory("VmHWM")
if "drop" not in sys.argv:
    deform.SetPosedHandlesData(data_of(pose))
    deform.LockVolumeOn()
    line["locked_pose_s"] = timed(deform)
    line["ratio_less_1"] = deform.GetVolumeRatio() - 1
    line["locked_volume"] = deform.GetVolume().hex()
del deform
if "stress" in sys.argv:
    stress = on(vtkVisceraStressFilter)
    line["stress_s"] = timed(stress)
    line["mean_stress"] = stress.GetMeanRotationalStress().hex()
if rank == 0:
    print(json.dumps(line), flush=True)
controller.Finalize(1)
