from typing import Mapping, Optional, Sequence as ListOf

from numpy.typing import ArrayLike

from ._core import Progress, Sequence, System

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
