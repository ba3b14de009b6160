"""Heart and circulation: pressures, volumes and flows of a beat that repeats itself. Needs numpy alone."""

from __future__ import annotations

from typing import Any, Sequence

from numpy.typing import ArrayLike

from . import _core
from ._core import Circulation
from .deformation import Progress


def circulate(
    scenario: str = "rest",
    *,
    near: Circulation | None = None,
    progress: Progress | None = None,
    **parameters: float,
) -> Circulation:
    """Finds the periodic state of a scenario (`scenarios()` lists them).

    near        a result for parameters that differ a little: where to begin, which saves beats.
    parameters  by name (`circulation_parameters()` lists them, with units and ranges): what differs from the scenario.

    `.curves` has all pressures (mmHg), volumes (ml) and flows (ml/s) over the beat, `.indices` what is read off them.
    5 to 20 ms. A circulation that never settles is no error: look at `.converged` and `.failure_reason`. Raises UsageError
    for names that there are not and values out of range, Cancelled.
    """
    return _core.circulate(scenario, parameters, near, progress)


def circulation_response(
    name: str,
    values: ArrayLike,
    scenario: str = "rest",
    *,
    progress: Progress | None = None,
    **parameters: float,
) -> Sequence[dict[str, Any]]:
    """How the circulation answers to one parameter, `values` (k, in its unit), while all others stay: k dicts, as
    `Circulation.indices`.

    Over "stressedVolume" (ml) it is Frank and Starling's curve. About 10 ms a value. Raises UsageError, DataError at a
    value where no beat repeats itself, Cancelled.
    """
    return _core.circulation_response(name, values, scenario, parameters, progress)
