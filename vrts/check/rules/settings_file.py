"""Reads `[settings]` of a task: what programs may set by PARAMETER, ENABLE, DISABLE and ACCEL."""

from collections.abc import Collection
from difflib import get_close_matches

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.check.rules.settings import (
    FREE_PARAMETERS,
    FREE_SWITCHES,
    FULL_ACCELERATION,
    USUAL_LOCKS,
    locks_of,
)
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.scene.model import FASTEST_ACCELERATION, Locks

UNKNOWN_SETTING = Rule("V656", "unknown-setting")


def read_settings(top: Table, problems: Problems) -> Locks:
    """Return what programs may not set."""
    section = top.table("settings")
    if section is None:
        return USUAL_LOCKS
    parameters = _names(section, problems, "parameters", FREE_PARAMETERS, PARAMETERS)
    switches = _names(section, problems, "switches", FREE_SWITCHES, SWITCHES)
    fastest = section.number(
        "acceleration_percent", FULL_ACCELERATION, minimum=1.0, maximum=FASTEST_ACCELERATION
    )
    section.finish()
    return locks_of(parameters, switches, fastest)


def _names(
    section: Table,
    problems: Problems,
    key: str,
    usual: tuple[str, ...],
    known: Collection[str],
) -> tuple[str, ...]:
    found = tuple(name.upper() for name in section.strings(key, usual) or ())
    for name in found:
        if name not in known:
            close = get_close_matches(name, known, 1, 0.6)
            what = key.removesuffix("es" if key == "switches" else "s")
            problems.error(
                UNKNOWN_SETTING,
                f"the controller has no {what} `{name}`",
                section.value_span(key),
                help=(f"did you mean `{close[0]}`?" if close else f"{key}: {', '.join(known)}",),
            )
    return found
