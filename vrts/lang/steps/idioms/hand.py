"""The hand as other robot languages and beginners name it."""

# fmt: off
# ruff: noqa: E501

import re

from vrts.lang.steps.idioms.idiom import Idiom

HAND = (
    Idiom("<grab|grip|catch|close_gripper|closegripper|close_hand|closehand|gripper_close|hand_close|grip_close|gripperclose|handclose|grab_part|pick_up|pickup|gripclose|clamp|grippe|grab_object|take|hold_part|gripper_on|closegrip|close_grip> <(|> <)|>", "CLOSEI", says="the hand is closed by CLOSEI"),
    Idiom("<release|ungrip|drop|let_go|letgo|open_gripper|opengripper|open_hand|openhand|gripper_open|hand_open|gripperopen|handopen|gripopen|unclamp|ungrasp|free|gripper_off|opengrip|loose|unhand|open_grip|put_down> <(|> <)|>", "OPENI", says="the hand is opened by OPENI"),
    Idiom("<close|gripper|hand|grip>_<gripper|hand|grip|close|closed|fingers|jaws|on>", "CLOSEI", says="the hand is closed by CLOSEI"),
    Idiom("<open|gripper|hand|grip>_<gripper|hand|grip|open|opened|fingers|jaws|off>", "OPENI", says="the hand is opened by OPENI"),
    Idiom("close_<i|immediate|immediately|now>", "CLOSEI", says="CLOSEI is one word"),
    Idiom("open_<i|immediate|immediately|now>", "OPENI", says="OPENI is one word"),
    Idiom("<gripper|hand|grip> = <open|0|off|false>", "OPENI", says="the hand is opened by OPENI", sure=False),
    Idiom("<gripper|hand|grip> = <close|closed|1|on|true>", "CLOSEI", says="the hand is closed by CLOSEI", sure=False),
    Idiom("<grab|grip|pick|pickup|take|catch>_{v}", "", "other robot languages", help="write `MOVES {v}`, then CLOSEI"),
    Idiom("<release|drop|place|put>_{v}", "", "other robot languages", help="write `MOVES {v}`, then OPENI"),
    Idiom("<grab|grip|pick|pickup|take> ( {v} )", "", "other robot languages", help="write `MOVES {v}`, then CLOSEI"),
    Idiom("<release|drop|place|put> ( {v} )", "", "other robot languages", help="write `MOVES {v}`, then OPENI"),
    Idiom("openi ( )", "OPENI", says="OPENI has no parentheses"),
    Idiom("closei ( )", "CLOSEI", says="CLOSEI has no parentheses"),
    Idiom("<stop|halt|pause|ready|break|openi|closei|open|close> ( )", "", says="an instruction without operands has no parentheses", help="leave the parentheses out"),
)

_PARTED = re.compile(
    r"[ \t]*(?:\d+[ \t]+)?(?P<word>OPEN|CLOSE|RELAX)[ \t]+I[ \t]*(?:;.*)?", re.IGNORECASE
)


def parted_word(line: str) -> tuple[str, int] | None:
    """Return the word that `CLOSE I` means, and where it begins: a step, but hardly a meant one."""
    found = _PARTED.fullmatch(line)
    return (f"{found['word'].upper()}I", found.start("word")) if found is not None else None
