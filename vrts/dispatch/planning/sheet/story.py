"""What a program does, told from a run of it: what it takes, and where it sets it down."""

from vrts.dispatch.bundle import Bundle, rows
from vrts.engine.hand.told import named
from vrts.engine.memory.cells import Cell, cells_of
from vrts.engine.memory.events import (
    Grasped,
    Landed,
    MotionStarted,
    Reacted,
    Released,
    SignalChanged,
)
from vrts.engine.run import Run


def story(run: Run) -> list[str]:
    """Return what happens, one line an event that an operator sees."""
    motions = sum(isinstance(event, MotionStarted) for event in run.events)
    found: list[str] = []
    for event in run.events:
        when = f"{event.time_s:.1f} s:"
        match event:
            case Grasped(body=body):
                found.append(f"{when} takes `{body}`")
            case Landed(body=body, support=support, also=also):
                found.append(f"{when} `{body}` stands on {named((support, *also))}")
            case Released(body=body, height_m=height) if height > 0.0:
                found.append(f"{when} lets go of `{body}`")
            case Reacted(program=program, signal=signal) if signal:
                found.append(f"{when} signal {signal} begins `{program}`")
            case SignalChanged(signal=signal, on=on, cause=cause) if cause is not None:
                found.append(f"{when} turns signal {signal} {'on' if on else 'off'}")
            case _:
                pass
    ended = run.ended_s if run.ended_s is not None else run.horizon_s
    found.append(f"{ended:.1f} s: {run.ending.value}, after {motions} motions")
    return found


def changed(bundle: Bundle, run: Run) -> tuple[str, ...]:
    """Return the data of a bundle that a run leaves with other values."""
    sections = (bundle.locations, bundle.reals, bundle.strings)
    names = {name for section in sections for name, _ in rows(section)}
    cells = [cell for bound in run.history.memory.bound for cell in cells_of(bound)]
    return tuple(sorted(cell.name for cell in cells if cell.name in names and _changed(cell)))


def _changed(cell: Cell) -> bool:
    return any(value != cell.values[0] for value in cell.values[1:])
