"""A task with `[variants]`, and each of its variants as an ordinary task.

    varied = load_varied(Path("lab1"))
    one = varied.drawn(key, "moodle 4711")
    setting = varied.setting(one.combination)            # task and scene, with the hidden part
    program = varied.reference(one.combination)          # the solution, with this variant's places

All variants: `varied.variants.combination(n)` for n below `varied.variants.total`; those for which
`varied.variants.allowed` says no are given to nobody. Nothing here is random, and nothing is
written but a folder of our own that vanishes.
"""

import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from vrts.assignments.pack import Bundle, read_zip
from vrts.assignments.packed import is_packed, setting_of
from vrts.assignments.task_folder import SOLUTION, TaskFiles, read_folder, reference_of
from vrts.assignments.variants.places import with_places
from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile
from vrts.check.task.manifest import Manifest, sha256
from vrts.check.variants.drawn import Variant, drawn
from vrts.check.variants.files import (
    SCENARIO,
    SCENE,
    STAFF,
    TASK,
    cut,
    name_findings,
    path_findings,
    varied,
    without_names,
)
from vrts.check.variants.model import Combination, Variants
from vrts.check.variants.section import SECTION, VALUES
from vrts.pipeline.files import (
    SCENARIO_FILE,
    TASK_FILE,
    CannotRead,
    member_bytes,
    read_bytes,
    shown,
)
from vrts.pipeline.files import STAFF as STAFF_FOLDER
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.report.plain import one_line
from vrts.scene.handling.withheld import all_locations

START = "start.v2"
SCENES_STAY = Rule("V920", "hidden-scenes-cannot-vary")


@dataclass(frozen=True, slots=True)
class VariedTask:
    """A task with `[variants]`."""

    files: TaskFiles  # as written
    variants: Variants
    base: Setting  # as written, with the hidden part
    solution: bytes | None  # the reference as written; None: there is none
    sources: Mapping[str, SourceFile]  # texts of the files, by the word that paths begin with
    names: Mapping[str, str]  # of these files, by the same word

    def with_key(self, key: bytes) -> "VariedTask":
        """Return the same, whose tags are those that are handed out by a key."""
        return replace(self, variants=replace(self.variants, key=key))

    def drawn(self, key: bytes, student: str) -> Variant:
        """Return the variant that a key gives to a student, as `vrts.check.variants.drawn`.

        Raises:
            Refused: Hardly any combination is left for students.
        """
        try:
            return drawn(self.variants, key, student)
        except ValueError as problem:
            headline = f"{problem}: `[[{SECTION}.without]]` leaves too few for a draw"
            raise Refused((error(VALUES, headline, Label(self.variants.span)),)) from problem

    def texts(self, combination: Combination) -> dict[str, bytes]:
        """Return the files that are others in a variant, by name; without `[variants]`."""
        found = varied(self.variants, combination, self.sources)
        return {self.names[word]: text.encode() for word, text in found.items()}

    def of(self, combination: Combination) -> TaskFiles:
        """Return the files of the task in a variant, with the hidden part, for staff."""
        texts = self.texts(combination)
        public = {name: texts.get(name, data) for name, data in self.files.public.items()}
        staff = {name: texts.get(name, data) for name, data in self.files.staff.items()}
        return self.files._replace(public=public, staff=staff)

    def setting(self, combination: Combination, *, staff: bool = True) -> Setting:
        """Return the setting of a variant, with or without the hidden part.

        Raises:
            Refused: The variant is no sound task; a note says which variant.
        """
        files = self.of(combination)
        members = {**files.public, **files.staff} if staff else files.public
        hashes = {name: sha256(data) for name, data in members.items()}
        hidden = 0 if staff else self.base.hidden
        manifest = Manifest(files.name, staff, hidden, (), files.scene, files.lab, hashes)
        try:
            return setting_of(Bundle(manifest, members, ()), staff=staff)
        except Refused as refused:
            values = self.variants.values(combination).items()
            note = f"in the variant {one_line(', '.join(f'{k} = {v}' for k, v in values))}"
            raise Refused(tuple(_noted(d, note) for d in refused.diagnostics)) from refused

    def reference(self, combination: Combination, setting: Setting | None = None) -> bytes | None:
        """Return the reference solution with the locations of a variant; None: there is none.

        A value that is not the scene's own as the task is written stays as it is.

        Args:
            combination: The variant.
            setting: Of it, where it is known already.
        """
        if self.solution is None:
            return None
        there = setting or self.setting(combination)
        before, now = all_locations(self.base.scene), all_locations(there.scene)
        return with_places(self.solution, before, now)

    def start(self, setting: Setting) -> bytes | None:
        """Return `start.v2` with the places of a variant that students are given; None: none."""
        data = self.files.public.get(START)
        if data is None:
            return None
        before, now = self.base.scene.locations, setting.scene.locations
        return with_places(data, before, now, self.variants.staff_names)

    def for_students(self, combination: Combination) -> dict[str, bytes]:
        """Return the public files of a variant; names for staff are not in the scene's file."""
        return self._without_names(self.of(combination).public)

    def as_written(self) -> dict[str, bytes]:
        """Return the public files of the task as it is written, without what is for staff."""
        text = cut(self.sources[TASK]).encode()
        found = self._without_names({**self.files.public, self.names[TASK]: text})
        start = self.start(self.base)
        self.check_readable(found)
        return found if start is None else {**found, START: start}

    def meanings(self) -> dict[str, str]:
        """Return digests of what students are told, by file: comments and layout do not count."""
        found = {TASK: cut(self.sources[TASK])}
        found |= {word: self.sources[word].text for word in (SCENE, SCENARIO) if word in self.names}
        return {self.names[word]: _meaning(text) for word, text in found.items()}

    def check_readable(self, files: Mapping[str, bytes]) -> None:
        """Check that what students are handed out can be read.

        Raises:
            Refused: It cannot: something that students have needs what they do not get.
        """
        hashes = {name: sha256(data) for name, data in files.items()}
        manifest = Manifest(
            self.files.name, False, self.base.hidden, (), self.files.scene, self.files.lab, hashes
        )
        try:
            setting_of(Bundle(manifest, files, ()), staff=False)
        except Refused as refused:
            note = "so it is in the zips of students, in which `staff_names` are left out"
            raise Refused(tuple(_noted(d, note) for d in refused.diagnostics)) from refused

    def _without_names(self, files: dict[str, bytes]) -> dict[str, bytes]:
        names = self.variants.staff_names
        if names:
            scene = self.names[SCENE]
            files[scene] = without_names(SourceFile(scene, files[scene].decode()), names).encode()
        return files


def load_varied(path: Path) -> VariedTask:
    """Return a task with its variants.

    Args:
        path: `task.toml`, its folder, or a zip of `vrts task pack` for staff.

    Raises:
        CannotRead: It is not there, or has no variants.
        Refused: Task, scene or `[variants]` have errors.
    """
    if is_packed(path):
        bundle = read_zip(read_bytes(path))
        files = _unpacked(bundle)
        base = setting_of(bundle)
        solution = files.staff.get(f"{STAFF_FOLDER}/{SOLUTION}")
        home = path
    else:
        home = path if path.is_dir() else path.parent
        files = read_folder(home)
        base = load_task(home, staff=True)
        reference = reference_of(home)
        solution = None if reference is None else member_bytes(reference)
    assert base.task is not None
    variants = base.task.variants
    if variants is None:
        hint = "add `[variants]` to its `task.toml`: `vrts manual variants` tells how"
        raise CannotRead(f"the task `{path}` has no variants", (hint,))
    if base.variants:
        raise _not_varied(variants)
    names = {TASK: TASK_FILE, SCENE: files.scene}
    every = {**files.public, **files.staff}
    for word, name in ((SCENARIO, SCENARIO_FILE), (STAFF, f"{STAFF_FOLDER}/{TASK_FILE}")):
        if name in every:
            names[word] = name
    sources = {
        word: SourceFile(shown(home / name), _text(every[name])) for word, name in names.items()
    }
    found = (*path_findings(variants, sources), *name_findings(variants, all_locations(base.scene)))
    if found:
        raise Refused(found)
    return VariedTask(files, variants, base, solution, sources, names)


def _not_varied(variants: Variants) -> Refused:
    """Return the refusal of hidden scenes: the places of a variant cannot be put into them."""
    folder = f"{STAFF_FOLDER}/scenes"
    headline = f"scenes in `{folder}` cannot vary, and the task has `[variants]`"
    note = "in them each would be marked with places that are not those of the own variant"
    remedies = (
        f"hide what is checked in `{STAFF_FOLDER}/{TASK_FILE}`: it is marked in each own variant",
        f"or take the scenes out of `{folder}`",
    )
    found = error(SCENES_STAY, headline, Label(variants.span), notes=(note,), help=remedies)
    return Refused((found,))


def _text(data: bytes) -> str:
    return data.decode("utf-8-sig").replace("\r\n", "\n")


def _unpacked(bundle: Bundle) -> TaskFiles:
    """Return the files of a packed task, those of staff apart."""
    manifest = bundle.manifest
    inside = f"{STAFF_FOLDER}/"
    public = {name: d for name, d in bundle.files.items() if not name.startswith(inside)}
    staff = {name: d for name, d in bundle.files.items() if name.startswith(inside)}
    return TaskFiles(manifest.name, manifest.scene, public, staff, manifest.lab)


def _meaning(text: str) -> str:
    said = json.dumps(tomllib.loads(text), sort_keys=True, default=str)
    return sha256(said.encode())


def _noted(d: Diagnostic, note: str) -> Diagnostic:
    return replace(d, notes=(*d.notes, note))
