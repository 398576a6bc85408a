"""The futures of one run as a tree: where each forked, and by what. A value: nothing changes it."""

from enum import Enum
from typing import NamedTuple

from vrts.debug.passages import Instant
from vrts.engine.run import Run
from vrts.lang.dialect import Dialect

MOST_KEPT = 24  # branches; each may hold a whole run
LONGEST_NAME = 40  # characters


class By(Enum):
    """What made a branch; the value is a word for it."""

    FIRST = "first"
    TEXT = "text"
    VALUE = "value"
    STEP = "step"
    COMMAND = "command"


class Branch(NamedTuple):
    """One future."""

    number: int
    parent: int  # its number; 0: none
    by: By
    words: str  # what was done
    forked: Instant  # up to here it is as its parent
    run: Run
    dialect: Dialect
    name: str = ""  # somebody gave it one

    @property
    def label(self) -> str:
        """What it is called."""
        return self.name or str(self.number)


class Tree(NamedTuple):
    """All branches, the oldest first, and which one the debugger is on."""

    branches: tuple[Branch, ...]
    number: int  # of the present one
    last: int  # the highest number that was given
    undone: tuple[int, ...] = ()  # where `redo` leads, the next last

    @property
    def current(self) -> Branch:
        """The branch that the debugger is on."""
        return self.numbered(self.number)

    @property
    def labels(self) -> list[str]:
        """What the branches are called."""
        return [branch.label for branch in self.branches]

    def numbered(self, number: int) -> Branch:
        """Return a branch that is there."""
        return next(branch for branch in self.branches if branch.number == number)

    def called(self, label: str) -> Branch | None:
        """Return the branch of a name or number, if there is one."""
        wanted = label.strip().lower()
        return next(
            (b for b in self.branches if wanted in (b.name.lower(), str(b.number)) and wanted), None
        )

    def grown(
        self, run: Run, by: By, words: str, forked: Instant, dialect: Dialect
    ) -> "tuple[Tree, Branch | None]":
        """Return the tree with one branch more, and one that had to go: the oldest without a name.

        The first one stays, and the one that the new one comes from.
        """
        branch = Branch(self.last + 1, self.number, by, words, forked, run, dialect)
        kept = self.branches
        gone = None
        if len(kept) >= MOST_KEPT:
            free = [b for b in kept[1:] if not b.name and b.number != self.number]
            gone = free[0] if free else None
        if gone is not None:
            kept = tuple(_without(b, gone) for b in kept if b is not gone)
        return Tree((*kept, branch), branch.number, branch.number), gone

    def at(self, branch: Branch) -> "Tree":
        """Return the tree with the debugger on another branch."""
        return self._replace(number=branch.number, undone=())

    def undo(self) -> "Tree | None":
        """Return the tree with the debugger on the parent; None at the first one."""
        if not self.current.parent:
            return None
        return self._replace(number=self.current.parent, undone=(*self.undone, self.number))

    def redo(self) -> "Tree | None":
        """Return the tree with what was undone last done again; None where nothing was."""
        if not self.undone:
            return None
        return self._replace(number=self.undone[-1], undone=self.undone[:-1])

    def named(self, name: str) -> "Tree":
        """Return the tree with a name for the present branch; nobody else may have it."""
        branches = tuple(
            b._replace(name=name) if b.number == self.number else b for b in self.branches
        )
        return self._replace(branches=branches)

    def shared(self, one: Branch, other: Branch) -> int:
        """Return how many statements two branches have in common at least."""
        mine, theirs = self._ways(one), self._ways(other)
        common = next((number for number in mine if number in theirs), None)
        if common is None:
            return 0
        return min(mine[common], theirs[common])

    def depth(self, branch: Branch) -> int:
        """Return how many branches lead to one."""
        return len(self._ways(branch)) - 1

    def _ways(self, branch: Branch) -> dict[int, int]:
        """Return the branches that lead to one, itself first: statements shared with each."""
        found = {branch.number: branch.run.statements}
        least = branch.run.statements
        while branch.parent:
            least = min(least, branch.forked.finished)
            branch = self.numbered(branch.parent)
            found[branch.number] = least
        return found


def first_branch(run: Run, dialect: Dialect) -> Tree:
    """Return the tree of a run that nobody has changed."""
    branch = Branch(1, 0, By.FIRST, "the program as it was opened", Instant(0.0, 0), run, dialect)
    return Tree((branch,), 1, 1)


def _without(branch: Branch, gone: Branch) -> Branch:
    if branch.parent != gone.number:
        return branch
    forked = min(branch.forked, gone.forked)
    return branch._replace(parent=gone.parent, forked=forked)
