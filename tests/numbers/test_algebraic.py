"""`exactmesh.numbers.algebraic`: laws, hard cases, independent oracles (mpmath, SymPy, Arb), and harm."""

import math
import pickle
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import gmpy2
import mpmath
import pytest
import sympy
from algebraic_values import sums, trees, value
from gmpy2 import mpq, mpz
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.numbers import algebraic, interval, nested, radicals, surd_sum
from exactmesh.numbers.algebraic import Real, sqrt, total
from exactmesh.numbers.interval import Interval, sign_of
from exactmesh.numbers.nested import Nested
from exactmesh.numbers.radicals import ONE, Radical, TooManyRoots
from exactmesh.numbers.separation import Expr
from exactmesh.numbers.surd_sum import SurdSum

few = settings(max_examples=80, deadline=None, derandomize=True)
R2, R3, R5, R6 = (sqrt(n) for n in (2, 3, 5, 6))
SIN_PI_8 = sqrt(2 - R2) / 2
PRIMES = (6151, 6163, 2**61 - 1, 2**89 - 1)


def real(tree: Any) -> Real:
    return value(tree, Real, sqrt, Real.sign)


def reals() -> st.SearchStrategy[Real]:
    return trees().map(real)


def surds() -> st.SearchStrategy[Real]:
    return sums().map(real)


class TestFieldLaws:
    @few
    @given(reals(), reals())
    def test_sums_and_products_commute_and_subtraction_undoes(self, x: Real, y: Real) -> None:
        assert x + y == y + x and x * y == y * x
        assert (x + y) - y == x and (x - y) + y == x and x - x == 0

    @few
    @given(reals(), surds(), surds())
    def test_sums_and_products_associate_and_distribute(self, x: Real, y: Real, z: Real) -> None:
        assert (x + y) + z == x + (y + z)
        assert (x * y) * z == x * (y * z)
        assert (x + y) * z == x * z + y * z

    @few
    @given(reals(), reals())
    def test_division_undoes_multiplication(self, x: Real, y: Real) -> None:
        if y:
            assert x / y * y == x and 1 / y * y == 1 and y / y == 1

    @few
    @given(reals())
    def test_the_square_root_undoes_the_square(self, x: Real) -> None:
        assert sqrt(x * x) == abs(x)
        assert sqrt(abs(x)) ** 2 == abs(x) and sqrt(abs(x)) >= 0

    @few
    @given(surds(), st.integers(-3, 5))
    def test_powers(self, x: Real, k: int) -> None:
        if x:
            assert x**k * x == x ** (k + 1)

    def test_division_by_an_exact_zero_is_refused(self) -> None:
        with pytest.raises(ZeroDivisionError):
            1 / (R2 * R3 - R6)
        with pytest.raises(ZeroDivisionError):
            Real(1) / 0


class TestOrderLaws:
    @few
    @given(reals(), reals())
    def test_exactly_one_of_less_equal_greater_holds(self, x: Real, y: Real) -> None:
        assert [x < y, x == y, x > y].count(True) == 1
        assert (x <= y) == (not x > y) and (x >= y) == (not x < y) and [x == y, x != y].count(True) == 1
        assert (x - y).sign() == (x > y) - (x < y) == -(y - x).sign()

    @few
    @given(reals(), surds(), surds())
    def test_order_respects_sums_and_products(self, x: Real, y: Real, z: Real) -> None:
        assert (x < y) == (x + z < y + z)
        if z:
            assert (x < y) == ((x * z < y * z) if z > 0 else (x * z > y * z))

    @few
    @given(reals())
    def test_floor_and_ceiling(self, x: Real) -> None:
        assert math.floor(x) <= x < math.floor(x) + 1
        assert math.ceil(x) - 1 < x <= math.ceil(x)
        assert isinstance(math.floor(x), int)

    @few
    @given(st.lists(reals(), min_size=1, max_size=4))
    def test_sorted_min_and_max(self, values: list[Real]) -> None:
        ordered = sorted(values)
        assert all(x <= y for x, y in pairwise(ordered))
        assert min(values) == ordered[0] and max(values) == ordered[-1]

    @few
    @given(reals(), surds())
    def test_equal_values_hash_equal(self, x: Real, y: Real) -> None:
        again = (x + y) - y
        assert again == x and hash(again) == hash(x) and len({x, again}) == 1


class TestOracles:
    @few
    @given(trees())
    def test_digits_agree_with_mpmath(self, tree: Any) -> None:
        x = real(tree)
        with mpmath.workdps(200):
            # Zero is told by the exact type: the oracle speaks where values are apart.
            tiny = mpmath.mpf(10) ** -150
            y = value(tree, _mpf, lambda v: mpmath.sqrt(v) if v > tiny else mpmath.mpf(0),
                      lambda v: 0 if abs(v) < tiny else int(mpmath.sign(v)))
            if abs(y) < tiny:
                assert x == 0
            else:
                assert x.sign() == mpmath.sign(y)
                lower, upper = x.enclosure(520)
                assert abs(_mpf(lower) - y) < tiny * abs(y) and abs(_mpf(upper) - y) < tiny * abs(y)

    @few
    @given(trees(), trees())
    def test_signs_of_differences_agree_with_the_separation_bound(self, first: Any, second: Any) -> None:
        x, y = (value(t, Expr, Expr.sqrt, Expr.sign) for t in (first, second))
        assert (real(first) - real(second)).sign() == (x - y).sign()

    @few
    @given(trees())
    def test_the_canonical_form_denotes_the_value_of_the_tree(self, tree: Any) -> None:
        x = real(tree)
        form = x.fold(Expr, Expr.sqrt)
        assert (form - value(tree, Expr, Expr.sqrt, Expr.sign)).sign() == 0

    @settings(max_examples=10, deadline=None, derandomize=True)
    @given(st.sampled_from((2, 3, 5)), st.integers(-3, 3), st.integers(-3, 3), st.sampled_from((2, 6, 7)))
    def test_minimal_polynomials_agree_with_sympy(self, n: int, a: int, b: int, m: int) -> None:
        x = sqrt(abs(a + b * sqrt(n))) + sqrt(m)
        variable = sympy.Symbol("x")
        same = sympy.sqrt(abs(a + b * sympy.sqrt(n))) + sympy.sqrt(m)
        polynomial = sympy.minimal_polynomial(same, variable)
        result = Real()
        for coefficient in sympy.Poly(polynomial, variable).all_coeffs():
            result = result * x + int(coefficient)
        assert result == 0

    @few
    @given(trees())
    def test_expressions_are_read_back_by_python_and_sympy(self, tree: Any) -> None:
        x = real(tree)
        low, _ = x.enclosure(60)
        y = eval(x.expression(), {"sqrt": math.sqrt})
        size = float(sum(abs(c) * 1000 for c, _ in x._element.products())) + 1
        assert abs(y - float(low)) <= 1e-12 * size
        z = sympy.sympify(x.expression(), evaluate=False)
        assert abs(z.evalf(60) - sympy.Rational(str(low))) <= 2.0**-50 * (size + 1)


def _mpf(q: Any) -> mpmath.mpf:
    return mpmath.mpf(int(q.numerator)) / int(q.denominator)


class TestHardCases:
    def test_equal_values_in_different_forms(self) -> None:
        equal = [
            (sqrt(5 + 2 * R6), R2 + R3),
            (R2 * R3, R6),
            (sqrt(3 + R5), (sqrt(10) + R2) / 2),
            (sqrt(6 + 4 * R2), 2 + R2),
            (sqrt(10 + 2 * R6 + 2 * sqrt(10) + 2 * sqrt(15)), R2 + R3 + R5),
            (sqrt(sqrt(2)) ** 2, R2),
            (sqrt(2 - R2) * sqrt(2 + R2), R2),
            (2 * SIN_PI_8 * sqrt(1 - SIN_PI_8**2), R2 / 2),
            (sqrt(16 - 2 * sqrt(29) + 2 * sqrt(55 - 10 * sqrt(29))) - R5,
             sqrt(22 + 2 * R5) - sqrt(11 + 2 * sqrt(29))),
            (sqrt(1 + SIN_PI_8) * sqrt(1 - SIN_PI_8), sqrt(2 + R2) / 2),
            (sqrt(3 + 2 * sqrt(2 + R2) + R2), 1 + sqrt(2 + R2)),
            (sqrt(2 + sqrt(2 + R2)) * sqrt(2 - sqrt(2 + R2)), sqrt(2 - R2)),
            (1 / (1 + sqrt(sqrt(2))), (sqrt(sqrt(2)) - 1) * (1 + R2)),
        ]
        for x, y in equal:
            assert x == y and y == x and hash(x) == hash(y) and (x - y).sign() == 0 and not x < y

    def test_values_that_agree_to_a_hundred_digits_and_differ(self) -> None:
        n = 10**100
        x = sqrt(n * n + 1)
        assert x > n and x != n and (x - n).sign() == 1 and math.floor(x) == n
        assert x - n < mpq(1, 2 * n) and sqrt(n * n - 1) < n and math.floor(sqrt(n * n - 1)) == n - 1
        nearly = SIN_PI_8.enclosure(1100)
        assert nearly[0] < SIN_PI_8 < nearly[1] and hash(SIN_PI_8 + 0) == hash(SIN_PI_8)
        assert sqrt(2 - R2 + mpq(1, n)) > 2 * SIN_PI_8 and sqrt(2 - sqrt(2 + mpq(1, n))) < 2 * SIN_PI_8
        assert math.floor(10**300 * (sqrt(n * n + 1) - n)) == 5 * 10**199 - 1

    @pytest.mark.parametrize("order", range(1, 13))
    @pytest.mark.parametrize("n", [10**3, 10**6 - 20])
    def test_sums_of_square_roots_that_nearly_cancel(self, order: int, n: int) -> None:
        # The order-th difference of sqrt has the sign of its derivative, and is about n**(1/2 - order).
        terms = [(-1) ** (order - i) * math.comb(order, i) * sqrt(n + i) for i in range(order + 1)]
        difference = total(terms)
        assert difference.sign() == (-1) ** (order - 1)
        assert 0 < abs(difference) < mpq(math.factorial(order), n ** (order - 1)) * 2

    def test_known_least_gaps_of_short_sums(self) -> None:
        # From the tables of the sum of square roots problem (O'Rourke 1981): r(20, 2), and a longer one.
        assert 0 < sqrt(10) + sqrt(11) - R5 - sqrt(18) < mpq(2, 10**4)
        assert 0 < abs(R5 + R6 + sqrt(18) - 2 - 2 * sqrt(12)) < mpq(1, 10**4)

    @pytest.mark.parametrize("p", PRIMES)
    @pytest.mark.parametrize("q", PRIMES)
    def test_squares_of_large_primes_hidden_in_a_radicand(self, p: int, q: int) -> None:
        x, y = sqrt(p * p * q * 6), p * sqrt(q * 6)
        assert x == y and hash(x) == hash(y) and x - y == 0 and x / y == 1 and (x + y) / 2 == x
        assert sqrt(mpq(p, q)) * sqrt(mpq(q, p)) == 1
        hidden = (sqrt(p * p * q * PRIMES[0] * 6151 * 7) + 1) * (sqrt(q * 7) - 1)
        assert hidden == (p * 6151 * sqrt(q * 7) + 1) * (sqrt(q * 7) - 1)

    def test_different_nested_roots_meet(self) -> None:
        a, b = sqrt(1 + R2), sqrt(1 + R3)
        x = (a + b) * (a - b)
        assert x == R2 - R3 and (a + b) / (a + b) == 1 and a < b and a * b == sqrt((1 + R2) * (1 + R3))
        # The square of the third is the product of the squares of the others: dependent in either order.
        c = sqrt((1 + R2) * (1 + R3) * 5)
        assert c - R5 * a * b == 0 and a * b - c / R5 == 0 and sorted([c, b, a]) == [a, b, c]
        deep = sqrt(a + b)
        assert deep**4 == 2 + R2 + R3 + 2 * a * b and sqrt(a * a + 2 * a * b + b * b) == a + b

    def test_an_arc_midpoint_of_the_offset_curve_lies_on_its_circle(self) -> None:
        # Edge directions (3, 1) and (1, 4), radius r = sqrt(7/5)/4: the chain u + v has norm sqrt(2 + 2 u.v).
        u = (3 / sqrt(10), 1 / sqrt(10))
        v = (1 / sqrt(17), 4 / sqrt(17))
        r = sqrt(Fraction(7, 5)) / 4
        s = (u[0] + v[0], u[1] + v[1])
        length = sqrt(s[0] ** 2 + s[1] ** 2)
        m = (r * s[0] / length, r * s[1] / length)
        assert m[0] ** 2 + m[1] ** 2 == mpq(7, 80)
        assert m[0] * u[0] + m[1] * u[1] == m[0] * v[0] + m[1] * v[1] > 0


class TestLength:
    def test_thirty_thousand_additions_of_different_roots(self) -> None:
        chain = Real()
        for n in range(1, 30_001):
            chain = chain + sqrt(n)
        assert chain == total(sqrt(n) for n in range(30_000, 0, -1))
        assert chain.sign() == 1 and chain.decimal(10) == "3464188.01"

    def test_thirty_thousand_additions_with_a_nested_root(self) -> None:
        chain = Real()
        for _ in range(30_000):
            chain = chain + SIN_PI_8 - R3
        assert chain == 30_000 * (SIN_PI_8 - R3) and len(str(chain)) < 60

    def test_large_radicands_in_a_long_sum(self) -> None:
        values = [sqrt(10**18 + n) for n in range(2000)]
        chain = Real()
        for x in values:
            chain = chain + x
        for x in reversed(values):
            chain = chain - x
        assert chain == 0

    def test_mixing_too_many_roots_is_refused_and_less_is_not(self) -> None:
        primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31]
        many = total(sqrt(p) for p in primes)
        assert many.sign() == 1 and many * many > many
        for operation in (lambda: 1 / many, lambda: sqrt(many)):
            with pytest.raises(TooManyRoots) as caught:
                operation()
            assert caught.value.limit == radicals.MAX_RANK
        five = total(sqrt(p) for p in primes[:5])
        assert 1 / five * five == 1 and sqrt(five * five) == five
        chain = Real()
        with pytest.raises(TooManyRoots) as caught:
            for p in primes:
                chain += sqrt(1 + sqrt(p))
        assert caught.value.limit == nested.MAX_ROOTS
        deep = R2
        with pytest.raises(TooManyRoots):
            for _ in range(nested.MAX_ROOTS + 1):
                assert (deep := sqrt(2 + deep)) < 2


class TestConversions:
    def test_floats_are_refused_everywhere(self) -> None:
        with pytest.raises(TypeError, match="enclosure"):
            float(R2)
        operations: list[Callable[[], Any]] = [
            lambda: Real(0.5), lambda: sqrt(2.0), lambda: math.sqrt(R2), lambda: R2 + 0.5, lambda: 0.5 * R2,
            lambda: R2 < 1.5, lambda: R2 == 1.5, lambda: 2.0 / R2, lambda: R2 - 1j,
            lambda: gmpy2.mpfr(1) + R2,
        ]
        for operation in operations:
            with pytest.raises(TypeError):
                operation()

    def test_what_is_no_number_is_refused_but_differs(self) -> None:
        assert R2 != "sqrt(2)" and R2 is not None
        for operation in (lambda: R2 + "1", lambda: R2 < None, lambda: Real("1"), lambda: R2 ** R2):
            with pytest.raises(TypeError):
                operation()

    @few
    @given(st.fractions())
    def test_rationals_come_and_go(self, q: Fraction) -> None:
        x = Real(q)
        assert x.rational() == q and x == q and hash(x) == hash(q) and x.is_rational()
        assert x.enclosure() == (q, q)
        assert mpq(q) == x and q == x and x + mpq(q) == 2 * q and mpq(q) - x == 0 and mpz(2) * x == 2 * q
        assert math.floor(x) == math.floor(q) and math.ceil(x) == math.ceil(q) and bool(x) == bool(q)

    def test_an_irrational_is_no_rational(self) -> None:
        for x in (R2, SIN_PI_8):
            assert not x.is_rational()
            with pytest.raises(ValueError, match="irrational"):
                x.rational()

    def test_a_root_of_a_negative_number_is_refused(self) -> None:
        with pytest.raises(ValueError, match="negative"):
            sqrt(R2 - R3)
        assert sqrt(R2 * R3 - R6) == 0

    @few
    @given(reals(), st.integers(1, 400))
    def test_enclosures_keep_their_promise(self, x: Real, bits: int) -> None:
        lower, upper = x.enclosure(bits)
        assert lower <= x <= upper
        assert (upper - lower) * mpq(2) ** bits <= abs(x)

    @few
    @given(reals(), st.integers(2, 40))
    def test_decimals_are_rounded_correctly(self, x: Real, digits: int) -> None:
        with mpmath.workdps(120):
            y = x.fold(_mpf, mpmath.sqrt)
            text = x.decimal(digits)
            assert abs(mpmath.mpf(text) - y) <= abs(y) * mpmath.mpf(10) ** (1 - digits) / 2 * (1 + 1e-30)

    def test_texts(self) -> None:
        assert str(SIN_PI_8 / 8) == "sqrt(2 - sqrt(2))/16"
        assert repr(mpq(-3, 4) * R2 - 1) == "Real(-1 - 3*sqrt(2)/4)"
        assert str(Real()) == "0" and str(sqrt(mpq(1, 2))) == "sqrt(2)/2" and R2.decimal(5) == "1.4142"
        assert (sqrt(10**200 + 1) - 10**100).decimal(3) == "5e-101"

    @few
    @given(reals())
    def test_pickling(self, x: Real) -> None:
        again = pickle.loads(pickle.dumps(x))
        assert again == x and again - x == 0 and again * 1 - x + 1 == 1 and str(again) == str(x)


def orientation(ax: Any, ay: Any, bx: Any, by: Any, cx: Any, cy: Any) -> Any:
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


class TestFilter:
    def calls(self, *values: Real) -> tuple[int, list[str]]:
        seen: list[str] = []

        def watched(*arguments: Any) -> Any:
            seen.append(str(getattr(arguments[0], "bits", "exact")))
            return orientation(*arguments)

        return sign_of(watched, *values), seen

    def test_the_path_that_decides(self) -> None:
        zero, one = Real(0), Real(1)
        assert self.calls(zero, zero, one, zero, R2, R3) == (1, ["64"])
        close = sqrt(10**40 + 1) - 10**20
        assert self.calls(zero, zero, one, R2, R2, 2 - close) == (-1, ["64", "128", "256"])
        closest = sqrt(10**200 + 1) - 10**100
        assert self.calls(zero, zero, one, R2, R2, 2 + closest) == (1, ["64", "128", "256", "512", "exact"])
        assert self.calls(zero, zero, R3, R6, R2, Real(2)) == (0, ["64", "128", "256", "512", "exact"])

    @few
    @given(st.lists(surds(), min_size=6, max_size=6))
    def test_it_agrees_with_the_expanded_polynomial(self, values: list[Real]) -> None:
        assert sign_of(orientation, *values) == orientation(*values).sign()

    @few
    @given(st.lists(st.fractions(-8, 8, max_denominator=9), min_size=4, max_size=4), st.integers(2, 80))
    def test_interval_operations_contain_the_exact_results(self, q: list[Fraction], bits: int) -> None:
        a, b, c, d = (mpq(x) for x in q)
        first, second = (Interval(Interval.of(min(p), bits).low, Interval.of(max(p), bits).high, bits)
                         for p in ((a, b), (c, d)))
        for x in (a, b, (a + b) / 2):
            for y in (c, d, (c + d) / 2):
                results = [(first + second, x + y), (first - second, x - y), (first * second, x * y),
                           (-first, -x), (first + y, x + y), (x - second, x - y), (first * y, x * y)]
                assert all(mpq(r.low) <= exact <= mpq(r.high) for r, exact in results)

    def test_overflow_raises(self) -> None:
        huge = Interval.of(mpz(1) << 1000, 64)
        with pytest.raises(gmpy2.OverflowResultError):
            for _ in range(30):
                huge = huge * huge


class TestHarm:
    """Each harm is a plausible slip; `laws` must notice it."""

    def laws(self) -> None:
        p = PRIMES[2]
        for x in (R2 + 3, R2 + R3 + R5, sqrt(1 + R2) + R3, R2 * R3 - R5):
            assert x * (1 / x) == 1
        assert sqrt(p * p * 6151 * 6163) - p * sqrt(6151 * 6163) == 0
        assert hash(sqrt(p * p * 6151 * 6163)) == hash(p * sqrt(6151 * 6163))
        assert sqrt(5 + 2 * R6) == R2 + R3
        assert sqrt(2 - R2) * sqrt(2 + R2) == R2
        assert sqrt(1 + R2) != sqrt(1 + R3) and sqrt(1 + R2) + 1 != 1
        for bits in (64, 128):
            enclosure = R2.interval(bits) * R2.interval(bits)
            assert mpq(enclosure.low) <= 2 <= mpq(enclosure.high)
            enclosure = SIN_PI_8.interval(bits)
            low, high = mpq(enclosure.low), mpq(enclosure.high)
            assert 2 * (1 - 2 * low**2) ** 2 >= 1 >= 2 * (1 - 2 * high**2) ** 2

    @pytest.fixture(autouse=True)
    def fresh_caches(self) -> Iterator[None]:
        yield
        clear_caches()

    def test_unharmed(self) -> None:
        self.laws()

    def test_zero_test_that_compares_radicands_only(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(Radical, "__eq__", lambda r, s: r.n == s.n)
        self.refused()

    def test_ratio_upside_down(self, monkeypatch: pytest.MonkeyPatch) -> None:
        ratio = Radical.ratio
        monkeypatch.setattr(Radical, "ratio", lambda r, s: ratio(r, s)[::-1])
        self.refused()

    def test_wrong_conjugate(self, monkeypatch: pytest.MonkeyPatch) -> None:
        # The sign of the first irrational term alone is changed, which is no automorphism.
        def split(x: SurdSum) -> tuple[SurdSum, SurdSum]:
            first = next(r for r in x.terms if r is not ONE)
            rest = {r: t for r, t in x.terms.items() if r is not first}
            return SurdSum(rest), SurdSum({first: x.terms[first]})

        def inverse(x: SurdSum) -> SurdSum:
            fixed, moved = split(x)
            norm = (fixed * fixed - moved * moved).terms
            return (fixed - moved) * SurdSum({r: (r, 1 / (c * r.n)) for r, (_, c) in norm.items()})

        monkeypatch.setattr(SurdSum, "inverse", inverse)
        self.refused()

    def test_conjugate_not_conjugated(self, monkeypatch: pytest.MonkeyPatch) -> None:
        def inverse(x: Nested) -> Any:
            norm = (x.a * x.a - x.b * x.b * x.root.square).inverse()
            return nested._made(x.root, x.a * norm, x.b * norm)

        monkeypatch.setattr(Nested, "inverse", inverse)
        self.refused()

    def test_roots_that_are_never_found_in_the_field(self, monkeypatch: pytest.MonkeyPatch) -> None:
        rational = SurdSum.root
        monkeypatch.setattr(SurdSum, "root", lambda x: rational(x) if x.rational() is not None else None)
        self.refused()

    def test_dependent_roots_that_are_not_aligned(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(algebraic, "aligned", lambda x, y: (x, y))
        self.refused()

    def test_rounding_the_wrong_way(self, monkeypatch: pytest.MonkeyPatch) -> None:
        rounding = interval._rounding
        monkeypatch.setattr(interval, "_rounding", lambda bits: rounding(bits)[::-1])
        self.refused()

    def test_nested_values_that_pass_for_zero(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(Nested, "__bool__", lambda x: False, raising=False)
        self.refused()

    def refused(self) -> None:
        clear_caches()
        for x in (R2, R3, R5, R6, SIN_PI_8):
            x._interval = None
        try:
            with pytest.raises((AssertionError, ValueError, ZeroDivisionError)):
                self.laws()
        finally:
            for x in (R2, R3, R5, R6, SIN_PI_8):
                x._interval = None


def clear_caches() -> None:
    for cached in (radicals.radical, radicals.product, radicals.root_enclosure, nested._images):
        cached.cache_clear()


def test_the_sum_of_surds_has_no_public_state() -> None:
    x = R2 + R3
    before = str(x)
    _ = x + R2, x * R3, -x, 1 / x, surd_sum.total([x._element, x._element])
    assert str(x) == before
