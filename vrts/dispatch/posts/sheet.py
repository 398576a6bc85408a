"""The operator's sheet beside a program in another language: what is claimed, what is assumed."""

from typing import NamedTuple

from vrts.base.oat import components
from vrts.base.units import deg
from vrts.dispatch.posts.checks import NOT_TRIED, Check, here_text
from vrts.dispatch.posts.other_arm import OtherArm
from vrts.dispatch.posts.same_motion import TOLERANCE_MM, Difference
from vrts.engine.run import Run
from vrts.lang.dialect import Dialect


class Given(NamedTuple):
    """What was written, of what."""

    name: str  # of the program, as shown
    dialect: Dialect
    run: Run
    arm: OtherArm | None
    holds: int | None  # signal that the text asks whether the hand holds something
    difference: Difference


TEXT = """
## What is claimed

- vrts verified the program, wrote it again, read it again and executed it in the same scene: at
  every time the tool is within {tolerance:g} mm of where it was ({most:.4f} mm at most).
- TOOL and BASE are set where the program begins. The tool is {tool} mm from the flange.

## What is assumed

- **{not_tried}.** vrts read manuals and programs of others, and spoke to no such controller.
- The other arm reaches the places, in the same arm branch, without hitting anything: only the arm
  that was simulated was looked at. Its flange stands in the hand as that of the simulated arm.
- Speeds, accelerations and rounded corners are those of the other controller.
- {joints}
{holds}
## Check before the first run

Let the program run slowly to these places, each a stop of the arm, and ask for HERE. What it shows
must be what stands here; else TOOL, BASE or a zero position is another one.

| motion | step | in | HERE: X Y Z [mm], angles [deg] | joints [deg] |
|---|---|---|---|---|
"""


def sheet_text(given: Given, found: tuple[Check, ...]) -> str:
    """Return the sheet, in Markdown."""
    run, arm = given.run, given.arm
    x, y, z, *_ = components(run.scene.X_FT)
    if arm is None:
        joints = "The text holds no joint values."
    elif arm.counts_alike:
        joints = f"Joint values are those of the {run.scene.robot.arm.title}."
    else:
        each = zip(arm.order, arm.sign, arm.zero_deg, strict=True)
        said = (f"{k} = {s:+d} × ours {of} {z0:+g}°" for k, (of, s, z0) in enumerate(each, 1))
        joints = f"Joint values are those of {_plain(arm.title)}: {'; '.join(said)}."
    holds = ""
    if given.holds is not None:
        holds = (
            f"- Signal {given.holds} is on while the hand holds something. It stands for"
            " GRASP's look at the\n  opening of the hand, and was taken to be on throughout.\n"
        )
    text = TEXT.format(
        tolerance=TOLERANCE_MM,
        most=given.difference.most_mm,
        tool=f"{x:.2f}, {y:.2f}, {z:.2f}",
        not_tried=NOT_TRIED.capitalize(),
        joints=joints,
        holds=holds,
    )
    rows = [
        f"| {c.motion} | `{_plain(c.words)}` | `{c.program}` | {here_text(c, given.dialect)}"
        f" | {_joints(c, arm)} |"
        for c in found
    ]
    title = f"# `{_plain(given.name)}` in {given.dialect.title}: {NOT_TRIED}\n"
    return title + text + "\n".join(rows) + "\n"


def _joints(check: Check, arm: OtherArm | None) -> str:
    if arm is None:
        return "not known"
    return " ".join(f"{value + 0.0:.2f}" for value in arm.joints(tuple(map(deg, check.goal))))


def _plain(words: str) -> str:
    """Return foreign words as they may stand in a table."""
    return " ".join(words.split()).replace("|", "/").replace("`", "'")
