"""Details of runs, by how near they are: order, filler and shifted values are no disguise."""

import random

import numpy as np
import pytest
from numpy.typing import NDArray

from vrts.marking.similarity.evidence import nearness_told
from vrts.marking.similarity.features.episodes import Detail, by_key, words_of_detail
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.likeness import likeness
from vrts.marking.similarity.weighing.chance import chances
from vrts.marking.similarity.weighing.nearness import Nearness, nearness
from vrts.marking.similarity.weighing.nearness import _away as _away  # pyright: ignore[reportPrivateUsage]
from vrts.marking.submission.sketch import Sketch, Stop

PLACES = {"can1": (8000, -4500, -2250), "can2": (7500, 4500, -2250), "can3": (9000, 0, -2250)}
GOALS = {"can1": (9500, -1300, -750), "can2": (11000, 2300, -1250), "can3": (6000, 3000, -750)}


class Plan:
    """What somebody has in mind: heights, speeds, points on the way [tenths of a millimetre]."""

    def __init__(self, seed: int) -> None:
        draw = random.Random(seed)
        self.order = list(PLACES)
        self.heights = [draw.choice((800, 1000, 1200, 1500, 2000)) for _ in range(4)]
        self.speeds = [draw.choice((10, 20, 30, 40, 50)) for _ in range(2)]
        self.safe = (draw.randrange(7500, 10000), draw.randrange(-1000, 1000), 1000)
        self.taken = {thing: self._about(draw, at) for thing, at in PLACES.items()}
        self.put = {thing: self._about(draw, at) for thing, at in GOALS.items()}
        self.filler: tuple[int, int, int] | None = None

    @staticmethod
    def _about(draw: random.Random, at: tuple[int, int, int]) -> tuple[int, int, int]:
        x, y, z = (n + round(draw.gauss(0, 40)) for n in at)
        return x, y, z

    def disguised(self, seed: int, by: int = 30) -> "Plan":
        """Shift each value a little, take things in another order, move to and fro in between."""
        draw = random.Random(seed)

        def shifted(at: tuple[int, int, int]) -> tuple[int, int, int]:
            x, y, z = (n + draw.choice((-by, by)) for n in at)
            return x, y, z

        self.safe = shifted(self.safe)
        self.taken = {thing: shifted(at) for thing, at in self.taken.items()}
        self.put = {thing: shifted(at) for thing, at in self.put.items()}
        draw.shuffle(self.order)
        self.filler = (draw.randrange(7000, 9000), draw.randrange(-500, 500), 2000)
        return self

    def sketch(self, named: bool = False) -> Sketch:
        """Return what a run did."""
        stops: list[Stop] = []

        def stop(at: tuple[int, int, int], speed: int, held: str, hand: str = "") -> None:
            name, origin = min(
                (*PLACES.items(), *GOALS.items()),
                key=lambda row: sum((a - b) ** 2 for a, b in zip(row[1], at, strict=True)),
            )
            x, y, z = (a - b for a, b in zip(at, origin, strict=True))
            line = len(stops) + 1
            axis = (0, 0, -100)
            stops.append(Stop(line, not hand, speed, at, axis, name, (x, y, z), held, hand, named))

        def above(at: tuple[int, int, int], k: int) -> tuple[int, int, int]:
            return at[0], at[1], at[2] + self.heights[k]

        for thing in self.order:
            taken, put = self.taken[thing], self.put[thing]
            stop(self.safe, 100, "")
            if self.filler is not None:
                stop(self.filler, 100, "")
            stop(above(taken, 0), 100, "")
            stop(taken, self.speeds[0], "", "close")
            stop(above(taken, 1), 100, thing)
            stop(self.safe, 100, thing)
            stop(above(put, 2), 100, thing)
            stop(put, self.speeds[1], thing, "open")
            stop(above(put, 3), 100, "")
        return Sketch("vrts.motion/1", tuple(stops))


def details(sketch: Sketch) -> dict[tuple[str, str], list[tuple[float, ...]]]:
    return {key: [one.at for one in some] for key, some in by_key(sketch).items()}


def of_class(count: int = 60) -> list[Sketch]:
    """Return runs of a class, of which the last is the first in disguise."""
    return [*(Plan(k).sketch() for k in range(count)), Plan(0).disguised(1).sketch()]


def with_text(sketches: list[Sketch]) -> dict[str, Program]:
    """Return programs of which the text tells nothing."""
    text = ".PROGRAM main()\n  MOVE {}\n.END\n"
    return {
        f"s{k:02d}": Program(text.format(f"a{k}").encode(), one) for k, one in enumerate(sketches)
    }


def near_of(sketches: list[Sketch], count: int) -> Nearness:
    return nearness([details(one) for one in sketches], count)


def test_order_and_motions_in_between_leave_details_as_they_are() -> None:
    plain, other = details(Plan(3).sketch()), details(Plan(3).disguised(4, by=0).sketch())
    assert plain.keys() == other.keys()
    for key in plain.keys() - {("way", t) for t in PLACES} - {("come", t) for t in PLACES}:
        assert plain[key] == other[key], key
    assert all({*plain["come", t]} < {*other["come", t]} for t in PLACES)
    assert plain["above", "can1"][0][2] == Plan(3).heights[0] / 10


def test_places_that_the_scene_names_are_no_detail() -> None:
    kinds = {kind for kind, _ in by_key(Plan(3).sketch(named=True))}
    assert kinds.isdisjoint({"take", "put", "way", "come", "go", "together", "take axis"})
    assert {"above", "raise", "over", "leave", "take speed"} <= kinds


def test_a_copy_with_all_values_shifted_is_nearer_than_every_other_pair() -> None:
    total = near_of(of_class(), 61).total
    assert np.unravel_index(np.argmax(np.triu(total, 1)), total.shape) == (0, 60)
    assert np.allclose(total, total.T)


def test_many_details_of_one_decision_are_not_many_witnesses() -> None:
    """Ten kinds that say the same are one family; two that are near apart weigh more."""
    draw = np.random.default_rng(5)
    kinds = [f"k{k}" for k in range(10)]
    found: list[dict[tuple[str, str], list[tuple[float, ...]]]] = []
    for _ in range(60):
        same, other = (float(n) for n in draw.normal(0.0, 100.0, 2))
        found.append({**{(kind, ""): [(same,)] for kind in kinds}, ("other", ""): [(other,)]})
    for kind in kinds:
        found[1][kind, ""] = found[0][kind, ""]
    found[3].update({key: [(at[0][0] + 0.2,)] for key, at in found[2].items()})
    alone = nearness(found, 60).total
    together = nearness(found, 60, dict.fromkeys(kinds, "one")).total
    assert alone[0, 1] > 0.8 * alone[2, 3], "one decision seems to be ten"
    assert together[0, 1] < 0.7 * together[2, 3]


def test_programs_of_another_folder_are_measured_by_the_class() -> None:
    total = near_of(of_class(), 60).total
    assert total.shape == (60, 61)
    assert int(np.argmax(total[:, 60])) == 0


def test_what_all_have_alike_tells_nothing() -> None:
    same = near_of([Plan(5).sketch()] * 20, 20)
    assert not same.total.any()
    assert nearness([{}, {}], 2).total.tolist() == [[0, 0], [0, 0]]


def test_the_evidence_is_told_in_words_with_lines_the_rarest_first() -> None:
    sketches = of_class()
    first, second = by_key(sketches[0]), by_key(sketches[60])
    told = nearness_told(near_of(sketches, 61).of(0, 60), first, second)
    assert told
    assert all(one.what == "motion" and one.first_line and one.second_line for one in told)
    assert [one.weight for one in told] == sorted((one.weight for one in told), reverse=True)
    assert told[0].others == 0
    every = {words_of_detail(one) for some in first.values() for one in some}
    assert "the hand takes `can1` at nearly the same point" in every
    assert "nearly the same point beside the others, to put `can2`" in every
    assert not any("{" in words for words in every)
    assert words_of_detail(Detail("go", "", (), 1)) == "nearly the same point at the end"


def test_nearness_makes_a_pair_stand_out_that_is_moderately_alike_otherwise() -> None:
    draw = np.random.default_rng(1)
    share = np.triu(draw.uniform(0.1, 0.4, (80, 80)), 1).astype(np.float32)
    near = np.triu(draw.uniform(0.0, 20.0, (80, 80)), 1)
    share[2, 7], near[2, 7] = 0.35, 30.0
    compared = np.triu(np.ones((80, 80), dtype=np.bool_), 1)
    without = chances((share, share), compared).expected[2, 7]
    assert chances((share, share), compared, near=near).expected[2, 7] < without / 20
    nothing = chances((share, share), compared, near=np.zeros((80, 80))).expected[2, 7]
    assert nothing == without


def test_a_pair_whose_run_is_unknown_counts_as_one_that_is_as_rare_in_writing() -> None:
    """As with programs of an earlier year that nobody executed."""
    draw = np.random.default_rng(2)
    run = draw.uniform(0.1, 0.4, (60, 90)).astype(np.float32)
    run[:, 60:] = 0.0
    steps = draw.uniform(0.1, 0.4, (60, 90)).astype(np.float32)
    steps[3, 80] = steps[5, 9] = 0.9
    run[5, 9] = 0.9
    compared = np.triu(np.ones((60, 90), dtype=np.bool_), 1)
    ran = np.arange(90) < 60
    known = chances((run, steps), compared, ran=ran).expected
    blind = chances((run, steps), compared).expected
    assert known[3, 80] < blind[3, 80] / 5
    assert known[3, 80] == known[:, 60:].min()
    assert np.median(known[:, 60:]) > 100, "others are no more than chance"
    assert np.allclose(chances((run, steps), compared, ran=ran | True).expected, blind)


def test_a_copy_by_motion_alone_is_the_first_group() -> None:
    sketches = of_class(40)
    found = likeness(with_text(sketches), jobs=1)
    assert found.groups[0].members == ("s00", "s40")
    assert any("nearly" in one.words for one in found.groups[0].evidence)


def test_who_shares_nothing_but_heights_is_hardly_a_group() -> None:
    """Ways down and up to three things, and above three others: four heights, chosen once."""
    plans = [Plan(k) for k in range(60)]
    plans[1].heights = plans[2].heights = [911, 1313, 1717, 2121]
    sketches = [*(plan.sketch() for plan in plans), Plan(0).disguised(1).sketch()]
    groups = {one.members: one for one in likeness(with_text(sketches), jobs=1).groups}
    assert groups["s00", "s60"].strength == "worth a look"
    assert groups["s01", "s02"].strength == "weak"


def test_blocks_of_rows_change_nothing_and_bound_the_memory(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    draw = np.random.default_rng(3)
    details = [
        {("put", "can"): [tuple(map(float, draw.normal(0, 9, 3))) for _ in range(1 + k % 4)]}
        for k in range(30)
    ]
    whole = nearness(details, 24).total
    monkeypatch.setattr("vrts.marking.similarity.weighing.nearness.BLOCK", 600)
    assert np.array_equal(nearness(details, 24).total, whole)
    held: list[int] = []

    def counted(one: NDArray[np.float32], other: NDArray[np.float32]) -> NDArray[np.float32]:
        held.append(len(one) * len(other))
        return _away(one, other)

    monkeypatch.setattr("vrts.marking.similarity.weighing.nearness._away", counted)
    assert np.array_equal(nearness(details, 24).total, whole)
    assert max(held) <= 600
