"""A dialogue from lines that are all there: a file, or a pipe [the terminal is elsewhere].

The next line is issued when the robot program has stopped or asks something; or, after a line
`;@ 2.5`, at that simulated time, so that commands can be given while a program executes.
"""

import re
from collections.abc import Iterable, Iterator

from vrts.monitor.dialogue import Dialogue

LONGEST = 600.0  # [s] of simulated time that one command may take

_AT = re.compile(r"[ \t]*;@[ \t]*(\d{1,6}(?:\.\d*)?|\.\d+)[ \t]*")


def transcript(dialogue: Dialogue, lines: Iterable[str]) -> Iterator[str]:
    """Yield what a terminal would show, piece by piece: prompts, the lines, and answers."""
    timed = False
    for raw in lines:
        line = raw.rstrip("\r\n")
        at = _AT.fullmatch(line)
        if at is not None:
            timed = True
            yield dialogue.advance(float(at[1]))
            continue
        if not timed and dialogue.monitor.at_commands:
            yield dialogue.settle(LONGEST)
        timed = False
        yield f"{dialogue.prompt}{line}\n"
        yield dialogue.enter(line)
    yield dialogue.settle(LONGEST)
