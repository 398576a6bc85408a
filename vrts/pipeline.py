"""The stages for one request, composed, each at most once; and the files they need.

Reads programs, scenes, tasks and scenarios; writes nothing. What is wrong in a file is a
diagnostic; a file that is not there is a wrong call and raises `CannotRead`.
"""

import hashlib
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.source import SourceFile

if TYPE_CHECKING:
    from vrts.check.task import Task
    from vrts.ir.module import Module
    from vrts.lang.compiler import Compilation
    from vrts.report.assessment import Assessment
    from vrts.scene.model import Scenario, Scene
    from vrts.scene.scenario_file import ScenarioFile

NO_SUCH_PROGRAM = Rule("V190", "no-such-program")

PACKAGE = Path(__file__).parent
LIBRARY = PACKAGE / "library"  # scenes and examples in an installed package
CHECKOUT = PACKAGE.parent  # the same in a checkout

SCENE_FILE = "scene.toml"
TASK_FILE = "task.toml"
STAFF = "staff"  # folder beside a task: what students do not get
MANIFEST_FILE = "manifest.json"  # of a packed task, also after unpacking
SCENARIO_FILE = "scenario.toml"  # beside a task: how its runs begin, and what happens in them
MAX_TOML = 1_000_000  # bytes
CURVE_STEP = 0.1  # [s] between samples of the clearance, for charts
CURVE_MOST = 600  # samples

Value = TypeVar("Value")


class CannotRead(Exception):  # noqa: N818 -- names the situation
    """A file that a request names cannot be read."""

    def __init__(self, message: str, hints: tuple[str, ...] = ()) -> None:
        """Say which and why; `hints` tell what there is instead."""
        super().__init__(message)
        self.message = message
        self.hints = hints


class Refused(Exception):  # noqa: N818 -- names the situation
    """A scene or task file has errors; the diagnostics say which."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        """Keep everything that was found."""
        super().__init__("errors in a scene or task file")
        self.diagnostics = diagnostics


@dataclass(frozen=True, slots=True)
class Setting:
    """A scene, and the task and scenario set in it if there are, read and found right.

    Where a task has a scenario, the digest of the task covers both: marks are valid for this
    scenario only, as they are for this scene only.
    """

    scene: "Scene"
    task: "Task | None"
    diagnostics: tuple[Diagnostic, ...]  # warnings
    scenario: "ScenarioFile | None" = None
    scene_source: SourceFile | None = None  # None: a robot alone
    stamps: tuple[Diagnostic, ...] = ()  # why marks do not count; part of every assessment
    hidden: int = 0  # checks that are in `task` for marking only
    more: int = 0  # checks that are not in `task` but will be at marking
    variants: tuple["Setting", ...] = ()  # the task in hidden scenes; the lowest mark counts


# --- files ----------------------------------------------------------------------------------------


def library_folders() -> tuple[Path, ...]:
    """Return the folders that hold `scenes` and `examples`, the checkout's first."""
    return tuple(folder for folder in (CHECKOUT, LIBRARY) if (folder / "scenes").is_dir())


def scene_names() -> tuple[str, ...]:
    """Return the names of the scenes that come with vrts."""
    return tuple(
        sorted(
            {
                path.parent.name
                for folder in library_folders()
                for path in (folder / "scenes").glob(f"*/{SCENE_FILE}")
            }
        )
    )


def find_scene(name: str, beside: Path | None = None) -> Path:
    """Return the file of a scene: a path, beside a given file, or a name of the library.

    Raises:
        CannotRead: There is no such scene.
    """
    folders = [folder for folder in (beside, Path.cwd()) if folder is not None]
    for folder in folders:
        for candidate in (folder / name, folder / name / SCENE_FILE):
            if candidate.is_file():
                return candidate
    for folder in library_folders():
        candidate = folder / "scenes" / name / SCENE_FILE
        if re.fullmatch(r"[\w.-]+", name) and candidate.is_file():
            return candidate
    raise CannotRead(f"there is no scene `{name}`", (f"scenes: {', '.join(scene_names())}",))


def find_example(name: str) -> Path | None:
    """Return the folder of an example: a path, or a name of the library."""
    if Path(name).is_dir():
        return Path(name)
    for folder in library_folders():
        candidate = folder / "examples" / name
        if re.fullmatch(r"[\w.-]+", name) and candidate.is_dir():
            return candidate
    return None


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file.

    Raises:
        CannotRead: It is not there, is a folder, or may not be read.
    """
    try:
        return path.read_bytes()
    except OSError as problem:
        reason = (problem.strerror or "unreadable").lower()
        raise CannotRead(f"cannot read `{path}`: {reason}") from problem


def read_toml_source(path: Path, home: Path | None = None) -> SourceFile:
    """Return the text of a TOML file.

    Args:
        path: Of the file.
        home: Folder from which names are shown; None: the working folder.

    Raises:
        CannotRead: It is not there, is too large, or is not UTF-8.
    """
    data = read_bytes(path)
    if len(data) > MAX_TOML:
        raise CannotRead(f"`{path}` is too large: {len(data):,} bytes")
    try:
        return SourceFile(shown(path, home), data.decode("utf-8-sig").replace("\r\n", "\n"))
    except UnicodeDecodeError as problem:
        raise CannotRead(f"`{path}` is not UTF-8 text") from problem


def shown(path: Path, home: Path | None = None) -> str:
    """Return a path as diagnostics show it: relative to the working folder where it is inside."""
    try:
        return str(path.resolve().relative_to(Path.cwd() if home is None else home.resolve()))
    except ValueError:
        return str(path)


# --- settings -------------------------------------------------------------------------------------


def robot_alone() -> Setting:
    """Return the scene of a robot by itself."""
    from vrts.scene.default import robot_alone as alone

    return Setting(alone(), None, ())


def load_scene(name: str, beside: Path | None = None, home: Path | None = None) -> Setting:
    """Return a scene without a task; `home` as for `read_toml_source`.

    Raises:
        CannotRead: There is no such scene.
        Refused: Its file has errors.
    """
    from vrts.scene.scene_file import read_scene

    path = find_scene(name, beside)
    source = read_toml_source(path, home)
    scene, found = read_scene(source, path.parent)
    return Setting(_accepted(scene, found), None, found, scene_source=source)


def load_task(
    path: Path,
    scene: str | None = None,
    scenario: Path | None = None,
    *,
    staff: bool = False,
    home: Path | None = None,
) -> Setting:
    """Return a task in its scene, or in another one, which is stamped: its marks do not count.

    The scenario is the one given, else `scenario.toml` beside the task if there is one.

    Args:
        path: `task.toml`, or its folder.
        scene: Name or path of another scene than the task's.
        scenario: A scenario file.
        staff: Whether to add the hidden parts in `staff/task.toml` and `staff/scenes`.
        home: As for `read_toml_source`.

    Raises:
        CannotRead: The task, its scene or the scenario is not there.
        Refused: One of the files has errors.
    """
    from vrts.check.manifest import altered, announced, other_scene
    from vrts.check.staff import read_whole_task
    from vrts.check.task_file import read_task, scene_name

    folder = path if path.is_dir() else path.parent
    source = read_toml_source(folder / TASK_FILE if path.is_dir() else path, home)
    named, found = scene_name(source)
    setting = load_scene(scene or _accepted(named, found), folder, home)
    stamps: tuple[Diagnostic, ...] = ()
    more = 0
    if (folder / MANIFEST_FILE).is_file():
        packed = _packed_files(folder)
        stamps, more = altered(packed), announced(packed[MANIFEST_FILE])
    if scene is not None and named is not None and scene != named:
        stamps += other_scene(load_scene(named, folder, home).scene, setting.scene)
    hidden = 0
    if staff and (folder / STAFF / TASK_FILE).is_file():
        staff_source = read_toml_source(folder / STAFF / TASK_FILE, home)
        task, counts, found = read_whole_task(source, staff_source, setting.scene)
        hidden = sum(counts.values())
    else:
        task, found = read_task(source, setting.scene)
    setting = replace(
        setting,
        task=_accepted(task, found),
        diagnostics=(*setting.diagnostics, *found),
        stamps=stamps,
        hidden=hidden,
        more=0 if hidden else more,
    )
    if scenario is None and (folder / SCENARIO_FILE).is_file():
        scenario = folder / SCENARIO_FILE
    if scenario is not None:
        setting = with_scenario(setting, scenario, home)
    return _with_variants(setting, path, scenario, home) if staff and scene is None else setting


def _with_variants(
    setting: Setting, path: Path, scenario: Path | None, home: Path | None
) -> Setting:
    """Add the task in every scene of `staff/scenes`; each counts as one hidden check."""
    from vrts.check.manifest import hidden_scene

    folder = path if path.is_dir() else path.parent
    variants = [
        load_task(path, str(place.resolve()), scenario, staff=True, home=home)
        for place in sorted((folder / STAFF / "scenes").glob("*.toml"))
    ]
    told = tuple(replace(variant, stamps=hidden_scene(variant.scene)) for variant in variants)
    return replace(
        setting,
        variants=told,
        hidden=setting.hidden + len(told),
        more=0 if told else setting.more,
    )


def _packed_files(folder: Path) -> dict[str, bytes]:
    """Return the files that the manifest of an unpacked task names, as far as they are there."""
    from vrts.check.manifest import listed

    manifest = read_bytes(folder / MANIFEST_FILE)[: MAX_TOML + 1]
    found = {MANIFEST_FILE: manifest}
    for name in listed(manifest):
        place = folder / name
        if place.resolve().is_relative_to(folder.resolve()) and place.is_file():
            found[name] = read_bytes(place)
    return found


def with_scenario(setting: Setting, path: Path, home: Path | None = None) -> Setting:
    """Return a setting in which runs go as a scenario file says; `home` as for `load_task`.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    from vrts.ir.system import PARAMETERS
    from vrts.scene.scenario_file import read_scenario

    numbers = PARAMETERS.keys() - {"NEST.POS"}  # which is six of them
    scenario, found = read_scenario(read_toml_source(path, home), setting.scene, sorted(numbers))
    accepted = _accepted(scenario, found)
    task = setting.task
    if task is not None:
        both = hashlib.sha256(f"{task.digest} {accepted.digest}".encode()).hexdigest()
        task = replace(task, digest=both)
    return replace(
        setting, task=task, diagnostics=(*setting.diagnostics, *found), scenario=accepted
    )


def setting_for(
    program: Path | None,
    *,
    scene: str | None = None,
    task: Path | None = None,
    scenario: Path | None = None,
) -> Setting | None:
    """Return the setting that a program is verified in; None when nothing tells which.

    The task is the one given, else `task.toml` beside the program, unless a scene is asked for.
    The scenario is the one given, else the task's.
    """
    if task is not None:
        return load_task(task, scene, scenario)
    beside = program.parent if program is not None else None
    if scene is not None:
        setting = load_scene(scene, beside)
        return setting if scenario is None else with_scenario(setting, scenario)
    if beside is None:
        return None
    for folder in (beside, beside.parent if beside.name == "submissions" else beside):
        if (folder / TASK_FILE).is_file():
            return load_task(folder / TASK_FILE, scenario=scenario)
    return None


def _accepted(value: Value | None, found: tuple[Diagnostic, ...]) -> Value:
    if value is None:
        raise Refused(found)
    return value


class Compiled(NamedTuple):
    """A program as far as it could be read and compiled."""

    source: SourceFile | None  # None for what is no text
    compilation: "Compilation | None"
    diagnostics: tuple[Diagnostic, ...]


# --- programs -------------------------------------------------------------------------------------


class ProgramFile(NamedTuple):
    """The bytes of a program, and its name as shown."""

    data: bytes
    name: str


class Reading(NamedTuple):
    """How programs are read."""

    dialect: str | None = "val2"  # None: as file name and content tell
    precedence: str | None = None  # "A" or "B"; None: as the dialect has it
    replace: bool = False  # a program that comes again takes the place of the first
    others: tuple[ProgramFile, ...] = ()  # compiled together with the program


STRICT = Reading()


def compile_bytes(data: bytes, name: str, reading: Reading = STRICT) -> "Compiled":
    """Return source, compilation and diagnostics; the first two are None for what is no text."""
    from vrts.lang.compiler import Options, compile_sources
    from vrts.lang.dialect import DIALECTS, Precedence
    from vrts.lang.reading import decode

    found = [decode(file.data, file.name) for file in (ProgramFile(data, name), *reading.others)]
    unread = tuple(source for source in found if isinstance(source, Diagnostic))
    sources = [source for source in found if isinstance(source, SourceFile)]
    if isinstance(found[0], Diagnostic):
        return Compiled(None, None, unread)
    options = Options(
        None if reading.dialect is None else DIALECTS[reading.dialect],
        None if reading.precedence is None else Precedence(reading.precedence),
        reading.replace,
    )
    compilation = compile_sources(sources, options)
    if unread:
        compilation = replace(compilation, module=None)
    return Compiled(found[0], compilation, (*unread, *compilation.diagnostics))


def store(compilation: "Compilation", *, exact: bool = False) -> str:
    """Return what STORE writes for a compilation that succeeded."""
    from vrts.lang.store import store_text

    module, source = compilation.module, compilation.source
    assert module is not None
    assert source is not None
    return store_text(source, module, compilation.dialect, exact=exact)


class Formatted(NamedTuple):
    """A program in canonical layout."""

    before: str
    after: str
    data: bytes  # of the file as it should be
    changed: bool  # whether that is another than it is
    diagnostic: Diagnostic | None = None  # why the file cannot be read


def format_bytes(data: bytes, name: str, dialect: str | None) -> Formatted:
    """Return the canonical layout of a program, with LF line ends."""
    from vrts.lang.detection import detect
    from vrts.lang.dialect import DIALECTS
    from vrts.lang.layout import layout
    from vrts.lang.reading import decode

    source = decode(data, name)
    if isinstance(source, Diagnostic):
        return Formatted("", "", data, False, source)
    chosen = DIALECTS[dialect] if dialect is not None else detect(source)[0]
    after = layout(source, chosen)
    if not after.endswith("\n"):
        after += "\n"
    encoded = _encoded_like(after, data)
    return Formatted(source.text, after, encoded, encoded != data)


def _encoded_like(text: str, data: bytes) -> bytes:
    """Return text as UTF-8, or in the 8-bit code page of a file that is no UTF-8."""
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        try:
            return text.encode("cp1252")
        except UnicodeEncodeError:
            return text.encode()
    return text.encode()


def assess(
    program: Path | bytes,
    *,
    scene: str | None = None,
    task: Path | None = None,
    setting: Setting | None = None,
    identifier: str | None = None,
    title: str | None = None,
    collisions: bool = True,
    engine: str | None = None,
    judged: bool = True,
    entry: str | None = None,
    curve: bool = False,
    reading: Reading = STRICT,
    step_done: Callable[[str], None] = lambda _: None,
) -> "Assessment":
    """Compile, run, check and mark one program.

    Args:
        program: Its file, or its bytes.
        scene: Name or path of the scene; None: the task's.
        task: The task file; None: the one beside the program, or none.
        setting: Scene and task already read, in place of the two above.
        identifier: Safe for file names; None: the stem of the file.
        title: As shown; None: the name of the file.
        collisions: Whether to check them.
        engine: Name of what measures distances; None: the most exact there is.
        judged: Whether to check and mark at all.
        entry: Program to execute; None: the task's, else the first.
        curve: Whether to sample the clearance over time, for charts.
        reading: Dialect, and files compiled together with the program.
        step_done: Told the name of every stage that is done.

    Raises:
        CannotRead: A file is not there, or nothing says which scene to take.
        Refused: Scene or task have errors.
    """
    from vrts.report.assessment import Assessment

    path = program if isinstance(program, Path) else None
    data = read_bytes(program) if isinstance(program, Path) else program
    if setting is None:
        setting = setting_for(path, scene=scene, task=task)
    if setting is None:
        raise CannotRead(
            "nothing says in which scene to verify the program",
            (
                "give `--scene NAME`, or put a `task.toml` beside it",
                f"scenes: {', '.join(scene_names())}",
            ),
        )
    name = title or (shown(path) if path is not None else "program")
    source, compilation, diagnostics = compile_bytes(data, name, reading)
    step_done("compile")
    start = Assessment(
        identifier or (path.stem if path is not None else "program"),
        name if title or path is None else path.name,
        source,
        (*setting.stamps, *diagnostics),
        scene=setting.scene,
        task=setting.task,
    )
    if compilation is None or compilation.module is None or compilation.module.main is None:
        return _ungraded(start)
    start = replace(start, module=compilation.module)
    found = _run(
        start,
        scenario_for(setting.task, setting.scenario),
        judged=judged,
        collisions=collisions,
        engine=engine,
        entry=entry,
        step_done=step_done,
    )
    return with_curve(found) if curve and judged and collisions else found


def _run(
    a: "Assessment",
    scenario: "Scenario",
    *,
    judged: bool,
    collisions: bool,
    engine: str | None,
    entry: str | None,
    step_done: Callable[[str], None],
) -> "Assessment":
    from vrts.engine.controller import execute

    assert a.module is not None
    assert a.scene is not None
    name = entry or (a.task.program if a.task else None)
    if name is not None and name.lower() not in a.module.programs:
        missing = no_program(a.module, name)
        return _ungraded(replace(a, diagnostics=(*a.diagnostics, missing)))
    run = execute(a.module, a.scene, scenario, name.lower() if name else None)
    step_done("simulate")
    scene, task = a.scene, a.task
    a = replace(a, run=run, diagnostics=without_repeats(a.diagnostics, run.findings))
    if not judged:
        return a
    from vrts.check.judge import judge

    judgement = judge(scene, run, task, collisions=collisions, engine=engine)
    step_done("check")
    a = replace(a, judgement=judgement)
    if task is None:
        return a
    from vrts.check.mark import grade

    return replace(a, grade=grade(task, run, judgement))


def with_curve(a: "Assessment") -> "Assessment":
    """Return the assessment with the clearance of its run over time."""
    if a.run is None or a.scene is None or a.run.horizon_s <= 0.0:
        return a
    import numpy as np

    from vrts.check.clearance_curve import clearance_curve

    count = min(int(a.run.horizon_s / CURVE_STEP) + 2, CURVE_MOST)
    times = np.linspace(0.0, a.run.horizon_s, count)
    values = clearance_curve(a.scene, a.run, times)
    return replace(a, clearance=tuple(zip(times.tolist(), values.tolist(), strict=True)))


def scenario_for(task: "Task | None", planned: "ScenarioFile | None" = None) -> "Scenario":
    """Return the scenario of a run: where there is a task, it is stopped at its longest time."""
    from vrts.scene.model import Scenario

    scenario = Scenario() if planned is None else planned.scenario
    if task is None:
        return scenario
    limits = replace(scenario.limits, time_s=min(scenario.limits.time_s, task.t_max))
    return replace(scenario, limits=limits)


def _ungraded(a: "Assessment") -> "Assessment":
    from vrts.check.grade import Status
    from vrts.check.mark import ungraded

    if a.task is None:
        return a
    status = Status.UNREADABLE if a.source is None else Status.DOES_NOT_COMPILE
    return replace(a, grade=ungraded(status, a.diagnostics))


def no_program(module: "Module", name: str) -> Diagnostic:
    """Return what to say when a program to execute is not among those of a module."""
    return error(
        NO_SUCH_PROGRAM,
        f"there is no program `{name}` to execute",
        help=(f"programs in the file: {', '.join(module.programs)}",),
    )


def without_repeats(
    compiled: tuple[Diagnostic, ...], run: tuple[Diagnostic, ...]
) -> tuple[Diagnostic, ...]:
    """Drop warnings of the compiler about a name whose run-time error says the same."""
    named = {d.data["name"] for d in run if d.is_error and "name" in d.data}
    return tuple(d for d in compiled if d.is_error or d.data.get("name") not in named)
