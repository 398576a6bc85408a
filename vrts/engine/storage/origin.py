"""What a run was made of, as far as a file has to tell it: texts of programs and scene."""

import hashlib
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.controllers.models import FIRST
from vrts.controllers.values import digest
from vrts.engine.storage.damage import require
from vrts.engine.storage.plain import Json, listed, named, text, truth
from vrts.ir.dump import dump
from vrts.ir.module import Module

LONGEST_NAME = 4096  # characters of the name of a file, with its folders
_FIRST = (FIRST.name, digest(FIRST))  # before files said which


class Programs(NamedTuple):
    """Program texts, and how they are to be read."""

    sources: tuple[SourceFile, ...]  # compiled together, in this order
    dialect: str
    precedence: str | None = None  # None: as the dialect has it
    replace: bool = False  # a program that comes again takes the place of the first


class SceneText(NamedTuple):
    """The scene's file."""

    name: str  # under which it was read; of a robot alone: the robot
    text: str | None  # None: a robot alone
    digest: str  # of the file and those it names
    controller: str  # name of the model that the run went by
    controller_digest: str  # of what that model says


class Origin(NamedTuple):
    """What a run was made of; its scenario and commands belong to the run itself."""

    programs: Programs
    scene: SceneText


def module_digest(module: Module) -> str:
    """Return the hash of what programs were compiled to, steps included."""
    steps = [origin.step for program in module.programs.values() for origin in program.origins]
    return hashlib.sha256(f"{dump(module)}\0{steps}".encode()).hexdigest()


def write_origin(origin: Origin, module: Module) -> Json:
    """Return an origin as JSON."""
    programs, scene = origin
    return {
        "programs": {
            "sources": [[source.name, source.text] for source in programs.sources],
            "dialect": programs.dialect,
            "precedence": programs.precedence,
            "replace": programs.replace,
            "sha256": module_digest(module),
        },
        "scene": {"name": scene.name, "text": scene.text, "sha256": scene.digest},
        "controller": {"name": scene.controller, "sha256": scene.controller_digest},
    }


def read_origin(data: Json, *, names_controller: bool = True) -> tuple[Origin, str]:
    """Return an origin, and the digest that its module has to have.

    Args:
        data: JSON.
        names_controller: Whether it says by which model the run went; else it was the first.

    Raises:
        Damaged: JSON does not stand for one.
    """
    parts = named(data)
    programs, scene = named(parts.get("programs")), named(parts.get("scene"))
    sources: list[SourceFile] = []
    for item in listed(programs.get("sources")):
        name, content = listed(item, 2)
        sources.append(SourceFile(text(name), text(content)))
    require(bool(sources), "there is no program")
    dialect, precedence = text(programs.get("dialect")), programs.get("precedence")
    require(precedence in (None, "A", "B"), "there is no such precedence")
    found = Programs(tuple(sources), dialect, precedence, truth(programs.get("replace")))
    for name in (text(scene.get("name")), *(source.name for source in sources)):
        require(name.isprintable() and len(name) <= LONGEST_NAME, "a file has no proper name")
    content = scene.get("text")
    place = SceneText(
        text(scene.get("name")),
        None if content is None else text(content),
        text(scene.get("sha256")),
        *(_controller(parts.get("controller")) if names_controller else _FIRST),
    )
    return Origin(found, place), text(programs.get("sha256"))


def _controller(data: Json) -> tuple[str, str]:
    said = named(data)
    name = text(said.get("name"))
    require(name.isprintable() and len(name) <= LONGEST_NAME, "a controller has no proper name")
    return name, text(said.get("sha256"))
