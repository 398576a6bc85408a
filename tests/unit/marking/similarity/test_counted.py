"""How often programs have each word of the language: it tells where nothing they share is rare."""

import numpy as np

from vrts.marking.similarity.evidence import counts_told
from vrts.marking.similarity.features.counts import words_counted
from vrts.marking.similarity.symbols import readable
from vrts.marking.similarity.weighing.chance import chances
from vrts.marking.similarity.weighing.counted import counted

CLASS = [tuple((word, 1 + (k >> bit & 1)) for bit, word in enumerate("abcde")) for k in range(32)]


def test_words_are_counted_whatever_names_comments_texts_and_values_are() -> None:
    one = b'.PROGRAM a()\n  MOVE p1 ; MOVE\n  TYPE "MOVE on"\n  move p2\n.END\n'
    other = b'.PROGRAM z()\n  MOVE there\n  MOVE p1\n  TYPE "x", 3\n.END\n.LOCATIONS\nMOVE 1 2 3\n'
    found = [words_counted(file) for file in (readable(one, "a"), readable(other, "b")) if file]
    assert found[0] == found[1]
    assert dict(found[0]) == {".PROGRAM": 1, "MOVE": 2, "TYPE": 1}


def test_two_that_lack_and_have_the_same_count_more_than_two_that_share_as_much() -> None:
    same = (("a", 2), ("b", 1), ("c", 3))
    found = counted([*CLASS, same, same], 34)
    assert found[32, 33] == found.max()
    assert found[32, 33] > 2 * np.sort(found[32])[-2]
    assert np.array_equal(found, found.T)
    assert not found.diagonal().any()


def test_the_distance_to_another_folder_is_measured_by_the_class() -> None:
    found = counted([*CLASS, CLASS[3], (("a", 9),)], 32)
    assert found[3, 32] == found[3].max() > 0
    assert found[3, 33] == 0


def test_an_empty_program_is_near_nobody() -> None:
    found = counted([*CLASS, (), ()], 34)
    assert not found[32:].any()
    assert not found[:, 32:].any()


def test_evidence_says_how_far_apart_they_are_and_how_many_are_as_near() -> None:
    (told,) = counts_told(CLASS[0], CLASS[3], float(counted([*CLASS], 32)[0, 3]) + 2.0, 32)
    assert told.words == "each word of the language as often, 2 more or fewer in all"
    assert counts_told(CLASS[0], CLASS[0], 3.0, 32)[0].words == "each word of the language as often"
    assert counts_told(CLASS[0], CLASS[3], 0.5, 32) == []


def test_what_is_counted_alike_makes_chance_less_likely() -> None:
    draw = np.random.default_rng(1)
    share = np.triu(draw.uniform(0, 0.3, (34, 34)).astype(np.float32), 1)
    pairs = np.triu(np.ones((34, 34), dtype=np.bool_), 1)
    as_often = counted([*CLASS, (("a", 4),), (("a", 4),)], 34)
    before, now = (chances((share,), pairs, counted=one).surprise for one in (None, as_often))
    assert now[32, 33] > before[32, 33] + 2.0
