"""Steps of AS in a form of their own: told by their shape as a whole, and never carried out.

A line that only begins like one is no such step, so that a slip in it is still found.
"""

import re

from vrts.lang.problems import Problems
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.vocabulary.commands import look_up_command
from vrts.lang.vocabulary.lookup import hardly_a_name
from vrts.lang.vocabulary.relatives_commands import commands_of

BLOCK_WORD = "block step"

_NUMBER = r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?"
_LIST = rf"(?:{_NUMBER}(?:[ \t]*,[ \t]*{_NUMBER})*)?"
_CLAMP = r"\d+[ \t]*\((?:ON|OFF),\d+,\d+,(?:\d+|[A-Z])\)"  # 1 (OFF,0,0,O)
_SIGNAL = r"-?(?:\^[BH])?[\dA-F.]+"
# JOINT SPEED9 ACCU1 TIMER0 TOOL1 WORK0 CLAMP1 (OFF,0,0,O) OX= WX= #[0,10,-30,0,15,0]
_BLOCK = re.compile(
    rf"""(?:A[CS][ \t]+)?[A-Z]\w*
    [ \t]+(?:SPEED)?[ \t]*\d[\d.]*
    [ \t]+ACCU\d+
    [ \t]+TIMER\d+[ \t]+TOOL\d+[ \t]+WORK\d+(?:[ \t]+GROUP\d+)?(?:[ \t]+MATHN\d+)?
    (?:[ \t]+(?:END|JUMP))?
    [ \t]+CLAMP[ \t]*(?:{_CLAMP}[ \t]*)*
    (?:[ \t]*(?:OX|WX|YO|YI)=[ \t]*(?:{_SIGNAL}(?:[ \t]*,[ \t]*{_SIGNAL})*)?)*
    [ \t]*(?:\#\[[ \t]*{_LIST}[ \t]*\])?
    [ \t]*$""",
    re.ASCII | re.IGNORECASE | re.VERBOSE,
)
_FUNCTION = re.compile(  # FN20[ 7 ], FN99[ "text" ], FN312[ 8,V9%,I85 ]
    r"FN\d+(?:[ \t]*\[(?:[ \t]*(?:\"[^\"]*\"|[\w.$%&#+-]+)[ \t]*(?:,|(?=\])))+\]|[ \t]*$)",
    re.ASCII | re.IGNORECASE,
)
_COMPONENT = re.compile(  # POINT/X a = b sets one component
    r"POINT[ \t]*(?P<component>/(?:[XYZOAT]|OAT|EXT|7|8|9|1[0-8]))(?=[ \t])",
    re.ASCII | re.IGNORECASE,
)

_BEGINNING = frozenset({"EXECUTE", "PRIME"})  # programs
_MONITOR = re.compile(r"MC[ \t]+(?P<word>[A-Z][\w.]*)(?:/\w+)*", re.ASCII | re.IGNORECASE)
_ROBOT = r"(?:[\w.$\[\]]+[ \t]*:)?"  # the number of a robot or task
_VALUE = r"-?[\w.]+(?:\[[^\]]*\])?"
_PROGRAM = re.compile(  # 2: main, -1, 5
    rf"[ \t]*{_ROBOT}[ \t]*(?P<name>{_VALUE})?[ \t]*(?:,[ \t]*(?:{_VALUE})?[ \t]*)*:?[ \t]*$",
    re.ASCII,
)


def untouched_word(text: str) -> str | None:
    """Return the word that a step of such a form is told under; None for any other step."""
    if _FUNCTION.fullmatch(text):
        return "FN"
    if " ACCU" in text.upper() and _BLOCK.match(text):
        return BLOCK_WORD
    return None


def without_component(text: str) -> str | None:
    """Return `POINT/X a = b` with blanks for `/X`, to be read like POINT; None for other steps."""
    match = _COMPONENT.match(text)
    if match is None:
        return None
    start, end = match.span("component")
    plain = text[:start] + " " * (end - start) + text[end:]
    return None if _COMPONENT.match(plain) else plain


def monitor_step(text: str, at: int, problems: Problems) -> bool:
    """Return whether MC of AS is followed by a command, and by what it takes; report it if not."""
    match = _MONITOR.match(text)
    word = match["word"].upper() if match else ""
    found = look_up_command(word)
    known = commands_of(problems.dialect)
    short = [other for other in known if other.startswith(word)] if word else []
    if match is None or not (found.word or found.candidates or short):
        start = at + (match.start("word") if match else 0)  # MC may be short: `M`
        problems.error(
            INVALID_EXPRESSION,
            "MC gives the monitor a command, and this is none",
            start,
            at + len(text),
            help=("write the command behind MC, as in `MC EXECUTE main`",),
        )
        return False
    given = found.word.text if found.word is not None else word
    if given not in _BEGINNING:
        return True
    program = _PROGRAM.match(text, match.end())
    if program and not hardly_a_name(program["name"] or "", problems.dialect):
        return True
    problems.error(
        INVALID_EXPRESSION,
        f"{given} begins a program, and this names none",
        at + match.end(),
        at + len(text),
        help=(f"write `MC {given} program, cycles, step`",),
    )
    return False
