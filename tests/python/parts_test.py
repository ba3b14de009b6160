"""Files, sequences and plugins: the parts of the package that take VTK and Qt's core.

parts_test.py PLUGINS: the folder with the plugins of the build.
"""

import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import viscera

PLUGINS = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "modules/bindings/python/examples"))
from _example import kidney  # noqa: E402


class Folder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)


class Cine(Folder):
    def test_volumes_over_time_are_a_stack_of_slices(self):
        voxels = np.arange(5 * 2 * 3 * 4, dtype="<i2").reshape(5, 2, 3, 4)  # Phase, layer, row, column.
        header = bytearray(352)
        struct.pack_into("<i", header, 0, 348)
        struct.pack_into("<8h", header, 40, 4, 4, 3, 2, 5, 1, 1, 1)
        struct.pack_into("<2h", header, 70, 4, 16)
        struct.pack_into("<8f", header, 76, 1, 2, 2, 8, 160, 0, 0, 0)
        struct.pack_into("<2f", header, 108, 352, 1)
        header[123] = 2 | 16  # mm, ms
        struct.pack_into("<h", header, 254, 1)
        struct.pack_into("<12f", header, 280, -2, 0, 0, 7, 0, -2, 0, 0, 0, 0, 8, 0)
        header[344:347] = b"n+1"
        file = self.folder / "cine.nii"
        file.write_bytes(bytes(header) + voxels.tobytes())
        study = viscera.cine(file)
        self.assertEqual(len(study.slices), 2)
        for layer, slice in enumerate(study.slices):
            self.assertEqual(slice.images.dtype, np.float32)
            np.testing.assert_array_equal(slice.images, voxels[:, layer])
            np.testing.assert_array_equal(slice.image(3), voxels[3, layer])
            np.testing.assert_allclose(slice.fractions, np.arange(5) / 5, atol=1e-6)
            np.testing.assert_allclose(slice.index_to_lps @ [1, 1, 0, 1], [-5, 2, 8 * layer, 1], atol=1e-5)
            self.assertAlmostEqual(slice.interval, 0.8, 5)
            self.assertEqual(slice.phase_at(0.59), 3)
        self.assertEqual(study.stacks[0].slices, [0, 1])
        self.assertEqual(study.stacks[0].gaps, [0])
        self.assertEqual(study.findings, [])
        with self.assertRaises(viscera.UsageError):
            study.slices[0].image(5)
        with self.assertRaises(viscera.NoInputError):
            viscera.cine(self.folder / "none")


class Files(Folder):
    def test_surfaces_come_back_from_files(self):
        points, triangles = kidney()
        for ending in ("ply", "vtp", "obj", "off", "stl"):
            file = self.folder / f"organ.{ending}"
            viscera.write_surface(file, points, triangles, name="kidney")
            surface = viscera.read_surface(file)
            self.assertEqual(surface.points.shape, points.shape)
            self.assertLess(abs(viscera.volume(*surface) / viscera.volume(points, triangles) - 1), 1e-6, ending)
            self.assertFalse(surface.points.flags.writeable)
            self.assertTrue(np.shares_memory(surface.points, viscera.as_points(surface.points)))
        with self.assertRaises(viscera.NoInputError) as caught:
            viscera.read_surface(self.folder / "none.stl")
        self.assertIsInstance(caught.exception, OSError)
        self.assertIn("none.stl", caught.exception.where)
        (self.folder / "bad.stl").write_text("solid nothing")
        with self.assertRaises(viscera.DataError):
            viscera.read_surface(self.folder / "bad.stl")
        for file in ("no/such/folder/o.stl", "organ.docx"):
            with self.assertRaises(viscera.CannotCreateError):
                viscera.write_surface(self.folder / file, points, triangles)

    def test_surfaces_are_repaired_by_size(self):
        points, triangles = kidney()
        crumb = points[triangles[:4].ravel()] * 0.001
        both = np.vstack([points, crumb])
        faces = np.vstack([triangles, len(points) + np.arange(12).reshape(4, 3)])
        for limit in ("2%", "5mm", "0.1ml"):
            mended = viscera.repair_surface(both, faces, [f"remove-fragments={limit}"])
            self.assertEqual(len(mended.triangles), len(triangles), limit)
        large = viscera.repair_surface(points, triangles, ["scale=10"])
        np.testing.assert_allclose(large.points, 10 * points)
        factor = viscera.life_size_factor("stomach", viscera.volume(*large) / 1000)
        self.assertLess(factor, 1)
        self.assertIsNone(viscera.life_size_factor("thing", 5))
        self.assertIn("remesh", viscera.surface_repairs())
        for wrong in ("magic", "remesh=none", "scale", "remove-fragments=5kg"):
            with self.assertRaises(viscera.UsageError):
                viscera.repair_surface(points, triangles, [wrong])

    def test_handles_come_back_with_every_bit_and_their_labels(self):
        places = np.random.default_rng(2).normal(0, 50, (9, 3))
        labels = [f"Apex {i}" for i in range(9)]
        for ending in ("mrk.json", "fcsv"):
            file = self.folder / f"rig.{ending}"
            viscera.write_handles(file, places, labels)
            read = viscera.read_handles(file)
            np.testing.assert_array_equal(read.positions, places)
            self.assertEqual(read.labels, labels)
            self.assertEqual(sum(map(len, read.groups.values())), 9)
        with self.assertRaises(viscera.DataError):
            viscera.write_handles(self.folder / "rig.fcsv", places, labels[:-1])

    def test_sample_organs_are_named_and_made(self):
        self.assertIn("heart", viscera.sample_names())
        heart = viscera.sample_organ("heart", "low")
        self.assertEqual(next(iter(heart)), "outer")
        self.assertTrue(viscera.check_surface(*heart["lv"])["outward"])
        with self.assertRaises(viscera.UsageError):
            viscera.sample_organ("tail")


class Motion(Folder):
    def test_a_sequence_fits_another_organ_by_its_landmarks(self):
        stomach = viscera.sample_organ("stomach", "low")["outer"]
        own = viscera.sequence("peristalsis", 0.9 * stomach.points, stomach.triangles)
        bound = viscera.bind(own.surfaces["organ"][0], own.rest_handles, own.system, **own.parameters)
        rest = viscera.volume(*own.surfaces["organ"])
        for seconds in (0, 5, 11):
            posed = bound.pose(own.pose(seconds))
            self.assertLess(abs(viscera.volume(posed, stomach.triangles) / rest - 1), 1e-9)
        with self.assertRaises(viscera.DataError):
            viscera.sequence("peristalsis", 0.9 * stomach.points, stomach.triangles, landmarks={"fundus": [900, 0, 0]})
        with self.assertRaises(viscera.UsageError):
            viscera.sequence("sneezing")
        with self.assertRaises(viscera.UsageError):
            own.pose(0, rate=1e9)

    def test_a_sequence_file_is_read(self):
        file = self.folder / "mine.sequence.json"
        file.write_text("{")
        with self.assertRaises(viscera.DataError):
            viscera.sequence(file)
        self.assertIn("heartbeat", viscera.sequence_names())

    def test_breathing_keeps_the_volume(self):
        points, triangles = kidney()
        handles = viscera.place_handles(points, triangles)
        breath = viscera.breathing(handles, points, down=20)
        bound = viscera.bind(points, handles)
        low, standard, high = breath.rates
        posed = bound.pose(breath.pose(60 / standard / 2))
        self.assertLess(low, high)
        self.assertAlmostEqual((posed - points)[:, 2].mean(), -20, 0)
        self.assertLess(abs(viscera.volume(posed, triangles) / viscera.volume(points, triangles) - 1), 1e-9)


class PatientMotion(Folder):
    def phases(self, count=5):
        """A surface a phase of a kidney that empties, and the volumes, ml."""
        points, triangles = kidney(10, 12)
        files, volumes = [], []
        for phase in range(count):
            squeeze = 0.5 - 0.5 * np.cos(2 * np.pi * phase / count)
            moved = points * (1 - 0.2 * squeeze)
            files.append(self.folder / f"cavity_{phase}.ply")
            viscera.write_surface(files[-1], moved, triangles)
            volumes.append(viscera.volume(moved, triangles) / 1000)
        return files, np.array(volumes)

    def test_a_series_of_surfaces_becomes_poses_with_their_volumes(self):
        files, volumes = self.phases()
        told = []
        motion = viscera.track(files, period=0.9, handles=24, progress=lambda fraction, step: told.append(fraction))
        self.assertEqual(told[-1], 1.0)
        self.assertTrue(motion.corresponding)
        self.assertEqual(motion.fit, "good")
        self.assertAlmostEqual(motion.indices["cavity"]["ef"], 1 - volumes.min() / volumes.max(), 4)
        beat = motion.sequence
        rest, triangles = beat.surfaces["cavity"]
        bound = viscera.bind(rest, beat.rest_handles, beat.system, **beat.parameters)
        for phase, volume in zip(motion.phases, volumes):
            posed = viscera.volume(bound.pose(beat.pose(phase["seconds"])), triangles) / 1000
            self.assertLess(abs(posed / volume - 1), 1e-5)  # single precision of the files
            self.assertLess(phase["mean_mm"], 0.5)
            self.assertEqual(phase["surfaces"]["cavity"]["flipped"], 0)
        file = self.folder / "beat.sequence.json"
        motion.write(file)
        back = viscera.sequence(file)
        np.testing.assert_array_equal(back.pose(0.3), beat.pose(0.3))
        np.testing.assert_array_equal(back.surfaces["cavity"][0], rest)
        again = viscera.track(files, period=0.9, rig=beat.rest_handles, threads=1)
        np.testing.assert_array_equal(again.sequence.rest_handles, beat.rest_handles)
        self.assertAlmostEqual(again.indices["cavity"]["ef"], motion.indices["cavity"]["ef"], 6)

    def test_a_series_of_labels_has_the_volumes_of_its_voxels(self):
        grid = np.indices((20, 20, 20)) - 9.5
        for phase in range(4):
            radius = 8 - 2 * (0.5 - 0.5 * np.cos(np.pi * phase / 2))
            voxels = ((grid**2).sum(axis=0) < radius**2).astype(np.uint8)
            header = ("NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 20 20 20\n"
                      "space directions: (4,0,0) (0,4,0) (0,0,4)\nspace origin: (0,0,0)\nencoding: raw\n\n")
            (self.folder / f"ball_{phase}.nrrd").write_bytes(header.encode() + voxels.tobytes())
        motion = viscera.track(self.folder, {"ball": [1]}, period=1, handles=30, keep_volumes=True)
        self.assertFalse(motion.corresponding)
        for phase in motion.phases:
            ball = phase["surfaces"]["ball"]
            self.assertLess(abs(ball["fitted_ml"] / ball["volume_ml"] - 1), 1e-6)
            self.assertGreater(phase["dice"], 0.9)

    def test_two_labelled_phases_and_images_become_a_motion(self):
        grid = np.indices((20, 20, 20)) - 9.5
        phases = [((grid**2).sum(axis=0) < (8 - squeeze) ** 2) for squeeze in (0, 0.5, 1.2, 1.8, 2, 1.5, 0.9, 0.4)]
        header = ("NRRD0004\ntype: uint8\ndimension: {}\nspace: left-posterior-superior\nsizes: {}20 20 20\n"
                  "space directions: {}(4,0,0) (0,4,0) (0,0,4)\n{}space origin: (0,0,0)\nencoding: raw\n{}\n")
        grey = np.stack([40 + 80 * ball + (grid[1] % 3) for ball in phases]).astype(np.uint8)
        times = "axis 0 index type:=numeric\naxis 0 index unit:=ms\naxis 0 index values:=" + " ".join(
            str(100 * phase) for phase in range(8)) + "\n"
        images = self.folder / "grey.seq.nrrd"
        images.write_bytes(header.format(4, "8 ", "none ", "kinds: list domain domain domain\n", times).encode()
                           + grey.transpose(1, 2, 3, 0).tobytes())
        for phase in (0, 4):
            (self.folder / f"labels_{phase}.nrrd").write_bytes(
                header.format(3, "", "", "", "").encode() + phases[phase].astype(np.uint8).tobytes())
        labels = {phase: self.folder / f"labels_{phase}.nrrd" for phase in (4, 0)}
        motion = viscera.track(labels, {"ball": [1]}, images=images, period=0.8, handles=30)
        self.assertEqual(motion.labelled, [0, 4])
        self.assertFalse(motion.estimate)
        self.assertEqual(len(motion.phases), 8)
        full, empty = phases[0].sum(), phases[4].sum()
        self.assertAlmostEqual(motion.indices["ball"]["ejection_fraction"], (full - empty) / full, 5)
        self.assertEqual(motion.planes[0]["states"][4], "labelled")
        self.assertTrue(all(finding["text"] for finding in motion.findings))
        self.assertEqual(motion.corrections, [])
        for wrong in ({"phase": 2}, {"phase": 2, "points_mm": [1, 2, 3]}, {"phase": 2, "points": [[1, 2, 3]]},
                      {"phase": 4, "points_mm": [[1, 2, 3]]}):  # The last one has labels.
            with self.assertRaises(viscera.UsageError):
                viscera.track(labels, {"ball": [1]}, images=images, period=0.8, corrections=[wrong])
        for wrong in ([self.folder / "labels_0.nrrd"], {-1: self.folder / "labels_0.nrrd"}):
            with self.assertRaises(viscera.UsageError):
                viscera.track(wrong, {"ball": [1]}, images=images)
        with self.assertRaises(viscera.UsageError):
            viscera.track(labels, {"ball": [1]}, images=images, loop=False)
        with self.assertRaises(viscera.UsageError):
            viscera.track(labels, {"ball": [1]})

    def test_what_cannot_be_tracked_is_said(self):
        files, _ = self.phases()
        with self.assertRaises(viscera.DataError):
            viscera.track(files[:3], period=0.9)
        with self.assertRaises(viscera.UsageError):
            viscera.track(files)  # no period anywhere
        with self.assertRaises(viscera.UsageError):
            viscera.track(files, period=0.9, handles=24, rig=np.zeros((24, 3)))
        with self.assertRaises(viscera.NoInputError):
            viscera.track(self.folder / "none", period=0.9)
        with self.assertRaises(viscera.Cancelled):
            viscera.track(files, period=0.9, progress=lambda fraction, step: False)


class OpenDocument(Folder):
    SESSION = pathlib.Path(__file__).parents[1] / "gui/sessions/play_recorded_locked.viscera"

    def test_a_drag_under_a_lock_keeps_the_volume_and_is_undone(self):
        bench = viscera.open(self.SESSION)
        self.assertEqual(bench.organs, ["ball"])
        before, pose = bench.volume_ml("ball"), bench.pose
        went = bench.drag("H-9", [6, -4, 3])
        self.assertGreater(np.linalg.norm(went), 1)
        self.assertAlmostEqual(bench.volume_ml("ball"), before, 6)
        self.assertFalse(np.array_equal(bench.pose, pose))
        np.testing.assert_allclose(bench.drag("H-9", [1, 1, 0], exactly=True), [1, 1, 0], atol=1e-9)
        self.assertTrue(bench.undo() and bench.undo())
        np.testing.assert_array_equal(bench.pose, pose)
        self.assertFalse(bench.undo())

    def test_a_beat_and_a_session_come_again_to_the_same_bits(self):
        played = []
        for _ in range(2):
            bench = viscera.open([self.SESSION])
            bench.drag("H-9", [6, -4, 3])
            bench.save(self.folder / "posed.viscera")
            played.append(viscera.open(self.folder / "posed.viscera").play(10)[1]["ball"])
        self.assertGreater(len(played[0]), 5)
        np.testing.assert_array_equal(played[0], played[1])

    def test_stress_grows_with_the_pose(self):
        bench = viscera.open(self.SESSION)
        bench.rest()
        self.assertAlmostEqual(bench.stress("ball", 300)["max"], 0, 6)
        bench.lock("ball", False)
        bench.drag("H-9", [12, 0, 0])
        self.assertGreater(bench.stress("ball", 300)["max"], 0.001)

    def test_what_is_not_there_is_said(self):
        bench = viscera.open(self.SESSION)
        with self.assertRaisesRegex(viscera.UsageError, "ball"):
            bench.lock("bal")
        with self.assertRaises(viscera.DataError):
            bench.set_pose(np.zeros((3, 3)))
        with self.assertRaises(viscera.NoInputError):
            viscera.open(self.folder / "none.viscera")


class Parts(unittest.TestCase):
    def test_plugins_are_loaded_and_problems_told(self):
        with tempfile.NamedTemporaryFile(suffix=".so") as none:
            reports = viscera.load_plugins([PLUGINS, none.name])
        self.assertTrue(reports[-1].problem)
        self.assertEqual([report.problem for report in reports[:-1]], [""] * (len(reports) - 1))
        known = {system.id for system in viscera.systems()}
        for report in reports[:-1]:
            self.assertLessEqual(set(report.systems), known)

    def test_the_numerical_part_loads_neither_vtk_nor_qt(self):
        done = subprocess.run(
            [sys.executable, "-c", "import viscera\nprint(open('/proc/self/maps').read())"],
            capture_output=True, text=True, check=True,
        )
        self.assertIn("libviscera_coordinates", done.stdout)
        for stranger in ("libvtk", "libQt5", "libdcm"):
            self.assertNotIn(stranger, done.stdout)

    def test_a_missing_part_says_what_it_needs(self):
        code = (
            "import sys, viscera\nsys.modules['viscera._files'] = None\n"
            "try:\n  viscera.read_surface('a.stl')\nexcept viscera.MissingPart as error:\n  print(error)"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertIn("VISCERA_WITH_CONTENT", done.stdout)


if __name__ == "__main__":
    unittest.main()
