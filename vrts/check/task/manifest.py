"""What a packed task says about itself: its files with their hashes, and which vrts may mark it.

The hashes tell an honest student that a file is not the one that marks are given for. They are no
seal: marks come from the staff's own files.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any, NamedTuple, cast

from vrts import __version__
from vrts.base.diagnostic import Diagnostic, Rule, Severity, warning
from vrts.scene.model import Scene

MODIFIED_SCENE = Rule("V671", "modified-scene")
MODIFIED_TASK = Rule("V672", "modified-task")
OTHER_VERSION = Rule("V673", "other-version")
HIDDEN_SCENE = Rule("V678", "hidden-scene")
OTHER_CONTROLLER = Rule("V679", "other-controller")

NAME = "manifest.json"
SCHEMA = "vrts.task/1"
MOST_FILES = 200
OF_TASK = ("task.toml", "scenario.toml")
HARMLESS = (".toml", ".md", ".v2", ".png", ".svg", ".jpg")  # no shapes of a scene are in these
NOT_COUNTING = "this mark does not count"
ANOTHER_VERSION = "this is vrts"  # begins what tells of another version
IN_HIDDEN_SCENE = "marked in the hidden scene"  # begins the one stamp with which marks count


class Manifest(NamedTuple):
    """What is packed."""

    name: str  # of the task
    staff: bool  # whether the hidden part is in it
    hidden: int  # how many checks come in addition at marking
    versions: tuple[str, ...]  # of vrts that may mark
    scene: str  # which of the files is the scene's
    lab: str  # which is that of the lab laid over it; "" without one
    files: Mapping[str, str]  # sha256 by name


def manifest_bytes(manifest: Manifest) -> bytes:
    """Return a manifest as JSON. The same content gives the same bytes."""
    fields = {
        "schema": SCHEMA,
        "name": manifest.name,
        "for": "staff" if manifest.staff else "students",
        "hidden_checks": manifest.hidden,
        "vrts": list(manifest.versions),
        "scene": manifest.scene,
        "lab": manifest.lab,
        "sha256": dict(sorted(manifest.files.items())),
    }
    return (json.dumps(fields, indent=2, ensure_ascii=True) + "\n").encode()


def read_manifest(data: bytes) -> Manifest | None:
    """Return the manifest that some bytes are; None for anything else."""
    try:
        value: Any = json.loads(data)
    except (ValueError, RecursionError):
        return None
    if not isinstance(value, dict):
        return None
    fields = cast("dict[str, Any]", value)
    name, hidden, scene = (fields.get(key) for key in ("name", "hidden_checks", "scene"))
    lab = fields.get("lab", "")
    versions, files = fields.get("vrts"), fields.get("sha256")
    if (
        fields.get("schema") != SCHEMA
        or not (isinstance(name, str) and isinstance(scene, str) and isinstance(lab, str))
        or type(hidden) is not int
        or not 0 <= hidden <= MOST_FILES
        or not isinstance(versions, list)
        or not isinstance(files, dict)
        or len(cast("dict[str, Any]", files)) > MOST_FILES
    ):
        return None
    texts = tuple(map(str, cast("list[Any]", versions)))
    hashes = {str(key): str(text) for key, text in cast("dict[str, Any]", files).items()}
    return Manifest(name, fields.get("for") == "staff", hidden, texts, scene, lab, hashes)


def listed(data: bytes) -> tuple[str, ...]:
    """Return the names of the files of a manifest; none for what is no manifest."""
    manifest = read_manifest(data)
    return () if manifest is None else tuple(manifest.files)


def announced(data: bytes) -> int:
    """Return how many hidden checks a manifest tells of; 0 for what is no manifest."""
    manifest = read_manifest(data)
    return 0 if manifest is None else manifest.hidden


def for_students(data: bytes) -> bool:
    """Return whether a manifest is of what students get; False for what is no manifest."""
    manifest = read_manifest(data)
    return manifest is not None and not manifest.staff


def sha256(data: bytes) -> str:
    """Return the hash of a file."""
    return hashlib.sha256(data).hexdigest()


def altered(files: Mapping[str, bytes]) -> tuple[Diagnostic, ...]:
    """Return why marks of a packed task do not count.

    Args:
        files: Bytes of the manifest and of every file there is, by name.
    """
    manifest = read_manifest(files[NAME])
    if manifest is None:
        headline = f"modified task: {NOT_COUNTING}"
        return (warning(MODIFIED_TASK, headline, notes=(f"`{NAME}` is not as vrts writes it",)),)
    changed = [
        name
        for name, digest in manifest.files.items()
        if name not in files or sha256(files[name]) != digest
    ]
    found: list[Diagnostic] = []
    parts = (
        (MODIFIED_SCENE, "scene", [name for name in changed if _of_scene(name, manifest)]),
        (MODIFIED_TASK, "task", [name for name in changed if name in OF_TASK]),
    )
    for rule, what, names in parts:
        if names:
            note = f"`{names[0]}` is not the file that was handed out"
            remedy = "unpack the task again for a mark that counts"
            headline = f"modified {what}: {NOT_COUNTING}"
            found.append(warning(rule, headline, notes=(note,), help=(remedy,)))
    return (*found, *unsuitable(manifest))


def _of_scene(name: str, manifest: Manifest) -> bool:
    return name in (manifest.scene, manifest.lab) or not name.endswith(HARMLESS)


def unsuitable(manifest: Manifest) -> tuple[Diagnostic, ...]:
    """Return a warning if this vrts is none of those that may mark a task."""
    if __version__ in manifest.versions:
        return ()
    headline = f"{ANOTHER_VERSION} {__version__}: {NOT_COUNTING}"
    remedy = f"install vrts {' or '.join(manifest.versions)} for a mark that counts"
    return (warning(OTHER_VERSION, headline, help=(remedy,)),)


def other_scene(own: Scene, taken: Scene) -> tuple[Diagnostic, ...]:
    """Return a warning if a scene is not that of a task."""
    if own.digest == taken.digest:
        return ()
    headline = f"modified scene: {NOT_COUNTING}"
    here, there = own.name, taken.name
    if here == there:  # in another lab, perhaps
        here, there = own.title, taken.title
    note = f"the task is set in `{here}`; this is `{there}`, or a changed copy"
    return (warning(MODIFIED_SCENE, headline, notes=(note,)),)


def other_controller(own: Scene, taken: Scene) -> tuple[Diagnostic, ...]:
    """Return a warning if a controller model is not that of a task."""
    if own.controller == taken.controller:
        return ()
    headline = f"another controller: {NOT_COUNTING}"
    here, there = own.controller.name, taken.controller.name
    note = f"the task is set under the controller model `{here}`; this is `{there}`"
    return (warning(OTHER_CONTROLLER, headline, notes=(note,)),)


def hidden_scene(scene: Scene) -> tuple[Diagnostic, ...]:
    """Return what tells that a result is that of a hidden scene."""
    headline = f"{IN_HIDDEN_SCENE} `{scene.name}`, where the mark is lowest"
    return (Diagnostic(HIDDEN_SCENE, Severity.NOTE, headline),)
