"""Reads `[variants]` of a task: what varies, between which values, which never go together."""

import json
import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import cast

from vrts.base.diagnostic import Label, Rule
from vrts.base.source import Span
from vrts.base.toml.reading import Problems, Table
from vrts.check.variants.even import read_even
from vrts.check.variants.model import Variants, Vary, Without

VALUES = Rule("V867", "variant-values")

SECTION = "variants"
RANGE = ("from", "to", "step")
FEWEST = 2  # choices
MOST_VARY = 40  # things that vary in a task
MOST_PATHS = 40  # values that one draw sets
MOST_CHOICES = 1000  # of one thing
MOST_WITHOUT = 200
MOST_VARIANTS = 10**12
SEARCHED = 20_000  # combinations looked at for one that is not excluded

_NAME = re.compile(r"[a-z][a-z0-9_]{0,29}", re.IGNORECASE)
_ASSIGNMENT = re.compile(r"[\w. -]{1,60}")


def read_variants(top: Table, problems: Problems) -> Variants | None:
    """Return the variants of a task; None where it has none, or they are wrong."""
    section = top.table(SECTION)
    if section is None:
        return None
    before = len(problems.found)
    if not section.span.text.startswith("["):  # students' files are cut at headers
        headline = f"`{SECTION}` needs a header of its own"
        remedy = f"write `[{SECTION}]`, and `[[{SECTION}.vary]]` for each thing that varies"
        problems.error(VALUES, headline, section.span, help=(remedy,))
    assignment = section.string("assignment", required=True)
    if assignment is not None and not _ASSIGNMENT.fullmatch(assignment):
        headline = "`assignment` must be a short name: letters, digits, blanks, `-`, `_` and `.`"
        problems.error(VALUES, headline, section.value_span("assignment"))
    staff_names = section.names("staff_names", choices=None)
    even = read_even(section)
    varies: dict[str, Vary] = {}
    tables = section.tables("vary", required=True)
    _few(section, "vary", len(tables), MOST_VARY, problems)
    for table in tables[:MOST_VARY]:
        vary = _vary(table, problems)
        if vary is None:
            continue
        if vary.name in varies:
            problems.error(
                VALUES,
                f"two things that vary have the name `{vary.name}`",
                table.value_span("name"),
                secondary=(Label(varies[vary.name].span, "the other one"),),
            )
        varies[vary.name] = vary
    _each_once(tuple(varies.values()), problems)
    whole = tuple(varies.values())
    excluded = section.tables("without")
    _few(section, "without", len(excluded), MOST_WITHOUT, problems)
    sound = len(problems.found) == before  # else choices are missing
    rules = [_without(table, whole, problems) for table in excluded[:MOST_WITHOUT]] if sound else []
    section.finish()
    if len(problems.found) > before or assignment is None:
        return None
    found = Variants(
        assignment,
        whole,
        tuple(rule for rule in rules if rule is not None),
        tuple(name.lower() for name in staff_names),
        section.span,
        even,
        tuple(section.element_span("staff_names", k) for k in range(len(staff_names))),
    )
    return found if _usable(found, problems) else None


def _vary(table: Table, problems: Problems) -> Vary | None:
    before = len(problems.found)
    name = table.string("name", required=True)
    if name is not None and not _NAME.fullmatch(name):
        headline = f"invalid name `{name}` of what varies"
        remedy = "a name begins with a letter and has at most 30 letters, digits, _"
        problems.error(VALUES, headline, table.value_span("name"), help=(remedy,))
    paths = table.names("set", choices=None, required=True)
    if len(paths) > MOST_PATHS:
        headline = f"one draw sets {MOST_PATHS} values at most"
        problems.error(VALUES, headline, table.value_span("set"))
    plus = _plus(table, len(paths), problems)
    ranged = _range(table, problems)
    listed = table.array("choices")
    said = "choices" in table, any(key in table for key in RANGE)
    table.finish()
    if len(problems.found) > before or name is None:
        return None
    if all(said) or not any(said):
        headline = f"`{name}` needs `choices`, or `from`, `to` and `step`"
        if all(said):
            headline = f"`{name}` has `choices`, and `from`, `to` and `step` as well"
        problems.error(VALUES, headline, table.span, help=("leave one of the two",))
        return None
    choices = ranged if said[1] else _listed(table, listed, len(paths), problems)
    if choices is None:
        return None
    values = [_shifted(choice, len(paths), plus) for choice in choices]
    if None in values:
        headline = "`plus` is for choices that are numbers"
        problems.error(VALUES, headline, table.value_span("plus"))
        return None
    texts = tuple(tuple(map(toml_text, value)) for value in values if value is not None)
    if len(set(texts)) < len(texts):
        twice = next(k for k in range(len(texts)) if texts[k] in texts[:k])
        headline = f"`{name}` has the same choice twice"
        problems.error(VALUES, headline, table.element_span("choices", twice))
        return None
    spots = _path_spans(table, len(paths))
    return Vary(name, paths, texts, table.span, spots)


def _plus(table: Table, paths: int, problems: Problems) -> tuple[float, ...]:
    plus = table.numbers("plus") or ()
    if plus and len(plus) != paths:
        headline = f"`plus` has {len(plus)} numbers, and `set` names {paths} values"
        remedy = "write a number for each value, 0 where nothing is added"
        problems.error(VALUES, headline, table.value_span("plus"), help=(remedy,))
    return plus


def _range(table: Table, problems: Problems) -> list[object] | None:
    """Return the numbers from one to another; None where there is no range, or it is wrong."""
    start, end = table.fraction("from"), table.fraction("to")
    step = table.fraction("step", above=0.0)
    if "choices" in table or not any(key in table for key in RANGE):
        return None
    for key in RANGE:
        if key not in table:
            headline = f"a range needs `from`, `to` and `step`: `{key}` is missing"
            problems.error(VALUES, headline, table.span)
            return None
    if start is None or end is None or step is None:
        return None  # said already
    if end <= start:
        headline = f"the range ends at {_number(end)}, which is not after {_number(start)}"
        problems.error(VALUES, headline, table.value_span("to"))
        return None
    steps = (end - start) / step
    if steps.denominator != 1:
        last = start + int(steps) * step
        headline = f"steps of {_number(step)} from {_number(start)} do not end at {_number(end)}"
        remedy = f"end at {_number(last)} or {_number(last + step)}, or take another step"
        problems.error(VALUES, headline, table.value_span("step"), help=(remedy,))
        return None
    if steps >= MOST_CHOICES:
        headline = f"the range has {int(steps) + 1:,} values, and may have {MOST_CHOICES:,}"
        problems.error(VALUES, headline, table.value_span("step"), help=("take a longer step",))
        return None
    return [start + k * step for k in range(int(steps) + 1)]


def _listed(
    table: Table, listed: list[object], paths: int, problems: Problems
) -> list[object] | None:
    if len(listed) < FEWEST or len(listed) > MOST_CHOICES:
        headline = f"`choices` has {len(listed):,}: it needs {FEWEST} to {MOST_CHOICES:,}"
        problems.error(VALUES, headline, table.value_span("choices"))
        return None
    for number, choice in enumerate(listed):
        span = table.element_span("choices", number)
        if not _plain(choice):
            headline = "a choice is text, a number, true or false, or a list of these"
            problems.error(VALUES, headline, span)
            return None
        several = cast("list[object]", choice) if isinstance(choice, list) else None
        if paths > 1 and several is not None and len(several) != paths:
            headline = f"this choice has {len(several)} values, and `set` names {paths}"
            remedy = "write a list with a value for each, or one value for all"
            problems.error(VALUES, headline, span, help=(remedy,))
            return None
    return listed


def _shifted(choice: object, paths: int, plus: tuple[float, ...]) -> list[object] | None:
    """Return the value of a choice for each path; None where a number is added to no number."""
    values = [choice] * paths
    if paths > 1 and isinstance(choice, list):
        values = list(cast("list[object]", choice))
    if not plus:
        return values
    found: list[object] = []
    for value, more in zip(values, plus, strict=True):
        if isinstance(value, bool) or not isinstance(value, int | float | Fraction):
            if more:
                return None
            found.append(value)
        else:
            found.append(_exact(value) + _exact(more))
    return found


def _without(table: Table, varies: tuple[Vary, ...], problems: Problems) -> Without | None:
    """Return an excluded combination: every key names what varies, and lists choices of it."""
    numbers = {vary.name: k for k, vary in enumerate(varies)}
    known = [name for name in numbers if name in table]
    found: dict[int, frozenset[int]] = {}
    for name in known:
        vary = varies[numbers[name]]
        texts = [_shown_alike(value, vary) for value in table.array(name)]
        wrong = next((k for k, choice in enumerate(texts) if choice is None), None)
        if wrong is not None:
            shown = ", ".join(vary.shown(k) for k in range(min(len(vary.choices), 12)))
            problems.error(
                VALUES,
                f"`{name}` never has this value",
                table.element_span(name, wrong),
                notes=(f"its choices: {shown}",),
            )
        found[numbers[name]] = frozenset(choice for choice in texts if choice is not None)
    table.finish()
    if not found and not table.keys:
        problems.error(VALUES, "an excluded combination names nothing that varies", table.span)
    return Without(found) if found else None


def _shown_alike(value: object, vary: Vary) -> int | None:
    """Return the number of the choice that is meant by a value."""
    if not _plain(value):
        return None
    whole, items = toml_text(value), [value]
    if isinstance(value, list):
        items = list(cast("list[object]", value))
    parts = tuple(toml_text(item) for item in items)
    for number, choice in enumerate(vary.choices):
        alone = len(choice) == 1 or len(set(choice)) == 1 or not isinstance(value, list)
        if (alone and choice[0] == whole) or (len(choice) > 1 and choice == parts):
            return number
    return None


def _few(section: Table, key: str, count: int, most: int, problems: Problems) -> None:
    if count > most:
        headline = f"there are {count:,} tables `[[{SECTION}.{key}]]`, and may be {most}"
        problems.error(VALUES, headline, section.span)


def _each_once(varies: tuple[Vary, ...], problems: Problems) -> None:
    """Report a value that two draws set, or one draw twice."""
    seen: dict[str, Vary] = {}
    for vary in varies:
        for path, span in zip(vary.paths, vary.path_spans, strict=True):
            for other, known in seen.items():
                if f"{path}.".startswith(f"{other}.") or f"{other}.".startswith(f"{path}."):
                    headline = f"`{vary.name}` and `{known.name}` set the same value"
                    if known.name == vary.name:
                        headline = f"`{vary.name}` sets the same value twice"
                    problems.error(VALUES, headline, span, f"as `{other}` does")
                    break
            seen[path] = vary


def _usable(found: Variants, problems: Problems) -> bool:
    """Report too many variants, or none that a student may get."""
    if found.total > MOST_VARIANTS:
        headline = f"there are {found.total:,} variants, and may be {MOST_VARIANTS:,}"
        problems.error(VALUES, headline, found.span, help=("take longer steps",))
        return False
    step = max(1, found.total // SEARCHED)
    numbers = range(0, found.total, step)
    if not any(found.allowed(found.combination(number)) for number in numbers):
        headline = "nearly every combination is excluded" if step > 1 else "nothing is left"
        headline = f"{headline}: `[[{SECTION}.without]]` leaves too few for a draw"
        problems.error(VALUES, headline, found.span)
        return False
    return True


def _path_spans(table: Table, count: int) -> tuple[Span, ...]:
    return tuple(table.element_span("set", k) for k in range(count))


# values as TOML


def toml_text(value: object) -> str:
    """Return a plain value as TOML writes it: the same value, the same text."""
    match value:
        case bool():
            return "true" if value else "false"
        case int() | float() | Fraction():
            return _number(_exact(value))
        case str():
            return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
        case list():
            return f"[{', '.join(map(toml_text, cast('list[object]', value)))}]"
        case _:
            raise AssertionError(f"looked at before: {value!r}")


def _plain(value: object) -> bool:
    if isinstance(value, list):
        return all(map(_plain, cast("list[object]", value)))
    if isinstance(value, float):
        return math.isfinite(value)
    return isinstance(value, str | int)  # true and false are of `int`


def _exact(value: float | Fraction) -> Fraction:
    return value if isinstance(value, Fraction) else Fraction(repr(value))


def _number(value: Fraction) -> str:
    """Return a number with all its decimals; those of TOML end, and so do their sums."""
    if value.denominator == 1:
        return str(value.numerator)
    return format(Decimal(value.numerator) / Decimal(value.denominator), "f")
