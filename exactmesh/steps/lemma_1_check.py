"""Check Lemma 1 and the words before it on the trapezoids of P5; `lemma_1.py` is not imported.

Every trapezoid is brought into the text's position, the shorter parallel side below: `Figure`. R is the rectangle over
that side, P the parallelogram that it sweeps along the left leg where R does not fit. Values are ratios of squares.

Centre     the centre of R, or of P, halves the feature size exactly.
Slant      mfs(P) = min(h, l h / sqrt(a^2 + h^2)), a being what the legs of P lean over.
Case 1, 2  mfs(H) = min(h, l) where R fits into H, mfs(H) = mfs(P) where not.
Sides      in case 1 the centre of R is farther than l/2 from the legs.
Lemma      in a trapezoid without T-vertices the four triangles around the new vertex keep half of mfs(H).

T-vertices are left out of account but in the last clause, which needs that there are none.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared, face_witness
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges
from exactmesh.steps.records import Patch, Trapezoid, Trapezoidation

_HALVED = mpq(1, 4)


@dataclass(frozen=True, slots=True)
class Figure:
    """A trapezoid: the shorter side from (0, 0) to (`short`, 0), the longer one from (`shift`, `height`) on.

    It is mirrored where that is needed to make `shift` positive when R does not fit.
    """

    short: mpq
    long: mpq
    shift: mpq
    height: mpq

    @property
    def fits(self) -> bool:
        """Whether R lies in H: case 1 of the lemma."""
        return bool(self.shift <= 0)

    def trapezoid(self) -> list[Point]:
        """Return the corners of H."""
        return _quad(self.short, self.long, self.shift, self.height)

    def inner(self) -> list[Point]:
        """Return the corners of R in case 1, of P in case 2."""
        return _quad(self.short, self.short, max(self.shift, mpq(0)), self.height)


def figure(bottom: tuple[mpq, mpq], top: tuple[mpq, mpq], height: mpq) -> Figure:
    """Return a trapezoid between two horizontal sides, given by the abscissae of their ends, in the text's position."""
    short, long = (top, bottom) if top[1] - top[0] < bottom[1] - bottom[0] else (bottom, top)
    at_left, at_right = long[0] - short[0], short[1] - long[1]
    return Figure(short[1] - short[0], long[1] - long[0], max(at_left, at_right), height)


def quadrilaterals(chords: Trapezoidation, points: Sequence[Point]) -> Iterator[tuple[int, Trapezoid, Figure]]:
    """Yield the trapezoids with four corners, numbered."""
    for number, z in enumerate(chords.trapezoids):
        bl, br, tr, tl = (points[v] for v in (z.bl, z.br, z.tr, z.tl))
        if bl != br and tl != tr:
            yield number, z, figure((bl.x, br.x), (tl.x, tr.x), tl.y - bl.y)


def check_centre(chords: Trapezoidation, points: Sequence[Point], fits: bool) -> Verdict:
    """Return the verdict on what the centre of R (`fits`), or of P, does to the squared feature size."""
    tally = Tally("the centre halves the feature size", "==", _HALVED)
    for number, _, h in quadrilaterals(chords, points):
        if h.fits == fits:
            corners = h.inner()
            centre = Point((corners[0].x + corners[2].x) / 2, h.height / 2)
            fan = [*corners, centre]
            least = min(_feature(fan, (i, (i + 1) % 4, 4)) for i in range(4))
            tally.see(least / _own_feature(corners), trapezoid=number)
    return tally.verdict()


def check_slant(chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the formula for the squared mfs of the parallelogram P."""
    tally = Tally("mfs(P) = min(h, l h / sqrt(a^2 + h^2))", "==", mpq(1))
    for number, _, h in quadrilaterals(chords, points):
        if not h.fits:
            height, across = h.height**2, (h.short * h.height) ** 2 / (h.shift**2 + h.height**2)
            tally.see(_own_feature(h.inner()) / min(height, across), trapezoid=number)
    return tally.verdict()


def check_case_1(chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on mfs(H) = min(h, l) where R fits."""
    tally = Tally("mfs(H) = min(h, l)", "==", mpq(1))
    for number, _, h in quadrilaterals(chords, points):
        if h.fits:
            tally.see(_own_feature(h.trapezoid()) / min(h.height, h.short) ** 2, trapezoid=number)
    return tally.verdict()


def check_case_2(chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on mfs(H) = mfs(P) where R does not fit."""
    tally = Tally("mfs(H) = mfs(P)", "==", mpq(1))
    for number, _, h in quadrilaterals(chords, points):
        if not h.fits:
            tally.see(_own_feature(h.trapezoid()) / _own_feature(h.inner()), trapezoid=number)
    return tally.verdict()


def check_side_distance(chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the squared distance of the centre of R from the legs of H, over l^2."""
    tally = Tally("the centre of R is farther than l/2 from the legs", ">", _HALVED)
    for number, _, h in quadrilaterals(chords, points):
        if h.fits:
            low_left, low_right, high_right, high_left = h.trapezoid()
            centre = Point(h.short / 2, h.height / 2)
            least = min(segment_distance_squared(centre, low_left, high_left),
                        segment_distance_squared(centre, low_right, high_right))
            tally.see(least / h.short**2, trapezoid=number)
    return tally.verdict()


def check_lemma(chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the squared feature size left in each trapezoid without T-vertices, over mfs(H)^2."""
    tally = Tally("half of mfs(H) is left", ">=", _HALVED)
    owner, _ = directed_edges(interior.faces)
    for number, z, h in quadrilaterals(chords, points):
        if z.bottom or z.top:
            continue
        corners = (z.bl, z.br, z.tr, z.tl)
        faces = [interior.faces[owner[side]] for side in zip(corners, (*corners[1:], z.bl), strict=True)
                 if side in owner]
        apexes = set().union(*faces).difference(corners)
        if len(faces) != 4 or len(apexes) != 1 or any(len(face) != 3 for face in faces):
            return failed(tally.instances + 1, "four triangles stand around one vertex", trapezoid=number)
        tally.see(min(_feature(points, face) for face in faces) / _own_feature(h.trapezoid()), trapezoid=number,
                  at=str(points[apexes.pop()]))
    return tally.verdict()


def _quad(short: mpq, long: mpq, shift: mpq, height: mpq) -> list[Point]:
    zero = mpq(0)
    return [Point(zero, zero), Point(short, zero), Point(shift + long, height), Point(shift, height)]


def _own_feature(corners: Sequence[Point]) -> mpq:
    """Return the squared mfs of a convex quadrilateral."""
    return face_witness(corners, (0, 1, 2, 3)).squared


def _feature(points: Sequence[Point], face: tuple[int, ...]) -> mpq:
    """Return the squared feature size of a triangle, zero for what is none."""
    corners = corners_of(points, face)
    return mpq(0) if isinstance(corners, NotTriangle) else face_feature_squared(points, face, corners)
