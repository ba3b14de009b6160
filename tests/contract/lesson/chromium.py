"""Debian's Chromium, driven over its debugging pipe; Python's standard library only."""
import base64, json, os, pathlib, subprocess, tempfile, time, zlib

# Not the shell script in /usr/bin, which keeps no descriptors open.
PROGRAM = os.environ.get("CHROMIUM", "/usr/lib/chromium/chromium")
FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--no-first-run", "--disable-extensions", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--force-color-profile=srgb", "--remote-debugging-pipe"]
PATIENCE = 90  # seconds until a page is ready


class BrowserError(Exception):
    """The browser ended, or what was asked of it failed."""


class Chromium:
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
        self.ask("Page.navigate", url=pathlib.Path(page).resolve().as_uri())
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

    def end(self):
        self.process.terminate()
        self.process.wait(20)


def pixels(png):
    """Width, height and 8-bit RGB of a PNG: a list of rows of tuples."""
    at, data = 8, b""
    while at < len(png):
        size, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        if kind == b"IHDR":
            width, height = (int.from_bytes(png[at + i:at + i + 4], "big") for i in (8, 12))
            channels = {2: 3, 6: 4}[png[at + 17]]
        if kind == b"IDAT":
            data += png[at + 8:at + 8 + size]
        at += 12 + size
    data, stride, rows = zlib.decompress(data), width * channels, []
    before = bytearray(stride)
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = (row[i - channels] if i >= channels else 0), before[i], (before[i - channels] if i >= channels else 0)
            if kind == 4:
                p = a + b - c
                row[i] = (row[i] + min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]) & 255
            elif kind:
                row[i] = (row[i] + (0, a, b, (a + b) // 2)[kind]) & 255
        rows.append([tuple(row[x:x + 3]) for x in range(0, stride, channels)])
        before = row
    return width, height, rows


def blocks(png, side=10):
    """Means of squares of pixels: small differences of drawing vanish in them."""
    width, height, rows = pixels(png)
    means = []
    for y in range(0, height - side + 1, side):
        for x in range(0, width - side + 1, side):
            square = [rows[y + j][x + i] for j in range(side) for i in range(side)]
            means.append(tuple(sum(p[c] for p in square) / len(square) for c in range(3)))
    return means
