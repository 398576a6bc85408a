from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

def lfilter(
    b: Sequence[float], a: Sequence[float], x: npt.NDArray[np.float64], axis: int = ...
) -> npt.NDArray[np.float64]: ...
