// SPDX-License-Identifier: BSL-1.0
// Linear convolutions (a * b)_k = sum_{i=0..k} a_i b_{k-i}: what a fractional difference is. By Fourier transforms, padded with zeros until
// nothing wraps around, in O(n log n); their error is a few epsilon times |a| |b| (Euclidean norms) in every value. By the sum itself for
// few values and for exact scalars, which have no roots of unity.
#pragma once

#include <algorithm>

#include "hilger/history/fft.hpp"

namespace hilger {

namespace detail {

template <class S>
inline constexpr bool has_transform = std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact;
/// Below this many values on one side the sum is faster.
inline constexpr std::size_t few_values = 48;

template <class S>
std::vector<S> direct_convolution(std::vector<S> const& a, std::vector<S> const& b, std::size_t size) {
    std::vector<S> c(size, S(0));
    if (a.empty() or b.empty()) return c;
    for (std::size_t k = 0; k < std::min(size, a.size() + b.size() - 1); ++k) {
        std::size_t const first = k < b.size() ? 0 : k - (b.size() - 1);
        for (std::size_t i = first; i <= std::min(k, a.size() - 1); ++i) c[k] = c[k] + a[i] * b[k - i];
    }
    return c;
}

/// The transform of n = 2 size() real values as that of half as many complex ones, even numbers real, odd ones imaginary.
template <class S>
std::vector<complex_number<S>> packed_transform(fourier_transform<S> const& transform, std::vector<S> const& x, std::size_t count) {
    std::vector<complex_number<S>> z(transform.size());
    for (std::size_t j = 0; j < count; ++j) (j % 2 == 0 ? z[j / 2].re : z[j / 2].im) = x[j];
    transform.forward(z);
    return z;
}

/// a becomes the packed transform of the cyclic convolution. With E and O the transforms of the even and the odd values, Z = E + iO, that
/// of a product is E = E_a E_b + w O_a O_b, O = E_a O_b + O_a E_b; E_{-k} and O_{-k} are conjugate to E_k and O_k. In reversed order -k is
/// at the place of k with all digits below the highest one exchanged.
template <class S>
void multiply_packed(fourier_transform<S> const& transform, std::vector<complex_number<S>>& a, std::vector<complex_number<S>> const& b) {
    using C = complex_number<S>;
    std::size_t const half = transform.size() / 2;
    S const quarter = S(1) / S(4);
    auto const even = [](C const& z, C const& mirrored) { return z + conj(mirrored); };
    auto const odd = [](C const& z, C const& mirrored) { return (conj(mirrored) - z).times_i(); };
    in_reversed_order(transform.size(), [&](std::size_t j, std::size_t k) {
        std::size_t const mirror = j == 0 ? 0 : j ^ (std::bit_floor(j) - 1);
        if (mirror < j) return;
        C const ea = even(a[j], a[mirror]), oa = odd(a[j], a[mirror]), eb = even(b[j], b[mirror]), ob = odd(b[j], b[mirror]);
        C const product = oa * ob;
        C const turned = transform.size() == 1 ? product
                         : k < half            ? transform.root(k) * product
                                               : C{} - transform.root(k - half) * product;
        C const e = ea * eb + turned, o = ea * ob + oa * eb;
        a[j] = quarter * (e + o.times_i());
        a[mirror] = quarter * (conj(e) + conj(o).times_i());
    });
}

/// The first `size` values of a cyclic convolution from its packed transform.
template <class S>
std::vector<S> unpacked_values(fourier_transform<S> const& transform, std::vector<complex_number<S>>& z, std::size_t size) {
    transform.backward(z);
    S const scale = S(1) / S(static_cast<long long>(transform.size()));
    std::vector<S> x(size, S(0));
    for (std::size_t j = 0; j < std::min(size, 2 * z.size()); ++j) x[j] = scale * (j % 2 == 0 ? z[j / 2].re : z[j / 2].im);
    return x;
}

/// The size of the packed transform for the convolution of so many values.
inline std::size_t packed_size(std::size_t a, std::size_t b) { return std::max<std::size_t>(std::bit_ceil(a + b - 1) / 2, 1); }

} // namespace detail

/// The first `size` values of a * b; zeros beyond its end.
template <class S>
std::vector<S> convolve(std::vector<S> const& a, std::vector<S> const& b, std::size_t size) {
    std::size_t const n = std::min(a.size(), size), m = std::min(b.size(), size);
    if constexpr (detail::has_transform<S>)
        if (std::min(n, m) > detail::few_values) {
            fourier_transform<S> const transform(detail::packed_size(n, m));
            auto z = detail::packed_transform(transform, a, n);
            detail::multiply_packed(transform, z, detail::packed_transform(transform, b, m));
            return detail::unpacked_values(transform, z, size);
        }
    return detail::direct_convolution(a, b, size);
}

/// Convolution with one kernel, many times: x -> the first n values of kernel * x for n = kernel.size() values x. As a matrix: lower
/// triangular Toeplitz. The kernel's transform is kept, which leaves two transforms for each use.
template <class S>
class toeplitz_triangle {
public:
    explicit toeplitz_triangle(std::vector<S> kernel) : kernel_(std::move(kernel)), transform_(transform_size()) {
        if constexpr (detail::has_transform<S>)
            if (by_transform()) transformed_ = detail::packed_transform(transform_, kernel_, kernel_.size());
    }
    [[nodiscard]] std::vector<S> const& kernel() const { return kernel_; }

    /// L x. @throws error::mismatch when x has not as many values as the kernel.
    [[nodiscard]] std::vector<S> operator()(std::vector<S> const& x) const {
        if (x.size() != kernel_.size())
            error::raise<error::mismatch>("a triangle of ", kernel_.size(), " rows was given ", x.size(), " values");
        if constexpr (detail::has_transform<S>)
            if (by_transform()) {
                auto z = detail::packed_transform(transform_, x, x.size());
                detail::multiply_packed(transform_, z, transformed_);
                return detail::unpacked_values(transform_, z, x.size());
            }
        return detail::direct_convolution(kernel_, x, x.size());
    }

private:
    struct nothing {
        explicit nothing(std::size_t) {}
    };
    using transform_type = std::conditional_t<detail::has_transform<S>, fourier_transform<S>, nothing>;
    [[nodiscard]] bool by_transform() const { return detail::has_transform<S> and kernel_.size() > detail::few_values; }
    [[nodiscard]] std::size_t transform_size() const { return by_transform() ? detail::packed_size(kernel_.size(), kernel_.size()) : 1; }
    std::vector<S> kernel_;
    transform_type transform_;
    std::vector<complex_number<S>> transformed_;
};

} // namespace hilger
