"""What the examples share: where results go, what a missing package means, and a shape to work on."""

import importlib
import pathlib
import sys

import numpy as np


def results() -> pathlib.Path:
    """The folder for results."""
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def needs(package: str):
    """The package, or the end of the script with the status that means "skipped"."""
    try:
        return importlib.import_module(package)
    except ImportError as error:
        print(f"skipped: {package} is not there ({error})")
        sys.exit(77)


def kidney(rings: int = 30, segments: int = 40) -> tuple[np.ndarray, np.ndarray]:
    """A bent ellipsoid, 110 mm long: points (n x 3, mm) and triangles (m x 3), closed and outward."""
    theta = np.pi * np.arange(1, rings + 1)[:, None] / (rings + 1)
    phi = 2 * np.pi * np.arange(segments)[None, :] / segments
    ball = np.stack(
        [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta) + 0 * phi], axis=-1
    ).reshape(-1, 3)
    points = np.vstack([ball, [0, 0, 1], [0, 0, -1]]) * [25, 20, 55]
    points[:, 0] -= points[:, 2] ** 2 / 150
    ring, segment = np.meshgrid(np.arange(rings - 1), np.arange(segments), indexing="ij")
    a = (ring * segments + segment).ravel()
    b = (ring * segments + (segment + 1) % segments).ravel()
    north, south, last = rings * segments, rings * segments + 1, (rings - 1) * segments
    first = np.arange(segments)
    after = (first + 1) % segments
    triangles = np.vstack(
        [
            np.stack([a, a + segments, b + segments], axis=1),
            np.stack([a, b + segments, b], axis=1),
            np.stack([np.full(segments, north), first, after], axis=1),
            np.stack([np.full(segments, south), last + after, last + first], axis=1),
        ]
    )
    return points, triangles.astype(np.int32)
