"""How many WebSocket frames a connection may send; pings and empty parts of messages count too."""

from typing import Final

from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket

FRAMES: Final = (200.0, 2000.0)  # a second, and at once: what waited for a network comes together
SLICE: Final = 4096  # bytes that are taken together, so that a flood is noticed in time


class Frames:
    """Counts the frames of a connection."""

    def __init__(self) -> None:
        """Begin with none."""
        self._bucket = Bucket(*FRAMES)

    def take(self) -> bool:
        """Count one; return whether it may be."""
        return self._bucket.take(steady())
