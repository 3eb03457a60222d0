// SPDX-License-Identifier: BSL-1.0
// What the names in a formula stand for: the time, coordinates and their velocities, parameters with their values. Numbers are kept as they
// were written, and become exact in rationals.
#pragma once

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/text/expression.hpp"

namespace hilger::text {

/// The number that digits spell, 12, -0.5, 1e-3, 1/3; nothing where they spell none, or none that the scalar has. In exact scalars it is
/// exact, in others the nearest, of quotients rounded once more.
template <class S>
std::optional<S> number_in(std::string_view digits) {
    if (auto const slash = digits.find('/'); slash != std::string_view::npos) {
        auto const above = number_in<S>(digits.substr(0, slash)), below = number_in<S>(digits.substr(slash + 1));
        if (not above or not below or *below == S(0) or digits.find('/', slash + 1) != std::string_view::npos) return {};
        return S(*above / *below);
    }
    // What is read: a sign, digits with a point in or around them, an exponent.
    std::string_view rest = digits;
    bool const minus = rest.starts_with('-');
    if (minus or rest.starts_with('+')) rest.remove_prefix(1);
    std::string mantissa;
    int exponent = 0;
    bool point = false;
    std::size_t k = 0;
    for (; k < rest.size() and ((rest[k] >= '0' and rest[k] <= '9') or (rest[k] == '.' and not point)); ++k) {
        if (rest[k] == '.')
            point = true;
        else {
            mantissa += rest[k];
            if (point) --exponent;
        }
    }
    if (mantissa.empty()) return {};
    if (k < rest.size()) {
        if (rest[k] != 'e' and rest[k] != 'E') return {};
        std::string_view power = rest.substr(k + 1);
        if (power.starts_with('+')) power.remove_prefix(1);
        int given = 0;
        auto const [end, wrong] = std::from_chars(power.data(), power.data() + power.size(), given);
        if (power.empty() or wrong != std::errc() or end != power.data() + power.size() or given < -10'000 or 10'000 < given) return {};
        exponent += given;
    }
    if constexpr (std::is_floating_point_v<S>) {
        S x{};
        std::string const plain = mantissa + "e" + std::to_string(exponent);
        if (auto const [end, wrong] = std::from_chars(plain.data(), plain.data() + plain.size(), x); wrong != std::errc()) return {};
        return minus ? -x : x;
    } else if constexpr (std::numeric_limits<S>::is_exact) {
        S x(0), power(1);
        for (char const c : mantissa) x = x * S(10) + S(c - '0');
        S square(10);
        for (int n = exponent < 0 ? -exponent : exponent; n > 0; n /= 2, square = square * square)
            if (n % 2 == 1) power = power * square;
        x = exponent < 0 ? S(x / power) : S(x * power);
        return minus ? S(-x) : x;
    } else if constexpr (std::is_constructible_v<S, std::string>) {
        S const x(mantissa + "e" + std::to_string(exponent));
        return minus ? S(-x) : x;
    } else { // what stands for doubles
        auto const x = number_in<double>(digits);
        return x ? std::optional<S>(S(*x)) : std::nullopt;
    }
}

/// Whether a formula is the number 0, as it was written.
inline bool is_zero(expression const& e) { return e.root().what == kind::number and number_in<double>(e.root().name) == 0.0; }

/// A coordinate, or a vector of them under one name.
struct coordinate {
    std::string position, velocity;
    int size = 0; ///< 0 for one that is a number and takes no index
};

/// What a name stands for.
struct meaning {
    enum class role { time, position, velocity, parameter } is = role::time;
    int first = 0; ///< of its components, in the state or in the numbers of all parameters
    int size = 0;  ///< 0 for a number
};

class vocabulary {
public:
    explicit vocabulary(std::vector<coordinate> const& coordinates, std::string const& time = "t") {
        for (coordinate const& c : coordinates) {
            add(c.position, {meaning::role::position, dimension_, c.size});
            add(c.velocity, {meaning::role::velocity, dimension_, c.size});
            dimension_ += c.size == 0 ? 1 : c.size;
        }
        if (not time.empty()) add(time, {meaning::role::time, 0, 0});
    }
    /// A parameter that is a number, and one that is a list of numbers. @throws error::invalid_parameter when the name is taken or none,
    /// a list is empty, or a value is no number
    void set(std::string const& name, std::string const& digits) { add_parameter(name, {digits}, 0); }
    void set(std::string const& name, std::vector<std::string> const& digits) {
        if (digits.empty()) error::raise<error::invalid_parameter>("the parameter '", name, "' is a list of numbers, and of none here");
        add_parameter(name, digits, static_cast<int>(digits.size()));
    }

    /// Makes a parameter one that each state brings with it, behind the coordinates of its position, as components dimension() and on: what
    /// differs between the members of an ensemble. @throws error::invalid_parameter when there is no such parameter
    void bring_with_states(std::string const& name) {
        auto const at = meanings_.find(name);
        if (at == meanings_.end() or at->second.is != meaning::role::parameter)
            error::raise<error::invalid_parameter>("there is no parameter '", name, "': there are ", known());
        at->second = {meaning::role::position, dimension_ + brought_, at->second.size};
        brought_ += at->second.size == 0 ? 1 : at->second.size;
    }
    /// How many numbers that is.
    [[nodiscard]] int brought() const { return brought_; }
    /// The same words with these numbers in the place of those. @throws error::not_finite
    [[nodiscard]] vocabulary with(std::vector<double> const& numbers) const {
        vocabulary fixed = *this;
        for (auto& [name, means] : fixed.meanings_)
            if (means.is == meaning::role::position and dimension_ <= means.first) {
                int const first = means.first - dimension_;
                for (int k = first; k < first + std::max(means.size, 1); ++k)
                    if (double const x = numbers[static_cast<std::size_t>(k)]; not(x - x == 0))
                        error::raise<error::not_finite>("the parameter '", name, "' is a number, and is ", x, " here");
                means = {meaning::role::parameter, static_cast<int>(digits_.size()) + first, means.size};
            }
        for (double const x : numbers) {
            char text[32];
            fixed.digits_.emplace_back(text, std::to_chars(text, text + sizeof text, x).ptr);
        }
        fixed.brought_ = 0;
        return fixed;
    }

    [[nodiscard]] int dimension() const { return dimension_; }
    [[nodiscard]] meaning const* find(std::string const& name) const {
        auto const at = meanings_.find(name);
        return at == meanings_.end() ? nullptr : &at->second;
    }
    [[nodiscard]] std::string const& digits(int k) const { return digits_[static_cast<std::size_t>(k)]; }
    /// All names, for errors.
    [[nodiscard]] std::string known() const {
        std::string list;
        for (auto const& [name, is] : meanings_) list += (list.empty() ? "" : ", ") + name + (is.size > 0 ? "[]" : "");
        return list;
    }

private:
    static bool is_name(std::string const& word) {
        auto const letter = [](char c) {
            return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or c == '_' or static_cast<signed char>(c) < 0;
        };
        bool good = not word.empty() and letter(word[0]);
        for (char const c : word) good = good and (letter(c) or (c >= '0' and c <= '9'));
        return good and word != "and" and word != "or" and word != "not" and word != "if" and word != "sum";
    }
    void add(std::string const& name, meaning is) {
        if (not is_name(name)) error::raise<error::invalid_parameter>("a name is letters, digits and _, and '", name, "' is none");
        if (name == "pi") error::raise<error::invalid_parameter>("pi is the number 3.14159..., and the name of nothing else");
        if (not meanings_.emplace(name, is).second)
            error::raise<error::invalid_parameter>("each name has one meaning, and '", name, "' was given two");
    }
    void add_parameter(std::string const& name, std::vector<std::string> const& digits, int size) {
        for (std::string const& d : digits)
            if (not number_in<double>(d))
                error::raise<error::invalid_parameter>("the parameter '", name, "' is a number, as 0.1, 1e-3 or 1/3, and was given as '", d,
                                                       "'");
        add(name, {meaning::role::parameter, static_cast<int>(digits_.size()), size});
        digits_.insert(digits_.end(), digits.begin(), digits.end());
    }
    int dimension_ = 0, brought_ = 0;
    std::map<std::string, meaning> meanings_;
    std::vector<std::string> digits_;
};

/// What formulas of numbers alone are read with.
inline std::shared_ptr<vocabulary const> no_words() {
    static auto const none = std::make_shared<vocabulary const>(std::vector<coordinate>{}, "");
    return none;
}

} // namespace hilger::text
