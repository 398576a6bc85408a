"""Questions that take several steps, asked together: what each needs next is answered at once.

A question is a generator: it yields what it needs to know, is sent the answer, and comes to its
result. Answering many at a time costs little more than answering one.
"""

from collections.abc import Callable, Generator, Mapping, Sequence
from typing import TypeAlias, TypeVar

Needs = TypeVar("Needs")
Answer = TypeVar("Answer")
T = TypeVar("T")
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
    told: dict[int, T] = {}
    answers: Mapping[int, Answer | None] = dict.fromkeys(range(len(questions)))
    while answers:
        asked: dict[int, Needs] = {}
        for number, given in answers.items():
            question = questions[number]
            try:
                asked[number] = next(question) if given is None else question.send(given)
            except StopIteration as end:
                told[number] = end.value
        answers = answer(asked) if asked else {}
    return [told[number] for number in range(len(questions))]
