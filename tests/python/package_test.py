"""The package against numpy, and what it promises about memory, threads, errors and its own documentation."""

import ast
import inspect
import os
import pathlib
import re
import signal
import sys
import threading
import time
import unittest
import warnings

import numpy as np

import viscera
from viscera import _core

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "modules/bindings/python/examples"))
from _example import kidney  # noqa: E402

SOURCE = pathlib.Path(__file__).parents[2] / "modules/bindings/python/viscera"


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return (a * np.cross(b, c)).sum() / 6


class Numbers(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = kidney()
        self.handles = viscera.place_handles(self.points, self.triangles)
        self.binding = viscera.bind(self.points, self.handles)
        self.pose = self.handles + np.random.default_rng(3).normal(0, 3, self.handles.shape)

    def test_weights_reproduce_points_and_poses(self):
        weights = self.binding.weights
        self.assertLess(abs(weights.sum(axis=1) - 1).max(), 1e-13)
        self.assertGreaterEqual(weights.min(), 0)
        self.assertLess(abs(weights @ self.handles - self.points).max(), 1e-10)
        self.assertLess(abs(weights @ self.pose - self.binding.pose(self.pose)).max(), 1e-10)
        np.testing.assert_array_equal(weights[:, 4], self.binding.influence(4))

    def test_s_celestial_satisfies_its_equation(self):
        # Coordinates of one point by a plain damped Newton of numpy (thesis 4.4).
        for row in (0, 77, 500):
            away = self.handles - self.points[row]
            distance = np.linalg.norm(away, axis=1)
            q = away / distance[:, None]
            x = np.zeros(3)
            for _ in range(60):
                t = q @ x
                root = np.sqrt(t * t + 1)
                phi = (t + root) ** 2
                step = np.linalg.solve((q * (2 * phi / root)[:, None]).T @ q, -(q * phi[:, None]).sum(axis=0))
                x += step * min(1.0, 0.5 / np.linalg.norm(step))
            weights = phi / distance
            np.testing.assert_allclose(self.binding.weights[row], weights / weights.sum(), atol=1e-12)

    def test_volume_and_its_gradients(self):
        volume = viscera.volume(self.points, self.triangles)
        self.assertAlmostEqual(volume / volume_of(self.points, self.triangles), 1, 12)
        self.assertGreater(viscera.area(self.points, self.triangles), 1000)
        gradient = viscera.volume_gradient(self.binding, self.triangles, self.pose)
        at_points = viscera.point_volume_gradient(self.binding.pose(self.pose), self.triangles)
        np.testing.assert_allclose(gradient, self.binding.weights.T @ at_points, atol=1e-8)
        for handle, axis in ((9, 0), (20, 2)):
            step = np.zeros_like(self.pose)
            step[handle, axis] = 1e-3
            change = volume_of(self.binding.pose(self.pose + step), self.triangles) - volume_of(
                self.binding.pose(self.pose - step), self.triangles
            )
            self.assertAlmostEqual(gradient[handle, axis] / (change / 2e-3), 1, 6)

    def test_moving_one_handle_is_posing_with_it_moved(self):
        points = self.binding.pose(self.pose)
        self.assertIs(self.binding.move_handle(self.pose, 11, [1, 2, 3], points), points)
        moved = self.pose.copy()
        moved[11] += [1, 2, 3]
        np.testing.assert_allclose(points, self.binding.pose(moved), atol=1e-10)

    def test_the_volume_of_an_open_surface_warns(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            viscera.volume(self.points, self.triangles)
        with self.assertWarnsRegex(UserWarning, "open .3 edges"):
            viscera.volume(self.points, self.triangles[1:])
        turned = self.triangles.copy()
        turned[0] = turned[0][::-1]
        with self.assertWarnsRegex(UserWarning, "face the same way"):
            viscera.volume(self.points, turned)
        tube = np.array([[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5]])  # its two holes are alike
        rings = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]]
        with self.assertWarns(UserWarning):
            viscera.volume(rings, tube)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertRaises(UserWarning, viscera.volume, rings, tube)

    def test_the_package_has_the_version_of_the_program(self):
        self.assertRegex(viscera.__version__, r"^\d+\.\d+\.\d+$")

    def test_the_fewest_handles_are_those_of_the_program(self):
        for enclosing, fewest in ((True, 8), (False, 4)):
            place = lambda count: viscera.place_handles(self.points, self.triangles, count, enclosing=enclosing)  # noqa: E731
            self.assertEqual(len(place(fewest)), fewest)
            self.assertRaises(viscera.DataError, place, fewest - 1)

    def test_a_rigid_body_keeps_its_shape_and_lies_where_kabsch_puts_it(self):
        rigid = self.binding.rigid(self.triangles)
        posed, soft = rigid.pose(self.pose), self.binding.pose(self.pose)
        for row in (0, 77, 500):
            np.testing.assert_allclose(
                np.linalg.norm(posed - posed[row], axis=1), np.linalg.norm(self.points - self.points[row], axis=1), atol=1e-9
            )
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        shares = np.zeros(len(self.points))
        for corner in range(3):
            np.add.at(shares, self.triangles[:, corner], areas)
        shares /= shares.sum()
        rest, middle = self.points - shares @ self.points, shares @ soft
        u, _, vt = np.linalg.svd((soft - middle).T @ (rest * shares[:, None]))
        u[:, 2] *= np.linalg.det(u @ vt)
        np.testing.assert_allclose(posed, rest @ (u @ vt).T + middle, atol=1e-8)
        self.assertGreater(np.abs(soft - posed).max(), 0.1)

    def test_the_gap_of_surfaces_and_the_sides_of_a_plane(self):
        other = self.points + [300, 0, 0]
        gap = viscera.surface_gap(self.points, self.triangles, other, self.triangles)
        self.assertAlmostEqual(np.linalg.norm(gap["to"] - gap["from"]), gap["mm"], places=9)
        between = np.linalg.norm(self.points[:, None] - other[None, ::7], axis=2).min()
        self.assertLessEqual(gap["mm"], between + 1e-9)
        self.assertGreater(gap["mm"], between - 5)
        middle = self.points.mean(axis=0)
        sides = viscera.sides_of_plane(self.points, self.triangles, middle, [0, 0, 5])
        whole = volume_of(self.points, self.triangles)
        self.assertAlmostEqual(sides["front_mm3"] + sides["back_mm3"], whole, delta=1e-9 * whole)
        turned = viscera.sides_of_plane(self.points, self.triangles, middle, [0, 0, -1])
        self.assertAlmostEqual(turned["front_mm3"], sides["back_mm3"], delta=1e-9 * whole)
        with self.assertRaises(viscera.UsageError):
            viscera.sides_of_plane(self.points, self.triangles, middle, [0, 0, 0])

    def test_a_lock_leaves_the_handles_of_the_pose_exactly_where_they_are(self):
        pose = self.handles.copy()
        pose[4] += [15, 0, 0]
        restored = viscera.lock_volume(self.binding, self.triangles, pose)
        np.testing.assert_array_equal(restored.handles[4], pose[4])
        self.assertGreater(restored.largest_shift, 0)

    def test_lock_keeps_the_volume_exactly(self):
        pose = self.handles.copy()
        pose[10] += [6, -4, 3]
        rest = viscera.volume(self.points, self.triangles)
        kept = viscera.lock_volume(self.binding, self.triangles, pose)
        self.assertLess(abs(viscera.volume(self.binding.pose(kept.handles), self.triangles) / rest - 1), 1e-12)
        np.testing.assert_array_equal(kept.handles[10], pose[10])
        more = viscera.lock_volume(self.binding, self.triangles, pose, target=1.05 * rest)
        self.assertLess(abs(viscera.volume(self.binding.pose(more.handles), self.triangles) / rest - 1.05), 1e-11)
        with self.assertRaises(viscera.DataError):
            viscera.lock_volume(self.binding, self.triangles, pose, target=9 * rest, limit=1)
        with self.assertRaises(viscera.UsageError):
            viscera.lock_volume(self.binding, self.triangles, pose, free=[99])

    def test_stress_is_what_the_singular_values_say(self):
        inside = 0.8 * self.points[::20]
        stress = viscera.StressPoints(self.binding, inside)
        self.assertTrue(stress.closed_form)
        gradients = stress.deformation_gradients(self.pose)
        s = np.linalg.svd(gradients)[1]
        found = stress.evaluate(self.pose)
        np.testing.assert_allclose(
            found.rotational_stress, np.arcsin((s[:, 0] - s[:, 2]) / (s[:, 0] + s[:, 2])), atol=1e-9
        )
        np.testing.assert_allclose(found.volume_ratio, np.linalg.det(gradients), rtol=1e-9)
        by_weights = self.binding.gradients(inside)
        np.testing.assert_allclose(np.einsum("hi,phj->pij", self.pose, by_weights), gradients, atol=1e-9)
        self.assertEqual(viscera.rotational_stress(self.binding, self.handles, inside).folded, 0)

    def test_stress_of_two_poses_and_over_poses(self):
        inside = 0.8 * self.points[::40]
        stress = viscera.StressPoints(self.binding, inside)
        one, other = stress.evaluate(self.pose), stress.evaluate(self.handles)
        difference = viscera.stress_difference(self.binding, self.pose, self.handles, inside)
        np.testing.assert_allclose(
            difference["stress_degrees"], np.degrees(one.rotational_stress - other.rotational_stress), atol=1e-9
        )
        np.testing.assert_allclose(difference["volume_ratio"], one.volume_ratio - other.volume_ratio, atol=1e-12)
        curves = viscera.stress_curves(self.binding, [self.handles, self.pose], inside)
        self.assertEqual(curves["stretch_max"].shape, (2, len(inside)))
        np.testing.assert_array_equal(curves["stretch_max"][1], one.stretch_max)
        mirrored = np.asarray(self.handles) * [-1, 1, 1]
        self.assertTrue(np.isnan(viscera.stress_curves(self.binding, [mirrored], inside)["stress_degrees"]).all())
        with self.assertRaises(viscera.UsageError):
            viscera.stress_curves(self.binding, [], inside)

    def test_no_result_depends_on_threads(self):
        one = viscera.bind(self.points, self.handles, threads=1)
        np.testing.assert_array_equal(one.pose(self.pose, threads=1), self.binding.pose(self.pose))


class Systems(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = kidney(8, 10)
        self.handles = viscera.place_handles(self.points, self.triangles, 14)

    def test_every_system_binds_and_follows_an_affine_motion(self):
        turn = np.array([[1.1, 0.2, 0], [0, 0.9, 0.1], [0.05, 0, 1]])
        for system in viscera.systems():
            with self.subTest(system.id):
                binding = viscera.bind(0.9 * self.points, self.handles, system.id, partial=True)
                bound = np.setdiff1d(np.arange(len(self.points)), binding.report["failures"])
                self.assertGreater(len(bound), 0)
                if system.traits["affine"]:
                    np.testing.assert_allclose(
                        binding.pose(self.handles @ turn)[bound], (0.9 * self.points @ turn)[bound], atol=1e-5
                    )

    def test_parameters_are_offered_checked_and_used(self):
        offered = {each.name: each for each in viscera.system("s-celestial").parameters}
        self.assertEqual(offered["softness"].unit, "mm")
        hard, soft = viscera.sweep(self.points, self.handles, "softness", [0, 20])
        self.assertGreater(abs(hard.weights - soft.weights).max(), 0.01)
        for wrong in ({"softness": -1}, {"no_such": 1}, {"softness": "many"}):
            with self.assertRaises(viscera.UsageError):
                viscera.bind(self.points, self.handles, **wrong)
        target = next(each for each in viscera.system("lagrange-minimisation").parameters if each.name == "target")
        by_name, by_number = (
            viscera.bind(self.points, self.handles, "lagrange-minimisation", target=value)
            for value in (target.choices[1], 1)
        )
        np.testing.assert_array_equal(by_name.weights, by_number.weights)

    def test_cages_and_groups_reach_the_system(self):
        box = viscera.enclosing_handles(self.points)
        with self.assertRaises(viscera.DataError):
            viscera.bind(self.points, box, "mean-value", triangles=[[0, 1, 2]])
        grouped, groups = viscera.groups_along_axis(self.handles, self.points, 2)
        binding = viscera.bind(self.points, grouped, "localised-s-celestial", groups=groups)
        self.assertTrue((binding.weights == 0).any())
        with self.assertRaises(viscera.DataError):
            viscera.bind(self.points, self.handles, "localised-s-celestial", groups={"left": [0, 1, 99, 3]})

    def test_pascals_are_of_a_stated_material(self):
        stretch = np.diag([1.1, 1.0, 1.0])
        binding = viscera.bind(self.points, self.handles)
        points, _, count = viscera.grid_witnesses(self.points, self.triangles, 200)
        found = viscera.StressPoints(binding, points[:count]).evaluate(self.handles @ stretch)
        with self.assertRaisesRegex(viscera.UsageError, "material"):
            found.von_mises_kpa()
        with self.assertRaises(viscera.UsageError):
            found.von_mises_kpa("hair")
        shear = 6.27 / 2.98
        np.testing.assert_allclose(found.von_mises_kpa("liver"), shear * 0.21 / 1.1, rtol=1e-6)
        np.testing.assert_allclose(
            found.strain_energy_kpa(young=6.27), shear * (0.105 - np.log(1.1) + 0.5 * 49 * 0.01), rtol=1e-6
        )
        self.assertIn("liver", [tissue["name"] for tissue in viscera.tissues()])

    def test_an_elastic_organ_goes_with_its_handles(self):
        pose = self.handles.copy()
        pose[8] += [0, 1, 0]
        found = viscera.elasticity(self.points, self.triangles, self.handles, pose, tetrahedra=200)
        self.assertEqual(found["points"].shape, self.points.shape)
        self.assertAlmostEqual(found["drag_mm"], 1.0)
        self.assertNotIn("energy_mj", found)
        with self.assertRaises(viscera.UsageError):
            viscera.elasticity(self.points, self.triangles, self.handles, pose, others="none")

    def test_tetrahedra_fill_the_surface(self):
        points, tetrahedra, inside = viscera.tetrahedralise(self.points, self.triangles, 500.0)
        np.testing.assert_array_equal(points[inside:], self.points)
        edges = points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]
        self.assertAlmostEqual(
            np.linalg.det(edges).sum() / 6 / viscera.volume(self.points, self.triangles), 1, 9
        )


class Circulation(unittest.TestCase):
    def test_curves_and_indices_agree_and_no_blood_is_lost(self):
        found = viscera.circulate()
        self.assertTrue(found.converged, found.failure_reason)
        self.assertLess(found.volume_error_ml, 1e-4)
        curves, lv = found.curves, found.indices["lv"]
        self.assertEqual({len(curve) for curve in curves.values()}, {len(curves["time_s"])})
        self.assertAlmostEqual(curves["lv_ml"].max(), lv["end_diastolic_volume_ml"], 1)
        self.assertAlmostEqual(curves["lv_ml"].min(), lv["end_systolic_volume_ml"], 1)
        work = np.trapz(-curves["lv_mmHg"], curves["lv_ml"]) * 133.322e-6  # mmHg ml in J
        self.assertAlmostEqual(work / lv["stroke_work_J"], 1, 2)
        self.assertEqual(found.parameters["rate"], 72)
        self.assertIn("S1 mitral", [name for name, *_ in found.sounds])

    def test_scenarios_and_parameters_are_those_of_the_catalogue(self):
        self.assertEqual(viscera.scenarios()[0].id, "rest")
        narrow = next(each for each in viscera.scenarios() if each.id == "aortic-stenosis")
        self.assertGreater(narrow.left_muscle, 1)
        found = viscera.circulate(narrow.id, rate=80)
        self.assertLessEqual(set(narrow.changes.items()), set(found.parameters.items()))
        self.assertEqual(found.parameters["rate"], 80)
        self.assertGreater(found.indices["aortic_mean_gradient_mmHg"], 20)
        rate = next(each for each in viscera.circulation_parameters() if each.name == "rate")
        for wrong in ({"scenario": "nothing"}, {"no_such": 1}, {"rate": rate.maximum + 1}):
            with self.assertRaises(viscera.UsageError):
                viscera.circulate(**wrong)

    def test_a_near_beginning_saves_beats_and_ends_the_same(self):
        near = viscera.circulate(stressedVolume=1100)
        plain, begun = viscera.circulate(stressedVolume=1101), viscera.circulate(stressedVolume=1101, near=near)
        self.assertLess(begun.beats, plain.beats)
        np.testing.assert_allclose(begun.curves["lv_ml"], plain.curves["lv_ml"], atol=1e-4)

    def test_stroke_volume_answers_to_filling(self):
        answers = viscera.circulation_response("stressedVolume", np.array([800.0, 1000]))
        self.assertGreater(answers[1]["lv"]["sv_ml"], answers[0]["lv"]["sv_ml"])
        with self.assertRaises(viscera.Cancelled):
            viscera.circulation_response("rate", np.linspace(50, 150, 60), progress=lambda fraction, step: False)


class Memory(unittest.TestCase):
    def test_arrays_are_taken_and_returned_without_copies(self):
        points, triangles = kidney()
        own = viscera.as_points(points)
        self.assertTrue(np.shares_memory(own, viscera.as_points(own)))
        binding = viscera.bind(own, viscera.place_handles(own, triangles))
        self.assertTrue(np.shares_memory(own, binding.points))
        self.assertFalse(binding.points.flags.writeable)
        posed = binding.pose(binding.handles)
        address = posed.ctypes.data
        self.assertIs(binding.pose(binding.handles, out=posed), posed)
        self.assertEqual(posed.ctypes.data, address)
        tiles = binding.weight_tiles
        np.testing.assert_array_equal(
            tiles.transpose(0, 2, 1).reshape(-1, tiles.shape[1])[: len(own)], binding.weights
        )
        self.assertTrue(np.shares_memory(tiles, binding.weight_tiles))

    def test_views_keep_the_memory_of_their_objects_alive(self):
        points, triangles = kidney(8, 10)
        binding = viscera.bind(points, viscera.place_handles(points, triangles))
        tiles, stress = binding.weight_tiles, viscera.rotational_stress(binding, binding.handles).volume_ratio
        total = tiles.sum()
        del binding
        filler = [np.random.default_rng(i).random(1000) for i in range(50)]
        self.assertEqual(tiles.sum(), total)
        np.testing.assert_allclose(stress, 1, atol=1e-9)
        del filler

    def test_arrays_of_other_kinds_are_converted_or_refused(self):
        points, triangles = kidney(8, 10)
        expected = viscera.volume(points, triangles)
        self.assertEqual(viscera.volume(points.tolist(), triangles.astype(np.int64)), expected)
        self.assertEqual(viscera.volume(np.asfortranarray(points), triangles.astype(np.uint16)), expected)
        for wrong_points, wrong_triangles in (
            (points[:, :2], triangles),
            (points, triangles.astype(float)),
            (points, triangles + 1000),
            (points, triangles.astype(np.int64) + 2**40),
            ("points", triangles),
            (points, triangles - 50),
        ):
            with self.assertRaises(viscera.DataError):
                viscera.volume(wrong_points, wrong_triangles)
        with self.assertRaises(viscera.UsageError):
            viscera.bind(points, viscera.enclosing_handles(points)).pose(
                viscera.enclosing_handles(points), out=np.empty_like(points)
            )


class LongJobs(unittest.TestCase):
    """On a binding that takes a second or more unless it is ended."""

    def setUp(self):
        points, triangles = kidney(100, 200)
        self.arguments = (0.9 * points, viscera.place_handles(points, triangles), "numerical-integration")

    def test_listeners_hear_and_may_cancel(self):
        heard = []

        def cancel_soon(fraction, step):
            heard.append(fraction)
            return False

        with self.assertRaises(viscera.Cancelled):
            viscera.bind(*self.arguments, progress=cancel_soon)
        self.assertGreaterEqual(len(heard), 1)
        self.assertLess(heard[0], 1)

    def test_what_a_listener_raises_ends_the_job(self):
        with self.assertRaisesRegex(RuntimeError, "enough"):
            viscera.bind(*self.arguments, progress=lambda fraction, step: (_ for _ in ()).throw(RuntimeError("enough")))

    def test_control_c_is_a_keyboard_interrupt(self):
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                viscera.bind(*self.arguments)
                time.sleep(5)
        finally:
            timer.join()

    def test_other_threads_run_meanwhile(self):
        counted = [0]
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.002)

        other = threading.Thread(target=count)
        other.start()
        before = counted[0]
        try:
            with self.assertRaises(viscera.Cancelled):
                viscera.bind(*self.arguments, progress=lambda fraction, step: counted[0] - before < 5)
        finally:
            stop.set()
            other.join()


class Errors(unittest.TestCase):
    def test_errors_say_what_where_and_what_to_try(self):
        points, triangles = kidney(8, 10)
        handles = viscera.place_handles(points, triangles)
        with self.assertRaises(viscera.UnboundVertices) as caught:
            viscera.bind(np.vstack([points, [900, 0, 0]]), handles)
        self.assertEqual(caught.exception.vertices.tolist(), [len(points)])
        self.assertIn("enclosing", caught.exception.try_this)
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaisesRegex(viscera.UsageError, "s-celestial"):
            viscera.bind(points, handles, "celestial")
        with self.assertRaises(viscera.DataError):
            viscera.bind(points, handles[:3])
        with self.assertRaisesRegex(viscera.DataError, "30"):
            viscera.bind(points, handles).pose(handles[:-1])
        with self.assertRaises(viscera.DataError):
            viscera.keyframes(handles, [0.0, 0.0], [handles, handles], 1.0)


class Documentation(unittest.TestCase):
    def names_in(self, stub):
        """Names of a stub, with those of its classes, and the arguments of functions."""
        found = {}
        for node in ast.parse((SOURCE / stub).read_text()).body:
            if isinstance(node, ast.FunctionDef):
                found[node.name] = [a.arg for a in node.args.args]
            elif isinstance(node, ast.ClassDef):
                found[node.name] = None
                for member in node.body:
                    if isinstance(member, ast.FunctionDef):
                        found[f"{node.name}.{member.name}"] = None
                    elif isinstance(member, ast.AnnAssign):
                        found[f"{node.name}.{member.target.id}"] = None
        return found

    def test_stubs_say_what_there_is(self):
        import importlib

        for name in ("_core", "_files", "_motion"):
            try:
                module = importlib.import_module("viscera." + name)
            except ImportError:
                self.assertNotEqual(name, "_core")
                continue
            there = set()
            for key, value in vars(module).items():
                if key.startswith("_") or inspect.ismodule(value):
                    continue
                there.add(key)
                if inspect.isclass(value):
                    there |= {f"{key}.{k}" for k in vars(value) if not k.startswith("_")}
            stub = self.names_in(name + ".pyi")
            said = {key for key in stub if not key.split(".")[-1].startswith("_")}
            self.assertEqual(there - said, set(), name)
            self.assertEqual(said - there, set(), name)
            for key, arguments in stub.items():
                if arguments is not None:
                    signature = getattr(module, key).__doc__.splitlines()[0]
                    for argument in arguments:
                        self.assertIn(argument + ":", signature, key)

    def test_everything_public_is_described_with_its_units(self):
        for name in viscera.__all__:
            self.assertTrue(getattr(viscera, name).__doc__, name)
        for owner in (_core.Binding, _core.VolumeLock, _core.StressPoints, _core.StressMap, _core.Circulation):
            for name, member in vars(owner).items():
                if not name.startswith("_"):
                    self.assertTrue(inspect.getdoc(member), f"{owner.__name__}.{name}")
        for name in ("bind", "volume", "area", "place_handles", "volume_gradient", "lock_volume"):
            self.assertRegex(getattr(viscera, name).__doc__, "mm", name)

    def test_whatever_takes_an_array_says_its_shape(self):
        arrays = {"points", "triangles", "handles", "rest_handles", "poses", "point_gradient", "positions"}
        members = {name: getattr(viscera, name) for name in viscera.__all__}
        for name, owner in list(members.items()):
            if inspect.isclass(owner):
                members |= {f"{name}.{key}": member for key, member in vars(owner).items() if not key.startswith("_")}
        checked = 0
        for name, member in members.items():
            text = inspect.getdoc(member) or ""
            if inspect.isfunction(member):
                arguments = set(inspect.signature(member).parameters)
            else:
                arguments = set(re.findall(r"(\w+):", text.splitlines()[0])) if inspect.isroutine(member) else set()
            if arguments & arrays and name != "track":  # its handles are a number
                self.assertRegex(text, r"\b[a-z] x (3|4|h|r)\b", name)
                checked += 1
        self.assertGreater(checked, 20)


if __name__ == "__main__":
    unittest.main()
