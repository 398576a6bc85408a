"""What vrts assumes: models of controllers with what they rest on, and every marked decision."""

from itertools import groupby
from pathlib import Path

from vrts.controllers.models import USUAL
from vrts.controllers.readings import READINGS, value_text
from vrts.controllers.values import values
from vrts.report.assumptions import Assumption, decisions
from vrts.site.generated.markdown import code, table, text

HEAD = """\
# What is assumed

No manual of VAL-II could be read for this work. Where no document gives a number or a rule,
somebody had to decide. Here are all these decisions. If a real robot does something else than vrts
says, look here first. `vrts explain --assumptions` prints them in the terminal;
[how we know](sources.md) tells what was read.

## The controller

What the usual model of a controller does, and what that rests on. `--controller` takes another
model.

"""


def assumptions_page(package: Path) -> str:
    """Return the page of everything that is assumed."""
    usual = dict(values(USUAL))
    rows = (
        (
            text(reading.about),
            text(value_text(usual[reading.field], reading.unit)),
            f"[{reading.ground.status}](#{reading.rule.replace('/', '-').replace('#', '-')})",
            text(reading.ground.source),
        )
        for reading in READINGS
    )
    sources = {
        ".".join(path.relative_to(package).with_suffix("").parts): path.read_text("utf-8")
        for path in sorted(package.rglob("*.py"))
        if path.relative_to(package).parts[0] != "site"
    }
    found = decisions(sources)
    rooms = groupby(found, key=lambda one: one.where.split(".")[0])
    return (
        HEAD
        + table(("question", "answer", "how sure", "source"), rows)
        + "\n## Numbers and rules in the source\n\n"
        + "".join(_room(room, list(ones)) for room, ones in rooms)
    )


def _room(room: str, found: list[Assumption]) -> str:
    rows = (
        (code(one.name), code(one.value), text("; ".join(x for x in (one.why,) if x)), _place(one))
        for one in found
    )
    head = ("name", "value", "why", "where")
    return f"### {code(room)}\n\n" + table(head, rows) + "\n"


def _place(one: Assumption) -> str:
    return code(f"vrts/{one.where.replace('.', '/')}.py")
