"""Merge regions of the Interior where a face keeps too little: coarse chords, without a sweep of their own.

In      the Interior as made from all trapezoids, region by region; `Offset`, `Trapezoidation`, all points.
Out     `Patch`: the same but for clusters of regions that are triangulated together (`bands.py`).
Exact   faces are measured exactly; a cluster takes the place of its regions only when it keeps more than they did.
Check   `patch_check.py`

A trapezoid one level high, with many T-vertices on one side and an empty chord on the other, keeps a fifth of a level
and no more. Here the regions on both sides of that chord become one, the chord is left out, and T-vertices that face it
are two levels or more from the next one. A cluster grows, across the sides that hem it in, until every part is good.
Trapezoids elsewhere stay as they are, so there are few clusters, and most of them are two regions.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise

from gmpy2 import mpq

from exactmesh.geometry.columns import Columns
from exactmesh.geometry.face_columns import Corners, FaceColumns, features_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.steps.balance import Balance
from exactmesh.steps.bands import Band, Ground, triangulate_band
from exactmesh.steps.records import Cycle, Offset, Patch, Trapezoidation

# A cluster grows by at most so many steps; the sides that are tried when none hems it in.
_STEPS = 12
_LONGEST_SIDES = 3


def merged_where_thin(patch: Patch, face_counts: Sequence[int], offset: Offset, chords: Trapezoidation,
                      points: Sequence[Point], balance: Balance) -> Patch:
    """Return the Interior with clusters where faces keep less than the balance wants.

    `face_counts` are the numbers of faces of the regions, in the order of the faces.
    """
    places = [*points, *patch.points]
    region_of = [number for number, count in enumerate(face_counts) for _ in range(count)]
    thin = sorted({region_of[face] for face in _thin_faces(patch, places, balance.feature_squared)})
    if not thin:
        return patch
    faces: list[list[Cycle]] = [[] for _ in face_counts]
    for number, face in zip(region_of, patch.faces, strict=True):
        faces[number].append(face)
    edges_at = _edges_at(offset, chords, patch)
    clusters = _Clusters(faces, Ground(places, edges_at, balance.level, balance.feature_squared))
    # Once more at the end: what failed may succeed when its neighbours have become clusters.
    for region in (*thin, *thin):
        clusters.mend(region)
    return clusters.patch(patch)


def _thin_faces(patch: Patch, places: Sequence[Point], wanted_squared: mpq) -> list[int]:
    """Return the faces that keep less than what is wanted, in order."""
    columns, faces = Columns(places), FaceColumns(patch.faces)
    corners = Corners(columns, faces)
    found = [int(face) for face in corners.bad]
    for numbers, values in features_squared(columns, faces, corners):
        doubtful = numbers[~(values.low() > float(wanted_squared) * (1 + 2.0**-40))]
        found += [int(face) for face in doubtful if _feature_squared(places, patch.faces[face]) < wanted_squared]
    return sorted(set(found))


def _feature_squared(places: Sequence[Point], cycle: Cycle) -> mpq:
    """Return the squared feature size of a face, zero when it is no triangle."""
    corners = corners_of(places, cycle)
    return mpq(0) if isinstance(corners, NotTriangle) else face_feature_squared(places, cycle, corners)


def _edges_at(offset: Offset, chords: Trapezoidation, patch: Patch) -> dict[int, set[int]]:
    """Return the edges of Q that vertices lie on."""
    found: dict[int, set[int]] = defaultdict(set)
    for k, following in enumerate(offset.successors()):
        found[offset.first + k].add(k)
        found[offset.first + following].add(k)
    for edge, v in chain(zip(chords.edge, range(chords.first, chords.first + len(chords.edge)), strict=True),
                         patch.on_edge):
        found[v].add(edge)
    return found


class _Cluster:
    """Some regions as one polygon, a counter-clockwise cycle."""

    def __init__(self, regions: frozenset[int], cycle: Sequence[int], band: Band | None) -> None:
        self.regions, self.cycle, self.band = regions, cycle, band

    @property
    def value(self) -> mpq:
        """The least squared feature size of its faces, zero where there are none."""
        return self.band.value if self.band is not None else mpq(0)


class _Clusters:
    """The regions by number; `cluster_of` has those that are in a cluster that takes their place."""

    def __init__(self, faces: Sequence[Sequence[Cycle]], ground: Ground) -> None:
        self.faces, self.ground = faces, ground
        self.outline = [_boundary(side for face in some for side in _sides(face)) if some else None for some in faces]
        self.region_at = {side: number for number, cycle in enumerate(self.outline) if cycle for side in _sides(cycle)}
        self.cluster_of: dict[int, _Cluster] = {}

    def mend(self, region: int) -> None:
        """Put a cluster in the place of a thin region, if one is found that keeps more."""
        outline = self.outline[region]
        known = self.cluster_of.get(region)
        if outline is None or (known is not None and known.value >= self.ground.wanted_squared):
            return
        cluster: _Cluster | None = known or _Cluster(frozenset([region]), outline,
                                                     triangulate_band(self.ground, outline))
        best, kept = None, known.value if known is not None else self._kept(region)
        for _ in range(_STEPS):
            if cluster is None:
                break
            if cluster.value > kept:
                best, kept = cluster, cluster.value
                if kept >= self.ground.wanted_squared:
                    break
            cluster = next(self._grown(cluster), None)
        if best is not None:
            for number in best.regions:
                self.cluster_of[number] = best

    def patch(self, patch: Patch) -> Patch:
        """Return the Interior with the clusters in it, and without the vertices that none of its faces has."""
        places = self.ground.points
        bands = [(cluster, cluster.band) for cluster in dict.fromkeys(self.cluster_of.values()) if cluster.band]
        faces = [face for number, some in enumerate(self.faces) if number not in self.cluster_of for face in some]
        on_edge = list(patch.on_edge)
        new: list[Point] = list(patch.points)
        for _, band in bands:
            by = patch.first + len(new) - len(places)
            faces += [tuple(v if v < len(places) else v + by for v in face) for face in band.faces]
            on_edge += [(edge, v + by) for edge, v in band.feet]
            new += band.new
        used = {v for face in faces for v in face if v >= patch.first}
        number = {v: patch.first + i for i, v in enumerate(sorted(used))}
        return Patch(patch.first, tuple(new[v - patch.first] for v in number),
                     tuple(tuple(number.get(v, v) for v in face) for face in faces),
                     tuple((edge, number[v]) for edge, v in on_edge))

    def _kept(self, region: int) -> mpq:
        return min(_feature_squared(self.ground.points, face) for face in self.faces[region])

    def _grown(self, cluster: _Cluster) -> Iterator[_Cluster]:
        """Yield a cluster with what lies beyond a side that hems it in, then beyond one of the longest level sides, if
        it can be triangulated."""
        places = self.ground.points
        narrow = cluster.band.narrow if cluster.band is not None else ()
        level = [side for side in _sides(cluster.cycle) if places[side[0]].y == places[side[1]].y]
        level.sort(key=lambda side: abs(places[side[0]].x - places[side[1]].x), reverse=True)
        for u, v in (*narrow, *level[:_LONGEST_SIDES]):
            beyond = self.region_at.get((v, u))
            if beyond is None or beyond in cluster.regions:
                continue
            # A cluster that was found earlier may have some of these regions, but not as a whole.
            regions, cycle = self._whole(beyond)
            if regions & cluster.regions:
                continue
            joined = _boundary(chain(_sides(cluster.cycle), _sides(cycle)))
            if joined is not None and (band := triangulate_band(self.ground, joined)) is not None:
                yield _Cluster(cluster.regions | regions, joined, band)

    def _whole(self, region: int) -> tuple[frozenset[int], Sequence[int]]:
        """Return the cluster a region is in, else the region itself."""
        if region in self.cluster_of:
            return self.cluster_of[region].regions, self.cluster_of[region].cycle
        return frozenset([region]), self.outline[region] or ()


def _sides(cycle: Sequence[int]) -> list[tuple[int, int]]:
    return list(pairwise((*cycle, cycle[0])))


def _boundary(sides: Iterable[tuple[int, int]]) -> list[int] | None:
    """Return the one cycle of the sides that have no twin; None when they are not one simple cycle."""
    every = set(sides)
    following = {u: v for u, v in every if (v, u) not in every}
    lonely = sum((v, u) not in every for u, v in every)
    start = next(iter(following), None)
    if start is None or lonely != len(following):
        return None
    cycle = [start]
    while (v := following.get(cycle[-1], start)) != start:
        cycle.append(v)
    return cycle if len(cycle) == len(following) else None
