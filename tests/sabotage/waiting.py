"""Faults planted in what keeps commands from waiting while many robots are at work."""

from tests.sabotage.patch import Patch

TURNS = "tests/unit/live/session/marks/test_turns.py"

WAITING: tuple[Patch, ...] = (
    Patch(
        "all sessions check what they did in the same moment",
        "vrts/live/session/marks/checker.py",
        "        if not self._turns.take():",
        "        if not (self._turns.take() or True):",
        (TURNS,),
    ),
    Patch(
        "one check that takes long keeps all others waiting",
        "vrts/live/session/marks/checker.py",
        "            if not 0.0 <= since < TURN:",
        "            if False:",
        (TURNS,),
    ),
    Patch(
        "checks have as much of the processor as frames, where Linux groups processes",
        "vrts/marking/supervise/limits.py",
        "    if niceness and os.getsid(0) == os.getpid():",
        "    if False:",
        ("tests/unit/marking/supervise/test_aside.py",),
    ),
    Patch(
        "frames are made at full rate of an arm at which nobody looks",
        "vrts/live/rooms/room.py",
        "if wanted else UNWATCHED",
        "if wanted else FULL_RATE",
        ("tests/unit/live/rooms/test_room.py",),
    ),
)
