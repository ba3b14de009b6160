"""What ParaView's window runs for paraview_test.py: a handle is dragged by ParaView's own widget.

paraview --dr --script=in_window.py, with VISCERA_PLUGIN naming the plugin and VISCERA_RESULTS a folder. A ball between eight
handles, a source at rest and one to drag. Timers let the window draw itself between the steps. The mouse's events go to the
view's interactor, as those of the real one do. Prints DRAGGED with the handle and its way, and the volumes, and ends.
"""

import os
import sys
import time
import traceback

from paraview import simple

HANDLE = 7
AWAY = (60, 40)  # Pixels.
folder = os.environ["VISCERA_RESULTS"]


def finish(status):
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # a window's script cannot close the window


class Drag:
    """The steps, one a timer."""

    def __init__(self):
        simple.GetSettingsProxy("GeneralSettings").AutoApply = 1  # what the button Apply does
        simple.LoadPlugin(os.environ["VISCERA_PLUGIN"], remote=False, ns=globals())
        ball = simple.Clean(Input=simple.Sphere(Radius=40, ThetaResolution=60, PhiResolution=60))
        self.rest = VisceraHandles(registrationName="At rest")  # noqa: F821
        self.posed = VisceraHandles(registrationName="Posed")  # noqa: F821
        self.warped = VisceraDeform(Input=ball, RestHandles=self.rest, PosedHandles=self.posed)  # noqa: F821
        self.view = simple.GetActiveViewOrCreate("RenderView")
        simple.Show(self.warped, self.view)
        self.view.CameraPosition = [150.0, 250.0, 120.0]
        self.view.CameraFocalPoint = [0.0, 0.0, 0.0]
        self.view.CameraViewUp = [0.0, 0.0, 1.0]
        simple.ResetCamera(self.view)
        simple.SetActiveSource(self.posed)  # its properties, and with them its widget, are shown
        self.steps = [self.show_widget, self.look, self.drag, self.look_again]
        self.interactor = self.view.GetInteractor()
        self.interactor.AddObserver("TimerEvent", self.next)
        self.interactor.CreateRepeatingTimer(100)
        self.wait()

    def wait(self):
        self.due = time.monotonic() + 2  # the panel applies a change a second after it

    def next(self, caller, event):
        if time.monotonic() < self.due:
            return
        try:
            simple.Render(self.view)
            self.steps.pop(0)()
        except BaseException:
            traceback.print_exc()
            finish(1)
        self.wait()

    def volume(self):
        self.warped.UpdatePipeline()
        self.warped.UpdatePropertyInformation()
        return self.warped.SMProxy.GetProperty("Volume").GetElement(0)

    def handles(self):
        numbers = list(self.posed.Points)
        return [numbers[i : i + 3] for i in range(0, len(numbers), 3)]

    def on_screen(self, place):
        renderer = self.view.GetRenderer()
        renderer.SetWorldPoint(*place, 1)
        renderer.WorldToDisplay()
        return [round(each) for each in renderer.GetDisplayPoint()[:2]]

    def show_widget(self):
        """As the panel's box "Show Spline", which is checked for sources from the menu, not for those of a script."""
        shown = self.view.SMProxy.GetProperty("HiddenRepresentations")
        widgets = [shown.GetProxy(i) for i in range(shown.GetNumberOfProxies())]
        widget = [each for each in widgets if "PolyLine" in each.GetXMLName()][-1]  # of the source that is active
        for name in ("Visibility", "Enabled"):
            widget.GetProperty(name).SetElement(0, 1)
        widget.UpdateVTKObjects()

    def look(self):
        self.before, self.rest_volume = self.handles(), self.volume()
        simple.SaveScreenshot(f"{folder}/before.png", self.view)

    def drag(self):
        x, y = self.on_screen(self.before[HANDLE])
        send = self.interactor.InvokeEvent
        for step in range(11):
            at = x + AWAY[0] * step // 10, y + AWAY[1] * step // 10
            self.interactor.SetEventInformation(*at, 0, 0, chr(0), 0, None)
            send("MouseMoveEvent")
            if step == 0:
                send("LeftButtonPressEvent")
        send("LeftButtonReleaseEvent")

    def look_again(self):
        after = self.handles()
        moved = [i for i, (old, new) in enumerate(zip(self.before, after)) if old != new]
        there = self.on_screen(after[HANDLE])
        asked = [at + by for at, by in zip(self.on_screen(self.before[HANDLE]), AWAY)]
        simple.SaveScreenshot(f"{folder}/dragged.png", self.view)
        print("DRAGGED", moved, "missed by", max(abs(a - b) for a, b in zip(there, asked)), "pixels; volume",
              self.rest_volume, self.volume())
        finish(0)


try:
    keep = Drag()
except BaseException:
    traceback.print_exc()
    finish(1)
