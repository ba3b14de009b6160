"""From here to ParaView: an organ in pieces with ghost cells, its handles, and a script that pvbatch runs on any number
of ranks. Needs numpy alone.

    python3 -m viscera.paraview session.viscera FOLDER --pieces 4
"""

from __future__ import annotations

import argparse
import base64
import json
import os
import pathlib
import shlex
import zlib
from typing import Mapping, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import DataError, Error, NoInputError

PathLike = Union[str, "os.PathLike[str]"]


class Session(NamedTuple):
    """What of a session file concerns the organs and their handles."""

    #: Name, and points (n x 3, mm) with triangles (m x 3), at rest.
    organs: dict[str, tuple[NDArray[np.float64], NDArray[np.int32]]]
    labels: list[str]
    #: The handles at rest and posed, h x 3 mm.
    rest: NDArray[np.float64]
    pose: NDArray[np.float64]
    #: An id for `bind`, and its parameters.
    system: str
    parameters: dict[str, float]


class Piece(NamedTuple):
    """One part of an organ, with the cells of others that touch it."""

    #: Rows of the organ's points.
    points: NDArray[np.int64]
    #: Corners as rows of `points`.
    cells: NDArray[np.int64]
    #: Which cells and points belong to another piece.
    ghost_cells: NDArray[np.bool_]
    ghost_points: NDArray[np.bool_]


def read_session(path: PathLike) -> Session:
    """The organs and handles of a `.viscera` file. Raises NoInputError, DataError."""
    file = pathlib.Path(path)
    try:
        content = json.loads(file.read_text())
    except OSError as error:
        raise NoInputError(f"{file}: {error.strerror}") from error
    except ValueError as error:
        raise DataError(f"{file}: It is no session: {error}") from error
    if content.get("format") != "viscera-session":
        raise DataError(f"{file}: It is no session")
    handles = content["rig"]["handles"]
    rest = np.array([each["rest"] for each in handles], dtype=float).reshape(-1, 3)
    pose = np.array([each.get("pose", each["rest"]) for each in handles], dtype=float).reshape(-1, 3)
    organs = {each["name"]: _surface_of(each, file.parent) for each in content["organs"]}
    system = content.get("system", {})
    return Session(
        organs,
        [each["label"] for each in handles],
        rest,
        pose,
        system.get("id", "s-celestial"),
        dict(system.get("parameters", {})),
    )


def cut(points: ArrayLike, cells: ArrayLike, pieces: int) -> list[Piece]:
    """Cuts triangles (m x 3) or tetrahedra (m x 4) of points (n x 3) into slabs of equally many cells along the longest
    axis, each with one layer of ghosts: the cells of others that share a point with it. O(m log m)."""
    places, corners = np.asarray(points, dtype=float), np.asarray(cells)
    axis = int(np.argmax(places.max(axis=0) - places.min(axis=0)))
    order = np.argsort(places[corners, axis].mean(axis=1), kind="stable")
    owner = np.empty(len(corners), dtype=np.int64)
    owner[order] = np.arange(len(corners)) * pieces // max(len(corners), 1)
    first = np.full(len(places), pieces)
    np.minimum.at(first, corners.ravel(), np.repeat(owner, corners.shape[1]))
    found = []
    for piece in range(pieces):
        touched = np.zeros(len(places), dtype=bool)
        touched[corners[owner == piece]] = True
        taken = touched[corners].any(axis=1)
        rows = np.unique(corners[taken])
        found.append(Piece(rows, np.searchsorted(rows, corners[taken]), owner[taken] != piece, first[rows] != piece))
    return found


def export(
    folder: PathLike,
    points: ArrayLike,
    cells: ArrayLike,
    rest: ArrayLike,
    pose: ArrayLike,
    pieces: int = 1,
    system: str = "s-celestial",
    parameters: Mapping[str, float] = {},
    name: str = "organ",
) -> pathlib.Path:
    """Writes an organ, triangles (m x 3) or tetrahedra (m x 4), with its handles (h x 3, mm) for ParaView.

    `name`.pvtp or .pvtu in as many pieces, rest.vtp, posed.vtp, and run.py, whose first lines say how it is run. The
    files are inline: ParaView 5.11 loses appended data where libexpat is newer. Returns run.py.
    """
    places, corners = np.asarray(points, dtype=float), np.asarray(cells)
    if corners.ndim != 2 or corners.shape[1] not in (3, 4):
        raise DataError(f"cells: Has the shape {corners.shape} (m x 3 or m x 4 is wanted)")
    if pieces < 1:
        raise DataError(f"pieces: There are {pieces} (give 1 or more)")
    target = pathlib.Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    kind, ending = ("PolyData", "vtp") if corners.shape[1] == 3 else ("UnstructuredGrid", "vtu")
    counts = [0, 0]
    for number, piece in enumerate(cut(places, corners, pieces)):
        text = _data(kind, places[piece.points], piece.cells, piece.ghost_cells, piece.ghost_points)
        (target / f"{name}{number}.{ending}").write_text(text)
        counts[0] += len(piece.points)
        counts[1] += len(piece.cells)
    ghost = '<PDataArray type="UInt8" Name="vtkGhostType"/>'
    sources = "".join(f'<Piece Source="{name}{number}.{ending}"/>' for number in range(pieces))
    (target / f"{name}.p{ending}").write_text(
        f'<VTKFile type="P{kind}" version="1.0" byte_order="LittleEndian" header_type="UInt64"><P{kind} GhostLevel="1">'
        f"<PPointData>{ghost}</PPointData><PCellData>{ghost}</PCellData><PPoints>"
        f'<PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>{sources}</P{kind}></VTKFile>\n'
    )
    for file, positions in (("rest.vtp", rest), ("posed.vtp", pose)):
        (target / file).write_text(_data("PolyData", np.asarray(positions, dtype=float), np.empty((0, 3), np.int64)))
    script = target / "run.py"
    reader = "XMLPartitionedPolydataReader" if ending == "vtp" else "XMLPartitionedUnstructuredGridReader"
    script.write_text(
        _SCRIPT.format(
            name=name, ending=ending, reader=reader, points=counts[0], cells=counts[1], system=system,
            locality=parameters.get("locality", 0), softness=parameters.get("softness", 0), pieces=pieces,
        )
    )
    return script


def export_session(session: PathLike, folder: PathLike, pieces: int = 1) -> list[pathlib.Path]:
    """`export` for every organ of a session, each into a folder of its name. The scripts."""
    read = read_session(session)
    return [
        export(pathlib.Path(folder) / _file_name(name), points, triangles, read.rest, read.pose, pieces, read.system,
               read.parameters)
        for name, (points, triangles) in read.organs.items()
    ]


_SCRIPT = '''# One organ and a pose of its handles in ParaView, cut into {pieces} pieces:
#   VISCERA_PLUGIN=.../Viscera.so mpirun -np {pieces} pvbatch --sym run.py
# Writes posed.p{ending} (open it in ParaView) and handles.csv (where the volume lock has put the handles).
import os
import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

here = os.path.dirname(os.path.abspath(__file__))
simple.LoadPlugin(os.environ["VISCERA_PLUGIN"], remote=False, ns=globals())
organ = simple.{reader}(FileName=[here + "/{name}.p{ending}"])
organ.UpdatePipeline()
read = organ.GetClientSideObject().GetOutputDataObject(0)
mine, there = vtkIdTypeArray(), vtkIdTypeArray()
mine.InsertNextValue(read.GetNumberOfPoints())
mine.InsertNextValue(read.GetNumberOfCells())
there.DeepCopy(mine)
controller = vtkMultiProcessController.GetGlobalController()
if controller.GetNumberOfProcesses() > 1:
    controller.AllReduce(mine, there, vtkCommunicator.SUM_OP)
if (there.GetValue(0), there.GetValue(1)) != ({points}, {cells}):
    sys.exit("Points or cells were lost on the way: this ParaView cannot read these files with this libexpat.")
bent = VisceraDeform(
    Input=organ,
    RestHandles=simple.XMLPolyDataReader(FileName=[here + "/rest.vtp"]),
    PosedHandles=simple.XMLPolyDataReader(FileName=[here + "/posed.vtp"]),
    System="{system}",
    Locality={locality},
    Softness={softness},
    LockVolume=int("lock" in sys.argv),
)
bent.UpdatePipeline()
bent.UpdatePropertyInformation()
volume, rest = (bent.SMProxy.GetProperty(name).GetElement(0) for name in ("Volume", "RestVolume"))
print("volume", volume, "mm3, at rest", rest, "mm3")
simple.SaveData(here + "/posed.p{ending}", proxy=bent, DataMode="Binary")
simple.SaveData(here + "/handles.csv", proxy=simple.OutputPort(bent, 1), Precision=17)
'''


def _data(
    kind: str,
    points: NDArray[np.float64],
    cells: NDArray[np.int64],
    ghost_cells: NDArray[np.bool_] | None = None,
    ghost_points: NDArray[np.bool_] | None = None,
) -> str:
    """VTK's XML with the arrays inline."""
    size = cells.shape[1]
    attributes = ["", ""]
    for i, (tag, ghosts) in enumerate((("PointData", ghost_points), ("CellData", ghost_cells))):
        if ghosts is not None:
            attributes[i] = f"<{tag}>{_array('vtkGhostType', ghosts.astype(np.uint8), 'UInt8')}</{tag}>"
    lists = _array("connectivity", cells.astype(np.int64).ravel(), "Int64") + _array(
        "offsets", size * np.arange(1, len(cells) + 1, dtype=np.int64), "Int64"
    )
    if kind == "PolyData":
        counts, topology = f'NumberOfPolys="{len(cells)}"', f"<Polys>{lists}</Polys>"
    else:
        types = _array("types", np.full(len(cells), 10, np.uint8), "UInt8")
        counts, topology = f'NumberOfCells="{len(cells)}"', f"<Cells>{lists}{types}</Cells>"
    return (
        f'<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" header_type="UInt64"><{kind}>'
        f'<Piece NumberOfPoints="{len(points)}" {counts}>{"".join(attributes)}<Points>'
        f'{_array("Points", points, "Float64", 3)}</Points>{topology}</Piece></{kind}></VTKFile>\n'
    )


def _array(name: str, values: NDArray, kind: str, components: int = 1) -> str:
    """Little-endian bytes behind their number, as base64."""
    raw = np.ascontiguousarray(values).astype(values.dtype.newbyteorder("<")).tobytes()
    text = base64.b64encode(np.uint64(len(raw)).astype("<u8").tobytes() + raw).decode()
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">{text}</DataArray>'


def _surface_of(organ: dict, folder: pathlib.Path) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """The surface of an organ of a session: inside it, in a file, or a sample's."""
    if "surface" in organ:
        inside = organ["surface"]
        points, triangles = (zlib.decompress(base64.b64decode(inside[key])) for key in ("points", "indices"))
        return (
            np.frombuffer(points, "<f8").reshape(-1, 3).astype(float),
            np.frombuffer(triangles, "<i4").reshape(-1, 3).astype(np.int32),
        )
    from .files import read_surface, sample_organ

    source = organ.get("source", {})
    if "sample" in source:
        name, _, resolution = source["sample"].partition("@")
        return tuple(sample_organ(name, resolution or "medium")[source["surface"]])  # type: ignore[return-value]
    for file in (folder / source["file"].get("relative", ""), pathlib.Path(source["file"].get("absolute", ""))):
        if file.is_file():
            return tuple(read_surface(file))  # type: ignore[return-value]
    raise NoInputError(f"The file of '{organ['name']}' is nowhere (save the session with all surfaces inside)")


def _file_name(name: str) -> str:
    return "".join(letter if letter.isalnum() or letter in "-_" else "_" for letter in name) or "organ"


def main() -> None:
    """The command line: see the module."""
    options = argparse.ArgumentParser(prog="python3 -m viscera.paraview", description="A session for ParaView")
    options.add_argument("session", help="a .viscera file")
    options.add_argument("folder", help="where each organ gets a folder of its own")
    options.add_argument("--pieces", type=int, default=1, help="as many as there will be ranks, or more")
    given = options.parse_args()
    try:
        for script in export_session(given.session, given.folder, given.pieces):
            print(f"mpirun -np {given.pieces} pvbatch --sym {shlex.quote(str(script))}")
    except Error as error:
        options.exit(error.exit_code, f"{error}\n")


if __name__ == "__main__":
    main()
