"""Overlaps of bodies, as a host asks for them."""
import pytest

import vblast_ss as vb

SETTINGS = {"segment_count": 20, "length": 0.02, "start": (-0.01, 0.0, 0.0)}
STICK = [vb.Capsule((0.0, 0.0, -0.01), (0.0, 0.0, 0.01), 2e-3)]


def test_an_overlap_is_told_and_asked_for():
    told = []
    with vb.Context(log=lambda level, text: told.append(text)) as context:
        scene = vb.Scene(context=context)
        stick = scene.add_rigid(STICK)
        thread = scene.add(vb.Thread(context=context, **SETTINGS))
        assert len(told) == 1 and f"overlaps body {stick}" in told[0]
        overlap = scene.overlap(thread)
        assert overlap.body == stick and overlap.depth > 2e-3


def test_an_overlap_is_refused_on_demand():
    with vb.Context() as context:
        scene = vb.Scene(context=context, overlap=vb.OverlapPolicy.REFUSE)
        scene.add_rigid(STICK)
        with pytest.raises(vb.OutOfRangeError, match="overlaps"):
            scene.add(vb.Thread(context=context, **SETTINGS))
