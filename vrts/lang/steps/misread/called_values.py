"""`y = CALL twice(5)`: a program yields nothing that could be assigned."""

import re

from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import VARIABLE, Meant

_CALLED = re.compile(
    rf"(?P<target>{VARIABLE})[ \t]*:?=(?!=)[ \t]*(?P<call>CALL)[ \t]+(?P<program>[A-Za-z][\w.]*)"
    r"[ \t]*(?:\((?P<given>.*)\)|(?P<loose>[^()]*))",
    re.ASCII | re.IGNORECASE,
)
_STARTING = re.compile(r"(?:REACTI?|PCEXECUTE|IF)\b(?!.*THEN)", re.IGNORECASE)  # take names
_INSIDE = re.compile(
    r"(?<![\w.$#])CALL[ \t]+(?P<program>[A-Za-z][\w.]*)(?:[ \t]*\((?P<given>[^()]*)\))?",
    re.ASCII | re.IGNORECASE,
)
_OPERATOR = re.compile(
    r"(?:[-+*/(<>,=]|(?:^|[ \t])(?:TYPE|IF|WHILE|UNTIL|WAIT|NOT|AND|OR))[ \t]*$", re.I
)
_SAYS = "VAL-II says *Illegal expression syntax*"
_NOTHING = "a program gives no value back: CALL stands at the start of a step"


def called_value(text: str) -> Meant | None:
    """Return what is meant by CALL in an expression."""
    found = _CALLED.fullmatch(text)
    if found is not None:
        given = (found["given"] or found["loose"] or "").strip(" \t,")
        arguments = f"{given}, {found['target']}" if given else found["target"]
        call = f"CALL {found['program']}({arguments})"
        help_ = f"let the program put it into an argument: `{call}`"
        return Meant(
            UNEXPECTED_TEXT,
            _NOTHING,
            found.start("call"),
            len(text),
            (help_,),
            notes=(_SAYS,),
        )
    if _STARTING.match(text):
        return None
    for inside in _INSIDE.finditer(text):
        before, behind = text[: inside.start()], text[inside.end() :]
        if before.count('"') % 2 or not _OPERATOR.search(before):
            continue
        given = (inside["given"] or "").strip()
        call = f"CALL {inside['program']}({given}{', ' if given else ''}result)"
        help_ = f"let it put the result into an argument: `{call}`, then `{before}result{behind}`"
        return Meant(
            UNEXPECTED_TEXT, _NOTHING, inside.start(), inside.end(), (help_,), notes=(_SAYS,)
        )
    return None
