"""The tree of decisions, as far as it is kept."""

from vrts.prove.proof import Branch, Decided

MOST = 5_000  # branches


class Tree:
    """Branches in the order in which they were explored."""

    def __init__(self) -> None:
        """Be empty."""
        self.branches: list[Branch] = []
        self._first: dict[int, int] = {}  # branches by state

    def add(self, parent: int | None, decided: Decided | None) -> int | None:
        """Add a branch; return its number. None: it is not kept, nor what grows on it."""
        orphan = parent is None and bool(self.branches) and decided is None
        if len(self.branches) >= MOST or orphan:
            return None
        self.branches.append(Branch(parent, decided, ""))
        return len(self.branches) - 1

    def ends(
        self, branch: int | None, how: str, time_s: float | None = None, state: int | None = None
    ) -> None:
        """Note how and when a branch ends, if nobody has; `state` is the one it merges into."""
        if branch is not None and not self.branches[branch].ends:
            into = None if state is None else self._first.get(state)
            old = self.branches[branch]
            self.branches[branch] = old._replace(ends=how, ended_s=time_s, into=into)

    def visits(self, branch: int | None, state: int) -> None:
        """Note on which branch a state was met first."""
        if branch is not None:
            self._first[state] = branch
