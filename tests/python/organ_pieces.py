"""Organs whole and cut into pieces with ghost cells, as data of VTK, for the tests of the filters."""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "modules/bindings/python/examples"))
from _example import kidney  # noqa: E402

from viscera.paraview import cut  # noqa: E402

VTK_TETRA = 10


def surface(fineness: int = 1):
    """Points and triangles."""
    return kidney(30 * fineness, 40 * fineness)


def solid():
    """Points and tetrahedra: a ball of cubes, each cut into six tetrahedra, bent as the surface is."""
    n = 12
    grid = np.stack(np.meshgrid(*[np.arange(n + 1)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.arange((n + 1) ** 3).reshape([n + 1] * 3)
    cube = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    cells = []
    for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (1, 0, 2), (0, 2, 1), (2, 1, 0)):
        corner, corners = cube.copy(), []
        corners.append(number[tuple(corner.T)])
        for axis in order:
            corner[:, axis] += 1
            corners.append(number[tuple(corner.T)])
        cells.append(np.stack(corners, axis=1))
    points = 50 * (2 * grid / n - 1)
    cells = np.vstack(cells)
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    turned = np.linalg.det(edges) < 0
    cells[turned] = cells[turned][:, [0, 2, 1, 3]]
    inside = (np.linalg.norm(points[cells].mean(axis=1), axis=1) < 48)
    cells = cells[inside]
    used, cells = np.unique(cells, return_inverse=True)
    points = points[used] * [0.6, 0.5, 1.1]
    points[:, 0] -= points[:, 2] ** 2 / 150
    return points, cells.reshape(-1, 4)


def handles(points):
    """24 handles around the organ and where a pose has them; some stay at rest."""
    random = np.random.default_rng(11)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, size = (low + high) / 2, high - low
    corners = middle + 0.75 * size * (2 * np.indices((2, 2, 2)).reshape(3, -1).T - 1)
    ball = random.normal(size=(16, 3))
    rest = np.vstack([corners, middle + 0.75 * size * ball / np.linalg.norm(ball, axis=1)[:, None]])
    pose = rest.copy()
    pose[8:18] += random.normal(0, 4, (10, 3))
    return rest, pose


def data_of(points, cells, cell_ghosts=None, point_ghosts=None):
    """Polygons or a grid of tetrahedra, by the number of corners."""
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    corners = cells.shape[1]
    array = vtkCellArray()
    array.SetData(corners, numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel(), dtype=np.int64), deep=True))
    if corners == 3:
        data = vtkPolyData()
        data.SetPoints(places)
        data.SetPolys(array)
    else:
        data = vtkUnstructuredGrid()
        data.SetPoints(places)
        data.SetCells(VTK_TETRA, array)
    for ghosts, attributes in ((cell_ghosts, data.GetCellData()), (point_ghosts, data.GetPointData())):
        if ghosts is not None:
            marks = numpy_to_vtk(ghosts.astype(np.uint8), deep=True)
            marks.SetName("vtkGhostType")
            attributes.AddArray(marks)
    return data


def piece_data(points, cells, pieces, number):
    """One piece; an empty one where there are not so many."""
    if number >= pieces:
        return vtkPolyData() if cells.shape[1] == 3 else vtkUnstructuredGrid()
    rows, own, cell_ghosts, point_ghosts = cut(points, cells, pieces)[number]
    return data_of(points[rows], own, cell_ghosts, point_ghosts)


def point_data(points):
    """Points without cells: handles."""
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(places)
    return data
