"""Questions that take several steps, asked together: what each needs next is answered at once.

A question is a generator: it yields what it needs to know, is sent the answer, and comes to its
result. Answering many at a time costs little more than answering one.
"""

from collections.abc import Callable, Generator, Mapping, Sequence
from typing import TypeAlias, TypeVar

Needs = TypeVar("Needs")
Answer = TypeVar("Answer")
T = TypeVar("T")
U = TypeVar("U")
Asking: TypeAlias = Generator[Needs, Answer, T]


def all_told(
    questions: Sequence[Generator[Needs, Answer, T]],
    answer: Callable[[Mapping[int, Needs]], Mapping[int, Answer]],
) -> list[T]:
    """Return what several questions come to.

    Args:
        questions: The questions.
        answer: Returns answers to what questions need next; both by the number of the question.
    """
    return both_told(questions, (), answer)[0]


def both_told(
    first: Sequence[Generator[Needs, Answer, T]],
    second: Sequence[Generator[Needs, Answer, U]],
    answer: Callable[[Mapping[int, Needs]], Mapping[int, Answer]],
) -> tuple[list[T], list[U]]:
    """Return what questions of two kinds come to.

    Args:
        first: Those of one kind.
        second: Those of the other.
        answer: Returns answers to what questions need next; both by the number of the question,
            those of the second kind after the first.
    """
    one: dict[int, T] = {}
    other: dict[int, U] = {}
    questions = [
        *(_into(one, number, question) for number, question in enumerate(first)),
        *(_into(other, number, question) for number, question in enumerate(second)),
    ]
    answers: Mapping[int, Answer | None] = dict.fromkeys(range(len(questions)))
    while answers:
        asked: dict[int, Needs] = {}
        for number, given in answers.items():
            question = questions[number]
            try:
                asked[number] = next(question) if given is None else question.send(given)
            except StopIteration:
                continue
        answers = answer(asked) if asked else {}
    return [one[number] for number in range(len(first))], [
        other[number] for number in range(len(second))
    ]


def _into(
    told: dict[int, T], number: int, question: Asking[Needs, Answer, T]
) -> Asking[Needs, Answer, None]:
    told[number] = yield from question
