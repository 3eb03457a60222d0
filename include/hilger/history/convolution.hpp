// SPDX-License-Identifier: BSL-1.0
// Convolutions (w * x)_k = sum_{n=0..k} w_n x_{k-n} of whole sequences, as fractional differences are. By Fourier transforms long enough
// that nothing wraps around, so that every point is right, in O(N log N) and with an error of some epsilon of sum |w_n| max |x|; by the sum
// itself for few values and for exact scalars, which have no roots of unity.
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/fourier/transform.hpp"

namespace hilger {

/// Convolution with one kernel, many times: x -> the first n values of kernel * x for n = kernel.size() values x. As a matrix: lower
/// triangular Toeplitz. The kernel's transform is kept, so that each use takes two transforms. A const object may be shared by threads.
template <class S>
class toeplitz_triangle {
public:
    /// The triangle with first column `kernel`.
    explicit toeplitz_triangle(std::vector<S> kernel) : kernel_(std::move(kernel)), length_(std::bit_ceil(kernel_.size())) {
        if constexpr (has_transform)
            if (by_transform()) { // polynomials of half their length are multiplied modulo z^{2 length} + 1
                S const scale = S(1) / S(static_cast<long long>(length_));
                transformed_ = padded(kernel_);
                for (S& w : transformed_.re) w = w * scale;
                transform_.reserve(length_);
                transform_.forward(transformed_, length_);
            }
    }
    [[nodiscard]] std::vector<S> const& kernel() const { return kernel_; }

    /// L x, of the kernel's length. @throws error::mismatch when x has another.
    [[nodiscard]] std::vector<S> operator()(std::vector<S> const& x) const {
        if (x.size() != kernel_.size())
            error::raise<error::mismatch>("a triangle of ", kernel_.size(), " rows was given ", x.size(), " values");
        if constexpr (has_transform)
            if (by_transform()) {
                auto z = padded(x);
                transform_.forward(z, length_);
                transform_.multiply(z, transformed_, length_);
                transform_.backward(z, length_);
                return {z.re.begin(), z.re.begin() + static_cast<index_type>(x.size())};
            }
        std::vector<S> y(x.size(), S(0));
        for (std::size_t k = 0; k < x.size(); ++k)
            for (std::size_t n = 0; n <= k; ++n) y[k] = y[k] + kernel_[n] * x[k - n];
        return y;
    }

private:
    static constexpr bool has_transform = std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact;
    static constexpr std::size_t few_values = 48;
    [[nodiscard]] bool by_transform() const { return has_transform and kernel_.size() > few_values; }
    [[nodiscard]] detail::memory::spectrum<S> padded(std::vector<S> const& x) const {
        detail::memory::spectrum<S> z;
        z.re.assign(length_, S(0));
        z.im.assign(length_, S(0));
        std::copy(x.begin(), x.end(), z.re.begin());
        return z;
    }
    struct nothing {};
    std::vector<S> kernel_;
    std::size_t length_;
    std::conditional_t<has_transform, detail::memory::spectrum<S>, nothing> transformed_;
    std::conditional_t<has_transform, detail::memory::fourier<S>, nothing> transform_;
};

} // namespace hilger
