"""Where the hand grips and sets down, fixed to objects."""

import pytest

from vrts.base.pose import IDENTITY, Pose
from vrts.live.session.views.places import places_of
from vrts.pipeline.scenes import load_scene


def test_places_go_with_their_objects() -> None:
    scene = load_scene("cans-on-bases").scene
    places = {place.name: place for place in places_of(scene)}
    assert set(places) == set(scene.locations)
    assert (places["can1_grip"].body, places["safe"].body) == ("can1", "")
    assert all(p.body.startswith("base") for name, p in places.items() if name.endswith("_put"))
    for name, place in places.items():
        X_OT = Pose(place.X[:9], place.X[9:])  # type: ignore[arg-type]
        frames = [body.X_WO for body in scene.bodies if body.name == place.body]
        X_WT = (frames[0] if frames else IDENTITY) @ X_OT
        assert X_WT.translation == pytest.approx(scene.locations[name].translation, abs=1e-8)
