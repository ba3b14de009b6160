from typing import Any, Mapping, Optional, Sequence as ListOf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import Progress, Sequence, System

class PatientMotion:
    tissue_ml: list[float]
    corresponding: bool
    warnings: list[str]
    @property
    def sequence(self) -> Sequence: ...
    @property
    def phases(self) -> list[dict[str, Any]]: ...
    @property
    def indices(self) -> dict[str, dict[str, float]]: ...
    @property
    def fit(self) -> str: ...
    def write(self, path: str) -> None: ...

class Workbench:
    warnings: list[str]
    @property
    def organs(self) -> list[str]: ...
    @property
    def handles(self) -> list[str]: ...
    @property
    def measurements(self) -> list[str]: ...
    @property
    def pose(self) -> NDArray[np.float64]: ...
    def points(self, organ: str) -> NDArray[np.float64]: ...
    def volume_ml(self, organ: str) -> float: ...
    def lock(self, organ: str, locked: bool = True) -> None: ...
    def drag(
        self, handle: str, by: ArrayLike, exactly: bool = False, free_handles_follow: bool = False
    ) -> NDArray[np.float64]: ...
    def set_pose(self, places: ArrayLike, free_handles_follow: bool = False) -> None: ...
    def rest(self) -> None: ...
    def play(
        self, frames_per_second: float = 25.0, cycles: float = 1.0, progress: Optional[Progress] = None
    ) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]: ...
    def stress(
        self, organ: str, witnesses: int = 2000, progress: Optional[Progress] = None
    ) -> dict[str, float]: ...
    def measure(self, name: str) -> dict[str, float]: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    def save(self, path: str, embed: Optional[bool] = None) -> None: ...

def open_bench(
    files: ListOf[str], systems: ListOf[System], threads: int, progress: Optional[Progress]
) -> Workbench: ...

class CineMotion:
    tissue_ml: list[float]
    corresponding: bool
    warnings: list[str]
    labelled: list[int]
    estimate: bool
    @property
    def sequence(self) -> Sequence: ...
    @property
    def phases(self) -> list[dict[str, Any]]: ...
    @property
    def indices(self) -> dict[str, dict[str, float]]: ...
    @property
    def fit(self) -> str: ...
    @property
    def planes(self) -> list[dict[str, Any]]: ...
    @property
    def findings(self) -> list[dict[str, Any]]: ...
    @property
    def corrections(self) -> list[dict[str, Any]]: ...
    def write(self, path: str) -> None: ...

def sequence_names() -> list[str]: ...
def ready_sequence(name: str, resolution: str, progress: Optional[Progress]) -> Sequence: ...
def fitted_sequence(
    name: str,
    points: ArrayLike,
    triangles: ArrayLike,
    landmarks: Mapping[str, ListOf[ArrayLike]],
    progress: Optional[Progress],
) -> Sequence: ...
def sequence_of_file(path: str) -> Sequence: ...
def load_plugins(search_path: ListOf[str]) -> list[tuple[str, list[System], str]]: ...
def write_phantom(
    folder: str,
    modality: str,
    heartbeat: bool,
    breathing: bool,
    ejection_fraction: float,
    rate: float,
    spacing: str,
    slices: ListOf[str],
    noise: str,
    shift_slices: float,
    phases: int,
    fields: float,
    over_time: bool,
    format: str,
    seed: int,
    threads: int,
    progress: Optional[Progress],
) -> dict[str, Any]: ...
def strain_json(
    motion: ListOf[str],
    kind: str,
    surfaces: ListOf[tuple[str, ListOf[str]]],
    period: Optional[float],
    leave_out: ListOf[int],
    loop: bool,
    handles: int,
    instants: int,
    names: Mapping[str, str],
    landmarks: Mapping[str, ArrayLike],
    reference: int,
    witnesses: int,
    contours: ListOf[tuple[str, str, ListOf[int], bool]],
    threads: int,
    progress: Optional[Progress],
) -> str: ...
def track(
    phases: ListOf[str],
    surfaces: ListOf[tuple[str, ListOf[str]]],
    handles: int,
    rig: Optional[ArrayLike],
    period: Optional[float],
    times: ListOf[float],
    leave_out: ListOf[int],
    loop: bool,
    keep_volumes: bool,
    smoothing: Optional[float],
    robust: float,
    threads: int,
    progress: Optional[Progress],
) -> PatientMotion: ...
def track_images(
    images: str,
    labels: ListOf[tuple[int, ListOf[str]]],
    surfaces: ListOf[tuple[str, ListOf[str]]],
    handles: int,
    rig: Optional[ArrayLike],
    period: Optional[float],
    leave_out_series: ListOf[int],
    corrections: ListOf[tuple[int, Optional[int], Optional[int], str, ArrayLike]],
    keep_volumes: bool,
    threads: int,
    progress: Optional[Progress],
) -> CineMotion: ...
