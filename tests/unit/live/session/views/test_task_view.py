"""What the page of a room is told of a task, and that it counts as the task's own checks do."""

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.support_goals import SCENE
from vrts.base.pose import Pose, rotation_about
from vrts.base.source import SourceFile
from vrts.check.goals.placed import errors_at
from vrts.check.task.goals import Looks
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.live.session.views.task_view import LONGEST, task_view
from vrts.report.page.viewer_data import pose_numbers

WEB = Path("vrts/web/live").resolve()
DENO = str(Path(sys.executable).parent / "deno")

EVERYTHING = """
[task]
title = "Everything <b>"
description = '''
Put the cans away.
<img src=x onerror=alert(1)>
'''
scene = "x"
ordered = true

[[goal]]
object = ["can1", "can2"]
on = ["base1", "base2"]
gripped = 0.1
lifted = 0.2
lifted_mm = 40

[[goal]]
object = "brick"
at_mm = [700, 0, -300]
position_mm = 7.5
symmetry = "none"

[[relation]]
object = "can2"
right_of = "can1"
by_mm = 100

[[relation]]
object = "can1"
from_mm = [600, -500, -310]
to_mm = [1200, 500, 200]

[[via]]
name = "gate"
at_mm = [800, -20, 100]
radius_mm = 15
approach = [0, 0, -2]
speed_mm_s = [0, 50]

[[via]]
at_mm = [900, 0, 100]

[[zone]]
name = "glass"
from_mm = [500, -100, 0]
to_mm = [600, 100, 300]
keeps_out = "robot"
points = 2

[[upright]]
object = "can1"

[[rule]]
must_use = "CALL"

[time]
reference_s = 10

[mark]
contacts_by = "depth"
"""


def asked_for(text: str = EVERYTHING) -> Task:
    """Return a task."""
    task, problems = read_task(SourceFile("bricks/task.toml", text), SCENE)
    assert task is not None, [d.headline for d in problems]
    return task


def view(text: str = EVERYTHING) -> dict[str, Any]:
    """Return what is shown of a task, as it arrives."""
    return json.loads(msgspec.json.encode(task_view(SCENE, asked_for(text))))


def test_everything_that_is_asked_for_is_drawn_or_said() -> None:
    shown = view()
    assert shown["title"] == "Everything <b>", "the page sets it as text"
    assert shown["text"].splitlines()[0] == "Put the cans away."
    one_of, other, brick, beside, box = shown["goals"]
    assert (one_of["bodies"], other["bodies"]) == (["can1"], ["can2"])
    assert [place["where"] for place in one_of["places"]] == ["on base1", "on base2"]
    assert "10 % for being gripped and 20 % for being lifted by 40 mm" in one_of["words"]
    assert one_of["words"].startswith("any of 2 places, each for one goal only, within 10 mm")
    assert brick["words"] == "within 7.5 mm and 5 degrees"
    assert brick["places"][0]["X"][9:] == [0.7, 0.0, -0.3]
    assert len(brick["shapes"]["brick"]["turns"]) == 1, "with a label no turn counts as none"
    assert (beside["other"], beside["box"]) == ("can1", None)
    assert beside["words"] == "right of can1, by 100 mm at least"
    assert box["box"] == {"lower": [0.6, -0.5, -0.31], "upper": [1.2, 0.5, 0.2]}
    gate, other = shown["vias"]
    assert gate["approach"] == [0.0, 0.0, -1.0]
    assert gate["words"].startswith("the tool comes within 15 mm of 800, −20, 100 mm, points")
    assert gate["words"].endswith("no faster than 50 mm/s")
    assert other["words"] == "the tool comes within 20 mm of 900, 0, 100 mm"
    assert shown["ordered"]
    assert shown["zones"] == [
        {"name": "glass", "lower": [0.5, -0.1, 0.0], "upper": [0.6, 0.1, 0.3]}
    ]
    said = [f"{rule['text']} | {rule['worth']}" for rule in shown["rules"]]
    assert said == [
        "The robot stays out of `glass` | costs 2.0",
        "`can1` stays within 5 degrees of upright | costs 1.0",
        "The program must use CALL | costs 1.0",
        "Full time bonus up to 12.5 s, over at 25 s | up to 1.5",
        "Nothing is touched or dropped | costs 0.1 a millimetre",
    ]


def test_a_description_of_any_length_comes_as_one_that_can_be_shown() -> None:
    text = EVERYTHING.replace("Put the cans away.", "x\u202ey" * LONGEST)
    shown = view(text)["text"]
    assert len(shown) == LONGEST
    assert shown.endswith("…")
    assert "\u202e" not in shown


def deno(module: str, body: str, given: object) -> Any:
    """Return what a function of the page makes of something."""
    code = f"""
        import * as page from "{(WEB / module).as_uri()}";
        import {{ poseFrom }} from "{(WEB.parent / "viewer" / "poses.js").as_uri()}";
        const made = (given) => ({body});
        console.log(JSON.stringify(made({json.dumps(given)})));
    """
    done = subprocess.run(
        [DENO, "eval", "--no-lock", code],
        capture_output=True,
        text=True,
        check=True,
        timeout=60.0,
    )
    return json.loads(done.stdout)


angles = st.floats(-math.pi, math.pi)
steps = st.floats(-0.05, 0.05)
turns = st.tuples(angles, st.sampled_from([0.0, 0.03, -0.2, math.pi]), angles)


@settings(max_examples=3, deadline=None)
@given(st.lists(st.tuples(st.tuples(steps, steps, steps), turns), min_size=60, max_size=60))
def test_the_page_measures_distances_as_marking_does(
    moved: list[tuple[tuple[float, float, float], tuple[float, float, float]]],
) -> None:
    asked = asked_for()
    one_of, _, brick = asked.goals
    goals = [one_of, brick, brick._replace(looks=Looks.SHAPE), one_of._replace(looks=Looks.NONE)]
    wanted: list[tuple[float, float, float]] = []
    given: list[object] = []
    for number, (away, (a, b, c)) in enumerate(moved):
        goal = goals[number % len(goals)]
        shown: Any = task_view(SCENE, replace(asked, goals=(goal,)))["goals"]
        choice = goal.choices[-1]
        x, y, z = choice.X_WG.translation
        turned = _turned(choice.X_WG, a, b, c).rotation
        X_WO = _as_sent(Pose(turned, (x + away[0], y + away[1], z + away[2])))
        share, found = errors_at(
            *(SCENE.body(choice.body), goal.looks, X_WO, _as_sent(choice.X_WG), goal),
            asked.mark.zero_at,
        )
        wanted.append((float(share), float(found.position_mm), float(found.orientation_deg)))
        given.append([shown[0], choice.body, pose_numbers(X_WO), pose_numbers(choice.X_WG)])
    body = """given.map(([goal, name, X_WO, X_WG]) => {
        const shape = goal.shapes[name];
        const found = page.missedBy(shape, poseFrom(X_WO), poseFrom(X_WG), goal, 3);
        return [found.share, found.positionMm, found.orientationDeg];
    })"""
    for mine, theirs in zip(deno("goal_distance.js", body, given), wanted, strict=True):
        assert abs(mine[0] - theirs[0]) < 0.005, (mine, theirs)
        assert abs(mine[1] - theirs[1]) < 0.021, (mine, theirs)
        assert abs(mine[2] - theirs[2]) < 0.021, (mine, theirs)


def _turned(X_WO: Pose, a: float, b: float, c: float) -> Pose:
    x, z = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    one, two, three = (
        Pose(rotation_about(axis, angle), (0.0, 0.0, 0.0))
        for axis, angle in ((z, a), (x, b), (z, c))
    )
    return X_WO @ one @ two @ three


def _as_sent(X: Pose) -> Pose:
    numbers = pose_numbers(X)
    return Pose(tuple(numbers[:9]), tuple(numbers[9:]))  # type: ignore[arg-type]


boxes = st.tuples(
    *(st.floats(-20, 420), st.floats(-20, 320), st.floats(10, 120), st.floats(10, 20)),
    st.sampled_from([1, 2, 3]),
)


@settings(max_examples=5, deadline=None)
@given(st.lists(st.lists(boxes, max_size=12), min_size=20, max_size=20))
def test_no_name_covers_another_or_leaves_the_picture(
    many: list[list[tuple[float, float, float, float, int]]],
) -> None:
    names = [
        [dict(zip(("x", "y", "width", "height", "weight"), one, strict=True)) for one in some]
        for some in many
    ]
    body = "given.map((names) => page.placed(names, { width: 400, height: 300 }))"
    for wanted, placed in zip(names, deno("name_places.js", body, names), strict=True):
        shown = [
            (p["left"], p["top"], p["left"] + n["width"], p["top"] + n["height"])
            for n, p in zip(wanted, placed, strict=True)
            if p is not None
        ]
        for k, (left, top, right, bottom) in enumerate(shown):
            assert left >= 0
            assert top >= 0
            assert right <= 400
            assert bottom <= 300
            for other in shown[k + 1 :]:
                apart = left >= other[2] or other[0] >= right
                assert apart or top >= other[3] or other[1] >= bottom
        inside = [n for n in wanted if 60 <= n["x"] <= 340 and 60 <= n["y"] <= 240]
        if inside:
            heaviest = max(wanted, key=lambda n: n["weight"])["weight"]
            first = next(n for n in wanted if n["weight"] == heaviest)
            if first in inside:
                assert placed[wanted.index(first)] is not None, "what matters most is written"
