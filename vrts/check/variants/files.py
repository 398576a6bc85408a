"""The files of a task in one of its variants, as texts; and what is wrong with the paths of all.

A path begins with a word for the file that it is in: `task`, `scene`, `scenario` or `staff`.
"""

import tomllib
from collections.abc import Iterator, Mapping

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile
from vrts.base.toml.places import places
from vrts.check.variants.edits import Edit, NoPath, edited, find
from vrts.check.variants.model import Combination, Variants
from vrts.check.variants.section import SECTION

PATH = Rule("V866", "variant-path")

TASK, SCENE, SCENARIO, STAFF = "task", "scene", "scenario", "staff"
FILES = {
    TASK: "task.toml",
    SCENE: "the file of the scene",
    SCENARIO: "scenario.toml",
    STAFF: "staff/task.toml",
}
UNTOUCHED = (  # in task.toml: where things are, and what a class has in common
    *("task.scene", "task.lab", "task.controller", "task.program", SECTION),
    *("mark.total", "late", "submissions", "exam"),
)


def path_findings(variants: Variants, sources: Mapping[str, SourceFile]) -> tuple[Diagnostic, ...]:
    """Return every path that names nothing, or what cannot vary, where it stands.

    Args:
        variants: Of the task.
        sources: Its files by the word for each; those that there are.
    """
    found: list[Diagnostic] = []
    roots = {word: places(source.text).root for word, source in sources.items()}
    for vary in variants.varies:
        for number, (path, span) in enumerate(zip(vary.paths, vary.path_spans, strict=True)):
            word, *parts = path.split(".")
            label = Label(span)
            if word not in FILES or not parts:
                headline = f"`{path}` does not begin with a file"
                known = ", ".join(f"`{one}.`" for one in FILES)
                remedy = f"begin with {known}: for example `scene.objects.can1.at_mm.x`"
                found.append(error(PATH, headline, label, help=(remedy,)))
                continue
            if word not in roots:
                headline = f"`{path}`: the task has no {FILES[word]}"
                found.append(error(PATH, headline, label))
                continue
            if word == TASK and ".".join(parts).startswith(UNTOUCHED):
                headline = f"`{path}` is the same in all variants"
                remedy = "vary goals, or what is in the scene: its paths begin with `scene.`"
                found.append(error(PATH, headline, label, help=(remedy,)))
                continue
            try:
                find(roots[word], tuple(parts))
                for choice in vary.choices:
                    edited(sources[word], [Edit(tuple(parts), choice[number])])
            except NoPath as problem:
                headline = f"`{path}`: {problem.why}"
                help_ = (f"did you mean `{problem.near}`?",) if problem.near else ()
                notes = (f"what varies stands in {FILES[word]}, with its usual value",)
                found.append(error(PATH, headline, label, notes=notes, help=help_))
    return tuple(found)


def varied(
    variants: Variants, combination: Combination, sources: Mapping[str, SourceFile]
) -> dict[str, str]:
    """Return the texts of a task's files in one variant, by the word for each; no `[variants]`.

    Raises:
        NoPath: A path names nothing; `path_findings` tells where.
    """
    edits: dict[str, list[Edit]] = {}
    for vary, number in zip(variants.varies, combination, strict=True):
        for path, text in zip(vary.paths, vary.choices[number], strict=True):
            word, *parts = path.split(".")
            edits.setdefault(word, []).append(Edit(tuple(parts), text))
    return {
        word: edited(source, edits.get(word, ()), [(SECTION,)] if word == TASK else ())
        for word, source in sources.items()
    }


def cut(task: SourceFile) -> str:
    """Return the text of a task without `[variants]`."""
    return edited(task, (), [(SECTION,)])


def without_names(scene: SourceFile, names: tuple[str, ...]) -> str:
    """Return the text of a scene without its own locations of some names."""
    return edited(scene, (), tuple(_named(scene, names)))


def _named(scene: SourceFile, names: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    for name in tomllib.loads(scene.text).get("locations", {}):
        if name.lower() in names:
            yield ("locations", name)
