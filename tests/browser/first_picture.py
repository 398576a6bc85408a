"""When a page shows the arm, judged by the pixels of what the screen has shown.

Chromium hands out every frame that it gives to the screen, with its time. When all has come to
rest the viewer draws twice more, with the arm and without it; a pixel belongs to the arm where
these two differ clearly. A frame shows the arm when nearly all these pixels are nearer to the
picture with it than to the one without. So it counts no matter who has drawn the picture, and an
arm in another place, or seen by another camera, does not count.
"""

import base64
import io
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image
from playwright.sync_api import CDPSession, Page

DIFFERENT = 30  # sum of the differences of three colours, of 765
NEARLY_ALL = 0.75  # of the arm's pixels; a drawing without shadows differs in some
LEAST = 400  # pixels of an arm that can be judged
BARE = """() => {
  const { viewer } = vrts.world;
  viewer.sun.castShadow = false;
  viewer.robot.group.visible = true;
  viewer.draw();
}"""
WITHOUT = """() => {
  const { viewer } = vrts.world;
  viewer.robot.group.visible = false;
  viewer.draw();
}"""
BOX = """() => {
  const { x, y, width, height } = document.getElementById("view").getBoundingClientRect();
  return { x, y, width, height };
}"""
BYTES = """() => ["navigation", "resource"]
  .flatMap((kind) => performance.getEntriesByType(kind))
  .map((one) => [one.name, one.transferSize, one.startTime, one.responseEnd])"""

Picture = npt.NDArray[np.int16]


class Profile(NamedTuple):
    """A device and its network."""

    name: str
    slower: float  # times: the processor
    down: float  # bits a second; 0: no limit
    up: float  # bits a second
    latency_ms: float  # from a request to its answer
    size: tuple[int, int]  # of the window [px]
    mobile: bool


PHONE = Profile("phone", 4.0, 1.6e6, 0.75e6, 150.0, (390, 844), mobile=True)
DESKTOP = Profile("desktop", 1.0, 0.0, 0.0, 0.0, (1366, 768), mobile=False)


@dataclass
class Screen:
    """What a page has given to the screen."""

    session: CDPSession
    frames: list[tuple[float, bytes]] = field(default_factory=list[tuple[float, bytes]])

    def watch(self, size: tuple[int, int]) -> None:
        """Note every frame from now on."""
        self.session.on("Page.screencastFrame", self._take)
        self.send(
            "Page.startScreencast",
            format="png",
            maxWidth=size[0],
            maxHeight=size[1],
            everyNthFrame=1,
        )

    def stop(self) -> None:
        """Note no more."""
        self.session.remove_listener("Page.screencastFrame", self._take)
        self.send("Page.stopScreencast")

    def send(self, method: str, **fields: Any) -> Any:
        """Tell the browser something."""
        return told(self.session, method, **fields)

    def _take(self, message: Any) -> None:
        when = float(message["metadata"]["timestamp"])
        self.frames.append((when, base64.b64decode(message["data"])))
        self.send("Page.screencastFrameAck", sessionId=message["sessionId"])


def told(session: CDPSession, method: str, **fields: Any) -> Any:
    """Tell the browser something; return its answer."""
    send: Any = session.send  # pyright: ignore[reportUnknownMemberType, reportUnknownVariableType]
    return send(method, fields)


def behave(session: CDPSession, profile: Profile) -> None:
    """Make a browser's page as slow as a profile says, with nothing in its cache."""
    told(session, "Network.enable")
    told(session, "Network.clearBrowserCache")
    told(session, "Emulation.setCPUThrottlingRate", rate=profile.slower)
    if profile.down:
        conditions = {
            "offline": False,
            "latency": profile.latency_ms,
            "downloadThroughput": profile.down / 8,
            "uploadThroughput": profile.up / 8,
        }
        told(session, "Network.emulateNetworkConditions", **conditions)


def pixels(page: Page) -> Picture:
    """Return what the page shows now, cut to the view."""
    return _cut(page.screenshot(scale="css"), page.evaluate(BOX))


def first_with_arm(page: Page, frames: list[tuple[float, bytes]]) -> tuple[float, Picture]:
    """Return when [s since 1970] a frame first showed the arm as it is shown now, and the frame."""
    page.evaluate(BARE)
    with_arm = pixels(page)
    page.evaluate(WITHOUT)
    without = pixels(page)
    arm = np.abs(with_arm - without).sum(2) > DIFFERENT
    assert arm.sum() > LEAST, f"no arm to be judged: {arm.sum()} pixels"
    box = page.evaluate(BOX)
    for when, data in frames:
        shown = _cut(data, box)
        if shown.shape == with_arm.shape and arm_share(shown, with_arm, without) > NEARLY_ALL:
            return when, shown
    raise AssertionError(f"none of {len(frames)} frames shows the arm")


def arm_share(shown: Picture, with_arm: Picture, without: Picture) -> float:
    """Return which share of the arm's pixels look like the arm and not like what is behind it."""
    arm = np.abs(with_arm - without).sum(2) > DIFFERENT
    near, far = (np.abs(shown - other).sum(2)[arm] for other in (with_arm, without))
    return float((near < far).mean())


def _cut(data: bytes, box: dict[str, float]) -> Picture:
    picture: Picture = np.asarray(Image.open(io.BytesIO(data)).convert("RGB")).astype(np.int16)
    x, y = round(box["x"]), round(box["y"])
    return picture[y : y + round(box["height"]), x : x + round(box["width"])]
