"""The coordinate systems there are, built in and from plugins."""

from __future__ import annotations

import os
from typing import NamedTuple, Sequence, Union

from . import _core
from ._core import System
from ._parts import part
from .errors import UsageError

PathLike = Union[str, "os.PathLike[str]"]

_from_plugins: dict[str, System] = {}


class PluginReport(NamedTuple):
    """What became of one plugin."""

    file: str
    systems: list[str]
    problem: str


def systems() -> list[System]:
    """Every coordinate system, in the order of lists: the built-in ones, then those of plugins."""
    return [*_core.built_in_systems(), *_from_plugins.values()]


def system(name: str | System) -> System:
    """The system with that id. Raises UsageError that lists the ids there are."""
    if isinstance(name, System):
        return name
    known = {each.id: each for each in systems()}
    if name not in known:
        raise UsageError(f"There is no coordinate system '{name}' (use one of: {', '.join(known)})")
    return known[name]


def load_plugins(paths: Sequence[PathLike] = ()) -> list[PluginReport]:
    """Loads plugins from files and folders, and from those that VISCERA_PLUGIN_PATH names.

    Their systems can be bound by id from then on. A plugin that cannot be loaded is reported with the problem; the
    others go on. Needs the part of Viscera that is built with Qt.
    """
    search = [os.fspath(path) for path in paths]
    search += [path for path in os.environ.get("VISCERA_PLUGIN_PATH", "").split(":") if path]
    built_in = {each.id for each in _core.built_in_systems()}
    reports = []
    for file, found, problem in part("_motion").load_plugins(search):
        ids = [each.id for each in found]
        _from_plugins.update({each.id: each for each in found if each.id not in built_in})
        reports.append(PluginReport(str(file), ids, problem))
    return reports
