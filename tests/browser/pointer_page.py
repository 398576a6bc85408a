"""A page with nothing but a view of a real scene and the virtual pointer, asking a real session."""

import json
from pathlib import Path
from urllib.parse import quote

import msgspec
from playwright.sync_api import Browser

from tests.browser.support import DOTS, FRAMES, UNDRAWN, Opened, until
from vrts.live.session.channel import messages as m
from vrts.live.session.live_session import Session
from vrts.live.session.ways.ways import Ways
from vrts.pipeline.scenes import load_scene
from vrts.report.page.viewer_data import pose_numbers, scene_data
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Configuration
from vrts.web.assets import asset, module_name, sources

ENTRY = "live/pointer.js"
MODULES = (ENTRY, "viewer/viewer.js", "viewer/replay.js")

_PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Pointer</title>
<style>{css}
body {{ display: flex; flex-wrap: wrap; }}
canvas {{ width: min(880px, 100vw); height: 700px; display: block; }}
#panel {{ width: 360px; padding: 12px; background: var(--paper); }}</style>
<script id="data" type="application/json">{data}</script>
<script type="importmap">{modules}</script></head><body>
<canvas id="canvas"></canvas><div id="panel"></div>
<script type="module">
import {{ armFrames }} from "vrts/viewer/kinematics.js";
import {{ compose, poseFrom }} from "vrts/viewer/poses.js";
import {{ Viewer }} from "vrts/viewer/viewer.js";
import {{ VirtualPointer }} from "{entry}";
import * as pose from "vrts/live/pointer_pose.js";
const data = JSON.parse(document.getElementById("data").textContent);
const dark = matchMedia("(prefers-color-scheme: dark)").matches;
const viewer = new Viewer(document.getElementById("canvas"), data.scene, dark ? "dark" : "light");
const {{ X_BL, X_BF }} = armFrames(data.scene.robot.arm, data.q);
const X_WT = compose(X_BF, poseFrom(data.tool));
const state = {{ t: 0, q: data.q, v: data.q, X_WL: X_BL, X_WF: X_BF, X_WT, bodies: new Map(),
  held: [] }};
viewer.show(state);
const asked = [], gone = [];
const panel = document.getElementById("panel");
const pointer = new VirtualPointer({{ viewer, panel, state: () => state,
  ask: (question) => {{ asked.push(performance.now()); return window.reach(question); }},
  go: async (action) => {{
    gone.push(action);
    if (window.refusal) throw new Error(window.refusal);
  }} }});
window.t = {{ viewer, pointer, pose, asked, gone, state }};
</script></body></html>"""


class Asked:
    """A session at rest, and what it answers."""

    def __init__(self, folder: Path) -> None:
        setting = load_scene("cans-on-bases")
        self.said: list[m.News | bytes] = []
        self.session = Session(
            m.Start(1, str(folder), "cans-on-bases"), setting, self.said.append, lambda: 0.0
        )
        self.ways = Ways(self.session, self.said.append, forks=False)
        self.scene = setting.scene
        planner = self.session.growing.machine.system.planner
        self.configuration: Configuration = self.session.growing.configuration
        self.tool = planner.tool
        self.arm = planner.arm

    @property
    def location(self) -> list[float]:
        """The twelve numbers of the tool's pose in the world."""
        return pose_numbers(forward(self.arm, self.configuration) @ self.tool)

    def reach(self, question: dict[str, object]) -> object:
        """Return the answer to a question as the browser asks it."""
        order = msgspec.convert({"type": "ask_reach", "ref": 1, **question}, m.AskReach)
        self.ways.ask(order)
        return msgspec.to_builtins(self.said.pop())


def pointer_page(
    browser: Browser, folder: Path, asked: Asked, *, phone: bool = False, dark: bool = False
) -> Opened:
    """Open the page; what it asks is answered by the session."""
    data = json.dumps(
        {
            "scene": scene_data(asked.scene, None),
            "q": (*asked.configuration, 0.04),
            "tool": pose_numbers(asked.tool),
        }
    )
    modules: dict[str, str] = {}
    for module in MODULES:
        for name, source in sources(module).items():
            modules[name] = "data:text/javascript," + quote(source)
    css = asset("report/base.css") + asset("live/pointer.css")
    path = folder / "pointer.html"
    path.write_text(
        _PAGE.format(
            css=css, data=data, modules=json.dumps({"imports": modules}), entry=module_name(ENTRY)
        ),
        encoding="utf-8",
    )
    context = browser.new_context(
        viewport={"width": 400, "height": 1300} if phone else {"width": 1260, "height": 720},
        has_touch=phone,
        color_scheme="dark" if dark else "light",
        device_scale_factor=DOTS,
    )
    context.add_init_script(FRAMES)
    context.add_init_script(UNDRAWN)
    page = context.new_page()
    view = Opened(page)
    page.on("console", lambda message: view.messages.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: view.messages.append(f"exception: {error}"))
    page.expose_function("reach", asked.reach)  # pyright: ignore[reportUnknownMemberType]
    page.goto(path.as_uri())
    until(view, "window.t !== undefined")
    return view
