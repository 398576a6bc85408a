"""Locations that are suggested for a task bring its objects to its goals, or are not shown."""

from random import Random

import pytest

from tests.support_goals import SCENE, SCENE_TEXT, scene_of, task_of
from tests.support_programs import ran
from vrts.assignments.first_task import carryings, first_task
from vrts.assignments.new_files import new_program
from vrts.assignments.suggested import failure, suggested, what_came_of_it
from vrts.check.goals.placed import errors
from vrts.engine.memory.records import Ending, Lie
from vrts.pipeline.files import scene_names
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.scene.block import location_block
from vrts.scene.model import Mobility, Scene
from vrts.scene.things.symmetry import symmetries_of

BRICK = '[[goal]]\nobject = "brick"\non = "base1"\n'
SQUARE = SCENE_TEXT.replace("[70, 40, 80]", "[50, 50, 80]")
TURNED = SCENE_TEXT.replace("size_mm = [70, 40, 80]", "size_mm = [70, 40, 80]\nturn_deg = 30")


def setting_of(text: str, scene: Scene = SCENE) -> Setting:
    return Setting(scene, task_of(text, scene), ())


@pytest.mark.parametrize("scene_text", [SCENE_TEXT, SQUARE, TURNED])
@pytest.mark.parametrize("turn", [0, 90, 35, 180])
def test_a_brick_goes_to_its_goal_however_that_is_turned(scene_text: str, turn: int) -> None:
    scene = scene_of(scene_text)
    setting = setting_of(f"{BRICK}turn_deg = {turn}\n", scene)
    found = suggested(setting)
    (way,) = found.ways
    assert not found.missing
    pair = [(name, found.locations[name]) for name in (way.grip, way.put)]
    assert failure(setting, way.goal, way.choice, *pair) is None
    named = dict(found.refused)
    if way.put != "base1_put1" and turn != NEARLY:  # what the scene tells is not shown
        assert "turned" in named["base1_put1"]
        assert "base1_put1" not in found.locations
    assert (way.put == "base1_put1") is (turn in WELL[scene_text])


NEARLY = 35  # 5 degrees from how TURNED stands: allowed, but not what is suggested
WELL = {SCENE_TEXT: (0, 180), SQUARE: (0, 90, 180), TURNED: ()}


def test_what_was_tried_is_told() -> None:
    text = BRICK + 'turn_deg = 90\n[[goal]]\nobject = ["can1", "can2"]\non = ["base2", "base1"]\n'
    words = what_came_of_it(suggested(setting_of(text)))
    assert words[0].startswith("Each of these was tried")
    assert "brick_grip, brick_put: brick on base1" in words
    assert "can2_grip, base1_put2: can2 on base1" in words
    assert words[-1] == (
        "Not shown: base1_put1, with which `brick` is turned 90 degrees away from its goal"
    )


def test_a_label_counts_in_suggestions_too() -> None:
    plain = suggested(setting_of(BRICK + "turn_deg = 180\n"))
    assert plain.ways[0].put == "base1_put1"
    labelled = suggested(setting_of(BRICK + 'turn_deg = 180\nsymmetry = "none"\n'))
    assert labelled.ways[0].put == "brick_put"


def test_without_a_way_it_is_said_so() -> None:
    far = SCENE_TEXT.replace("at_mm = [900, -130]", "at_mm = [1650, -690]").replace(
        'kind = "table"\nat_mm = [1000, 0]\nsize_mm = [800, 1400]',
        'kind = "table"\nat_mm = [1300, 0]\nsize_mm = [1400, 1600]',
    )
    found = suggested(setting_of(BRICK, scene_of(far)))
    assert (found.ways, found.missing) == ((), ("brick on base1",))
    assert what_came_of_it(found)[-1] == "No way was found from above for: brick on base1"


def test_without_goals_the_locations_are_those_of_the_scene() -> None:
    path = '[[via]]\nname = "gate"\nat_mm = [850, 0, 200]\n'
    for setting in (Setting(SCENE, None, ()), setting_of(path)):
        assert suggested(setting).locations == SCENE.locations


def test_a_first_task_gets_full_marks_also_with_turned_bricks() -> None:
    scene = scene_of(TURNED)
    found = first_task("Bricks", "bricks", Setting(scene, None, ()))
    assert found is not None
    assert "turn_deg = 30" in found.task
    task = found.setting.task
    assert task is not None
    assert [goal.title for goal in task.goals] == ["brick on base1", "can1 on base2"]
    assert {c.turn for c in carryings(Setting(SCENE, None, ()))} == {0.0}


POST = """
[objects.post]
kind = "box"
at_mm = [900, -80]
on = "base1"
size_mm = [10, 10, 100]
"""


def test_a_place_of_the_scene_where_the_hand_hits_something_is_not_suggested() -> None:
    """The place is right for the brick, but a post stands where a finger opens."""
    given = "[locations]\nbase1_put = [900, -130, -160, 90, 90, 0]\n"
    scene = scene_of(SCENE_TEXT + POST + given)
    found = suggested(setting_of(BRICK, scene))
    assert [(way.grip, way.put) for way in found.ways] == [("brick_g2", "brick_put")]
    (why,) = [why for name, why in found.refused if name == "base1_put"]
    assert "hits `post`" in why
    assert carried_as_told(scene) == 6
    assert "base1_put1" not in scene.locations  # with the other grasp it would end turned


def test_a_first_task_leaves_out_what_cannot_be_done() -> None:
    alone = SCENE_TEXT[: SCENE_TEXT.index("[objects.can1]")]
    wide = scene_of(alone.replace("[70, 40, 80]", "[90, 90, 80]"))
    assert first_task("Bricks", "bricks", Setting(wide, None, ())) is None
    assert first_task("Bricks", "bricks", Setting(scene_of(alone + POST), None, ())) is not None


QUICK = ("cans-on-bases", "one-can-ur5")


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in QUICK else pytest.mark.thorough)
        for name in scene_names()
    ],
)
def test_a_new_program_can_be_run_and_what_its_scene_tells_carries_cans(name: str) -> None:
    scene = load_scene(name).scene
    assert ran(new_program("vrts verify it.v2", scene), scene).ending is Ending.COMPLETED
    assert carried_as_told(scene) >= (0 if name == "dish-on-stand" else 1)


CARRY = (
    ".PROGRAM main\nOPENI\nMOVE safe\nAPPRO {0}, 120\nMOVES {0}\nCLOSEI\nDEPARTS 120\nMOVE safe\n"
    "APPRO {1}, 120\nSPEED 20\nMOVES {1}\nOPENI\nDEPARTS 120\n.END\n"
)


def carried_as_told(scene: Scene) -> int:
    """Carry every object from its grasp to the places of bases; return how many were tried."""
    count = 0
    movable = [
        b for b in scene.bodies if b.mobility is Mobility.MOVABLE and b.kind in ("can", "box")
    ]  # whose grasps are worked out
    for number, body in enumerate((b for b in movable if f"{b.name}_grip" in scene.locations), 1):
        for base in (b for b in scene.bodies if b.kind == "base"):
            put = next(
                (
                    n
                    for n in (f"{base.name}_put", f"{base.name}_put{number}")
                    if n in scene.locations
                ),
                None,
            )
            if put is None:
                continue
            text = CARRY.format(f"{body.name}_grip", put) + location_block(scene.locations)
            end = ran(text, scene)
            last = end.placements[body.name][-1]
            assert (last.lie, last.support) == (Lie.RESTING, base.name), (body.name, put)
            x, y, _ = base.X_WO.translation
            wanted = body.X_WO._replace(translation=(x, y, last.X.translation[2]))
            alike = min(errors(symmetries_of(body).upright(), last.X, wanted))
            assert alike.position_mm < 1
            assert min(e.orientation_deg for e in errors(symmetries_of(body), last.X, wanted)) < 1
            count += 1
    return count


def random_scene(seed: int) -> Scene:
    """Return the workspace with things of other sizes that are turned at random."""
    chance = Random(seed)
    text = SCENE_TEXT.replace(
        "size_mm = [70, 40, 80]",
        f"size_mm = [{chance.choice((40, 60, 75))}, {chance.choice((40, 60))}, 80]\n"
        f"turn_deg = {chance.randrange(-180, 180)}",
    )
    return scene_of(text.replace("[900, 130]", f"[{chance.randrange(800, 1000)}, 130]"))


@pytest.mark.parametrize(
    "seed", [0, 1, *(pytest.param(k, marks=pytest.mark.thorough) for k in range(2, 30))]
)
def test_a_thing_that_is_carried_as_the_scene_tells_looks_as_before(seed: int) -> None:
    assert carried_as_told(random_scene(seed)) >= 4
