"""Square roots of positive integers, up to rational factors: the basis in which sums of roots are written.

sqrt(n) and sqrt(m) are rational multiples of each other exactly when n * m is a perfect square, and square
roots of positive integers no two of which are such multiples are linearly independent over Q (Besicovitch
1940, "On the linear independence of fractional powers of integers"). A `Radical` is such a class, with one of
its integers written out.

No integer is factored. Squares of primes below 4096 are divided out, and a cofactor that is a perfect square;
a square of a larger prime may stay hidden, so classes are compared by `is_square`, not by their integers. The
hash depends on the class only: it is made of the small square-free part and of Legendre symbols of the rest,
which a square changes not.
"""

from collections.abc import Callable, Collection
from functools import lru_cache

from gmpy2 import gcd, is_square, isqrt, legendre, mpz, next_prime, primorial

from exactmesh.numbers.interval import Interval

# Products of all primes below 4096; the gcd with it costs about a microsecond.
_SMALL_PRIMES = primorial(4095)
# 24 symbols tell long sums of large radicands apart well enough; a clash costs one `is_square`.
_SYMBOL_PRIMES = tuple(p for p in range(3, 101, 2) if all(p % q for q in range(3, p, 2)))[:24]
# Division and root extraction cost 2**rank terms: beyond this they would not end in useful time.
MAX_RANK = 10


class TooManyRoots(ArithmeticError):
    """An operation mixes more independent square roots than can be treated; `limit` says how many."""

    def __init__(self, limit: int) -> None:
        super().__init__(f"more than {limit} independent square roots would be mixed")
        self.limit = limit


class Radical:
    """The class of sqrt(n) modulo rational factors: equal when the product of the integers is a square."""

    __slots__ = ("_hash", "n")

    def __init__(self, n: mpz, fingerprint: int) -> None:
        self.n = n
        self._hash = fingerprint

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, Radical) and (self.n == other.n or bool(is_square(self.n * other.n)))

    def __reduce__(self) -> tuple[Callable[[mpz], "Radical"], tuple[mpz]]:
        return _written, (self.n,)

    def ratio(self, other: "Radical") -> tuple[mpz, mpz]:
        """Return integers a, b with sqrt(self.n) = a/b * sqrt(other.n), for an equal radical."""
        return isqrt(self.n * other.n), other.n


ONE = Radical(mpz(1), 0)


@lru_cache(maxsize=1 << 16)
def radical(n: mpz) -> tuple[mpz, Radical]:
    """Return q > 0 and a radical r with sqrt(n) = q * sqrt(r.n), for n > 0."""
    q = mpz(1)
    small = gcd(n, _SMALL_PRIMES)
    while (repeated := gcd(n // small, small)) > 1:
        n //= repeated * repeated
        q *= repeated
        small = gcd(n, small)
    rest = n // small
    if is_square(rest):
        q *= isqrt(rest)
        n, rest = small, mpz(1)
    if n == 1:
        return q, ONE
    symbols = 0
    for p in _SYMBOL_PRIMES:
        symbols = 2 * symbols + (legendre(rest, p) == 1)
    return q, Radical(n, hash((int(small), symbols)))


def _written(n: mpz) -> Radical:
    return radical(n)[1]


@lru_cache(maxsize=1 << 16)
def product(n: mpz, m: mpz) -> tuple[mpz, Radical]:
    """Return q and a radical r with sqrt(n) * sqrt(m) = q * sqrt(r.n)."""
    common = gcd(n, m)
    q, r = radical((n // common) * (m // common))
    return q * common, r


@lru_cache(maxsize=1 << 14)
def root_enclosure(n: mpz, bits: int) -> Interval:
    """Return an interval around sqrt(n)."""
    return Interval.of(n, bits).root()


@lru_cache(maxsize=256)
def _prime_after(p: int) -> int:
    return int(next_prime(p))


def separating_prime(moved: Radical, among: Collection[Radical]) -> int:
    """Return a prime p that divides none of `among` and modulo which `moved`, not ONE, is no square.

    n -> Legendre symbol (n/p) is multiplicative, so multiplying each sqrt(n) by it is an automorphism of the
    field that the radicals `among` generate, and it turns sqrt(moved) into -sqrt(moved). Half of all primes
    do.
    """
    p = 1 << 31
    while True:
        p = _prime_after(p)
        if legendre(moved.n, p) == -1 and all(r.n % p for r in among):
            return p


def rank(radicals: Collection[Radical]) -> int:
    """Return the number of independent ones among `radicals`; the field they generate has degree 2**rank.

    Raises `TooManyRoots` beyond `MAX_RANK`.
    """
    # Each basis element is moved by its own prime and fixed by those of the elements before it.
    basis: list[tuple[int, Radical]] = []
    for r in radicals:
        for p, element in basis:
            if legendre(r.n, p) == -1:
                _, r = product(r.n, element.n)
        if r.n != 1:
            if len(basis) == MAX_RANK:
                raise TooManyRoots(MAX_RANK)
            basis.append((separating_prime(r, radicals), r))
    return len(basis)
