"""The checker of proof certificates in detail: polynomials, boxes, and the words of every refusal."""

import itertools
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from gmpy2 import mpq

from exactmesh.proofs.certificate import (
    Cell,
    Constraint,
    Refused,
    bernstein,
    bounds,
    constraint_from_text,
    halves,
    is_violated,
    refute,
    satisfy,
    to_unit_box,
)
from exactmesh.proofs.polynomial import (
    NotPolynomial,
    Polynomial,
    polynomial,
    polynomial_from_text,
    variables,
)

X, Y = variables("x y")
Values = dict[str, mpq]
POINTS: list[Values] = [{"x": mpq(a), "y": mpq(b, 3)} for a, b in itertools.product((-2, 0, 1, 3), (-4, 0, 2, 3))]


def constraints(*texts: str) -> list[Constraint]:
    return [constraint_from_text(text) for text in texts]


def message(action: Callable[[], object]) -> str:
    """Return the words of a refusal, "" when there is none."""
    try:
        action()
    except (Refused, NotPolynomial) as error:
        return str(error)
    return ""


class TestPolynomials:
    TEXTS = ("0", "5", "x", "-x", "x + y", "x*y - 2*x**2 + 1/3", "(x - y)**3", "x**4 - y", "2*(x + 1)*(y - 3)/7")

    @staticmethod
    def by_python(text: str, point: Values) -> Fraction:
        names = {name: Fraction(int(v.numerator), int(v.denominator)) for name, v in point.items()}
        return Fraction(eval(text.replace("/7", "*Fraction(1, 7)").replace("1/3", "Fraction(1, 3)"),
                             {"Fraction": Fraction, **names}))

    def test_a_text_has_the_values_that_python_gives_it(self) -> None:
        for text, point in itertools.product(self.TEXTS, POINTS):
            assert polynomial_from_text(text).value(point) == self.by_python(text, point)

    def test_arithmetic_is_that_of_values(self) -> None:
        for s, t, point in itertools.product(self.TEXTS, self.TEXTS, POINTS):
            p, q = polynomial_from_text(s), polynomial_from_text(t)
            a, b = p.value(point), q.value(point)
            for found, value in ((p + q, a + b), (p - q, a - b), (p * q, a * b), (-p, -a), (p**3, a**3), (p + 2, a + 2),
                                 (2 + p, a + 2), (p - 2, a - 2), (2 - p, 2 - a), (p * 3, a * 3), (3 * p, 3 * a),
                                 (p / 4, a / 4), (p / mpq(2, 3), a * mpq(3, 2)), (p**0, mpq(1))):
                assert found.value(point) == value
                assert all(found.terms.values())

    def test_substitution_is_composition(self) -> None:
        for text, point in itertools.product(self.TEXTS, POINTS):
            p = polynomial_from_text(text)
            image = {"x": point["x"] + 2 * point["y"], "y": point["y"]}
            assert p.substitute({"x": X + 2 * Y}).value(point) == p.value(image)
            assert p.substitute({"x": mpq(2), "y": X}).value(point) == p.value({"x": mpq(2), "y": point["x"]})
            assert p.substitute({}) == p

    @pytest.mark.parametrize("text, names, degrees", [
        ("0", set(), (0, 0)), ("7", set(), (0, 0)), ("x", {"x"}, (1, 0)), ("x*y**2 - x**3 + y", {"x", "y"}, (3, 2)),
        ("x - x + y", {"y"}, (0, 1)), ("(x + y)**2 - x**2", {"x", "y"}, (1, 2))])
    def test_names_and_degrees(self, text: str, names: set[str], degrees: tuple[int, int]) -> None:
        p = polynomial_from_text(text)
        assert p.names() == names and (p.degree("x"), p.degree("y")) == degrees

    @pytest.mark.parametrize("text, written", [
        ("0", "0"), ("5", "5"), ("-5/3", "-5/3"), ("x", "x"), ("-x", "-x"), ("x*2", "2*x"),
        ("x**2 - x - 1", "x**2 - x + -1"),
        ("y + x*y + 3", "x*y + y + 3"), ("x/2 - y**3", "-y**3 + 1/2*x"), ("y*x - y*x", "0"), ("1 - x", "-x + 1"),
        ("y**2 + x**2 + x*y", "x*y + x**2 + y**2"), ("3 - 2*x*y", "-2*x*y + 3"), ("x - y", "x - y")])
    def test_higher_degrees_are_written_first(self, text: str, written: str) -> None:
        p = polynomial_from_text(text)
        assert str(p) == written.replace("+ -", "- ")
        assert polynomial_from_text(str(p)) == p

    def test_equal_polynomials_have_equal_terms(self) -> None:
        assert (X + Y) * (X - Y) == X**2 - Y**2 and (X - X).terms == {} and polynomial(0).terms == {}
        assert polynomial(X) is X and polynomial(mpq(1, 2)).terms == {(): mpq(1, 2)}
        assert Polynomial({}) == polynomial(0) and (X * Y).terms == {(("x", 1), ("y", 1)): 1} == (Y * X).terms
        assert (X**2 * X).terms == {(("x", 3),): 1}

    @pytest.mark.parametrize("text", ["", "x +", "x/y", "1.5", "x**y", "x**-1", "x**65", "f(x)", "True", "'x'", "x/0",
                                      "+x", "x//2", "x if x else y", "x == y", "x; y", "x/2.0", "~x", "x and y"])
    def test_what_is_no_polynomial(self, text: str) -> None:
        assert message(lambda: polynomial_from_text(text)) == f"no polynomial: {text!r}"

    def test_limits(self) -> None:
        assert polynomial_from_text("x**64").degree("x") == 64 and polynomial_from_text("x**0") == polynomial(1)
        long = "x + " * 30 + "?"
        assert message(lambda: polynomial_from_text(long)) == f"no polynomial: {long[:60]!r}"
        deep = "-" * 100_000 + "x"
        assert message(lambda: polynomial_from_text(deep)) == f"no polynomial: {deep[:60]!r}"


class TestConstraints:
    @pytest.mark.parametrize("relation, holds", [(">=", (False, True, True)), (">", (False, False, True)),
                                                 ("==", (False, True, False))])
    def test_a_constraint_holds_or_not(self, relation: str, holds: tuple[bool, bool, bool]) -> None:
        found = constraint_from_text(f"2*x - 1 {relation} 0")
        assert str(found) == f"2*x - 1 {relation} 0"
        points = [{"x": mpq(v, 2)} for v in (0, 1, 2)]
        assert tuple(found.holds(point) for point in points) == holds
        if relation == "==":
            assert message(found.negated) == "an equality has no single opposite"
        else:
            assert [found.negated().holds(point) for point in points] == [not value for value in holds]

    def test_what_is_no_constraint(self) -> None:
        long = "x" * 70
        assert message(lambda: constraint_from_text(long)) == f"no constraint: {long[:60]!r}"
        for text in ("x", "x >= 1", "x>= 0", "0 >= x"):
            assert message(lambda text=text: constraint_from_text(text)) == f"no constraint: {text!r}"
        assert message(lambda: constraint_from_text("x/y > 0")) == "no polynomial: 'x/y'"

    def test_points(self) -> None:
        given = constraints("x >= 0", "1 - y > 0", "x - y == 0")
        satisfy(given, {"x": "1/2", "y": "1/2"})
        satisfy(given, {"x": "0", "y": "0", "z": "5"})
        for point, words in (({"x": "1", "y": "1"}, "the point does not satisfy -y + 1 > 0"),
                             ({"x": "-1", "y": "2"}, "the point does not satisfy x >= 0"),
                             ({"x": "0", "y": "1/2"}, "the point does not satisfy x - y == 0"),
                             ({"x": "0"}, "malformed point: 'y'"), ({"x": "a", "y": "0"}, "malformed point: ")):
            assert message(lambda point=point: satisfy(given, point)).startswith(words)


def combination(terms: list[Any], equalities: Any = ()) -> dict[str, Any]:
    return {"kind": "combination", "terms": terms, "equalities": list(equalities)}


GIVEN = ("x > 0", "-x - 1 > 0", "x**2 == 0", "y >= 0", "-y >= 0")


class TestCombinations:
    @pytest.mark.parametrize("node", [
        combination([["1", [0], None], ["1", [1], None], ["1", [], None]]),
        combination([["2", [0], None], ["2", [1], None], ["2", [], None]]),
        combination([["1", [0], None], ["1", [1], None], ["1", [], None], ["3", [3], None], ["3", [4], None]]),
        combination([["1", [0], None], ["1", [1], None], ["1", [], "1"]])])
    def test_a_positive_sum_that_is_zero_refutes(self, node: dict[str, Any]) -> None:
        refute(constraints(*GIVEN), node)

    @pytest.mark.parametrize("node, words", [
        (combination([["0", [0], None]]), "a coefficient is not positive"),
        (combination([["-1", [0], None]]), "a coefficient is not positive"),
        (combination([["1", [5], None]]), "there is no assumption 5"),
        (combination([["1", [-1], None]]), "there is no assumption -1"),
        (combination([["1", [True], None]]), "there is no assumption True"),
        (combination([["1", ["0"], None]]), "there is no assumption 0"),
        (combination([["1", [3], None], ["1", [4], None]]), "no term is positive"),
        (combination([["1", [0, 3], None]]), "no term is positive"),
        (combination([["1", [], "0"]]), "no term is positive"), (combination([]), "no term is positive"),
        (combination([["1", [0], None]]), "the combination is not zero"),
        (combination([["1", [0], None], ["1", [1], None]]), "the combination is not zero"),
        (combination([["1", [], None]], [[0, "-1"]]), "only an equality may have any multiplier"),
        (combination([["1", [], None]], [[9, "-1"]]), "there is no assumption 9"),
        (combination([["1", [], "x/y"]]), "no polynomial: 'x/y'"),
        (combination([["1", [], None]], [[2, "y/x"]]), "no polynomial: 'y/x'"),
        (combination([["a", [], None]]), "malformed certificate: "), ({}, "no certificate, or one of an unknown kind"),
        ({"kind": "other"}, "no certificate, or one of an unknown kind"),
        ({"kind": "combination", "terms": []}, "no certificate, or one of an unknown kind")])
    def test_a_refusal_says_why(self, node: dict[str, Any], words: str) -> None:
        assert message(lambda: refute(constraints(*GIVEN), node)).startswith(words)

    def test_squares_and_products_count(self) -> None:
        given = constraints("x - 1 > 0", "y > 0", "1 - x >= 0", "x*y - y == 0")
        refute(given, combination([["1", [0, 1], None]], [[3, "-1"]]))
        refute(given, combination([["1", [0], None], ["1", [2], None]]))
        # -(x - 1)**2 >= 0 and a square, and 1 > 0 is missing.
        given = constraints("-x**2 + 2*x - 2 >= 0")
        refute(given, combination([["1", [0], None], ["1", [], "x - 1"], ["1", [], None]]))
        assert message(lambda: refute(given, combination([["1", [0], None], ["1", [], "x + 1"], ["1", [], None]]))
                       ) == "the combination is not zero"
        refute(constraints("x == 0", "x - 2 == 0"), combination([["2", [], None]], [[0, "-1"], [1, "1"]]))


class TestCases:
    def test_a_case_is_an_inequality_and_has_certificates(self) -> None:
        given = constraints("y - 5 == 0")
        # y - 6 >= 0 contradicts y = 5; its opposite does not.
        node = {"kind": "cases", "on": "y - 6 >= 0", "holds": combination(
            [["1", [1], None], ["1", [], None]], [[0, "-1"]]), "fails": {}}
        assert message(lambda: refute(given, node)) == "no certificate, or one of an unknown kind"
        node["fails"] = node["holds"]
        assert message(lambda: refute(given, node)) == "the combination is not zero"
        assert message(lambda: refute(given, {**node, "on": "y == 0"})) == "an equality has no single opposite"
        assert message(lambda: refute(given, {**node, "on": 5})) == "no certificate, or one of an unknown kind"
        assert message(lambda: refute(given, {**node, "on": "y"})) == "no constraint: 'y'"

    def test_both_cases_must_be_refuted(self) -> None:
        given = constraints("x - 1 > 0", "-x > 0")
        good = combination([["1", [0], None], ["1", [1], None], ["1", [], None]])
        bad = combination([["1", [0], None]])
        refute(given, {"kind": "cases", "on": "y >= 0", "holds": good, "fails": good})
        for holds, fails in ((good, bad), (bad, good)):
            assert message(lambda holds=holds, fails=fails: refute(
                given, {"kind": "cases", "on": "y >= 0", "holds": holds, "fails": fails})) != ""
        # What is open besides a case with cases of its own must be refuted as well.
        inner = {"kind": "cases", "on": "z >= 0", "holds": good, "fails": good}
        refute(given, {"kind": "cases", "on": "y >= 0", "holds": inner, "fails": inner})
        for holds, fails in ((inner, bad), (bad, inner), (inner, {**inner, "holds": bad}),
                             ({**inner, "fails": bad}, inner)):
            assert message(lambda holds=holds, fails=fails: refute(
                given, {"kind": "cases", "on": "y >= 0", "holds": holds, "fails": fails})
                           ) == "the combination is not zero"
        # y > 0 and its opposite -y >= 0, each with the number 2.
        given = constraints("y - 1 >= 0", "-y - 1 >= 0")
        refute(given, {"kind": "cases", "on": "y > 0",
                       "holds": combination([["1", [2], None], ["1", [1], None], ["1", [], None]]),
                       "fails": combination([["1", [2], None], ["1", [0], None], ["1", [], None]])})
        refute(given, {"kind": "cases", "on": "y >= 0",
                       "holds": combination([["1", [2], None], ["1", [1], None], ["1", [], None]]),
                       "fails": combination([["1", [2], None], ["1", [0], None], ["1", [], None]])})


class TestBoxes:
    CELLS: tuple[Cell, ...] = (((mpq(0), mpq(1)), (mpq(0), mpq(1))), ((mpq(1, 4), mpq(1, 2)), (mpq(-1), mpq(3))))

    def test_bernstein_coefficients_enclose_the_values_and_are_values_at_the_corners(self) -> None:
        texts = ("3", "x", "y", "x*y", "x**2 - x", "x**3*y**2 - 2*x + y - 1/7", "(x - y)**2")
        for text, cell in itertools.product(texts, self.CELLS):
            p = polynomial_from_text(text)
            values = bernstein(p, ["x", "y"], cell)
            assert len(values) == (p.degree("x") + 1) * (p.degree("y") + 1)
            for s, t in itertools.product([mpq(k, 4) for k in range(5)], repeat=2):
                point = {name: low + (high - low) * part for name, (low, high), part in
                         zip("xy", cell, (s, t), strict=True)}
                assert min(values) <= p.value(point) <= max(values)
                if s in (0, 1) and t in (0, 1):
                    m, n = p.degree("x"), p.degree("y")
                    assert p.value(point) == values[int(s) * m * (n + 1) + int(t) * n]

    @pytest.mark.parametrize("text, coefficients", [
        ("x", [0, 1]), ("x**2", [0, 0, 1]), ("2*x - x**2", [0, 1, 1]), ("1 - 3*x + 3*x**2", [1, mpq(-1, 2), 1]),
        ("5", [5]), ("x**3", [0, 0, 0, 1]), ("(1 - x)**3 + 6*x*(1 - x)**2", [1, 2, 0, 0])])
    def test_known_coefficients_on_the_unit_interval(self, text: str, coefficients: list[mpq]) -> None:
        assert bernstein(polynomial_from_text(text), ["x"], ((mpq(0), mpq(1)),)) == coefficients
        moved = polynomial_from_text(text).substitute({"x": (X - 2) / 3})
        assert bernstein(moved, ["x"], ((mpq(2), mpq(5)),)) == coefficients

    @pytest.mark.parametrize("text, violated", [
        ("-x - 1 >= 0", True), ("-x >= 0", False), ("-x > 0", True), ("1/2 - x > 0", False), ("x + 1 == 0", True),
        ("-x - 1 == 0", True), ("x == 0", False), ("-x == 0", False),
        ("x - 1/2 == 0", False), ("x + 1 >= 0", False), ("x - 2 > 0", True),
        ("-1 >= 0", True), ("0 > 0", True), ("0 >= 0", False)])
    def test_an_assumption_is_violated_throughout_or_not(self, text: str, violated: bool) -> None:
        assert is_violated(constraint_from_text(text), ["x"], ((mpq(0), mpq(1)),)) is violated

    def test_bounds_are_the_best_ones(self) -> None:
        given = constraints("x - 1 >= 0", "2*x - 3 > 0", "5 - x >= 0", "9 - 2*x > 0", "x == 0", "x*y >= 0",
                            "y + 7 >= 0", "x**2 - 4 >= 0", "x - y >= 0", "3*z >= 0", "-z > 0")
        assert bounds(given, "x") == (mpq(3, 2), mpq(9, 2))
        assert bounds(constraints("x - 2 == 0", "-x - 3 == 0"), "x") == (None, None)
        assert bounds(given, "y") == (-7, None) and bounds(given, "z") == (0, 0) and bounds(given, "w") == (None, None)

    def test_the_unit_box_keeps_signs(self) -> None:
        p = polynomial_from_text("x**2*y - 3*x + y**3 - 5")
        given = constraints("x - 2 >= 0", "6 - x >= 0", "y + 1 >= 0")
        unit = to_unit_box(p, given, ["x", "y"])
        for s, t in itertools.product([mpq(k, 5) for k in range(5)], repeat=2):
            x, y = 2 + 4 * s, -1 + t / (1 - t)
            value = p.value({"x": x, "y": y})
            assert unit.value({"x": s, "y": t}) == value * (1 - t) ** 3
        assert message(lambda: to_unit_box(p, given[:2], ["x", "y"])) == "y has no lower bound"
        assert to_unit_box(p, given, ["x"]).names() == {"x", "y"}

    def test_halves(self) -> None:
        cell = self.CELLS[1]
        assert halves(cell, 0) == [((mpq(1, 4), mpq(3, 8)), cell[1]), ((mpq(3, 8), mpq(1, 2)), cell[1])]
        assert halves(cell, 1) == [(cell[0], (mpq(-1), mpq(1))), (cell[0], (mpq(1), mpq(3)))]
        for k in (-1, 2, 3):
            assert message(lambda k=k: halves(cell, k)) == f"the box has no side {k}"

    @pytest.mark.parametrize("tree, words", [
        ([2, 2], "the tree goes on after its last box"), ([0], "an assumption is not violated throughout its box"),
        ([], "a box is left out"), ([-1, 2], "a box is left out"), ([-2, 2, 2], "the box has no side 1"),
        ([3], "there is no assumption 3"), ([-1, 2, 2, 2], "the tree goes on after its last box"),
        (["a"], "malformed certificate: "), ([2], ""), ([-1, 2, 2], ""), ([-1, -1, 2, 2, 2], "")])
    def test_a_tree_of_boxes(self, tree: list[Any], words: str) -> None:
        given = constraints("x >= 0", "1 - x >= 0", "x**2 - x - 1 >= 0")
        node = {"kind": "boxes", "variables": ["x"], "tree": tree}
        found = message(lambda: refute(given, node))
        assert found.startswith(words) and bool(found) == bool(words)

    @pytest.mark.parametrize("names", [["x", "x", "y"], ["x"], [], ["y"]])
    def test_the_variables_are_those_of_the_assumptions(self, names: list[str]) -> None:
        given = constraints("x >= 0", "y >= 0", "-x - y - 1 > 0")
        node = {"kind": "boxes", "variables": names, "tree": [2]}
        assert message(lambda: refute(given, node)) == "the variables of the box are not those of the assumptions"
        refute(given, {**node, "variables": ["y", "x"]})
        given = [*given, *constraints("z >= 0")]
        refute(given, {**node, "variables": ["z", "x", "y"]})

    def test_halves_come_in_order_and_each_needs_its_own_reason(self) -> None:
        # On the lower half x <= 1/2 the third is violated, on the upper half the fourth.
        given = constraints("x >= 0", "1 - x >= 0", "x**2 - 2/5 > 0", "1/5 - x**2 > 0")
        refute(given, {"kind": "boxes", "variables": ["x"], "tree": [-1, 2, 3]})
        assert message(lambda: refute(given, {"kind": "boxes", "variables": ["x"], "tree": [-1, 3, 2]})) != ""
        two = constraints("x >= 0", "1 - x >= 0", "y >= 0", "1 - y >= 0", "y**2 - 2/5 > 0", "1/5 - y**2 > 0")
        refute(two, {"kind": "boxes", "variables": ["x", "y"], "tree": [-2, 4, 5]})
        refute(two, {"kind": "boxes", "variables": ["x", "y"], "tree": [-1, -2, 4, 5, -2, 4, 5]})
        refute(two, {"kind": "boxes", "variables": ["y", "x"], "tree": [-1, 4, 5]})
        assert message(lambda: refute(two, {"kind": "boxes", "variables": ["x", "y"], "tree": [-1, 4, 5]})) != ""
