"""Tests of the Python binding. Every call of a C function is noted: the last test asks whether one is missing."""
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINDING = ROOT / "bindings" / "python"
sys.path[:0] = [str(BINDING), str(pathlib.Path(__file__).resolve().parent)]

CALLED = set()


def noted(name, function):
    def call(*arguments):
        CALLED.add(name)
        return function(*arguments)
    return call


def pytest_configure(config):
    from vblast_ss._api import FUNCTIONS
    from vblast_ss._library import lib
    for name in FUNCTIONS:
        setattr(lib, name, noted(name, getattr(lib, name)))


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: "test_every_function" in item.nodeid)


@pytest.fixture
def called():
    return CALLED


@pytest.fixture
def context():
    import vblast_ss as vb
    with vb.Context() as made:
        yield made
