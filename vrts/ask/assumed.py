"""What had to be assumed, for people: what, how much, why, and how to find out on the robot.

What a rule of the manual says is read there; values come from the controller models and from the
marks in the source. What no robot can answer - numbers by which vrts itself searches and hints -
stands at the end.
"""

import re
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache

from vrts.ask.collect import manual_files, title_of
from vrts.ask.rules import Rule, rules_in
from vrts.ask.terminal import Look, rendered
from vrts.controllers.models import MODELS, USUAL
from vrts.controllers.readings import READINGS, Reading, value_text
from vrts.controllers.values import values
from vrts.report.assumptions import Assumption, text_of

WIDTH = 88  # columns
_FIRST = re.compile(r"\A\s*(.+?)(?:\n\s*\n|\n```|\Z)", re.S)
_MANUAL = re.compile(r"manual ([a-z0-9/#-]+)")
_ARMS = "robots."  # modules with data of arms
_INDENT = 18
_ON_ARMS = (
    "Log one joint, then lines, at SPEED 100: `vrts validate --fit` finds speeds and acceleration."
    " Measure lengths with a tape and write them into a lab: `vrts new lab lab.toml`."
)
_BEGIN = """\
What had to be assumed
======================

No manual of VAL-II could be read for vrts. Each entry says what was decided, how much it is,
why, and how you find out on your robot. If your robot answers otherwise, write its measures
into a lab (`vrts new lab`), or let `vrts validate --fit` find them in a log.
"""


def assumed_text(found: Sequence[Assumption]) -> str:
    """Return all that had to be assumed, as text.

    Args:
        found: Decisions marked in the source.
    """
    rows = [_BEGIN, "Models of the controller, of which each has its own answers:"]
    for model in MODELS.values():
        rows.append(f"  {model.name:<8}{model.title}" + (" (usual)" if model is USUAL else ""))
    told: set[Assumption] = set()
    for page, rules in _by_page(found):
        rows += ["", "", title_of(manual_files()[page]), "-" * len(title_of(manual_files()[page]))]
        for rule in rules:
            marked = [a for a in found if _rule_of(a) == rule.name]
            told.update(marked)
            rows += ["", *_entry(rule, marked)]
    arms = [a for a in found if a.where.startswith(_ARMS) and a not in told]
    rows += ["", "", "The arms", "--------", ""]
    rows += [line for arm in arms for line in _filled("", f"  {arm.where}: {arm.what}; {arm.why}")]
    rows += _filled("on the robot", _ON_ARMS)
    rest = [a for a in found if a not in told and not a.where.startswith(_ARMS)]
    rows += ["", "", "What vrts itself goes by", "------------------------", ""]
    rows += textwrap.wrap(
        "No robot knows these: they decide what searches, hints, budgets and pages do. They are"
        " named as in the source, for those who change it.",
        WIDTH,
    )
    return "\n".join([*rows, "", text_of(rest)])


def _by_page(found: Iterable[Assumption]) -> Iterator[tuple[str, list[Rule]]]:
    """Yield the pages of the manual with their rules that rest on a decision."""
    decided = {reading.rule for reading in READINGS if _is_assumed(reading)}
    decided |= {_rule_of(assumption) for assumption in found}
    for page, text in manual_files().items():
        kept = [
            rule
            for rule in rules_in(page, text)
            if rule.status == "assumed" or rule.name in decided
        ]
        if kept:
            yield page, kept


def _is_assumed(reading: Reading) -> bool:
    grounds = (reading.ground, *reading.others.values())
    return any(ground.status == "assumed" for ground in grounds)


def _rule_of(assumption: Assumption) -> str:
    cited = _MANUAL.search(f"{assumption.about} {assumption.why}")
    return cited[1] if cited else ""


def _entry(rule: Rule, marked: Sequence[Assumption]) -> Iterator[str]:
    """Yield the lines of one entry."""
    yield f"  {rule.title.replace('`', '')}"
    first = _FIRST.match(rule.text)
    if first and not first[1].startswith("|"):
        yield from _filled("what", _plain(first[1]))
    amounts = [*map(_amount, _readings().get(rule.name, ())), *(a.what for a in marked if a.value)]
    yield from _listed("how much", dict.fromkeys(amounts))
    yield from _filled("why", f"{rule.status}: {_plain(rule.source)}")
    yield from _filled("on the robot", rule.fields.get("On the robot", ""))
    yield from _filled("more", f"vrts manual {rule.name}")


@cache
def _readings() -> Mapping[str, tuple[Reading, ...]]:
    """Return the fields of controller models by their rules."""
    found: dict[str, tuple[Reading, ...]] = {}
    for reading in READINGS:
        found[reading.rule] = (*found.get(reading.rule, ()), reading)
    return found


def _amount(reading: Reading) -> str:
    """Return what a field of the models answers, how much it is in each, and what says so."""
    usual = dict(values(USUAL))[reading.field]
    asks, _, without = reading.about.partition("; none: ")
    said = without if usual is None else value_text(usual, reading.unit)
    told = f"{asks} = {said} ({reading.field}; {reading.ground.status}: {reading.ground.source})"
    for name, model in MODELS.items():
        value = dict(values(model))[reading.field]
        if value != usual:
            ground = reading.others[name]
            other = without if value is None else value_text(value, reading.unit)
            told += f"; of {name}: {other} ({ground.status}: {ground.source})"
    return told


def _plain(text: str) -> str:
    return rendered(" ".join(text.split()), Look(100_000, color=False), lambda words, _: words)


def _filled(heading: str, text: str) -> list[str]:
    """Return a text behind its heading; nothing for none."""
    first = f"    {heading:<{_INDENT - 4}}" if heading else ""
    others = " " * _INDENT if heading else " " * 6
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _listed(heading: str, texts: Iterable[str]) -> Iterator[str]:
    for number, text in enumerate(texts):
        yield from _filled(heading if number == 0 else " ", text)
