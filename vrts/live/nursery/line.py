"""What the server and the nursery say to each other, one packet each."""

import struct
import sys
from typing import Final

import msgspec

WORKS: Final = sys.platform == "linux"  # pidfds, packets, and forks that are safe
ANSWER: Final = struct.Struct("<BQq")  # what, number of the session, and a number about it
BEGUN, NOT_BEGUN, ENDED = 1, 2, 3  # with process id and its pidfd; errno; exit status
STREAMS: Final = 3  # input, output, errors
LONGEST: Final = 16_384  # bytes of an order


class Order(msgspec.Struct, frozen=True, array_like=True):
    """What the server wants: a session, with which come its three streams, or a scene kept."""

    number: int  # of the session; 0: keep the scene read, for later ones
    scene: str
    task: str
    lab: str
    controller: str
