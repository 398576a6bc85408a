"""Marks sessions like submissions: repeated exactly, judged by a task, reported on."""

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import msgspec

from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.controllers.models import FIRST, MODELS
from vrts.controllers.values import digest
from vrts.live.logs.logged_sessions import LoggedSession
from vrts.live.session.again.replay import Differs, replay_whole
from vrts.live.session.channel.entries import Entry
from vrts.live.session.setting import as_written
from vrts.live.session.views.program import as_program
from vrts.marking.proposer.by_name import ALONE, By
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker, Marks
from vrts.marking.submission.one import Marked, NotMarkable, Order, Wanted, mark
from vrts.marking.submission.session_run import session_run
from vrts.marking.submission.setting import Place
from vrts.pipeline.controllers import under
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.audience import as_allowed

ANOTHER = "mark it with the scene and the task that it had"
SHOWN = "session.v2"  # what was done, as a program


class Logged(msgspec.Struct, frozen=True):
    """What is marked of a session."""

    controller: str  # model that it went by
    controller_sha256: str  # of what that model said; empty: not known
    entries: tuple[Entry, ...]


_logged = msgspec.json.Decoder(Logged | tuple[Entry, ...])  # of the first model, entries alone


class SessionMarker(Marker):
    """Marks sessions by one task. What is marked is the JSON of a session's entries."""

    def __init__(self, place: Place, wanted: Wanted) -> None:
        """Read the task; hidden scenes are left out: nobody has seen them to act in them.

        Raises:
            CannotRead: A file is not there.
            Refused: Task, scene or scenario have errors.
        """
        super().__init__(place, wanted)
        if self.whole.variants:
            hidden = self.whole.hidden - len(self.whole.variants)
            self.whole = replace(self.whole, variants=(), hidden=hidden)
            self.public = replace(self.public, more=hidden) if hidden else self.whole
        task = self.whole.task
        self.has_variants = task is not None and task.variants is not None  # rooms had none
        same = self.public is self.whole
        self.whole = as_written(self.whole)
        self.public = self.whole if same else as_written(self.public)

    def command(self, order: Order, folder: Path) -> tuple[list[str], bytes]:
        """Return the same as a command, for systems where nothing is forked."""
        _, told = super().command(order, folder)
        return [sys.executable, "-m", "vrts.live.logs.session_alone"], told

    def warm_up(self) -> None:
        """Load what all sessions share, by marking one in which nothing was done."""
        order = Order("warm-up", "warm-up", entries_to_bytes(()))
        self._mark(order, self.public, self.wanted, ALONE)

    def _work(self, order: Order, folder: Path, wanted: Wanted) -> Marks:
        try:
            return super()._work(order, folder, wanted)
        except NotMarkable as problem:
            name, data = order.identifier, order.data
            return self.unmarked(Kind.AMBIGUOUS, name, str(problem), ANOTHER, data)

    def _mark(self, order: Order, setting: Setting, wanted: Wanted, by: By) -> Marked:
        return mark(order, setting, wanted, by, assessed)


def entries_to_bytes(entries: Sequence[Entry]) -> bytes:
    """Return what is marked of a session from before there were controller models."""
    return msgspec.json.encode(entries)


def session_to_bytes(session: LoggedSession) -> bytes:
    """Return what is marked of a session."""
    model = (session.controller, session.controller_sha256)
    return msgspec.json.encode(Logged(*model, session.entries))


def assessed(order: Order, setting: Setting, wanted: Wanted, by: By) -> Assessment:
    """Repeat a session, check it and mark it; without hints where the task allows none.

    Raises:
        NotMarkable: It comes out as another one.
    """
    read = _logged.decode(order.data)
    logged = read if isinstance(read, Logged) else Logged(FIRST.name, "", read)
    setting = _of_then(setting, logged)
    scene, task = setting.scene, setting.task
    assert task is not None
    try:
        whole = replay_whole(setting, logged.entries, task.t_max)
    except Differs as problem:
        raise NotMarkable(f"the session cannot be repeated: {problem}") from problem
    run = session_run(whole, task.t_max)
    report = None
    if wanted.collisions:
        report = check_collisions(
            scene, run, proposer=by.proposer, second=by.second, near_miss=task.near_miss
        )
    judgement = judge(scene, run, task, collisions=False, proposer=by.proposer, report=report)
    found = Assessment(
        order.identifier,
        order.title,
        SourceFile(SHOWN, as_program(run, "session")),
        setting.stamps,
        scene=scene,
        task=task,
        module=run.module,
        run=run,
        judgement=judgement,
        grade=grade(task, run, judgement),
    )
    return as_allowed(found, setting.stamps)


def _of_then(setting: Setting, logged: Logged) -> Setting:
    """Return the setting under the controller model that a session went by.

    Raises:
        NotMarkable: There is no such model, or it says something else now.
    """
    own = setting.scene.controller.name
    if logged.controller not in (own, *MODELS):
        what = f"there is no controller model `{logged.controller}`"
        raise NotMarkable(f"the session cannot be repeated: {what}")
    found = under(setting, logged.controller)
    if logged.controller_sha256 not in ("", digest(found.scene.controller)):
        what = f"the controller model `{logged.controller}` says something else now"
        raise NotMarkable(f"the session cannot be repeated: {what}")
    return found
