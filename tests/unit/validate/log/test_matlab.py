"""Arrays of MATLAB as logs."""

import struct
import zlib
from functools import cache
from io import BytesIO

import numpy as np
import pytest
import scipy.io

from tests.unit.validate.support import path_run
from vrts.base.diagnostic import Diagnostic
from vrts.base.units import DEG, MM
from vrts.pipeline.refused import Refused
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.log.matlab import MOST_UNPACKED
from vrts.validate.sampling import extent_of, sampled

TIMES = np.arange(0.0, 16.5, 0.05)


@cache
def saved(packed: bool = True) -> bytes:
    """Return the closed path as MATLAB saves it, with a matrix, columns, rows and other things."""
    samples = sampled(path_run(), TIMES)
    stream = BytesIO()
    variables = {
        "t": TIMES,
        "jt": np.rad2deg(samples.joints),
        "x": (samples.positions[:, 0] / MM)[:, None],
        "y": samples.positions[:, 1] / MM,
        "z": samples.positions[:, 2] / MM,
        "gain": 3.5,
        "who": "us",
        "parts": {"a": 1.0},
    }
    scipy.io.savemat(stream, variables, do_compression=packed)
    return stream.getvalue()


def read(data: bytes) -> RobotLog:
    return read_log(GivenLog("run.mat", (data,)), extent_of(path_run()))


def refused(data: bytes) -> Diagnostic:
    with pytest.raises(Refused) as caught:
        read(data)
    return caught.value.diagnostics[0]


@pytest.mark.parametrize("packed", [False, True])
def test_arrays_are_columns(packed: bool) -> None:
    log = read(saved(packed))
    expected = sampled(path_run(), TIMES)
    assert log.joints is not None
    assert log.positions is not None
    assert np.abs(log.joints - expected.joints).max() < 1e-9 * DEG
    assert np.abs(log.positions - expected.positions).max() < 1e-9
    assert (log.times == TIMES).all()


def test_the_newest_form_says_what_to_do() -> None:
    found = refused(b"MATLAB 7.3 MAT-file, Platform: GLNXA64" + bytes(90))
    assert found.notes == ("it is of version 7.3 (HDF5); `save -v7` writes one that is read",)


def test_a_variable_that_unpacks_to_too_much_is_refused() -> None:
    inner = struct.pack("<II", 14, 2 * MOST_UNPACKED)
    squeezed = zlib.compressobj(1)
    packed = squeezed.compress(inner)
    for _ in range(3 * MOST_UNPACKED // 10**8):
        packed += squeezed.compress(bytes(10**8))
    packed += squeezed.flush()
    data = saved()[:128] + struct.pack("<II", 15, len(packed)) + packed
    assert len(data) < 5_000_000
    assert "unpacks to more than" in refused(data).notes[0]


def test_a_damaged_file_is_read_or_refused() -> None:
    random = np.random.default_rng(7)
    codes: list[str] = []
    for packed in (False, True):
        for _ in range(40):
            data = bytearray(saved(packed))
            at = int(random.integers(124, len(data)))
            if random.integers(0, 2):
                data[at : at + 4] = random.bytes(4)
            else:
                del data[at:]
            try:
                read(bytes(data))
            except Refused as problem:
                codes.append(problem.diagnostics[0].rule.code)
    assert len(codes) > 20
    assert all(code.startswith("V88") for code in codes)
