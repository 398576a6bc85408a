"""VAL-II, for a program that was written for a relative, or with the tolerance of `val2+`."""

from typing import ClassVar

from vrts.dispatch.posts.expressions_anew import CannotWrite
from vrts.dispatch.posts.post import Post
from vrts.lang.dialect import VAL2
from vrts.lang.syntax import expressions


class Val2(Post):
    """Writes VAL-II."""

    name = "val2"
    dialect = VAL2
    suffix = ".v2"
    LACKS: ClassVar[frozenset[str]] = frozenset({"DECOMPOSE"})

    def infix(self, node: expressions.Infix) -> str:
        """Return an operation; VAL-II has no powers."""
        if node.operator == "**":
            raise CannotWrite(node.start, node.end, "VAL-II has no `**`", "multiply, or use SQR")
        return super().infix(node)
