"""A phantom in motion: images of organs whose motion is known everywhere."""

from __future__ import annotations

import os
from typing import Any, Sequence as ListOf, Union

from ._parts import part
from .deformation import Progress
from .errors import UsageError

PathLike = Union[str, "os.PathLike[str]"]


def phantom(
    folder: PathLike,
    *,
    heartbeat: bool = False,
    breathing: bool = False,
    ejection_fraction: float = 0.58,
    rate: float = 75.0,
    modality: str = "ct",
    spacing: ListOf[float] | None = None,
    slices: ListOf[str] = (),
    noise: tuple[str, float] | None = None,
    shift_slices: float = 0.0,
    phases: int | None = None,
    fields: float = 8.0,
    over_time: bool = False,
    format: str = "nrrd",
    seed: int = 1,
    threads: int = 0,
    progress: Progress | None = None,
) -> dict[str, Any]:
    """Writes a moving phantom into a folder: images, label maps, displacement fields and their truth.

    folder     made when it is not there.
    heartbeat, breathing
               what moves; both are composed.
    ejection_fraction, rate
               of the left ventricle, 0.2 to 0.7; beats a minute, 40 to 150.
    modality   "ct", "cine" (DICOM, MR) or "labels".
    spacing    three numbers of mm along x, y and z; of a cine pixels and thickness. None: 3, 3, 3; of a cine
               1.5, 1.5, 8.
    slices     of a cine: ["sax:9,2", "lax"] for nine slices 2 mm apart across the left ventricle, and planes along it.
    noise      ("rician", 15) or ("gaussian", 20): the kind and its deviation in the image's unit.
    shift_slices
               how far each slice of a cine lies aside, mm.
    phases     images over one beat or breath; none: 20, of a cine 25.
    fields     spacing of the displacement fields, mm; 0: none are written.
    over_time  one file over time for the CT and one for the labels, not one for each phase.
    format     "nrrd" or "nifti", of volumes and fields.
    seed       of grain, noise and shifts: the same seed gives the same bytes, for any number of threads.

    Returns a dict with phases (each with time_ms, beat_fraction, inspiration, volumes_ml by tissue), files (relative to
    the folder; phantom.json describes all others), ejection_fraction with a heartbeat, and folded_ml. Needs the part of
    Viscera that is built with Qt's core. Raises UsageError, CannotCreateError, Cancelled. Seconds a phase.
    """
    if format not in ("nrrd", "nifti"):
        raise UsageError('The format is "nrrd" or "nifti"')
    cine = modality == "cine"
    wanted = (1.5, 1.5, 8.0) if cine else (3.0, 3.0, 3.0)
    sizes = wanted if spacing is None else tuple(float(size) for size in spacing)
    return part("_motion").write_phantom(
        os.fspath(folder), modality, heartbeat, breathing, ejection_fraction, rate,
        ",".join(f"{size:.9g}" for size in sizes), list(slices), "" if noise is None else f"{noise[0]}:{noise[1]:.9g}",
        shift_slices, (25 if cine else 20) if phases is None else phases, fields, over_time, format, seed, threads,
        progress,
    )
