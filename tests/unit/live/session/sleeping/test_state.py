"""A session that falls asleep and wakes, from its state and from its log: it is what it was."""

import random
import shutil
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from tests.unit.live.session.again.test_carrying_on import told
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.again.carrying_on import How, Voice, carry_on
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import Done, Start
from vrts.live.session.growing.folder import ASLEEP, FILE
from vrts.live.session.live_session import Clock, Send, Session
from vrts.live.session.looking.block import block_bytes
from vrts.live.session.sleeping.state import Unfit, put_away, woken

SWING = """\
.PROGRAM swing(.by)
 LOCAL i
 FOR i = 1 TO 3
  DRIVE 1, .by, 60
  turns[i] = turns[i-1]+.by
  SIGNAL i, -(i+1)
 END
 TYPE "swung ", /F8.2, turns[3]
.END
"""
WATCH = ".PROGRAM watch()\n REACTI 1001, swing\n 10 n = n+1\n WAIT TIMER(1) > 0.5\n.END\n"


class Again(Driven):
    """The same session in another process, with the same clock."""

    def __init__(
        self, first: Driven, start: Start, begun: Callable[[Send, Clock], Session]
    ) -> None:
        self.clock_s = first.clock_s
        self.news, self.frames, self.log = [], [], []
        self.start = start
        self._given, self._count = {}, first._count
        self.session = begun(self._hear, self._clock)


def from_state(first: Driven, folder: Path) -> Again:
    """Put a session away, and wake it in a copy of its folder."""
    sha256 = put_away(first.session, {})
    assert sha256
    shutil.copytree(first.start.folder, folder)
    start = msgspec.structs.replace(first.start, folder=str(folder), asleep_sha256=sha256)
    setting = first.session.setting
    return Again(first, start, lambda send, clock: woken(start, setting, send, clock))


def from_log(first: Driven, folder: Path, entries: list[Entry], until_s: float) -> Again:
    """Repeat a session in an empty folder."""
    folder.mkdir()
    start = msgspec.structs.replace(first.start, folder=str(folder))

    def begun(send: Send, clock: Clock) -> Session:
        voice = Voice()
        session = Session(start, first.session.setting, voice, clock)
        carry_on(session, voice, entries, until_s, how=How.SLEPT)
        voice.to = send
        return session

    return Again(first, start, begun)


def state_of(driven: Driven) -> dict[str, object]:
    """Return everything that anybody can see of a session now."""
    session = driven.session
    session.beat()
    shown = msgspec.to_builtins(session.showing.snapshot(0))
    for volatile in ("contacts", "near", "marked"):  # of checks, which nobody makes here
        shown.pop(volatile)
    shown["status"].pop("checked_s")
    for row in shown["events"]:
        if (
            row["kind"] == "note"
        ):  # told at the next beat, and a session that is repeated beats less
            row.pop("time_s")
    growing = session.growing
    state, desk = session.run.at(growing.time_s), session.conversation.monitor.desk
    return {
        "shown": shown,
        "variables": state.variables,
        "poses": state.poses,
        "under way": session.under_way,
        "desk": [(*p[:5], [f.headline for f in p.faults]) for p in desk.programs.values()],
        "program": session.program("all"),
        "files": sorted(path.name for path in Path(driven.start.folder).glob("ada/*")),
    }


def past_of(driven: Driven) -> list[bytes]:
    """Return all blocks of the past."""
    growing = driven.session.growing
    found: list[bytes] = []
    for number in range(int(growing.time_s // 60) + 1):
        run = growing.run_of(max(60.0 * number, growing.reaches_s), 60.0 * (number + 1))
        assert run is not None
        found.append(block_bytes(run, number, growing.reaches_s))
    return found


def rest(driven: Driven) -> None:
    """Let time pass until nothing is under way; a program that does not end is stopped."""
    for _ in range(300):
        if not driven.session.under_way:
            return
        driven.run(0.5)
    driven.typed("ABORT", "PCEND", seconds=2.0)
    driven.halt()
    driven.run(3.0)


def something(driven: Driven, chance: random.Random) -> None:
    """Do something at random."""
    now_s = driven.session.now_s
    actions: list[do.Action] = [
        do.Upload("swing.v2", SWING),
        do.Upload("watch.v2", WATCH),
        do.Upload("bad.v2", ".PROGRAM bad()\n MOV 1\n.END\n"),
        do.Typed(f"EXECUTE swing({chance.randint(-20, 20)})"),
        do.Typed("PCEXECUTE watch"),
        do.Typed("PCEND"),
        do.Typed("ABORT"),
        do.Typed("PROCEED"),
        do.Typed("EXECUTE bad"),
        do.Typed(f"DO a[{chance.randint(0, 3)}] = {chance.random():.3f}"),
        do.Typed("DO n = RANDOM"),
        do.Typed("HERE place"),
        do.Typed("LISTL"),
        do.Typed("STORE all"),
        do.Typed(f"SPEED {chance.randint(20, 100)}"),
        do.Typed(f"SIGNAL {chance.choice('123')}, -4"),
        do.Typed("RESET"),
        do.Typed("WHERE"),
        do.Step("joint", chance.randint(0, 5), chance.choice((1, -1)), 0.1),
        do.Step("tool", chance.randint(0, 5), chance.choice((1, -1)), 0.02),
        do.Jog("joint", 0, chance.choice((1, -1)), 0.5),
        do.LetGo(),
        do.Hand(chance.random() < 0.5),
        do.Ready(),
        do.Record("spot"),
        do.Save("lesson"),
        do.Rewind(now_s * chance.random()),
        do.Reset(),
    ]
    weights = [*[2.0] * (len(actions) - 2), 1.0, 0.3]
    driven.act(chance.choices(actions, weights)[0], chance.choice(("ada", "ada", "bob")))
    driven.run(chance.choice((0.02, 0.3, 2.0, 11.0)))


@pytest.mark.thorough
@pytest.mark.parametrize(
    "seed", [1, *[pytest.param(n, marks=pytest.mark.thorough) for n in range(2, 8)]]
)
def test_a_session_wakes_as_it_was_from_its_state_and_from_its_log(
    tmp_path: Path, seed: int
) -> None:
    (tmp_path / "first").mkdir()
    first, chance = Driven(tmp_path / "first"), random.Random(seed)
    for nap in range(2):
        for _ in range(12):
            something(first, chance)
        rest(first)
        entries, until_s = told(first), first.session.growing.time_s
        before = past_of(first)
        state = from_state(first, tmp_path / f"state{nap}")
        log = from_log(first, tmp_path / f"log{nap}", entries, until_s)
        was = state_of(first)
        assert state_of(state) == was
        assert state_of(log) == was
        assert past_of(state) == past_of(log) == before
        seed_of_more = chance.random()
        answers: list[list[Done]] = []
        for one in (first, state, log):
            heard, more = len(one.said(Done)), random.Random(seed_of_more)
            for _ in range(6):
                something(one, more)
            rest(one)
            answers.append(one.said(Done)[heard:])
        assert answers[1] == answers[0]
        assert answers[2] == answers[0]
        was = state_of(first)
        assert state_of(state) == was
        assert state_of(log) == was


def test_a_state_that_does_not_fit_is_left_aside(tmp_path: Path) -> None:
    folder = tmp_path / "first"
    folder.mkdir()
    driven = Driven(folder)
    driven.typed("DO a = 1", "DO DRIVE 1,10,50", seconds=2.0)
    sha256 = put_away(driven.session, {})
    start = msgspec.structs.replace(driven.start, asleep_sha256=sha256)
    setting = driven.session.setting

    def unfit(why: str) -> None:
        with pytest.raises(Unfit, match=why):
            woken(start, setting, lambda _: None, lambda: 0.0)

    data, history = (folder / ASLEEP).read_bytes(), (folder / FILE).read_bytes()
    (folder / ASLEEP).write_bytes(data[:-1])
    unfit("it was changed")
    (folder / ASLEEP).write_bytes(data)
    (folder / FILE).write_bytes(history[:-1])
    unfit("the file of its history is another one")
    (folder / FILE).write_bytes(history)
    assert woken(start, setting, lambda _: None, lambda: 0.0).growing.time_s > 2.0
    (folder / ASLEEP).unlink()
    unfit("it is not there")


def test_who_edits_at_the_monitor_wakes_from_the_log(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.typed("EDIT new", "READY")
    assert not driven.session.under_way
    assert put_away(driven.session, {}) == ""
