"""Marks one session in a process that was started for it, where processes are not forked."""

import base64
import sys
from pathlib import Path

import msgspec

from vrts.live.session_marker import SessionMarker
from vrts.marking.marker import Told
from vrts.marking.one import Order
from vrts.marking.supervise.forked import NO_MEMORY
from vrts.marking.supervise.limits import Limits, impose


def main() -> None:
    """Do as standard input says."""
    told = msgspec.json.decode(sys.stdin.buffer.read(), type=Told)
    impose(Limits())
    try:
        marker = SessionMarker(told.place, told.wanted)
        order = Order(told.identifier, told.title, base64.b64decode(told.program))
        answer = marker.work(order, Path(told.folder))
    except MemoryError:
        sys.exit(NO_MEMORY)
    sys.stdout.buffer.write(answer)


if __name__ == "__main__":
    main()
