"""What is written is read back, to the bit."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape
from vrts.marking.proposer.wire import HEAD, Asked, answer_to_bytes, from_bytes, proposals, to_bytes

NUMBERS = st.floats(allow_nan=False)
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS)
SHAPES = (
    st.builds(Box, VECTORS)
    | st.builds(Cylinder, NUMBERS, NUMBERS)
    | st.builds(Hull, st.lists(VECTORS, max_size=6).map(tuple))
)


@settings(max_examples=examples(100))
@given(st.lists(SHAPES, max_size=4), st.integers(0, 5), st.integers(0, 2**32 - 1))
def test_messages(shapes: list[Shape], count: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    pairs = random.integers(0, 1000, (count, 2)).astype(np.int32)
    data = to_bytes(Asked(tuple(shapes), pairs, random.normal(size=(count, 24))))
    found = from_bytes(data[: HEAD.size], data[HEAD.size :])
    assert found.shapes == tuple(shapes)
    assert (found.pairs == pairs).all()
    assert to_bytes(found) == data


@settings(max_examples=examples(100))
@given(st.lists(st.tuples(VECTORS, VECTORS, VECTORS)))
def test_answers(answers: list[tuple[tuple[float, ...], ...]]) -> None:
    found = proposals(b"".join(answer_to_bytes(*vectors) for vectors in answers))
    rows = list(zip(*(part.tolist() for part in found), strict=True))
    assert rows == [tuple(list(vector) for vector in vectors) for vectors in answers]
