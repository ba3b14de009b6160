"""Sequences: poses of handles over time, ready ones and those of patients."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Sequence as ListOf, Union

import numpy as np
from numpy.typing import ArrayLike

from ._core import Sequence
from ._parts import part
from .deformation import Progress
from .errors import UsageError

if TYPE_CHECKING:
    from ._motion import CineMotion, PatientMotion

PathLike = Union[str, "os.PathLike[str]"]


def sequence(
    name: PathLike,
    points: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    landmarks: Mapping[str, ArrayLike] | None = None,
    resolution: str = "medium",
    progress: Progress | None = None,
) -> Sequence:
    """A sequence that comes with Viscera ("heartbeat", "peristalsis", "breathing"), or a .sequence.json file.

    Without `points` it moves its sample organ, whose surfaces are in `.surfaces`. With the `points` (n x 3, mm, LPS)
    and `triangles` (m x 3) of an organ it is fitted to that; `landmarks` names places on it (3, or k x 3, mm), those
    that are missing are found by the shape. A file's surfaces are in `.surfaces` where it holds them. Bind to `.rest_handles` by `.system` with `.parameters`.

    Needs the part of Viscera that is built with Qt's core.
    """
    motion = part("_motion")
    text = os.fspath(name)
    if text.endswith(".sequence.json"):
        return motion.sequence_of_file(text)
    if points is None and triangles is None:
        if landmarks:
            raise UsageError("Landmarks are for an organ of your own (give points and triangles too)")
        return motion.ready_sequence(text, resolution, progress)
    if points is None or triangles is None:
        raise UsageError("An organ has points and triangles (give both)")
    places = {role: list(np.atleast_2d(np.asarray(at, dtype=float))) for role, at in (landmarks or {}).items()}
    return motion.fitted_sequence(text, points, triangles, places, progress)


def sequence_names() -> ListOf[str]:
    """The sequences that come with Viscera."""
    return part("_motion").sequence_names()


def _correction(given: Mapping[str, Any]) -> tuple[int, int | None, int | None, str, ArrayLike]:
    unknown = set(given) - {"phase", "slice", "series", "surface", "points_mm"}
    if unknown or "phase" not in given or "points_mm" not in given:
        raise UsageError(
            "A corrected contour has a phase and points_mm, and may have slice, series and surface "
            f"(it has {', '.join(sorted(given))})"
        )
    points = np.asarray(given["points_mm"], dtype=float)
    if given["phase"] < 0 or points.ndim != 2 or points.shape[1] != 3:
        raise UsageError("A corrected contour has a phase from 0 and points_mm, k x 3")
    return given["phase"], given.get("slice"), given.get("series"), given.get("surface", ""), points


def _track_images(
    images: PathLike,
    phases: Mapping[int, PathLike | ListOf[PathLike]],
    named: ListOf[tuple[str, ListOf[str]]],
    handles: int | None,
    rig: ArrayLike | None,
    period: float | None,
    leave_out_series: ListOf[int],
    corrections: ListOf[Mapping[str, Any]],
    keep_volumes: bool,
    threads: int,
    progress: Progress | None,
) -> CineMotion:
    labels = []
    for phase, files in phases.items():
        if phase < 0:
            raise UsageError("Labelled phases are counted from 0")
        one = isinstance(files, (str, os.PathLike))
        labels.append((phase, [os.fspath(file) for file in ([files] if one else files)]))
    return part("_motion").track_images(
        os.fspath(images), labels, named, handles or 0, rig, period, list(leave_out_series),
        [_correction(each) for each in corrections], keep_volumes, threads, progress,
    )


def track(
    phases: PathLike | ListOf[PathLike] | Mapping[int, PathLike | ListOf[PathLike]],
    surfaces: Mapping[str, ListOf[str | int]] | None = None,
    *,
    images: PathLike | None = None,
    leave_out_series: ListOf[int] = (),
    corrections: ListOf[Mapping[str, Any]] = (),
    handles: int | None = None,
    rig: ArrayLike | None = None,
    period: float | None = None,
    times: ListOf[float] = (),
    leave_out: ListOf[int] = (),
    loop: bool = True,
    keep_volumes: bool = True,
    smoothing: float | None = None,
    robust: float = 0.0,
    threads: int = 0,
    progress: Progress | None = None,
) -> PatientMotion | CineMotion:
    """A patient's own motion: one rig of handles, and its pose in every phase of a series.

    phases        surfaces or label maps (files), one a phase, a folder of them, a 4D NIfTI or a .seq.nrrd. Several
                  surfaces a phase are told by their files' names without the last number.
    surfaces      of label maps: name and labels (names or values) of each; the outer one has those of its cavities too:
                  {"LV": [1], "RV": [2], "EPI": [1, 2, 3]}. None: the only label, or those of a heart.
    images        cine images of a whole cycle (a DICOM folder, a 4D NIfTI, a .seq.nrrd); `phases` are then the labelled
                  ones, two or more, counted from 0: {0: "ed.nrrd", 9: "es.nrrd"}, each a label map, a surface or a folder
                  of surfaces. The result has `planes`, `findings`, `labelled` and `estimate`, too. With one labelled
                  phase all other numbers are estimates. times, leave_out, loop, smoothing and robust are not for images.
    leave_out_series
                  series of the images that are not used, by their numbers.
    corrections   contours that the motion has to meet, whatever the images show: {"phase": 4, "slice": 2, "surface":
                  "RV", "points_mm": k x 3} each, or "series" in the place of the slice, or neither: that in whose plane
                  the points lie. Phases without labels only. The result has `corrections`.
    handles       how many (none: 60 for one surface, 120 for more); or
    rig           positions of your own, h x 3 mm, around the organ in the first phase.
    period        of one cycle, s; goes before what the files say.
    times         of the phases, s, as many as there are; none: the files', else evenly over the period.
    leave_out     phases that are not used, counted from 0.
    loop          whether the last phase leads back to the first.
    keep_volumes  every phase has its measured volumes, exactly.
    smoothing     in time (none: 1e-5 for surfaces with the same triangles, else 1e-4).
    robust        beyond it distances count less, mm; 0: all alike.

    Some seconds a phase for label maps. Needs the part of Viscera that is built with Qt's core. Raises NoInputError,
    DataError that says what to do, UsageError, Cancelled.
    """
    named = [(name, [str(label) for label in np.atleast_1d(labels)]) for name, labels in (surfaces or {}).items()]
    if handles is not None and rig is not None:
        raise UsageError("A rig has its handles (give their number, or positions)")
    if handles is not None and handles < 1:
        raise UsageError(f"There cannot be {handles} handles")
    if any(phase < 0 for phase in leave_out):
        raise UsageError("Phases that are left out are counted from 0")
    if images is not None:
        if not isinstance(phases, Mapping):
            raise UsageError('Labels of images are named by their phases (as in {0: "ed.nrrd", 9: "es.nrrd"})')
        if len(times) or len(leave_out) or not loop or smoothing is not None or robust:
            raise UsageError("Images have no use for times, leave_out, loop, smoothing and robust (leave them out)")
        return _track_images(
            images, phases, named, handles, rig, period, leave_out_series, corrections, keep_volumes, threads,
            progress,
        )
    if isinstance(phases, Mapping) or len(leave_out_series) or len(corrections):
        raise UsageError("There are no images (give the images, or a file for each phase)")
    files = [phases] if isinstance(phases, (str, os.PathLike)) else list(phases)
    return part("_motion").track(
        [os.fspath(file) for file in files], named, handles or 0, rig, period, list(times), list(leave_out), loop,
        keep_volumes, smoothing, robust, threads, progress,
    )
