"""Binding points to handles, and what follows from a binding."""

from __future__ import annotations

from typing import Callable, Iterable, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._core import Binding, RestoredPose, StressMap, StressPoints, System, VolumeLock
from .errors import UsageError
from .catalogue import system as system_named

#: Called with a fraction (0 to 1) and the name of the present step, some fifty times a second at most; returning
#: False cancels the job, and what it raises ends it.
Progress = Callable[[float, str], Optional[bool]]
Groups = Union[Mapping[str, Sequence[int]], Sequence[Sequence[int]], None]


def bind(
    points: ArrayLike,
    handles: ArrayLike,
    system: str | System = "s-celestial",
    triangles: ArrayLike | None = None,
    groups: Groups = None,
    *,
    partial: bool = False,
    threads: int = 0,
    progress: Progress | None = None,
    **parameters: float | str,
) -> Binding:
    """Computes the coordinates of `points` (n x 3, mm) with respect to `handles` (h x 3, mm, at rest).

    system      its id (`systems()` lists them) or the object.
    triangles   a cage: t x 3 rows of `handles`, closed, outward. Systems that need one take the handles' convex
                hull without it.
    groups      for localised systems: name and rows of the handles that act together (or a list of lists).
    partial     accept points without coordinates, which then do not move; else they raise UnboundVertices.
    threads     0: all of the machine's. No result depends on it.
    parameters  of the system, by name; `-` in a name is written `_`. Numbers, or the names of choices.

    O(n h) for most systems. Raises DataError for handles that no point could use, UsageError for parameters,
    Cancelled, KeyboardInterrupt.
    """
    chosen = system_named(system)
    offered = {each.name for each in chosen.parameters}
    values = {name if name in offered else name.replace("_", "-"): value for name, value in parameters.items()}
    return _core.bind(points, handles, chosen, triangles, _group_list(groups), values, partial, threads, progress)


def lock_volume(
    binding: Binding,
    triangles: ArrayLike,
    handles: ArrayLike,
    target: float | None = None,
    free: Sequence[int] | None = None,
    limit: float | None = None,
) -> RestoredPose:
    """The pose `handles` (h x 3, mm), changed by the least that gives the surface its volume exactly.

    triangles   m x 3 rows of the bound points: a closed surface.
    target      mm^3; none: the volume at rest.
    free        the handles that may move; none: those that the pose leaves at rest.
    limit       how far they may move, mm; none: the size of the rig.

    For many poses, or several surfaces at once, keep a `VolumeLock`. Raises DataError where it cannot be done.
    """
    return VolumeLock([(binding, triangles, target)]).restore(handles, free, limit)


def rotational_stress(
    binding: Binding, handles: ArrayLike, points: ArrayLike | None = None, progress: Progress | None = None
) -> StressMap:
    """The distortion by a pose `handles` (h x 3, mm) at `points` (m x 3 mm at rest; none: the bound ones).

    For many poses keep `StressPoints`: it takes the derivatives once.
    """
    return StressPoints(binding, points, progress).evaluate(handles)


def stress_difference(
    binding: Binding,
    handles: ArrayLike,
    before: ArrayLike,
    points: ArrayLike | None = None,
    progress: Progress | None = None,
) -> dict[str, np.ndarray]:
    """What the distortion by a pose `handles` (h x 3, mm) exceeds that by the pose `before` by, point by point.

    points      m x 3 mm at rest; none: the bound ones.

    Arrays of m numbers: stress_degrees, volume_ratio, stretch_max, stretch_min; not a number where one of the poses
    folds the tissue.
    """
    there = StressPoints(binding, points, progress)
    now, then = (_quantities(there.evaluate(pose)) for pose in (handles, before))
    return {name: now[name] - then[name] for name in now}


def stress_curves(
    binding: Binding,
    poses: Iterable[ArrayLike],
    points: ArrayLike,
    progress: Progress | None = None,
) -> dict[str, np.ndarray]:
    """The distortion at `points` (m x 3 mm at rest), such as one probe, over poses (each h x 3, mm), such as a beat.

    Arrays of poses x m numbers: stress_degrees, volume_ratio, stretch_max, stretch_min; not a number where a pose folds
    the tissue. With a sequence whose handles the binding has:

        beat = viscera.sequence("heartbeat")
        poses = [beat.pose(t) for t in np.linspace(0, 0.8, 64, endpoint=False)]
        curves = viscera.stress_curves(binding, poses, [[0.0, -20.0, 10.0]])
    """
    there = StressPoints(binding, points, progress)
    rows = [_quantities(there.evaluate(pose)) for pose in poses]
    if not rows:
        raise UsageError("There is no pose")
    return {name: np.stack([row[name] for row in rows]) for name in rows[0]}


def _quantities(found: StressMap) -> dict[str, np.ndarray]:
    folded = found.volume_ratio <= 0
    values = {
        "stress_degrees": np.degrees(found.rotational_stress),
        "volume_ratio": found.volume_ratio,
        "stretch_max": found.stretch_max,
        "stretch_min": found.stretch_min,
    }
    return {name: np.where(folded, np.nan, array) for name, array in values.items()}


def sweep(
    points: ArrayLike,
    handles: ArrayLike,
    parameter: str,
    values: Sequence[float | str],
    system: str | System = "s-celestial",
    **options: object,
) -> list[Binding]:
    """One binding of `points` (n x 3, mm) to `handles` (h x 3, mm) for each value of one parameter.

    `options` are those of `bind`, which also says what it raises.
    """
    own = _core.as_points(points)
    return [bind(own, handles, system, **{**options, parameter: value}) for value in values]  # type: ignore[arg-type]


def _group_list(groups: Groups) -> list[tuple[str, list[int]]]:
    if groups is None:
        return []
    if isinstance(groups, Mapping):
        named = list(groups.items())
    else:
        named = [(f"Group {i + 1}", rows) for i, rows in enumerate(groups)]
    found = []
    for name, rows in named:
        array = np.asarray(rows)
        if array.ndim != 1 or array.dtype.kind not in "iu":
            raise UsageError(f"Group {name} is no list of rows of handles")
        found.append((str(name), [int(row) for row in array]))
    return found
