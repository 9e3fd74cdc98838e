"""Numbers with unit, provenance and certain digits."""

from mpmath import mp, mpf

# Digits: of the arithmetic; of a stored decimal, at most; on which two methods must agree.
WORKING = 32
SHOWN = 20
AGREED = 22


def exact(number):
    """A parameter as written: 0.1 is one tenth."""
    return mpf(str(number))


def analytic(unit, number):
    """A value from a closed form."""
    return {"unit": unit, **_written(number, SHOWN), "provenance": "analytic", "agreement": None}


def agreed(methods, units, first, second, digits=AGREED):
    """Values by name from two methods that must agree; stored are those of the first, to the digits that agree."""
    assert list(units) == list(first) == list(second), f"{list(units)}, {list(first)}, {list(second)}"
    largest = max(map(abs, first.values()))
    values = {}
    for name, unit in units.items():
        scale = max(abs(first[name]), largest * mpf("1e-9"))
        distance = abs(first[name] - second[name]) / scale
        bound = mpf(10) ** -digits
        assert distance <= bound, f"{name}: relative difference {mp.nstr(distance, 3)} of {methods}"
        values[name] = {
            "unit": unit, **_written(first[name], min(SHOWN, digits - 1)),
            "provenance": f"numeric, agreed by {methods[0]} and {methods[1]}", "agreement": float(bound),
        }
    return values


def _written(number, digits):
    """A number as decimal text and as the nearest double."""
    return {"decimal": mp.nstr(number, digits, strip_zeros=False, min_fixed=-4, max_fixed=12), "f64": float(number)}
