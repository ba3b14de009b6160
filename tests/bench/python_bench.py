"""The package for numpy against the benchmark in C++, and against S-Celestial coordinates written in numpy.

PYTHONPATH=build/release/python /usr/bin/python3 tests/bench/python_bench.py build/release/bin/bench_coordinates

Processor time of one thread, which neighbours disturb least; short rounds of C++ and Python alternate, and the least of each
is taken. The middle of the rounds' ratios is told too.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

import viscera

ROUNDS = 15
ROUND_SECONDS = 0.1
BENCH = sys.argv[1]
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "modules/bindings/python/examples"))


def blob(rings, segments):
    """The surface of bench_scenes.h."""
    theta = np.pi * np.arange(1, rings + 1)[:, None] / (rings + 1)
    phi = 2 * np.pi * np.arange(segments)[None, :] / segments
    radius = 50 * (1 + 0.12 * np.sin(3 * theta) * np.cos(2 * phi) + 0.05 * np.sin(theta) * np.sin(7 * phi))
    ring = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta) + 0 * phi], axis=-1)
    points = np.vstack([(radius[..., None] * ring).reshape(-1, 3), [[0, 0, 50.0], [0, 0, -50.0]]])
    a = (np.arange(rings - 1)[:, None] * segments + np.arange(segments)).ravel()
    b = (np.arange(rings - 1)[:, None] * segments + (np.arange(segments) + 1) % segments).ravel()
    one, two = np.arange(segments), (np.arange(segments) + 1) % segments
    north, south, last = rings * segments, rings * segments + 1, (rings - 1) * segments
    triangles = np.vstack(
        [
            np.stack([a, a + segments, b + segments], axis=1),
            np.stack([a, b + segments, b], axis=1),
            np.stack([np.full(segments, north), one, two], axis=1),
            np.stack([np.full(segments, south), last + two, last + one], axis=1),
        ]
    )
    return points, triangles.astype(np.int32)


def in_cpp(name):
    """Seconds of processor for one iteration, by Google Benchmark, and for how many vertices."""
    done = subprocess.run(
        [BENCH, f"--benchmark_filter={name}", "--benchmark_format=json", f"--benchmark_min_time={ROUND_SECONDS}"],
        capture_output=True, text=True, check=True,
    )
    found = json.loads(done.stdout)["benchmarks"][0]
    return found["cpu_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}[found["time_unit"]], found.get("vertices")


def in_python(job, least=ROUND_SECONDS):
    """Seconds of processor for one call."""
    job()
    calls, begin = 0, time.process_time()
    while time.process_time() - begin < least:
        job()
        calls += 1
    return (time.process_time() - begin) / calls


def s_celestial(points, handles, iterations=12):
    """The weights by damped Newton steps on all points at once (thesis 4.4), as one would write it in numpy."""
    away = handles[None] - points[:, None]
    distance = np.linalg.norm(away, axis=2)
    q = away / distance[..., None]
    x = np.zeros_like(points)
    for _ in range(iterations):
        t = np.einsum("phi,pi->ph", q, x)
        root = np.sqrt(t * t + 1)
        phi = (t + root) ** 2
        gradient = np.einsum("ph,phi->pi", phi, q)
        hessian = np.einsum("ph,phi,phj->pij", 2 * phi / root, q, q)
        step = np.linalg.solve(hessian, -gradient[..., None])[..., 0]
        length = np.linalg.norm(step, axis=1, keepdims=True)
        x += step * np.minimum(1, 1 / np.maximum(length, 1e-300))
    weights = phi / distance
    return weights / weights.sum(axis=1, keepdims=True)


def compare(what, cpp, python):
    """The least of alternating rounds, and the middle of the rounds' ratios."""
    rounds = [(cpp(), python()) for _ in range(ROUNDS)]
    least = [min(each) for each in zip(*rounds)]
    middle = statistics.median(own / native for native, own in rounds)
    print(f"{what}: C++ {1e3 * least[0]:.3f} ms, numpy {1e3 * least[1]:.3f} ms, overhead "
          f"{100 * (least[1] / least[0] - 1):+.1f} % of the least, {100 * (middle - 1):+.1f} % in the middle of {ROUNDS} rounds",
          flush=True)
    return least


large, large_triangles = blob(332, 521)
handles = viscera.place_handles(large, large_triangles)
binding = viscera.bind(large, handles, threads=1)
pose = handles + 1.0
out = binding.pose(pose)
compare(f"pose of {len(large)} vertices", lambda: in_cpp("poseAllHandles/threads:1/large:1")[0],
        lambda: in_python(lambda: binding.pose(pose, out=out, threads=1)))
fresh = in_python(lambda: binding.pose(pose, threads=1))
print(f"the same into a new array: {1e3 * fresh:.3f} ms")

vertices = in_cpp("bind<sCelestial>/threads:1/locality:0")[1]
bunny = pathlib.Path(__file__).parents[3] / "shared/organs/bunny.obj"
if bunny.is_file():  # the benchmark's, in mm
    lines = bunny.read_text().splitlines()
    small = 1000 * np.array([line.split()[1:4] for line in lines if line.startswith("v ")], dtype=float)
    small_triangles = np.array([[word.split("/")[0] for word in line.split()[1:4]] for line in lines if line.startswith("f ")],
                               dtype=np.int32) - 1
else:
    small, small_triangles = blob(155, 232)
if len(small) == vertices:
    around = viscera.place_handles(small, small_triangles)
    own = viscera.as_points(small)
    seconds = compare(f"bind {len(small)} vertices", lambda: in_cpp("bind<sCelestial>/threads:1/locality:0")[0],
                      lambda: in_python(lambda: viscera.bind(own, around, threads=1)))
    begin = time.process_time()
    weights = s_celestial(small, around)
    plain = time.process_time() - begin
    error = abs(weights - viscera.bind(own, around).weights).max()
    print(f"S-Celestial written in numpy: {plain:.2f} s, {plain / seconds[1]:.0f} times as long; largest difference "
          f"of a weight {error:.1e}")
else:
    print(f"bind is left out: the C++ benchmark takes a surface of {vertices} vertices that is not here")
