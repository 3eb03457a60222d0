// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/vocabulary.hpp"

#include <algorithm>
#include <charconv>

#include "hilger/error.hpp"

namespace hilger::text {

namespace {

bool is_name(std::string const& word) {
    auto const letter = [](char c) {
        return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or c == '_' or static_cast<signed char>(c) < 0;
    };
    bool good = not word.empty() and letter(word[0]);
    for (char const c : word) good = good and (letter(c) or (c >= '0' and c <= '9'));
    return good and word != "and" and word != "or" and word != "not" and word != "if" and word != "sum";
}

} // namespace

bool is_zero(expression const& e) { return e.root().what == kind::number and number_in<double>(e.root().name) == 0.0; }

vocabulary::vocabulary(std::vector<coordinate> const& coordinates, std::string const& time) {
    for (coordinate const& c : coordinates) {
        add(c.position, {meaning::role::position, dimension_, c.size});
        add(c.velocity, {meaning::role::velocity, dimension_, c.size});
        dimension_ += c.size == 0 ? 1 : c.size;
    }
    if (not time.empty()) add(time, {meaning::role::time, 0, 0});
}
void vocabulary::set(std::string const& name, std::vector<std::string> const& digits) {
    if (digits.empty()) error::raise<error::invalid_parameter>("the parameter '", name, "' is a list of numbers, and of none here");
    add_parameter(name, digits, static_cast<int>(digits.size()));
}
void vocabulary::bring_with_states(std::string const& name) {
    auto const at = meanings_.find(name);
    if (at == meanings_.end() or at->second.is != meaning::role::parameter)
        error::raise<error::invalid_parameter>("there is no parameter '", name, "': there are ", known());
    at->second = {meaning::role::position, dimension_ + brought_, at->second.size};
    brought_ += at->second.size == 0 ? 1 : at->second.size;
}
vocabulary vocabulary::with(std::vector<double> const& numbers) const {
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
meaning const* vocabulary::find(std::string const& name) const {
    auto const at = meanings_.find(name);
    return at == meanings_.end() ? nullptr : &at->second;
}
std::string vocabulary::known() const {
    std::string list;
    for (auto const& [name, is] : meanings_) list += (list.empty() ? "" : ", ") + name + (is.size > 0 ? "[]" : "");
    return list;
}
void vocabulary::add(std::string const& name, meaning is) {
    if (not is_name(name)) error::raise<error::invalid_parameter>("a name is letters, digits and _, and '", name, "' is none");
    if (name == "pi") error::raise<error::invalid_parameter>("pi is the number 3.14159..., and the name of nothing else");
    if (not meanings_.emplace(name, is).second)
        error::raise<error::invalid_parameter>("each name has one meaning, and '", name, "' was given two");
}
void vocabulary::add_parameter(std::string const& name, std::vector<std::string> const& digits, int size) {
    for (std::string const& d : digits)
        if (not number_in<double>(d))
            error::raise<error::invalid_parameter>("the parameter '", name, "' is a number, as 0.1, 1e-3 or 1/3, and was given as '", d,
                                                   "'");
    add(name, {meaning::role::parameter, static_cast<int>(digits_.size()), size});
    digits_.insert(digits_.end(), digits.begin(), digits.end());
}

std::shared_ptr<vocabulary const> no_words() {
    static auto const none = std::make_shared<vocabulary const>(std::vector<coordinate>{}, "");
    return none;
}

} // namespace hilger::text
