"""`DELAY FOR 5`, `DEPART FROM part, 50`: small words of English that no step takes."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.lookup import look_up

_FILLED = re.compile(
    r"(?P<word>[A-Za-z]+)[ \t]+(?P<filler>for|from|to|at|of|the|with|by|until|on|over|is|towards?)"
    r"[ \t]+(?P<rest>\S.*)",
    re.IGNORECASE | re.ASCII,
)


def filler(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step that is right without the small word behind its first."""
    found = _FILLED.fullmatch(text)
    word = look_up(found["word"], dialect).word if found is not None else None
    if found is None or word is None or word.text != found["word"].upper():
        return None
    meant = f"{found['word']} {found['rest']}"
    tried = repair.steps(meant)
    if tried is None:
        return None
    small = found["filler"].upper()
    return Meant(
        UNEXPECTED_TEXT,
        f"{word.text} takes no {small}",
        found.start("filler"),
        len(text),
        (f"take `{found['filler']}` out: write `{tried.text}`",),
        tried.text[len(found["word"]) :].lstrip(),
        sure=not tried.fixes,
        notes=("VAL-II says *Unexpected text at end of line*",),
    )
