"""The filters of VTK in one process, against the package for numpy."""

import base64
import json
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

import numpy as np
from organ_pieces import cut, data_of, handles, kidney, point_data, solid, surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPPolyDataReader, vtkXMLPUnstructuredGridReader
from viscera_vtk.vtkVisceraFilters import (
    vtkVisceraDeformFilter,
    vtkVisceraHandleSource,
    vtkVisceraStressFilter,
)

import viscera
from viscera import paraview

POINTS, TRIANGLES = surface()
REST, POSE = handles(POINTS)


def filter_on(data, kind=vtkVisceraDeformFilter, rest=REST, pose=POSE, **properties):
    made = kind()
    made.SetInputData(data)
    made.SetRestHandlesData(point_data(rest))
    made.SetPosedHandlesData(point_data(pose))
    for name, value in properties.items():
        getattr(made, "Set" + name)(value)
    return made


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def number(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


class Deform(unittest.TestCase):
    def test_points_are_those_of_the_package(self):
        made = filter_on(data_of(POINTS, TRIANGLES))
        made.Update()
        binding = viscera.bind(POINTS, REST)
        np.testing.assert_array_equal(points_of(made.GetOutput()), binding.pose(POSE))
        volume = viscera.volume(binding.pose(POSE), TRIANGLES)
        self.assertLess(abs(made.GetVolume() / volume - 1), 1e-13)
        self.assertEqual(number(made.GetOutput(), "Volume"), made.GetVolume())
        self.assertLess(made.GetVectorArea(), 1e-9)
        self.assertEqual(made.GetUnboundPoints(), 0)
        np.testing.assert_array_equal(points_of(made.GetOutput(1)), POSE)

    def test_system_and_parameters_are_used_or_refused(self):
        made = filter_on(data_of(POINTS, TRIANGLES), System="t-celestial", Softness=7.0)
        made.SetParameter("locality", 2.0)
        made.Update()
        expected = viscera.bind(POINTS, REST, "t-celestial", softness=7, locality=2).pose(POSE)
        np.testing.assert_array_equal(points_of(made.GetOutput()), expected)
        said = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(said)
        try:
            for wrong in ({"System": "nothing"}, {"System": "wachspress", "Softness": 3.0}):
                filter_on(data_of(POINTS, TRIANGLES), **wrong).Update()
            filter_on(data_of(POINTS, TRIANGLES), pose=POSE[:-1]).Update()
            filter_on(vtkImageData(), rest=REST).Update()
        finally:
            vtkOutputWindow.SetInstance(None)
        for text in ("no coordinate system 'nothing'", "no parameter 'softness'", "23 posed ones"):
            self.assertIn(text, said.GetOutput())

    def test_weights_are_kept_until_something_changes(self):
        made = filter_on(data_of(POINTS, TRIANGLES))
        made.Update()
        for pose in (REST, POSE + 1):
            made.SetPosedHandlesData(point_data(pose))
            made.Update()
            np.testing.assert_array_equal(points_of(made.GetOutput()), viscera.bind(POINTS, REST).pose(pose))
        moved = REST + [1, 0, 0]
        made.SetRestHandlesData(point_data(moved))
        made.Update()
        np.testing.assert_array_equal(points_of(made.GetOutput()), viscera.bind(POINTS, moved).pose(POSE + 1))
        made.KeepWeightsOff()
        made.Update()
        np.testing.assert_array_equal(points_of(made.GetOutput()), viscera.bind(POINTS, moved).pose(POSE + 1))

    def test_volume_has_the_same_bits_however_the_organ_is_cut(self):
        for points, cells in ((POINTS, TRIANGLES), solid()):
            rest, pose = handles(points)
            whole = filter_on(data_of(points, cells), rest=rest, pose=pose, LockVolume=True)
            whole.Update()
            self.assertGreater(abs(viscera.volume(POINTS, TRIANGLES)), 1e5)
            for pieces in (2, 5):
                blocks = vtkMultiBlockDataSet()
                for i, (rows, own, ghosts, others) in enumerate(cut(points, cells, pieces)):
                    blocks.SetBlock(2 * i, data_of(points[rows], own, ghosts, others))  # holes in between
                made = filter_on(blocks, rest=rest, pose=pose, LockVolume=True)
                made.Update()
                self.assertEqual(made.GetVolume(), whole.GetVolume())
                self.assertEqual(made.GetRestVolume(), whole.GetRestVolume())
                np.testing.assert_array_equal(points_of(made.GetOutput(1)), points_of(whole.GetOutput(1)))
                for i, (rows, *_) in enumerate(cut(points, cells, pieces)):
                    np.testing.assert_array_equal(
                        points_of(made.GetOutputDataObject(0).GetBlock(2 * i)),
                        points_of(whole.GetOutputDataObject(0))[rows],
                    )

    def test_lock_agrees_with_the_packages(self):
        made = filter_on(data_of(POINTS, TRIANGLES), LockVolume=True)
        made.Update()
        kept = viscera.lock_volume(viscera.bind(POINTS, REST), TRIANGLES, POSE)
        np.testing.assert_allclose(points_of(made.GetOutput(1)), kept.handles, atol=1e-6)
        self.assertLess(abs(made.GetVolumeRatio() - 1), 1e-13)
        made.SetTargetVolume(1.03 * made.GetRestVolume())
        made.Update()
        self.assertLess(abs(made.GetVolumeRatio() - 1.03), 1e-13)

    def test_handles_with_triangles_are_a_cage(self):
        box = viscera.enclosing_handles(POINTS)
        from scipy.spatial import ConvexHull

        hull = ConvexHull(box)
        faces = hull.simplices.copy()
        for face, equation in zip(faces, hull.equations):
            if np.cross(box[face[1]] - box[face[0]], box[face[2]] - box[face[0]]) @ equation[:3] < 0:
                face[:] = face[::-1]
        made = filter_on(data_of(POINTS, TRIANGLES), rest=box, pose=1.2 * box, System="mean-value")
        made.SetRestHandlesData(data_of(box, faces))
        made.Update()
        expected = viscera.bind(POINTS, box, "mean-value", triangles=faces).pose(1.2 * box)
        np.testing.assert_array_equal(points_of(made.GetOutput()), expected)

    def test_partitioned_data_and_empty_parts_are_taken(self):
        parts = vtkPartitionedDataSet()
        parts.SetNumberOfPartitions(3)
        for i, (rows, own, ghosts, others) in enumerate(cut(POINTS, TRIANGLES, 2)):
            parts.SetPartition(2 * i, data_of(POINTS[rows], own, ghosts, others))
        made = filter_on(parts)
        made.Update()
        whole = filter_on(data_of(POINTS, TRIANGLES))
        whole.Update()
        self.assertEqual(made.GetVolume(), whole.GetVolume())


class Stress(unittest.TestCase):
    def test_arrays_are_those_of_the_package(self):
        points, cells = solid()
        rest, pose = handles(points)
        made = filter_on(data_of(points, cells), vtkVisceraStressFilter, rest, pose, Softness=4.0)
        made.Update()
        expected = viscera.rotational_stress(viscera.bind(points, rest, softness=4), pose)
        data = made.GetOutput().GetPointData()
        for name, values in (
            ("RotationalStress", expected.rotational_stress),
            ("VolumeRatio", expected.volume_ratio),
            ("StretchMax", expected.stretch_max),
            ("StretchMin", expected.stretch_min),
        ):
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)), values)
        self.assertEqual(made.GetMaxRotationalStress(), expected.rotational_stress.max())
        sizes = abs(np.linalg.det(points[cells[:, 1:]] - points[cells[:, :1]]))
        mean = (sizes * expected.rotational_stress[cells].mean(axis=1)).sum() / sizes.sum()
        self.assertAlmostEqual(made.GetMeanRotationalStress(), mean, 12)
        np.testing.assert_array_equal(
            points_of(made.GetOutput()), viscera.bind(points, rest, softness=4).pose(pose)
        )
        made.PosePointsOff()
        made.Update()
        np.testing.assert_array_equal(points_of(made.GetOutput()), points)


class Handles(unittest.TestCase):
    def test_source_gives_points_or_places_them(self):
        source = vtkVisceraHandleSource()
        for i, place in enumerate(REST):
            source.SetPoint(i, *place)
        source.SetMovedHandle(3)
        source.SetDisplacement(1, 2, 3)
        source.Update()
        moved = REST.copy()
        moved[3] += [1, 2, 3]
        np.testing.assert_array_equal(points_of(source.GetOutput()), moved)
        placed = vtkVisceraHandleSource()
        placed.SetInputData(data_of(POINTS, TRIANGLES))
        placed.SetCount(20)
        made = vtkVisceraDeformFilter()
        made.SetInputData(data_of(POINTS, TRIANGLES))
        made.SetRestHandlesConnection(placed.GetOutputPort())
        made.SetPosedHandlesConnection(placed.GetOutputPort())
        made.Update()
        np.testing.assert_array_equal(
            points_of(placed.GetOutput()), viscera.place_handles(POINTS, TRIANGLES, 20)
        )
        np.testing.assert_allclose(points_of(made.GetOutput()), POINTS, atol=1e-9)


class Description(unittest.TestCase):
    def test_paraviews_lists_name_every_system_that_needs_no_groups(self):
        file = pathlib.Path(__file__).parents[2] / "modules/bindings/paraview/plugin/viscera.xml"
        lists = [each for each in xml.etree.ElementTree.parse(file).iter("StringListDomain") if each.get("name") == "systems"]
        self.assertEqual(len(lists), 2)
        known = [each.id for each in viscera.systems() if not each.traits["uses_groups"]]
        for names in lists:
            self.assertCountEqual([each.get("value") for each in names], known)


class Export(unittest.TestCase):
    def test_an_organ_for_paraview_is_read_by_vtk_in_pieces(self):
        for (points, cells), ending, reader in (
            ((POINTS, TRIANGLES), "pvtp", vtkXMLPPolyDataReader),
            (solid(), "pvtu", vtkXMLPUnstructuredGridReader),
        ):
            rest, pose = handles(points)
            with tempfile.TemporaryDirectory() as folder:
                script = paraview.export(folder, points, cells, rest, pose, 3)
                compile(script.read_text(), str(script), "exec")
                read = reader()
                read.SetFileName(f"{folder}/organ.{ending}")
                read.Update()
                here = vtkXMLPolyDataReader()
                here.SetFileName(f"{folder}/posed.vtp")
                here.Update()
            np.testing.assert_array_equal(points_of(here.GetOutput()), pose)
            made = filter_on(read.GetOutput(), rest=rest, pose=pose)
            made.Update()
            whole = filter_on(data_of(points, cells), rest=rest, pose=pose)
            whole.Update()
            self.assertEqual(made.GetVolume(), whole.GetVolume())
            self.assertEqual(made.GetRestVolume(), whole.GetRestVolume())

    def test_a_session_brings_organs_handles_and_coordinates(self):
        packed = {
            key: base64.b64encode(zlib.compress(array.tobytes())).decode()
            for key, array in (("points", POINTS), ("indices", TRIANGLES))
        }
        session = {
            "format": "viscera-session", "version": 2, "system": {"id": "t-celestial", "parameters": {"softness": 4}},
            "organs": [{"id": 1, "name": "Left kidney", "surface": packed}],
            "rig": {"handles": [{"id": 2, "label": "A", "rest": [0, 0, 1]},
                                {"id": 3, "label": "B", "rest": [1, 0, 0], "pose": [2, 0, 0]}]},
        }
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "s.viscera"
            file.write_text(json.dumps(session))
            read = paraview.read_session(file)
            self.assertEqual(len(paraview.export_session(file, folder, 2)), 1)
            self.assertTrue((pathlib.Path(folder) / "Left_kidney/organ1.vtp").is_file())
            file.write_text("{}")
            with self.assertRaises(viscera.DataError):
                paraview.read_session(file)
        np.testing.assert_array_equal(read.organs["Left kidney"][0], POINTS)
        np.testing.assert_array_equal(read.organs["Left kidney"][1], TRIANGLES)
        self.assertEqual((read.labels, read.system, read.parameters), (["A", "B"], "t-celestial", {"softness": 4}))
        np.testing.assert_array_equal(read.pose, [[0, 0, 1], [2, 0, 0]])
        with self.assertRaises(viscera.NoInputError):
            paraview.read_session("/nowhere.viscera")


if __name__ == "__main__":
    unittest.main()
