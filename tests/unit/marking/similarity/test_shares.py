"""What programs have in common: the same on every machine, to the last bit."""

import numpy as np

from vrts.marking.similarity.weighing.shares import shares


def test_sums_of_weights_are_exact_in_whatever_order_they_are_made() -> None:
    draw = np.random.default_rng(7)
    class_ = [sorted({*draw.integers(0, 12_000, 2_500).tolist()}) for _ in range(20)]
    found = shares(class_[:15], class_[15:], frozenset(range(50)))
    weights = dict(zip(found.digests.tolist(), found.weights.tolist(), strict=True))
    for i, j in ((0, 1), (3, 14), (2, 17)):
        both = ({*class_[i]} & {*class_[j]}) - {*range(50)}
        assert both
        said = sum((weights[digest] for digest in sorted(both, reverse=True)), 0.0)
        assert found.common[i, j] == said
        assert (said * 512).is_integer()
