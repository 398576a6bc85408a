"""Steps of AS in a form of their own: told by their shape as a whole, and never carried out.

A line that only begins like one is no such step, so that a slip in it is still found.
"""

import re

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
    r"POINT[ \t]*/(?:[XYZOAT]|OAT|EXT|7|8|9|1[0-8])[ \t]+[^=]+=[ \t]*\S", re.ASCII | re.IGNORECASE
)


def untouched_word(text: str) -> str | None:
    """Return the word that a step of such a form is told under; None for any other step."""
    if _COMPONENT.match(text):
        return "POINT"
    if _FUNCTION.fullmatch(text):
        return "FN"
    if " ACCU" in text.upper() and _BLOCK.match(text):
        return BLOCK_WORD
    return None
