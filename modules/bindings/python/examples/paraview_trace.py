"""The ParaView plugin as a trace: a sphere between handles, one of which is dragged, at constant volume.

VISCERA_PLUGIN=.../Viscera.so pvpython paraview_trace.py FOLDER
"""

import os
import sys

plugin = os.environ.get("VISCERA_PLUGIN")
try:
    from paraview import simple
except ImportError as error:
    print(f"skipped: paraview is not there ({error})")
    sys.exit(77)
if not plugin:
    print("skipped: VISCERA_PLUGIN does not name the plugin")
    sys.exit(77)

folder = sys.argv[1] if len(sys.argv) > 1 else "."
simple.LoadPlugin(plugin, remote=False, ns=globals())

sphere = simple.Sphere(Radius=40, ThetaResolution=60, PhiResolution=60)
organ = simple.Triangulate(Input=simple.Clean(Input=sphere))
rest = VisceraPlaceHandles(Input=organ, Count=26)  # noqa: F821
posed = VisceraPlaceHandles(Input=organ, Count=26, MovedHandle=12, Displacement=[0.0, 15.0, 5.0])  # noqa: F821
bent = VisceraDeform(Input=organ, RestHandles=rest, PosedHandles=posed, LockVolume=1)  # noqa: F821
bent.UpdatePipeline()
bent.UpdatePropertyInformation()
volume, before = (bent.SMProxy.GetProperty(name).GetElement(0) for name in ("Volume", "RestVolume"))
print(f"volume {volume / 1000:.4f} ml, at rest {before / 1000:.4f} ml")
assert abs(volume / before - 1) < 1e-12

stress = VisceraStress(Input=organ, RestHandles=rest, PosedHandles=posed)  # noqa: F821
stress.UpdatePipeline()
low, high = stress.PointData["RotationalStress"].GetRange()
print(f"rotational stress up to {high:.3f} rad")
assert high > low >= 0
simple.SaveData(f"{folder}/bent.stl", proxy=bent)
