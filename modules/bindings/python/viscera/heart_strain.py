"""Strain of a heart's wall: of contours and of the material, with the 17 segments."""

from __future__ import annotations

import json
import os
import re
from typing import Any, Mapping, Sequence as ListOf, Union

import numpy as np
from numpy.typing import ArrayLike

from ._parts import part
from .deformation import Progress
from .errors import UsageError

PathLike = Union[str, "os.PathLike[str]"]


def _snake(value: Any) -> Any:
    """Keys as Python has them: "glsPercent" is "gls_percent"."""
    if isinstance(value, dict):
        return {re.sub(r"(?<=[a-z0-9])([A-Z])", r"_\1", key).lower(): _snake(each) for key, each in value.items()}
    if isinstance(value, list):
        return [_snake(each) for each in value]
    return value


def contour_strain(points: ArrayLike, vertices: ArrayLike, closed: bool = False, reference: int = 0) -> np.ndarray:
    """The change of a contour's length over the phases of a motion, in per cent: what GLS and GCS are.

    points     t x n x 3, mm: the same n points in each of t phases.
    vertices   k numbers of points, in order along the contour.
    closed     whether the contour returns to its first point.
    reference  the phase without strain, counted from 0.

    Returns t numbers, negative for shortening.
    """
    phases = np.asarray(points, dtype=float)
    if phases.ndim != 3 or phases.shape[2] != 3:
        raise UsageError("Points over time are t x n x 3")
    rows = np.asarray(vertices, dtype=int).ravel()
    if rows.size < 2:
        raise UsageError("A contour has two points at least")
    if rows.min() < 0 or rows.max() >= phases.shape[1]:
        raise UsageError(f"Points are counted from 0 to {phases.shape[1] - 1}")
    if not -phases.shape[0] <= reference < phases.shape[0]:
        raise UsageError(f"There is no phase {reference}")
    if closed:
        rows = np.append(rows, rows[0])
    lengths = np.linalg.norm(np.diff(phases[:, rows], axis=1), axis=2).sum(axis=1)
    return 100.0 * (lengths / lengths[reference] - 1.0)


def _contours(contours: Mapping[str, Any]) -> list[tuple[str, str, list[int], bool]]:
    listed = []
    for name, value in contours.items():
        entry = dict(value) if isinstance(value, Mapping) else {"vertices": value}
        rows = [int(row) for row in np.asarray(entry["vertices"]).ravel()]
        listed.append((name, str(entry.get("surface", "")), rows, bool(entry.get("closed", False))))
    return listed


def strain(
    motion: PathLike | ListOf[PathLike],
    surfaces: Mapping[str, ListOf[str | int]] | None = None,
    *,
    lv: str = "",
    rv: str = "",
    epi: str = "",
    la: str = "",
    landmarks: Mapping[str, ArrayLike] | None = None,
    contours: Mapping[str, Any] | None = None,
    reference: int | None = None,
    witnesses: int = 40_000,
    tracked_handles: int | None = None,
    period: float | None = None,
    leave_out: ListOf[int] = (),
    loop: bool = True,
    instants: int = 50,
    threads: int = 0,
    progress: Progress | None = None,
) -> dict[str, Any]:
    """The strain of a heart in motion: GLS, GCS, GRS, the 17 segments, twist, thickness, over all phases.

    motion     a series as for `track`, which is tracked first; a .sequence.json with its organs; or "heartbeat".
    surfaces   of label maps, as for `track`.
    lv, rv, epi, la
               names of surfaces: cavities of the ventricles, epicardium or whole heart, cavity of the left atrium.
               Those that are empty are found.
    landmarks  "base", "apex", "insertion" (3 numbers each, mm, LPS) in the place of those that are found.
    contours   lists of vertices in the place of contours that are found, numbered as in the files: {"4ch": [...],
               "base": {"surface": "LV", "vertices": [...], "closed": True}}. Names: fourChamber, twoChamber,
               threeChamber, base, middle, apex, rightFreeWall, leftReservoir.
    reference  the phase without strain, counted from 0: the end of diastole; none: the first, or the fullest where the
               left ventricle holds 3 % more in another.
    witnesses  points in the outer surface, at which the deformation gradient is taken.
    tracked_handles
               how many handles track a series; none: as `track` has them.
    period, leave_out, loop
               as for `track`.
    instants   of a sequence that computes its poses.

    Returns a dict with the keys of `viscera strain --json`, in small letters with underscores; strain is in per cent,
    negative for shortening; times in ms. Needs the part of Viscera that is built with Qt's core. Raises NoInputError,
    DataError, UsageError, Cancelled.
    """
    files = [motion] if isinstance(motion, (str, os.PathLike)) else list(motion)
    texts = [os.fspath(file) for file in files]
    module = part("_motion")
    if len(texts) == 1 and texts[0].endswith(".sequence.json"):
        kind = "file"
    elif len(texts) == 1 and texts[0] in module.sequence_names():
        kind = "ready"
    else:
        kind = "series"
    if (reference is not None and reference < 0) or any(phase < 0 for phase in leave_out):
        raise UsageError("Phases are counted from 0")
    unknown = set(landmarks or {}) - {"base", "apex", "insertion"}
    if unknown:
        raise UsageError(f"There is no landmark {sorted(unknown)[0]} (use base, apex, insertion)")
    named = [(name, [str(label) for label in np.atleast_1d(labels)]) for name, labels in (surfaces or {}).items()]
    places = {name: np.asarray(at, dtype=float) for name, at in (landmarks or {}).items()}
    return _snake(json.loads(module.strain_json(
        texts, kind, named, period, list(leave_out), loop, tracked_handles or 0, instants,
        {"lv": lv, "rv": rv, "epi": epi, "la": la}, places, reference, witnesses, _contours(contours or {}), threads,
        progress,
    )))
