#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion to photon: from a movement of the mouse in an X server to changed pixels of `rhexis train`.

  scripts/dev/latency.py                       phaco_sculpt, 640 x 480, 100 movements
  scripts/dev/latency.py groove --count 200 --width 1280 --height 960

An Xvfb of its own is started, an instrument is taken, led into the eye and held there with aspiration on while the
exercise is simulated; then the cursor is moved by 25 pixels to and fro through XTest, and the middle of the screen is
read until more of it has changed than changes by itself. The screen is read every 5 ms, which the result includes.
Exit status: 0 done, 2 something is missing.
"""
import argparse
import ctypes
import ctypes.util
import os
import random
import signal
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOVE = 25            # pixels
REGION = 160         # pixels of the window's middle, that are looked at
STRIDE = 61          # every so many bytes of it
PAUSE_S = 0.004      # between two looks: an eye that never shuts takes a core from what it looks at
DIFFERS = 30         # of 255
GIVE_UP_S = 2.0


def fail(text):
    print("latency: " + text, file=sys.stderr)
    sys.exit(2)


class XImage(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("xoffset", ctypes.c_int),
                ("format", ctypes.c_int), ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int),
                ("bitmap_unit", ctypes.c_int), ("bitmap_bit_order", ctypes.c_int), ("bitmap_pad", ctypes.c_int),
                ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int), ("bits_per_pixel", ctypes.c_int)]


class Screen:
    """The X server as a hand and an eye."""

    def __init__(self, display):
        names = [ctypes.util.find_library(name) for name in ("X11", "Xtst")]
        if None in names:
            fail("libX11 and libXtst are needed (packages libx11-6 and libxtst6)")
        self.x, self.test = (ctypes.CDLL(name) for name in names)
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x.XGetImage.restype = ctypes.POINTER(XImage)
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.x.XKeysymToKeycode.restype = ctypes.c_ubyte
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        if not self.display:
            fail("no X server at " + display)
        self.root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))

    def move(self, right, down):
        self.test.XTestFakeRelativeMotionEvent(self.display, right, down, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def press(self, name):
        symbol = ctypes.c_ulong(self.x.XStringToKeysym(name.encode()))
        key = self.x.XKeysymToKeycode(self.display, symbol)
        for down in (1, 0):
            self.test.XTestFakeKeyEvent(self.display, ctypes.c_uint(key), down, ctypes.c_ulong(0))
        self.x.XFlush(self.display)

    def focus_window(self):
        """The window that covers the middle of the screen has the keyboard."""
        root, parent, children = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.POINTER(ctypes.c_ulong)()
        count = ctypes.c_uint()
        self.x.XQueryTree(self.display, self.root, ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                          ctypes.byref(count))
        for i in range(count.value):
            self.x.XSetInputFocus(self.display, ctypes.c_ulong(children[i]), 2, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def look(self, width, height):
        """Every so many bytes of the middle of a screen of this size."""
        image = self.x.XGetImage(self.display, self.root, (width - REGION) // 2, (height - REGION) // 2, REGION, REGION,
                                 ctypes.c_ulong(0xFFFFFFFF), 2)
        data = ctypes.string_at(image.contents.data, image.contents.bytes_per_line * image.contents.height)
        self.x.XDestroyImage(image)
        return data[::STRIDE]


def changed(before, now):
    return sum(abs(a - b) > DIFFERS for a, b in zip(before, now))


def start_server(width, height):
    reading, writing = os.pipe()
    try:
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{width}x{height}x24"],
                                  pass_fds=[writing], stderr=subprocess.DEVNULL)
    except FileNotFoundError:
        fail("Xvfb is needed (package xvfb)")
    os.close(writing)
    with os.fdopen(reading, encoding="ascii") as number:
        return server, ":" + number.readline().strip()


def lead_in(screen):
    """Takes the first instrument, meets it and leads it through the wound; aspiration on."""
    screen.focus_window()
    screen.press("e")
    time.sleep(0.3)
    screen.press("f")
    for _ in range(100):
        screen.move(0, -2)
        time.sleep(0.02)
    screen.press("2")
    time.sleep(1.0)


def measure(screen, given):
    """Seconds from each movement to what is seen of it; and how much changes by itself."""
    own = []
    last = screen.look(given.width, given.height)
    for _ in range(100):
        now = screen.look(given.width, given.height)
        own.append(changed(last, now))
        last = now
        time.sleep(0.02)
    threshold = max(own) + 8
    times = []
    missed = 0
    for i in range(given.count):
        time.sleep(0.25 + 0.1 * random.random())
        before = screen.look(given.width, given.height)
        begun = time.monotonic()
        screen.move(MOVE if i % 2 == 0 else -MOVE, 0)
        while changed(before, screen.look(given.width, given.height)) <= threshold:
            time.sleep(PAUSE_S)
            if time.monotonic() - begun > GIVE_UP_S:
                missed += 1
                break
        else:
            times.append(time.monotonic() - begun)
    return times, missed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", nargs="?", default="phaco_sculpt", help="exercise [phaco_sculpt]")
    parser.add_argument("--count", type=int, default=100, help="movements [100]")
    parser.add_argument("--width", type=int, default=640)
    parser.add_argument("--height", type=int, default=480)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/bindings/cli/rhexis"))
    given = parser.parse_args()
    random.seed(1)
    server, display = start_server(given.width, given.height)
    environment = {**os.environ, "DISPLAY": display}
    environment.pop("SDL_VIDEODRIVER", None)
    with tempfile.TemporaryDirectory() as folder:
        limit = 30 + given.count
        program = subprocess.Popen(
            [os.path.abspath(given.program), "train", given.name, "--width", str(given.width), "--height",
             str(given.height), "--no-open", "--limit", str(limit), "--out", os.path.join(folder, "run")],
            env=environment, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            time.sleep(5.0)
            if program.poll() is not None:
                fail(f"rhexis train {given.name} ended at once")
            screen = Screen(display)
            lead_in(screen)
            times, missed = measure(screen, given)
        finally:
            program.send_signal(signal.SIGKILL)
            program.wait()
            server.terminate()
            server.wait()
    if not times:
        fail("no movement was seen")
    ms = sorted(1e3 * t for t in times)
    print(f"{given.name}, {given.width} x {given.height}: {len(ms)} movements seen, {missed} not: "
          f"median {statistics.median(ms):.0f} ms, 95 % {ms[int(0.95 * (len(ms) - 1))]:.0f} ms, "
          f"least {ms[0]:.0f}, most {ms[-1]:.0f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
