// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/portable_math.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace axiscomp::portable {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The sum of two doubles, the second of which is below the last bit of the first: T. J. Dekker, A
/// floating-point technique for extending the available precision, 1971.
struct Pair {
    double high = 0.0;
    double low = 0.0;
};

constexpr Pair halfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double halfPiRest = -0x1.f1976b7ed8fbcp-110;
constexpr Pair pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Pair ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Pair ln10{0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53};

/// 1, 1/2!, 1/3!, ...
constexpr std::array<Pair, 23> inverseFactorials{Pair{1.0, 0.0}, {0x1p-1, 0.0},
    {0x1.5555555555555p-3, 0x1.5555555555555p-57}, {0x1.5555555555555p-5, 0x1.5555555555555p-59},
    {0x1.1111111111111p-7, 0x1.1111111111111p-63}, {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65},
    {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73}, {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76},
    {0x1.71de3a556c734p-19, -0x1.c154f8ddc6cp-73}, {0x1.27e4fb7789f5cp-22, 0x1.cbbc05b4fa99ap-76},
    {0x1.ae64567f544e4p-26, -0x1.c062e06d1f209p-80},
    {0x1.1eed8eff8d898p-29, -0x1.2aec959e14c06p-83}, {0x1.6124613a86d09p-33, 0x1.f28e0cc748ebep-87},
    {0x1.93974a8c07c9dp-37, 0x1.05d6f8a2efd1fp-92}, {0x1.ae7f3e733b81fp-41, 0x1.1d8656b0ee8cbp-97},
    {0x1.ae7f3e733b81fp-45, 0x1.1d8656b0ee8cbp-101},
    {0x1.952c77030ad4ap-49, 0x1.ac981465ddc6cp-103},
    {0x1.6827863b97d97p-53, 0x1.eec01221a8b0bp-107},
    {0x1.2f49b46814157p-57, 0x1.2650f61dbdcb4p-112},
    {0x1.e542ba4020225p-62, 0x1.ea72b4afe3c2fp-120},
    {0x1.71b8ef6dcf572p-66, -0x1.d043ae40c4647p-120},
    {0x1.0ce396db7f853p-70, -0x1.aebcdbd20331cp-124},
    {0x1.761b41316381ap-75, -0x1.3423c7d91404fp-130}};

/// |a| is not smaller than |b|.
Pair ordered(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

Pair sumOf(double a, double b)
{
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// The upper half of the digits, and the lower one.
Pair halves(double a)
{
    constexpr double splitter = 0x1p27 + 1.0;
    const double scaled = splitter * a;
    const double high = scaled - (scaled - a);
    return {high, a - high};
}

Pair productOf(double a, double b)
{
    const double product = a * b;
    const Pair x = halves(a);
    const Pair y = halves(b);
    return {
        product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

Pair operator+(const Pair& a, const Pair& b)
{
    Pair sum = sumOf(a.high, b.high);
    const Pair lower = sumOf(a.low, b.low);
    sum = ordered(sum.high, sum.low + lower.high);
    return ordered(sum.high, sum.low + lower.low);
}

Pair operator-(const Pair& a)
{
    return {-a.high, -a.low};
}

Pair operator*(const Pair& a, const Pair& b)
{
    const Pair product = productOf(a.high, b.high);
    return ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}

Pair operator*(const Pair& a, double b)
{
    return a * Pair{b, 0.0};
}

Pair operator/(const Pair& a, const Pair& b)
{
    const double first = a.high / b.high;
    const Pair rest = a + -(b * first);
    const double second = rest.high / b.high;
    const double third = (rest + -(b * second)).high / b.high;
    return ordered(first, second) + Pair{third, 0.0};
}

double rounded(const Pair& a)
{
    return a.high + a.low;
}

/// The sum of value^first / first!, and of every second power from there, signs in turn.
Pair alternatingSeries(const Pair& value, std::size_t first)
{
    const Pair minusSquare = -(value * value);
    std::size_t n = first == 0 ? 22 : 23; // so far that what follows is too small for |value| < 0.8
    Pair sum = inverseFactorials[n - 1];
    while (n > first) {
        n -= 2;
        sum = sum * minusSquare + (n == 0 ? Pair{1.0, 0.0} : inverseFactorials[n - 1]);
    }
    return first == 0 ? sum : sum * value;
}

struct SineAndCosine {
    Pair sine;
    Pair cosine;
};

/// Of an angle up to a few times pi / 4.
SineAndCosine sineAndCosine(const Pair& angle)
{
    return {alternatingSeries(angle, 1), alternatingSeries(angle, 0)};
}

/// What is left of an angle beside a multiple of pi / 2, and the quarter of the circle.
struct Reduced {
    Pair angle;
    int quarter = 0;
};

Reduced reduced(double angle)
{
    constexpr double perQuarter = 0x1.45f306dc9c883p-1; // 2 / pi
    constexpr double largest = 1e15;
    if (std::abs(angle) > largest)
        angle = std::fmod(angle, 4.0 * halfPi.high);
    const double quarters = std::nearbyint(angle * perQuarter);
    const Pair rest = Pair{angle, 0.0} + -productOf(quarters, halfPi.high)
        + -productOf(quarters, halfPi.low) + Pair{-quarters * halfPiRest, 0.0};
    return {rest, static_cast<int>(static_cast<long long>(quarters) & 3)};
}

/// quarter 0: the sine; 1: the cosine; and so on.
double sineOf(const Pair& angle, int quarter)
{
    const Pair value = alternatingSeries(angle, (quarter & 1) == 0 ? 1 : 0);
    return rounded((quarter & 2) == 0 ? value : -value);
}

Pair logarithm(double value)
{
    constexpr double rootOfHalf = 0x1.6a09e667f3bcdp-1;
    int exponent = 0;
    double mantissa = std::frexp(value, &exponent);
    if (mantissa < rootOfHalf) {
        mantissa *= 2.0;
        --exponent;
    }
    // 2 (s + s^3 / 3 + s^5 / 5 + ...) with s = (m - 1) / (m + 1), which is below 0.18
    const Pair s = Pair{mantissa - 1.0, 0.0} / sumOf(mantissa, 1.0);
    const Pair square = s * s;
    Pair sum;
    for (int n = 41; n >= 1; n -= 2)
        sum = sum * square + Pair{1.0, 0.0} / Pair{static_cast<double>(n), 0.0};
    return sum * s * 2.0 + ln2 * static_cast<double>(exponent);
}

double exponential(const Pair& value)
{
    constexpr double perDoubling = 0x1.71547652b82fep+0; // 1 / ln 2
    constexpr double farthest = 800.0;
    if (std::abs(value.high) > farthest)
        return value.high > 0.0 ? infinity : 0.0;
    const double doublings = std::nearbyint(value.high * perDoubling);
    const Pair rest = value + -(ln2 * doublings);
    Pair sum = inverseFactorials.back();
    for (std::size_t n = inverseFactorials.size() - 1; n > 0; --n)
        sum = sum * rest + inverseFactorials[n - 1];
    return std::ldexp(rounded(sum * rest + Pair{1.0, 0.0}), static_cast<int>(doublings));
}

/// Divided by that of the base.
double logarithm(double value, const Pair& ofBase)
{
    if (value > 0.0 && value < infinity)
        return rounded(logarithm(value) / ofBase);
    return value == 0.0 ? -infinity : value > 0.0 ? value : noNumber;
}

} // namespace

double sin(double angle)
{
    if (!std::isfinite(angle))
        return noNumber;
    const Reduced rest = reduced(angle);
    return sineOf(rest.angle, rest.quarter);
}

double cos(double angle)
{
    if (!std::isfinite(angle))
        return noNumber;
    const Reduced rest = reduced(angle);
    return sineOf(rest.angle, rest.quarter + 1);
}

double atan2(double y, double x)
{
    if (!std::isfinite(x) || !std::isfinite(y))
        return noNumber;
    if (x == 0.0 && y == 0.0)
        return 0.0;
    // Of the first eighth of the circle, by Newton's method from a parabola.
    double along = std::abs(x);
    double across = std::abs(y);
    const bool isSteep = across > along;
    if (isSteep)
        std::swap(along, across);
    const double slope = across / along;
    Pair angle{slope * (0x1.921fb54442d18p-1 + 0.273 * (1.0 - slope)), 0.0};
    const double radius = hypot(slope, 1.0);
    const Pair exactSlope = Pair{across, 0.0} / Pair{along, 0.0};
    for (int step = 0; step < 3; ++step) {
        const SineAndCosine at = sineAndCosine(angle);
        const Pair off = exactSlope * at.cosine + -at.sine;
        angle = angle + off / Pair{radius, 0.0};
    }
    if (isSteep)
        angle = halfPi + -angle;
    if (x < 0.0)
        angle = pi + -angle;
    return y < 0.0 ? -rounded(angle) : rounded(angle);
}

double hypot(double x, double y)
{
    return std::sqrt(x * x + y * y);
}

double log(double value)
{
    return logarithm(value, {1.0, 0.0});
}

double log2(double value)
{
    return logarithm(value, ln2);
}

double log10(double value)
{
    return logarithm(value, ln10);
}

double pow(double base, double exponent)
{
    if (exponent == 0.0 || base == 1.0)
        return 1.0;
    if (!(base >= 0.0) || !std::isfinite(exponent))
        return noNumber;
    if (base == 0.0 || base == infinity)
        return (base == 0.0) == (exponent > 0.0) ? 0.0 : infinity;
    const Pair logarithmOfBase = logarithm(base);
    // Beyond this the product's halves would overflow; the result has long been infinite or 0.
    constexpr double farthest = 1e6;
    if (std::abs(exponent) > farthest)
        return (exponent > 0.0) == (logarithmOfBase.high > 0.0) ? infinity : 0.0;
    return exponential(logarithmOfBase * exponent);
}

} // namespace axiscomp::portable
