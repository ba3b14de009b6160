"""Firefox, driven over Marionette; Python's standard library only. Needs a display: headless it has no WebGL 2."""
import base64, json, pathlib, socket, subprocess, tempfile, time

PORT = 2829
PREFERENCES = {"webgl.force-enabled": True, "marionette.port": PORT, "app.update.enabled": False, "dom.w3c_touch_events.enabled": 1,
               "datareporting.policy.dataSubmissionEnabled": False, "network.captive-portal-service.enabled": False,
               "network.connectivity-service.enabled": False, "browser.shell.checkDefaultBrowser": False,
               # Nothing listens there: whatever asks for the network fails.
               "network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": 9,
               "network.proxy.ssl": "127.0.0.1", "network.proxy.ssl_port": 9}
PATIENCE = 120  # seconds until a page is ready
KEYS = {"ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015", "PageUp": "\ue00e",
        "PageDown": "\ue00f", "Escape": "\ue00c"}
SHIFT = "\ue008"


class BrowserError(Exception):
    """The browser ended, or what was asked of it failed."""


class Firefox:
    name = "firefox"

    def __init__(self):
        self.home = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        lines = [f'user_pref("{k}", {json.dumps(v)});' for k, v in PREFERENCES.items()]
        pathlib.Path(self.home.name, "user.js").write_text("\n".join(lines))
        self.process = subprocess.Popen(["firefox-esr", "--marionette", "-remote-allow-system-access", "--profile", self.home.name], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.unread, self.number, self.address = b"", 0, ""
        for _ in range(300):
            try:
                self.socket = socket.create_connection(("127.0.0.1", PORT), 120)
                break
            except OSError:
                time.sleep(0.2)
        else:
            raise BrowserError("firefox does not listen")
        self.receive()
        self.ask("WebDriver:NewSession", capabilities={})

    def receive(self):
        while b":" not in self.unread:
            self.take()
        size, _, data = self.unread.partition(b":")
        while len(data) < int(size):
            self.take()
            data = self.unread.partition(b":")[2]
        self.unread = data[int(size):]
        return json.loads(data[:int(size)])

    def take(self):
        more = self.socket.recv(1 << 20)
        if not more:
            raise BrowserError("the browser ended")
        self.unread += more

    def ask(self, command, **parameters):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters]).encode()
        self.socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self.receive()
        if error:
            raise BrowserError(f"{command}: {error['message']}\n{str(parameters)[:400]}")
        return result

    def run(self, expression):
        script = f"const viscera = window.wrappedJSObject.viscera; return Promise.resolve(({expression})).then(v => JSON.stringify(v === undefined ? null : v));"
        return json.loads(self.ask("WebDriver:ExecuteScript", script=script, args=[], sandbox="default")["value"])

    def of_the_browser(self, script):
        self.ask("Marionette:SetContext", value="chrome")
        value = self.ask("WebDriver:ExecuteScript", script=script, args=[], sandbox="system")["value"]
        self.ask("Marionette:SetContext", value="content")
        return value

    def window(self, width, height, scale=1, mobile=False):
        # Its windows are at least 450 pixels wide: for a phone's it draws the page larger.
        zoom = 1.6 if width < 500 else 1.0
        self.of_the_browser(f"Services.wm.getMostRecentWindow('navigator:browser').gBrowser.selectedBrowser.fullZoom = {zoom}")
        outer = [width * zoom, height * zoom]
        for _ in range(6):
            self.ask("WebDriver:SetWindowRect", width=round(outer[0]), height=round(outer[1]))
            time.sleep(0.4)
            off = [width - self.run("innerWidth"), height - self.run("innerHeight")]
            if max(map(abs, off)) < zoom:
                return
            outer = [a + b * zoom for a, b in zip(outer, off)]
        print("the window is", self.run("[innerWidth, innerHeight]"), "instead of", [width, height])

    def prefer(self, scheme="dark", motion="reduce"):
        self.of_the_browser(f"Services.prefs.setIntPref('ui.prefersReducedMotion', {int(motion == 'reduce')});"
                            f"Services.prefs.setIntPref('layout.css.prefers-color-scheme.content-override', {0 if scheme == 'dark' else 1});")

    def open(self, page):
        """Opens a lesson; returns the milliseconds that the page itself says it took."""
        self.of_the_browser("Services.console.reset()")
        self.address = pathlib.Path(page).resolve().as_uri()
        self.ask("WebDriver:Navigate", url=self.address)
        begin = time.time()
        while True:
            ready = self.run("document.documentElement.dataset.ready || null")
            if ready:
                return int(ready)
            if time.time() - begin > PATIENCE:
                raise BrowserError("the page does not get ready")
            time.sleep(0.2)

    def key(self, key, shift=False):
        actions = [{"type": "keyDown", "value": KEYS.get(key, key)}, {"type": "keyUp", "value": KEYS.get(key, key)}]
        if shift:
            actions = [{"type": "keyDown", "value": SHIFT}] + actions + [{"type": "keyUp", "value": SHIFT}]
        self.ask("WebDriver:PerformActions", actions=[{"type": "key", "id": "keys", "actions": actions}])

    def point(self, kind, paths):
        actions = []
        for number, path in enumerate(paths):
            steps = [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0} for x, y in path]
            steps.insert(1, {"type": "pointerDown", "button": 0})
            actions.append({"type": "pointer", "id": f"{kind}{number}", "parameters": {"pointerType": kind}, "actions": steps + [{"type": "pointerUp", "button": 0}]})
        self.ask("WebDriver:PerformActions", actions=actions)
        self.ask("WebDriver:ReleaseActions")

    def mouse(self, path):
        self.point("mouse", [path])

    def touch(self, *paths):
        self.point("touch", paths)

    def picture(self, file=None):
        data = base64.b64decode(self.ask("WebDriver:TakeScreenshot", full=False)["value"])
        if file:
            pathlib.Path(file).write_bytes(data)
        return data

    def asked_for(self):
        """Addresses, the lesson's own not among them."""
        return self.run("performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:') && !n.startsWith('blob:'))")

    def said(self):
        """What the page brought onto the console."""
        return self.of_the_browser("return Services.console.getMessageArray().filter(m => m instanceof Ci.nsIScriptError && m.sourceName.startsWith("
                                   + json.dumps(self.address) + ")).map(m => m.errorMessage)")

    def nameless(self):
        """Controls without a name; not known here."""
        return []

    def end(self):
        self.process.terminate()
        self.process.wait(60)
