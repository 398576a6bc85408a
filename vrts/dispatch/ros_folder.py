"""A verified program for robots under ROS 2: a bag, goals of a controller, and what is claimed."""

import tempfile
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.units import deg, mm
from vrts.dispatch.verified import NotVerified, verified
from vrts.engine.memory.events import MotionEnded, MotionStarted
from vrts.engine.run import Run
from vrts.pipeline.request import Request
from vrts.report.event_words import event_text
from vrts.report.plain import one_line
from vrts.report.ros.bag import write_bag
from vrts.report.ros.goals import goal_text
from vrts.report.ros.messages import joint_names
from vrts.report.ros.trajectories import TOLERANCE, Way, ways

BAG, GOALS, SHEET = "bag", "goals", "sheet.md"
ACTION = "control_msgs/action/FollowJointTrajectory"
CONTROLLER = "/joint_trajectory_controller/follow_joint_trajectory"

CLAIMED = """
## What is claimed

- Each goal is one way of the arm from rest to rest. A controller that joins its points by cubics,
  as `joint_trajectory_controller` does with positions and velocities, is nowhere off by more than
  {tolerance:.5f} degrees from what vrts verified. That is worked out, not tried on a controller.
- The bag holds the same run: joint states, transforms, shapes, near misses, and what the program
  said.

## What is assumed

- The robot's joints are named {names} and are counted as here: READY is {ready} degrees.
- The drives follow what is asked. Forces and loads were never looked at.
- The hand, signals and waits are not in the goals. Whoever sends them does what stands between.
  The program decides nothing any more: this is one run of it, in the scenario that was verified.

## One after the other

Send a goal when the one before has succeeded and what stands between has been done:

```sh
ros2 action send_goal {controller} {action} "$(cat goals/01.yaml)"
```
"""


class RosFolder(NamedTuple):
    """The files of a folder by name, or why there is none."""

    files: dict[str, bytes] | None
    diagnostics: tuple[Diagnostic, ...]


def exported_messages(request: Request) -> RosFolder:
    """Verify a program and return its run as messages and goals."""
    found = verified(request)
    if isinstance(found, NotVerified):
        return RosFolder(None, found.diagnostics)
    run = found.run
    files = {SHEET: _sheet(run, request.program.name).encode()}
    names = joint_names(run.scene.robot.arm)
    for number, way in enumerate(ways(run), start=1):
        files[f"{GOALS}/{number:02}.yaml"] = goal_text(names, way).encode()
    with tempfile.TemporaryDirectory() as folder:  # rosbags writes folders only
        bag = Path(folder) / BAG
        write_bag(found.assessment, bag)
        for file in sorted(bag.iterdir()):
            files[f"{BAG}/{file.name}"] = file.read_bytes()
    return RosFolder(files, found.compilation.diagnostics)


def _sheet(run: Run, name: str) -> str:
    arm = run.scene.robot.arm
    ready = ", ".join(f"{deg(angle):g}" for angle in arm.ready)
    lines = [f"# `{one_line(name)}` for ROS 2", "", f"{arm.title}, {run.horizon_s:.2f} s."]
    lines += CLAIMED.format(
        tolerance=deg(TOLERANCE),
        names=", ".join(f"`{joint}`" for joint in joint_names(arm)),
        ready=ready,
        controller=CONTROLLER,
        action=ACTION,
    ).split("\n")
    lines += ["| from | to | what |", "|---|---|---|"]
    lines += [f"| {begin:.3f} s | {end} | {words} |" for begin, end, words in _rows(run)]
    return "\n".join(lines) + "\n"


def _rows(run: Run) -> list[tuple[float, str, str]]:
    """Return goals and what happens between them, in time order."""
    rows = [
        (way.start_s, f"{way.end_s:.3f} s", f"**goal {number:02}**{_led(run, way)}")
        for number, way in enumerate(ways(run), start=1)
    ]
    for event in run.events:
        found = event_text(event)
        if found is not None and not isinstance(event, (MotionStarted, MotionEnded)):
            line = f"line {event.cause.span.line}: " if event.cause and event.cause.span else ""
            rows.append((event.time_s, "", line + _cell(found[1])))
    return sorted(rows, key=lambda row: row[0])


def _led(run: Run, way: Way) -> str:
    """Return which lines make a way, and where it leads."""
    motions = [m for m in run.motions if way.start_s - 1e-6 <= m.start_s < way.end_s]
    if not motions:
        return ""
    lines = ", ".join(dict.fromkeys(str(m.cause.span.line) for m in motions if m.cause.span))
    x, y, z = (mm(part) for part in motions[-1].X_WT.translation)
    return f", line {lines}: to X {x:.1f} Y {y:.1f} Z {z:.1f} mm"


def _cell(words: str) -> str:
    """Return foreign words as a cell of a table."""
    return one_line(words).replace("\\", "\\\\").replace("|", "\\|")
