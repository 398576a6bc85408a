"""Every word of the language: its form, what it does, an example, how far vrts goes, sources."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from vrts.ir.taken import TAKEN
from vrts.lang.vocabulary.function_forms import form_of
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.report.support import OPAQUE, RUNS, Entry, entries
from vrts.site.generated.markdown import anchor, block, code, container, contents, table, text
from vrts.site.generated.rules import Rule, about, rules_of
from vrts.site.generated.spec_cases import SpecCase
from vrts.site.generated.word_examples import (
    Cases,
    all_cases,
    case_of,
    dialogue_of,
    sample_program,
)

STATES = {
    RUNS: "vrts carries it out",
    "compiles": "vrts reads it; a run stops there, for it is not simulated yet",
    OPAQUE: "vrts reads it; a run stops there, for it is never simulated",
    "known": "vrts tells it apart from other words, and does no more with it yet",
}
PREFACE = """\
Each word stands here with its form, what it does, and an example. Every example is executed by the
tests of vrts, and what it types and does is compared with what stands here. Times are those of a
PUMA 761, and the locations `a`, `b`, `c` and `d` lie in front of it. In forms, lower-case letters
stand for what you choose.
"""


class Part(NamedTuple):
    """One page of words."""

    name: str
    title: str
    says: str
    has: Callable[[Entry], bool]


def _ours(*kinds: str) -> Callable[[Entry], bool]:
    return lambda entry: entry.kind in kinds and bool(set("12") & set(entry.dialects))


def _theirs(letter: str, others: str) -> Callable[[Entry], bool]:
    return lambda entry: letter in entry.dialects and not set(others) & set(entry.dialects)


PARTS = (
    Part("instructions", "Instructions", "first words of a step", _ours("instruction")),
    Part("functions", "Functions", "what gives a value", _ours("function")),
    Part(
        "operators",
        "Operators, constants and small words",
        "AND, TRUE, ALWAYS and their like",
        _ours("operator", "constant", "qualifier"),
    ),
    Part(
        "switches",
        "Switches and parameters",
        "settings of the controller, by ENABLE and PARAMETER",
        _ours("switch", "parameter"),
    ),
    Part(
        "monitor", "Commands of the monitor", "what an operator types at the dot", _ours("command")
    ),
    Part("vplus", "Words that only V+ has", "Adept's successor of VAL-II", _theirs("+", "12")),
    Part("as", "Words that only AS has", "Kawasaki's relative of VAL-II", _theirs("a", "12+")),
)


def word_pages(manual: Path, spec: Path) -> dict[str, str]:
    """Return the pages of the words, by their names in `look-up/words`."""
    everything = entries()
    rules = rules_of(manual / "language")
    cases = all_cases(spec)
    pages = {part.name: _page(part, filter(part.has, everything), rules, cases) for part in PARTS}
    return {**pages, "index": _index(everything)}


def page_of(entry: Entry) -> str:
    """Return the name of the page with a word."""
    return next(part.name for part in PARTS if part.has(entry))


def label_of(entry: Entry) -> str:
    """Return the label of a word's section."""
    return anchor("word", entry.kind, entry.word)


def form(entry: Entry) -> str:
    """Return how a word is written, with a word for each argument."""
    signature = FUNCTIONS.get(entry.word.lower()) if entry.kind == "function" else None
    return form_of(signature) if signature is not None and signature.parameters else entry.usage


def has_section(entry: Entry) -> bool:
    """Return whether a word has a section of its own, not only a row."""
    return entry.state != OPAQUE and entry.about != TAKEN


def _page(part: Part, found: Iterable[Entry], rules: tuple[Rule, ...], cases: Cases) -> str:
    chosen = list(found)
    own = [entry for entry in chosen if has_section(entry)]
    pieces = [f"# {part.title}\n"]
    pieces += [section(entry, rules, cases) for entry in own]
    taken = [entry for entry in chosen if entry.about == TAKEN]
    if taken:
        pieces.append("## Accepted without effect\n\nA program may use them. Nothing happens.\n")
        pieces.append(_rows(taken, with_about=False))
    opaque = [entry for entry in chosen if entry.state == OPAQUE]
    if opaque:
        pieces.append(
            "## Known, and never carried out\n\nvrts reads these words, so a program with them can "
            "be checked. A run stops where it comes to one.\n"
        )
        pieces.append(_rows(opaque, with_about=True))
    return "\n".join(pieces)


def _rows(found: list[Entry], *, with_about: bool) -> str:
    rows = [(code(e.word), code(form(e)), e.languages, text(e.about)) for e in found]
    head = ("word", "write", "languages", "what it would do")
    kept = len(head) if with_about else len(head) - 1
    return table(head[:kept], (row[:kept] for row in rows))


def section(entry: Entry, rules: tuple[Rule, ...], cases: Cases) -> str:
    """Return the section of one word."""
    pieces = [f"({label_of(entry)})=", f"## {text(entry.word)}\n"]
    pieces.append(f"{text(entry.about[:1].upper() + entry.about[1:])}.\n")
    facts = [("Write", code(form(entry)))]
    if entry.shortest and entry.shortest != entry.word:
        facts.append(("Shortest in VAL-II", code(entry.shortest)))
    facts.append(("Kind, languages", f"{entry.kind} of {entry.languages}"))
    facts.append(("How far", STATES[entry.state]))
    if entry.robot:
        facts.append(("For the robot", "it may not stand in a process control program"))
    if entry.breaks:
        facts.append(("Waits", "until the arm stands still"))
    speaking = about(entry.word, rules)
    if speaking:
        links = "; ".join(f"[{text(r.title)}](#{r.label}) ({r.status})" for r in speaking)
        facts += [("Rules", links), ("Source", text(speaking[0].source))]
    listed = "\n".join(f"{name}\n: {says}\n" for name, says in facts)
    pieces.append(container("facts", listed))
    pieces.append(_example(entry, cases))
    return "\n".join(pieces)


def _example(entry: Entry, cases: Cases) -> str:
    if entry.kind == "command":
        dialogue = dialogue_of(entry, cases)
        if dialogue is None:
            return ""
        program = block("val2", dialogue.program) + "\n" if dialogue.program else ""
        return f"{program}{block('text', dialogue.transcript)}"
    case = case_of(entry, cases)
    if case is None:
        program, dialect = sample_program(entry)
        return block(dialect, program)
    return _case(case)


def _case(case: SpecCase) -> str:
    pieces = [f"*{text(case.title)}*\n", block(case.dialect, case.program)]
    for kind, called, body in case.parts:
        if kind == "robot":
            pieces.append(f"{called} a {body}.\n")
        else:
            pieces.append(f"{called}:\n\n{block('toml' if kind == 'scenario' else 'text', body)}")
    return "\n".join(pieces)


def _index(everything: tuple[Entry, ...]) -> str:
    """Return the list of all words from A to Z."""
    parts = "".join(f"- [{part.title}]({part.name}.md): {part.says}\n" for part in PARTS)
    rows: dict[str, list[tuple[str, ...]]] = {}
    for entry in sorted(everything, key=lambda e: (e.word.lstrip("$#"), e.kind)):
        known = rows.setdefault(entry.word.lstrip("$#")[0], [])
        link = f"#{label_of(entry)}" if has_section(entry) else f"{page_of(entry)}.md"
        name = f"[{text(entry.word)}]({link})"
        known.append((name, entry.kind, entry.languages, entry.state, text(entry.about)))
    head = ("word", "kind", "languages", "in vrts", "what it does")
    letters = "".join(f"## {letter}\n\n{table(head, found)}\n" for letter, found in rows.items())
    legend = "".join(f"- *{state}*: {says}\n" for state, says in STATES.items())
    return (
        f"# Words\n\n{PREFACE}\n{parts}\n{contents((p.name for p in PARTS), hidden=True)}\n"
        f"How far vrts goes with a word:\n\n{legend}\n{letters}"
    )
