"""Numbers in detail: messages, defaults, limits, and the paths that broad laws do not tell apart."""

import itertools
import math
import pickle
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import gmpy2
import pytest
from gmpy2 import mpfr, mpq, mpz

from exactmesh.errors import FormatError
from exactmesh.numbers import algebraic, nested, radicals, separation, surd_sum
from exactmesh.numbers.algebraic import Real, sqrt, total
from exactmesh.numbers.interval import Interval, sign_by_widening, sign_of
from exactmesh.numbers.nested import Nested, Root
from exactmesh.numbers.radicals import MAX_RANK, ONE, TooManyRoots
from exactmesh.numbers.rational import (
    decimal_text,
    rational,
    rational_from_float,
    rational_from_text,
    sqrt_below,
    sqrt_text,
)
from exactmesh.numbers.root import exact_text, number_text, root_expression, root_text
from exactmesh.numbers.separation import Expr, Undecided, separation_bits
from exactmesh.numbers.surd_sum import SurdSum


class TestRational:
    @pytest.mark.parametrize("text, reason", [
        ("x", "'x' is not an integer, a finite decimal or a fraction p/q"),
        ("1/0", "denominator of '1/0' is zero"),
        ("1e100001", "the exponent of '1e100001' is beyond 100000"),
        ("y" * 40, f"'{'y' * 40}' is not an integer, a finite decimal or a fraction p/q"),
        ("y" * 41, f"'{'y' * 37}...' is not an integer, a finite decimal or a fraction p/q")])
    def test_a_refusal_quotes_what_it_refuses_and_says_why(self, text: str, reason: str) -> None:
        for read in (rational, rational_from_text):
            with pytest.raises(FormatError) as caught:
                read(text)
            assert caught.value.reason == str(caught.value) == reason

    def test_a_double_without_a_place_is_refused_by_its_value(self) -> None:
        with pytest.raises(FormatError, match=r"^inf is not a finite number$"):
            rational_from_float(float("inf"))

    def test_an_exponent_of_zeros(self) -> None:
        assert rational_from_text("5e0") == rational_from_text("5e+00") == rational_from_text("5E-000") == 5

    def test_twelve_digits_unless_told_otherwise(self) -> None:
        assert decimal_text(mpq(1, 3)) == "0." + "3" * 12
        assert sqrt_text(mpq(1, 9)) == "0." + "3" * 12

    @pytest.mark.parametrize("value, digits, text", [
        (mpq(1, 10**5), 1, "0.00001"), (mpq(1, 10**6), 1, "1e-6"), (mpq(12, 10**7), 3, "1.2e-6"),
        (mpq(12), 1, "10"), (mpq(123), 3, "123"), (mpq(10**20), 1, "1" + 20 * "0"), (mpq(10**21), 1, "1e21"),
        (mpq(1234 * 10**18), 4, "1.234e21"), (mpq(123 * 10**18), 3, "123" + 18 * "0")])
    def test_where_the_point_stands(self, value: mpq, digits: int, text: str) -> None:
        assert decimal_text(value, digits) == text
        assert decimal_text(-value, digits) == f"-{text}"

    def test_a_root_from_below_has_at_least_one_bit(self) -> None:
        assert sqrt_below(mpq(3), 1) == 1 and sqrt_below(mpq(2), 2) == 1 and sqrt_below(mpq(2), 3) == mpq(5, 4)
        for squared, bits in ((mpq(0), 3), (mpq(2), 0), (mpq(2), -1)):
            with pytest.raises(ValueError, match=f"^squared and bits must be positive, not {squared} and {bits}$"):
                sqrt_below(squared, bits)

    @pytest.mark.parametrize("scale", range(-9, 10))
    def test_a_root_from_below_is_the_longest_that_fits(self, scale: int) -> None:
        for numerator in (1, 2, 3, 5, 7, 15, 16, 17):
            squared = numerator * mpq(2) ** scale
            r = sqrt_below(squared, 4)
            unit = max(mpq(2) ** k for k in range(-12, 12) if r >= 8 * mpq(2) ** k)
            assert (r / unit).denominator == 1 and r * r <= squared < (r + unit) ** 2 and r < 16 * unit


def ends(x: Interval) -> tuple[mpq, mpq]:
    return mpq(x.low), mpq(x.high)


def between(low: int, high: int, bits: int = 64) -> Interval:
    return Interval(mpfr(low, bits), mpfr(high, bits), bits)


class TestInterval:
    @pytest.mark.parametrize("bits", [2, 24, 64, 100])
    def test_an_interval_around_a_number_is_the_narrowest(self, bits: int) -> None:
        for value in (mpq(1, 3), mpq(-1, 3), mpq(22, 7), mpz(3**200), mpz(-(3**200))):
            x = Interval.of(value, bits)
            assert x.low < value < x.high and x.bits == bits
            assert x.low.precision == x.high.precision == bits
            assert gmpy2.next_above(x.low) == x.high
        for value in (0, 1, -1, mpq(3, 4)):
            assert ends(Interval.of(value, bits)) == (value, value)

    def test_the_sign_is_that_of_all_numbers_inside(self) -> None:
        assert [between(*pair).sign() for pair in ((1, 2), (-2, -1), (0, 0), (0, 1), (-1, 0), (-1, 1))] == [
            1, -1, 0, None, None, None]

    def test_the_ends_of_a_result_are_those_of_the_numbers_inside(self) -> None:
        pairs = [(a, b) for a, b in itertools.product(range(-3, 4), repeat=2) if a <= b]
        for first, second in itertools.product(pairs, repeat=2):
            x, y = between(*first), between(*second)
            for result, operation in ((x + y, int.__add__), (x - y, int.__sub__), (x * y, int.__mul__)):
                exact = [operation(a, b) for a, b in itertools.product(first, second)]
                assert ends(result) == (min(exact), max(exact)) and result.bits == 64
        for low, high in pairs:
            x = between(low, high)
            assert ends(-x) == (-high, -low) and (-x).bits == 64
            for n in (-2, 0, 3):
                for result, exact in ((x + n, (low + n, high + n)), (n + x, (low + n, high + n)),
                                      (x - n, (low - n, high - n)), (n - x, (n - high, n - low)),
                                      (x * n, (low * n, high * n)), (n * x, (low * n, high * n))):
                    assert ends(result) == (min(exact), max(exact)) and result.bits == 64

    def test_each_end_is_rounded_outwards(self) -> None:
        third, seventh = Interval.of(mpq(1, 3), 20), Interval.of(mpq(1, 7), 20)
        negative = Interval.of(mpq(-1, 3), 20)
        around = Interval(-third.high, seventh.high, 20)
        for x, y in itertools.product((third, seventh, negative, around), repeat=2):
            for result, operation in ((x + y, mpq.__add__), (x - y, mpq.__sub__), (x * y, mpq.__mul__)):
                exact = [operation(a, b) for a, b in itertools.product(ends(x), ends(y))]
                low, high = ends(result)
                assert low <= min(exact) and max(exact) <= high
                assert gmpy2.next_above(result.low) > min(exact) and gmpy2.next_below(result.high) < max(exact)

    def test_a_root_is_that_of_what_is_not_negative(self) -> None:
        assert ends(between(4, 9).root()) == (2, 3) and ends(between(-5, 16).root()) == (0, 4)
        quarter = Interval.of(mpq(1, 4), 64)
        assert ends(quarter.root()) == (mpq(1, 2), mpq(1, 2)) and ends((quarter * 4).root()) == (1, 1)
        assert ends(between(0, 1).root()) == (0, 1) and between(1, 4, 33).root().bits == 33
        two = Interval.of(2, 30).root()
        assert ends(two)[0] ** 2 < 2 < ends(two)[1] ** 2 and gmpy2.next_above(two.low) == two.high
        with pytest.raises(gmpy2.InvalidOperationError):
            between(-5, -4).root()

    @pytest.mark.parametrize("low, high", [(0, 1), (-1, 0)])
    def test_overflow_raises_at_either_end(self, low: int, high: int) -> None:
        top = mpfr(2) ** (1 << 29)
        x = Interval(low * top, high * top, 64)
        with pytest.raises(gmpy2.OverflowResultError):
            _ = x * Interval(mpfr(1), top, 64) * Interval(mpfr(1), top, 64)

    def test_widening_begins_with_64_bits_and_doubles_them(self) -> None:
        for value, last in ((mpq(1), 64), (mpq(-1, 2**40), 64), (mpq(1, 2**200), 256), (mpq(-1, 2**900), 1024)):
            seen: list[int] = []

            def enclosure(bits: int, value: mpq = value, seen: list[int] = seen) -> Interval:
                seen.append(bits)
                return Interval.of(value, bits) + Interval(mpfr(-1), mpfr(1), bits) * (mpq(1, 2) ** bits)

            assert sign_by_widening(enclosure) == (1 if value > 0 else -1)
            assert seen == [64 << k for k in range(len(seen))] and seen[-1] == last

    def test_a_sign_beyond_512_bits_is_that_of_the_values(self) -> None:
        class Vague:
            """A number whose intervals contain zero until it has so many bits."""

            def __init__(self, value: int, enough: int) -> None:
                self.value, self.enough = value, enough

            def interval(self, bits: int) -> Interval:
                return Interval.of(self.value, bits) if bits >= self.enough else between(-1, 1, bits)

            def sign(self) -> int:
                return 7

        def same(x: Any) -> Any:
            return x

        for value in (-3, 0, 5):
            for enough in (64, 128, 512):
                assert sign_of(same, Vague(value, enough)) == (value > 0) - (value < 0)
            assert sign_of(same, Vague(value, 1024)) == 7


class TestRadicals:
    def test_too_many_roots_says_how_many_are_allowed(self) -> None:
        error = TooManyRoots(7)
        assert str(error) == "more than 7 independent square roots would be mixed" and error.limit == 7

    def test_a_radical_is_the_square_free_part_where_that_is_seen(self) -> None:
        for n in range(1, 500):
            q, r = radicals.radical(mpz(n))
            free = max(d for d in range(1, n + 1) if n % (d * d) == 0)
            assert (q, r.n) == (free, n // free**2) and (r is ONE) == (n == free**2)
        p = mpz(6151)
        for n in (1, 2, 12, 30):
            q, r = radicals.radical(n * p * p)
            assert q * q * r.n == n * p * p and r.n == radicals.radical(mpz(n))[1].n
        q, r = radicals.radical(p * p * 6163)  # a square of a large prime stays hidden beside another one
        assert (q, r.n) == (1, p * p * 6163)

    def test_radicals_are_equal_when_they_differ_by_a_rational(self) -> None:
        big = [6151, 6163, 2**61 - 1]
        for a, b in itertools.product(big, repeat=2):
            for n, m in itertools.product((1, 2, 6), repeat=2):
                x, y = radicals.radical(mpz(n * a))[1], radicals.radical(mpz(m * b * 6173**2))[1]
                equal = (n, a) == (m, b)
                assert (x == y) == equal and (not equal or hash(x) == hash(y))
                if equal:
                    numerator, denominator = x.ratio(y)
                    assert numerator**2 * y.n == denominator**2 * x.n
        x = radicals.radical(mpz(5))[1]
        assert x != 5 and x == x and x != "x"

    def test_hashes_tell_large_radicands_apart(self) -> None:
        primes = [6151]
        while len(primes) < 200:
            primes.append(int(gmpy2.next_prime(primes[-1])))
        for factor in (1, 6):
            assert len({hash(radicals.radical(mpz(factor * p))[1]) for p in primes}) > 190
        assert len({hash(radicals.radical(mpz(p * 6151))[1]) for p in primes[1:]}) > 190

    def test_a_product_is_the_root_of_the_product(self) -> None:
        for n, m in itertools.product((1, 2, 3, 6, 10, 15, 6151, 6151 * 2, 6151 * 6163), repeat=2):
            q, r = radicals.product(mpz(n), mpz(m))
            assert q > 0 and q * q * r.n == n * m and r == radicals.radical(mpz(n * m))[1]

    def test_the_enclosure_of_a_root(self) -> None:
        for bits in (10, 64):
            low, high = ends(radicals.root_enclosure(mpz(7), bits))
            assert low**2 < 7 < high**2 and high - low <= mpq(4, 2**bits)

    def test_a_separating_prime_negates_one_and_divides_none(self) -> None:
        rows = [radicals.radical(mpz(n))[1] for n in (2, 3, 5, 6, 30, 6151 * (2**31 + 11))]
        for moved in rows:
            p = radicals.separating_prime(moved, rows)
            assert gmpy2.is_prime(p) and p > 4096 and gmpy2.legendre(moved.n, p) == -1
            assert all(r.n % p for r in rows)
        # 2**31 + 11 is the first prime that is tried, and divides one of them.
        assert radicals.separating_prime(rows[0], []) != 2**31 + 11 or radicals.separating_prime(
            rows[0], rows) != 2**31 + 11

    @pytest.mark.parametrize("integers, expected", [
        ((), 0), ((1,), 0), ((2,), 1), ((2, 3), 2), ((2, 3, 6), 2), ((6, 10, 15), 2), ((2, 3, 5, 30, 1, 10), 3),
        ((6151 * 2, 6163 * 2, 6151 * 6163), 2), ((6, 35, 10, 21), 3)])
    def test_rank_is_the_number_of_independent_ones(self, integers: tuple[int, ...], expected: int) -> None:
        for order in itertools.islice(itertools.permutations(integers), 24):
            assert radicals.rank([radicals.radical(mpz(n))[1] for n in order]) == expected

    def test_rank_has_a_limit(self) -> None:
        primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31]
        rows = [radicals.radical(mpz(p))[1] for p in primes]
        assert radicals.rank(rows[:MAX_RANK]) == MAX_RANK == 10
        with pytest.raises(TooManyRoots) as caught:
            radicals.rank(rows)
        assert caught.value.limit == 10
        assert radicals.rank([*rows[:10], radicals.radical(mpz(math.prod(primes[:10])))[1]]) == 10


def surds(*terms: tuple[int | Fraction, int]) -> SurdSum:
    """Return the sum of c * sqrt(n)."""
    return surd_sum.total(SurdSum.root_of(mpq(n)).scaled(mpq(c)) for c, n in terms)


def same(x: Any, y: Any) -> bool:
    return not x - y


class TestSurdSums:
    ONE_OF_EACH = (surds(), surds((3, 1)), surds((Fraction(-2, 3), 2)), surds((1, 1), (1, 2)), surds((1, 2), (1, 3)),
                   surds((2, 1), (-1, 3), (Fraction(1, 2), 6)), surds((1, 6151 * 6163), (2, 6151)))

    def test_rationals_and_roots(self) -> None:
        assert surds().rational() == 0 and not surds() and surds((3, 1)).rational() == 3
        for x in (surds((1, 2)), surds((1, 1), (1, 2)), surds((1, 2), (1, 3))):
            assert x.rational() is None and x
        assert SurdSum.root_of(mpq(0)).rational() == 0 and SurdSum.root_of(mpq(9, 4)).rational() == mpq(3, 2)
        assert same(SurdSum.root_of(mpq(8, 9)), surds((Fraction(2, 3), 2)))
        assert SurdSum.of(mpq(0)).terms == {} and SurdSum.of(mpq(5)).rational() == 5

    def test_operations_against_digits(self) -> None:
        def digits(x: SurdSum) -> mpq:
            return mpq(x.enclosure(400).low)

        for x, y in itertools.product(self.ONE_OF_EACH, repeat=2):
            a, b = digits(x), digits(y)
            for found, expected in ((x + y, a + b), (x - y, a - b), (x * y, a * b), (-x, -a)):
                assert abs(digits(found) - expected) < mpq(1, 2**300)
            assert x.sign() == gmpy2.sign(a if abs(a) > mpq(1, 2**300) else mpq(0))
            assert same(x.scaled(mpq(3, 7)), x * surds((Fraction(3, 7), 1))) and not x.scaled(mpq(0))
            if x:
                assert same(x * x.inverse(), surds((1, 1))) and same((x * x).inverse() * x, x.inverse())
            root = (x * x).root()
            assert root is not None and (same(root, x) or same(root, -x))
        for x in self.ONE_OF_EACH:
            for operation in ("__add__", "__sub__", "__mul__"):
                assert getattr(x, operation)("x") is NotImplemented

    @pytest.mark.parametrize("square", [
        surds((-1, 1)), surds((1, 1), (-1, 2)), surds((1, 1), (1, 2)), surds((3, 1), (1, 2), (1, 3)), surds((1, 2)),
        surds((-5, 1), (-2, 6)), surds((5, 1), (2, 5))])
    def test_what_has_no_root_in_the_field(self, square: SurdSum) -> None:
        assert square.root() is None

    def test_roots_of_sums(self) -> None:
        for x in (surds((1, 2), (1, 3)), surds((1, 2), (-1, 3)), surds((1, 1), (2, 5)), surds((3, 2), (1, 6), (1, 7)),
                  surds((1, 2), (1, 3), (1, 5), (1, 7)), surds((1, 6151 * 6163), (2, 6151))):
            root = (x * x).root()
            assert root is not None and (same(root, x) or same(root, -x))
        with pytest.raises(ZeroDivisionError, match=r"^division by an exact zero$"):
            surds().inverse()

    def test_content_is_the_largest_rational_that_divides_all_coefficients(self) -> None:
        assert surds().content() == 0
        for terms, content in ((((6, 1),), 6), (((-6, 2), (9, 3)), 3), (((Fraction(4, 3), 1), (Fraction(6, 5), 2)),
                                                                        Fraction(2, 15))):
            assert surds(*terms).content() == content

    def test_terms_are_written_by_their_radicands(self) -> None:
        x = surds((5, 7), (-2, 3), (1, 1), (Fraction(1, 2), 10))
        assert list(x.products()) == [(1, ()), (-2, ("sqrt(3)",)), (5, ("sqrt(7)",)), (mpq(1, 2), ("sqrt(10)",))]

    def test_the_enclosure_of_a_rational_is_the_narrowest(self) -> None:
        x = surds((Fraction(1, 3), 1)).enclosure(30)
        assert gmpy2.next_above(x.low) == x.high and x.bits == 30
        assert ends(surds().enclosure(30)) == (0, 0)
        low, high = ends(surds((3, 2), (-1, 3)).enclosure(60))
        assert 0 < high - low < mpq(1, 2**56)

    def test_division_has_a_limit_of_ten_independent_roots(self) -> None:
        primes = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31)
        eleven = surds(*((1, p) for p in primes))
        long = surds(*((1, n) for n in range(1, 2500)))
        for x in (eleven, long):
            assert len(x.terms) > MAX_RANK
            for operation in (x.inverse, x.root):
                with pytest.raises(TooManyRoots) as caught:
                    operation()
                assert caught.value.limit == 10
        many_of_few = surds(*((1, math.prod(c)) for k in (1, 2) for c in itertools.combinations(primes[:5], k)))
        assert len(many_of_few.terms) == 15 and same(many_of_few * many_of_few.inverse(), surds((1, 1)))

    def test_hidden_squares_are_written_as_what_stands_there(self) -> None:
        p, q = 2**61 - 1, 6151
        x = surds((1, p * p * q * 6163), (1, q * 6163))
        assert same(x, surds((p + 1, q * 6163))) and len(x.terms) == 1
        assert not surds((1, p * p * q * 6163), (-p, q * 6163)) and not surds((p, q * 6163), (-1, p * p * q * 6163))


R2, R3, R5 = (sqrt(n) for n in (2, 3, 5))
DEEP = sqrt(2 + R2)


class TestNested:
    @pytest.mark.parametrize("x, text", [
        (Real(), "0"), (Real(-3), "-3"), (Real(Fraction(-3, 4)), "-3/4"), (R2, "sqrt(2)"), (-R2, "-sqrt(2)"),
        (R2 / 2, "sqrt(2)/2"), (-3 * R2 / 2, "-3*sqrt(2)/2"), (R3 + R2, "sqrt(2) + sqrt(3)"), (R2 - 1, "-1 + sqrt(2)"),
        (1 - R2 - 2 * R3 / 7, "1 - sqrt(2) - 2*sqrt(3)/7"), (DEEP, "sqrt(2 + sqrt(2))"),
        (R3 * DEEP / 5 - R2, "-sqrt(2) + sqrt(3)*sqrt(2 + sqrt(2))/5"),
        (sqrt(1 + DEEP), "sqrt(1 + sqrt(2 + sqrt(2)))"), (sqrt(12 + 6 * R2), "sqrt(6)*sqrt(2 + sqrt(2))"),
        (sqrt(Fraction(2, 3) + R2 / 3), "sqrt(3)*sqrt(2 + sqrt(2))/3"),
        (DEEP * sqrt(1 + R3), "sqrt(1 + sqrt(3))*sqrt(2 + sqrt(2))"),
        (sqrt(1 + R2) * sqrt(1 + R3) - sqrt(1 + R2), "-sqrt(1 + sqrt(2)) + sqrt(1 + sqrt(2))*sqrt(1 + sqrt(3))")])
    def test_the_form_of_expressions(self, x: Real, text: str) -> None:
        assert x.expression() == str(x) == text and repr(x) == f"Real({text})" and exact_text(x) == text
        assert abs(eval(text, {"sqrt": math.sqrt}) - float(x.decimal(17))) < 1e-14

    def test_roots_are_ordered_by_depth_and_then_by_text(self) -> None:
        a, b, c = Root(surds((1, 1), (1, 2))), Root(surds((1, 1), (1, 3))), Root((1 + DEEP)._element)
        assert (a.key, b.key) == ((1, "sqrt(1 + sqrt(2))"), (1, "sqrt(1 + sqrt(3))"))
        assert c.key == (2, "sqrt(1 + sqrt(2 + sqrt(2)))") and c.inside == {Root((2 + R2)._element)}
        assert a == Root(surds((1, 1), (1, 2))) and hash(a) == hash(Root(surds((1, 1), (1, 2)))) and a != b and a != "x"

    def test_the_enclosure_of_a_root_is_that_of_the_bits_asked_for(self) -> None:
        root = Root(surds((2, 1), (1, 2)))
        for bits in (20, 20, 50, 20):
            x = root.enclosure(bits)
            assert x.bits == bits and mpq(1, 2 ** (bits + 4)) < mpq(x.high - x.low) < mpq(1, 2 ** (bits - 6))
        assert root.enclosure(20) is root.enclosure(20)

    def test_sums_and_products_of_values_with_different_roots(self) -> None:
        values = [Real(3), R2, DEEP, sqrt(1 + R3), 1 + 2 * DEEP, R3 - sqrt(1 + R2), sqrt(1 + DEEP), DEEP * sqrt(1 + R3)]
        for x, y in itertools.product(values, repeat=2):
            a, b = (mpq(v.interval(300).low) for v in (x, y))
            for found, expected in ((x + y, a + b), (x - y, a - b), (x * y, a * b), (x / y, a / b)):
                assert abs(mpq(found.interval(300).low) - expected) < mpq(1, 2**200)
            assert (x + y) - y == x and x * y / y == x and (x == y) == (x is y) and 0 - (-x) == x

    def test_dependent_roots_that_meet_are_written_by_each_other(self) -> None:
        up, down = sqrt(2 + R2), sqrt(2 - R2)
        a, b = sqrt(1 + R2), sqrt(1 + R3)
        values = [up, down, 3 - R3 * down, sqrt(1 + down), sqrt(2 + 2 * up), sqrt(4 + up - down), a, b,
                  sqrt((1 + R2) * (1 + R3)), sqrt(5 + 5 * R2) + b, sqrt(3 * (1 + R2) * (1 + R3) * (2 + R2)) - up,
                  a + b - up, sqrt(1 + a), sqrt(1 + sqrt((1 + R2) * 7)) + b, R2 - 1 - down * b]
        digits = [mpq(x.interval(400).low) for x in values]
        for (x, p), (y, q) in itertools.product(zip(values, digits, strict=True), repeat=2):
            for found, expected in ((x + y, p + q), (x - y, p - q), (x * y, p * q)):
                assert abs(mpq(found.interval(400).low) - expected) < mpq(1, 2**300)
            assert (x + y) - x == y and (x - y) - (x + y) + 2 * y == 0 and x * y == y * x
            assert (x == y) == (x is y) and (x < y) == (p < q)
        assert up * down == R2 and up - R2 / down == 0 and R2 / up - down == 0 and sqrt(1 + down) ** 2 == 1 + R2 / up
        assert sqrt((1 + R2) * (1 + R3)) == a * b == b * a and sqrt(5 + 5 * R2) - R5 * a == 0
        assert (a + b) - sqrt((1 + a) ** 2 * (1 + R3)) == a - a * b
        for factor in (a - 3, 2 * a - 3, 3 - a):
            assert (a + b) + sqrt(factor**2 * (1 + R3)) == a + b + abs(factor) * b
        tower = (Root((1 + R2)._element), Root((1 + R3)._element))
        found = nested.root_in(((1 + a) ** 2)._element, tower)
        assert found is not None and same(found * found, ((1 + a) ** 2)._element)
        assert (a + b + up) - (b + down) == a + up - R2 / up and (down + b) + (up + a) == a + (down + up) + b

    def test_content_is_taken_out_of_a_root(self) -> None:
        assert (4 + 6 * sqrt(2 + R2))._element.content() == 2 and (6 + 4 * sqrt(2 + R2))._element.content() == 2
        assert str(sqrt(2 + 2 * sqrt(2 + R2))) == "sqrt(2)*sqrt(1 + sqrt(2 + sqrt(2)))"
        assert sqrt(12 + 6 * R2) / DEEP == sqrt(6) and sqrt(18 + 9 * R2) == 3 * DEEP
        element = (2 * DEEP + 4 * R3)._element
        assert element.content() == 2 and (6 * DEEP)._element.content() == 6
        assert (DEEP / 3 + Fraction(1, 2))._element.content() == mpq(1, 6)
        assert element.rational() is None

    def test_roots_are_positive_and_of_the_right_field(self) -> None:
        for x in (1 - DEEP, DEEP - 1, R2 * DEEP - 5, sqrt(1 + R3) * DEEP - 7, 3 + 2 * DEEP, R5 - R3 * DEEP):
            assert sqrt(x * x) == abs(x) and sqrt(x * x) > 0
            assert sqrt(x * x * (2 + R2)) == abs(x) * DEEP
        assert nested.root_in((2 + R2)._element, ()) is None
        assert nested.root_in((-R2)._element, ()) is None and nested.root_in(surds(), ()) is surd_sum.ZERO
        deep = DEEP._element.root  # type: ignore[union-attr]
        found = nested.root_in((2 + R2)._element, (deep,))
        assert isinstance(found, Nested) and found.root == deep
        for x in (3 + R2, 1 + DEEP):
            assert nested.root_in(x._element, (deep,)) is None

    def test_more_nested_roots_than_the_limit_are_too_many(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(nested, "MAX_ROOTS", 2)
        two = sqrt(1 + R2) + sqrt(1 + R3)
        assert two - sqrt(1 + R2) == sqrt(1 + R3) and sqrt(two * two) == two
        for operation in (lambda: two + sqrt(1 + R5), lambda: sqrt(two * 3 + 1)):
            with pytest.raises(TooManyRoots) as caught:
                operation()
            assert caught.value.limit == 2

    def test_fold_rebuilds_a_value(self) -> None:
        for x in (Real(), Real(Fraction(2, 3)), R2 - R3 / 2, 3 + R2 * DEEP, sqrt(1 + DEEP) - R5):
            def of(q: mpq) -> Real:
                return Real(q)

            assert x.fold(of, sqrt) == x

    def test_pickles(self) -> None:
        for x in (R2 + 1, 3 * DEEP - R3, sqrt(1 + DEEP)):
            assert pickle.loads(pickle.dumps(x)) == x
            assert str(pickle.loads(pickle.dumps(x)) - x + x) == str(x)
        root = Root(surds((2, 1), (1, 2)))
        assert pickle.loads(pickle.dumps(root)) == root


class TestReal:
    def test_refusals_say_what_they_refuse(self) -> None:
        messages: list[tuple[Callable[[], object], type[Exception], str]] = [
            (lambda: Real("1"), TypeError,  # type: ignore[arg-type]
             "Real takes int, Fraction, mpz, mpq or Real, not str"),
            (lambda: sqrt(R2 - R3), ValueError, "square root of the negative number -0.317837245196"),
            (lambda: R2.rational(), ValueError, "1.41421356237 is irrational"),
            (lambda: float(R2), TypeError,
             "a Real is not rounded to a float silently: use enclosure(bits) or decimal(digits)"),
            (lambda: R2 + 0.5, TypeError, "a float is not exact: use int, Fraction, mpz or mpq"),
            (lambda: R2 + 1j, TypeError, "a complex is not exact: use int, Fraction, mpz or mpq"),
            (lambda: R2 + mpfr(1), TypeError, "a mpfr is not exact: use int, Fraction, mpz or mpq"),
            (lambda: R2 ** Fraction(1, 2), TypeError, "")]
        for operation, error, message in messages:
            with pytest.raises(error) as caught:
                operation()
            assert message in (str(caught.value), "")

    def test_what_is_no_number_is_left_to_the_other_operand(self) -> None:
        for name in ("add", "radd", "sub", "rsub", "mul", "rmul", "truediv", "eq", "lt", "le", "gt", "ge", "pow"):
            if name != "rsub":
                assert getattr(R2, f"__{name}__")("x") is NotImplemented, name

    def test_order_is_strict_or_not(self) -> None:
        near = R2 + Fraction(1, 10**40)
        for x, y in ((R2, near), (Real(1), R2), (DEEP, R5), (-R2, Real())):
            assert x < y and x <= y and y > x and y >= x and x != y
            assert not (y < x or y <= x or x > y or x >= y or x == y)
        for x, y in ((R2, sqrt(8) / 2), (Real(2), R2 * R2), (DEEP * DEEP, 2 + R2)):
            assert x <= y and x >= y and x == y and not x < y and not x > y
        assert R2 > 1 and R2 >= Fraction(7, 5) and R2 < mpq(3, 2) and R2 <= mpz(2) and 1 < R2 < 2  # noqa: SIM300
        assert (R2 - R2).sign() == 0 and R2.sign() == 1 and (-R2).sign() == -1 and (1 - DEEP).sign() == -1

    def test_signs_that_64_bits_do_not_tell(self) -> None:
        near = sqrt(10**60 + 1) - 10**30
        assert near.sign() == 1 and (-near).sign() == -1 and abs(-near) == near
        assert sqrt(Real(0)) == 0 == sqrt(near - near)
        # The filter in front: apart in 64 bits, or not; and the sign of a difference.
        assert R2._apart(R3) and R3._apart(R2) and not near._apart(Real(0)) and not R2._apart(R2)
        assert (R2._compared(R3), R3._compared(R2), R2._compared(R2), near._compared(0)) == (-1, 1, 0, 1)

    def test_powers(self) -> None:
        x = 1 + R2
        product = Real(1)
        for k in range(12):
            assert x**k == product and x**-k == 1 / product and x ** True == x
            product = product * x
        assert Real(0) ** 0 == 1 and R2**10 == 32

    def test_floor_and_ceiling_are_integers(self) -> None:
        n = 10**30
        for x, floor in ((Real(Fraction(7, 2)), 3), (Real(Fraction(-7, 2)), -4), (Real(3), 3), (R2, 1), (-R2, -2),
                         (sqrt(n * n + 1), n), (-sqrt(n * n + 1), -n - 1), (sqrt(n * n - 1), n - 1)):
            assert math.floor(x) == floor and type(math.floor(x)) is int
            assert math.ceil(x) == floor + (x != floor) and type(math.ceil(x)) is int

    def test_digits(self) -> None:
        assert R2.decimal() == "1.41421356237" and Real(Fraction(1, 3)).decimal() == "0.333333333333"
        assert Real(Fraction(1, 3)).decimal(3) == "0.333"
        assert R2.decimal(1) == "1" and (-R3).decimal(3) == "-1.73"
        assert sqrt(2 + R2).decimal(
            30) == "1.84775906502257351225636637879"
        assert number_text(R2) == "1.41421356237" and number_text(mpq(1, 3)) == "0.333333333333"
        assert number_text(R2, 3) == "1.41" and number_text(mpq(1, 3), 3) == "0.333"
        assert (sqrt(10**200 + 1) - 10**100).decimal(3) == "5e-101"

    def test_enclosures_are_as_narrow_as_asked_and_no_rational_needs_one(self) -> None:
        for x in (R2, -DEEP, R2 - Fraction(1414213562, 10**9), sqrt(10**80 + 1) - 10**40):
            for bits in (1, 53, 200):
                low, high = x.enclosure(bits)
                assert low < x < high and (high - low) * 2**bits <= min(abs(low), abs(high)) and low * high > 0
            low, high = x.enclosure()
            assert (high - low) * 2**53 <= min(abs(low), abs(high))
        assert Real(5).enclosure() == (5, 5) and Real(5).is_rational() and not R2.is_rational()

    def test_the_first_interval_is_kept(self) -> None:
        x = R2 + R3
        assert x.interval() is x.interval(64) and x.interval(65) is not x.interval(65)
        assert x.interval().bits == 64 and x.interval(65).bits == 65 and x.interval(32).bits == 32

    def test_hashes(self) -> None:
        assert hash(Real(3)) == hash(3) == hash(sqrt(9)) and hash(Real(Fraction(1, 3))) == hash(Fraction(1, 3))
        values = [sqrt(n) + m for n in (2, 3, 5, 7) for m in range(-9, 10)]
        assert len({hash(x) for x in values}) == len(values)
        assert hash(R2 + R3) == hash(sqrt(5 + 2 * sqrt(6)))
        for value in (mpq(1, 3), mpq(-7, 5), mpq(10**30, 7), mpq(1, 10**30), mpq(1), mpq(-1)):
            f, e = algebraic._leading_bits(value)
            assert f == math.floor(value * mpq(2) ** e) and abs(f).bit_length() in (64, 65) and type(f) is int

    def test_sums_of_many(self) -> None:
        assert total([]) == 0 and total([R2]) == R2 and total([R2, DEEP, R3, DEEP, Real(1)]) == R2 + R3 + 2 * DEEP + 1
        assert total(iter([DEEP, -DEEP])) == 0

    def test_numbers_on_the_left(self) -> None:
        for q in (3, Fraction(3, 2), mpq(3, 2), mpz(3)):
            assert q + R2 == R2 + q and q - R2 == -(R2 - q) and q * R2 == R2 * q and (q / R2) * R2 == q
            assert R2 - q + q == R2 and R2 / q * q == R2
        with pytest.raises(ZeroDivisionError):
            1 / Real(0)

    def test_signs_and_absolute_values(self) -> None:
        zero = Real()
        assert abs(zero) is zero
        assert +R2 is R2 and abs(R2) is R2 and abs(-R2) == R2 and abs(Real()) == 0 and bool(R2) and not Real()


class TestRootTexts:
    def test_exact_texts_of_roots(self) -> None:
        assert exact_text(mpq(3, 4)) == "3/4" and exact_text(R2 / 2) == "sqrt(2)/2"
        assert root_expression(R2) == "sqrt(sqrt(2))" and root_expression(sqrt(4)) == "sqrt(2)"
        assert root_expression(Real(Fraction(9, 4))) == "3/2" and root_expression(mpq(9, 2)) == "sqrt(9/2)"
        assert root_expression(mpq(2, 9)) == "sqrt(2/9)"

    def test_decimals_of_roots(self) -> None:
        assert root_text(mpq(2)) == "1.41421356237" and root_text(mpq(2), 3) == "1.41"
        assert root_text(R2) == "1.189207115" and root_text(R2, 4) == "1.189" and root_text(R2, 12) == "1.189207115"
        assert root_text(R2, 30) == "1.18920711500272106671749997056"
        assert root_text(Real()) == "0" and root_text(Real(4)) == "2"
        assert root_text(sqrt(10**40 + 1) - 10**20, 5) == "7.0711e-11"


class TestSeparation:
    def test_the_bounds_of_the_table(self) -> None:
        def logs(x: Expr) -> tuple[int, int]:
            return x.log_u, x.log_l

        five, third, big = Expr(5), Expr(Fraction(-1, 3)), Expr(mpq(1000, 7))
        assert (logs(five), logs(third), logs(big)) == ((3, 0), (1, 2), (10, 3))
        assert logs(five + third) == (1 + max(3 + 2, 0 + 1), 2) == logs(five - third)
        assert logs(third + big) == (1 + max(1 + 3, 2 + 10), 5) == logs(big - third)
        assert logs(third * big) == (11, 5) and logs(third / big) == (1 + 3, 2 + 10) and logs(five / third) == (5, 1)
        assert logs(big.sqrt()) == (7, 3) and logs(third.sqrt()) == (1, 2) and logs(five.sqrt()) == (2, 0)
        assert logs(Expr(mpq(1, 1000)).sqrt()) == (1, 6) and logs(Expr(mpq(3, 2)).sqrt()) == (2, 2)
        assert separation_bits(big, 0) == 3 and separation_bits(big, 1) == 13 and separation_bits(big, 3) == 73

    def test_operations_have_their_values(self) -> None:
        values = [Fraction(-3), Fraction(0), Fraction(1, 2), Fraction(7, 3)]
        for p, q in itertools.product(values, repeat=2):
            x, y = Expr(p), Expr(q)
            for found, value in ((x + y, p + q), (x - y, p - q), (x * y, p * q), (-x, -p), (x + q, p + q),
                                 (p + y, p + q), (x - q, p - q), (p - y, p - q), (x * q, p * q), (p * y, p * q)):
                assert found.sign() == (value > 0) - (value < 0) and (found - value).sign() == 0
            if q:
                for found in (x / y, p / y, x / q):
                    assert (found - p / q).sign() == 0
        assert (Expr(2).sqrt() * Expr(2).sqrt() - 2).sign() == 0 and Expr(0).sqrt().sign() == 0

    def test_refusals(self) -> None:
        two = Expr(2).sqrt()
        cases: list[tuple[Callable[[], object], type[Exception], str]] = [
            (lambda: (1 / (two * two - 2)).sign(), ZeroDivisionError, "division by an expression that is zero"),
            (lambda: (1 / Expr(0)).sign(), ZeroDivisionError, "division by an expression that is zero"),
            (lambda: (two - 3).sqrt().sign(), ValueError, "square root of a negative expression"),
            (lambda: two + 0.5, TypeError, "an Expr is made of int, Fraction or mpq, not float"),
            (lambda: two + "x", TypeError, "an Expr is made of int, Fraction or mpq, not str"),
            (lambda: (two - 2**70).sqrt().sign(max_bits=63), Undecided, "the sign is not decided at 63 bits")]
        for operation, error, message in cases:
            with pytest.raises(error) as caught:
                operation()
            assert str(caught.value) == message

    def test_bits_are_doubled_up_to_the_limit(self) -> None:
        x = Expr(10**200 + 1).sqrt() - 10**100
        for limit in (64, 512, 1023):
            with pytest.raises(Undecided) as caught:
                x.sign(max_bits=limit)
            assert caught.value.bits == limit
        assert x.sign(max_bits=1024) == x.sign() == 1
        assert Expr(2).sqrt().sign(max_bits=64) == 1 and (1 / x).sign() == 1 and x.sqrt().sign() == 1

    @pytest.fixture
    def counted(self, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[int]]:
        """Collect the numbers of roots for which the bound is asked."""
        seen: list[int] = []

        def watched(node: Expr, roots: int) -> int:
            seen.append(roots)
            return separation_bits(node, roots)

        monkeypatch.setattr(separation, "separation_bits", watched)
        yield seen

    def test_each_root_counts_once(self, counted: list[int]) -> None:
        two, again, three = Expr(2).sqrt(), Expr(2).sqrt(), Expr(3).sqrt()
        deep = Expr(2) + two
        for x, roots in ((two - again, 1), (two * three - Expr(6).sqrt(), 3), (deep.sqrt() - deep.sqrt(), 2),
                         (deep.sqrt() - (Expr(2) + two).sqrt(), 3), (Expr(mpq(1, 2)).sqrt() - two / 2, 2),
                         (Expr(0) * 1, 0)):
            counted.clear()
            assert x.sign() == 0 and set(counted) == {roots}

    def test_zero_divisors_and_zero_radicands_are_seen_at_any_depth(self) -> None:
        two = Expr(2).sqrt()
        zero = two * two - 2
        assert (zero.sqrt() + 1).sign() == 1 and (1 - zero.sqrt() * 5).sign() == 1
        tiny = Expr(10**60 + 1).sqrt() - 10**30
        assert (1 / tiny - 10**29).sign() == 1 and (tiny.sqrt() - mpq(1, 10**16)).sign() == 1
        assert ((two - 1) / tiny).sign() == 1 and ((1 - two) / tiny).sign() == -1
