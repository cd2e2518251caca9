"""A short campaign over the readers, and what the long ones found."""

import json

import pytest
from fuzz_readers import READERS, outcome, run, samples
from hypothesis import given, settings
from hypothesis import strategies as st

# Found by the campaign: seed and number, and the bytes cut down to what matters.
FOUND: dict[str, tuple[str, str | bytes]] = {
    "seed 6, dissection 7981: a control character in an unknown key was shown as it is": (
        "dissection", '{"format": "exactmesh-dissection/1", "scales": [], "pieces": [{"polygons": [], "motions": '
        '[{"matrix": [], "transla\x85ion": []}]}]}'),
    "seed 5, dxf 7: a line of the file in the refusal ended with a line feed": (
        "dxf", "0\nSECTION\n2\nENTITIES\nLINE\n0\n"),
    "seed 5, dxf 63: an infinite count was an OverflowError": (
        "dxf", "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n1e309\n70\n1\n10\n1\n20\n1\n0\nENDSEC\n0\nEOF\n"),
    "seed 1, wkb 6468: the refusal ended with a line feed": (
        "wkb", b"\x01\x02\0\0\0\x01\0\0\0" + bytes(16)),
    "seed 4, wkb 5166: a curve was a NotImplementedError": ("wkb", b"\x01\x09" + bytes(8) + b"1"),
    "by reading the code: the short cut for written files went too deep": (
        "pslg", '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": ['
        + "[" * 10**5 + "0, 1" + "]" * 10**5 + "]}"),
}
_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8) | st.sampled_from(["1/3", "-0.5e2"]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(
        st.sampled_from(["type", "coordinates", "vertices", "edges", "faces", "geometry", "features", "name"]), inner,
        max_size=3), max_leaves=12)


@pytest.mark.parametrize("what", FOUND)
def test_what_was_found_is_read_or_refused(what: str) -> None:
    name, found = FOUND[what]
    assert outcome(name, found if isinstance(found, bytes) else found.encode())[0] in ("read", "refused")


@pytest.mark.parametrize("name", READERS)
def test_samples_are_read(name: str) -> None:
    assert {outcome(name, data)[0] for data in samples(name)} == {"read"}


def test_a_short_campaign_finds_nothing() -> None:
    faults, table = run(1, 3300, list(READERS))
    assert not faults, faults[0]
    for line in table.splitlines()[1:-1]:
        count, read, refused, reasons = map(int, line.split()[:4])
        assert count == read + refused == 300 and read > 5 and reasons > 4


def test_faults_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(data: bytes) -> str:
        raise {0: RuntimeError("x"), 1: MemoryError(), 2: AssertionError()}[len(data) % 3]

    monkeypatch.setitem(READERS, "wkt", wrong)
    faults, table = run(1, 9, ["wkt"])
    assert len(faults) == 9 and "9 FAULTS" in table
    monkeypatch.setattr("fuzz_readers.SECONDS", 0.01)

    def endless(data: bytes) -> str:
        while True:
            pass

    monkeypatch.setitem(READERS, "wkt", endless)
    assert outcome("wkt", b"")[1].startswith("TooSlow")


def test_campaigns_can_be_repeated() -> None:
    first, again = (run(3, 70, ["geojson", "poly"])[1] for _ in range(2))
    assert [line.split()[:5] for line in first.splitlines()] == [line.split()[:5] for line in again.splitlines()]


@settings(max_examples=60)
@given(st.sampled_from(list(READERS)), st.sampled_from(["format", "type"]), st.data())
def test_values_of_any_shape_are_read_or_refused(name: str, key: str, data: st.DataObject) -> None:
    names = ["exactmesh-pslg/1", "exactmesh-mesh/1", "exactmesh-dissection/1", "Polygon", "Feature", "MultiPoint"]
    value = data.draw(st.dictionaries(st.sampled_from(
        ["vertices", "edges", "faces", "holes", "kind", "coordinates", "geometries", "pieces", "scales"]), _VALUES))
    text = json.dumps({key: data.draw(st.sampled_from(names)), **value})
    kind, what = outcome(name, text.encode())
    assert kind != "FAULT", what
