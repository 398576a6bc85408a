"""Laws of the ranking of similar programs, for any bytes and for random programs."""

from hypothesis import given
from hypothesis import strategies as st

from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.ranking import Ranking, similarity, to_bytes

STEPS = st.sampled_from(
    (
        *("MOVE a", "MOVES b", "APPRO a, 100", "DEPARTS 50", "OPENI", "CLOSEI", "x = y+1"),
        *("IF SIG(1) THEN", "END", "FOR i = 1 TO 3", "SET a = b:c", 'TYPE "hello"', "DELAY 1"),
        *("SET p = TRANS(1,2,3,4,5,6)", "10 GOTO 10", "}{ nothing [", "CALL sub(a, 1)"),
    )
)
LINES = st.lists(STEPS, max_size=40)
PROGRAMS = st.lists(LINES, min_size=1, max_size=3).map(
    lambda subs: "".join(
        f".PROGRAM p{k}()\n" + "".join(f"  {line}\n" for line in lines) + ".END\n"
        for k, lines in enumerate(subs)
    )
)
PIECES = st.sampled_from(
    (".PROGRAM", "\n", ".END", ".LOCATIONS", "a 1 2 3", "TRANS(", "1e999", "\0")
)
BYTES = st.one_of(
    st.binary(max_size=300),
    st.lists(st.one_of(PIECES, st.text(max_size=12)), max_size=30).map(
        lambda parts: " ".join(parts).encode("utf-8", "surrogatepass")
    ),
)
CLASSES = st.dictionaries(st.sampled_from("abcdef"), PROGRAMS, min_size=2)


def without_places(ranking: Ranking) -> list[tuple[str, str, float]]:
    """Return the pairs and their scores."""
    return [(pair.first, pair.second, pair.score) for pair in ranking.pairs]


@given(st.dictionaries(st.sampled_from("abcd"), BYTES))
def test_any_bytes_give_a_ranking_and_a_page(programs: dict[str, bytes]) -> None:
    ranking = similarity(programs)
    assert to_bytes(ranking)
    assert similarity_page(ranking, programs, "any")


@given(CLASSES)
def test_scores_lie_between_nothing_and_all_and_every_pair_comes_once(
    texts: dict[str, str],
) -> None:
    found = similarity({name: text.encode() for name, text in texts.items()})
    for pair in found.pairs:
        assert 0 <= pair.code <= pair.score <= 1
        assert 0 <= pair.taught <= pair.score
        assert pair.first < pair.second
        for region in pair.regions:
            assert 1 <= region.first_start <= region.first_end
            assert region.first_end <= len(texts[pair.first].split("\n"))
            assert region.second_end <= len(texts[pair.second].split("\n"))
    assert len({(pair.first, pair.second) for pair in found.pairs}) == len(found.pairs)


@given(CLASSES, st.integers(0, 5))
def test_comments_blank_lines_and_case_change_no_score(texts: dict[str, str], every: int) -> None:
    changed = {
        name: "\n\n".join(
            line.upper() + ("   ; a remark" if k % (every + 1) == 0 else "")
            for k, line in enumerate(text.split("\n"))
        )
        for name, text in texts.items()
    }
    before = similarity({name: text.encode() for name, text in texts.items()})
    after = similarity({name: text.encode() for name, text in changed.items()})
    assert without_places(before) == without_places(after)


@given(CLASSES)
def test_the_class_itself_as_template_leaves_nothing(texts: dict[str, str]) -> None:
    programs = {name: text.encode() for name, text in texts.items()}
    assert similarity(programs, list(programs.values())).pairs == ()


@given(CLASSES)
def test_nobody_is_compared_within_a_group(texts: dict[str, str]) -> None:
    programs = {name: text.encode() for name, text in texts.items()}
    assert similarity(programs, groups=dict.fromkeys(programs, "group 1")).pairs == ()
