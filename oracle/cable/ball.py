"""Real numbers enclosed in balls: their decimals, and the f64 nearest to them, decided by the enclosure."""

from flint import arb, arb_poly, ctx, fmpq, fmpz

from ..fixtures import fixture

# Bits of every ball, and decimals that are stored. Radii near 1e-150 leave no doubt about either.
ctx.prec = 512
DIGITS = 40


def is_exact(values):
    """Whether nested lists hold rational numbers only."""
    if isinstance(values, (list, tuple)):
        return all(map(is_exact, values))
    return not isinstance(values, arb)


def at(polynomial, place):
    """A rational polynomial at a rational number, or enclosed at a ball."""
    return arb_poly(polynomial)(place) if isinstance(place, arb) else polynomial(place)


def decimal(ball):
    """The number to `DIGITS` significant digits, at most one unit of the last digit off."""
    assert ball.rel_accuracy_bits() > 300, f"a ball too wide for its digits: {ball}"
    return ball.str(DIGITS, radius=False)


def nearest(value):
    """The f64 nearest to a rational number or to all numbers in a ball."""
    if not isinstance(value, arb):
        return fixture.nearest(value)
    low, high = (fixture.nearest(rational(end)) for end in (value.lower(), value.upper()))
    assert low == high, f"a ball that does not decide its f64: {value}"
    return low


def rational(exact):
    """The rational number that a ball without radius is."""
    mantissa, exponent = map(int, exact.man_exp())
    return fmpq(fmpz(mantissa)) * fmpq(2) ** exponent


def agree(a, b, size=0):
    """Whether two numbers can be the same: rational ones are, balls meet and are tiny beside them or `size`."""
    if is_exact([a, b]):
        return a == b
    a, b = arb(a), arb(b)
    largest = max(abs(float(a.mid())), abs(float(b.mid())), float(size))
    return a.overlaps(b) and float((a - b).rad()) <= 1e-100 * largest
