"""Sequences: poses of handles over time."""

from __future__ import annotations

import os
from typing import Mapping, Sequence as ListOf, Union

import numpy as np
from numpy.typing import ArrayLike

from ._core import Sequence
from ._parts import part
from .deformation import Progress
from .errors import UsageError

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
    that are missing are found by the shape. Bind to `.rest_handles` by `.system` with `.parameters`.

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
