"""Settings whose runs go by another controller model than their scene names."""

from dataclasses import replace

from vrts.base.diagnostic import Rule, error
from vrts.check.task.manifest import other_controller
from vrts.controllers.model import ControllerModel
from vrts.controllers.models import MODELS
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.report.plain import one_line
from vrts.scene.model import controlled

NO_CONTROLLER = Rule("V426", "no-controller")


def model_named(name: str) -> ControllerModel:
    """Return a controller model by its name.

    Raises:
        Refused: There is none.
    """
    model = MODELS.get(name)
    if model is None:
        headline = f"there is no controller model `{one_line(name)}`"
        raise Refused((error(NO_CONTROLLER, headline, help=(f"known are {', '.join(MODELS)}",)),))
    return model


def under(setting: Setting, name: str) -> Setting:
    """Return a setting under the controller model that something went by before.

    A model that was fitted is the setting's own, or is not had again: it has no name of its own.

    Raises:
        Refused: There is no such model.
    """
    if name == setting.scene.controller.name:
        return setting
    scene = controlled(setting.scene, model_named(name))
    return replace(setting, scene=scene, variants=tuple(under(v, name) for v in setting.variants))


def with_controller(setting: Setting, name: str | None) -> Setting:
    """Return a setting under a controller model; None: as it is.

    Under another model than the task is set in, marks do not count.

    Raises:
        Refused: There is no such model.
    """
    if name is None:
        return setting
    scene = controlled(setting.scene, model_named(name))
    stamps = setting.stamps
    if setting.task is not None:
        stamps += other_controller(setting.scene, scene)
    variants = tuple(with_controller(variant, name) for variant in setting.variants)
    return replace(setting, scene=scene, stamps=stamps, variants=variants)
