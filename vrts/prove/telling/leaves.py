"""Where the tree of decisions ends: each leaf with all that outside decided on the way to it."""

from collections.abc import Iterator, Sequence

from vrts.prove.proof import Branch, Decided


def leaves(tree: Sequence[Branch]) -> Iterator[tuple[int, tuple[Decided, ...]]]:
    """Yield the number and the story of each branch that ends, or meets another one.

    Args:
        tree: Branches, parents before those that part from them.
    """
    stories: list[tuple[Decided, ...]] = []
    for number, branch in enumerate(tree):
        before = () if branch.parent is None else stories[branch.parent]
        story = before if branch.decided is None else (*before, branch.decided)
        stories.append(story)
        if branch.ends:
            yield number, story
