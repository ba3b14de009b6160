"""Debian's Chromium, driven over its debugging pipe; Python's standard library only."""
import base64, json, os, pathlib, subprocess, tempfile, time

# Not the shell script in /usr/bin, which keeps no descriptors open.
PROGRAM = os.environ.get("CHROMIUM", "/usr/lib/chromium/chromium")
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--no-first-run", "--disable-extensions", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--force-color-profile=srgb", "--remote-debugging-pipe"]
PATIENCE = 90  # seconds until a page is ready


class BrowserError(Exception):
    """The browser ended, or what was asked of it failed."""


class Chromium:
    name = "chromium"

    def __init__(self):
        self.home = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_it, from_it = os.pipe(), os.pipe()

        def take_ends():  # It reads requests from descriptor 3 and writes answers to 4.
            read, write = os.dup(to_it[0]), os.dup(from_it[1])
            os.dup2(read, 3)
            os.dup2(write, 4)
        self.process = subprocess.Popen([PROGRAM, *FLAGS, "--user-data-dir=" + self.home.name, "about:blank"], preexec_fn=take_ends,
                                        close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_it[0])
        os.close(from_it[1])
        self.out, self.into, self.number, self.events, self.unread, self.session = to_it[1], from_it[0], 0, [], b"", None
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.ask(domain + ".enable")
        self.ask("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=-1, uploadThroughput=-1)

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.unread:
                more = os.read(self.into, 1 << 20)
                if not more:
                    raise BrowserError("the browser ended")
                self.unread += more
            text, _, self.unread = self.unread.partition(b"\0")
            answer = json.loads(text)
            if answer.get("id") != self.number:
                self.events.append(answer)
            elif "error" in answer:
                raise BrowserError(f"{method}: {answer['error']}")
            else:
                return answer["result"]

    def run(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(answer["exceptionDetails"]["exception"].get("description", "?") + "\n" + expression)
        return answer["result"].get("value")

    def window(self, width, height, scale=1, mobile=False):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=mobile)
        self.ask("Emulation.setTouchEmulationEnabled", enabled=mobile, maxTouchPoints=2)

    def prefer(self, scheme="dark", motion="reduce"):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": motion},
                                                         {"name": "prefers-color-scheme", "value": scheme}])

    def open(self, page):
        """Opens a lesson; returns the milliseconds that the page itself says it took."""
        self.address = pathlib.Path(page).resolve().as_uri()
        self.ask("Page.navigate", url=self.address)
        begin = time.time()
        while True:
            ready = self.run("document.documentElement && document.documentElement.dataset.ready")
            if ready:
                return int(ready)
            if time.time() - begin > PATIENCE:
                raise BrowserError("the page does not get ready: " + str(self.run("document.body.innerText"))[:200])
            time.sleep(0.05)

    def key(self, key, shift=False):
        text = {"text": key} if len(key) == 1 else {}
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key, modifiers=8 if shift else 0, **(text if kind == "keyDown" else {}))

    def mouse(self, path):
        for i, (x, y) in enumerate(path):
            self.ask("Input.dispatchMouseEvent", type="mousePressed" if i == 0 else "mouseMoved", x=x, y=y, button="left", buttons=1, clickCount=1)
        self.ask("Input.dispatchMouseEvent", type="mouseReleased", x=path[-1][0], y=path[-1][1], button="left", clickCount=1)

    def touch(self, *paths):
        """One path a finger, all of the same length."""
        for i, places in enumerate(zip(*paths)):
            self.ask("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=[{"x": x, "y": y, "id": n} for n, (x, y) in enumerate(places)])
        self.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def picture(self, file=None):
        data = base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])
        if file:
            pathlib.Path(file).write_bytes(data)
        return data

    def asked_for(self):
        """Addresses, the lesson's own not among them."""
        asked = [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]
        return [address for address in asked if not address.startswith(("data:", "blob:")) and address != self.address]

    def said(self):
        """What was brought onto the console."""
        return [e for e in self.events if e.get("method") in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")]

    def nameless(self):
        """Controls for which a screen reader has no name."""
        self.ask("Accessibility.enable")
        nodes = self.ask("Accessibility.getFullAXTree")["nodes"]
        self.ask("Accessibility.disable")
        roles = ("button", "slider", "combobox", "application", "image")
        return [n["role"]["value"] for n in nodes if not n.get("ignored") and n.get("role", {}).get("value") in roles and not n.get("name", {}).get("value")]

    def end(self):
        self.process.terminate()
        self.process.wait(20)
