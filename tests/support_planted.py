"""Planted defects: small programs that go wrong in some future, or in none, as files to prove."""

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent / "data" / "prove"
HEADING = re.compile(r"^## (\w+) (.+)$", re.MULTILINE)
BLOCK = re.compile(r"^```(toml case|toml environment|toml task|val2)\n(.*?)^```$", re.M | re.S)
BLAMED = ";!"  # stands in the line that does what goes wrong
KINDS = {  # what `vrts prove` calls what a program of the corpus expects
    "contact": "contact",
    "error": "run-time error",
    "goal": "goal missed",
    "endless": "endless loop",
    "deadlock": "wait that nothing may end",
    "never": "property broken",
    "always": "property broken",
}
NO_LINE = ("goal missed", "property broken")  # of a whole run, or of a tick
UNBOUNDED = ("unbounded",)  # nothing can be shown: that it is left open is to be told


@dataclass(frozen=True, slots=True)
class Planted:
    """A program, what may come from outside, and what is to be found."""

    name: str
    title: str
    program: str
    environment: str | None
    task: str | None
    scene: str | None
    expected: tuple[str, ...]  # kinds of what may be told, or "holds", or "none"
    words: str  # that the headline holds

    @property
    def is_right(self) -> bool:
        return self.expected[0] in ("holds", "none")

    @property
    def lines(self) -> tuple[int, ...]:
        """The lines that are to blame, from 1; none where it does not matter."""
        lines = self.program.splitlines()
        return tuple(k for k, line in enumerate(lines, 1) if BLAMED in line)

    def written(self, folder: Path) -> list[str]:
        """Write the files into a folder, and return the arguments of `vrts prove`."""
        path = folder / f"{self.name}.v2"
        path.write_text(self.program)
        arguments = [str(path)]
        if self.environment is not None:
            (folder / "environment.toml").write_text(self.environment)
            arguments += ["--environment", str(folder / "environment.toml")]
        if self.task is not None:
            (folder / "task.toml").write_text(self.task)
            arguments += ["--task", str(folder / "task.toml")]
        elif self.scene is not None:
            arguments += ["--scene", self.scene]
        return arguments


def planted() -> list[Planted]:
    """Return all programs, in the order of their files."""
    return [one for path in sorted(FOLDER.glob("*-*.md")) for one in in_file(path)]


def in_file(path: Path) -> list[Planted]:
    """Return the programs of one file."""
    text = path.read_text(encoding="utf-8")
    heads = list(HEADING.finditer(text))
    ends = [head.start() for head in heads[1:]] + [len(text)]
    return [
        read(head[1], head[2], text[head.end() : end])
        for head, end in zip(heads, ends, strict=True)
    ]


def read(name: str, title: str, section: str) -> Planted:
    """Return the program of one section."""
    blocks = dict(BLOCK.findall(section))
    case = tomllib.loads(blocks["toml case"])
    expected: str | list[str] = case["expect"]
    return Planted(
        name=name,
        title=title,
        program=blocks["val2"],
        environment=blocks.get("toml environment"),
        task=blocks.get("toml task"),
        scene=case.get("scene"),
        expected=(expected,) if isinstance(expected, str) else tuple(expected),
        words=case.get("words", ""),
    )


def outcome(one: Planted, told: dict[str, Any]) -> str:
    """Return what became of a program, by the JSON of `vrts prove`.

    Of one that goes wrong: `found`, `open` (as was to be told), `undetermined` or `missed`. Of one
    that is right: `held`, `undetermined` or `accused`.
    """
    answer, found = told["answer"], told["found"]
    if one.is_right:
        fine = answer == "holds" or one.expected == ("none",)
        return "accused" if found else "held" if fine else "undetermined"
    if one.expected == UNBOUNDED and answer == "undetermined" and not found:
        lines = [variable["line"] for variable in told["unbounded"]]
        said = lines == list(one.lines) or "nothing says what is typed" in told["open"][0]
        return "open" if said else "undetermined"
    if answer == "violated" and any(is_expected(one, wrong) for wrong in found):
        return "found"
    return "undetermined" if answer == "undetermined" else "missed"


def is_expected(one: Planted, wrong: dict[str, Any]) -> bool:
    """Return whether something told is what was planted: its kind, words and line, confirmed."""
    kinds = [KINDS.get(kind) for kind in one.expected]
    where = not one.lines or wrong["wrong"] in NO_LINE or wrong["line"] in one.lines
    named = wrong["wrong"] in kinds and one.words in wrong["headline"]
    return named and where and bool(wrong["confirmed"])
