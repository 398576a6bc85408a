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
- **Payload is not set**: scenes know no masses. Set it, with its centre, on the robot, or add
  `set_payload` behind `set_tcp`.
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


def sheet_text(run: Run, name: str, table: Table) -> str:
    """Return the sheet, in Markdown."""
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
    )


def _row(run: Run, number: int) -> str:
    motion = run.motions[number]
    x, y, z = motion.X_WT.translation
    place = " ".join(f"{part / MM + 0.0:.2f}" for part in (-x, -y, z))
    joints = " ".join(f"{deg(joint) + 0.0:.2f}" for joint in motion.goal)
    return f"| {number + 1} | {motion.cause.span.line} | {place} | {joints} |"
