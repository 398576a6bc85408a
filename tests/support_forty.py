"""A fixed program of 60 seconds among forty objects, run by the engine."""

from functools import cache

from tests.places import TESTS
from tests.support_programs import compiled
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.scene.reading.scene_file import read_scene

FOLDER = TESTS / "data" / "forty-objects"


@cache
def forty_objects() -> Run:
    """Return the run; its scene is `run.scene`."""
    text = (FOLDER / "scene.toml").read_text(encoding="utf-8")
    scene, problems = read_scene(SourceFile("scene.toml", text))
    assert scene is not None
    assert not problems
    return execute(compiled((FOLDER / "solution.v2").read_text(encoding="utf-8")), scene)
