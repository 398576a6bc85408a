"""Branches listed, gone to, named and compared: what each command about them does."""

import re

from vrts.debug.branches.compared import rows
from vrts.debug.branches.tree import LONGEST_NAME, Branch, Tree
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.editing.text import sources_of
from vrts.debug.evaluating import CannotTell

_NAME = re.compile(r"[A-Za-z_][\w-]*")


def listed(tree: Tree) -> list[str]:
    """Return the branches as lines, the present one marked; deeper ones further in."""
    return [
        f"{'*' if branch.number == tree.number else ' '} {'  ' * tree.depth(branch)}"
        f"{branch.label}: {_made(branch)}"
        for branch in _in_order(tree)
    ]


def go_to(debugger: Debugger, console: Console, label: str) -> str:
    """Go to a branch, at the same time."""
    tree = debugger.tree
    return _stand(debugger, console, tree.at(_called(tree, label)))


def undo(debugger: Debugger, console: Console) -> str:
    """Go to the branch that the present one came from."""
    tree = debugger.tree.undo()
    if tree is None:
        raise CannotTell("nothing was changed: there is nothing to undo")
    return _stand(debugger, console, tree)


def redo(debugger: Debugger, console: Console) -> str:
    """Go to the branch that was undone last."""
    tree = debugger.tree.redo()
    if tree is None:
        raise CannotTell("nothing was undone")
    return _stand(debugger, console, tree)


def name(debugger: Debugger, text: str) -> str:
    """Give the present branch a name."""
    wanted, tree = text.strip(), debugger.tree
    if not _NAME.fullmatch(wanted) or len(wanted) > LONGEST_NAME:
        raise CannotTell("a name begins with a letter: `name slower`")
    taken = tree.called(wanted)
    if taken is not None and taken.number != tree.number:
        raise CannotTell(f"`{wanted}` is the name of another future")
    debugger.name_branch(wanted)
    return f"this future is called `{wanted}`, and is kept"


def compare(debugger: Debugger, console: Console, text: str) -> list[str]:
    """Return two branches side by side: mark, clearance, time, lost points."""
    tree, words = debugger.tree, text.split()
    if len(words) == 1:
        words = [tree.current.label, *words]
    if len(words) != 2:
        raise CannotTell(f"`compare` takes two futures of: {', '.join(tree.labels)}")
    one, other = (_called(tree, word) for word in words)
    task = None if console.request is None else console.request.setting.task
    return rows(one, other, task, debugger.memory)


def gave_up(gone: Branch | None) -> str:
    """Return that a branch is not kept any more; nothing where all are."""
    if gone is None:
        return ""
    return f"future {gone.label} ({gone.words}) is not kept any more: `name` keeps one"


def _stand(debugger: Debugger, console: Console, tree: Tree) -> str:
    before = debugger.run.module
    debugger.to_branch(tree)
    if debugger.run.module is not before:
        console.show(sources_of(debugger))
    return f"future {tree.current.label}: {_made(tree.current)}"


def _called(tree: Tree, label: str) -> Branch:
    found = tree.called(label)
    if found is None:
        asked = (
            f"no future is called `{label.strip()[:LONGEST_NAME]}`" if label else "which future?"
        )
        raise CannotTell(f"{asked}; there are: {', '.join(tree.labels)}")
    return found


def _made(branch: Branch) -> str:
    if not branch.parent:
        return branch.words
    return f"{branch.by.value} at {branch.forked.time_s:.3f} s, {branch.words}"


def _in_order(tree: Tree) -> list[Branch]:
    """Return the branches, each behind the one that it came from."""
    found: list[Branch] = []
    to_do = [tree.branches[0]]
    while to_do:
        branch = to_do.pop()
        found.append(branch)
        to_do += [b for b in reversed(tree.branches) if b.parent == branch.number]
    return found
