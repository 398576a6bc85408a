"""`a = b = 0`: two values in one step."""

import re

from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.other_forms import SINGLE_EQUALS
from vrts.lang.vocabulary.functions import CONSTANTS

_CHAIN = re.compile(
    rf"(?P<word>SET[ \t]+)?(?P<names>{VARIABLE}(?:[ \t]*==?[ \t]*{VARIABLE})+)"
    r"[ \t]*(?P<last>=)(?!=)[ \t]*(?P<value>[^ \t=].*)",
    re.ASCII | re.IGNORECASE,
)
_EQUALS = re.compile(r"(?<![<>=])=(?!=)")
_STRING = re.compile(r'"[^"]*"')


def chain(text: str) -> Meant | None:
    """Return what is meant by a step with several names that take one value."""
    found = _CHAIN.fullmatch(text)
    if found is None or _EQUALS.search(_STRING.sub("", found["value"])):
        return None
    word = "SET " if found["word"] else ""
    names = [name.strip() for name in re.split("==?", found["names"])]
    if any(name.lower() in CONSTANTS for name in names[1:]):
        return None
    steps: list[str] = []
    value = found["value"].strip()
    for name in reversed(names):
        steps.append(f"{word}{name} = {value}")
        value = name
    help_ = "write a step for each: " + ", then ".join(f"`{step}`" for step in steps)
    helps = [help_]
    if len(names) == len(("target", "compared")) and not word and names[0][0] not in "$#":
        compared = f"{names[0]} = {names[1]} == {found['value'].strip()}"
        helps.append(f"if it is to compare, write `==`: `{compared}`")
    return Meant(
        SINGLE_EQUALS,
        "a step gives one value: one `=` stands in it",
        found.start("last"),
        found.end("last"),
        tuple(helps),
        notes=("VAL-II says *Illegal operator*",),
    )
