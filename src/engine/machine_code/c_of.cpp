// SPDX-License-Identifier: BSL-1.0
// Rows of equal operations are loops, all others a line each. Numbers are read from their places: a compiler that saw them would fold, and
// round otherwise than the library of functions does.
#include <algorithm>
#include <concepts>
#include <vector>

#include "engine/machine_code/machine_code.hpp"

namespace engine {

namespace {

using evaluation = hilger::detail::evaluation<double>;
constexpr int most_lines = 20'000;

std::string at(int place) { return "x[" + std::to_string(place) + "]"; }
std::string in_loop(int place, bool moves) { return "x[" + std::to_string(place) + (moves ? " + i]" : "]"); }
std::string written(std::string const& name, std::string const& a, std::string const& b, bool of_one) {
    if (name == "-x") return "-" + a;
    if (name == "slope_of_log") return '(' + a + " < 0 ? log(" + a + ") : 1 / " + a + ')';
    if (name == "over_norm") return '(' + b + " == 0 ? " + a + " * " + b + " : " + a + " / " + b + ')';
    if (name.size() == 1) return a + ' ' + name + ' ' + b;
    return name + '(' + a + (of_one ? ")" : ", " + b + ')');
}
bool is_of_one(std::string const& name) {
    return name.size() > 1 and name != "pow" and name != "hypot" and name != "atan2" and name != "over_norm";
}

class writer {
public:
    explicit writer(evaluation const& what) : what_(what), is_stored_(static_cast<std::size_t>(what.size()), false) {
        // what another part or a loop reads is in memory
        for (int const place : what.results()) store(place);
        std::vector<int> part_of(is_stored_.size(), -1);
        for_all([&](int part, auto const& r) {
            for (int i = 0; i < r.count; ++i) {
                part_of[static_cast<std::size_t>(r.out + i)] = part;
                for (int const from : {r.a[i], r.b[i]})
                    if (r.in_a_row or part_of[static_cast<std::size_t>(from)] != part) store(from);
            }
            lines_ += r.in_a_row ? 1 : r.count;
        });
    }
    [[nodiscard]] std::string text() {
        if (lines_ > most_lines) return {};
        std::string all = "#include <math.h>\n";
        for (int p = 0; p < evaluation::parts; ++p) {
            is_local_.assign(is_stored_.size(), false);
            all += "void part_" + std::to_string(p) + "(double *x)\n{\n    (void)x;\n";
            what_.for_each_round(static_cast<evaluation::part>(p),
                                 [&](auto const& r) { r.in_a_row ? add_loop(r, all) : add_lines(r, all); });
            all += "}\n";
        }
        all += "void part_4(double *x)\n{\n";
        for (int p = 0; p < evaluation::parts; ++p) all += "    part_" + std::to_string(p) + "(x);\n";
        return all + "}\n";
    }

private:
    template <class Use>
    void for_all(Use const& use) {
        for (int p = 0; p < evaluation::parts; ++p)
            what_.for_each_round(static_cast<evaluation::part>(p), [&](auto const& r) { use(p, r); });
    }
    void store(int place) { is_stored_[static_cast<std::size_t>(place)] = true; }
    void add_loop(evaluation::operations const& r, std::string& all) {
        std::string const name = r.what->name;
        bool const moves_a = r.a[0] != r.a[1], moves_b = r.b[0] != r.b[1];
        all += "    for (int i = 0; i < " + std::to_string(r.count) + "; ++i) " + in_loop(r.out, true) + " = " +
               written(name, in_loop(r.a[0], moves_a), in_loop(r.b[0], moves_b), is_of_one(name)) + ";\n";
    }
    void add_lines(evaluation::operations const& r, std::string& all) {
        std::string const name = r.what->name;
        for (int i = 0; i < r.count; ++i) {
            int const out = r.out + i;
            std::string const local = 'v' + std::to_string(out);
            all += "    const double " + local + " = " + written(name, operand(r.a[i]), operand(r.b[i]), is_of_one(name)) + ";\n";
            if (is_stored_[static_cast<std::size_t>(out)]) all += "    " + at(out) + " = " + local + ";\n";
            is_local_[static_cast<std::size_t>(out)] = true;
        }
    }
    [[nodiscard]] std::string operand(int place) const {
        return is_local_[static_cast<std::size_t>(place)] ? 'v' + std::to_string(place) : at(place);
    }
    evaluation const& what_;
    std::vector<bool> is_stored_, is_local_;
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
                            written(r.what->name, operand(r.a[i]), operand(r.b[i]), is_of_one(r.what->name)) + ";\n";
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
