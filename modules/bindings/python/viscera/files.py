"""Surfaces, handles, label maps, cine studies and sample organs. Needs the part of Viscera that is built with VTK."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Sequence, Union

from numpy.typing import ArrayLike

from ._parts import part as extension
from .deformation import Progress

if TYPE_CHECKING:
    from ._files import CineStudy, Handles, LabelMap, Surface

PathLike = Union[str, "os.PathLike[str]"]


def read_surface(path: PathLike, part: str = "") -> Surface:
    """Reads STL, OBJ, PLY, OFF, VTK, VTP, GLB or GLTF by its extension, as mm in LPS.

    The result has `points` (n x 3), `triangles` (m x 3), `colors`, `name` and `warnings`, and unpacks:
    `points, triangles = read_surface(path)`. A file of several organs needs the name
    of one of them, or its number from 1, as `part`. Raises NoInputError, DataError,
    UsageError that lists the organs.
    """
    return extension("_files").read_surface(os.fspath(path), part)


def write_surface(
    path: PathLike, points: ArrayLike, triangles: ArrayLike, space: str = "LPS", name: str = ""
) -> None:
    """Writes points (n x 3, mm, LPS) and triangles (m x 3) by extension: STL, OBJ, PLY, OFF, VTK, VTP, GLB.

    `space`: the axes in the file, LPS or RAS. Nothing half-written is left. Raises CannotCreateError, DataError.
    """
    extension("_files").write_surface(os.fspath(path), points, triangles, space, name)


def repair_surface(
    points: ArrayLike, triangles: ArrayLike, repairs: Sequence[str], progress: Progress | None = None
) -> Surface:
    """Repairs a surface (n x 3 mm, m x 3) by these steps, in their order; names are those of `surface_repairs()`.

    `remove-fragments=SIZE` drops pieces below 2%, 5mm or 0.3ml, `remesh=MM` makes the surface anew with details of
    MM, `scale=FACTOR` multiplies all coordinates. `warnings` of the result says when remeshing has lost a detail.
    Raises UsageError for a repair that does not exist, DataError where it is not possible.
    """
    return extension("_files").repair_surface(points, triangles, list(repairs), progress)


def surface_repairs() -> list[str]:
    """The names of the repairs that `repair_surface` knows."""
    return extension("_files").surface_repairs()


def life_size_factor(name: str, volume_ml: float) -> float | None:
    """The `scale` that gives an organ of that name the usual volume of its kind, or None where it is not known."""
    return extension("_files").life_size_factor(name, volume_ml)


def read_handles(path: PathLike) -> Handles:
    """Reads handles from 3D Slicer's .mrk.json or .fcsv: `positions` (h x 3, mm, LPS), `labels`, `groups`."""
    return extension("_files").read_handles(os.fspath(path))


def write_handles(
    path: PathLike, positions: ArrayLike, labels: Sequence[str] = (), space: str = "LPS"
) -> None:
    """Writes handles (h x 3, mm, LPS) as .mrk.json or .fcsv, in full precision."""
    extension("_files").write_handles(os.fspath(path), positions, list(labels), space)


def read_label_map(path: PathLike, progress: Progress | None = None) -> LabelMap:
    """Reads a label map: NIfTI, NRRD, MetaImage, DICOM-SEG, or a folder with one mask an organ.

    `segments` names the organs, `layers` are the voxels (k x j x i), `surfaces()` makes closed surfaces of them.
    """
    return extension("_files").read_label_map(os.fspath(path), progress)


def cine(path: PathLike, progress: Progress | None = None) -> CineStudy:
    """Reads a cine study: a DICOM folder of one patient, or a 4D NIfTI or .seq.nrrd as a stack over time.

    `slices` are the planes, each with `images` (phases x rows x columns), `fractions` of its own cycle,
    `index_to_lps` and `plane`; `stacks` are parallel slices with their gaps in mm; `findings` say what is missing,
    damaged or left out. Raises NoInputError, DataError for two patients and for a folder without phases.
    """
    return extension("_files").cine(os.fspath(path), progress)


def sample_names() -> list[str]:
    """The organs that come with Viscera."""
    return extension("_files").sample_names()


def sample_organ(
    name: str, resolution: str = "medium", progress: Progress | None = None
) -> dict[str, Surface]:
    """A sample organ, `resolution` low, medium or high: name and surface, the outer one first.

    Made when it is first asked for (seconds), then kept on disk.
    """
    return extension("_files").sample_organ(name, resolution, progress)
