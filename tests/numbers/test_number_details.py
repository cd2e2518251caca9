"""Numbers in detail: messages, defaults, limits, and the paths that broad laws do not tell apart."""

import itertools
import math
from typing import Any

import gmpy2
import pytest
from gmpy2 import mpfr, mpq, mpz

from exactmesh.errors import FormatError
from exactmesh.numbers import radicals
from exactmesh.numbers.interval import Interval, sign_by_widening, sign_of
from exactmesh.numbers.radicals import MAX_RANK, ONE, TooManyRoots
from exactmesh.numbers.rational import (
    decimal_text,
    rational,
    rational_from_float,
    rational_from_text,
    sqrt_below,
    sqrt_text,
)


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
        assert ends(between(0, 1).root()) == (0, 1) and between(1, 4, 33).root().bits == 33
        two = Interval.of(2, 30).root()
        assert ends(two)[0] ** 2 < 2 < ends(two)[1] ** 2 and gmpy2.next_above(two.low) == two.high
        with pytest.raises(gmpy2.InvalidOperationError):
            between(-5, -4).root()

    @pytest.mark.parametrize("sign", [1, -1])
    def test_overflow_raises_at_either_end(self, sign: int) -> None:
        huge = Interval.of(mpz(1) << 1000, 64)
        with pytest.raises(gmpy2.OverflowResultError):
            for _ in range(30):
                huge = sign * (huge * huge)
                huge = sign * huge
        greatest = Interval.of(1, 64)
        for _ in range(61):
            try:
                greatest = greatest * greatest * 2
            except gmpy2.OverflowResultError:
                break
        for x in (Interval(mpfr(1), greatest.high, 64), Interval(-greatest.high, mpfr(1), 64)):
            with pytest.raises(gmpy2.OverflowResultError):
                _ = x * x * x * x

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
