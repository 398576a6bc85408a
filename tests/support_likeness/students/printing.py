"""How a program is put on paper."""

import re

from tests.support_likeness.students.authors import Layout
from tests.support_likeness.students.program import Line, Program, Values


def printed(program: Program, layout: Layout) -> str:
    """Return the text of a program in somebody's layout."""
    lines = [note(text, layout) for text in program.head]
    for unit in program.units:
        lines += [note(text, layout) for text in unit.notes]
        brackets = unit.params or layout.brackets
        params = f"({layout.comma.join(unit.params)})" if brackets else ""
        lines.append(f"{cased('.PROGRAM', layout)} {unit.name}{params}")
        lines += block(unit.body, layout, layout.indent)
        lines += [cased(".END", layout)] + [""] * layout.blank
    if program.places:
        lines.append(cased(".LOCATIONS", layout))
        lines += [row(name, values, layout) for name, values in program.places.items()]
        lines.append(cased(".END", layout))
    return "\n".join(lines) + "\n"


def note(text: str, layout: Layout) -> str:
    """Return a comment."""
    return (layout.lead + text).rstrip() if text else ""


def cased(word: str, layout: Layout) -> str:
    """Return a word of VAL-II as somebody writes it."""
    return {"upper": word.upper(), "lower": word.lower(), "title": word.capitalize()}[layout.upper]


def block(lines: list[Line], layout: Layout, indent: str) -> list[str]:
    """Return the text of a block, line by line."""
    found: list[str] = []
    for line in lines:
        begin = indent
        if line.label:
            begin = line.label + " " * max(1, len(indent.expandtabs(8)) - len(line.label))
        text = begin + statement(line, layout)
        if line.word == "NOTE":
            text = indent + note(line.args[0], layout)
        elif line.note:
            text = text.ljust(layout.column) + " " + note(line.note, layout)
        found.append(text.rstrip())
        for k, inner in enumerate(line.blocks):
            if k:
                found.append(indent + cased("ELSE", layout))
            found += block(inner, layout, indent + layout.deeper)
        if line.body is not None:
            found.append(indent + cased("END", layout))
    return found


def statement(line: Line, layout: Layout) -> str:
    """Return a statement without what stands around it."""
    args = [words(arg, layout) for arg in line.args]

    def word(text: str) -> str:
        return cased(text, layout)

    match line.word:
        case "NOTE" | "BLANK":
            return ""
        case "LET":
            return layout.equals.join(args)
        case "SET":
            return f"{word('SET')} {layout.equals.join(args)}"
        case "CALL":
            inner = f"({layout.comma.join(args[1:])})" if len(args) > 1 else ""
            return f"{word('CALL')} {args[0]}{inner or '()' * layout.brackets}"
        case "FOR":
            return f"{word('FOR')} {args[0]}{layout.equals}{args[1]} {word('TO')} {args[2]}"
        case "WHILE":
            return f"{word('WHILE')} {args[0]} {word('DO')}"
        case "IF":
            return f"{word('IF')} {args[0]} {word('THEN')}"
        case "IFGOTO":
            return f"{word('IF')} {args[0]} {word('GOTO')} {args[1]}"
        case "SPEED":
            return " ".join([word("SPEED"), *args])
        case _:
            return f"{word(line.word)} {layout.comma.join(args)}".rstrip()


INNER = re.compile(r'"[^"]*"|\b(?:ALWAYS|BY|TRANS|SHIFT|INVERSE|MMPS)\b')


def words(arg: str, layout: Layout) -> str:
    """Return an argument with VAL-II's words in somebody's case."""
    return INNER.sub(lambda m: m[0] if m[0][0] == '"' else cased(m[0], layout), arg)


def row(name: str, values: Values, layout: Layout) -> str:
    """Return a line of .LOCATIONS."""
    texts = [number(value, layout.digits) for value in values]
    if layout.columns:
        return f"{name:16}" + "".join(f"{text:>10}" for text in texts)
    return " ".join([name, *texts])


def number(value: float, digits: int) -> str:
    """Return a number with so many digits; -1: as few as it needs, two at most."""
    return f"{value:.{digits}f}" if digits >= 0 else f"{round(value, 2):g}"
