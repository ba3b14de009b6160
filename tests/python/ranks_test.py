"""The filters on 1, 2, 4 and 6 ranks of MPI: the same bits, whatever each rank holds, and no rank left waiting."""

import importlib
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

for needed in ("mpi4py.MPI", "vtkmodules.vtkParallelMPI"):
    try:
        importlib.import_module(needed) if needed != "mpi4py.MPI" else importlib.import_module("mpi4py")
    except ImportError as error:
        print(f"skipped: {needed} is not there ({error})")
        sys.exit(77)
if not shutil.which("mpirun"):
    print("skipped: there is no mpirun")
    sys.exit(77)

TIME_LIMIT = 100  # s: the failure of a collective is a hang
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMP_NUM_THREADS": "1"}


def run(ranks, *cases):
    """What rank 0 of that many says of each case."""
    script = pathlib.Path(__file__).with_name("one_rank.py")
    done = subprocess.run(
        ["mpirun", "--oversubscribe", "-np", str(ranks), sys.executable, str(script), *cases],
        env=ENVIRONMENT, timeout=TIME_LIMIT, capture_output=True, text=True,
    )
    if done.returncode != 0:
        raise AssertionError(f"{cases} on {ranks} ranks:\n{done.stdout}\n{done.stderr}")
    lines = [line.split(maxsplit=2) for line in done.stdout.splitlines() if line.startswith("CASE")]
    return {case: results for _, case, results in lines}


class Ranks(unittest.TestCase):
    def test_points_volumes_locked_poses_and_stress_have_the_same_bits(self):
        expected = run(1, "surface", "solid")
        for kind in ("surface", "solid"):
            self.assertIn("0x", expected[kind])
        for ranks, variants in ((2, ["", "-blocks"]), (4, ["", "-parts", "-serial"]), (6, ["", "-blocks"])):
            found = run(ranks, *(kind + variant for kind in expected for variant in variants))
            self.assertEqual(len(found), 2 * len(variants))
            for case, results in found.items():
                with self.subTest(case, ranks=ranks):
                    self.assertEqual(results, expected[case.split("-")[0]])

    def test_what_fails_on_one_rank_ends_all_with_its_message(self):
        self.assertEqual(run(4, "broken")["broken"], "3 3 3 3")

    def test_ranks_on_different_processors_are_refused(self):
        with open("/proc/cpuinfo") as processor:
            if "avx2" not in processor.read():
                self.skipTest("this processor has no wider vectors")
        self.assertEqual(run(2, "mixed")["mixed"], "3 3")


if __name__ == "__main__":
    unittest.main()
