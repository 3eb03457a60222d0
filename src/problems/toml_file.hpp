// SPDX-License-Identifier: BSL-1.0
// A file in TOML, read with error messages that give file, line and column, the text found and the accepted ones.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Version 3.3 asserts conditions on the file, as that a header begins with a letter: the file is refused instead of ending the program.
#define TOML_ASSERT(condition) ((condition) ? void() : throw std::domain_error(#condition))
#define TOML_EXCEPTIONS 1
#if defined(__GNUC__) and not defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wterminate" // in a noexcept function the throw ends the program, as assert would
#endif
#include <toml++/toml.h>
#if defined(__GNUC__) and not defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include "hilger/error.hpp"
#include "hilger/text/lagrangian.hpp"

namespace program {

class toml_file {
public:
    toml_file(std::string_view content, std::string path) : path_(std::move(path)) {
        try {
            file_ = toml::parse(content);
        } catch (toml::parse_error const& e) {
            refuse(e.source().begin, std::string(e.description()));
        } catch (std::domain_error const&) {
            hilger::error::raise<hilger::error::unreadable>(path_, ": this is no TOML");
        }
    }
    [[nodiscard]] std::string const& path() const { return path_; }

    /// Refuses all other keys.
    template <class Keys>
    void require_known(toml::table const& table, Keys const& keys) const {
        for (auto const& [key, node] : table)
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
                std::string known;
                for (auto const& k : keys) known += (known.empty() ? "" : ", ") + std::string(k);
                refuse(key.source().begin, "there is no key '" + std::string(key.str()) + "': there are " + known);
            }
    }
    [[nodiscard]] toml::table const& all() const { return file_; }
    [[nodiscard]] toml::node const* get(char const* key) const { return file_.get(key); }
    [[nodiscard]] toml::node const& required(char const* key) const {
        auto const* n = file_.get(key);
        if (n == nullptr) hilger::error::raise<hilger::error::unreadable>(path_, ": there is no ", key, ", which a problem has");
        return *n;
    }
    [[nodiscard]] toml::table const& table_of(toml::node const& n, std::string const& what) const {
        if (auto const* t = n.as_table()) return *t;
        refuse(&n, what);
    }
    [[nodiscard]] std::string text_of(toml::node const& n, char const* key) const {
        if (auto const s = n.value_exact<std::string>()) return *s;
        refuse(&n, std::string(key) + " is a text, in quotes");
    }
    /// A text that is copied into rows, summaries and pictures.
    [[nodiscard]] std::string heading(toml::source_position const& at, std::string const& word) const {
        for (char const c : word)
            if (not(std::isalnum(static_cast<unsigned char>(c)) or static_cast<signed char>(c) < 0 or
                    std::string_view(" _-+.()[]/^=").find(c) != std::string_view::npos))
                refuse(at, "a name that heads a column or a picture is letters, digits, spaces and _-+.()[]/^=, and not '" + word + "'");
        if (word.empty()) refuse(at, "a name that heads a column or a picture is not empty");
        return word;
    }
    /// The digits of a number or of a text.
    [[nodiscard]] std::string digits_of(toml::node const& n) const {
        if (auto const x = n.value_exact<std::int64_t>()) return std::to_string(*x);
        if (auto const x = n.value_exact<double>(); x and std::isfinite(*x)) return hilger::round_trip(*x);
        if (auto const s = n.value_exact<std::string>(); s and hilger::text::number_in<double>(*s)) return *s;
        refuse(&n, "a number was expected, as 1, 0.5 or \"1/3\"");
    }
    [[nodiscard]] std::vector<std::string> digits_of_list(toml::node const& n, char const* what) const {
        auto const* list = n.as_array();
        if (list == nullptr) refuse(&n, std::string("a list was expected, of ") + what);
        std::vector<std::string> digits;
        for (auto const& x : *list) digits.push_back(digits_of(x));
        return digits;
    }
    [[nodiscard]] hilger::index_type count_of(toml::node const& n, char const* key) const {
        auto const count = n.value<std::int64_t>();
        if (not n.is_number() or not count or *count < 1) refuse(&n, std::string(key) + " is a positive whole number");
        return static_cast<hilger::index_type>(*count);
    }
    /// `with_numbers`: another number may follow the colon.
    [[nodiscard]] std::string chosen(toml::node const& n, char const* key, std::vector<std::string> const& choices,
                                     bool with_numbers = false) const {
        std::string const name = text_of(n, key);
        if (choices.empty()) refuse(&n, "there is no " + std::string(key) + " to choose here");
        std::string known;
        for (auto const& c : choices) known += (known.empty() ? "" : ", ") + c;
        auto const kind = name.substr(0, name.find(':') + 1);
        bool const another = with_numbers and not kind.empty() and
                             std::any_of(choices.begin(), choices.end(), [&](auto const& c) { return c.starts_with(kind); });
        if (std::find(choices.begin(), choices.end(), name) == choices.end() and not another)
            refuse(&n, "the " + std::string(key) + " is one of " + known + " here, and not '" + name + "'");
        return name;
    }
    [[nodiscard]] hilger::text::stated formula(toml::node const& n, std::shared_ptr<hilger::text::vocabulary const> const& words,
                                               char const* key) const {
        return {hilger::text::read(text_of(n, key), path_, begin_of_text(n)), words, path_};
    }
    /// The place of the first letter in quotation marks.
    static hilger::text::place begin_of_text(toml::node const& n) {
        auto const at = n.source().begin;
        return {static_cast<int>(at.line), static_cast<int>(at.column) + 1};
    }
    static double number(std::string const& digits) { return *hilger::text::number_in<double>(digits); }

    /// Refuses n when `work` throws.
    template <class Work>
    auto saying_where(toml::node const* n, Work const& work) const -> decltype(work()) {
        try {
            return work();
        } catch (hilger::error::invalid_parameter const& e) {
            refuse(n, e.what());
        } catch (hilger::error::mismatch const& e) {
            refuse(n, e.what());
        }
    }
    [[noreturn]] void refuse(toml::node const* n, std::string const& why) const {
        if (n == nullptr) hilger::error::raise<hilger::error::unreadable>(path_, ": ", why);
        refuse(n->source().begin, why);
    }
    [[noreturn]] void refuse(toml::source_position const& at, std::string const& why) const {
        hilger::error::raise<hilger::error::unreadable>(path_, ", line ", at.line, ", column ", at.column, ": ", why);
    }

private:
    std::string path_;
    toml::table file_;
};

} // namespace program
