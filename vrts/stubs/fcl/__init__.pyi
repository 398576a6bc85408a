import numpy as np
import numpy.typing as npt

class CollisionGeometry: ...

class Box(CollisionGeometry):
    def __init__(self, x: float, y: float, z: float) -> None: ...

class Cylinder(CollisionGeometry):
    def __init__(self, radius: float, lz: float) -> None: ...

class Convex(CollisionGeometry):
    def __init__(
        self, verts: npt.NDArray[np.float64], num_faces: int, faces: npt.NDArray[np.int32]
    ) -> None: ...

class Transform:
    def __init__(
        self,
        rotation: npt.NDArray[np.float64] = ...,
        translation: npt.NDArray[np.float64] = ...,
    ) -> None: ...

class CollisionObject:
    def __init__(self, geometry: CollisionGeometry, transform: Transform) -> None: ...
    def setTransform(self, transform: Transform) -> None: ...

class DistanceRequest:
    def __init__(
        self, enable_nearest_points: bool = ..., enable_signed_distance: bool = ...
    ) -> None: ...

class DistanceResult:
    min_distance: float
    nearest_points: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]
    def __init__(self) -> None: ...

def distance(
    first: CollisionObject,
    second: CollisionObject,
    request: DistanceRequest,
    result: DistanceResult,
) -> float: ...
