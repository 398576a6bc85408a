"""The files of a task in one of its variants, as texts; and what is wrong with the paths of all.

A path begins with a word for the file that it is in: `task`, `scene`, `scenario` or `staff`.
"""

import tomllib
from collections.abc import Iterable, Mapping
from difflib import get_close_matches

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile, Span
from vrts.base.toml.places import places
from vrts.check.variants.edits import Edit, NoPath, edited, exact, find
from vrts.check.variants.model import Combination, Variants
from vrts.check.variants.section import SECTION, VALUES, toml_text
from vrts.scene.handling.withheld import KEY, may_be_worked_out

PATH = Rule("V866", "variant-path")

YOURS = "these places you find and teach yourself"
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
    seen: list[tuple[tuple[str, ...], str, Span]] = []
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
                continue
            spot = (word, *exact(roots[word], tuple(parts)))
            other = next((one for one in seen if _within(one[0], spot)), None)
            if other is not None:
                headline = f"`{path}` and `{other[1]}` set the same value"
                label = Label(span, "x, y, z are the numbers 1, 2, 3")
                found.append(error(VALUES, headline, label, secondary=(Label(other[2]),)))
            seen.append((spot, path, span))
    return tuple(found)


def name_findings(variants: Variants, known: Iterable[str]) -> tuple[Diagnostic, ...]:
    """Return every name in `staff_names` that no location of the scene has.

    Args:
        variants: Of the task.
        known: Names of its locations, in small letters.
    """
    there = tuple(known)
    found: list[Diagnostic] = []
    for name, span in zip(variants.staff_names, variants.staff_spans, strict=False):
        if name not in there:
            near = get_close_matches(name, there, 1, 0.6)
            remedy = f"did you mean `{near[0]}`?" if near else "`vrts scene show` tells the names"
            headline = f"the scene has no location `{name}`, which is withheld from nobody"
            found.append(error(VALUES, headline, Label(span), help=(remedy,)))
    return tuple(found)


def _within(one: tuple[str, ...], other: tuple[str, ...]) -> bool:
    """Return whether one of two places is the other, or in it."""
    shorter = min(len(one), len(other))
    return one[:shorter] == other[:shorter]


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
    """Return the text of a scene without its own locations of some names.

    What vrts would work out itself is withheld: it says so in the text.
    """
    fields = tomllib.loads(scene.text)
    own = tuple(
        ("locations", name) for name in fields.get("locations", {}) if name.lower() in names
    )
    before = fields.get(KEY, [])
    known = [before] if isinstance(before, str) else before
    more = [name for name in names if may_be_worked_out(name, fields.get("objects", {}))]
    withheld = toml_text(list(dict.fromkeys([*known, *more])))
    if KEY in fields:
        return edited(scene, [Edit((KEY,), withheld)], own)
    line = f"{KEY} = {withheld}  # {YOURS}\n" if more else ""
    return line + edited(scene, (), own)
