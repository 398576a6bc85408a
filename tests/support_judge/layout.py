"""How somebody lays a file out: capitals, blanks, comments, the table of places."""

from random import Random
from typing import NamedTuple

from tests.support_judge.source import Body, Free, Loop, Place, Source, Step


class Layout(NamedTuple):
    """Habits that change nothing of what a program does."""

    indent: str
    deeper: str
    comma: str
    lower: bool
    equals: str
    note_column: int
    blank_lines: bool
    brackets: bool  # behind main
    decimals: int
    tabs: bool
    places_first: bool


def some_layout(rng: Random) -> Layout:
    """Return somebody's habits."""
    return Layout(
        indent=rng.choices(["        ", "    ", "  ", "\t", ""], [40, 30, 15, 10, 5])[0],
        deeper=rng.choice(["  ", "    "]),
        comma=rng.choices([", ", ","], [80, 20])[0],
        lower=rng.random() < 0.12,
        equals=rng.choices([" = ", "="], [75, 25])[0],
        note_column=rng.choice([0, 0, 32, 40]),
        blank_lines=rng.random() < 0.35,
        brackets=rng.random() < 0.85,
        decimals=rng.choices([2, 0, 1], [70, 20, 10])[0],
        tabs=rng.random() < 0.1,
        places_first=rng.random() < 0.06,
    )


def written(source: Source, layout: Layout) -> str:
    """Return the text of a file."""
    lines = [f"; {line}" for line in source.head]
    table = [".LOCATIONS", *(_place(one, layout) for one in source.places), ".END"]
    if layout.places_first:
        lines += table
    for one in source.programs:
        if one.note:
            lines.append(f"; {one.note}")
        listed = layout.comma.join(one.parameters)
        brackets = f"({listed})" if listed or layout.brackets else ""
        lines += [f".PROGRAM {one.name}{brackets}", *_body(one.body, layout, layout.indent), ".END"]
        if layout.blank_lines:
            lines.append("")
    if not layout.places_first:
        lines += table
    return "\n".join(lines) + "\n"


def _body(body: Body, layout: Layout, indent: str) -> list[str]:
    lines: list[str] = []
    for node in body:
        match node:
            case Step():
                lines.append(_step(node, layout, indent))
            case Loop():
                lines += _loop(node, layout, indent)
            case Free():
                for number, piece in enumerate(node.pieces):
                    if number and layout.blank_lines and len(piece) > 2:
                        lines.append("")
                    lines += _body(piece, layout, indent)
    return lines


def _loop(loop: Loop, layout: Layout, indent: str) -> list[str]:
    inside = _body(loop.body, layout, indent + layout.deeper)
    name = loop.variable
    if loop.kind == "FOR":
        begin = [f"{indent}{_case('FOR', layout)} {name} = 1 {_case('TO', layout)} {loop.last}"]
        more = []
    else:
        words = _case("WHILE", layout), _case("DO", layout)
        begin = [
            f"{indent}{name}{layout.equals}1",
            f"{indent}{words[0]} {name} <= {loop.last} {words[1]}",
        ]
        more = [f"{indent}{layout.deeper}{name}{layout.equals}{name}+1"]
    return [*begin, *inside, *more, f"{indent}{_case('END', layout)}"]


def _step(step: Step, layout: Layout, indent: str) -> str:
    word, operands = _case(step.word, layout), step.operands
    match step.word:
        case ";":
            return f"{indent}; {step.note}"
        case "=":
            text = layout.equals.join(operands)
        case "SET":
            text = f"{word} {layout.equals.join(operands)}"
        case "CALL":
            listed = layout.comma.join(operands[1:])
            text = f"{word} {operands[0]}" + (f"({listed})" if listed else "")
        case _:
            text = f"{word} {layout.comma.join(operands)}".rstrip()
    line = indent + text
    return f"{line:<{layout.note_column}} ; {step.note}" if step.note else line


def _place(place: Place, layout: Layout) -> str:
    values = [f"{value:.{layout.decimals}f}" for value in place.values]
    if layout.decimals != 2:
        values = [f"{value:g}" for value in place.values]
    if layout.tabs:
        return "\t".join([place.name, *values])
    return f"{place.name:<16}" + "".join(f"{value:>9}" for value in values)


def _case(word: str, layout: Layout) -> str:
    return word.lower() if layout.lower else word
