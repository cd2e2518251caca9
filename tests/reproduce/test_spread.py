"""The published construction's degradation grows with the length of a room; the repaired one's does not."""

import json
from itertools import pairwise

from gmpy2 import mpq

from exactmesh import mfs
from exactmesh.cli import main
from exactmesh.reproduce import spread


def rows():
    return list(spread.spread_rows(lambda step: None))


def test_every_room_has_mfs_one_or_so():
    for _, room in spread._FAMILIES:
        assert {mfs(room(length)).squared for length in spread.LENGTHS} <= {mpq(1), mpq(4, 5)}


def test_the_growth_is_linear_and_the_repair_is_flat():
    found = rows()
    for family in {row.family for row in found}:
        of_family = [row for row in found if row.family == family]
        long = [row for row in of_family if row.length >= 44]
        assert all(row.paper > 45**2 for row in long)
        assert all(a.paper < b.paper for a, b in pairwise(long))
        assert all(row.paper > row.length**2 for row in long)
        assert all(row.repaired <= mpq(108, 5) ** 2 for row in of_family)


def test_the_command_prints_both_forms(capsys):
    assert main(["reproduce", "spread", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)["spread"]
    assert len(printed) == 2 * len(spread.LENGTHS)
    assert [row["degradation_squared"]["paper"] for row in printed] == [str(row.paper) for row in rows()]
    assert main(["reproduce", "spread"]) == 0
    text = capsys.readouterr().out.splitlines()
    assert len(text) == 1 + len(printed) and "paper / L" in text[0]
