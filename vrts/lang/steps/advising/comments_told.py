"""Comments as other languages begin them, told and mended."""

import re

from vrts.base.diagnostic import Edit
from vrts.lang.steps.advising.adviser import OTHER_LANGUAGE, Advised, Adviser, Line
from vrts.lang.steps.idioms import comments

_DIRECTIVE = re.compile(r"#[ \t]*(?:define|include|import)\b", re.IGNORECASE)  # of C


class CommentAdvice(Adviser):
    """Explains lines by the comments in them."""

    open_comment = False  # of `/*`
    closing = ("*/", "*)")  # what ends it

    def comment(self, line: Line, mark: int) -> Advised | None:
        """Explain a line by the comment in it alone."""
        return self.leading(line, mark) or self.behind(line, mark, alone=False)

    def leading(self, line: Line, mark: int) -> Advised | None:
        """Explain a line that is a comment altogether."""
        found = comments.leading(line.text)
        if found is None or _DIRECTIVE.match(line.text):
            return None
        self.problems.forget(mark)
        self._comment_told(line, found)
        return Advised(None)

    def behind(self, line: Line, mark: int, *, alone: bool = True) -> Advised | None:
        """A comment behind a step; `alone`: which is right but for it."""
        found = comments.behind(line.text)
        tried = self.repair.steps(found.before) if found is not None else None
        if found is None or tried is None or tried.fixes > (not alone):
            return None
        self.problems.forget(mark)
        self._comment_told(line, found)
        return Advised(self._word_of(tried.text))

    def _comment_told(self, line: Line, found: comments.Comment) -> None:
        start, end = line.at + found.start, line.at + found.end
        quoted = found.sign if found.sign[0] in "\"'" else ""
        self.closing = (quoted,) if quoted else CommentAdvice.closing
        rest = line.raw[found.end :]
        self.open_comment = found.goes_on and not any(sign in rest for sign in self.closing)
        closing = found.closed_in(line.text)
        fix = self.problems.replace(start, end, ";")
        if closing is not None:
            first, last = line.at + closing[0], line.at + closing[1]
            fix = fix._replace(more=(Edit(self.problems.span(first, last), ""),))
        self.problems.error(
            OTHER_LANGUAGE,
            f"`{found.sign}` begins no comment",
            start,
            end,
            help=("begin comments with `;`",),
            fix=fix,
        )
        self.habits.note(self.problems, f"comment {found.sign}")

    def inside_comment(self, start: int, end: int, text: str) -> None:
        """Report a line of a comment that began with `/*` in a line above."""
        self.open_comment = not any(sign in text for sign in self.closing)
        self.problems.error(
            OTHER_LANGUAGE,
            "this is meant as a comment",
            start,
            end,
            help=("begin comments with `;`",),
            fix=self.problems.replace(start, start, "; "),
        )
        self.habits.note(self.problems, "comment /*")
