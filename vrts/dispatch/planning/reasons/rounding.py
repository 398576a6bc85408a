"""What becomes of values when they are printed with the controller's decimals and read again."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, error
from vrts.base.pose import Pose, distance, rotation_angle
from vrts.base.units import deg, mm
from vrts.dispatch.planning.printed import name_of, placed_data
from vrts.dispatch.planning.reasons.refusals import LOST_BY_ROUNDING
from vrts.ir.dump import dump
from vrts.ir.module import Module
from vrts.ir.values import Value


class Difference(NamedTuple):
    """How far the locations of a module are from what is held of them, at most."""

    position_mm: float
    orientation_deg: float


def same_instructions(given: Module, held: Module) -> bool:
    """Return whether two modules have the same programs, wherever they are written."""
    return _programs(given) == _programs(held)


def largest(given: Module, held: Module) -> Difference:
    """Return the largest difference of any location."""
    pairs = zip(placed_data(given), placed_data(held), strict=True)
    found = [_difference(a.value, b.value) for a, b in pairs]
    return Difference(
        max((one.position_mm for one in found), default=0.0),
        max((one.orientation_deg for one in found), default=0.0),
    )


def lost(given: Module, held: Module) -> Iterator[Diagnostic]:
    """Yield a refusal for locations that differ in the file and are the same when printed."""
    seen: dict[Value, tuple[str, Value]] = {}
    for a, b in zip(placed_data(given), placed_data(held), strict=True):
        if isinstance(b.value, float | str):
            continue
        name, value = seen.setdefault(b.value, (name_of(a), a.value))
        if value != a.value:
            yield error(
                LOST_BY_ROUNDING,
                f"`{name}` and `{name_of(a)}` differ, and are the same in the controller",
                notes=("it prints and keeps them with fewer decimals",),
                help=("move them apart, or use one location for both",),
            )


def _difference(a: Value, b: Value) -> Difference:
    if isinstance(a, float | int | str) or isinstance(b, float | int | str):
        return Difference(0.0, 0.0)
    if isinstance(a, Pose):
        assert isinstance(b, Pose)
        far = distance(a.translation, b.translation)
        return Difference(mm(far), deg(rotation_angle(a.rotation, b.rotation)))
    assert not isinstance(b, Pose)
    return Difference(0.0, deg(max(abs(p - q) for p, q in zip(a, b, strict=True))))


def _programs(module: Module) -> dict[str, str]:
    return {name: dump(Module({name: program}, ())) for name, program in module.programs.items()}
