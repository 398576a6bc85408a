from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

class SE3:
    rotation: Array
    translation: Array
    def __init__(self, rotation: Array, translation: Array) -> None: ...
    @staticmethod
    def Identity() -> SE3: ...
    def __mul__(self, other: SE3) -> SE3: ...
    def actInv(self, other: SE3) -> SE3: ...

class Motion:
    vector: Array

class JointModelRZ: ...

class FrameType:
    OP_FRAME: FrameType

class Frame:
    def __init__(
        self, name: str, joint: int, parent: int, placement: SE3, kind: FrameType
    ) -> None: ...

class ReferenceFrame:
    LOCAL: ReferenceFrame
    LOCAL_WORLD_ALIGNED: ReferenceFrame

class Data:
    oMf: Any

class Model:
    nq: int
    def addJoint(self, parent: int, joint: JointModelRZ, placement: SE3, name: str) -> int: ...
    def addFrame(self, frame: Frame) -> int: ...
    def createData(self) -> Data: ...
    def getFrameId(self, name: str) -> int: ...

def buildModelFromUrdf(path: str) -> Model: ...
def log6(placement: SE3) -> Motion: ...
def framesForwardKinematics(model: Model, data: Data, q: Array) -> None: ...
def computeFrameJacobian(
    model: Model, data: Data, q: Array, frame: int, reference: ReferenceFrame
) -> Array: ...
