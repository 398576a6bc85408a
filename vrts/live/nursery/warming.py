"""Loads and prepares what sessions need: a short one, of the robot alone, from beginning to end."""

from pathlib import Path

from vrts.live.actions import Go, Step, Typed, Upload
from vrts.live.session.channel.messages import Act, AskReach, News, Start
from vrts.live.session.live_session import Session
from vrts.live.session.looking.block import block_bytes
from vrts.live.session.looking.state import state_bytes
from vrts.live.session.marks.checker import warm_up
from vrts.live.session.setting import scene_sha256, setting_of
from vrts.live.session.ways.way import asked_of, find

BEAT = 0.1  # [s]
BEATS = 10  # after each action
PROGRAM = """\
.PROGRAM warm()
 SPEED 80
 READY
 DRIVE 1, 10, 50
 FOR i = 1 TO 3
  SIGNAL i
  a[i] = SQRT(i)
 END
 TYPE "warm"
.END
"""


def warm(folder: Path) -> None:
    """Let a session do one of everything, in a folder that is empty."""
    start = Start(0, str(folder))
    setting = setting_of(start)
    scene_sha256(setting)
    warm_up(setting)
    now_s = 0.0
    session = Session(start, setting, _hear, lambda: now_s)
    actions = (
        Upload("warm.v2", PROGRAM),
        Typed("EXECUTE warm"),
        Typed("WHERE"),
        Typed("DO a = 1"),
        Step("joint", 1, 1, 0.01),
        Step("tool", 3, 1, 0.01),
        Go((0.4, 0.2, 0.0), (0.0, 1.6, 0.0)),
    )
    for ref, action in enumerate(actions):
        session.take(Act(ref, now_s, "nobody", action))
        for _ in range(BEATS):
            now_s += BEAT
            session.beat()
    asked = AskReach(0, (0.4, 0.2, 0.0), (0.0, 1.6, 0.0))
    session.reach(asked)
    find(
        setting.scene,
        session.growing.machine.system.planner.stance,
        asked_of(session.growing, asked),
    )
    block_bytes(session.run, 0, 0.0)
    state_bytes(session)
    session.program("warm")


def _hear(_: News | bytes) -> None:
    """Tell nobody."""
