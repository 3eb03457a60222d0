// SPDX-License-Identifier: BSL-1.0
// The members of every time scale: size, sigma, rho, mu, nu, membership, and iteration as a C++20 random-access range. sigma maps T^+ to
// T^- and rho maps T^- to T^+ (Cresson-Safi, definition 3), so sigma of the last point and rho of the first are errors, not fixed points.
#pragma once

#include <compare>
#include <iterator>
#include <ostream>

#include "hilger/error.hpp"
#include "hilger/scale/base.hpp"

namespace hilger {

/// A random-access iterator over anything whose element(i) is a value. It refers to its owner, as iterators of a range do.
template <class Owner>
class element_iterator {
public:
    using iterator_concept = std::random_access_iterator_tag;
    using iterator_category = std::input_iterator_tag; // elements are values, not references
    using value_type = std::remove_cvref_t<decltype(std::declval<Owner const&>().element(0))>;
    using difference_type = index_type;
    using reference = value_type;
    using pointer = void;

    constexpr element_iterator() = default;
    constexpr element_iterator(Owner const& owner, index_type at) : owner_(&owner), at_(at) {}

    constexpr value_type operator*() const { return owner_->element(at_); }
    constexpr value_type operator[](index_type n) const { return owner_->element(at_ + n); }
    constexpr element_iterator& operator+=(index_type n) { return at_ += n, *this; }
    constexpr element_iterator& operator-=(index_type n) { return at_ -= n, *this; }
    constexpr element_iterator& operator++() { return ++at_, *this; }
    constexpr element_iterator& operator--() { return --at_, *this; }
    constexpr element_iterator operator++(int) { return {*owner_, at_++}; }
    constexpr element_iterator operator--(int) { return {*owner_, at_--}; }
    friend constexpr element_iterator operator+(element_iterator i, index_type n) { return i += n; }
    friend constexpr element_iterator operator+(index_type n, element_iterator i) { return i += n; }
    friend constexpr element_iterator operator-(element_iterator i, index_type n) { return i -= n; }
    friend constexpr index_type operator-(element_iterator const& i, element_iterator const& j) { return i.at_ - j.at_; }
    friend constexpr bool operator==(element_iterator const& i, element_iterator const& j) { return i.at_ == j.at_; }
    friend constexpr auto operator<=>(element_iterator const& i, element_iterator const& j) { return i.at_ <=> j.at_; }

private:
    Owner const* owner_ = nullptr;
    index_type at_ = 0;
};

/// Derived offers root() (the T it comes from) and domain() (which of T's families, cut how).
template <class Derived>
class scale_interface {
public:
    /// Number of points.
    [[nodiscard]] constexpr index_type size() const { return domain().size(root()); }
    [[nodiscard]] constexpr bool empty() const { return size() == 0; }
    /// Numbers of the first and the last point. Points keep the numbers they have in the whole family: T^- starts at 1.
    [[nodiscard]] constexpr index_type first() const { return domain().first(root()); }
    [[nodiscard]] constexpr index_type last() const { return domain().last(root()); }
    /// The point with number i. @throws error::outside_domain
    [[nodiscard]] constexpr auto point(index_type i) const {
        require(i);
        return element(i);
    }
    /// The same, unchecked.
    [[nodiscard]] constexpr auto element(index_type i) const { return domain().base.point(root(), i); }
    /// The first and the last point. @throws error::outside_domain when the scale is empty
    [[nodiscard]] constexpr auto min() const { return point(first()); }
    [[nodiscard]] constexpr auto max() const { return point(last()); }

    [[nodiscard]] constexpr auto begin() const { return element_iterator<Derived>(self(), first()); }
    [[nodiscard]] constexpr auto end() const { return element_iterator<Derived>(self(), first() + size()); }

    /// The next point. @throws error::outside_domain when t is not a point of the scale, or is its last one.
    template <class S>
    [[nodiscard]] constexpr auto sigma(S const& t) const {
        return element(before_last(t, "sigma"));
    }
    /// The previous point. @throws error::outside_domain when t is not a point of the scale, or is its first one.
    template <class S>
    [[nodiscard]] constexpr auto rho(S const& t) const {
        return element(after_first(t, "rho"));
    }
    /// Graininess sigma(t) - t. @throws error::outside_domain as sigma does.
    template <class S>
    [[nodiscard]] constexpr auto mu(S const& t) const {
        return domain().base.step(root(), before_last(t, "mu") - 1);
    }
    /// Backward graininess t - rho(t). @throws error::outside_domain as rho does.
    template <class S>
    [[nodiscard]] constexpr auto nu(S const& t) const {
        return domain().base.step(root(), after_first(t, "nu"));
    }
    /// Whether t is a point, up to the rounding of a + ih.
    template <class S>
    [[nodiscard]] constexpr bool contains(S const& t) const {
        return find(t) > last() ? false : true;
    }
    /// The number of the point t. @throws error::outside_domain when t is no point
    template <class S>
    [[nodiscard]] constexpr index_type number_of(S const& t) const {
        index_type const i = find(t);
        if (i > last()) error::raise<error::outside_domain>(t, " is not a point of ", self());
        return i;
    }
    /// @throws error::outside_domain when no point has the number i
    constexpr void require(index_type i) const {
        if (i < first() or i > last())
            error::raise<error::outside_domain>("point number ", i, " is outside ", self(), ", whose points are numbered ", first(), " to ",
                                                last());
    }

    template <class Other>
    friend constexpr bool operator==(Derived const& a, scale_interface<Other> const& other) {
        Other const& b = static_cast<Other const&>(other);
        return a.size() == b.size() and std::equal(a.begin(), a.end(), b.begin());
    }
    friend std::ostream& operator<<(std::ostream& out, Derived const& scale) {
        out << Derived::domain_type::name().text().view();
        if (scale.empty()) return out << " = {}";
        out << " = {" << scale.element(scale.first());
        index_type const shown = std::min<index_type>(scale.size(), 3);
        for (index_type k = 1; k < shown; ++k) out << ", " << scale.element(scale.first() + k);
        if (scale.size() > 4) out << ", ...";
        if (scale.size() > 3) out << ", " << scale.element(scale.last());
        return out << "} (" << scale.size() << (scale.size() == 1 ? " point)" : " points)");
    }

private:
    [[nodiscard]] constexpr Derived const& self() const { return static_cast<Derived const&>(*this); }
    [[nodiscard]] constexpr decltype(auto) root() const { return self().root(); }
    [[nodiscard]] constexpr auto domain() const { return self().domain(); }

    /// Binary search; last() + 1 when t is no point. In a floating scalar t may differ from the point by the rounding of
    /// a + ih (four units in the last place of the largest point; of t itself when the points were given), so that 0.3 is found in
    /// {0, 0.1, ...}. Never by more than a quarter of the distance to the next point, however fine the scale.
    template <class S>
    [[nodiscard]] constexpr index_type find(S const& given) const {
        using point_type = std::remove_cvref_t<decltype(element(0))>;
        point_type const t(given);
        if (empty() or not is_finite(t)) return last() + 1;
        point_type const size = [&] {
            if constexpr (Derived::root_type::is_uniform)
                return std::max(magnitude(element(first())), magnitude(element(last())));
            else
                return magnitude(t);
        }();
        point_type const slack = point_type(4) * epsilon<point_type>() * size;
        index_type low = first(), high = last() + 1;
        while (low < high) {
            index_type const middle = low + (high - low) / 2;
            if (element(middle) < t - slack)
                low = middle + 1;
            else
                high = middle;
        }
        // Closest of the points within the slack: on very fine scales there may be two.
        index_type best = last() + 1;
        for (index_type i = low; i <= last() and not(t + slack < element(i)); ++i)
            if (best > last() or magnitude(point_type(element(i) - t)) < magnitude(point_type(element(best) - t))) best = i;
        if (best > last()) return best;
        index_type const next = t < element(best) ? best - 1 : best + 1;
        bool const between =
            first() <= next and next <= last() and not(t == element(best)) and
            magnitude(point_type(element(next) - element(best))) < point_type(4) * magnitude(point_type(t - element(best)));
        return between ? last() + 1 : best;
    }
    template <class S>
    [[nodiscard]] constexpr index_type before_last(S const& t, char const* what) const {
        index_type const i = number_of(t);
        if (i == last()) error::raise<error::outside_domain>(what, "(", t, ") does not exist: ", t, " is the last point of ", self());
        return i + 1;
    }
    template <class S>
    [[nodiscard]] constexpr index_type after_first(S const& t, char const* what) const {
        index_type const i = number_of(t);
        if (i == first()) error::raise<error::outside_domain>(what, "(", t, ") does not exist: ", t, " is the first point of ", self());
        return i - 1;
    }
};

/// Anything that is a time scale: T itself or a view of it.
template <class Scale>
concept time_scale_like = std::derived_from<Scale, scale_interface<Scale>> and requires(Scale const& scale) {
    scale.root();
    scale.domain();
};

} // namespace hilger
