// SPDX-License-Identifier: BSL-1.0
// Random Lagrangians of two coordinates, rational in t, q and v, with and without branches, each as a text and in C++.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "hilger/hilger.hpp"
#include "hilger/text/lagrangian.hpp"

namespace hilger::testing {

/// A random U(t, q) that is a formula twice: as a text, and as a function of any number type.
class random_potential {
public:
    explicit random_potential(unsigned seed) : random_(seed) { root_ = grow(3); }
    [[nodiscard]] std::string text() const { return text_of(root_); }
    template <class T, class X>
    auto value(T const& t, X const& q) const {
        return value_of<std::remove_cvref_t<decltype(q(0) + q(1))>>(t, q, root_);
    }

private:
    enum what { number, time, position, plus, minus, times, over, square, choice };
    struct node {
        what is;
        int a = 0, b = 0;
    };
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    int add(node n) {
        nodes_.push_back(n);
        return static_cast<int>(nodes_.size()) - 1;
    }
    int grow(int levels) {
        if (levels == 0) {
            int const leaf = pick(4);
            return leaf == 0 ? add({number, pick(9) + 1}) : leaf == 1 ? add({time}) : add({position, pick(2)});
        }
        what const kind = std::array{plus, minus, times, over, square, choice, plus, times}[static_cast<std::size_t>(pick(8))];
        int const a = grow(levels - 1), b = kind == square ? a : grow(levels - 1);
        return add({kind, a, b});
    }
    // Quotients have denominators 1 + b^2, which are never 0; choices compare q[0] with b.
    [[nodiscard]] std::string text_of(int k) const {
        auto const& n = nodes_[static_cast<std::size_t>(k)];
        std::string const a = n.is < plus ? "" : "(" + text_of(n.a) + ")", b = n.is < plus ? "" : "(" + text_of(n.b) + ")";
        switch (n.is) {
        case number:
            return std::to_string(n.a) + "/10";
        case time:
            return "t";
        case position:
            return "q[" + std::to_string(n.a) + "]";
        case plus:
            return a + " + " + b;
        case minus:
            return a + " - " + b;
        case times:
            return a + "*" + b;
        case over:
            return a + "/(1 + " + b + "^2)";
        case square:
            return a + "^2";
        default:
            return "if(q[0] < " + b + ", " + a + ", 2*" + a + ")";
        }
    }
    template <class R, class T, class X>
    R value_of(T const& t, X const& q, int k) const {
        auto const& n = nodes_[static_cast<std::size_t>(k)];
        if (n.is == number) return R(R(n.a) / R(10));
        if (n.is == time) return R(t);
        if (n.is == position) return R(q(n.a));
        R const a = value_of<R>(t, q, n.a), b = value_of<R>(t, q, n.b);
        switch (n.is) {
        case plus:
            return a + b;
        case minus:
            return a - b;
        case times:
            return a * b;
        case over:
            return a / (R(1) + b * b);
        case square:
            return a * a;
        default:
            return R(q(0)) < b ? a : R(2) * a;
        }
    }
    std::mt19937 random_;
    std::vector<node> nodes_;
    int root_;
};

/// The same Lagrangian in C++.
struct typed {
    static constexpr bool is_generic_in_time = true;
    random_potential const* U;
    template <class T, class X>
    auto operator()(T const& t, X const& q, X const& v) const {
        return plain_t<decltype(q(0) * v(0))>(v(0) * v(0) / 2 + v(1) * v(1) - U->value(t, q));
    }
};
inline text::stated_lagrangian in_text(random_potential const& U) {
    auto words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 2}});
    return text::lagrangian_in("v[0]^2/2 + v[1]^2 - (" + U.text() + ")", words);
}

} // namespace hilger::testing
