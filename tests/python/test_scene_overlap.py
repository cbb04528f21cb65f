"""Overlaps of bodies, as a host asks for them."""
import pytest

import vblast_ss as vb

SETTINGS = {"segment_count": 20, "length": 0.02, "start": (-0.01, 0.0, 0.0)}
STICK = [vb.Capsule((0.0, 0.0, -0.01), (0.0, 0.0, 0.01), 2e-3)]


def test_an_overlap_causes_a_warning_and_can_be_queried():
    warnings = []
    with vb.Context(log=lambda level, text: warnings.append(text)) as context:
        scene = vb.Scene(context=context)
        stick = scene.add_rigid(STICK)
        thread = scene.add(vb.Thread(context=context, **SETTINGS))
        assert len(warnings) == 1 and f"overlaps body {stick}" in warnings[0]
        overlap = scene.overlap(thread)
        assert overlap.body == stick and overlap.depth > 2e-3


def test_an_overlap_is_refused_by_policy():
    with vb.Context() as context:
        scene = vb.Scene(context=context, overlap=vb.SceneOverlapPolicy.REFUSE)
        scene.add_rigid(STICK)
        with pytest.raises(vb.OutOfRangeError, match="overlaps"):
            scene.add(vb.Thread(context=context, **SETTINGS))
