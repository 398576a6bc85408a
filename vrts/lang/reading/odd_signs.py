"""Signs and names that the language does not have: what is said of them, and how they are read."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems, short
from vrts.lang.reading.characters import BLANKS, INVISIBLE, LOOK_ALIKES, STRANGERS
from vrts.lang.syntax.token import Token

STRAY_CHARACTER = Rule("V107", "stray-character")
INVALID_NAME = Rule("V111", "invalid-name")

SIGNS = {
    "=": "EQUAL",
    ",": "COMMA",
    "(": "LPAREN",
    ")": "RPAREN",
    "[": "LBRACKET",
    "]": "RBRACKET",
    "-": "MINUS",
    "+": "PLUS",
}
INFIX = frozenset({"*", "/", "<", ">", ":", "==", "<>", "<=", "=<", ">=", "=>"})
_DOTTED = re.compile(r"\.(?P<name>[A-Za-z]\w*)(?![\w.])", re.ASCII)  # a local name of AS
_MISTAKEN = {  # signs of other languages: what to write
    "!=": "<>",
    "><": "<>",
    ":=": "=",
    "**": "SQR(x)` or `x*x",
    "&&": "AND",
    "||": "OR",
    "+=": "x = x+1",
    "-=": "x = x-1",
    "++": "x = x+1",
    "--": "x = x-1",
}


def stranger(written: str, start: int, problems: Problems) -> Token | None:
    """Report a character with no meaning here; read a look-alike as what it stands for."""
    if written in LOOK_ALIKES:
        look_alike(written, start, problems)
        replacement = LOOK_ALIKES[written].replacement
        if written in BLANKS + INVISIBLE or not replacement:
            return None
        kind = SIGNS.get(replacement, "INFIX" if replacement in INFIX else "")
        return Token(kind, replacement, start, start + 1) if kind else None
    dotted = _DOTTED.match(problems.source.text, start)
    if dotted is not None:
        problems.error(
            STRAY_CHARACTER,
            "a name does not begin with a dot",
            start,
            dotted.end(),
            notes=("VAL-II says *Illegal expression syntax*",),
            help=(f"write `{short(dotted['name'])}`",),
            fix=problems.replace(start, start + 1, ""),
        )
        return None
    hint = STRANGERS.get(written, "")
    problems.error(
        STRAY_CHARACTER,
        f"`{visible(written)}` has no meaning here",
        start,
        start + 1,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(hint,) if hint else (),
    )
    return None


def look_alike(character: str, start: int, problems: Problems) -> None:
    """Note the place; all look-alikes of a file become one diagnostic (see `pasted_characters`)."""
    problems.look_alikes.append((character, start))


def mistaken(written: str, start: int, problems: Problems) -> Token | None:
    """Report an operator of another language."""
    instead = _MISTAKEN[written]
    plain = instead if instead in ("<>", "=", "AND", "OR") else None
    problems.error(
        STRAY_CHARACTER,
        f"`{written}` is not an operator of {problems.dialect.title}",
        start,
        start + len(written),
        help=(f"write `{instead}`",),
        fix=problems.replace(start, start + len(written), plain) if plain else None,
        notes=("VAL-II says *Illegal operator*",),
    )
    return None


def foreign_name(written: str, start: int, problems: Problems) -> None:
    """Report a name with a letter that names cannot have."""
    at = next(i for i, c in enumerate(written) if not c.isascii())
    problems.error(
        INVALID_NAME,
        f"the name `{short(written)}` contains `{visible(written[at])}`",
        start,
        start + len(written),
        notes=("VAL-II says *Invalid program or variable name*",),
        help=("names consist of the letters A to Z, digits, `.` and `_`",),
    )


def name_after_digit(written: str, start: int, problems: Problems) -> None:
    """Report `3x`."""
    problems.error(
        INVALID_NAME,
        f"`{short(written)}` is neither a number nor a name",
        start,
        start + len(written),
        notes=("VAL-II says *Invalid program or variable name*",),
        help=("begin names with a letter; put an operator or a blank after a number",),
    )


def visible(character: str) -> str:
    """Return a character as a message shows it."""
    return character if character.isprintable() else f"U+{ord(character):04X}"


def inner_quotes(text: str, start: int, at: int, problems: Problems) -> int:
    """Report a text that holds double quotes; return where it ends, or 0 where it holds none.

    Args:
        text: The text of a statement.
        start: Where the string begins in it.
        at: Offset of the text in the source.
        problems: Where it is reported.
    """
    of_c = _OF_C.match(text, start)
    doubled = _DOUBLED.match(text, start)
    inner = _INNER.match(text, start)
    if of_c is not None and '\\"' in of_c.group():
        end, meant = of_c.end(), of_c.group()[1:-1].replace('\\"', "'")
    elif doubled is not None and doubled.group()[1:-1].count('""') > 1:
        end, meant = doubled.end(), doubled.group()[1:-1].replace('""', "'")
    elif inner is not None and _is_prose(inner["inner"], problems.source.text):
        end, meant = inner.end(), f"{inner['first']}'{inner['inner']}'{inner['last']}"
    else:
        return 0
    problems.error(
        STRAY_CHARACTER,
        "a text cannot hold double quotes: the second one ends it",
        at + start,
        at + end,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f'write single quotes inside: `"{meant}"`', "$CHR(34) is a double quote"),
        fix=problems.replace(at + start, at + end, f'"{meant}"'),
    )
    return end


_OF_C = re.compile(r'"(?:[^"\\]|\\.)*"')
_DOUBLED = re.compile(r'"(?:[^"]|"")*"')
_INNER = re.compile(r'"(?P<first>[^"]*)"(?P<inner>\w(?:[^"]*[\w.!?])?)"(?P<last>[^"]*)"')
_OPERATORS = frozenset({"AND", "OR", "XOR", "MOD", "THEN", "DO", "OF"})


def _is_prose(inner: str, source: str) -> bool:
    """Whether what stands between two texts is no name that the program knows."""
    first = inner.split()[0]
    if first.upper() in _OPERATORS:
        return False
    uses = re.findall(rf"(?<![\w.$#]){re.escape(inner)}(?![\w.])", source, re.IGNORECASE)
    return " " in inner or len(uses) == 1
