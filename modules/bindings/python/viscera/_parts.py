"""Loads the parts of the package that take more than numpy, when they are first asked for."""

from __future__ import annotations

import importlib
from types import ModuleType

from .errors import MissingPart

_NEEDS = {
    "_files": "the modules of files (the CMake option VISCERA_WITH_CONTENT)",
    "_motion": "VTK and Qt's core (the CMake option VISCERA_WITH_APP)",
}


def part(name: str) -> ModuleType:
    """The extension `viscera.<name>`. Raises MissingPart that says what it needs."""
    try:
        return importlib.import_module("viscera." + name)
    except ImportError as error:
        raise MissingPart(f"This part of Viscera is not there: it needs {_NEEDS[name]}; {error}") from error
