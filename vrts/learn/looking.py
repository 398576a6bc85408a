"""What the files of a learner do, beside what a step asks for.

Whatever is executed goes through `pipeline.assess`, as `vrts verify` does it, with its limits.
Each program is executed once in each setting, however many steps look at it.
"""

import os
from collections.abc import Callable
from pathlib import Path

from vrts.assignments.packed import load_zip
from vrts.assignments.task_check import check_task
from vrts.assignments.task_folder import reference_of
from vrts.base.diagnostic import Diagnostic
from vrts.learn.at_log import look_at_log
from vrts.learn.at_program import look_at_program, mark_reached, not_there, said
from vrts.learn.lesson import (
    DONE,
    Answer,
    AssignmentWish,
    LogWish,
    MarkedWish,
    PackedWish,
    ProgramWish,
    Wish,
)
from vrts.marking.layout import Layout
from vrts.marking.result import Damaged
from vrts.marking.row import class_from_bytes
from vrts.pipeline.assess import assess
from vrts.pipeline.files import SCENE_FILE, TASK_FILE, CannotRead, named_place, read_bytes
from vrts.pipeline.refused import Refused
from vrts.pipeline.requesting import request_for
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import load_task
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.scene.checks import scene_findings

LARGEST_RESULTS = 50_000_000  # bytes


class Looking:
    """Looks at the files of one folder, and remembers what it has seen."""

    def __init__(self, folder: Path) -> None:
        """Take the folder of whoever learns; nothing is read yet."""
        self.folder = folder
        self._programs: dict[tuple[str, str | None], Assessment] = {}

    def at(self, wish: Wish) -> Answer:
        """Return whether the files do what a step asks for.

        What is wrong with a file is an answer, not an error.
        """
        try:
            return self._at(wish)
        except CannotRead as problem:
            return Answer(done=False, why=problem.message, hint=(problem.hints or ("",))[0])
        except Refused as problem:
            return _refused(problem.diagnostics)

    def _at(self, wish: Wish) -> Answer:
        match wish:
            case ProgramWish():
                path = self._inside(wish.file)
                self._scene_inside(wish.scene, wish.file)
                return look_at_program(wish, lambda: self._assessed(path, wish.scene), path)
            case AssignmentWish():
                return self._assignment(wish)
            case PackedWish():
                return self._packed(wish)
            case MarkedWish():
                return self._marked(wish)
            case LogWish():
                self._scene_inside(wish.scene, wish.program)
                return look_at_log(wish, self._inside)

    def _inside(self, name: str) -> Path:
        """Return the place of a file; a link leads to something in the folder.

        Raises:
            CannotRead: It leads out or nowhere, or no file can have such a name.
        """
        place = named_place(self.folder, name)
        really = Path(os.path.realpath(place))  # `resolve` fails at links in a circle
        if not really.is_relative_to(os.path.realpath(self.folder)):
            raise CannotRead(f"`{name}` leads out of the lesson's folder")
        if place.is_symlink() and not place.exists():
            raise CannotRead(f"`{name}` is a link that leads nowhere")
        return place

    def _scene_inside(self, name: str | None, program: str) -> None:
        """Look where a scene leads that lies in the folder, or beside a program in it.

        Raises:
            CannotRead: As for `_inside`.
        """
        if name is not None:
            for beside in (Path(), Path(program).parent):
                self._inside(str(beside / name))
                self._inside(str(beside / name / SCENE_FILE))

    def _assessed(self, path: Path, scene: str | None) -> Assessment:
        key = (str(path), scene)
        if key not in self._programs:
            self._programs[key] = assess(request_for(path, Where(scene=scene)))
        return self._programs[key]

    def _assignment(self, wish: AssignmentWish) -> Answer:
        folder = self._inside(wish.folder)
        if not folder.is_dir():
            return not_there(wish.folder, "folder")
        for name in (SCENE_FILE, TASK_FILE):
            self._inside(f"{wish.folder}/{name}")
        scene = load_scene(SCENE_FILE, folder)
        named = {body.name for body in scene.scene.bodies}
        missing = [name for name in wish.objects if name not in named]
        if missing:
            return Answer(done=False, why=f"the scene has no `{missing[0]}` yet")
        found = (*scene.diagnostics, *scene_findings(scene.scene))
        if found and not wish.task:
            return _refused(found)
        if not wish.task:
            return DONE
        if not (folder / TASK_FILE).is_file():
            return not_there(f"{wish.folder}/{TASK_FILE}")
        setting = load_task(folder, staff=True)
        if setting.hidden < wish.hidden:
            why = f"the task has {setting.hidden} hidden checks; this step wants {wish.hidden}"
            return Answer(done=False, why=why)
        checked = check_task(setting, reference_of(folder))
        if not checked.ready:
            return _refused(checked.findings)
        return DONE

    def _packed(self, wish: PackedWish) -> Answer:
        archive, program = self._inside(wish.file), self._inside(wish.program)
        for name, place in ((wish.file, archive), (wish.program, program)):
            if not place.is_file():
                return not_there(name)
        found = assess(request_for(program, setting=load_zip(archive, staff=False)))
        return mark_reached(found, wish.mark)

    def _marked(self, wish: MarkedWish) -> Answer:
        self._inside(wish.folder)
        results = self._inside(str(Layout(Path(wish.folder)).results))
        if not results.is_file():
            return not_there(wish.folder, "folder of marks")
        if results.stat().st_size > LARGEST_RESULTS:
            return Answer(done=False, why=f"`{results.name}` is too large")
        try:
            rows = class_from_bytes(read_bytes(results)).rows
        except Damaged:
            return Answer(done=False, why=f"`{wish.folder}` holds no marks that vrts wrote")
        if len(rows) < wish.rows:
            return Answer(done=False, why=f"{len(rows)} are marked; this step wants {wish.rows}")
        return DONE


Inside = Callable[[str], Path]


def _refused(found: tuple[Diagnostic, ...]) -> Answer:
    errors = [d for d in found if d.is_error] or list(found)
    return said(errors[0])
