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
from vrts.live.session.again.replay import Differs, replay_whole
from vrts.live.session.channel.entries import Entry
from vrts.live.session.views.program import as_program
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker, Marks
from vrts.marking.submission.one import Marked, NotMarkable, Order, Wanted, mark
from vrts.marking.submission.session_run import session_run
from vrts.marking.submission.setting import Place
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment

ANOTHER = "mark it with the scene and the task that it had"
SHOWN = "session.v2"  # what was done, as a program

_entries = msgspec.json.Decoder(tuple[Entry, ...])


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

    def command(self, order: Order, folder: Path) -> tuple[list[str], bytes]:
        """Return the same as a command, for systems where nothing is forked."""
        _, told = super().command(order, folder)
        return [sys.executable, "-m", "vrts.live.logs.session_alone"], told

    def warm_up(self) -> None:
        """Load what all sessions share, by marking one in which nothing was done."""
        self._mark(Order("warm-up", "warm-up", entries_to_bytes(())), self.public, self.wanted)

    def _work(self, order: Order, folder: Path, wanted: Wanted) -> Marks:
        try:
            return super()._work(order, folder, wanted)
        except NotMarkable as problem:
            name, data = order.identifier, order.data
            return self.unmarked(Kind.AMBIGUOUS, name, str(problem), ANOTHER, data)

    def _mark(self, order: Order, setting: Setting, wanted: Wanted) -> Marked:
        return mark(order, setting, wanted, assessed)


def entries_to_bytes(entries: Sequence[Entry]) -> bytes:
    """Return what is marked of a session."""
    return msgspec.json.encode(entries)


def assessed(order: Order, setting: Setting, wanted: Wanted) -> Assessment:
    """Repeat a session, check it and mark it.

    Raises:
        NotMarkable: It comes out as another one.
    """
    scene, task = setting.scene, setting.task
    assert task is not None
    try:
        whole = replay_whole(setting, _entries.decode(order.data), task.t_max)
    except Differs as problem:
        raise NotMarkable(f"the session cannot be repeated: {problem}") from problem
    run = session_run(whole, task.t_max)
    report = None
    if wanted.collisions:
        report = check_collisions(scene, run, engine=wanted.engine, near_miss=task.near_miss)
    judgement = judge(scene, run, task, collisions=False, engine=wanted.engine, report=report)
    return Assessment(
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
