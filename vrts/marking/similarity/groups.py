"""Groups of programs that seem to come from one source, as they are written into files."""

from typing import Annotated, Literal, TypeAlias

from msgspec import Meta

from vrts.marking.result import Record

STRONG, LOOK = 0.05, 0.5  # pairs as much alike that are expected by chance, at most

Strength: TypeAlias = Literal["strong", "worth a look", "weak"]
Score: TypeAlias = Annotated[
    float,
    Meta(
        ge=0,
        le=1,
        description="0.5: one pair as much alike is expected by chance among all that are compared,"
        " those with other folders too; fewer than 500 pairs count as 500",
    ),
]


class Link(Record, frozen=True):
    """Two programs of a group."""

    first: str
    second: Annotated[str, Meta(description="`NAME/id` in the corpus NAME")]
    score: Score
    strength: Strength
    page: Annotated[str, Meta(description="in `staff`; empty: the pair has none")] = ""


class Evidence(Record, frozen=True):
    """Something that two programs share."""

    what: Annotated[
        str, Meta(description="motion, steps, numbers, words, text, offsets, manner or lines")
    ]
    words: str
    weight: Annotated[float, Meta(ge=0, description="natural logarithm of how seldom it is")]
    others: Annotated[int, Meta(ge=0, description="further programs that have it")]
    first_line: Annotated[int, Meta(ge=0, description="of the first program; 0: of none")]
    second_line: Annotated[int, Meta(ge=0)]


class Group(Record, frozen=True):
    """Programs that seem to come from one source."""

    members: Annotated[tuple[str, ...], Meta(description="`NAME/id` in the corpus NAME")]
    score: Score
    strength: Strength
    expected: Annotated[
        float,
        Meta(
            ge=0,
            description="pairs as much alike that are expected by chance among all that are"
            " compared, those with other folders too; fewer than 500 pairs count as 500",
        ),
    ]
    links: tuple[Link, ...]
    evidence: Annotated[
        tuple[Evidence, ...], Meta(description="of the strongest link, what weighs most first")
    ]


def strength_of(expected: float) -> Strength:
    """Return the strength in words."""
    if expected <= STRONG:
        return "strong"
    return "worth a look" if expected <= LOOK else "weak"
