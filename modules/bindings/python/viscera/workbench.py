"""The open document at work: files, sessions and sample organs, as the window has them."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Sequence, Union

from ._parts import part
from .catalogue import systems
from .deformation import Progress

if TYPE_CHECKING:
    from ._motion import Workbench

PathLike = Union[str, "os.PathLike[str]"]


def open(
    paths: PathLike | Sequence[PathLike], threads: int = 0, progress: Progress | None = None
) -> Workbench:
    """Opens a session, or surfaces, label maps and handles together, or a sample organ ("sample:heart@low").

    Organs without handles get some. The result has `organs` and `handles` (names), `pose` (h x 3 mm), `points(organ)`,
    `volume_ml(organ)`, `lock(organ)`, `drag(handle, by)`, `set_pose(places)`, `rest()`, `play()`, `stress(organ)`,
    `measure(name)`, `undo()`, `redo()` and `save(path)`; the same calls give the same bits as the window and the
    command line. `warnings` say what to know about the files. `threads` 0: all of the machine.

    Needs the part of Viscera that is built with Qt's core. Raises NoInputError, DataError, UsageError, Cancelled.
    """
    files = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    return part("_motion").open_bench([os.fspath(file) for file in files], systems(), threads, progress)
