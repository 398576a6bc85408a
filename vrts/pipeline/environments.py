"""What may come from outside in the futures of a program: as a file says, or usually."""

from dataclasses import replace
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.pipeline.files import read_toml_source
from vrts.pipeline.setting import Setting, accepted, scenario_of
from vrts.prove.environment.environment import Environment
from vrts.prove.environment.reading import read_environment


def usual_environment(setting: Setting) -> Environment:
    """Return the environment in which everything that a program reads is free."""
    return Environment(scenario=scenario_of(setting))


def load_environment(
    path: Path, setting: Setting, home: Path | None = None
) -> tuple[Environment, tuple[Diagnostic, ...]]:
    """Return the environment that a file describes, and what there is to say about it.

    Args:
        path: The file.
        setting: Where programs run, and by its scenario how they begin.
        home: As for `read_toml_source`.

    Raises:
        CannotRead: The file is not there.
        Refused: It has errors.
    """
    found, said = read_environment(read_toml_source(path, home))
    return replace(accepted(found, said), scenario=scenario_of(setting)), said
