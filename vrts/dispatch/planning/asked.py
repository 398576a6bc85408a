"""What a plan was asked for, as files of its bundle; and the same wish, made of them again.

Nothing is looked up that is not in the bundle: neither the library of scenes nor a profile by its
name. So a plan made again somewhere else is made of the same texts.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import NamedTuple, TypeVar

from vrts.base.source import SourceFile
from vrts.base.workers import ALONE, Workers
from vrts.check.task.task_file import read_task
from vrts.controllers.models import MODELS
from vrts.dispatch.bundle import Bundle, bad_bundle
from vrts.dispatch.manifest import Asked, Manifest
from vrts.dispatch.planning.reasons.futures import asked_of
from vrts.dispatch.planning.reasons.refusals import Promise
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile_file import read_profile
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.environments import environment_of, in_environment
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import with_scenario_text
from vrts.pipeline.setting import Setting, Sources, accepted
from vrts.prove.environment.environment import Environment
from vrts.run_files.proving import base_name
from vrts.scene.default import robot_alone
from vrts.scene.model import Scene, controlled
from vrts.scene.reading.scene_file import read_scene

Value = TypeVar("Value")

PROGRAM, SCENE, TASK, PROFILE = "given/program", "given/scene", "given/task", "given/profile"
ENVIRONMENT, TASK_ENVIRONMENT = "given/environment", "given/task-environment"
OTHER, SHAPE, SCENARIO = "given/other-{}", "given/shape-{}", "given/scenario-{}"
_ALONE = " alone"  # at the end of the name of a scene without a file


class Kept(NamedTuple):
    """A wish as a bundle keeps it."""

    asked: Asked
    files: Mapping[str, bytes]  # by their names in the bundle


def kept(wish: Wish) -> Kept:
    """Return a wish as a bundle keeps it: no folder of whoever made it is named."""
    request, setting = wish.request, wish.request.setting
    scene, task, reading = setting.scene, setting.task, request.reading
    texts: dict[str, SourceFile | None] = {
        SCENE: setting.scene_source,
        TASK: setting.sources.task,
        TASK_ENVIRONMENT: setting.sources.environment,
        ENVIRONMENT: wish.environment_source,
        PROFILE: SourceFile("profile", wish.profile.text),
    }
    texts |= _numbered(SCENARIO, (one.sources.scenario for one in wish.settings))
    files = {PROGRAM: request.program.data}
    files |= {name: source.text.encode() for name, source in texts.items() if source is not None}
    files |= _numbered(OTHER, (other.data for other in reading.others))
    files |= _numbered(SHAPE, scene.files.values())
    asked = Asked(
        program=base_name(request.program.name),
        others=tuple(base_name(other.name) for other in reading.others),
        dialect=reading.dialect,
        precedence="A" if reading.precedence == "A" else "B" if reading.precedence else None,
        replace=reading.replace,
        entry=request.entry,
        scene=scene.name.removesuffix(_ALONE) if setting.scene_source is None else scene.name,
        alone=setting.scene_source is None,
        shapes=tuple(scene.files),
        controller=scene.controller.name,
        task=None if task is None else task.name,
        proof=task is not None and task.proof is not None,
        task_environment=_named(setting.sources.environment),
        environment=_named(wish.environment_source),
        scenarios=tuple(_named(one.sources.scenario) for one in wish.settings),
        fails_first=wish.fails_first,
    )
    return Kept(asked, files)


def wish_of(bundle: Bundle, workers: Workers = ALONE) -> Wish:
    """Return the wish that a bundle was planned from.

    Raises:
        Refused: It does not say, a file is missing, or one has errors.
    """
    asked = bundle.manifest.asked
    if asked is None:
        raise bad_bundle("it does not say what it was planned from")
    read = _Reader(bundle, asked)
    first, *further = (read.setting(number) for number in range(1, len(asked.scenarios) + 1))
    others = tuple(
        ProgramFile(read.file(OTHER.format(number)), name)
        for number, name in enumerate(asked.others, 1)
    )
    reading = Reading(asked.dialect, asked.precedence, asked.replace, others)
    program = ProgramFile(read.file(PROGRAM), asked.program)
    request = Request(program, first, reading, asked.entry)
    given = read.environment(first)
    return Wish(
        request,
        read_profile(read.text(PROFILE, f"{bundle.manifest.profile}.toml")),
        bundle.manifest.clearance_asked_mm,
        _promises(bundle.manifest),
        tuple(further),
        asked_of(first) if given is None else given,
        asked.fails_first,
        workers,
        None if given is None else read.text(ENVIRONMENT, asked.environment),
    )


class _Reader:
    """The files of a bundle, as what they were when it was planned."""

    def __init__(self, bundle: Bundle, asked: Asked) -> None:
        if not asked.scenarios:
            raise bad_bundle("it does not say in which scenarios it was verified")
        self.bundle, self.asked = bundle, asked

    def file(self, name: str) -> bytes:
        """Return the bytes of a file."""
        found = self.bundle.given.get(name)
        if found is None:
            raise bad_bundle(f"`{name}` is missing")
        return found

    def text(self, name: str, shown: str | None) -> SourceFile:
        """Return the text of a file under the name that it had."""
        try:
            return SourceFile(shown or name, self.file(name).decode())
        except UnicodeDecodeError as problem:
            raise bad_bundle(f"`{name}` is no text") from problem

    def setting(self, number: int) -> Setting:
        """Return what it was verified in; number 1 is the first scenario."""
        setting, asked = self._scene(), self.asked
        if asked.task is not None:
            source = self.text(TASK, f"{asked.task}/task.toml")
            read, said = read_task(source, setting.scene)
            task = accepted(read, said)
            if not asked.proof:
                task = replace(task, proof=None)
            setting = replace(setting, task=task, sources=Sources(source))
            named = asked.task_environment
            setting = in_environment(
                setting, None if named is None else self.text(TASK_ENVIRONMENT, named)
            )
        scenario = asked.scenarios[number - 1]
        if scenario is None:
            return setting
        return with_scenario_text(setting, self.text(SCENARIO.format(number), scenario))

    def environment(self, first: Setting) -> Environment | None:
        """Return the environment that was given; None: nobody gave one."""
        if self.asked.environment is None:
            return None
        found, _ = environment_of(self.text(ENVIRONMENT, self.asked.environment), first)
        return found

    def _scene(self) -> Setting:
        asked = self.asked
        if asked.alone:
            try:
                return Setting(self._controlled(robot_alone(asked.scene)), None, ())
            except KeyError as missing:
                raise bad_bundle(f"there is no robot `{asked.scene[:60]}`") from missing
        source = self.text(SCENE, f"{asked.scene}.toml")
        files = {
            name: self.file(SHAPE.format(number)) for number, name in enumerate(asked.shapes, 1)
        }
        scene, said = read_scene(source, None, name=asked.scene, files=files)
        return Setting(self._controlled(accepted(scene, said)), None, said, scene_source=source)

    def _controlled(self, scene: Scene) -> Scene:
        """Return the scene under the model that the runs go by; it may be one of its own."""
        named, own = self.asked.controller, scene.controller
        model = own if own.name == named else MODELS.get(named)
        if model is None:
            raise bad_bundle(f"there is no controller model `{named[:60]}`")
        return controlled(scene, model)


def _numbered(form: str, values: Iterable[Value]) -> dict[str, Value]:
    return {form.format(number): value for number, value in enumerate(values, 1)}


def _named(source: SourceFile | None) -> str | None:
    return None if source is None else base_name(source.name)


def _promises(manifest: Manifest) -> tuple[Promise, ...]:
    return tuple(Promise(f"{w.code}-{w.finding}", w.reason, w.who) for w in manifest.waivers)
