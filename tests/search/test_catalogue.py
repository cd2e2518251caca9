"""Every find that comes along is judged again, and stands with its command in the documentation."""

import json
from pathlib import Path

import pytest

from exactmesh.search.catalogue import CATALOGUE
from exactmesh.search.recheck import checked

DOCS = Path(__file__).parents[2] / "docs" / "search.md"


@pytest.mark.parametrize("name", CATALOGUE.names())
def test_a_find_is_what_it_says(name: str) -> None:
    find = json.loads(CATALOGUE.path(name).read_text())
    assert find["format"] == "exactmesh-find/1" and find["name"] == name
    assert find["outcome"] == {"violation": "violated", "record": "holds"}[find["label"]]
    assert checked(find).agrees
    text = DOCS.read_text()
    assert find["command"] in text and name in text and find["worst"] in text


def test_the_catalogue_has_what_searches_are_to_rediscover() -> None:
    finds = [json.loads(CATALOGUE.path(name).read_text()) for name in CATALOGUE.names()]
    violated = {find["target"][0] for find in finds if find["outcome"] == "violated"}
    assert violated >= {"appendix-a.offset-edge-length", "theorem-1.degradation", "section-2.p5-feature-size"}
    assert any(find["target"][0] == "repaired.degradation" and find["label"] == "record" for find in finds)
    assert any(find["target"][0] == "appendix-a.offset-edge-length" and len(find["figure"]) == 3 for find in finds)
