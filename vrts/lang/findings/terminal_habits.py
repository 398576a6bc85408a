"""What TYPE and PROMPT take as it stands, and who writes it means otherwise.

Formats behind their number or in quotes, those of C and Python, answers that nothing keeps, and
pieces behind a `;` as BASIC has them.
"""

import re
from itertools import pairwise

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.forms import is_text
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, FormatItem, Item, Number, Text
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Assignment, Simple

FORMAT_HABIT = Rule("V237", "format-habit")
ANSWER_LOST = Rule("V242", "answer-lost")

_QUOTED = re.compile(r"/?[FIGE]\d+(?:\.\d+)?|%\d*(?:\.\d+)?[dfg]", re.IGNORECASE)
_OF_C = re.compile(r"%[-+ 0]?\d*(?:\.\d+)?(?:l?[dfgisu]|[eE])(?![A-Za-z])")
_BRACES = re.compile(r"\{(?:\d*|[A-Za-z]\w*)(?::[^}]*)?\}")
_NEW_LINE = re.compile(r"\\n|\\t")
_CONTROLS = {r"\n": "/C1", r"\t": "/X4"}
_ASKS_FOR_NOTHING = re.compile(
    r"\b(press|hit|enter|return|key|ready|ok|okay|go on|continue|confirm|weiter|taste)\b", re.I
)
_REST = re.compile(r"[ \t]*;[ \t]*(?P<item>\"[^\"]*\"|[$]?[A-Za-z][\w.]*)[ \t]*(?=\n|$)")
_SIGNS = frozenset("%{\\")  # without one of them no format of another language is there
_PLAIN = frozenset("cxsub")  # formats that write something by themselves


def check_terminal(problems: Problems, program: ProgramText) -> None:
    """Warn of what is written to the terminal in the way of another language."""
    for step in program.steps:
        node = step.statement
        if isinstance(node, Simple):
            if node.word == "TYPE":
                _typed(problems, node)
            elif node.word == "PROMPT":
                _prompted(problems, node)
        value = node.value if isinstance(node, Assignment) else None
        if isinstance(value, Application) and value.name.text.lower() == "$encode":
            _formats(problems, value.arguments)


def _typed(problems: Problems, node: Simple) -> None:
    if node.operands:
        _behind_semicolon(problems, node)
        _named(problems, node.operands)
        if not _formats(problems, node.operands):
            _of_other_languages(problems, node.operands)


def _formats(problems: Problems, items: tuple[Item | None, ...]) -> bool:
    """`TYPE x, /F6.2` and `TYPE "/F6.2", x`; return whether it was told."""
    last = items[-1] if items else None
    if isinstance(last, FormatItem) and last.text[1:2].lower() not in _PLAIN:
        before = items[-2] if len(items) > 1 else None
        number = before is not None and not isinstance(before, FormatItem) and not is_text(before)
        written = problems.source.text[before.start : before.end] if number and before else "x"
        problems.warning(
            FORMAT_HABIT,
            f"the format `{last.text}` stands behind its number, and changes nothing",
            last.start,
            last.end,
            "no number follows it",
            help=(f"write it before the number: `{last.text}, {written}`",),
            fix=problems.replace(before.start, last.end, f"{last.text}, {written}", sure=False)
            if number and before
            else None,
        )
        return True
    for item, following in pairwise(items):
        if isinstance(item, FormatItem) and isinstance(following, Number):
            glued = problems.source.text[item.start : following.end]
            found = _DECIMAL_COMMA.fullmatch(glued)
            if found is not None:
                _comma_in_format(problems, item, following, found)
                return True
        if not isinstance(item, Text) or following is None or is_text(following):
            continue
        if len(item.value) > 1 and _QUOTED.fullmatch(item.value):
            _quoted(problems, item)
            return True
    return False


def _comma_in_format(
    problems: Problems, item: FormatItem, following: Number, found: re.Match[str]
) -> None:
    instead = f"{found['width']}.{found['digits']}"
    problems.warning(
        FORMAT_HABIT,
        f"`{found['digits']}` is written as a number of its own: the comma ends the format",
        item.start,
        following.end,
        notes=("a format has a point between its width and its digits",),
        help=(f"write `{instead}`",),
        fix=problems.replace(item.start, following.end, instead),
    )


def _quoted(problems: Problems, item: Text) -> None:
    bare = item.value.lstrip("/%").upper()
    of_c = item.value[0] == "%" or not bare[0].isalpha()
    instead = f"/{_LETTER[bare[-1]]}{bare[:-1] or _WIDTH[bare[-1]]}" if of_c else f"/{bare}"
    problems.warning(
        FORMAT_HABIT,
        "a format in quotes is a text like any other",
        item.start,
        item.end,
        f"written as it stands: {item.value}",
        help=(f"write it without quotes: `{instead}`",),
        fix=problems.replace(item.start, item.end, instead, sure=False),
    )


_DECIMAL_COMMA = re.compile(r"(?P<width>/[FGE]\d+),(?P<digits>\d)", re.IGNORECASE)
_LETTER = {"D": "I", "F": "F", "G": "G"}
_WIDTH = {"D": "0", "F": "0.2", "G": "0.3"}  # of a format that names none


def _of_other_languages(problems: Problems, items: tuple[Item | None, ...]) -> None:
    r"""`TYPE "%d", n`, `TYPE "n = {}", n`, `TYPE "done\n"`."""
    for at, item in enumerate(items):
        if not isinstance(item, Text) or _SIGNS.isdisjoint(item.value):
            continue
        found = _NEW_LINE.search(item.value)
        help_, instead = "", ""
        if found is not None:
            instead = _parted(item.value, last=at + 1 == len(items))
            help_ = f"write `{instead}`"
            if found.group() == "\\n" and found.end() == len(item.value) and at + 1 == len(items):
                help_ = "TYPE ends its line by itself: leave it out; `/C1` makes an empty line"
        if found is None and at + 1 < len(items):
            found = _OF_C.search(item.value) or _BRACES.search(item.value)
            help_ = "TYPE writes text and numbers as they follow each other: "
            help_ += '`TYPE "n = ", n`, with a format as `/F6.2` before a number'
        if found is None:
            continue
        start = item.start + 1 + found.start()
        problems.warning(
            FORMAT_HABIT,
            f"`{found.group()}` in a text is written as it stands",
            start,
            start + len(found.group()),
            "no format of VAL-II",
            help=(help_,),
            fix=problems.replace(item.start, item.end, instead, sure=False) if instead else None,
        )
        return


def _named(problems: Problems, items: tuple[Item | None, ...]) -> None:
    """`TYPE "n = ", "n"`: the name of a variable between quotes, where its value is meant."""
    for before, item in pairwise(items):
        if not isinstance(before, Text) or not isinstance(item, Text):
            continue
        if not before.value.rstrip().endswith(("=", ":")) or not item.value.isidentifier():
            continue
        given = rf"^[ \t\d]*(?:FOR[ \t]+)?{re.escape(item.value)}[ \t]*=(?!=)"
        if re.search(given, problems.source.text, re.IGNORECASE | re.MULTILINE) is None:
            continue
        problems.warning(
            FORMAT_HABIT,
            f"between quotes `{item.value}` is a text: its letters are written, not its value",
            item.start,
            item.end,
            help=(f"leave the quotes out: write `{item.value}`",),
            fix=problems.replace(item.start, item.end, item.value),
        )


def _parted(value: str, *, last: bool) -> str:
    r"""Return `"a", /C1, "b"` for `a\nb`; what ends the last text of a TYPE is left out."""
    pieces = re.split(r"(\\[nt])", value)
    if last and len(pieces) > 1 and pieces[-2:] == ["\\n", ""]:
        pieces = pieces[:-2]
    shown = [_CONTROLS.get(piece, f'"{piece}"') for piece in pieces if piece]
    return ", ".join(shown) or '""'


def _prompted(problems: Problems, node: Simple) -> None:
    if _behind_semicolon(problems, node) or len(node.operands) != 1:
        return
    text = node.operands[0]
    if not isinstance(text, Text):
        return
    asks = text.value.rstrip().endswith(("?", ":", "="))
    if not asks or _ASKS_FOR_NOTHING.search(text.value):
        return
    problems.warning(
        ANSWER_LOST,
        "no variable takes the answer to this PROMPT",
        node.start,
        node.end,
        "the answer is lost",
        help=(f"name a variable behind a comma: `PROMPT {_written(problems, text)}, n`",),
    )


def _behind_semicolon(problems: Problems, node: Simple) -> bool:
    """`TYPE "n = "; n`: BASIC joins what it prints by `;`; return whether it was told."""
    text = problems.source.text
    found = _REST.match(text, node.end)
    if found is None:
        return False
    item = found["item"]
    name = item.lower()
    if item[0] != '"' and (text[node.end : node.end + 1] != ";" or not _is_variable(text, name)):
        return False
    problems.warning(
        FORMAT_HABIT,
        f"what stands behind `;` is a remark: {item} is not part of this {node.word}",
        found.start("item"),
        found.end("item"),
        "a remark to the controller",
        help=(f"put a comma before it: `{text[node.start : node.end]}, {item}`",),
        fix=problems.replace(node.end, found.start("item"), ", ", sure=False),
    )
    return True


def _is_variable(text: str, name: str) -> bool:
    """Whether a program gives a name a value, or uses it in a sum."""
    pattern = rf"^[^;\n]*(?<![\w.$#]){re.escape(name)}(?![\w.])"
    return re.search(pattern, text, re.IGNORECASE | re.MULTILINE) is not None


def _written(problems: Problems, node: Item) -> str:
    return problems.source.text[node.start : node.end]
