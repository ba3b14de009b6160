#!/usr/bin/python3
"""Opens a lesson in Firefox over Marionette; Python's standard library only. By hand, under a display:

  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1400x1000x24" check_firefox.py LESSON.html TRUTH.json [PICTURE.png]

TRUTH.json as for check_page.py. Headless, Firefox says that it has no WebGL 2."""
import base64, json, pathlib, socket, subprocess, sys, tempfile, time

PREFERENCES = {"webgl.force-enabled": True, "marionette.port": 2829, "app.update.enabled": False, "ui.prefersReducedMotion": 1,
               "datareporting.policy.dataSubmissionEnabled": False, "network.captive-portal-service.enabled": False}


class Firefox:
    def __init__(self):
        self.home = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        lines = [f'user_pref("{k}", {json.dumps(v)});' for k, v in PREFERENCES.items()]
        pathlib.Path(self.home.name, "user.js").write_text("\n".join(lines))
        self.process = subprocess.Popen(["firefox-esr", "--marionette", "--profile", self.home.name], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.unread, self.number = b"", 0
        for _ in range(300):
            try:
                self.socket = socket.create_connection(("127.0.0.1", PREFERENCES["marionette.port"]), 120)
                break
            except OSError:
                time.sleep(0.2)
        self.receive()
        self.ask("WebDriver:NewSession", capabilities={})

    def receive(self):
        while b":" not in self.unread:
            self.unread += self.socket.recv(65536)
        size, _, data = self.unread.partition(b":")
        while len(data) < int(size):
            data += self.socket.recv(1 << 20)
        self.unread = data[int(size):]
        return json.loads(data[:int(size)])

    def ask(self, command, **parameters):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters]).encode()
        self.socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self.receive()
        if error:
            raise SystemExit(f"{command}: {error['message']}")
        return result


def main(lesson, truth, picture=None):
    truth, failed, f = json.loads(pathlib.Path(truth).read_text()), [], Firefox()

    def check(name, good, detail=""):
        print("passed" if good else "FAILED", name, detail)
        failed.extend([] if good else [name])
    try:
        f.ask("WebDriver:SetWindowRect", width=1280, height=900)
        f.ask("WebDriver:Navigate", url=pathlib.Path(lesson).resolve().as_uri())
        begin = time.time()
        ready = None
        while not ready and time.time() - begin < 90:
            ready = f.ask("WebDriver:ExecuteScript", script="return document.documentElement.dataset.ready || null", args=[], sandbox="default")["value"]
            time.sleep(0.2)
        check("ready", bool(ready), f"{ready} ms")
        call = lambda code: f.ask("WebDriver:ExecuteScript", script=f"const viscera = window.wrappedJSObject.viscera; return {code}", args=[], sandbox="default")["value"]
        worst = worst_volume = 0
        for instant in truth["instants"]:
            call(f"(viscera.setRate({instant['rate']}), viscera.seek({instant['fraction']}), viscera.render(), null)")
            found = call(f"Array.from({json.dumps(truth['vertices'])}, v => Array.from(viscera.placeOf(v)))")
            worst = max([worst] + [sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5 for p, q in zip(found, instant["points"])])
            for a, b in zip(call("Array.from(viscera.volumes())"), instant["volumesMl"]):
                worst_volume = max(worst_volume, abs(a - b) / b)
        check("vertices are the program's", worst < 0.05, f"{worst:.4f} mm over {len(truth['instants'])} instants")
        check("volumes are the program's", worst_volume < 5e-4, f"{100 * worst_volume:.4f} %")
        print("ms of 20 frames", call("(() => { const t = viscera.times; for (const k of ['pose', 'shade', 'volume', 'draw']) t[k] = 0; for (let i = 0; i < 20; ++i) { viscera.seek(i / 20); viscera.render(); } return JSON.stringify(t); })()"))
        before = call("Array.from(viscera.volumes())")
        element = {"element-6066-11e4-a52e-4f735466cecf": list(f.ask("WebDriver:FindElement", using="css selector", value="#view")["value"].values())[0]}
        place = call("(() => { viscera.setSide('anterior'); viscera.showHandles(true); viscera.render(); const v = document.getElementById('view'), r = v.getBoundingClientRect();"
                     "for (let i = 0; i < viscera.handles.length; ++i) { const p = viscera.project(viscera.placeOf(viscera.handles[i].vertex)), x = p[0] + r.x, y = p[1] + r.y;"
                     "if (document.elementFromPoint(x, y) === v) return [Math.round(x - r.x - r.width / 2), Math.round(y - r.y - r.height / 2)]; } })()")
        moves = [{"type": "pointerMove", "x": place[0], "y": place[1], "origin": element}, {"type": "pointerDown", "button": 0},
                 {"type": "pointerMove", "x": place[0] + 30, "y": place[1] - 20, "origin": element}, {"type": "pointerUp", "button": 0}]
        f.ask("WebDriver:PerformActions", actions=[{"type": "pointer", "id": "m", "parameters": {"pointerType": "mouse"}, "actions": moves}])
        call("(viscera.render(), null)")
        after = call("Array.from(viscera.volumes())")
        check("the mouse drags a handle", any(abs(a - b) > 0.02 for a, b in zip(before, after)), [round(b - a, 2) for a, b in zip(before, after)])
        f.ask("WebDriver:PerformActions", actions=[{"type": "key", "id": "k", "actions": [{"type": "keyDown", "value": "r"}, {"type": "keyUp", "value": "r"}]}])
        check("a key puts it back", call("(viscera.render(), !viscera.handles.some(h => h.pull.some(x => x)))"))
        if picture:
            call("(viscera.showHandles(false), viscera.render(), null)")
            pathlib.Path(picture).write_bytes(base64.b64decode(f.ask("WebDriver:TakeScreenshot", full=False)["value"]))
    finally:
        f.process.terminate()
        f.process.wait(20)
    print(f"{len(failed)} failed" if failed else "all passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
