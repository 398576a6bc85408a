"""Contacts that only some future shows are found, with the scenario that shows them."""

from tests.support_programs import cans, compiled, program
from tests.unit.prove.explore.proofs import only
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Afterwards, Again, Environment
from vrts.prove.proof import Proof, What, Wrong
from vrts.prove.prove import prove

SCENE = cans()
PLACES = {
    "grip": "800 -450 -225 90 90 0",
    "up": "800 -450 0 90 90 0",
    "put": "950 -130 -75 90 90 0",
    "away": "500 -450 0 90 90 0",
}
PICK = "OPENI\nMOVE up\nMOVES grip\nCLOSEI\nMOVES up\n"


def proven(body: str, environment: Environment | None = None, **asking: bool) -> Proof:
    module = compiled(program(body, PLACES))
    asked = Asking(collisions=asking.get("collisions", True))
    return prove(module, SCENE, environment or Environment(), asked, entry="main")


def test_two_inputs_that_lower_the_hand_together_are_found() -> None:
    body = "z = 0\nMOVE up\nIF SIG(1001) THEN\nz = z+60\nEND\nIF SIG(1002) THEN\nz = z+60\nEND\n"
    body += "DRAW 0, 0, -z-80\n"
    proof = proven(body)
    found = proof.found[0]
    assert found.wrong is Wrong.CONTACT
    assert {(d.number, d.value) for d in found.decisions} == {(1001, True), (1002, True)}
    assert found.cause is not None
    assert found.cause.step == 9
    run = execute(compiled(program(body, PLACES)), SCENE, found.scenario)
    assert check_collisions(SCENE, run).contacts
    assert proven(body, collisions=False).answer is Answer.HOLDS


def test_what_touches_in_no_future_holds_and_says_how_much_was_certified() -> None:
    proof = proven(PICK + "IF SIG(1001) THEN\nAPPRO put, 100\nMOVES put\nEND\nOPENI\nDEPARTS 50\n")
    wrong = [one for one in proof.found if one.wrong is Wrong.CONTACT]
    assert not wrong
    assert proof.covered.motion_s > 5.0


def test_a_loop_that_lowers_until_an_input_comes_is_found() -> None:
    body = "MOVE up\nWHILE SIG(-1001) DO\nDRAW 0, 0, -30\nBREAK\nEND\n"
    found = proven(body).found[0]
    assert found.wrong is Wrong.CONTACT
    assert found.decisions == (), "it never comes"


def test_a_location_that_drifts_from_execution_to_execution_is_found() -> None:
    body = "IF NOT DEFINED(z) THEN\nz = 0\nEND\nz = z+35\nMOVE up\nDRAW 0, 0, -z\nBREAK\n"
    assert proven(body, Environment(again=Again(2))).answer is Answer.HOLDS
    found = proven(body, Environment(again=Again(6))).found[0]
    assert found.wrong is Wrong.CONTACT
    assert {one.what for one in found.decisions} == {What.AGAIN}


def test_a_stop_after_which_the_hand_goes_another_way_is_found() -> None:
    body = "OPENI\nMOVE up\nBREAK\nDRAW 0, 300, 0\nDRAW 0, 0, -200\nBREAK\n"
    free = proven(body)
    stopped = proven(body, Environment(stops=frozenset({Afterwards.PROCEED})))
    told = [one for one in stopped.found if one.wrong is Wrong.CONTACT]
    assert free.answer is Answer.HOLDS
    assert told
    assert told[0].decisions[0].value == "stop"


def test_pads_may_press_into_what_they_grasp_and_not_into_what_is_left_standing() -> None:
    assert proven(PICK).answer is Answer.HOLDS
    other = "IF SIG(1001) THEN\nDRAW 0, 60, 0\nELSE\nCLOSEI\nEND"
    found = only(proven(PICK.replace("CLOSEI", other)))
    assert found.wrong is Wrong.CONTACT
    assert [one.value for one in found.decisions] == [True]
