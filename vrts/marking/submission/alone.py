"""Marks one program in a process that was started for it: reads what to do, writes the results.

`python -m vrts.marking.submission.alone`, where processes are not forked; see `supervise`.
"""

import base64
import sys
from pathlib import Path

import msgspec

from vrts.marking.submission.marker import Marker, Told
from vrts.marking.submission.one import Order
from vrts.marking.supervise.forked import NO_MEMORY
from vrts.marking.supervise.limits import Limits, impose


def main(kind: type[Marker] = Marker) -> None:
    """Do as standard input says, by a kind of marker."""
    told = msgspec.json.decode(sys.stdin.buffer.read(), type=Told)
    impose(Limits())
    try:
        marker = kind(told.place, told.wanted)
        order = Order(told.identifier, told.title, base64.b64decode(told.program))
        answer = marker.work(order, Path(told.folder))
    except MemoryError:
        sys.exit(NO_MEMORY)
    sys.stdout.buffer.write(answer)


if __name__ == "__main__":
    main()
