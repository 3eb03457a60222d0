// SPDX-License-Identifier: BSL-1.0
// Rows of equal operations become loops, joined when they read each other element by element; all other operations take a line each.
// Constants are read from memory: a compiler that knew them would fold them, and round otherwise than the C library.
#include <algorithm>
#include <array>
#include <concepts>
#include <vector>

#include "engine/machine_code/machine_code.hpp"
#include "text/c_statements.hpp"

namespace engine {

namespace {

using evaluation = hilger::detail::evaluation<double>;
constexpr int most_lines = 20'000;

std::string at(int place) { return "x[" + std::to_string(place) + "]"; }
std::string in_loop(int place, bool moves) { return "x[" + std::to_string(place) + (moves ? " + i]" : "]"); }
std::string written(std::string const& name, std::string const& a, std::string const& b) {
    if (name == "slope_of_log") return '(' + a + " < 0 ? log(" + a + ") : 1 / " + a + ')';
    if (name == "over_norm") return '(' + b + " == 0 ? " + a + " * " + b + " : " + a + " / " + b + ')';
    return hilger::detail::c_operation(name, {a}, {b}).text;
}

/// Rounds of operations joined in one loop, or one round in lines.
struct together {
    int count; ///< of the loop; 0 for lines
    std::vector<evaluation::operations> rounds;
};

class writer {
public:
    explicit writer(evaluation const& what)
        : what_(what), is_stored_(static_cast<std::size_t>(what.size()), false), is_local_(is_stored_), written_in_(is_stored_.size(), -1) {
        for (int const place : what.results()) is_stored_[static_cast<std::size_t>(place)] = true;
        for (int p = 0; p < evaluation::parts; ++p) join(p);
        // values that are read elsewhere are stored in memory
        for (int p = 0; p < evaluation::parts; ++p)
            for (auto const& t : together_[static_cast<std::size_t>(p)])
                for (auto const& r : t.rounds)
                    for (int i = 0; i < r.count; ++i)
                        for (int const from : {r.a[i], r.b[i]})
                            if (written_in(from) != written_in(r.out)) is_stored_[static_cast<std::size_t>(from)] = true;
    }
    [[nodiscard]] std::string text() {
        if (lines_ > most_lines) return {};
        std::string all = "#include <math.h>\n";
        for (int p = 0; p < evaluation::parts; ++p) {
            is_local_.assign(is_stored_.size(), false);
            all += "void part_" + std::to_string(p) + "(double *x)\n{\n    (void)x;\n";
            for (auto const& t : together_[static_cast<std::size_t>(p)]) t.count > 0 ? add_loop(t, all) : add_lines(t.rounds.front(), all);
            all += "}\n";
        }
        all += "void part_4(double *x)\n{\n";
        for (int p = 0; p < evaluation::parts; ++p) all += "    part_" + std::to_string(p) + "(x);\n";
        return all + "}\n";
    }

private:
    /// The unit that computes a value: the lines of a part, a loop, or an earlier unit.
    [[nodiscard]] int& written_in(int place) { return written_in_[static_cast<std::size_t>(place)]; }
    /// Orders the rounds of a part so that those of one loop are adjacent.
    void join(int part) {
        auto& all = together_[static_cast<std::size_t>(part)];
        std::vector<int> in(is_stored_.size(), -1); // the index in `all` of the unit that computes a place
        auto const latest_of = [&](int const* operands, int count) {
            int latest = -1;
            for (int i = 0; i < count; ++i) latest = std::max(latest, in[static_cast<std::size_t>(operands[i])]);
            return latest;
        };
        what_.for_each_round(static_cast<evaluation::part>(part), [&](evaluation::operations const& r) {
            int const count = r.in_a_row ? r.count : 0, a = latest_of(r.a, r.count), b = latest_of(r.b, r.count), latest = std::max(a, b);
            auto const is_there = [&](int from, int const* operands) {
                auto const begins = [&](auto const& x) { return x.out == operands[0] and r.count > 1 and operands[1] != operands[0]; };
                auto const at = static_cast<std::size_t>(latest);
                return from < latest or std::any_of(all[at].rounds.begin(), all[at].rounds.end(), begins);
            };
            auto at = static_cast<std::size_t>(latest + 1);
            if (count > 0 and latest >= 0 and all[at - 1].count == count and is_there(a, r.a) and is_there(b, r.b)) --at;
            while (at < all.size() and (count == 0 or all[at].count != count)) ++at;
            if (at == all.size()) all.push_back({count, {}});
            all[at].rounds.push_back(r);
            lines_ += count > 0 ? 1 : r.count;
            for (int i = 0; i < r.count; ++i) {
                in[static_cast<std::size_t>(r.out + i)] = static_cast<int>(at);
                written_in(r.out + i) = count > 0 ? evaluation::parts * static_cast<int>(at + 1) + part : part;
            }
        });
    }
    void add_loop(together const& t, std::string& all) {
        int const loop = written_in(t.rounds.front().out);
        auto const operand = [&](int const* from) {
            return written_in(*from) == loop ? 'v' + std::to_string(*from) : in_loop(*from, from[0] != from[1]);
        };
        all += "    for (int i = 0; i < " + std::to_string(t.count) + "; ++i) {\n";
        for (auto const& r : t.rounds) {
            std::string const local = 'v' + std::to_string(r.out), name = r.what->name;
            all += "        const double " + local + " = " + written(name, operand(r.a), operand(r.b)) + ";\n";
            auto const first = is_stored_.begin() + r.out;
            if (std::find(first, first + r.count, true) != first + r.count)
                all += "        " + in_loop(r.out, true) + " = " + local + ";\n";
        }
        all += "    }\n";
    }
    void add_lines(evaluation::operations const& r, std::string& all) {
        std::string const name = r.what->name;
        for (int i = 0; i < r.count; ++i) {
            int const out = r.out + i;
            std::string const local = 'v' + std::to_string(out);
            all += "    const double " + local + " = " + written(name, operand(r.a[i]), operand(r.b[i])) + ";\n";
            if (is_stored_[static_cast<std::size_t>(out)]) all += "    " + at(out) + " = " + local + ";\n";
            is_local_[static_cast<std::size_t>(out)] = true;
        }
    }
    [[nodiscard]] std::string operand(int place) const {
        return is_local_[static_cast<std::size_t>(place)] ? 'v' + std::to_string(place) : at(place);
    }
    evaluation const& what_;
    std::array<std::vector<together>, evaluation::parts> together_;
    std::vector<bool> is_stored_, is_local_;
    std::vector<int> written_in_;
    int lines_ = 0;
};

} // namespace

std::string c_of(evaluation const& what) { return writer(what).text(); }

template <class S>
std::string c_of_node(hilger::detail::evaluation<S> const& what, int d, std::vector<int> const& places, std::size_t first) {
    using evaluation = hilger::detail::evaluation<S>;
    constexpr int most_places = 1000;
    std::string const scalar = std::same_as<S, float> ? "float " : "double ";
    if (what.size() > most_places) return {};
    std::vector<bool> is_local(static_cast<std::size_t>(what.size()), false);
    auto const operand = [&](int place) {
        if (is_local[static_cast<std::size_t>(place)]) return 'v' + std::to_string(place);
        if (place < d) return "q" + std::to_string(place);
        if (place < 2 * d) return "w" + std::to_string(place - d);
        return place == 2 * d ? std::string("t") : at(place);
    };
    auto const lines = [&](std::initializer_list<typename evaluation::part> parts, std::size_t results, std::string const& to) {
        std::fill(is_local.begin(), is_local.end(), false);
        std::string text;
        for (auto const p : parts)
            what.for_each_round(p, [&](auto const& r) {
                for (int i = 0; i < r.count; ++i) {
                    text += "    const " + scalar + "v" + std::to_string(r.out + i) + " = " +
                            written(r.what->name, operand(r.a[i]), operand(r.b[i])) + ";\n";
                    is_local[static_cast<std::size_t>(r.out + i)] = true;
                }
            });
        for (std::size_t k = 0; k < results; ++k)
            text += "    to[" + to + std::to_string(k) + "] = " + (places[k] < 0 ? "0" : operand(places[k])) + ";\n";
        return text;
    };
    std::string const n = std::to_string(d);
    std::string arguments, nodes;
    for (int k = 0; k < d; ++k) {
        std::string const c = std::to_string(k);
        arguments +=
            "    const " + scalar + "q" + c + " = q[" + c + "], w" + c + " = v[" + c + "];\n    (void)q" + c + ", (void)w" + c + ";\n";
        nodes +=
            "    const " + scalar + "q" + c + " = q[" + n + " * i + " + c + "], w" + c + " = 0;\n    (void)q" + c + ", (void)w" + c + ";\n";
    }
    std::string const head = "(const " + scalar + "*restrict x, " + scalar + "t, const " + scalar + "*restrict q, ",
                      unused = "    (void)x;\n    (void)t;\n";
    auto const function = [&](char const* name, std::string const& body) {
        return std::string("void ") + name + head + "const " + scalar + "*restrict v, " + scalar + "*restrict to)\n{\n" + unused +
               arguments + body + "}\n";
    };
    return "#include <tgmath.h>\n" + function("first", lines({evaluation::shared, evaluation::momenta, evaluation::forces}, first, "")) +
           function("all", lines({evaluation::shared, evaluation::momenta, evaluation::forces, evaluation::seconds}, places.size(), "")) +
           function("force", lines({evaluation::shared, evaluation::forces}, static_cast<std::size_t>(d), "")) + "void many" + head +
           scalar + "*restrict to, long n)\n{\n" + unused + "    for (long i = 0; i < n; ++i) {\n" + nodes +
           lines({evaluation::shared, evaluation::forces}, static_cast<std::size_t>(d), n + " * i + ") + "    }\n}\n";
}
template std::string c_of_node(hilger::detail::evaluation<double> const&, int, std::vector<int> const&, std::size_t);
template std::string c_of_node(hilger::detail::evaluation<float> const&, int, std::vector<int> const&, std::size_t);

} // namespace engine
