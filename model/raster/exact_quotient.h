// ExactQuotient: floor(n 2^Shift / divisor + 1/2) of integers, without wide division. A binary64
// estimate is off by one at most; its remainder, small, is exact modulo 2^64 and corrects it.

#pragma once

#include <cstdint>

namespace ffgpu {

class ExactQuotient {
public:
    static constexpr int Shift = 22;

    // divisor in [1, 2^46]; per_divisor: 256 / divisor, rounded.
    ExactQuotient(double divisor, double per_divisor)
        : divisor_(static_cast<std::int64_t>(divisor))
        , factor_(factor(per_divisor)) {}

    // What the estimate multiplies a numerator with: two roundings, 2^-52 off the quotient.
    static double factor(double per_divisor) { return per_divisor * (1 << (Shift - 8)); }

    // |numerator| at most 2^54, the quotient below 2^51.
    std::int64_t operator()(std::int64_t numerator) const {
        const double estimate = static_cast<double>(numerator) * factor_;
        auto quotient = static_cast<std::int64_t>(estimate);
        const auto shifted = static_cast<std::uint64_t>(numerator) << Shift;
        const auto product =
            static_cast<std::uint64_t>(quotient) * static_cast<std::uint64_t>(divisor_);
        auto remainder = static_cast<std::int64_t>(shifted - product);
        for (; 2 * remainder >= divisor_; remainder -= divisor_)
            ++quotient;
        for (; 2 * remainder < -divisor_; remainder += divisor_)
            --quotient;
        return quotient;
    }

private:
    std::int64_t divisor_;
    double factor_;
};

} // namespace ffgpu
