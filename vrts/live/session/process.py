"""The process of a session: reads orders, keeps the beat, writes messages; one thread.

A program costs at most 100 statements of each kind a tick, so no program makes a beat late; what
checks collisions is a child of this process.
"""

import select
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from vrts.controllers.values import digest
from vrts.live.session.again.carrying_on import (
    CannotCarryOn,
    How,
    Interrupted,
    Voice,
    carry_on,
    read_entries,
)
from vrts.live.session.channel.inbox import Inbox, Unreadable
from vrts.live.session.channel.messages import Failed, Json, Ready, Start, Stop
from vrts.live.session.channel.messages import Unfit as UnfitState
from vrts.live.session.channel.outbox import Outbox, ServerGone
from vrts.live.session.going import Going
from vrts.live.session.growing.folder import empty
from vrts.live.session.known import Known, read
from vrts.live.session.live_session import Session
from vrts.live.session.marks.turns import Turns
from vrts.live.session.setting import scene_sha256
from vrts.live.session.sleeping.state import Unfit, woken
from vrts.marking.supervise.limits import Limits, impose
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting

FIRST = 30.0  # [s] within which the first order has to come
LIMITS = Limits(cpu_s=12 * 3600, memory=1_000_000_000)
MARGIN = 16_000_000  # bytes by which a file may be longer than the quota of the history
NO_MEMORY, CANNOT_BEGIN, SERVER_GONE, UNREADABLE = 71, 1, 74, 76  # exit statuses

Clock = Callable[[], float]


def serve(
    descriptor_in: int,
    descriptor_out: int,
    clock: Clock = time.monotonic,
    known: Known | None = None,
    turns: Turns | None = None,
) -> int:
    """Be the process of a session until it is told to stop; return the exit status.

    Args:
        descriptor_in: Where orders come from.
        descriptor_out: Where messages go.
        clock: Only goes forward [s].
        known: The scene and task that it will be told, if they are read already.
        turns: At checks, with other sessions; None: it checks when it will.
    """
    inbox, outbox = Inbox(descriptor_in), Outbox(descriptor_out)
    try:
        return _serve(inbox, outbox, descriptor_in, clock, known, turns)
    except ServerGone:
        return SERVER_GONE
    except Unreadable as problem:
        return _failed(outbox, f"an order cannot be read: {problem}", UNREADABLE)
    except MemoryError:
        return _failed(outbox, "the session needs more memory than it may use", NO_MEMORY)


def _serve(
    inbox: Inbox,
    outbox: Outbox,
    readable: int,
    clock: Clock,
    known: Known | None,
    turns: Turns | None,
) -> int:
    select.select([readable], [], [], FIRST)
    orders = inbox.orders()
    start = orders.pop(0) if orders else None
    if not isinstance(start, Start):
        return _failed(outbox, "the first order is to be `start`", UNREADABLE)
    try:
        setting, scene = known or read(start)
    except CannotRead as problem:
        return _failed(outbox, problem.message, CANNOT_BEGIN)
    except Refused as refused:
        headlines = [found.headline for found in refused.diagnostics if found.is_error]
        return _failed(outbox, "; ".join(headlines[:3]), CANNOT_BEGIN)
    impose(replace(LIMITS, file=max(LIMITS.file, start.history) + MARGIN))
    try:
        session, anew = _begun(start, setting, scene, outbox, readable, clock)
    except Interrupted:
        return 0
    except Unfit as problem:
        outbox.send(UnfitState(str(problem)))
        outbox.flush()
        return 0
    title = setting.task.title if setting.task is not None else ""
    arm = setting.scene.robot.arm.name
    carried_s = session.growing.time_s if start.before and not anew else None
    if start.asleep_sha256:
        carried_s = session.growing.time_s
    model = setting.scene.controller
    said = (model.name, digest(model))
    outbox.send(Ready(start.session, session.epoch_s, arm, scene, title, carried_s, anew, *said))
    with closing(Going(session, scene, outbox, clock, turns)) as going:
        while not inbox.ended:
            for order in orders:
                if isinstance(order, Stop):
                    outbox.flush()
                    return 0
                going.hear(order)
            going.beat()
            writable = [outbox] if outbox.waits else []
            select.select([readable, *going.ways.heard], writable, [], going.pause_s)
            orders = inbox.orders()
    return 0


def _begun(
    start: Start, setting: Setting, scene: Json, outbox: Outbox, readable: int, clock: Clock
) -> tuple[Session, str]:
    """Return a session that begins or goes on, and why it begins anew where it was to go on.

    Raises:
        Interrupted: The server has something else to say.
    """

    def wanted() -> bool:
        return not select.select([readable], [], [], 0.0)[0]

    anew = ""
    if start.asleep_sha256:
        return woken(start, setting, outbox.send, clock), ""
    if start.before:
        voice = Voice()
        session = Session(start, setting, voice, clock)
        try:
            entries = read_entries(Path(start.before))
            if scene_sha256(setting) != start.scene_sha256:
                raise CannotCarryOn("its scene or task is another one now")
            if start.controller_sha256 not in ("", digest(setting.scene.controller)):
                raise CannotCarryOn("its controller model is another one now")
            how = How.SLEPT if start.slept else How.EXACT if start.exact else How.STOPPED
            carry_on(session, voice, entries, start.until_s, how=how, wanted=wanted)
        except CannotCarryOn as problem:
            anew = str(problem)
            empty(Path(start.folder))
        else:
            voice.to = outbox.send
            return session, ""
    return Session(start, setting, outbox.send, clock), anew


def _failed(outbox: Outbox, text: str, status: int) -> int:
    """Say why it is over."""
    outbox.send(Failed(text))
    outbox.flush()
    return status
