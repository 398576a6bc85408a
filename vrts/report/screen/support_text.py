"""The words of the language as a table, as a card of one word, as JSON."""

import textwrap

from vrts.lang.dialect import TITLES
from vrts.lang.vocabulary.instructions import GROUPS
from vrts.report.support import OPAQUE, Entry

_PLURALS = {"switch": "switches"}  # all others take an s
_WIDTH = 100  # columns of what stands above the table
_BEGIN = """\
Words of the language. `vrts support MOVES` tells more of one, `vrts support straight` finds it,
`vrts manual MOVES` explains it. The words of VAL-II by what they are for, an example each:"""
_EXAMPLES = {  # of groups and kinds, in their order
    "motion": "MOVES part",
    "hand": "CLOSEI",
    "values": "SET b = SHIFT(a BY 0, 0, 50)",
    "control": "FOR i = 1 TO 5",
    "signals": "WAIT SIG(1001)",
    "terminal": 'TYPE "n is", n',
    "qualifier": "SPEED 50 ALWAYS",
    "operator": "n MOD 2 == 0",
    "function": "DISTANCE(a, b)",
    "constant": "x = PI",
    "switch": "ENABLE CP",
    "parameter": "PARAMETER HAND.TIME = 0.5",
    "command": "EXECUTE main",
}
_MOST_LINES = 4  # of words of one group
_OF_KINDS = ("qualifier", "operator", "function", "constant", "switch", "parameter", "command")
_LEGEND = """\
How to read the table: a word, its shortest spelling in VAL-II, its state, marks, languages, how it
is written, what it does.
  state      runs: compiled and simulated; compiles: a run stops there, not simulated yet
             opaque: a run stops there, never simulated; known: told apart, not read yet
  marks      R moves or sets up the robot, so not in process control programs
             B waits until the arm stands still
  languages  1 VAL, 2 VAL-II, + V+, a AS"""


def overview(found: tuple[Entry, ...]) -> str:
    """Return the words of VAL-II by what they are for: groups of instructions, then other kinds."""
    groups = dict(GROUPS)
    for entry in found:
        if entry.kind != "instruction" and "2" in entry.dialects and entry.state != OPAQUE:
            kept = groups.get(entry.kind, ())
            groups[entry.kind] = (*kept, entry.word) if entry.word not in kept else kept
    names = {name: _plural(name) if name in _OF_KINDS else name for name in groups}
    width = max(map(len, names.values()))
    indent = " " * (width + 4)
    rows = [_BEGIN]
    for name, words in groups.items():
        rows += ["", f"  {names[name]:<{width}}  {_EXAMPLES[name]}"]
        listed = textwrap.wrap(" ".join(words), _WIDTH - len(indent), break_on_hyphens=False)
        rows += [f"{indent}{line}" for line in listed[:_MOST_LINES]]
        if len(listed) > _MOST_LINES:
            rows.append(f"{indent}… all: `vrts support --kind {name}`")
    return "\n".join(rows)


def table(found: tuple[Entry, ...]) -> str:
    """Return a table of words, one line each, below what its marks mean."""
    widths = [max((len(cell) for cell in column), default=0) for column in _columns(found)]
    rows: list[str] = []
    kind = ""
    for entry in found:
        if entry.kind != kind:
            kind = entry.kind
            rows += ["", _plural(kind)] if rows else [_plural(kind)]
        cells = (f"{cell:<{width}}" for cell, width in zip(_cells(entry), widths, strict=True))
        rows.append(f"  {'  '.join(cells)}".rstrip())
    return "\n".join([_LEGEND, "", *_counted(found), "", *rows])


def counts(found: tuple[Entry, ...]) -> dict[str, dict[str, int]]:
    """Return how many words of each kind are in each state."""
    kinds: dict[str, dict[str, int]] = {}
    for entry in found:
        states = kinds.setdefault(entry.kind, {})
        states[entry.state] = states.get(entry.state, 0) + 1
    return kinds


def _counted(found: tuple[Entry, ...]) -> list[str]:
    """Return a line for each kind: how many words, and how far vrts goes with them."""
    return [
        f"{sum(states.values())} {_plural(kind) if sum(states.values()) > 1 else kind}: "
        + ", ".join(f"{count} {state}" for state, count in sorted(states.items(), reverse=True))
        for kind, states in counts(found).items()
    ]


def _columns(found: tuple[Entry, ...]) -> list[tuple[str, ...]]:
    return list(zip(*(_cells(entry) for entry in found), strict=True))


def _cells(entry: Entry) -> tuple[str, ...]:
    marks = ("R" if entry.robot else " ") + ("B" if entry.breaks else " ")
    languages = "".join(letter if letter in entry.dialects else " " for letter in TITLES)
    shortest = "" if entry.shortest == entry.word else entry.shortest
    return entry.word, shortest, entry.state, marks, languages, entry.usage, entry.about


def _plural(kind: str) -> str:
    return _PLURALS.get(kind, f"{kind}s")


def card(entry: Entry) -> str:
    """Return all that is known of one word."""
    rows = [f"{entry.word}  ({entry.kind} of {entry.languages})", f"  {entry.about}"]
    rows.append(f"  write      {entry.usage}")
    if entry.shortest:
        rows.append(f"  shortest   {entry.shortest}")
    if entry.robot:
        rows.append("  marks      [R] for the robot: not in process control programs")
    if entry.breaks:
        rows.append("  marks      breaks continuous path: waits until the arm stands still")
    rows.append(f"  in vrts    {entry.state}")
    return "\n".join(rows)


def as_json(found: tuple[Entry, ...]) -> dict[str, object]:
    """Return words for JSON."""
    return {
        "schema": "vrts.support/1",
        "counts": counts(found),
        "words": [{**entry._asdict(), "languages": entry.languages.split(", ")} for entry in found],
    }
