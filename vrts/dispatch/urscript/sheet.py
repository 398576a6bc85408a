"""The sheet beside a program in URScript: what is claimed, what is assumed, what is yours to do."""

from vrts.base.units import MM, deg
from vrts.dispatch.saying.arrays import UNKNOWN
from vrts.dispatch.saying.table import Table
from vrts.engine.run import Run

TEXT = """# `{name}` in URScript: not tried on a controller

{title}: {motions} motions, {rounded} of them rounded into the next.

## What is claimed

- Each motion leads where vrts verified that it leads; steps, loops, decisions, calls, inputs and
  outputs come in the same order. Tests read such texts by an interpreter made of excerpts of UR's
  manual.
- Poses that UR is given count in UR's own base frame: X and Y are opposed to those of the scene.

## What is assumed

- **Not tried on a controller.** No robot and no simulator of Universal Robots has seen this text.
- Ways and times between the ends are UR's own. Motions by the joints have the speed of the
  slowest joint, so none is faster than verified; lines have the verified speed. Rounded corners
  have a radius of at most {corner:.0f} mm, in UR's shape: vrts did not look whether it hits
  anything. Radii fit the run that was verified; where other inputs make ways shorter, UR may leave
  a rounding out.
- UR takes the joints for a pose that are nearest to where the arm stands. Where a motion behind
  another decision starts elsewhere, they may be others than vrts took: compare the joints below.
- The program goes on when a motion has ended, or where its rounded corner begins. Outputs that
  VAL-II sets as a motion begins stand before it. `sync()` in a loop may end a rounding there.
- Lists hold {elements} elements where a subscript is worked out in the run; UR stops beyond them.
{payload}{more}- Outputs are taken to be off where the program begins.
- Safety planes, joint limits, forces and the stop are the robot's.

## Check before the first run

Let it run slowly, and compare the tool (base feature) and the joints where the arm stops:

| motion | line | X Y Z in UR's base [mm] | joints [deg] |
|---|---|---|---|
{rows}

## Signals

The hand opens with standard output {hand_open} and closes with {hand_close}.

| signal | pin |
|---|---|
{pins}
"""


PAYLOAD = """- `set_payload` says {mass:g} kg, its centre at {centre} mm from the flange, as
  `io.toml` has it. It stays that, whether the hand holds something or not.
"""
NO_PAYLOAD = """- **Payload is not set**: scenes know no masses. Write `[payload]`, `mass_kg = ...`
  and `centre_mm = [x, y, z]` (from the flange) into `io.toml`, or set it on the robot.
"""
TIMERS = """- Timers are read by `time()` (script manual for SW 5.19), in steps of 2 ms. They count
  UR's own time: one that runs while the arm moves, or over a stop, which takes VAL-II 0.112 s,
  reads otherwise than in the run that was verified. TIMER(0) counts from the beginning of the
  program.
"""
REACTIONS = """- Inputs that the program watches are looked at in each frame of 2 ms, in VAL-II at
  each tick of {tick:g} ms: UR sees pulses that VAL-II may miss. Two reactions at one moment come
  in the order of their signals. While one is carried out, another one waits for its end.
- **Where the arm rests after REACTI is UR's own**: `stopj` slows down by {brake:g} s from full
  speed. vrts verified one such place, where its own brake ends; look what is near the whole way.
- A program that watches inputs moves in threads and has no rounded corners.
"""
BESIDE = """- The second program is a thread beside the first, and ends with it. The first one rests
  less at its stops than in VAL-II (0.112 s), so beside it the second one is up to 0.1 s less far
  after each; what comes first where both are that near is not what was verified.
"""


def sheet_text(run: Run, name: str, table: Table, text: str) -> str:
    """Return the sheet, in Markdown, of a text that was written."""
    stops = [k for k, motion in enumerate(run.motions) if motion.arrives and not motion.blended]
    chosen = stops if len(stops) <= 3 else [stops[0], stops[len(stops) // 2], stops[-1]]
    arm = run.scene.robot.arm
    pins = [f"| {signal} | input {pin} |" for signal, pin in table.inputs.items()]
    pins += [f"| {signal} | output {pin} |" for signal, pin in table.outputs.items()]
    return TEXT.format(
        name=" ".join(name.split()).replace("`", "'"),
        title=arm.title,
        motions=len(run.motions),
        elements=UNKNOWN + 1,
        rounded=sum(motion.blended for motion in run.motions),
        corner=arm.linear_speed * arm.acceleration_time / MM,
        rows="\n".join(_row(run, k) for k in chosen),
        hand_open=table.hand_open,
        hand_close=table.hand_close,
        pins="\n".join(pins),
        payload=_payload(table),
        more=_more(run, text),
    )


def _payload(table: Table) -> str:
    if table.payload is None:
        return NO_PAYLOAD
    centre = ", ".join(f"{part:g}" for part in table.payload.centre_mm)
    return PAYLOAD.format(mass=table.payload.mass_kg, centre=centre)


def _more(run: Run, text: str) -> str:
    arm, pace = run.scene.robot.arm, run.scene.controller.pace
    timers = TIMERS if "def v_clock()" in text else ""
    timers += BESIDE if "thread v_beside_" in text else ""
    if "def v_look()" not in text:
        return timers
    brake_s = pace.brake_accelerations * arm.acceleration_time
    return timers + REACTIONS.format(tick=1e3 * arm.tick, brake=brake_s)


def _row(run: Run, number: int) -> str:
    motion = run.motions[number]
    x, y, z = motion.X_WT.translation
    place = " ".join(f"{part / MM + 0.0:.2f}" for part in (-x, -y, z))
    joints = " ".join(f"{deg(joint) + 0.0:.2f}" for joint in motion.goal)
    return f"| {number + 1} | {motion.cause.span.line} | {place} | {joints} |"
