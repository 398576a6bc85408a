"""The sheet of a folder for LinuxCNC: what is claimed, with figures, and what is assumed."""

from vrts.base.units import MM, deg
from vrts.dispatch.linuxcnc.machine import JOINT_3, LEAD_S, Robot, half_s
from vrts.dispatch.linuxcnc.values import CLOCK

# what a rehearsal holds the motion against, and what is told of it
PATH_MM, EQUAL_MM, DURATION_S = 0.01, 0.05, 0.002  # of motions from stop to stop
ROUND_PATH_MM, ROUND_EQUAL_MM, ROUND_DURATION_S = 0.15, 1.5, 0.002  # of rounded and tilting ones

CLAIMED = """
## What is claimed

From one stop of the arm to the next, LinuxCNC's commanded motion is the one that vrts verified:

| | motions that stop, straight or by the joints | rounded corners, lines that turn the hand |
|---|---|---|
| path: the tip of the tool is off by at most | {path} mm | {round_path} mm |
| equal time: it is elsewhere by at most | {equal} mm | {round_equal} mm |
| ends: it stops off by at most | {path} mm | {path} mm |
| duration differs by at most | {duration:g} ms | {round_duration:g} ms |

`vrts dispatch rehearse` measures all of it against an installed LinuxCNC and says where it fails.
Equal time counts from the middle of each stretch between two stops.
"""

ASSUMED = """
## What is assumed

- **Pauses between motions are LinuxCNC's own** (about {pause} of VAL-II's BREAK): the whole program
  takes another time. What happens outside at a certain time comes earlier or later in the program.
- **Inputs are read at rest.** A step that reads one while the arm may move is refused.
- The joints follow what is commanded at once (`machine.hal`). Drives, encoders, homing, brakes,
  limit and emergency switches are yours to connect, and forces and loads were never looked at.
- LinuxCNC counts joint 3 from another zero: its joint 3 is VAL's less {joint_3:g} degrees.
- The world is the robot's base frame, its origin in the shoulder. The tool stays in the program;
  LinuxCNC's own tool offsets are not used.
- Lines do not keep to the speed of single joints, in LinuxCNC as in VAL-II: vrts checked that.
- Reals are in double precision, and EQ takes numbers as equal that differ by less than 0.0001:
  VAL-II has single precision and is exact.
- Motions begin and end at rest, except for rounded corners, which take {corner:g} s each.
- Before rounded motions the arm waits {lead:g} s, so that the set points of what comes are there.
- Outputs are taken to be off where the program begins.
- A wait for an input is repeated without an end, as WAIT is.
- In simulation, without a real-time kernel, LinuxCNC lost its place once in a hundred rehearsals
  on a very busy machine and took another way. Nobody has tried this under a real-time kernel.
{timers}
## Before the robot moves

1. Read `program.ngc`: each step of the program stands before what became of it.
2. Put your drives into `machine.hal`, your signals into `io.toml`, then export and rehearse again.
3. Run it with the power of the arm off, then at a tenth of the feed, with a hand on the stop.
"""


TIMERS = """- Timers count the servo cycles of 1 ms by HAL's `integ`, are read at rest, and count
  LinuxCNC's own time: waits by the clock took 0.02 to 0.08 s less than in VAL-II, whose stops are
  longer. TIMER(0) counts from the beginning of the program.
"""


def sheet_text(robot: Robot, name: str, text: str) -> str:
    """Return the sheet, in Markdown.

    Args:
        robot: What was written.
        name: Of the program, as shown.
        text: The program in G-code.
    """
    arm, run, table = robot.arm, robot.run, robot.table
    motions = run.motions
    rounded = sum(motion.blended for motion in motions)
    tool = ", ".join(f"{part / MM:.2f}" for part in run.scene.X_FT.translation)
    joints = zip(arm.lower, arm.upper, arm.speed, strict=True)
    first = (
        f"{arm.title} in {run.scene.title}: {len(motions)} motions, {rounded} of them rounded"
        " into the next."
    )
    flange = (
        f"Tool at the start, from the flange: {tool} mm. Acceleration: {arm.acceleration_time:g} s"
        " from rest to full speed, set again for each motion."
    )
    hand = (
        f"The hand opens with `motion.digital-out-{table.hand_open:02}` and closes with"
        f" `motion.digital-out-{table.hand_close:02}`."
    )
    rows = [
        f"# `{name}` for LinuxCNC",
        "",
        first,
        CLAIMED.format(
            path=PATH_MM,
            equal=EQUAL_MM,
            duration=1e3 * DURATION_S,
            round_path=ROUND_PATH_MM,
            round_equal=ROUND_EQUAL_MM,
            round_duration=1e3 * ROUND_DURATION_S,
        ),
        ASSUMED.format(
            pause="12 to 40 ms instead of the 112 ms",
            joint_3=JOINT_3,
            corner=2.0 * half_s(robot),
            lead=LEAD_S,
            timers=TIMERS if CLOCK in text else "",
        ),
        "## The robot",
        "",
        flange,
        "",
        "| joint | from [deg] | to [deg] | speed [deg/s] |",
        "|---|---|---|---|",
        *(
            f"| {k} | {deg(low):g} | {deg(high):g} | {deg(speed):g} |"
            for k, (low, high, speed) in enumerate(joints, start=1)
        ),
        "",
        "## Signals",
        "",
        hand,
        "",
        "| signal | pin |",
        "|---|---|",
        *(f"| {s} | `motion.digital-in-{p:02}` |" for s, p in table.inputs.items()),
        *(f"| {s} | `motion.digital-out-{p:02}` |" for s, p in table.outputs.items()),
    ]
    return "\n".join(rows) + "\n"
