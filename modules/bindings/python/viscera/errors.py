"""What goes wrong, as exceptions. All of them are :class:`Error`."""

from __future__ import annotations

import numpy as np


class Error(Exception):
    """Something that a user can do something about. Its text says what, where, and what to try."""

    problem: str = ""
    where: str = ""
    try_this: str = ""
    exit_code: int = 1


class UsageError(Error, ValueError):
    """A name, option or parameter that does not exist or is out of range."""


class DataError(Error, ValueError):
    """Data that can be read but not used: degenerate, of another shape or kind."""


class UnboundVertices(DataError):
    """Points that have no coordinates, because they lie outside the handles."""

    #: Rows of the points, ascending.
    vertices: np.ndarray = np.empty(0, dtype=np.int32)
    #: How many of them lie outside the hull of all handles.
    outside_hull: int = 0


class TetrahedraError(Error):
    """A surface could not be filled with tetrahedra."""


class NoInputError(Error, OSError):
    """A file that does not exist or may not be read."""


class CannotCreateError(Error, OSError):
    """A file that cannot be written."""


class Cancelled(Error):
    """A job whose progress callback returned False."""


class MissingPart(Error, ImportError):
    """A function of a part of Viscera that this build or installation lacks."""
