"""The plugin in ParaView: built against it, run by pvbatch on 1, 2, 4 and 6 ranks and by a pvserver of two with a client.

paraview_test.py PREFIX BUILD PLUGIN: where ParaView was unpacked, a folder for files, and the plugin.
"""

import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import threading
import unittest

PREFIX, BUILD, PLUGIN = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
del sys.argv[1:4]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "python"))

import numpy as np  # noqa: E402
import organ_pieces  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter  # noqa: E402
import viscera  # noqa: E402
from viscera import paraview  # noqa: E402
from viscera_vtk.vtkVisceraFilters import vtkVisceraDeformFilter, vtkVisceraStressFilter  # noqa: E402

SYSTEM = pathlib.Path(viscera.__file__).resolve().parents[2] / "lib"  # with the filters for the system's VTK, as installed
TIME_LIMIT = 120  # s: the failure of a collective is a hang
PIECES = 4
ENVIRONMENT = {
    **{key: value for key, value in os.environ.items() if key != "DISPLAY"},
    "LD_LIBRARY_PATH": f"{PREFIX}/usr/lib/{os.uname().machine}-linux-gnu:{SYSTEM}",
    "PYTHONPATH": str(PREFIX / "usr/lib/python3/dist-packages"),
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMP_NUM_THREADS": "1",
}


def write(data, name, mode="Binary"):
    """Inline data, which every ParaView reads, unless asked for otherwise."""
    writer = (vtkXMLPolyDataWriter if data.IsA("vtkPolyData") else vtkXMLUnstructuredGridWriter)()
    writer.SetFileName(str(BUILD / name))
    writer.SetInputData(data)
    getattr(writer, f"SetDataModeTo{mode}")()
    assert writer.Write()


def write_pieces(points, cells, handles, name):
    """The organ in pieces with ghosts, and its handles, as the package exports them. How many points and cells there are."""
    paraview.export(BUILD, points, cells, *handles, PIECES, name=name)
    pieces = paraview.cut(points, cells, PIECES)
    return sum(len(piece.points) for piece in pieces), sum(len(piece.cells) for piece in pieces)


def command(ranks, program, script, *arguments):
    """A program of ParaView, on ranks where they are more than one."""
    own = [str(PREFIX / "usr/bin" / program), *(["--sym"] if program == "pvbatch" else []), str(script), *arguments]
    return own if ranks == 1 else ["mpirun", "--oversubscribe", "-np", str(ranks), *own]


def finished(arguments, **environment):
    return subprocess.run(
        arguments, env={**ENVIRONMENT, **environment}, timeout=TIME_LIMIT, capture_output=True, text=True
    )


def run(ranks, organs, server="none"):
    """The results by organ, the same from all ranks."""
    done = finished(
        command(ranks, "pvbatch" if server == "none" else "pvpython", HERE / "in_paraview.py", str(BUILD), str(PLUGIN), server,
                *(f"{organ}={points},{cells}" for organ, (points, cells) in organs.items()))
    )
    found = {}
    # Ranks write as they come: lines may run into one another.
    for organ, numbers in re.findall(r"RESULT (\S+)((?: [-+]?0x[0-9a-f.]+p[-+][0-9]+)+)", done.stdout):
        if found.setdefault(organ, numbers.split()) != numbers.split():
            raise AssertionError("the ranks do not agree:\n" + done.stdout)
    if len(found) != len(organs):
        raise AssertionError(f"results are missing:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    return found


class Plugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        BUILD.mkdir(parents=True, exist_ok=True)
        cls.surface, cls.solid = organ_pieces.surface(), organ_pieces.solid()
        cls.handles = organ_pieces.handles(cls.surface[0])
        cls.organs = {
            "surface.pvtp": write_pieces(*cls.surface, cls.handles, "surface"),
            "solid.pvtu": write_pieces(*cls.solid, cls.handles, "solid"),
            "whole.vtp": tuple(map(len, cls.surface)),
        }
        for name, places in zip(("rest", "posed"), cls.handles):
            write(organ_pieces.point_data(places), name + ".vtp")
        write(organ_pieces.data_of(*cls.surface), "whole.vtp")

    def expected(self, points, cells):
        """The bits of the system's VTK on the whole organ."""
        found = []
        for kind, properties, names in (
            (vtkVisceraDeformFilter, {}, ("Volume", "RestVolume", "VectorArea")),
            (vtkVisceraDeformFilter, {"LockVolume": 1}, ("Volume", "RestVolume", "VectorArea")),
            (vtkVisceraStressFilter, {"Softness": 4.0}, ("MaxRotationalStress", "MeanRotationalStress")),
        ):
            made = kind()
            made.SetInputData(organ_pieces.data_of(points, cells))
            made.SetRestHandlesData(organ_pieces.point_data(self.handles[0]))
            made.SetPosedHandlesData(organ_pieces.point_data(self.handles[1]))
            for name, value in properties.items():
                getattr(made, "Set" + name)(value)
            made.Update()
            found += [getattr(made, "Get" + name)().hex() for name in names]
        return found

    def test_all_ranks_have_the_bits_of_one_process_of_vtk(self):
        # In pieces with ghosts, more ranks than pieces, and a serial reader that leaves all ranks but one empty.
        expected = {"surface.pvtp": self.expected(*self.surface), "solid.pvtu": self.expected(*self.solid)}
        expected["whole.vtp"] = expected["surface.pvtp"]
        for ranks, organs in (
            (1, ("surface.pvtp", "solid.pvtu")),
            (2, ("surface.pvtp", "whole.vtp")),
            (4, ("surface.pvtp", "solid.pvtu")),
            (6, ("surface.pvtp",)),
        ):
            for organ, results in run(ranks, {organ: self.organs[organ] for organ in organs}).items():
                with self.subTest(organ, ranks=ranks):
                    self.assertEqual(results[:-1], expected[organ])
                    self.assertIn("0x", results[-1])

    def test_lost_points_are_noticed(self):
        # Appended data: some builds of ParaView with some of libexpat lose all of it without an error. One point that is
        # missing has to be noticed as well, so one more is asked for than there is.
        points, triangles = self.surface
        write(organ_pieces.data_of(points, triangles), "appended.vtp", "Appended")
        with self.assertRaisesRegex(AssertionError, "LOST DATA") as caught:
            run(1, {"appended.vtp": (len(points) + 1, len(triangles))})
        lost = "LOST DATA: 0 points" in str(caught.exception)
        print("this ParaView", "loses" if lost else "reads", "appended data")

    def test_server_of_two_ranks_with_a_client(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        server = subprocess.Popen(
            ["mpirun", "--oversubscribe", "-np", "2", str(PREFIX / "usr/bin/pvserver"), f"--server-port={port}"],
            env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )
        end = threading.Timer(TIME_LIMIT, os.killpg, (server.pid, signal.SIGKILL))
        end.start()
        try:
            for line in server.stdout:
                if "Accepting connection" in line:
                    break
            found = run(1, {"surface.pvtp": self.organs["surface.pvtp"]}, f"127.0.0.1:{port}")
            self.assertEqual(found["surface.pvtp"][:-1], self.expected(*self.surface))
            server.wait(timeout=30)
        finally:
            if server.poll() is None:
                os.killpg(server.pid, signal.SIGTERM)
                server.wait()
            end.cancel()
            server.stdout.close()

    def test_a_handle_is_dragged_in_the_window(self):
        # ctest lends this test a display of its own: a window beside another one would take its focus.
        lent = re.search(r"id:(\d+)", os.environ.get("CTEST_RESOURCE_GROUP_0_DISPLAYS", ""))
        display = f":{lent[1]}" if lent else os.environ.get("DISPLAY")
        if not display:
            self.skipTest("there is no display")
        done = finished(
            [str(PREFIX / "usr/bin/paraview"), "--dr", f"--script={HERE / 'in_window.py'}"],
            VISCERA_PLUGIN=str(PLUGIN), VISCERA_RESULTS=str(BUILD), DISPLAY=display,
        )
        said = re.search(r"DRAGGED \[(\d+)\] missed by (\d+) pixels; volume (\S+) (\S+)", done.stdout)
        self.assertTrue(said, done.stdout + done.stderr)
        handle, missed, rest, now = said.groups()
        self.assertEqual(handle, "7")
        self.assertLessEqual(int(missed), 3)
        self.assertGreater(abs(float(now) / float(rest) - 1), 1e-4)

    def test_exported_script_brings_results_back(self):
        points, triangles = self.surface
        script = paraview.export(BUILD / "exported", points, triangles, *self.handles, 2)
        done = finished(command(2, "pvbatch", script, "lock"), VISCERA_PLUGIN=str(PLUGIN))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        kept = np.genfromtxt(BUILD / "exported/handles.csv", delimiter=",", names=True)
        pose = np.stack([kept[f"Points{axis}"] for axis in range(3)], axis=1)
        binding = viscera.bind(points, self.handles[0])
        rest = viscera.volume(points, triangles)
        self.assertLess(abs(viscera.volume(binding.pose(pose), triangles) / rest - 1), 1e-12)
        self.assertTrue((BUILD / "exported/posed.pvtp").is_file())

    def test_example_trace_runs(self):
        trace = HERE.parents[1] / "modules/bindings/python/examples/paraview_trace.py"
        done = finished(command(1, "pvpython", trace, str(BUILD)), VISCERA_PLUGIN=str(PLUGIN))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("volume", done.stdout)


if __name__ == "__main__":
    unittest.main()
