"""What is only a guess is left to people: a name may have its value from the controller."""

from vrts.pipeline.compiling.fixing import fix_bytes


def test_names_that_are_like_others_are_not_mended() -> None:
    data = b".PROGRAM m\nheight2 = 5\nTYPE height2, height1\nMOVE part1\n.END\n"
    data += b".LOCATIONS\npart2 600 100 -200 90 90 0\n.END\n"
    found = fix_bytes(data, "a.v2")
    assert (found.data, found.applied) == (data, ())
    assert {"V204", "V205"} <= {diagnostic.rule.code for diagnostic in found.left}
