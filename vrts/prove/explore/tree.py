"""The tree of decisions, as far as it is kept."""

from vrts.prove.proof import Branch, Decided

MOST = 5_000  # branches


class Tree:
    """Branches in the order in which they were explored."""

    def __init__(self) -> None:
        """Be empty."""
        self.branches: list[Branch] = []

    def add(self, parent: int | None, decided: Decided | None) -> int | None:
        """Add a branch; return its number. None: it is not kept, nor what grows on it."""
        orphan = parent is None and bool(self.branches) and decided is None
        if len(self.branches) >= MOST or orphan:
            return None
        self.branches.append(Branch(parent, decided, ""))
        return len(self.branches) - 1

    def ends(self, branch: int | None, how: str) -> None:
        """Note how a branch ends, if nobody has."""
        if branch is not None and not self.branches[branch].ends:
            self.branches[branch] = self.branches[branch]._replace(ends=how)
