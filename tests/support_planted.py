"""Planted defects: small programs that go wrong in some future, or in none, as files to prove."""

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parent / "data" / "prove"
HEADING = re.compile(r"^## (\w+) (.+)$", re.MULTILINE)
BLOCK = re.compile(r"^```(toml case|toml environment|toml task|val2)\n(.*?)^```$", re.M | re.S)
BLAMED = ";!"  # stands in the line that does what goes wrong


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
    expected = case["expect"]
    return Planted(
        name=name,
        title=title,
        program=blocks["val2"],
        environment=blocks.get("toml environment"),
        task=blocks.get("toml task"),
        scene=case.get("scene"),
        expected=tuple(expected) if isinstance(expected, list) else (expected,),
        words=case.get("words", ""),
    )
