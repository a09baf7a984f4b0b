"""Diagnostic passes in multilayer files."""

import json

import numpy as np
import pytest
from building import link, material, quad
from gridgather import passes
from pictures import multilayer


def test_diagnostic_passes_tell_what_pixels_took(lit):
    link(quad("Wall", size=1), "Wall", location=(0, 0, 0.5), rotation_euler=(np.pi / 2, 0, 0))
    own = lit.view_layers[0].gridgather
    assert not any("Samples" in channel for channel in multilayer(lit))
    for name in passes.PROPERTIES:
        setattr(own, name, True)
    channels = multilayer(lit)
    found = {name: channels[f"ViewLayer.{name}.X"] for name in passes.enabled(lit.view_layers[0])}
    counts = json.loads(lit.gridgather_statistics)["ViewLayer"]["counts"]
    rays, senders = found["Visibility Samples"], found["Resampled Senders"]
    assert rays.sum() == counts["visibility rays"] + counts["near rays"] > 0
    assert found["Form Factor Samples"].sum() == counts["form factors"]
    assert 0 <= senders.min() and senders.max() <= counts["resampled senders"]
    on_surface = found["Surface Sites"]
    assert 0 <= on_surface.min() and on_surface.max() <= 1
    lines = found["Cell Lines"]
    assert set(np.unique(lines)) == {0, 1} and 0.05 < lines.mean() < 0.8
    judged = ("Threshold Elevation", "Adaptation Luminance", "Site Threshold")
    assert not any(found[name].any() for name in judged)


def test_perception_passes_tell_what_an_eye_sees(lit):
    dark = quad("Dark", size=1)
    dark.materials.append(material("Dark", (0.02, 0.02, 0.02)))
    link(dark, "Dark", location=(0, 0, 0.1))
    own, settings = lit.view_layers[0].gridgather, lit.gridgather
    own.use_threshold_elevation = own.use_adaptation_luminance = own.use_site_threshold = True
    settings.use_perception, settings.display_white, settings.display_black = True, 200, 1

    def found():
        return [multilayer(lit)[f"ViewLayer.{name}.X"] for name in passes.enabled(lit.view_layers[0])]

    elevation, adaptation, threshold = found()
    assert 1 <= elevation.min() < 0.5 * elevation.max() <= 5
    assert 0.9 < adaptation.min() < adaptation.max() < 201.1
    assert threshold.min() > 0
    settings.use_masking = False
    unmasked, _, lower = found()
    assert (unmasked == 1).all()
    assert (threshold > 0.999 * lower).all() and (threshold > 1.2 * lower).any()
    settings.noticeable *= 2
    assert found()[2].mean() == pytest.approx(2 * lower.mean(), rel=0.1)


def test_passes_stay_with_their_view_layer(lit):
    second = lit.view_layers.new("Second")
    second.gridgather.use_cell_lines = True
    channels = multilayer(lit)
    assert [name for name in channels if "Cell Lines" in name] == ["Second.Cell Lines.X"]
    lit.gridgather.method = "SOLUTION"
    second.gridgather.use_visibility_samples = True
    assert not multilayer(lit)["Second.Visibility Samples.X"].any()
