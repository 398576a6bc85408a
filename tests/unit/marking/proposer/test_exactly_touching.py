"""A run in which shapes touch exactly: python-fcl ends its process there, and the check goes on."""

from tests.adversary.__main__ import rounded
from tests.exactly_touching import touching
from vrts.check.collision.collision import check_collisions
from vrts.geometry.proposing.nobody import Nobody
from vrts.marking.proposer.by_fcl import ByFcl


def test_who_gives_the_second_opinion_may_die_of_it() -> None:
    scene, record = touching()
    alone = check_collisions(scene, record)
    assert (alone.contacts, alone.undetermined) == ((), ())
    assert alone.clearance is not None
    assert abs(alone.clearance.distance_m) < 1e-6
    with ByFcl() as fcl:
        found = check_collisions(scene, record, second=fcl)
        assert fcl.deaths > 0, "it does not die of this any more: look for another touch"
    assert found == alone


def test_so_may_who_proposes() -> None:
    scene, record = touching()
    own = check_collisions(scene, record, proposer=Nobody())
    with ByFcl() as fcl:
        found = check_collisions(scene, record, proposer=fcl)
        assert fcl.deaths > 0
    assert rounded(found, moments=False) == rounded(own, moments=False)
    assert found.certified
