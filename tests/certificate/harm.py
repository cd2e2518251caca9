"""Many ways to spoil a valid certificate, its mesh or its input.

`HARMS` maps the name of a kind of harm to a function that spoils a fresh copy of a triple, or returns None where it
does not apply. Most harm is done by an attacker who knows the format: hashes are made right again afterwards, but for
`KEEPS_HASHES`. Some harm may leave a triple true, a vertex of the rest that is moved a little, say; after
`ALWAYS_WRONG` no checker may accept.
"""

import copy
import hashlib
import json
import random
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

import oracle
from triples import BASES, Triple, base

Harm = Callable[[Triple], Any]  # returns None where it does not apply, the files where it makes them, else True
HARMS: dict[str, Harm] = {}
KEEPS_HASHES: set[str] = set()
# Harm after which nothing that is stated can be true, whatever the numbers.
ALWAYS_WRONG: set[str] = set()


def harm(name: str, keeps_hashes: bool = False, always_wrong: bool = False) -> Callable[[Harm], Harm]:
    """Enter a function into the table."""
    def enter(function: Harm) -> Harm:
        HARMS[name] = function
        if keeps_hashes:
            KEEPS_HASHES.add(name)
        if always_wrong:
            ALWAYS_WRONG.add(name)
        return function
    return enter


def harmed(name: str, kind: str, seed: int) -> list[bytes] | None:
    """Return the files of a base spoilt in one way; None where the way does not apply."""
    triple = copy.deepcopy(base(name))
    triple.source = random.Random(f"{name} {kind} {seed}")
    made = HARMS[kind](triple)
    if made is None:
        return None
    return made if isinstance(made, list) else triple.files(kind in KEEPS_HASHES)


def _nudged(text: str, source: random.Random) -> str:
    """Return a number one unit of its last place away."""
    value = Fraction(text)
    return str(value + Fraction(source.choice((-1, 1)), value.denominator))


def _nudge(triple: Triple, v: int, step: Fraction | None = None) -> None:
    at = triple.vertex(v)
    axis = triple.source.randrange(2)
    at[axis] = _nudged(at[axis], triple.source) if step is None else str(
        Fraction(at[axis]) + step * triple.source.choice((-1, 1)))


@harm("vertex of the mesh moved by one in the last place")
def _(t: Triple) -> Any:
    _nudge(t, t.source.randrange(t.watched))
    return True


@harm("vertex of the mesh moved by 1e-60")
def _(t: Triple) -> Any:
    _nudge(t, t.source.randrange(t.watched), Fraction(1, 10**60))
    return True


@harm("vertex of input and mesh moved")
def _(t: Triple) -> Any:
    v = t.source.randrange(t.given)
    _nudge(t, v, t.source.choice([None, Fraction(1, 10**40), Fraction(3), Fraction(1, 3)]))
    t.pslg["vertices"][v] = t.vertex(v)
    return True


@harm("vertex of the rest moved")
def _(t: Triple) -> Any:
    _nudge(t, t.watched + t.source.randrange(len(t.certificate["vertices"])),
           t.source.choice([None, Fraction(1, 10**60), Fraction(5), Fraction(1, 7)]))
    return True


@harm("vertex moved far away")
def _(t: Triple) -> Any:
    v = t.source.randrange(t.given, t.watched + len(t.certificate["vertices"]))
    w = t.source.randrange(t.watched)
    (x, y), (p, q) = t.place(v), t.place(w)
    part = Fraction(t.source.randint(-20, 20), 10)
    t.put(v, x + (p - x) * part, y + (q - y) * part)
    return True


@harm("new vertex moved onto an input edge")
def _(t: Triple) -> Any:
    if t.watched == t.given:
        return None
    v = t.source.randrange(t.given, t.watched)
    a, b = (t.place(w) for w in t.source.choice(t.pslg["edges"]))
    part = Fraction(t.source.randint(1, 9), 10)
    t.put(v, a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part)
    return True


@harm("coordinates of a vertex exchanged")
def _(t: Triple) -> Any:
    at = t.vertex(t.source.randrange(t.watched))
    if at[0] == at[1]:
        return None
    at.reverse()
    return True


@harm("one file mirrored", always_wrong=True)
def _(t: Triple) -> Any:
    rows = t.source.choice([t.mesh["vertices"], t.certificate["vertices"], t.pslg["vertices"]])
    rows[:] = [[str(-Fraction(x)), y] for x, y in rows]
    return True


@harm("all mirrored: faces clockwise", always_wrong=True)
def _(t: Triple) -> Any:
    for rows in (t.mesh["vertices"], t.certificate["vertices"], t.pslg["vertices"], t.pslg.get("holes", [])):
        rows[:] = [[str(-Fraction(x)), y] for x, y in rows]
    return True


@harm("mesh scaled")
def _(t: Triple) -> Any:
    factor = Fraction(t.source.choice([2, 1000]), 999)
    t.mesh["vertices"] = [[str(Fraction(x) * factor), str(Fraction(y) * factor)] for x, y in t.mesh["vertices"]]
    return True


@harm("all scaled: another size")
def _(t: Triple) -> Any:
    for rows in (t.mesh["vertices"], t.certificate["vertices"], t.pslg["vertices"], t.pslg.get("holes", [])):
        rows[:] = [[str(Fraction(x) * Fraction(999, 1000)), str(Fraction(y) * Fraction(999, 1000))] for x, y in rows]
    return True


@harm("face dropped")
def _(t: Triple) -> Any:
    faces = t.a_list()
    faces.pop(t.source.randrange(len(faces)))
    return True


@harm("several faces of the mesh dropped", always_wrong=True)
def _(t: Triple) -> Any:
    del t.mesh["faces"][t.source.randrange(len(t.mesh["faces"])) :]
    return True


@harm("face doubled", always_wrong=True)
def _(t: Triple) -> Any:
    faces = t.a_list()
    faces.insert(t.source.randrange(len(faces)), list(t.source.choice(t.source.choice([faces, t.all_faces()]))))
    return True


@harm("all faces of the mesh doubled", always_wrong=True)
def _(t: Triple) -> Any:
    t.mesh["faces"] += t.mesh["faces"]
    return True


@harm("indices exchanged in a face")
def _(t: Triple) -> Any:
    face = t.a_face()
    i, j = t.source.sample(range(len(face)), 2)
    face[i], face[j] = face[j], face[i]
    return True


@harm("face turned around", always_wrong=True)
def _(t: Triple) -> Any:
    t.a_face().reverse()
    return True


@harm("two neighbours turned around", always_wrong=True)
def _(t: Triple) -> Any:
    found = _neighbours(t, t.a_list())
    if found is None:
        return None
    for face in found:
        face.reverse()
    return True


@harm("index changed in a face")
def _(t: Triple) -> Any:
    face = t.a_face()
    i = t.source.randrange(len(face))
    v = t.source.randrange(t.watched + len(t.certificate["vertices"]))
    if v == face[i]:
        return None
    face[i] = v
    return True


@harm("vertex left out of a face")
def _(t: Triple) -> Any:
    face = t.source.choice([f for f in t.all_faces() if len(f) > 3] or t.all_faces())
    face.pop(t.source.randrange(len(face)))
    return True


@harm("vertex put into a face")
def _(t: Triple) -> Any:
    face = t.a_face()
    face.insert(t.source.randrange(len(face) + 1), t.source.randrange(t.watched))
    return True


@harm("vertex repeated in a face", always_wrong=True)
def _(t: Triple) -> Any:
    face = t.a_face()
    i = t.source.randrange(len(face))
    face.insert(i, face[i])
    return True


@harm("two vertices merged")
def _(t: Triple) -> Any:
    u, v = t.source.sample(range(t.watched + len(t.certificate["vertices"])), 2)
    t.replace_vertex(u, v)
    return True


@harm("edge collapsed")
def _(t: Triple) -> Any:
    if t.watched == t.given:
        return None
    v = t.source.randrange(t.given, t.watched)
    around = [face for face in t.mesh["faces"] if v in face and len(face) == 3]
    if not around:
        return None
    u = t.source.choice([w for w in t.source.choice(around) if w != v])
    t.mesh["faces"] = [face for face in t.mesh["faces"] if not {u, v} <= set(face)]
    t.replace_vertex(v, u)
    return True


@harm("vertex doubled in place, in some faces")
def _(t: Triple) -> Any:
    faces = t.a_list()
    v = t.source.choice(t.source.choice(faces))
    around = [face for face in faces if v in face]
    new = _new_vertex(t, faces, t.vertex(v))
    for face in around[: t.source.randint(1, len(around))]:
        face[face.index(v)] = new if faces is not t.mesh["faces"] else t.watched - 1
    return True


def _new_vertex(t: Triple, faces: Any, at: Sequence[str]) -> int:
    """Add a vertex to the file that the faces are in; return its number."""
    if faces is t.mesh["faces"]:
        t.mesh["vertices"].append(list(at))
        for face in t.certificate["faces"]:
            face[:] = [v + 1 if v >= t.watched - 1 else v for v in face]
        return t.watched - 1
    t.certificate["vertices"].append(list(at))
    return t.watched + len(t.certificate["vertices"]) - 1


@harm("slit cut along an inner edge")
def _(t: Triple) -> Any:
    found = _neighbours(t, t.mesh["faces"])
    if found is None:
        return None
    first, second = found
    shared = [v for v in first if v in second]
    v = t.source.choice(shared)
    x, y = t.place(v)
    step = Fraction(t.source.choice((0, 0, 1, -1)), 10**20)
    new = _new_vertex(t, t.mesh["faces"], [str(x + step), str(y)])
    second[second.index(v)] = new
    return True


@harm("vertex added on an input edge")
def _(t: Triple) -> Any:
    u, v = t.source.choice(t.pslg["edges"])
    a, b = t.place(u), t.place(v)
    faces = t.a_list()
    new = _new_vertex(t, faces, [str((a[0] + b[0]) / 2), str((a[1] + b[1]) / 2)])
    for face in t.source.choice([faces, t.all_faces()]):
        for i in range(len(face)):
            if {face[i - 1], face[i]} == {u, v}:
                face.insert(i, new)
                break
    return True


@harm("input edge split in input, mesh and rest")
def _(t: Triple) -> Any:
    # The new vertex of the input comes last in it: all other indices move.
    e = t.source.randrange(len(t.pslg["edges"]))
    u, v = t.pslg["edges"][e]
    a, b = t.place(u), t.place(v)
    new, given = t.given, t.given
    at = [str((a[0] + b[0]) / 2), str((a[1] + b[1]) / 2)]
    for face in t.all_faces():
        face[:] = [w + 1 if w >= given else w for w in face]
        for i in range(len(face)):
            if {face[i - 1], face[i]} == {u, v}:
                face.insert(i, new)
                break
    t.mesh["vertices"].insert(given, at)
    t.pslg["vertices"].append(at)
    t.pslg["edges"][e] = [u, new]
    t.pslg["edges"].append([new, v])
    return True


def _neighbours(t: Triple, faces: list[list[int]]) -> tuple[list[int], list[int]] | None:
    """Return two triangles of the list that share an edge."""
    owner = {(face[i - 1], face[i]): face for face in faces for i in range(len(face))}
    pairs = [(face, owner[v, u]) for (u, v), face in owner.items()
             if (v, u) in owner and len(face) == len(owner[v, u]) == 3]
    return t.source.choice(pairs) if pairs else None


@harm("diagonal flipped")
def _(t: Triple) -> Any:
    found = _neighbours(t, t.a_list())
    if found is None:
        return None
    first, second = found
    i = next(i for i in range(3) if {first[i - 1], first[i]} <= set(second))
    u, v, w = first[i - 1], first[i], first[i - 2]
    z = next(x for x in second if x not in (u, v))
    first[:], second[:] = [w, u, z], [w, z, v]
    return True


@harm("diagonal flipped in one face only", always_wrong=True)
def _(t: Triple) -> Any:
    found = _neighbours(t, t.a_list())
    if found is None:
        return None
    first, second = found
    i = next(i for i in range(3) if {first[i - 1], first[i]} <= set(second))
    z = next(x for x in second if x not in first)
    first[:] = [first[i - 2], first[i - 1], z]
    return True


def _area(t: Triple, face: Sequence[int]) -> Fraction:
    return oracle.polygon_area([t.place(v) for v in face])


def _equal_areas(t: Triple, first: list[list[int]], second: list[list[int]]) -> Iterator[tuple[int, int]]:
    areas = [_area(t, face) for face in second]
    order = list(range(len(first)))
    t.source.shuffle(order)
    for i in order:
        area = _area(t, first[i])
        yield from ((i, j) for j in range(len(second)) if areas[j] == area and set(first[i]) != set(second[j]))


@harm("face covered twice, another of equal area not at all", always_wrong=True)
def _(t: Triple) -> Any:
    faces = t.a_list()
    pair = next(_equal_areas(t, faces, faces), None)
    if pair is None:
        return None
    faces[pair[0]] = list(faces[pair[1]])
    return True


@harm("overlap of two faces with the right total area", always_wrong=True)
def _(t: Triple) -> Any:
    # Across one edge, apexes exchanged: the areas that one gains the other loses.
    found = _neighbours(t, t.a_list())
    if found is None:
        return None
    first, second = found
    a = next(i for i, v in enumerate(first) if v not in second)
    b = next(i for i, v in enumerate(second) if v not in first)
    first[a], second[b] = second[b], first[a]
    return True


@harm("faces of equal area exchanged between mesh and rest")
def _(t: Triple) -> Any:
    mesh, rest = t.mesh["faces"], t.certificate["faces"]
    outer = [face for face in rest if max(face) < t.watched] or rest
    pair = next(_equal_areas(t, mesh, outer), None) or (t.source.randrange(len(mesh)), t.source.randrange(len(outer)))
    j = next(j for j, face in enumerate(rest) if face is outer[pair[1]])
    mesh[pair[0]], rest[j] = rest[j], mesh[pair[0]]
    return True


@harm("face given from the mesh to the rest", always_wrong=True)
def _(t: Triple) -> Any:
    t.certificate["faces"].append(t.mesh["faces"].pop(t.source.randrange(len(t.mesh["faces"]))))
    return True


@harm("face given from the rest to the mesh")
def _(t: Triple) -> Any:
    rest = t.certificate["faces"]
    near = [j for j, face in enumerate(rest) if max(face) < t.watched] or range(len(rest))
    t.mesh["faces"].append(rest.pop(t.source.choice(near)))
    return True


@harm("whole mesh given to the rest, or whole rest to the mesh")
def _(t: Triple) -> Any:
    mesh, rest = t.mesh["faces"], t.certificate["faces"]
    if t.source.random() < 0.5:
        t.mesh["faces"], t.certificate["faces"] = mesh[:1], rest + mesh[1:]
    else:
        near = [face for face in rest if max(face) < t.watched]
        t.mesh["faces"], t.certificate["faces"] = mesh + near, [face for face in rest if max(face) >= t.watched]
    t.certificate["hole_faces"] = [min(f, len(t.certificate["faces"]) - 1) for f in t.certificate["hole_faces"]]
    return True


@harm("faces of mesh and rest in one list")
def _(t: Triple) -> Any:
    if t.source.random() < 0.5:
        t.certificate["faces"] += t.mesh["faces"]
        t.mesh["faces"] = []
    else:
        t.mesh["faces"] += t.certificate["faces"]
        t.certificate["faces"] = []
    return True


@harm("bound forged by one in the last place")
def _(t: Triple) -> Any:
    value = Fraction(t.certificate["mfs_squared_at_least"])
    t.certificate["mfs_squared_at_least"] = f"{value.numerator + 1}/{value.denominator}"
    return True


@harm("bound forged by a part in 1e50")
def _(t: Triple) -> Any:
    key = t.source.choice(["mfs_squared_at_least", "degradation_squared_at_most", "input_mfs_squared_at_most"])
    sign = 1 if key == "mfs_squared_at_least" else -1
    t.certificate[key] = str(Fraction(t.certificate[key]) * (1 + sign * Fraction(1, 10**50)))
    return True


@harm("bound doubled, degradation halved")
def _(t: Triple) -> Any:
    t.certificate["mfs_squared_at_least"] = str(Fraction(t.certificate["mfs_squared_at_least"]) * 2)
    t.certificate["degradation_squared_at_most"] = str(Fraction(t.certificate["degradation_squared_at_most"]) / 2)
    return True


@harm("degradation forged by one in the last place")
def _(t: Triple) -> Any:
    value = Fraction(t.certificate["degradation_squared_at_most"])
    t.certificate["degradation_squared_at_most"] = f"{value.numerator - 1}/{value.denominator}"
    return True


@harm("decimal forged by one in the last place")
def _(t: Triple) -> Any:
    key, sign = t.source.choice([("mfs_at_least", 1), ("degradation_at_most", -1)])
    text = t.certificate[key]
    if "e" in text:
        return None
    places = len(text.partition(".")[2])
    t.certificate[key] = str(Fraction(text) + Fraction(sign, 10**places))
    return True


@harm("sign of a claim turned", always_wrong=True)
def _(t: Triple) -> Any:
    key = t.source.choice(["mfs_squared_at_least", "mfs_at_least", "degradation_squared_at_most",
                           "degradation_at_most", "input_mfs_squared_at_most"])
    t.certificate[key] = "-" + t.certificate[key]
    return True


@harm("bound of zero or below", always_wrong=True)
def _(t: Triple) -> Any:
    t.certificate["mfs_squared_at_least"] = t.source.choice(["0", "-0", "0/5", "0e7", "-1"])
    return True


@harm("feature size of the input forged")
def _(t: Triple) -> Any:
    value = Fraction(t.certificate["input_mfs_squared_at_most"])
    t.certificate["input_mfs_squared_at_most"] = f"{value.numerator * 7 - 1}/{value.denominator * 7}"
    return True


@harm("witness changed")
def _(t: Triple) -> Any:
    t.certificate["witness"][t.source.randrange(3)] = t.source.randrange(t.given)
    return True


@harm("witness is a longer pair")
def _(t: Triple) -> Any:
    t.certificate["witness"] = [t.source.randrange(t.given), *t.source.choice(t.pslg["edges"])]
    return True


@harm("witness is a pair of new vertices", always_wrong=True)
def _(t: Triple) -> Any:
    t.certificate["witness"] = [t.watched, t.watched + 1, t.watched + 1]
    return True


@harm("witness is a vertex and an edge of it", always_wrong=True)
def _(t: Triple) -> Any:
    u, v = t.source.choice(t.pslg["edges"])
    t.certificate["witness"] = [u, u, v]
    return True


@harm("kind changed")
def _(t: Triple) -> Any:
    kinds = ["classic", "nonproper", "proper", "internal", "", "Proper", "best"]
    t.mesh["kind"] = t.source.choice([kind for kind in kinds if kind != t.mesh["kind"]])
    return True


@harm("hole point moved")
def _(t: Triple) -> Any:
    if not t.pslg.get("holes"):
        return None
    hole = t.source.choice(t.pslg["holes"])
    v, w = t.source.sample(range(t.given), 2)
    (x, y), (p, q) = t.place(v), t.place(w)
    hole[:] = t.source.choice([
        [str(x), str(y)], [str((x + p) / 2), str((y + q) / 2)], [str(x + 10**6), str(y)],
        [_nudged(hole[0], t.source), hole[1]], [str((3 * x + p) / 4), str((3 * y + q) / 4 + 1)]])
    return True


@harm("hole point dropped", always_wrong=True)
def _(t: Triple) -> Any:
    if not t.pslg.get("holes"):
        return None
    i = t.source.randrange(len(t.pslg["holes"]))
    t.pslg["holes"].pop(i)
    if t.source.random() < 0.8:
        t.certificate["hole_faces"].pop(i)
    return True


@harm("hole point added")
def _(t: Triple) -> Any:
    u, v, w = (t.place(t.source.randrange(t.given)) for _ in range(3))
    t.pslg.setdefault("holes", []).append([str((u[0] + v[0] + w[0]) / 3), str((u[1] + v[1] + w[1]) / 3)])
    t.certificate["hole_faces"].append(t.source.randrange(len(t.certificate["faces"])))
    return True


@harm("hole point added outside", always_wrong=True)
def _(t: Triple) -> Any:
    corners = set(range(t.watched, t.watched + 4))
    face = t.source.choice([face for face in t.certificate["faces"] if corners & set(face)])
    at = [t.place(v) for v in face]
    t.pslg.setdefault("holes", []).append([str(sum(p[axis] for p in at) / len(at)) for axis in (0, 1)])
    t.certificate["hole_faces"].append(t.certificate["faces"].index(face))
    return True


@harm("hole in another face")
def _(t: Triple) -> Any:
    if not t.pslg.get("holes"):
        return None
    rows = t.certificate["hole_faces"]
    rows[t.source.randrange(len(rows))] = t.source.randrange(len(t.certificate["faces"]))
    return True


@harm("edge of the input dropped")
def _(t: Triple) -> Any:
    t.pslg["edges"].pop(t.source.randrange(len(t.pslg["edges"])))
    return True


@harm("edge of the input added")
def _(t: Triple) -> Any:
    t.pslg["edges"].append(t.source.sample(range(t.given), 2))
    return True


@harm("edge of the mesh made an edge of the input")
def _(t: Triple) -> Any:
    face = t.a_face()
    sides = [(face[i - 1], face[i]) for i in range(len(face)) if max(face[i - 1], face[i]) < t.given]
    if not sides:
        return None
    t.pslg["edges"].append(list(t.source.choice(sides)))
    return True


@harm("edge of the input doubled", always_wrong=True)
def _(t: Triple) -> Any:
    u, v = t.source.choice(t.pslg["edges"])
    t.pslg["edges"].append(t.source.choice([[u, v], [v, u]]))
    return True


@harm("edge of the input with one end", always_wrong=True)
def _(t: Triple) -> Any:
    v = t.source.randrange(t.given)
    t.pslg["edges"].append(t.source.choice([[v, v], [v], [], [v, v, v]]))
    return True


@harm("ends of two edges exchanged")
def _(t: Triple) -> Any:
    first, second = t.source.sample(t.pslg["edges"], 2)
    first[1], second[1] = second[1], first[1]
    return True


@harm("vertices exchanged in a list")
def _(t: Triple) -> Any:
    rows = t.source.choice([t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"]])
    i, j = t.source.sample(range(len(rows)), 2)
    rows[i], rows[j] = rows[j], rows[i]
    return True


@harm("vertices in another order")
def _(t: Triple) -> Any:
    rows = t.source.choice([t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"]])
    t.source.shuffle(rows)
    return True


@harm("unused vertex added", always_wrong=True)
def _(t: Triple) -> Any:
    at = [str(t.source.randint(-3, 9)), str(Fraction(t.source.randint(-9, 9), 7))]
    if t.source.random() < 0.5:
        _new_vertex(t, t.mesh["faces"], at)
        return True
    t.certificate["vertices"].append(at)
    return True


@harm("unused vertex added to input and mesh")
def _(t: Triple) -> Any:
    given = t.given
    at = [str(t.source.randint(-3, 9)), str(Fraction(t.source.randint(-9, 9), 7))]
    t.pslg["vertices"].append(at)
    t.mesh["vertices"].insert(given, at)
    for face in t.all_faces():
        face[:] = [v + 1 if v >= given else v for v in face]
    return True


@harm("last vertex dropped")
def _(t: Triple) -> Any:
    t.source.choice([t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"]]).pop()
    return True


@harm("box changed")
def _(t: Triple) -> Any:
    v = t.watched + t.source.randrange(4)
    x, y = t.place(v)
    step = t.source.choice([Fraction(1, 10**30), Fraction(1), Fraction(-3, 2), Fraction(100)])
    t.put(v, *t.source.choice([(x + step, y), (x, y + step), (-x, y), (x, -y)]))
    return True


@harm("box turned or taken apart")
def _(t: Triple) -> Any:
    rows = t.certificate["vertices"]
    rows[:4] = t.source.choice([rows[1:4] + rows[:1], rows[3::-1], rows[:3], rows[:2] + rows[3:4] + rows[2:3]])
    return True


@harm("faces of the box dropped", always_wrong=True)
def _(t: Triple) -> Any:
    corner = t.watched + t.source.randrange(4)
    t.certificate["faces"] = [face for face in t.certificate["faces"] if corner not in face]
    return True


@harm("rest of another certificate")
def _(t: Triple) -> Any:
    other = base(t.source.choice([name for name in BASES if BASES[name][0] != BASES["square"][0]]))
    if other.certificate["faces"] == t.certificate["faces"]:
        return None
    t.certificate["faces"] = copy.deepcopy(other.certificate["faces"])
    t.certificate["vertices"] = copy.deepcopy(other.certificate["vertices"])
    return True


@harm("another certificate, mesh or input", keeps_hashes=True, always_wrong=True)
def _(t: Triple) -> Any:
    other = copy.deepcopy(base(t.source.choice(list(BASES))))
    key = t.source.choice(["pslg", "mesh", "certificate"])
    if getattr(other, key) == getattr(t, key):
        return None
    setattr(t, key, getattr(other, key))
    return True


@harm("hashes exchanged", keeps_hashes=True, always_wrong=True)
def _(t: Triple) -> Any:
    t.files()
    t.certificate["pslg_sha256"], t.certificate["mesh_sha256"] = (
        t.certificate["mesh_sha256"], t.certificate["pslg_sha256"])
    return True


@harm("hash changed", keeps_hashes=True, always_wrong=True)
def _(t: Triple) -> Any:
    t.files()
    key = t.source.choice(["pslg_sha256", "mesh_sha256"])
    digits = list(t.certificate[key])
    i = t.source.randrange(64)
    digits[i] = "0" if digits[i] != "0" else "1"
    text = "".join(digits)
    t.certificate[key] = t.source.choice([text, text[:-1], text + "0", "", text.upper(), text[:32]])
    return True


@harm("enormous number")
def _(t: Triple) -> Any:
    size = t.source.choice([50, 400, 3990, 4000, 4001, 9000, 30000])
    digits = "9" * size
    text = t.source.choice([digits, f"1/{digits}", f"{digits}/{digits[:-1]}8", f"1e{size}", f"1e-{size}",
                            f"0.{digits}", "1e999999999", "1e-999999999", "1e99999999999999999999", f"-{digits}"])
    place = t.source.randrange(3)
    if place == 0:
        t.vertex(t.source.randrange(t.watched))[t.source.randrange(2)] = text
    elif place == 1:
        t.certificate["vertices"][t.source.randrange(len(t.certificate["vertices"]))][0] = text
    else:
        t.certificate[t.source.choice(["mfs_squared_at_least", "degradation_at_most", "mfs_at_least"])] = text
    return True


@harm("enormous index")
def _(t: Triple) -> Any:
    face = t.a_face()
    face[t.source.randrange(len(face))] = t.source.choice(
        [10**9, 2**31, 2**32, 2**63, 2**64, 10**17, 10**18, 10**30, 10**2000, -1, -(2**31)])
    return True


@harm("wrong type somewhere", always_wrong=True)
def _(t: Triple) -> Any:
    name = t.source.choice(["pslg", "mesh", "certificate"])
    document = getattr(t, name)
    key = t.source.choice(sorted(set(document) - {"name", "pslg_sha256", "mesh_sha256"}))
    wrong = t.source.choice([None, True, 1.5, {}, [[[]]], {"a": [1]}, "x", [None], [["1", None]], "1/0",
                             [["1", "2", "3"]], float("nan"), float("inf"), [[0, 1.0, 2]], [["0", "1"], 3]])
    value = document[key]
    if isinstance(value, list) and value and t.source.random() < 0.7:
        i = t.source.randrange(len(value))
        if isinstance(value[i], list) and value[i] and t.source.random() < 0.5:
            value[i][t.source.randrange(len(value[i]))] = wrong
        else:
            value[i] = wrong
    else:
        document[key] = wrong if wrong != value else None
    return True


@harm("key dropped, added or misspelt", always_wrong=True)
def _(t: Triple) -> Any:
    document = t.source.choice([t.pslg, t.mesh, t.certificate])
    key = t.source.choice(sorted(set(document) - {"holes", "name", "hole_faces"}))
    how = t.source.randrange(3)
    if how == 0:
        del document[key]
    elif how == 1:
        document["extra"] = document[key]
    else:
        document[key.upper()] = document.pop(key)
    return t.files(keep_hashes=document is t.certificate)


@harm("format of another file", always_wrong=True)
def _(t: Triple) -> Any:
    document = t.source.choice([t.pslg, t.mesh, t.certificate])
    document["format"] = t.source.choice(["exactmesh-pslg/2", "exactmesh-mesh/0", "exactmesh-certificate/11", "", "x"])
    return True


@harm("files in another order", always_wrong=True)
def _(t: Triple) -> Any:
    pslg, mesh, certificate = t.files()
    return t.source.choice([[mesh, pslg, certificate], [pslg, certificate, mesh], [certificate, mesh, pslg],
                            [pslg, pslg, certificate], [pslg, mesh, mesh], [certificate] * 3])


@harm("deep nesting", always_wrong=True)
def _(t: Triple) -> Any:
    depth = t.source.choice([10, 1000, 100_000])
    document = t.source.choice([t.pslg, t.mesh, t.certificate])
    key = t.source.choice(sorted(set(document)))
    files = t.files()
    which = [t.pslg, t.mesh, t.certificate].index(document)
    opening, closing = t.source.choice([("[", "]"), ('{"a":', "}"), ("[", "")])
    whole = t.source.random() < 0.3
    document[key] = "NEST"
    text = '"NEST"' if whole else json.dumps(document)
    files[which] = text.replace('"NEST"', opening * depth + "1" + closing * depth).encode()
    return files


@harm("truncated", always_wrong=True)
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    files[which] = files[which][: t.source.randrange(len(files[which]))]
    return files


@harm("key doubled", always_wrong=True)
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    document = [t.pslg, t.mesh, t.certificate][which]
    key = t.source.choice(sorted(document))
    files[which] = files[which][:-1] + f', "{key}": {json.dumps(document[key])}}}'.encode()
    return _rehashed(t, files)


def _rehashed(t: Triple, files: list[bytes]) -> list[bytes]:
    """Write the hashes of the first two files into the third, where there is place."""
    for key, data in (("pslg_sha256", files[0]), ("mesh_sha256", files[1])):
        files[2] = files[2].replace(t.certificate[key].encode(), hashlib.sha256(data).hexdigest().encode())
    return files


@harm("more after the end", always_wrong=True)
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    files[which] += t.source.choice([b"{}", b"]", b"\0", b"x", b" 1", b"/*", files[which]])
    return _rehashed(t, files)


@harm("text that is no JSON, or not ours", always_wrong=True)
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    data = files[which]
    files[which] = t.source.choice([
        b"\xef\xbb\xbf" + data, data.decode().encode("utf-16"), data.replace(b"[", b"[,", 1), b"", b"\0",
        data.replace(b'"', b"'"), data.replace(b"]", b",]", 1), data.replace(b":", b"=", 1), b"null", b'"', b'"\\u00',
        data.replace(b"{", b"{//\n", 1), data.replace(b"format", b"for\\u006dat"), data.replace(b"/1", b"/1\n", 1),
        data.replace(b"}", b',"name":"\xff"}'), data.replace(b"}", b',"name":"\\x"}')])
    return _rehashed(t, files)


@harm("scalar spelt in a way that is none", always_wrong=True)
def _(t: Triple) -> Any:
    rows = t.source.choice([t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"]])
    t.source.choice(rows)[t.source.randrange(2)] = t.source.choice([
        "", " 1", "1 ", "1_0", "0x1", "1/0", "1/-2", "1//2", "--1", "+-1", "1.2.3", "1e", "e5", ".", "-", "1e1.5",
        "1/2/3", "1.5/2", "nan", "inf", "\u0661", "1\u2009", "1e+", "/2", "2/", "1,5"])
    return True


@harm("same number spelt otherwise")
def _(t: Triple) -> Any:
    rows = t.source.choice([t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"]])
    at = t.source.choice(rows)
    value = Fraction(at[0])
    n, d = value.numerator, value.denominator
    others = [f"{3 * n}/{3 * d}", f"{n}/{d}", f"+{n}/{d}".replace("+-", "-")]
    at[0] = t.source.choice(others + ([f"{n}", f"{n}.0", f"{n}0e-1", f"{n}.e+0", int(n)] if d == 1 else []))
    return True


@harm("byte changed")
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    data = bytearray(files[which])
    for _ in range(t.source.choice([1, 1, 1, 5])):
        data[t.source.randrange(len(data))] = t.source.choice(b'0123456789[]{}",:/-. \\eE\n\0\xff')
    files[which] = bytes(data)
    return _rehashed(t, files)


@harm("bytes left out or put in")
def _(t: Triple) -> Any:
    files = t.files()
    which = t.source.randrange(3)
    data = files[which]
    i, j = sorted(t.source.randrange(len(data)) for _ in range(2))
    j = min(j, i + t.source.choice([1, 2, 10, 1000]))
    files[which] = t.source.choice([data[:i] + data[j:], data[:j] + data[i:], data[:i] + b" " * (j - i) + data[j:]])
    return _rehashed(t, files)


@harm("two kinds of harm at once")
def _(t: Triple) -> Any:
    names = [name for name in HARMS if name not in KEEPS_HASHES and name != "two kinds of harm at once"]
    for name in t.source.sample(names, 2):
        try:
            made = HARMS[name](t)
        except (KeyError, ValueError, IndexError, TypeError, AttributeError, StopIteration, ZeroDivisionError):
            return None  # the first harm left nothing for the second
        if isinstance(made, list):
            return made
    return True
