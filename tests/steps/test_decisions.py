"""Filters only save work: without them the bytes are the same, and what they leave to exact arithmetic is linear."""

import families
import numpy as np
import pytest

from exactmesh.claims.ledger import judge
from exactmesh.claims.run import Run
from exactmesh.geometry import balls, columns
from exactmesh.geometry.decisions import decisions, forget, note
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.steps import trapezoidation

KINDS = ("growth", "star", "grid")


def outcome(pslg):
    """Return the bytes of the mesh, and all that the step checkers say."""
    run = Run(pslg)
    said = [(j.claim.id, j.verdict) for j in judge(run)]
    return json_from_mesh(run.mesh), said


@pytest.mark.parametrize("kind", KINDS)
def test_without_floats_everything_is_the_same(kind, monkeypatch):
    pslg = families.random_simple_polygon(40, 1, kind)
    expected = outcome(pslg)
    blind = lambda *values: balls.Balls(np.zeros(len(values)), np.full(len(values), np.inf))  # noqa: E731
    monkeypatch.setattr(columns, "ball_of", blind)
    monkeypatch.setattr(trapezoidation, "column_of", lambda values: blind(*values))
    forget()
    assert outcome(pslg) == expected
    counts = decisions()
    for what in ("one-sided", "quad", "turn", "offset thickness", "extreme vertex", "face feature"):
        assert counts[what].exactly > 0 == counts[what].by_floats


def counted(count, kind):
    run = Run(families.random_simple_polygon(count, 7, kind))
    forget()
    assert all(j.verdict.holds for j in judge(run))
    return decisions()


@pytest.mark.parametrize("kind", KINDS)
def test_exact_decisions_are_linear(kind):
    small, large = counted(250, kind), counted(1000, kind)
    for what, count in large.items():
        # Four times the vertices; random polygons differ, and small counts more so.
        assert count.exactly <= 6 * (small[what].exactly if what in small else 0) + 60, what


@pytest.mark.parametrize("kind", ["growth", "star"])
def test_floats_decide_nearly_all_choices(kind):
    counts = counted(1000, kind)
    for what in ("one-sided", "quad", "place in the sweep", "extreme vertex", "offset thickness"):
        count = counts[what]
        assert count.exactly <= (count.by_floats + count.exactly) / 20, what


def test_counts_add_up():
    forget()
    note("this", 10, 3)
    note("this", 5, 0)
    assert (decisions()["this"].by_floats, decisions()["this"].exactly) == (12, 3) and list(decisions()) == ["this"]
    forget()
    assert decisions() == {}
