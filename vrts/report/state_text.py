"""The state of a run at one time, for the terminal. Lengths in mm, angles in degrees."""

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.units import deg, mm
from vrts.engine.run import Run
from vrts.ir.values import Value
from vrts.report.plain import one_line, plain_text


def state_text(run: Run, time_s: float) -> str:
    """Return everything known about an instant."""
    state = run.at(time_s)
    joints = " ".join(f"{deg(q):9.3f}" for q in state.configuration)
    lines = [f"at {time_s:.3f} s"]
    if state.span is not None:
        lines.append(f"  line {state.span.line}  {one_line(state.span.text)}")
    lines += [
        "           JT1       JT2       JT3       JT4       JT5       JT6",
        f"     {joints}",
        "             X         Y         Z         O         A         T",
        f"     {_pose(state.X_WT)}",
        f"  hand {mm(state.hand_opening):.1f} mm" + (f", holds {state.held}" if state.held else ""),
    ]
    lines += [
        f"  {name:<12} {_pose(X)}" for name, X in state.poses.items() if name in run.placements
    ]
    if state.signals:
        lines.append(f"  signals on: {', '.join(map(str, sorted(state.signals)))}")
    lines += [f"  {name} = {_value(value)}" for name, value in sorted(state.variables.items())]
    return plain_text("\n".join(lines))


def _pose(X: Pose) -> str:
    return " ".join(f"{part:9.2f}" for part in components(X))


def _value(value: Value) -> str:
    if isinstance(value, Pose):
        return " ".join(f"{part:.2f}" for part in components(value))
    if isinstance(value, tuple):
        return " ".join(f"{deg(part):.3f}" for part in value)
    return one_line(f'"{value}"') if isinstance(value, str) else f"{value:g}"
